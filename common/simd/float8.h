// The kernels of SelfCollision.  Included once per instruction set, inside a namespace and after
// TWINBUS_WIDE says whether a comparison of eight lanes becomes a mask in one instruction.

typedef float F4 __attribute__((vector_size(16), aligned(16)));
typedef float F8 __attribute__((vector_size(32), aligned(32)));
typedef int I4 __attribute__((vector_size(16), aligned(16)));
typedef int I8 __attribute__((vector_size(32), aligned(32)));

constexpr float kAxisSlack = 1e-7F;     // per length of a separating axis [m]
constexpr float kCapsuleSlack = 1e-5F;  // what single precision may lose [m]
constexpr float kPlaneSlack = 1e-6F;    // of a corner beside a plane [m]
constexpr float kHullSlack = 3e-6F;     // the same, between two links [m]
constexpr float kInnerSlack = 5e-6F;    // the same, of balls that overlap [m]

TWINBUS_INLINE F8 load8(const float* from) noexcept {
  F8 v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
TWINBUS_INLINE F4 load4f(const float* from) noexcept {
  F4 v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
TWINBUS_INLINE F8 all(float x) noexcept { return F8{x, x, x, x, x, x, x, x}; }
// The instructions say exactly a < b ? a : b, which compilers do not recognise.
TWINBUS_INLINE F8 least(F8 a, F8 b) noexcept {
#if TWINBUS_WIDE
  return __builtin_ia32_minps256(a, b);
#else
  return a < b ? a : b;
#endif
}
TWINBUS_INLINE F8 most(F8 a, F8 b) noexcept {
#if TWINBUS_WIDE
  return __builtin_ia32_maxps256(a, b);
#else
  return a > b ? a : b;
#endif
}
// In three halvings.
TWINBUS_INLINE F8 largest8(F8 a) noexcept {
  a = most(a, __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3));
  a = most(a, __builtin_shufflevector(a, a, 2, 3, 0, 1, 6, 7, 4, 5));
  return most(a, __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6));
}
TWINBUS_INLINE float largest(F8 a) noexcept { return largest8(a)[0]; }
TWINBUS_INLINE F8 size(F8 a) noexcept {
  return reinterpret_cast<F8>(reinterpret_cast<I8>(a) & 0x7FFFFFFF);
}
TWINBUS_INLINE F4 size4(F4 a) noexcept {
  return reinterpret_cast<F4>(reinterpret_cast<I4>(a) & 0x7FFFFFFF);
}
TWINBUS_INLINE F8 unit_clamp(F8 a) noexcept { return least(most(a, all(0.0F)), all(1.0F)); }
TWINBUS_INLINE unsigned bits(I8 mask) noexcept {
#if TWINBUS_WIDE
  return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<F8>(mask)));
#elif defined(__SSE__)
  F4 half[2];
  __builtin_memcpy(half, &mask, sizeof half);
  return static_cast<unsigned>(__builtin_ia32_movmskps(half[0])) |
         static_cast<unsigned>(__builtin_ia32_movmskps(half[1])) << 4;
#else
  unsigned result = 0;
  for (int i = 0; i < 8; ++i) result |= mask[i] != 0 ? 1U << i : 0U;
  return result;
#endif
}
// Of three coordinates: is any lane set?
TWINBUS_INLINE bool any3(I4 mask) noexcept {
#if defined(__SSE__)
  return (__builtin_ia32_movmskps(reinterpret_cast<F4>(mask)) & 7) != 0;
#else
  return (mask[0] | mask[1] | mask[2]) != 0;
#endif
}
TWINBUS_INLINE F8 root(F8 a) noexcept {
#if TWINBUS_WIDE
  return __builtin_ia32_sqrtps256(a);
#else
  for (int i = 0; i < 8; ++i) a[i] = __builtin_sqrtf(a[i]);
  return a;
#endif
}
TWINBUS_INLINE int lowest(unsigned mask) noexcept { return __builtin_ctz(mask); }
TWINBUS_INLINE F4 turned(const CollisionPose& pose, const float* p) noexcept {
  return load4f(pose.column[0]) * p[0] + load4f(pose.column[1]) * p[1] +
         load4f(pose.column[2]) * p[2];
}
TWINBUS_INLINE F4 moved(const CollisionPose& pose, const float* p) noexcept {
  return turned(pose, p) + load4f(pose.origin);
}
TWINBUS_INLINE F4 cross(F4 a, F4 b) noexcept {
  const F4 p = __builtin_shufflevector(a, a, 1, 2, 0, 3);
  const F4 q = __builtin_shufflevector(b, b, 1, 2, 0, 3);
  const F4 c = a * q - p * b;
  return __builtin_shufflevector(c, c, 1, 2, 0, 3);
}
