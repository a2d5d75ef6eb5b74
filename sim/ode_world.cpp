// Building, setting and stepping the ODE world; rows of the joints are in ode_servo.cpp, contacts
// in ode_contact.cpp.

#include "sim/ode_world.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdarg>
#include <mutex>
#include <numbers>
#include <stdexcept>

#include "robot/dynamics.h"
#include "sim/ode_impl.h"
#include "sim/ties.h"

namespace twinbus {

namespace {

// ODE exits or aborts when an error or debug handler returns, so those leave by an exception that
// step() catches.
struct EngineFailure {};
std::atomic<long> engine_message_count{0};

void on_message(int, const char*, va_list) {
  engine_message_count.fetch_add(1, std::memory_order_relaxed);
}
[[noreturn]] void on_failure(int, const char*, va_list) {
  engine_message_count.fetch_add(1, std::memory_order_relaxed);
  throw EngineFailure{};
}

// ODE is a library with global state: opened once, never closed.
void open_engine() {
  static std::once_flag once;
  std::call_once(once, [] {
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    dSetMessageHandler(&on_message);
    dSetErrorHandler(&on_failure);
    dSetDebugHandler(&on_failure);
    dRandSetSeed(1);
  });
  dAllocateODEDataForThread(dAllocateMaskAll);
}

Eigen::Matrix3d matrix(const dReal* m) {
  Eigen::Matrix3d result;
  result << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
  return result;
}

bool sane(const Eigen::Vector3d& v, double bound) {
  return v.cwiseAbs().maxCoeff() <= bound && v.allFinite();
}

// Before anything of ODE's is made: what a constructor that throws has made is never destroyed.
void check_links(const Model& model, bool fixed_base) {
  for (std::size_t i = fixed_base ? 1 : 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    if (link.mass > 0.0 && link.inertia.llt().info() == Eigen::Success) continue;
    throw std::runtime_error(
        "link '" + link.name +
        "' cannot be simulated: its mass and inertia must be positive; give it an <inertial>");
  }
}

}  // namespace

OdeWorld::Impl::Impl(const Model& m, const WorldConfig& c)
    : model(m), config(c), h(c.step), configuration(m), start_of_step(m), kinematics(m) {
  check_links(m, config.fixed_base);
  read_hulls();
  const std::vector<Tie> tied = checked_ties(m, config);
  open_engine();
  world = dWorldCreate();
  dWorldSetGravity(world, 0.0, 0.0, -kGravity);
  dWorldSetERP(world, 0.2);
  dWorldSetCFM(world, 1e-9);
  const bool rigid = config.contact == ContactModel::kRigid;
  dWorldSetContactSurfaceLayer(world, rigid ? kRigidLayer : 0.0);
  dWorldSetContactMaxCorrectingVel(world, rigid ? kRigidReturn : dInfinity);
  dWorldSetAutoDisableFlag(world, 0);
  contact_group = dJointGroupCreate(0);
  contacts.reserve(kMaxContacts);
  contact_rows.reserve(kMaxContacts);
  feedback.resize(kMaxContacts);
  pushes.reserve(16);

  // Hinges are attached in the middle of their range, which fixes ODE's zero far from half a turn.
  joints.resize(m.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = m.joints[j];
    const bool has_range = std::isfinite(joint.lower) && std::isfinite(joint.upper);
    joints[j].middle = has_range ? 0.5 * (joint.lower + joint.upper) : 0.0;
    configuration.q[static_cast<Eigen::Index>(j)] = joints[j].middle;
  }
  configuration.qd.setZero();
  kinematics.update(configuration);

  for (int i = 0; i < m.link_count(); ++i) {
    const Link& link = m.links[static_cast<std::size_t>(i)];
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
  for (int j = 0; j < m.joint_count(); ++j) add_joint(j, kinematics);
  add_geoms();
  add_loose();
  add_ties(tied);
  for (const dBodyID each : bodies) {
    if (each != nullptr) moving.push_back(each);
  }
  for (const Loose& each : loose) moving.push_back(each.body);
  saved.resize(moving.size());
}

OdeWorld::Impl::~Impl() {
  for (const OdeGeom& geom : link_geoms) dGeomDestroy(geom.geom);
  for (const dGeomID geom : obstacle_geoms) dGeomDestroy(geom);
  for (const dGeomID geom : tile_geoms) dGeomDestroy(geom);
  for (const Loose& each : loose) dGeomDestroy(each.geom);
  if (plane != nullptr) dGeomDestroy(plane);
  dJointGroupDestroy(contact_group);
  dWorldDestroy(world);
}

void OdeWorld::Impl::save() noexcept {
  for (std::size_t i = 0; i < moving.size(); ++i) {
    dCopyVector3(saved[i].position, dBodyGetPosition(moving[i]));
    dCopyVector4(saved[i].attitude, dBodyGetQuaternion(moving[i]));
    dCopyVector3(saved[i].linear, dBodyGetLinearVel(moving[i]));
    dCopyVector3(saved[i].angular, dBodyGetAngularVel(moving[i]));
  }
}

void OdeWorld::Impl::restore() noexcept {
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const SavedBody& s = saved[i];
    dBodySetPosition(moving[i], s.position[0], s.position[1], s.position[2]);
    dBodySetQuaternion(moving[i], s.attitude);
    dBodySetLinearVel(moving[i], s.linear[0], s.linear[1], s.linear[2]);
    dBodySetAngularVel(moving[i], s.angular[0], s.angular[1], s.angular[2]);
    dBodySetForce(moving[i], 0.0, 0.0, 0.0);
    dBodySetTorque(moving[i], 0.0, 0.0, 0.0);
  }
}

void OdeWorld::Impl::read_state() noexcept {
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

bool OdeWorld::Impl::state_is_sane() const noexcept {
  for (const dBodyID body : moving) {
    if (!sane(vector(dBodyGetPosition(body)), kMaxDistance) ||
        !sane(vector(dBodyGetLinearVel(body)), kMaxSpeed) ||
        !sane(vector(dBodyGetAngularVel(body)), kMaxSpeed)) {
      return false;
    }
    const dReal* q = dBodyGetQuaternion(body);
    if (!(std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]) + std::abs(q[3]) < 3.0)) return false;
  }
  return configuration.q.allFinite() && configuration.qd.allFinite();
}

OdeWorld::OdeWorld(const Model& model, const WorldConfig& config)
    : impl_(std::make_unique<Impl>(model, config)) {}
OdeWorld::~OdeWorld() = default;

Status OdeWorld::set(const Configuration& to, const Eigen::VectorXd* tau) noexcept {
  Impl& w = *impl_;
  const Status status = check_configuration(w.joints.size(), to);
  if (status != Status::kOk) return status;
  w.configuration = to;
  if (w.bodies[0] == nullptr) {
    w.configuration.base_velocity.setZero();
    w.configuration.base_angular_velocity.setZero();
  }
  w.kinematics.update(w.configuration);
  for (std::size_t i = 0; i < w.bodies.size(); ++i) {
    const dBodyID body = w.bodies[i];
    if (body == nullptr) continue;
    const int link = static_cast<int>(i);
    const Eigen::Isometry3d& pose = w.kinematics.link_in_world(link);
    const Eigen::Vector3d com = pose * w.com_in_link[i];
    const Eigen::Vector3d velocity = w.kinematics.point_velocity(link, com);
    const Eigen::Vector3d& spin = w.kinematics.angular_velocity(link);
    const Eigen::Quaterniond q(pose.linear());
    const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(body, com.x(), com.y(), com.z());
    dBodySetQuaternion(body, attitude);
    dBodySetLinearVel(body, velocity.x(), velocity.y(), velocity.z());
    dBodySetAngularVel(body, spin.x(), spin.y(), spin.z());
    dBodySetForce(body, 0.0, 0.0, 0.0);
    dBodySetTorque(body, 0.0, 0.0, 0.0);
  }
  for (auto& sole : w.offset) sole.fill(0.0);
  w.estimate_contact_forces();
  for (std::size_t j = 0; j < w.joints.size(); ++j) {
    OdeJoint& joint = w.joints[j];
    joint.bounded = false;
    const double known =
        tau != nullptr && tau->size() == to.q.size() ? (*tau)[static_cast<Eigen::Index>(j)] : 0.0;
    joint.tau = std::isfinite(known) ? std::clamp(known, -joint.limit, joint.limit) : 0.0;
    joint.play = w.flank(joint);
  }
  w.pushes.clear();
  w.frozen = false;
  return Status::kOk;
}

Status OdeWorld::set_servo(int joint, const ServoTarget& t) noexcept {
  Impl& w = *impl_;
  if (joint < 0 || joint >= static_cast<int>(w.joints.size())) return Status::kWrongSize;
  const Status status = check_target(t);
  if (status != Status::kOk) return status;
  ServoTarget& own = w.joints[static_cast<std::size_t>(joint)].target;
  own = t;
  own.kp *= w.config.servo_kp_scale;
  own.kd *= w.config.servo_kd_scale;
  return Status::kOk;
}

Status OdeWorld::push(int link, const Eigen::Vector3d& point,
                      const Eigen::Vector3d& force) noexcept {
  Impl& w = *impl_;
  if (link < 0 || link >= static_cast<int>(w.bodies.size())) return Status::kWrongSize;
  if (!point.allFinite() || !force.allFinite()) return Status::kNotFinite;
  if (!sane(point, kMaxDistance) || !sane(force, kMaxPush) ||
      w.pushes.size() == w.pushes.capacity()) {
    return Status::kOutOfRange;
  }
  w.pushes.push_back({link, point, force});
  return Status::kOk;
}

void OdeWorld::set_corner_offset(int sole, int corner, double offset) noexcept {
  if (!std::isfinite(offset)) return;
  impl_->offset[static_cast<std::size_t>(sole)][static_cast<std::size_t>(corner)] = offset;
}

double OdeWorld::corner_offset(int sole, int corner) const noexcept {
  return impl_->offset[static_cast<std::size_t>(sole)][static_cast<std::size_t>(corner)];
}

Status OdeWorld::step() noexcept {
  Impl& w = *impl_;
  if (w.frozen) return Status::kDiverged;
  try {
    w.save();
    w.start_of_step = w.configuration;
    w.find_contacts();
    // Every pass solves the exact problem of the rows that have limits; a pass that finds another
    // joint beyond its limit gives it a limited row and is taken back.  Joints only gain limits
    // within a step, so this ends.
    for (std::size_t pass = 0; pass <= w.joints.size(); ++pass) {
      for (std::size_t j = 0; j < w.joints.size(); ++j) {
        const auto index = static_cast<Eigen::Index>(j);
        w.prepare_rows(w.joints[j], w.start_of_step.q[index], w.start_of_step.qd[index]);
      }
      w.create_contact_joints();
      for (const Impl::Push& push : w.pushes) {
        if (w.body(push.link) == nullptr) continue;
        dBodyAddForceAtPos(w.body(push.link), push.force.x(), push.force.y(), push.force.z(),
                           push.point.x(), push.point.y(), push.point.z());
      }
      if (dWorldStep(w.world, w.h) == 0) throw EngineFailure{};
      dJointGroupEmpty(w.contact_group);
      w.read_state();
      if (!w.state_is_sane()) throw EngineFailure{};
      if (!w.read_torques()) break;
      w.restore();
      w.configuration = w.start_of_step;
    }
    w.read_contact_forces();
    w.update_play();
    w.kinematics.update(w.configuration);
    w.pushes.clear();
    return Status::kOk;
  } catch (const EngineFailure&) {
    dJointGroupEmpty(w.contact_group);
    w.restore();
    w.configuration = w.start_of_step;
    w.frozen = true;
    return Status::kDiverged;
  }
}

void OdeWorld::estimate_contact_forces() noexcept { impl_->estimate_contact_forces(); }

const Configuration& OdeWorld::configuration() const noexcept { return impl_->configuration; }

double OdeWorld::encoder(int joint) const noexcept {
  const Impl& w = *impl_;
  return w.configuration.q[joint] + w.joints[static_cast<std::size_t>(joint)].play;
}

double OdeWorld::tau(int joint) const noexcept {
  return impl_->joints[static_cast<std::size_t>(joint)].tau;
}

Eigen::Isometry3d OdeWorld::link_in_world(int link) const noexcept {
  const Impl& w = *impl_;
  const dBodyID body = w.body(link);
  if (body == nullptr) return w.configuration.base;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = matrix(dBodyGetRotation(body));
  pose.translation() = vector(dBodyGetPosition(body)) -
                       pose.linear() * w.com_in_link[static_cast<std::size_t>(link)];
  return pose;
}

Eigen::Vector3d OdeWorld::point_velocity(int link, const Eigen::Vector3d& point) const noexcept {
  const dBodyID body = impl_->body(link);
  if (body == nullptr) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d arm = point - vector(dBodyGetPosition(body));
  return vector(dBodyGetLinearVel(body)) + vector(dBodyGetAngularVel(body)).cross(arm);
}

Eigen::Vector3d OdeWorld::angular_velocity(int link) const noexcept {
  const dBodyID body = impl_->body(link);
  return body == nullptr ? Eigen::Vector3d::Zero() : vector(dBodyGetAngularVel(body));
}

double OdeWorld::mass() const noexcept { return impl_->total_mass; }

Eigen::Vector3d OdeWorld::com() const noexcept {
  const Impl& w = *impl_;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < w.bodies.size(); ++i) {
    const Eigen::Vector3d at = w.bodies[i] != nullptr
                                   ? vector(dBodyGetPosition(w.bodies[i]))
                                   : Eigen::Vector3d(w.configuration.base * w.com_in_link[i]);
    sum += w.link_mass[i] * at;
  }
  return sum / w.total_mass;
}

Eigen::Vector3d OdeWorld::com_velocity() const noexcept {
  const Impl& w = *impl_;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < w.bodies.size(); ++i) {
    if (w.bodies[i] != nullptr) sum += w.link_mass[i] * vector(dBodyGetLinearVel(w.bodies[i]));
  }
  return sum / w.total_mass;
}

const std::vector<ContactPoint>& OdeWorld::contacts() const noexcept { return impl_->contacts; }

double OdeWorld::corner_stiffness(int sole) const noexcept {
  const Impl& w = *impl_;
  if (w.config.contact == ContactModel::kRigid) return kRigidStiffness;
  return w.model.soles[static_cast<std::size_t>(sole)].stiffness / kSoleCorners *
         w.config.stiffness_scale;
}

double OdeWorld::corner_damping(int sole, double force) const noexcept {
  const Impl& w = *impl_;
  if (w.config.contact == ContactModel::kRigid) return 0.0;
  const double k = corner_stiffness(sole);
  return w.damping_at(
      k,
      w.model.soles[static_cast<std::size_t>(sole)].damping / kSoleCorners * w.config.damping_scale,
      force / k);
}

long OdeWorld::engine_messages() noexcept {
  return engine_message_count.load(std::memory_order_relaxed);
}

}  // namespace twinbus
