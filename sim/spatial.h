// Spatial vectors as one 8-wide number: what makes the articulated-body algorithm fast.
//
// Lanes 0..2 angular, 3..5 linear, 6 and 7 always zero.  Motions and forces are in world axes about
// one common point, so that inertias of different links add lane by lane.  A 6x6 matrix is an array
// of six columns.  GNU vector extensions (g++ and clang): the compiler splits them into whatever
// registers there are, and as nothing is fused or reordered every instruction set gives the same
// bits.

#pragma once

#include <Eigen/Core>

// Vectors are passed by value between inlined functions only.
#pragma GCC diagnostic ignored "-Wpsabi"

// Compiled twice, for any x86-64 and for AVX2, chosen when the program starts.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(NDEBUG) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#define TWINBUS_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define TWINBUS_VECTOR_CLONES
#endif

namespace twinbus {

// The alignment is said: g++ would align by the widest register of the baseline only.
typedef double Vec8 __attribute__((vector_size(64), aligned(64)));

inline Vec8 spatial(const Eigen::Vector3d& angular, const Eigen::Vector3d& linear) {
  return Vec8{angular[0], angular[1], angular[2], linear[0], linear[1], linear[2], 0.0, 0.0};
}

inline Eigen::Vector3d angular(const Vec8& v) { return {v[0], v[1], v[2]}; }
inline Eigen::Vector3d linear(const Vec8& v) { return {v[3], v[4], v[5]}; }

inline double dot(const Vec8& a, const Vec8& b) {
  const Vec8 m = a * b;
  return ((m[0] + m[1]) + (m[2] + m[3])) + (m[4] + m[5]);
}

// Matrix of six columns times a vector.
inline Vec8 times(const Vec8 (&columns)[6], const Vec8& v) {
  return ((columns[0] * v[0] + columns[1] * v[1]) + (columns[2] * v[2] + columns[3] * v[3])) +
         (columns[4] * v[4] + columns[5] * v[5]);
}

// Motion m as seen by something that moves with v: v x m.
inline Vec8 cross_motion(const Vec8& v, const Vec8& m) {
  return Vec8{v[1] * m[2] - v[2] * m[1],
              v[2] * m[0] - v[0] * m[2],
              v[0] * m[1] - v[1] * m[0],
              v[1] * m[5] - v[2] * m[4] + v[4] * m[2] - v[5] * m[1],
              v[2] * m[3] - v[0] * m[5] + v[5] * m[0] - v[3] * m[2],
              v[0] * m[4] - v[1] * m[3] + v[3] * m[1] - v[4] * m[0],
              0.0,
              0.0};
}

// Velocity, or acceleration without the centripetal part, of the point at r: J(r) v, J = [-r^ 1].
inline Eigen::Vector3d at_point(const Vec8& v, const Eigen::Vector3d& r) {
  return {v[3] + v[1] * r[2] - v[2] * r[1], v[4] + v[2] * r[0] - v[0] * r[2],
          v[5] + v[0] * r[1] - v[1] * r[0]};
}

// Force f at the point r: J(r)' f.
inline Vec8 force_at(const Eigen::Vector3d& r, const Eigen::Vector3d& f) {
  return Vec8{r[1] * f[2] - r[2] * f[1],
              r[2] * f[0] - r[0] * f[2],
              r[0] * f[1] - r[1] * f[0],
              f[0],
              f[1],
              f[2],
              0.0,
              0.0};
}

}  // namespace twinbus
