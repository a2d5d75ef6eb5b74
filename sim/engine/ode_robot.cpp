// Bodies and geoms of a robot in the ODE world, and where they are.

#include "sim/engine/ode_robot.h"

#include <cmath>
#include <numbers>

#include "robot/description/model.h"
#include "sim/contact/ground_contacts.h"
#include "sim/world/felt_feet.h"
#include "sim/world/link_hull.h"
#include "sim/engine/ode_geom.h"

namespace twinbus::inline sim {

namespace {

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

OdeRobot::OdeRobot(const Model& m, const WorldConfig& c)
    : model(m),
      config(c),
      pairs(parallel_joints_of(m)),
      never(m),
      configuration(m), start_of_step(m), kinematics(m), solves_(pairs.size()) {
  check_links(model, config.fixed_base);
  read_hulls();
  if (config.contact == ContactModel::kPatch) {
    WorldConfig ground = config;
    ground.obstacles.clear();  // a foot meets them with its own geoms
    patches.emplace(model, ground);
    // On uneven ground a robot on points has ODE's points, as in the other engine its probes.
    if (config.tiles.empty() || model.soles[0].link >= 0 || model.soles[1].link >= 0) link_patches.emplace(model, config);
  }
}

OdeRobot::~OdeRobot() {
  for (const OdeGeom& geom : geoms) dGeomDestroy(geom.geom);
}

void OdeRobot::read_hulls() {
  for (const Link& link : model.links) {
    for (const Shape& shape : link.collision) {
      if (shape.kind != ShapeKind::kMesh) continue;
      const TriangleMesh hull = link_hull(shape);
      OdeMesh& kept = hulls_.emplace_back();
      for (const Eigen::Vector3d& point : hull.points) kept.add_point(point);
      for (const auto& [a, b, c] : hull.triangles) kept.add_triangle(a, b, c);
    }
  }
}

void OdeRobot::create(dWorldID world) {
  // Hinges are attached in the middle of their range, which fixes ODE's zero far from half a turn.
  joints.resize(model.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const bool has_range = std::isfinite(joint.lower) && std::isfinite(joint.upper);
    joints[j].middle = has_range ? 0.5 * (joint.lower + joint.upper) : 0.0;
    configuration.q[static_cast<Eigen::Index>(j)] = joints[j].middle;
  }
  configuration.qd.setZero();
  kinematics.update(configuration);
  create_bodies(world);
  for (int j = 0; j < model.joint_count(); ++j) add_joint(j, world);
  for (const PassiveJoint& passive : passive_joints_of(model)) {
    OdeJoint& joint = joints[static_cast<std::size_t>(passive.joint)];
    joint.passive = true;
    joint.limit = dInfinity;
    joint.target = {.q = passive.rest, .kp = passive.stiffness};
  }
  create_geoms();
}

void OdeRobot::create_bodies(dWorldID world) {
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[static_cast<std::size_t>(i)];
    com_in_link.push_back(link.com);
    link_mass.push_back(link.mass * config.mass_scale);
    total_mass += link_mass.back();
    if (i == 0 && config.fixed_base) {
      bodies.push_back(nullptr);
      continue;
    }
    const Eigen::Matrix3d inertia = link.inertia * config.mass_scale;
    dMass mass;
    dMassSetZero(&mass);
    mass.mass = link_mass.back();
    for (int r = 0; r < 3; ++r) {
      for (int k = 0; k < 3; ++k) mass.I[r * 4 + k] = inertia(r, k);
    }
    const dBodyID body = dBodyCreate(world);
    dBodySetMass(body, &mass);
    bodies.push_back(body);
    const Eigen::Isometry3d& pose = kinematics.link_in_world(i);
    const Eigen::Vector3d com = pose * link.com;
    const Eigen::Quaterniond q(pose.linear());
    const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(body, com.x(), com.y(), com.z());
    dBodySetQuaternion(body, attitude);
  }
}

void OdeRobot::create_geoms() {
  std::size_t next_hull = 0;
  for (int link = 0; link < model.link_count(); ++link) {
    const std::vector<Shape>& shapes = model.links[static_cast<std::size_t>(link)].collision;
    for (const Shape& shape : shapes) {
      const bool in_link = shape.kind == ShapeKind::kMesh;
      // Of a mesh in the link frame, null if it has no volume.
      const dGeomID geom = in_link ? hulls_[next_hull++].create_geom() : geom_of(solid_of(shape));
      if (geom == nullptr) continue;
      const Eigen::Isometry3d pose = in_link ? Eigen::Isometry3d::Identity() : shape.pose;
      geoms.push_back({geom, link, link_patches ? link_patches->of(link, static_cast<int>(&shape - shapes.data())) : -1});
      if (body(link) == nullptr) {
        fixed_geoms_.push_back({geom, pose});
        continue;
      }
      dGeomSetBody(geom, body(link));
      set_geom_offset(geom, pose, com_in_link[static_cast<std::size_t>(link)]);
    }
  }
}

// Joints hold on to the world where the base was when they were made.
void OdeRobot::follow_base() noexcept {
  if (bodies[0] != nullptr || configuration.base.matrix() == attached_at_.matrix()) return;
  attached_at_ = configuration.base;
  Configuration middle(model);
  middle.base = attached_at_;
  middle.qd.setZero();
  for (std::size_t j = 0; j < joints.size(); ++j)
    middle.q[static_cast<Eigen::Index>(j)] = joints[j].middle;
  kinematics.update(middle);
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    if (body(joint.parent) != nullptr) continue;
    const Eigen::Isometry3d& pose = kinematics.link_in_world(joint.child);
    const Eigen::Vector3d com = pose * com_in_link[static_cast<std::size_t>(joint.child)];
    const Eigen::Quaterniond q(pose.linear());
    const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(body(joint.child), com.x(), com.y(), com.z());
    dBodySetQuaternion(body(joint.child), attitude);
    anchor_joint(j);
  }
}

void OdeRobot::place_fixed_base() noexcept {
  for (const FixedGeom& each : fixed_geoms_) {
    const Eigen::Isometry3d pose = configuration.base * each.in_base;
    const Eigen::Quaterniond q(pose.linear());
    const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
    const Eigen::Vector3d& p = pose.translation();
    dGeomSetPosition(each.geom, p.x(), p.y(), p.z());
    dGeomSetQuaternion(each.geom, attitude);
  }
}

void OdeRobot::place(const Configuration& to) noexcept {
  configuration = to;
  if (bodies[0] == nullptr) {
    configuration.base_velocity.setZero();
    configuration.base_angular_velocity.setZero();
  }
  follow_base();
  kinematics.update(configuration);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const dBodyID body = bodies[i];
    if (body == nullptr) continue;
    const int link = static_cast<int>(i);
    const Eigen::Isometry3d& pose = kinematics.link_in_world(link);
    const Eigen::Vector3d com = pose * com_in_link[i];
    const Eigen::Vector3d velocity = kinematics.point_velocity(link, com);
    const Eigen::Vector3d& spin = kinematics.angular_velocity(link);
    const Eigen::Quaterniond q(pose.linear());
    const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(body, com.x(), com.y(), com.z());
    dBodySetQuaternion(body, attitude);
    dBodySetLinearVel(body, velocity.x(), velocity.y(), velocity.z());
    dBodySetAngularVel(body, spin.x(), spin.y(), spin.z());
    dBodySetForce(body, 0.0, 0.0, 0.0);
    dBodySetTorque(body, 0.0, 0.0, 0.0);
  }
  place_fixed_base();
  for (auto& sole : offset) sole.fill(0.0);
}

void OdeRobot::read_state() noexcept {
  if (bodies[0] != nullptr) {
    configuration.base.linear() = matrix(dBodyGetRotation(bodies[0]));
    const Eigen::Vector3d arm = configuration.base.linear() * com_in_link[0];
    configuration.base.translation() = vector(dBodyGetPosition(bodies[0])) - arm;
    configuration.base_angular_velocity = vector(dBodyGetAngularVel(bodies[0]));
    configuration.base_velocity =
        vector(dBodyGetLinearVel(bodies[0])) - configuration.base_angular_velocity.cross(arm);
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    if (joints[j].prismatic) {
      configuration.q[index] = joints[j].middle + dJointGetSliderPosition(joints[j].joint);
      configuration.qd[index] = dJointGetSliderPositionRate(joints[j].joint);
    } else {
      // ODE's angle is within half a turn; ours goes on.
      const double turn = 2.0 * std::numbers::pi;
      const double angle = joints[j].middle + dJointGetHingeAngle(joints[j].joint);
      configuration.q[index] = angle + turn * std::round((configuration.q[index] - angle) / turn);
      configuration.qd[index] = dJointGetHingeAngleRate(joints[j].joint);
    }
  }
}

Eigen::Isometry3d OdeRobot::link_in_world(int link) const noexcept {
  if (body(link) == nullptr) return configuration.base;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = matrix(dBodyGetRotation(body(link)));
  pose.translation() = vector(dBodyGetPosition(body(link))) -
                       pose.linear() * com_in_link[static_cast<std::size_t>(link)];
  return pose;
}

int OdeRobot::sole_at(int link, const Eigen::Vector3d& point) const noexcept {
  for (int side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[static_cast<std::size_t>(side)];
    const bool toe = is_toe_of(model, sole, link);
    if (link < 0 || (sole.link != link && !toe)) continue;
    const Eigen::Vector3d in_sole = (kinematics.link_in_world(sole.link) * sole.frame).inverse() * point;
    if (toe ? under_sole(sole, in_sole, 0.0) : in_sole.z() < kSoleSkin) return side;
  }
  return -1;
}

ContactParams OdeRobot::surface(int side) const noexcept {
  if (side < 0) return shell(config.shell_stiffness, kLinkFriction);
  const Sole& sole = model.soles[static_cast<std::size_t>(side)];
  return rubber(sole.stiffness / kSoleCorners * config.stiffness_scale,
                sole.damping / kSoleCorners * config.damping_scale, sole.friction);
}

}  // namespace twinbus::sim
