#include "test/oracles/patch_force.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"

namespace twinbus {

namespace {

constexpr double kOneConstraint = 0.9998;  // cosine between normals
constexpr double kThin = 1e-6;             // of the spread along, what is no spread across

// Step 1, of the points that share the constraint of point `first`.
void fit(const Manifold& manifold, int first, std::array<bool, Manifold::kMost>& done,
         PatchForce& out) noexcept {
  const Eigen::Vector3d n = manifold.point[at(first)].normal;
  std::array<int, Manifold::kMost> member;
  int count = 0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double mean = 0.0;
  for (int i = first; i < manifold.count; ++i) {
    const ManifoldPoint& p = manifold.point[at(i)];
    if (done[at(i)] || !(p.normal.dot(n) > kOneConstraint)) continue;
    done[at(i)] = true;
    member[at(count++)] = i;
    middle += p.position;
    mean += p.depth;
  }
  middle /= count;
  mean /= count;
  // Two axes across the constraint; moments of the points in them.
  const Eigen::Vector3d x = n.unitOrthogonal(), y = n.cross(x);
  double xx = 0.0, xy = 0.0, yy = 0.0, dx = 0.0, dy = 0.0;
  for (int k = 0; k < count; ++k) {
    const ManifoldPoint& p = manifold.point[at(member[at(k)])];
    const double u = x.dot(p.position - middle), v = y.dot(p.position - middle);
    xx += u * u;
    xy += u * v;
    yy += v * v;
    dx += u * (p.depth - mean);
    dy += v * (p.depth - mean);
  }
  // Along the line of largest spread first; across it only if there is a spread.
  const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const double c = std::cos(turn), s = std::sin(turn);
  const double along = c * c * xx + 2.0 * c * s * xy + s * s * yy;
  const double across = s * s * xx - 2.0 * c * s * xy + c * c * yy;
  const double tilt_along = along > 0.0 ? (c * dx + s * dy) / along : 0.0;
  const double tilt_across = across > kThin * along ? (c * dy - s * dx) / across : 0.0;
  const Eigen::Vector3d tilt =
      tilt_along * (c * x + s * y) + tilt_across * (c * y - s * x);
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d& position = manifold.point[at(member[at(k)])].position;
    out.depth[at(member[at(k)])] = mean + tilt.dot(position - middle);
  }
}

}  // namespace

PatchForce patch_force(const PatchLaw& law, const Manifold& manifold,
                       const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin) noexcept {
  PatchForce out;
  std::array<bool, Manifold::kMost> done{};
  for (int i = 0; i < manifold.count; ++i) {
    if (!done[at(i)]) fit(manifold, i, done, out);
  }
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint& p = manifold.point[at(i)];
    const double spring = law.stiffness * out.depth[at(i)];
    const double rate = -p.normal.dot(velocity + spin.cross(p.position));
    const double damper = law.dissipation * spring * rate;
    if (!(spring > 0.0 && spring + damper > 0.0)) continue;
    out.normal[at(i)] = spring + damper;
    out.force += out.normal[at(i)] * p.normal;
    out.moment += p.position.cross(out.normal[at(i)] * p.normal);
  }
  return out;
}

}  // namespace twinbus
