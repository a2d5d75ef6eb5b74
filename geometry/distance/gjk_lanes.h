// Several searches at once, one a lane: the geometry.  Included by gjk_many.cpp once per instruction set, inside a
// namespace and after TWINBUS_WIDE says which instructions there are: 0 any, 1 those for four lanes, 2 for eight.

#if TWINBUS_WIDE == 2
constexpr int kLanes = 8;
typedef Vec8 Lanes;
typedef Int8 Whole;
struct Mask {
  unsigned char bits;  // a lane each
};
TWINBUS_INLINE Mask mask_of(unsigned bits) noexcept { return {static_cast<unsigned char>(bits)}; }
TWINBUS_INLINE Mask operator&(Mask a, Mask b) noexcept {
  return mask_of(a.bits & unsigned{b.bits});
}
TWINBUS_INLINE Mask operator|(Mask a, Mask b) noexcept {
  return mask_of(a.bits | unsigned{b.bits});
}
TWINBUS_INLINE Mask operator~(Mask a) noexcept { return mask_of(~unsigned{a.bits}); }
TWINBUS_INLINE unsigned lanes_of(Mask mask) noexcept { return mask.bits; }
TWINBUS_INLINE Lanes all(double x) noexcept { return Lanes{x, x, x, x, x, x, x, x}; }
TWINBUS_INLINE Mask above(const Lanes& a, const Lanes& b) noexcept {
  return {_mm512_cmp_pd_mask(a, b, _CMP_GT_OQ)};
}
TWINBUS_INLINE Mask at_least(const Lanes& a, const Lanes& b) noexcept {
  return {_mm512_cmp_pd_mask(a, b, _CMP_GE_OQ)};
}
TWINBUS_INLINE Lanes pick(Mask mask, const Lanes& a, const Lanes& b) noexcept {
  return _mm512_mask_blend_pd(mask.bits, b, a);
}
TWINBUS_INLINE Whole where(Mask mask, long long number) noexcept {
  return reinterpret_cast<Whole>(_mm512_maskz_set1_epi64(mask.bits, number));
}
TWINBUS_INLINE Mask negative(const Lanes& a) noexcept {
  return {_mm512_movepi64_mask(_mm512_castpd_si512(a))};
}
TWINBUS_INLINE Lanes root(const Lanes& a) noexcept { return _mm512_maskz_sqrt_pd(0xFF, a); }
#else
constexpr int kLanes = 4;
typedef Vec4 Lanes;
typedef Int4 Whole;
typedef Int4 Mask;
TWINBUS_INLINE Mask mask_of(unsigned bits) noexcept {
  const Int4 lane{1, 2, 4, 8};
  return (lane & static_cast<std::int64_t>(bits)) == lane;
}
TWINBUS_INLINE Lanes all(double x) noexcept { return Lanes{x, x, x, x}; }
TWINBUS_INLINE Mask above(const Lanes& a, const Lanes& b) noexcept { return a > b; }
TWINBUS_INLINE Mask at_least(const Lanes& a, const Lanes& b) noexcept { return a >= b; }
TWINBUS_INLINE Lanes pick(const Mask& mask, const Lanes& a, const Lanes& b) noexcept {
  return mask ? a : b;
}
TWINBUS_INLINE Whole where(const Mask& mask, std::int64_t number) noexcept { return mask & number; }
TWINBUS_INLINE Mask negative(const Lanes& a) noexcept { return reinterpret_cast<Int4>(a) < 0; }
#if TWINBUS_WIDE
TWINBUS_INLINE Lanes root(const Lanes& a) noexcept { return _mm256_sqrt_pd(a); }
TWINBUS_INLINE unsigned lanes_of(const Mask& mask) noexcept {
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<Vec4>(mask)));
}
#else
TWINBUS_INLINE Lanes root(const Lanes& a) noexcept {
  return Lanes{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]),
               __builtin_sqrt(a[3])};
}
TWINBUS_INLINE unsigned lanes_of(const Mask& mask) noexcept {
  return signs_of(reinterpret_cast<Vec4>(mask));
}
#endif
#endif

typedef double Numbers[kLanes];  // of every lane, in memory
typedef Lanes Lanes3[3];         // x, y, z

TWINBUS_INLINE Lanes load(const Numbers& from) noexcept {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
TWINBUS_INLINE void store(Numbers& to, const Lanes& v) noexcept { std::memcpy(to, &v, sizeof v); }

// Four vectors as their coordinates, and back.
TWINBUS_INLINE void transpose(const Vec4 (&v)[4], Vec4 (&lanes)[4]) noexcept {
  const Vec4 a = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6),
             b = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7),
             c = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6),
             d = __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
  lanes[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
  lanes[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  lanes[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
  lanes[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

// A vector a lane as their coordinates.
TWINBUS_INLINE void coordinates(const Vec4 (&v)[kLanes], Lanes3& to) noexcept {
#if TWINBUS_WIDE == 2
  Vec4 low[4], high[4];
  transpose({v[0], v[1], v[2], v[3]}, low);
  transpose({v[4], v[5], v[6], v[7]}, high);
  for (int d = 0; d < 3; ++d)
    to[d] = __builtin_shufflevector(low[d], high[d], 0, 1, 2, 3, 4, 5, 6, 7);
#else
  Vec4 rows[4];
  transpose(v, rows);
  for (int d = 0; d < 3; ++d) to[d] = rows[d];
#endif
}
