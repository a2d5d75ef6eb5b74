// Spatial vectors, laid out so that the articulated-body algorithm is fast.
//
// Two vectors of space, angular and linear, each four lanes wide with the last always zero.  Motions
// and forces are in world axes about one common point, so that inertias of different links add lane
// by lane.  A 6x6 matrix is an array of six columns.  GNU vector extensions (g++ and clang); what is
// worth it is compiled for every instruction set (aba.cpp) and chosen by simd(): the
// sets agree to rounding (they fuse multiply and add or not), one set always gives the same bits.

#pragma once

#include <Eigen/Core>

// Vectors are passed by value between inlined functions only.
#pragma GCC diagnostic ignored "-Wpsabi"

#define TWINBUS_INLINE inline __attribute__((always_inline))

namespace twinbus::inline sim {

enum class Simd { kBaseline, kAvx2, kAvx512 };

// The best that this machine has, unless lowered; for tests.
Simd simd() noexcept;
void lower_simd(Simd most) noexcept;

// A vector of space in lanes 0..2; lane 3 is always zero.  The alignment is said: g++ would align by
// the widest register of the baseline only.
typedef double Vec4 __attribute__((vector_size(32), aligned(32)));

struct Screw {
  Vec4 w;  // angular
  Vec4 v;  // linear
  double operator[](int i) const { return i < 3 ? w[i] : v[i - 3]; }
};

inline Eigen::Vector3d angular(const Screw& s) { return {s.w[0], s.w[1], s.w[2]}; }
inline Eigen::Vector3d linear(const Screw& s) { return {s.v[0], s.v[1], s.v[2]}; }

// Velocity, or acceleration without the centripetal part, of the point at r: J(r) s, J = [-r^ 1].
inline Eigen::Vector3d at_point(const Screw& s, const Eigen::Vector3d& r) {
  return linear(s) + angular(s).cross(r);
}

}  // namespace twinbus::sim
