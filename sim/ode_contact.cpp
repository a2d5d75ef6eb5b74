// What touches what in the simulated world, as soft contact rows of ODE.
//
// A row with soft ERP = h k / (h k + c) and CFM = 1 / (h k + c) is lambda = k (depth - h v+) - c v+
// >= 0: a spring and damper by backward Euler.  The corners of a sole carry its declared stiffness;
// everything else exists so that a fallen robot lies on the ground and an arm does not pass through
// a table.  Contacts come in a fixed order.  With contact rigid a row has neither: ODE's LCP.

#include <algorithm>
#include <cmath>

#include "sim/contact_law.h"
#include "sim/ground_contacts.h"
#include "sim/link_hull.h"
#include "sim/ode_impl.h"

namespace twinbus {

namespace {

constexpr int kPointsPerPair = 4;
constexpr double kSlipSpeed = 1e-3;  // below it the friction axes follow the foot [m/s]

void set_geom_offset(dGeomID geom, const Eigen::Isometry3d& pose, const Eigen::Vector3d& com) {
  const Eigen::Vector3d p = pose.translation() - com;
  dMatrix3 rotation;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) rotation[r * 4 + c] = pose.linear()(r, c);
    rotation[r * 4 + 3] = 0.0;
  }
  dGeomSetOffsetPosition(geom, p.x(), p.y(), p.z());
  dGeomSetOffsetRotation(geom, rotation);
}

Solid solid_of(const Shape& shape) noexcept {
  const SolidShape kind = shape.kind == ShapeKind::kBox      ? SolidShape::kBox
                          : shape.kind == ShapeKind::kSphere ? SolidShape::kSphere
                                                             : SolidShape::kCylinder;
  return {kind, shape.size};
}

}  // namespace

// Before there is anything of ODE: a mesh that cannot be read throws.
void OdeWorld::Impl::read_hulls() {
  for (const Link& link : model.links) {
    for (const Shape& shape : link.collision) {
      if (shape.kind != ShapeKind::kMesh) continue;
      const TriangleMesh hull = link_hull(shape);
      OdeMesh& kept = hulls.emplace_back();
      for (const Eigen::Vector3d& point : hull.points) kept.add_point(point);
      for (const auto& [a, b, c] : hull.triangles) kept.add_triangle(a, b, c);
    }
  }
}

void OdeWorld::Impl::add_geoms() {
  plane = dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0);
  std::size_t next_hull = 0;
  for (int link = 0; link < model.link_count(); ++link) {
    for (const Shape& shape : model.links[static_cast<std::size_t>(link)].collision) {
      const std::size_t hull = next_hull;
      if (shape.kind == ShapeKind::kMesh) ++next_hull;
      if (body(link) == nullptr) continue;
      // Of a mesh in the link frame, null if it has no volume.
      const dGeomID geom =
          shape.kind == ShapeKind::kMesh ? hulls[hull].create_geom() : geom_of(solid_of(shape));
      if (geom == nullptr) continue;
      dGeomSetBody(geom, body(link));
      const bool in_link = shape.kind == ShapeKind::kMesh;
      set_geom_offset(geom, in_link ? Eigen::Isometry3d::Identity() : shape.pose,
                      com_in_link[static_cast<std::size_t>(link)]);
      link_geoms.push_back({geom, link});
    }
  }
  for (const Obstacle& obstacle : config.obstacles) add_solid(obstacle, obstacle_geoms);
  for (const Obstacle& tile : config.tiles) add_solid(tile, tile_geoms);
}

void OdeWorld::Impl::add_solid(const Obstacle& obstacle, std::vector<dGeomID>& geoms) {
  if (obstacle.shape == ObstacleShape::kNone) return;
  const dGeomID geom = geom_of(solid_of(obstacle));
  const Eigen::Vector3d p = obstacle.pose.translation();
  const Eigen::Quaterniond q(obstacle.pose.linear());
  const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
  dGeomSetPosition(geom, p.x(), p.y(), p.z());
  dGeomSetQuaternion(geom, attitude);
  geoms.push_back(geom);
}

void OdeWorld::Impl::find_contacts() noexcept {
  contacts.clear();
  contact_rows.clear();
  find_sole_contacts();
  find_link_contacts();
  find_loose_contacts();  // last: contacts and contact_rows go together as far as the rows go
}

void OdeWorld::Impl::find_sole_contacts() noexcept {
  for (int side = 0; side < 2; ++side) {
    const auto foot = static_cast<std::size_t>(side);
    const Sole& sole = model.soles[foot];
    if (sole.link < 0 || body(sole.link) == nullptr) continue;
    const Eigen::Isometry3d& link = kinematics.link_in_world(sole.link);
    const double k = sole.stiffness / kSoleCorners * config.stiffness_scale;
    const double c = sole.damping / kSoleCorners * config.damping_scale;
    const double mu = std::sqrt(sole.friction * config.ground_friction);
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      const Eigen::Vector3d point = link * (sole.frame * sole_corner(sole, corner));
      const double raised = offset[foot][static_cast<std::size_t>(corner)];
      double depth = config.ground_height[foot] - raised - point.z();
      Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
      for (const Obstacle& tile : config.tiles) {
        const Distance d = under_tile(tile, point);
        if (!(-d.value - raised > depth)) continue;
        depth = -d.value - raised;
        normal = d.normal;
      }
      // What comes down within the step touches in it, as in the other engine.
      if (!(depth > 0.0 || depth - h * normal.dot(kinematics.point_velocity(sole.link, point)) > 0.0)) {
        continue;
      }
      dContactGeom geom{};
      for (int i = 0; i < 3; ++i) {
        geom.pos[i] = point[i];
        geom.normal[i] = normal[i];
      }
      geom.depth = depth;
      add_contact(geom, sole.link, side, k, c, mu);
    }
  }
}

int OdeWorld::Impl::sole_at(int link, const Eigen::Vector3d& point) const noexcept {
  for (int side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[static_cast<std::size_t>(side)];
    if (link < 0 || sole.link != link) continue;
    const Eigen::Isometry3d frame = kinematics.link_in_world(sole.link) * sole.frame;
    if ((frame.inverse() * point).z() < kSoleSkin) return side;
  }
  return -1;
}

void OdeWorld::Impl::find_link_contacts() noexcept {
  dContactGeom found[kPointsPerPair];
  const double mu = std::sqrt(kLinkFriction * config.ground_friction);
  for (const OdeGeom& own : link_geoms) {
    dReal box[6];
    dGeomGetAABB(own.geom, box);
    const auto meet = [&](dGeomID other, bool is_ground) {
      const int count = dCollide(own.geom, other, kPointsPerPair, found, sizeof(dContactGeom));
      for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d point(found[i].pos[0], found[i].pos[1], found[i].pos[2]);
        if (is_ground && sole_at(own.link, point) >= 0) continue;  // its corners touch there
        add_contact(found[i], own.link, -1, kLinkStiffness, kLinkDamping, mu);
      }
    };
    if (box[4] <= 0.0) meet(plane, true);
    const auto meet_near = [&](const std::vector<dGeomID>& geoms, bool are_ground) {
      for (const dGeomID geom : geoms) {
        dReal other[6];
        dGeomGetAABB(geom, other);
        if (bounds_meet(box, other)) meet(geom, are_ground);
      }
    };
    meet_near(obstacle_geoms, false);
    // As in the other engine tiles meet no more of a foot than its sole's corners.
    const bool is_foot = std::any_of(model.soles.begin(), model.soles.end(),
                                     [&](const Sole& sole) { return sole.link == own.link; });
    if (!is_foot) meet_near(tile_geoms, true);
  }
}

void OdeWorld::Impl::add_contact(const dContactGeom& geom, int link, int sole, double k, double c,
                                 double mu) noexcept {
  if (contacts.size() >= static_cast<std::size_t>(kMaxContacts)) return;
  const Eigen::Vector3d point(geom.pos[0], geom.pos[1], geom.pos[2]);
  dVector3 velocity;
  dBodyGetPointVel(body(link), point.x(), point.y(), point.z(), velocity);
  const double end = geom.depth - h * (geom.normal[0] * velocity[0] + geom.normal[1] * velocity[1] +
                                       geom.normal[2] * velocity[2]);
  c = damping_at(k, c, end);
  contact_rows.push_back(soft_row(geom, {velocity[0], velocity[1], velocity[2]},
                                  kinematics.link_in_world(link).linear(), k, c, mu));
  contacts.push_back({.link = link,
                      .sole = sole,
                      .point = point,
                      .force = Eigen::Vector3d::Zero(),
                      .depth = std::max(0.0, geom.depth)});
}

double OdeWorld::Impl::damping_at(double k, double c, double depth) const noexcept {
  ContactParams params;
  params.stiffness = k;
  params.damping = c;
  return twinbus::damping_at(as_asked(config, params), depth);
}

// So that the friction pyramid does not favour the world's axes.
dContact OdeWorld::Impl::soft_row(const dContactGeom& geom, const Eigen::Vector3d& velocity,
                                  const Eigen::Matrix3d& turn, double k, double c,
                                  double mu) const noexcept {
  const Eigen::Vector3d normal(geom.normal[0], geom.normal[1], geom.normal[2]);
  Eigen::Vector3d along = velocity - normal.dot(velocity) * normal;
  for (int axis = 0; axis < 2 && !(along.norm() > (axis == 0 ? kSlipSpeed : 0.1)); ++axis) {
    along = turn.col(axis) - normal.dot(turn.col(axis)) * normal;
  }
  along.normalize();
  dContact row{};
  row.geom = geom;
  row.geom.g1 = row.geom.g2 = nullptr;
  row.surface.mode = dContactApprox1 | dContactFDir1;
  const bool soft = config.contact != ContactModel::kRigid;
  if (soft) row.surface.mode |= dContactSoftERP | dContactSoftCFM;
  row.surface.mu = mu;
  row.surface.soft_erp = h * k / (h * k + c);
  row.surface.soft_cfm = 1.0 / (h * k + c);
  // ODE takes a negative depth for none: the way that is left is a speed.
  if (geom.depth < 0.0) {
    row.surface.mode |= dContactMotionN;
    row.surface.motionN = (soft ? row.surface.soft_erp : 1.0) / h * geom.depth;
  }
  for (int i = 0; i < 3; ++i) row.fdir1[i] = along[i];
  return row;
}

void OdeWorld::Impl::create_contact_joints() noexcept {
  for (std::size_t i = 0; i < contact_rows.size(); ++i) {
    const dJointID joint = dJointCreateContact(world, contact_group, &contact_rows[i]);
    dJointAttach(joint, body(contacts[i].link), nullptr);
    dJointSetFeedback(joint, &feedback[i]);
  }
  create_loose_joints();
}

void OdeWorld::Impl::read_contact_forces() noexcept {
  for (std::size_t i = 0; i < contact_rows.size(); ++i) {
    contacts[i].force = Eigen::Vector3d(feedback[i].f1[0], feedback[i].f1[1], feedback[i].f1[2]);
  }
  read_loose_forces();
  read_tie_forces();
  forget_open();
}

// Points that were about to touch and did not.
void OdeWorld::Impl::forget_open() noexcept {
  std::erase_if(contacts,
                [](const ContactPoint& c) { return !(c.depth > 0.0) && c.force.isZero(0.0); });
}

void OdeWorld::Impl::estimate_contact_forces() noexcept {
  find_contacts();
  for (std::size_t i = 0; i < contact_rows.size(); ++i) {
    const dContact& row = contact_rows[i];
    dVector3 velocity;
    dBodyGetPointVel(body(contacts[i].link), row.geom.pos[0], row.geom.pos[1], row.geom.pos[2],
                     velocity);
    const Eigen::Vector3d normal(row.geom.normal[0], row.geom.normal[1], row.geom.normal[2]);
    const double speed = normal.dot(Eigen::Vector3d(velocity[0], velocity[1], velocity[2]));
    const double force = (row.surface.soft_erp / h * row.geom.depth - speed) / row.surface.soft_cfm;
    contacts[i].force = std::max(0.0, force) * normal;
  }
  forget_open();
}

}  // namespace twinbus
