// Which steps of the ODE world are to be doubted, and what its contact springs hold.

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/engine/ode_impl.h"

namespace twinbus {

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
void OdeWorld::Impl::doubt_rows() noexcept {
  for (const Row& row : rows) {
    const double depth = row.contact.geom.depth;
    if (placed || !(depth > kFirstDepth)) continue;
    const double approach = vector(row.contact.geom.normal)
                                .dot(velocity_between(row.contact.geom, row.own, row.other));
    double expected = kFirstDepth + 2.0 * h * std::abs(approach);
    for (const DeepPair& pair : deep) {
      if (pair.own == row.own && pair.other == row.other) expected += 2.0 * pair.depth;
    }
    if (!(depth > expected)) continue;
    trust.doubt[static_cast<std::size_t>(Doubt::kDeep)] = true;
    trust.first_depth = std::max(trust.first_depth, depth);
  }
  deep.clear();
  for (const Row& row : rows) {
    if (row.contact.geom.depth > 0.25 * kFirstDepth && deep.size() < deep.capacity())
      deep.push_back({row.own, row.other, row.contact.geom.depth});
  }
  doubt_speeds();
}

// ODE looks where things are, not where they go: what moves by more than half its thickness in a step, with
// something in its way, may pass it unseen.
void OdeWorld::Impl::doubt_speeds() noexcept {
  for (std::size_t i = 0; i < loose.size(); ++i) {
    const Eigen::Vector3d way = h * vector(dBodyGetLinearVel(loose[i].body));
    if (!(way.norm() > 0.5 * thickness_of(config.loose[i]))) continue;
    dReal swept[6];
    dGeomGetAABB(loose[i].geom, swept);
    for (int axis = 0; axis < 3; ++axis) {
      swept[2 * axis] += std::min(0.0, way[axis]);
      swept[2 * axis + 1] += std::max(0.0, way[axis]);
    }
    const auto in_the_way = [&](dGeomID geom) {
      dReal box[6];
      dGeomGetAABB(geom, box);
      return bounds_meet(swept, box);
    };
    bool met = std::any_of(obstacle_geoms.begin(), obstacle_geoms.end(), in_the_way);
    for (std::size_t j = 0; j < loose.size(); ++j)
      met = met || (j != i && in_the_way(loose[j].geom));
    for (const OdeRobot& robot : robots) {
      for (const OdeGeom& geom : robot.geoms) met = met || in_the_way(geom.geom);
    }
    if (met) trust.doubt[static_cast<std::size_t>(Doubt::kThrough)] = true;
  }
}

// After a step: its rows with the speeds of its end.
double OdeWorld::Impl::elastic_energy() const noexcept {
  if (config.contact == ContactModel::kRigid) return 0.0;
  double energy = 0.0;
  for (const Row& row : rows) {
    const dContact& c = row.contact;
    const double stiffness = c.surface.soft_erp / (c.surface.soft_cfm * h);
    const double end =
        c.geom.depth - h * vector(c.geom.normal).dot(velocity_between(c.geom, row.own, row.other));
    if (end > 0.0) energy += 0.5 * stiffness * end * end;
  }
  return energy;
}

}  // namespace twinbus
