#include "sim/articulated/torque_free_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/math/index.h"
#include "common/simd/vec4.h"

namespace twinbus::inline sim {

namespace {

constexpr int kMostSweeps = 50;
constexpr double kMostRotationParts = 1000.0;
constexpr double kOuter = 1.3512071919596578;  // 1 / (2 - 2^(1/3))

// A component of four bodies in each.
struct Vectors {
  Vec4 x, y, z;
};
struct Quaternions {
  Vec4 x, y, z, w;
};
struct Turning {
  Vectors momentum, inertia;  // momentum in world
  Quaternions attitude;
  Vec4 h;  // of a part [s]
  Int4 steps;  // 3 a part; none: it does not turn
};

TWINBUS_INLINE bool any(const Int4& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }
TWINBUS_INLINE Vec4 root_of(Vec4 x) {
  for (int k = 0; k < kFreeLanes; ++k) x[k] = std::sqrt(x[k]);
  return x;
}
TWINBUS_INLINE Vec4 size_of(const Vectors& v) { return root_of(v.x * v.x + v.y * v.y + v.z * v.z); }
TWINBUS_INLINE void choose(const Int4& mask, const Vectors& value, Vectors& to) {
  to = {mask ? value.x : to.x, mask ? value.y : to.y, mask ? value.z : to.z};
}
TWINBUS_INLINE Quaternions normalized(const Quaternions& q) {
  const Vec4 size = root_of((q.x * q.x + q.z * q.z) + (q.y * q.y + q.w * q.w));
  return {q.x / size, q.y / size, q.z / size, q.w / size};
}
TWINBUS_INLINE Quaternions times(const Quaternions& a, const Quaternions& b) {
  return {(a.w * b.x + a.y * b.z) - (a.z * b.y - a.x * b.w), (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z),
          (a.w * b.z - a.y * b.x) + (a.z * b.w + a.x * b.y), (a.w * b.w - a.y * b.y) - (a.z * b.z + a.x * b.x)};
}
TWINBUS_INLINE Vectors turned(const Quaternions& q, const Vectors& v) {
  Vectors u{q.y * v.z - q.z * v.y, q.z * v.x - q.x * v.z, q.x * v.y - q.y * v.x};
  u = {u.x + u.x, u.y + u.y, u.z + u.z};
  return {(v.x + q.w * u.x) + (q.y * u.z - q.z * u.y), (v.y + q.w * u.y) + (q.z * u.x - q.x * u.z),
          (v.z + q.w * u.z) + (q.x * u.y - q.y * u.x)};
}

TWINBUS_AVX2_CLONES
void turn_lanes(Turning& bodies) noexcept {
  Quaternions& q = bodies.attitude;
  const Vectors& inertia = bodies.inertia;
  const Vec4 one = Vec4{} + 1.0;
  Int4 turns = bodies.steps > 0;
  for (int i = 0; any(turns); ++i) {
    const Vec4 part = bodies.h * (i % 3 == 1 ? 1.0 - 2.0 * kOuter : kOuter), quarter = 0.25 * part;
    const Vectors start = turned({-q.x, -q.y, -q.z, q.w}, bodies.momentum);
    const Vec4 near = 1e-15 * size_of(start);
    Vectors end = start, half{};  // half: h wm / 2
    Int4 moves = turns;
    for (int sweep = 0; sweep < kMostSweeps && any(moves); ++sweep) {
      choose(moves, {quarter * ((start.x + end.x) / inertia.x), quarter * ((start.y + end.y) / inertia.y),
                     quarter * ((start.z + end.z) / inertia.z)}, half);
      // cay(-2 half) start: the quaternion (1, -half), normalised.
      const Vectors next = turned(normalized({-half.x, -half.y, -half.z, one}), start);
      const Vec4 change = size_of({next.x - end.x, next.y - end.y, next.z - end.z});
      choose(moves, next, end);
      moves = moves & (change > near);
    }
    const Quaternions to = normalized(times(q, {half.x, half.y, half.z, one}));
    q = {turns ? to.x : q.x, turns ? to.y : q.y, turns ? to.z : q.z, turns ? to.w : q.w};
    turns = bodies.steps > i + 1;
  }
}

void set(const Eigen::Vector3d& from, int lane, Vectors& to) noexcept {
  to.x[lane] = from.x();
  to.y[lane] = from.y();
  to.z[lane] = from.z();
}

}  // namespace

void turn_freely(const FreeRotation* bodies, int count, double h) noexcept {
  Turning all{};
  for (Vec4* each : {&all.inertia.x, &all.inertia.y, &all.inertia.z, &all.attitude.w}) *each = Vec4{} + 1.0;
  std::array<Eigen::Vector3d, kFreeLanes> in_world;  // momentum, kept to the bit
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d &inertia = *bodies[k].inertia, &spin = *bodies[k].spin;
    const Eigen::Matrix3d rotation = bodies[k].pose->linear();
    if (!(spin.squaredNorm() > 0.0)) continue;
    in_world[at(k)] = rotation * inertia.cwiseProduct(rotation.transpose() * spin);
    const double fastest = spin.norm() * inertia.maxCoeff() / inertia.minCoeff();
    const int parts = 1 + static_cast<int>(std::min(kMostRotationParts - 1.0, 4.0 * h * fastest));  // of a needle no int holds it
    const Eigen::Quaterniond attitude(rotation);
    set(in_world[at(k)], k, all.momentum);
    set(inertia, k, all.inertia);
    all.attitude.x[k] = attitude.x();
    all.attitude.y[k] = attitude.y();
    all.attitude.z[k] = attitude.z();
    all.attitude.w[k] = attitude.w();
    all.h[k] = h / parts;
    all.steps[k] = 3 * parts;
  }
  turn_lanes(all);
  for (int k = 0; k < count; ++k) {
    if (all.steps[k] == 0) continue;
    const Quaternions& q = all.attitude;
    const Eigen::Matrix3d rotation = Eigen::Quaterniond(q.w[k], q.x[k], q.y[k], q.z[k]).toRotationMatrix();
    bodies[k].pose->linear() = rotation;
    *bodies[k].spin = rotation * (rotation.transpose() * in_world[at(k)]).cwiseQuotient(*bodies[k].inertia);
  }
}

}  // namespace twinbus::sim
