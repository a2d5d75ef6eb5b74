// Eight numbers at a time.  Included once per instruction set, inside a namespace,
// by check.cpp: no #pragma once.
//
// GNU vector extensions; nothing is fused or reordered, so every instruction set gives the same
// bits.  Only "is any lane true" and the like use instructions by name where there are some.

TWINBUS_INLINE Lanes all(float x) { return Lanes{x, x, x, x, x, x, x, x}; }
TWINBUS_INLINE Lanes load(const float* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
TWINBUS_INLINE Lanes least(Lanes a, Lanes b) { return a < b ? a : b; }
TWINBUS_INLINE Lanes most(Lanes a, Lanes b) { return a > b ? a : b; }
// As geometry/distance/simplex_lanes.h asks for them.
typedef Flags Mask;
typedef Lanes Lanes3[3];
TWINBUS_INLINE Mask above(Lanes a, Lanes b) { return a > b; }
TWINBUS_INLINE Mask at_least(Lanes a, Lanes b) { return a >= b; }
TWINBUS_INLINE Lanes pick(Mask which, Lanes a, Lanes b) { return which ? a : b; }
TWINBUS_INLINE Lanes size_of(Lanes a) {
  Flags bits;
  std::memcpy(&bits, &a, sizeof bits);
  bits &= 0x7fffffff;
  std::memcpy(&a, &bits, sizeof bits);
  return a;
}
#ifdef TWINBUS_BLOCK_AVX2
TWINBUS_INLINE unsigned mask(Flags f) {
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(f)));
}
TWINBUS_INLINE Lanes root(Lanes a) {
  return reinterpret_cast<Lanes>(_mm256_sqrt_ps(reinterpret_cast<__m256>(a)));
}
#else
TWINBUS_INLINE unsigned mask(Flags f) {
  unsigned bits = 0;
  for (int i = 0; i < 8; ++i) bits |= f[i] != 0 ? 1U << i : 0U;
  return bits;
}
TWINBUS_INLINE Lanes root(Lanes a) {
  for (int i = 0; i < 8; ++i) a[i] = __builtin_sqrtf(a[i]);
  return a;
}
#endif
#ifdef TWINBUS_BLOCK_AVX512
TWINBUS_INLINE __m512 twice(const Lanes& a) {
  return __builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7);
}
template <class Half, class Wide>
TWINBUS_INLINE Half half_of(const Wide& a, int which) {
  Half halves[2];
  std::memcpy(halves, &a, sizeof halves);
  return halves[which];
}
#endif
TWINBUS_INLINE bool any(Flags f) { return mask(f) != 0; }

TWINBUS_INLINE float lowest(Lanes a) {
  a = least(a, __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3));
  a = least(a, __builtin_shufflevector(a, a, 2, 3, 0, 1, 6, 7, 4, 5));
  return a[0] < a[1] ? a[0] : a[1];
}
TWINBUS_INLINE float highest(Lanes a) {
  a = most(a, __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3));
  a = most(a, __builtin_shufflevector(a, a, 2, 3, 0, 1, 6, 7, 4, 5));
  return a[0] > a[1] ? a[0] : a[1];
}

// Each lane gets the value of the one before it; the first gets its own.
TWINBUS_INLINE Lanes before(Lanes a) {
  return __builtin_shufflevector(a, a, 0, 0, 1, 2, 3, 4, 5, 6);
}
// Of the one behind it; the last gets its own.
TWINBUS_INLINE Lanes behind(Lanes a) {
  return __builtin_shufflevector(a, a, 1, 2, 3, 4, 5, 6, 7, 7);
}

// To 3e-7 for |angle| below 1e4: the nearest multiple of pi is taken away, then odd and even
// polynomials of degree 11 and 12.
TWINBUS_INLINE void sine_cosine(Lanes angle, Lanes& sine, Lanes& cosine) {
  constexpr float kMagic = 12582912.0F;  // 1.5 2^23: adding it rounds to an integer
  const Lanes shifted = angle * all(0.318309886F) + all(kMagic);
  const Lanes k = shifted - all(kMagic);
  const Lanes r = (angle - k * all(3.140625F)) - k * all(9.67653590e-4F);
  const Lanes r2 = r * r;
  Lanes s = all(-2.38396218e-8F);
  s = s * r2 + all(2.75221647e-6F);
  s = s * r2 + all(-1.98407943e-4F);
  s = s * r2 + all(8.33333004e-3F);
  s = s * r2 + all(-0.166666672F);
  s = r + r * r2 * s;
  Lanes c = all(1.99162842e-9F);
  c = c * r2 + all(-2.75253996e-7F);
  c = c * r2 + all(2.48010638e-5F);
  c = c * r2 + all(-1.38888846e-3F);
  c = c * r2 + all(4.16666679e-2F);
  c = c * r2 + all(-0.5F);
  c = all(1.0F) + r2 * c;
  Flags odd, bits_s, bits_c;
  std::memcpy(&odd, &shifted, sizeof odd);
  std::memcpy(&bits_s, &s, sizeof s);
  std::memcpy(&bits_c, &c, sizeof c);
  odd = odd << 31;  // odd multiples turn the sign of both
  bits_s ^= odd;
  bits_c ^= odd;
  std::memcpy(&sine, &bits_s, sizeof sine);
  std::memcpy(&cosine, &bits_c, sizeof cosine);
}
