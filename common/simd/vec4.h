// Three-dimensional vectors as one 4-wide number, and sines four at a time: what makes kinematics and dynamics fast.
//
// Lanes 0..2 are x, y, z; lane 3 is never part of a result.  GNU vector extensions (g++ and clang): the compiler splits
// them into whatever registers there are, and as nothing is fused or reordered every instruction set gives the same
// bits.  Everything here is inlined into functions that are compiled twice, see TWINBUS_AVX2_CLONES.

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstring>

// Vectors are passed by value between inlined functions only.
#pragma GCC diagnostic ignored "-Wpsabi"

// A function compiled twice, for any x86-64 and for AVX2, chosen when the program starts.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(NDEBUG) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#define TWINBUS_AVX2_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define TWINBUS_AVX2_CLONES
#endif
#define TWINBUS_INLINE inline __attribute__((always_inline))

namespace twinbus::inline common {

// The alignment is said: g++ would align by the widest register of the baseline only.
typedef double Vec4 __attribute__((vector_size(32), aligned(32)));
typedef std::int64_t Int4 __attribute__((vector_size(32), aligned(32)));

// A vector in memory that can be read and written 4 wide.
struct alignas(32) PaddedVector {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  double pad = 0.0;
};

TWINBUS_INLINE Vec4 load4(const double* from) noexcept {
  Vec4 v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
TWINBUS_INLINE void store4(double* to, const Vec4& v) noexcept { std::memcpy(to, &v, sizeof v); }
TWINBUS_INLINE Vec4 load(const PaddedVector& from) noexcept { return load4(from.value.data()); }
TWINBUS_INLINE void store(PaddedVector& to, const Vec4& v) noexcept { store4(to.value.data(), v); }
TWINBUS_INLINE Vec4 vec4(const Eigen::Vector3d& v) noexcept { return Vec4{v[0], v[1], v[2], 0.0}; }
TWINBUS_INLINE Eigen::Vector3d vector3(const Vec4& v) noexcept { return {v[0], v[1], v[2]}; }

TWINBUS_INLINE double dot3(const Vec4& a, const Vec4& b) noexcept {
  const Vec4 m = a * b;
  return m[0] + m[1] + m[2];
}

TWINBUS_INLINE Vec4 rolled(const Vec4& a) noexcept {  // y z x
  return __builtin_shufflevector(a, a, 1, 2, 0, 3);
}
TWINBUS_INLINE Vec4 cross4(const Vec4& a, const Vec4& b) noexcept {
  return rolled(a * rolled(b) - rolled(a) * b);
}

// Three columns.
struct Columns {
  Vec4 x, y, z;
  TWINBUS_INLINE Vec4 times(double a, double b, double c) const noexcept {
    return x * a + y * b + z * c;
  }
  TWINBUS_INLINE Vec4 times(const double* v) const noexcept { return times(v[0], v[1], v[2]); }
  TWINBUS_INLINE Vec4 times(const Vec4& v) const noexcept { return times(v[0], v[1], v[2]); }
};
TWINBUS_INLINE Columns columns(const double* first, int stride) noexcept {
  return {load4(first), load4(first + stride), load4(first + 2 * stride)};
}

// Sine and cosine of four angles [rad] to 2e-16 absolute for |angle| <= kMostAngle; of a larger angle
// the caller asks the C library.  NaN gives NaN.
inline constexpr double kMostAngle = 1e5;
TWINBUS_INLINE void sine_cosine(const Vec4& angle, Vec4& sine, Vec4& cosine) noexcept {
  constexpr double kMagic = 6755399441055744.0;  // 1.5 2^52: adding it rounds to an integer
  // pi / 2 = a + b, where a has 33 bits: n a is exact.
  constexpr double a = 0x1.921fb544p+0, b = 6.077100506506192e-11;
  const Vec4 shifted = angle * 0.63661977236758134308 + kMagic;
  const Vec4 n = shifted - kMagic;
  const Vec4 r = (angle - n * a) - n * b;
  const Vec4 s = r * r;
  // Taylor: 1e-16 at pi / 4.
  Vec4 p = s * (-1.0 / 1307674368000.0) + 1.0 / 6227020800.0;
  p = p * s - 1.0 / 39916800.0;
  p = p * s + 1.0 / 362880.0;
  p = p * s - 1.0 / 5040.0;
  p = p * s + 1.0 / 120.0;
  p = p * s - 1.0 / 6.0;
  p = r + r * s * p;
  Vec4 q = s * (1.0 / 20922789888000.0) - 1.0 / 87178291200.0;
  q = q * s + 1.0 / 479001600.0;
  q = q * s - 1.0 / 3628800.0;
  q = q * s + 1.0 / 40320.0;
  q = q * s - 1.0 / 720.0;
  q = q * s + 1.0 / 24.0;
  q = (1.0 - 0.5 * s) + s * s * q;
  // Quarter turns swap the two and change signs.
  Int4 quarter, bits_p, bits_q;
  std::memcpy(&quarter, &shifted, sizeof quarter);
  std::memcpy(&bits_p, &p, sizeof p);
  std::memcpy(&bits_q, &q, sizeof q);
  const Int4 swap = -(quarter & 1);
  const Int4 sign_p = (quarter & 2) << 62, sign_q = ((quarter + 1) & 2) << 62;
  const Int4 to_sine = ((bits_p & ~swap) | (bits_q & swap)) ^ sign_p;
  const Int4 to_cosine = ((bits_q & ~swap) | (bits_p & swap)) ^ sign_q;
  std::memcpy(&sine, &to_sine, sizeof sine);
  std::memcpy(&cosine, &to_cosine, sizeof cosine);
}

}  // namespace twinbus::common
