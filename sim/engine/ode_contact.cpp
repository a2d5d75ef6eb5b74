// What touches what in the simulated world, as soft contact rows of ODE.
//
// A row with soft ERP = h k / (h k + c) and CFM = 1 / (h k + c) is lambda = k (depth - h v+) - c v+
// >= 0: a spring and damper by backward Euler.  The corners of a sole carry its declared stiffness;
// everything else exists so that a fallen robot lies on the ground and an arm does not pass through
// a table.  Contacts come in a fixed order.  With contact rigid a row has neither: ODE's LCP.

#include <algorithm>

#include "sim/contact/contact_law.h"
#include "sim/contact/ground_contacts.h"
#include "sim/objects/rigid_object_contacts.h"
#include "sim/engine/ode_world.h"

namespace twinbus::inline sim {

namespace {

constexpr std::size_t kNoSurface = static_cast<std::size_t>(-1);  // of link patches
constexpr double kSlipSpeed = 1e-3;  // below it the friction axes follow the foot [m/s]

}  // namespace

void OdeWorld::add_geoms() {
  plane_ = dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0);
  for (const Obstacle& obstacle : config_.obstacles) add_solid(obstacle, obstacle_geoms_);
  for (const Obstacle& tile : config_.tiles) add_solid(tile, tile_geoms_);
}

void OdeWorld::add_solid(const Obstacle& obstacle, std::vector<dGeomID>& geoms) {
  if (obstacle.shape == ObstacleShape::kNone) return;
  const dGeomID geom = geom_of(solid_of(obstacle));
  const Eigen::Vector3d p = obstacle.pose.translation();
  const Eigen::Quaterniond q(obstacle.pose.linear());
  const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
  dGeomSetPosition(geom, p.x(), p.y(), p.z());
  dGeomSetQuaternion(geom, attitude);
  geoms.push_back(geom);
}

void OdeWorld::find_contacts() noexcept {
  contacts_.clear();
  rows_.clear();
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    find_sole_contacts(robot);
    find_link_contacts(robot);
  }
  find_meetings();
  find_loose_contacts();
}

void OdeWorld::find_sole_contacts(std::size_t index) noexcept {
  const OdeRobot& robot = robots_[index];
  for (int side = 0; side < 2; ++side) {
    const auto foot = static_cast<std::size_t>(side);
    const Sole& sole = robot.model.soles[foot];
    if (sole.link < 0 || robot.body(sole.link) == nullptr) continue;
    const Eigen::Isometry3d& link = robot.kinematics.link_in_world(sole.link);
    if (robot.patches) {
      press_sole(index, side);
      continue;
    }
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      const Eigen::Vector3d point = link * (sole.frame * sole_corner(sole, corner));
      const double raised = robot.offset[foot][static_cast<std::size_t>(corner)];
      double depth = robot.config.ground_height[foot] - raised - point.z();
      Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
      for (const Obstacle& tile : config_.tiles) {
        const Distance d = under_tile(tile, point);
        if (!(-d.value - raised > depth)) continue;
        depth = -d.value - raised;
        normal = d.normal;
      }
      // What comes down within the step touches in it, as in the other engine.
      const Eigen::Vector3d velocity = robot.kinematics.point_velocity(sole.link, point);
      if (!(depth > 0.0 || depth - h_ * normal.dot(velocity) > 0.0)) continue;
      dContactGeom geom{};
      for (int i = 0; i < 3; ++i) {
        geom.pos[i] = point[i];
        geom.normal[i] = normal[i];
      }
      geom.depth = depth;
      add_contact(geom, index, sole.link, side);
    }
  }
}

// With all of its area, as in the other engine.
void OdeWorld::press_sole(std::size_t index, int side) noexcept {
  const OdeRobot& robot = robots_[index];
  const auto foot = static_cast<std::size_t>(side);
  const Sole& sole = robot.model.soles[foot];
  const Eigen::Isometry3d frame = robot.kinematics.link_in_world(sole.link) * sole.frame;
  SolePatches::Points points;
  const int count = robot.patches->find(
      foot, frame, robot.kinematics.point_velocity(sole.link, frame.translation()),
      robot.kinematics.angular_velocity(sole.link), h_, robot.config.ground_height[foot],
      robot.offset[foot], points);
  const ContactParams whole = together(robot.surface(side), ground_);
  for (int i = 0; i < count && has_room(); ++i) {
    const SolePoint& point = points[static_cast<std::size_t>(i)];
    dContactGeom geom{};
    for (int k = 0; k < 3; ++k) {
      geom.pos[k] = point.position[k];
      geom.normal[k] = point.normal[k];
    }
    geom.depth = point.depth;
    const int felt = feel(index, sole.link, side, geom);
    if (index == 0 && felt < 0) return;
    add_row(geom, robot.body(sole.link), nullptr, times(whole, point.weight), felt, -1);
  }
}

// The same of a link that is no foot.
void OdeWorld::press_link(std::size_t index, const OdeGeom& part, std::size_t surface) noexcept {
  const OdeRobot& robot = robots_[index];
  const Eigen::Isometry3d& link = robot.kinematics.link_in_world(part.link);
  LinkPress press;
  if (!robot.link_patches->find(part.area, link, robot.kinematics.point_velocity(part.link, link.translation()),
                                robot.kinematics.angular_velocity(part.link), h_, surface, press)) {
    return;
  }
  const ContactParams params = times(together(robot.surface(-1), ground_), press.weight);
  for (int i = 0; i < press.count && has_room(); ++i) {
    const LinkPoint& point = press.point[static_cast<std::size_t>(i)];
    dContactGeom geom{};
    for (int k = 0; k < 3; ++k) {
      geom.pos[k] = point.position[k];
      geom.normal[k] = press.normal[k];
    }
    geom.depth = point.depth;
    const int felt = feel(index, part.link, -1, geom);
    if (index == 0 && felt < 0) return;
    add_row(geom, robot.body(part.link), nullptr, params, felt, -1);
  }
}

void OdeWorld::find_link_contacts(std::size_t index) noexcept {
  dContactGeom found[kPointsPerPair];
  const OdeRobot& robot = robots_[index];
  for (const OdeGeom& part : robot.geoms) {
    if (robot.body(part.link) == nullptr) continue;
    dReal box[6];
    dGeomGetAABB(part.geom, box);
    const auto meet_one = [&](dGeomID other, std::size_t surface) {
      if (part.area >= 0 && surface < kNoSurface) {
        press_link(index, part, surface);
        return;
      }
      const int count = dCollide(part.geom, other, kPointsPerPair, found, sizeof(dContactGeom));
      for (int i = 0; i < count; ++i) {
        const bool by_corners =
            other == plane_ && robot.sole_at(part.link, vector(found[i].pos)) >= 0;
        if (!by_corners) add_contact(found[i], index, part.link, -1);
      }
    };
    const auto meet_near = [&](const std::vector<dGeomID>& geoms, bool press) {
      for (std::size_t i = 0; i < geoms.size(); ++i) {
        dReal other[6];
        dGeomGetAABB(geoms[i], other);
        if (bounds_meet(box, other)) meet_one(geoms[i], press ? i + 1 : kNoSurface);
      }
    };
    if (box[4] <= 0.0) meet_one(plane_, 0);
    meet_near(obstacle_geoms_, true);
    // As in the other engine tiles meet no more of a foot than its sole's corners.
    if (!robot.has_sole(part.link)) meet_near(tile_geoms_, false);
  }
}

void OdeWorld::add_contact(const dContactGeom& geom, std::size_t robot, int link,
                           int sole) noexcept {
  if (!has_room()) return;
  const int felt = feel(robot, link, sole, geom);
  if (robot == 0 && felt < 0) return;
  add_row(geom, robots_[robot].body(link), nullptr, together(robots_[robot].surface(sole), ground_),
          felt, -1);
}

int OdeWorld::feel(std::size_t robot, int link, int sole, const dContactGeom& geom) noexcept {
  if (robot != 0 || contacts_.size() >= static_cast<std::size_t>(kMaxContacts)) return -1;
  contacts_.push_back({.link = link,
                      .sole = sole,
                      .point = vector(geom.pos),
                      .force = Eigen::Vector3d::Zero(),
                      .depth = std::max(0.0, geom.depth)});
  return static_cast<int>(contacts_.size()) - 1;
}

Eigen::Vector3d OdeWorld::velocity_between(const dContactGeom& geom, dBodyID first,
                                           dBodyID second) const noexcept {
  dVector3 v, other{0.0, 0.0, 0.0, 0.0};
  dBodyGetPointVel(first, geom.pos[0], geom.pos[1], geom.pos[2], v);
  if (second != nullptr) dBodyGetPointVel(second, geom.pos[0], geom.pos[1], geom.pos[2], other);
  return vector(v) - vector(other);
}

void OdeWorld::add_row(const dContactGeom& geom, dBodyID first, dBodyID second,
                       const ContactParams& params, int felt, int felt_by_other) noexcept {
  const Eigen::Vector3d velocity = velocity_between(geom, first, second);
  const double end = geom.depth - h_ * vector(geom.normal).dot(velocity);
  const double c = damping_at(as_asked(config_, params), end);
  rows_.push_back({soft_row(geom, velocity, first, params.stiffness, c, params.friction), first,
                  second, felt, felt_by_other});
}

// So that the friction pyramid does not favour the world's axes.
dContact OdeWorld::soft_row(const dContactGeom& geom, const Eigen::Vector3d& velocity,
                            dBodyID body, double k, double c, double mu) const noexcept {
  const Eigen::Matrix3d turn = matrix(dBodyGetRotation(body));
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
  const bool soft = config_.contact != ContactModel::kRigid;
  if (soft) row.surface.mode |= dContactSoftERP | dContactSoftCFM;
  row.surface.mu = mu;
  row.surface.soft_erp = h_ * k / (h_ * k + c);
  row.surface.soft_cfm = 1.0 / (h_ * k + c);
  if (config_.rolling_friction > 0.0 || config_.torsional_friction > 0.0) {
    row.surface.mode |= dContactRolling | dContactAxisDep;
    row.surface.mu2 = mu;
    row.surface.rho = row.surface.rho2 = config_.rolling_friction;
    row.surface.rhoN = config_.torsional_friction;
  }
  // ODE takes a negative depth for none: the way that is left is a speed.
  if (geom.depth < 0.0) {
    row.surface.mode |= dContactMotionN;
    row.surface.motionN = (soft ? row.surface.soft_erp : 1.0) / h_ * geom.depth;
  }
  for (int i = 0; i < 3; ++i) row.fdir1[i] = along[i];
  return row;
}

void OdeWorld::create_contact_joints() noexcept {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const dJointID joint = dJointCreateContact(world_, contact_group_, &rows_[i].contact);
    dJointAttach(joint, rows_[i].own, rows_[i].other);
    dJointSetFeedback(joint, &feedback_[i]);
  }
}

void OdeWorld::read_contact_forces() noexcept {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Eigen::Vector3d force = vector(feedback_[i].f1);
    // The torque that ODE tells is about the body's middle.
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    if ((rows_[i].contact.surface.mode & dContactRolling) != 0) {
      const Eigen::Vector3d arm = vector(rows_[i].contact.geom.pos) - vector(dBodyGetPosition(rows_[i].own));
      moment = vector(feedback_[i].t1) - arm.cross(force);
    }
    const auto felt_as = [&](int index, double sign) {
      if (index < 0) return;
      contacts_[static_cast<std::size_t>(index)].force = sign * force;
      contacts_[static_cast<std::size_t>(index)].moment = sign * moment;
    };
    felt_as(rows_[i].felt, 1.0);
    felt_as(rows_[i].felt_by_other, -1.0);
  }
  read_tie_forces();
  forget_open();
}

// Points that were about to touch and did not.
void OdeWorld::forget_open() noexcept {
  std::erase_if(contacts_,
                [](const ContactPoint& c) { return !(c.depth > 0.0) && c.force.isZero(0.0); });
}

// Of what is fixed alone: that is what carries a robot.
void OdeWorld::estimate_contact_forces() noexcept {
  find_contacts();
  for (const Row& row : rows_) {
    if (row.felt < 0 || row.other != nullptr) continue;
    const dContact& contact = row.contact;
    const Eigen::Vector3d normal = vector(contact.geom.normal);
    const double speed = normal.dot(velocity_between(contact.geom, row.own, nullptr));
    const double force =
        (contact.surface.soft_erp / h_ * contact.geom.depth - speed) / contact.surface.soft_cfm;
    contacts_[static_cast<std::size_t>(row.felt)].force = std::max(0.0, force) * normal;
  }
  forget_open();
}

}  // namespace twinbus::sim
