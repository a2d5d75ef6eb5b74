// What is loose on the ground.

#include "common/math/index.h"
#include "sim/objects/rigid_object_contacts.h"

namespace twinbus::inline sim {

namespace {
constexpr double kFlat = 0.05;   // a cylinder whose cap is this level stands on its rim
}  // namespace

void LooseContacts::meet_ground(const Piece& own, Search& search) noexcept {
  if (own.only_mesh) {
    meet_mesh(static_cast<std::size_t>(&own - pieces_.data()), -1, search);
    return;
  }
  if (own.solid.shape == SolidShape::kCylinder) {
    meet_cylinder(own, search);
    return;
  }
  Contact found;
  found.system = own.system;
  found.normal = Eigen::Vector3d::UnitZ();
  found.params = together(own.params, ground_);
  const auto targets = static_cast<int>(pieces_.size()) + 1;
  for (std::size_t i = 0; i < own.probes.size(); ++i) {
    const Probe& probe = own.probes[i];
    found.point = own.center + own.rotation * probe.center;
    found.point.z() -= probe.radius;
    found.depth = -found.point.z();
    found.material = !(probe.radius > 0.0);
    found.key = kFirstKey + (own.first_key + static_cast<int>(i)) * targets;
    consider(found, search);
  }
}

// On the points of its rims if it stands, else on the lowest point of each rim.
void LooseContacts::meet_cylinder(const Piece& own, Search& search) noexcept {
  Contact found;
  found.system = own.system;
  found.normal = Eigen::Vector3d::UnitZ();
  found.params = together(own.params, ground_);
  const auto targets = static_cast<int>(pieces_.size()) + 1;
  const Eigen::Vector3d axis = own.rotation.col(2);
  const Eigen::Vector3d across = axis * axis.z() - Eigen::Vector3d::UnitZ();
  const auto count = static_cast<int>(own.probes.size());
  found.material = across.norm() < kFlat;
  const int first = found.material ? 0 : count, end = found.material ? count : count + 2;
  for (int i = first; i < end; ++i) {
    if (found.material) {
      if (own.probes[at(i)].radius > 0.0) continue;
      found.point = own.center + own.rotation * own.probes[at(i)].center;
    } else {
      const double side = i == first ? 0.5 : -0.5;
      found.point =
          own.center + side * own.solid.size.y() * axis + own.solid.size.x() * across.normalized();
    }
    found.depth = -found.point.z();
    found.key = kFirstKey + (own.first_key + i) * targets;
    consider(found, search);
  }
}

}  // namespace twinbus::sim
