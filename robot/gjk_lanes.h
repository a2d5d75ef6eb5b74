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
TWINBUS_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
TWINBUS_INLINE void cross(const Lanes3& a, const Lanes3& b, Lanes3& c) noexcept {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

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
// What is nearest to zero: v = w + sum of part[k] (corner[k] - w), parts above zero for those that are needed.
struct NearestOfFour {
  Lanes3 part, v;
  Mask inside;  // zero is inside
};

TWINBUS_INLINE void nearest_of_four(const Lanes3& w, const Lanes3 (&corner)[3],
                                    NearestOfFour& result) noexcept {
  const Lanes none{};
  Lanes3 e[3], q[3], normal = {};
  Lanes(&part)[3] = result.part;
  // Squares of distances, and parts, are fractions: one division at the end.
  Lanes best = dot(w, w), per = all(1.0), height_best = none;
  const auto take = [&](const Mask& valid, const Lanes& square, const Lanes& of)
      __attribute__((always_inline)) {
    const Mask nearer = valid & above(best * of, square * per);
    best = pick(nearer, square, best);
    per = pick(nearer, of, per);
    return nearer;
  };
  for (int i = 0; i < 3; ++i) {
    for (int d = 0; d < 3; ++d) e[i][d] = corner[i][d] - w[d];
    cross(e[i], w, q[i]);
    const Lanes along = -dot(w, e[i]), length2 = dot(e[i], e[i]);
    const Mask nearer = take(above(along, none) & above(length2, along), dot(q[i], q[i]), length2);
    for (int k = 0; k < i; ++k) part[k] = pick(nearer, none, part[k]);
    part[i] = pick(nearer, along, none);
  }
  Lanes sum = none, volume = none;
  Mask of_face = mask_of(0), same = ~of_face;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Lanes3 n;
    cross(e[i], e[j], n);
    const Lanes of_i = dot(n, q[j]), of_j = -dot(n, q[i]), area2 = dot(n, n), height = dot(w, n);
    if (i == 0) volume = -dot(e[k], n);
    sum += height;
    same = same & above(height * volume, none);
    const Mask nearer = take(above(of_i, none) & above(of_j, none) & above(area2, of_i + of_j),
                             height * height, area2);
    of_face = of_face | nearer;
    part[i] = pick(nearer, of_i, part[i]);
    part[j] = pick(nearer, of_j, part[j]);
    part[k] = pick(nearer, none, part[k]);
    height_best = pick(nearer, height, height_best);
    for (int d = 0; d < 3; ++d) normal[d] = pick(nearer, n[d], normal[d]);
  }
  result.inside = same & at_least(volume * volume, sum * volume);
  const Lanes share = 1.0 / per;
  for (int i = 0; i < 3; ++i) part[i] *= share;
  height_best *= share;
  for (int d = 0; d < 3; ++d) {
    // Of a face along its normal, which rounding harms less than the sum of the corners.
    const Lanes v = w[d] + part[0] * e[0][d] + part[1] * e[1][d] + part[2] * e[2][d];
    result.v[d] = pick(of_face, height_best * normal[d], v);
  }
}
