// Which steps of the ODE world are to be doubted, and what its contact springs hold.

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/engine/ode_world.h"

namespace twinbus::inline sim {

namespace {

double thickness_of(const LooseBody& body) {
  const Eigen::Vector3d& size = body.solid.size;
  switch (body.solid.shape) {
    case SolidShape::kBox:
      return size.minCoeff();
    case SolidShape::kSphere:
    case SolidShape::kCapsule:
      return 2.0 * size.x();
    case SolidShape::kCylinder:
      return std::min(2.0 * size.x(), size.y());
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

// Before a step, with its rows found.
void OdeWorld::doubt_rows() noexcept {
  for (const Row& row : rows_) {
    const double depth = row.contact.geom.depth;
    if (placed_ || !(depth > kFirstDepth)) continue;
    const double approach = vector(row.contact.geom.normal)
                                .dot(velocity_between(row.contact.geom, row.own, row.other));
    double expected = kFirstDepth + 2.0 * h_ * std::abs(approach);
    for (const DeepPair& pair : deep_) {
      if (pair.own == row.own && pair.other == row.other) expected += 2.0 * pair.depth;
    }
    if (!(depth > expected)) continue;
    trust_.doubt[static_cast<std::size_t>(Doubt::kDeep)] = true;
    trust_.first_depth = std::max(trust_.first_depth, depth);
  }
  deep_.clear();
  for (const Row& row : rows_) {
    if (row.contact.geom.depth > 0.25 * kFirstDepth && deep_.size() < deep_.capacity())
      deep_.push_back({row.own, row.other, row.contact.geom.depth});
  }
  doubt_speeds();
}

// ODE looks where things are, not where they go: what moves by more than half its thickness in a step, with
// something in its way, may pass it unseen.
void OdeWorld::doubt_speeds() noexcept {
  for (std::size_t i = 0; i < loose_.size(); ++i) {
    const Eigen::Vector3d way = h_ * vector(dBodyGetLinearVel(loose_[i].body));
    if (!(way.norm() > 0.5 * thickness_of(config_.loose[i]))) continue;
    dReal swept[6];
    dGeomGetAABB(loose_[i].geom, swept);
    for (int axis = 0; axis < 3; ++axis) {
      swept[2 * axis] += std::min(0.0, way[axis]);
      swept[2 * axis + 1] += std::max(0.0, way[axis]);
    }
    const auto in_the_way = [&](dGeomID geom) {
      dReal box[6];
      dGeomGetAABB(geom, box);
      return bounds_meet(swept, box);
    };
    bool met = std::any_of(obstacle_geoms_.begin(), obstacle_geoms_.end(), in_the_way);
    for (std::size_t j = 0; j < loose_.size(); ++j)
      met = met || (j != i && in_the_way(loose_[j].geom));
    for (const OdeRobot& robot : robots_) {
      for (const OdeGeom& geom : robot.geoms) met = met || in_the_way(geom.geom);
    }
    if (met) trust_.doubt[static_cast<std::size_t>(Doubt::kThrough)] = true;
  }
}

// After a step: its rows with the speeds of its end.
double OdeWorld::elastic_energy() const noexcept {
  if (config_.contact == ContactModel::kRigid) return 0.0;
  double energy = 0.0;
  for (const Row& row : rows_) {
    const dContact& c = row.contact;
    const double stiffness = c.surface.soft_erp / (c.surface.soft_cfm * h_);
    const double end =
        c.geom.depth - h_ * vector(c.geom.normal).dot(velocity_between(c.geom, row.own, row.other));
    if (end > 0.0) energy += 0.5 * stiffness * end * end;
  }
  return energy;
}

}  // namespace twinbus::sim
