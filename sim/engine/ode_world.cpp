// Building, setting and stepping the ODE world; its robots are in ode_robot.cpp, rows of their
// joints in ode_servo.cpp, contacts in ode_contact.cpp.

#include "sim/engine/ode_world.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdarg>
#include <limits>
#include <mutex>

#include "robot/dynamics/inverse_dynamics.h"
#include "sim/contact/ground_contacts.h"
#include "sim/engine/ode_impl.h"
#include "sim/contact/ties.h"

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
    dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
    dSetMessageHandler(&on_message);
    dSetErrorHandler(&on_failure);
    dSetDebugHandler(&on_failure);
    dRandSetSeed(1);
  });
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
}

bool sane(const Eigen::Vector3d& v, double bound) {
  return v.cwiseAbs().maxCoeff() <= bound && v.allFinite();
}

// Before anything of ODE's is made: what a constructor that throws has made is never destroyed.
std::deque<OdeRobot> robots_of(const Model& model, const WorldConfig& config) {
  std::deque<OdeRobot> robots;
  robots.emplace_back(model, config);
  for (const OtherRobot& each : config.robots) {
    check_robot(each);
    robots.emplace_back(*each.model, config_of(each, config));
  }
  return robots;
}

ContactParams fixed(double friction) {
  constexpr double kRigid = std::numeric_limits<double>::infinity();
  return {kRigid, kRigid, kRigid, kRigid, friction};
}

}  // namespace

OdeWorld::Impl::Impl(const Model& m, const WorldConfig& c)
    : config(c),
      h(c.step),
      robots(robots_of(m, config)),
      commanded(robots.front()),
      ground(fixed(c.ground_friction)) {
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
  pushes.reserve(16);
  create_robots();
  add_geoms();
  add_loose();
  add_ties(tied);
  for (const OdeRobot& robot : robots) {
    for (const dBodyID each : robot.bodies) {
      if (each != nullptr) moving.push_back(each);
    }
  }
  for (const Loose& each : loose) moving.push_back(each.body);
  saved.resize(moving.size());
  const bool meet = config.self_contact || robots.size() > 1;
  const std::size_t of_robots = robots.size() * (meet ? 2 : 1) * kMaxContacts;
  contacts.reserve(kMaxContacts);
  feedback.resize(of_robots + loose.size() * static_cast<std::size_t>(kMostLooseContacts));
  rows.reserve(feedback.size());
  deep.reserve(feedback.size());
}

void OdeWorld::Impl::create_robots() {
  for (OdeRobot& robot : robots) robot.create(world);
  for (std::size_t i = 0; i < config.robots.size(); ++i) {
    const OtherRobot& asked = config.robots[i];
    OdeRobot& robot = robots[i + 1];
    robot.place(asked.start);
    for (int j = 0; j < robot.model.joint_count(); ++j) {
      const ServoTarget& servo = asked.servos[static_cast<std::size_t>(j)];
      robot.set_servo(j, servo);
      robot.set_tau(j, servo.tau);
    }
  }
}

OdeWorld::Impl::~Impl() {
  for (const dGeomID geom : obstacle_geoms) dGeomDestroy(geom);
  for (const dGeomID geom : tile_geoms) dGeomDestroy(geom);
  for (const Loose& each : loose) dGeomDestroy(each.geom);
  if (plane != nullptr) dGeomDestroy(plane);
  robots.clear();  // geoms before the bodies that carry them
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
  for (OdeRobot& robot : robots) robot.start_of_step = robot.configuration;
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
  for (OdeRobot& robot : robots) robot.configuration = robot.start_of_step;
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
  return std::all_of(robots.begin(), robots.end(), [](const OdeRobot& robot) {
    return robot.configuration.q.allFinite() && robot.configuration.qd.allFinite();
  });
}

void OdeWorld::Impl::prepare_step() noexcept {
  for (OdeRobot& robot : robots) robot.prepare_rows();
  create_contact_joints();
  for (const Push& push : pushes) {
    if (commanded.body(push.link) == nullptr) continue;
    dBodyAddForceAtPos(commanded.body(push.link), push.force.x(), push.force.y(), push.force.z(),
                       push.point.x(), push.point.y(), push.point.z());
  }
}

bool OdeWorld::Impl::read_step() noexcept {
  dJointGroupEmpty(contact_group);
  for (OdeRobot& robot : robots) robot.read_state();
  return state_is_sane();
}

OdeWorld::OdeWorld(const Model& model, const WorldConfig& config)
    : impl_(std::make_unique<Impl>(model, config)) {}
OdeWorld::~OdeWorld() = default;

Status OdeWorld::set(const Configuration& to, const Eigen::VectorXd* tau) noexcept {
  Impl& w = *impl_;
  const Status status = check_configuration(w.commanded.joints.size(), to);
  if (status != Status::kOk) return status;
  w.commanded.place(to);
  w.estimate_contact_forces();
  const bool known = tau != nullptr && tau->size() == to.q.size();
  for (int j = 0; j < w.commanded.model.joint_count(); ++j)
    w.commanded.set_tau(j, known ? (*tau)[j] : 0.0);
  w.pushes.clear();
  w.frozen = false;
  w.placed = true;
  return Status::kOk;
}

Status OdeWorld::set_servo(int joint, const ServoTarget& t) noexcept {
  Impl& w = *impl_;
  if (joint < 0 || joint >= w.commanded.model.joint_count()) return Status::kWrongSize;
  const Status status = check_target(t);
  if (status == Status::kOk) w.commanded.set_servo(joint, t);
  return status;
}

Status OdeWorld::push(int link, const Eigen::Vector3d& point,
                      const Eigen::Vector3d& force) noexcept {
  Impl& w = *impl_;
  if (link < 0 || link >= w.commanded.model.link_count()) return Status::kWrongSize;
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
  impl_->commanded.offset[static_cast<std::size_t>(sole)][static_cast<std::size_t>(corner)] =
      offset;
}

double OdeWorld::corner_offset(int sole, int corner) const noexcept {
  return impl_->commanded.offset[static_cast<std::size_t>(sole)][static_cast<std::size_t>(corner)];
}

Status OdeWorld::step() noexcept {
  Impl& w = *impl_;
  trust_ = w.trust = {};
  if (w.frozen) return Status::kDiverged;
  const long messages = engine_messages();
  try {
    w.save();
    w.find_contacts();
    w.doubt_rows();
    w.placed = false;
    // Every pass solves the exact problem of the rows that have limits; a pass that finds another
    // joint beyond its limit gives it a limited row and is taken back.  Joints only gain limits
    // within a step, so this ends.
    for (;;) {
      w.prepare_step();
      if (dWorldStep(w.world, w.h) == 0 || !w.read_step()) throw EngineFailure{};
      bool beyond = false;
      for (OdeRobot& robot : w.robots) beyond = robot.read_torques() || beyond;
      if (!beyond) break;
      w.restore();
    }
    w.read_contact_forces();
    for (OdeRobot& robot : w.robots) {
      robot.update_play();
      robot.kinematics.update(robot.configuration);
    }
    w.pushes.clear();
    w.trust.doubt[static_cast<std::size_t>(Doubt::kUnconverged)] = engine_messages() > messages;
    trust_ = w.trust;
    return Status::kOk;
  } catch (const EngineFailure&) {
    dJointGroupEmpty(w.contact_group);
    w.restore();
    w.frozen = true;
    return Status::kDiverged;
  }
}

void OdeWorld::estimate_contact_forces() noexcept { impl_->estimate_contact_forces(); }

const Configuration& OdeWorld::configuration() const noexcept {
  return impl_->commanded.configuration;
}

double OdeWorld::encoder(int joint) const noexcept {
  const OdeRobot& robot = impl_->commanded;
  return robot.configuration.q[joint] + robot.joints[static_cast<std::size_t>(joint)].play;
}

double OdeWorld::tau(int joint) const noexcept {
  return impl_->commanded.joints[static_cast<std::size_t>(joint)].tau;
}

Eigen::Isometry3d OdeWorld::link_in_world(int link) const noexcept {
  return impl_->commanded.link_in_world(link);
}

Eigen::Isometry3d OdeWorld::robot_link(int robot, int link) const noexcept {
  return impl_->robots[static_cast<std::size_t>(robot + 1)].link_in_world(link);
}

Eigen::Vector3d OdeWorld::point_velocity(int link, const Eigen::Vector3d& point) const noexcept {
  const dBodyID body = impl_->commanded.body(link);
  if (body == nullptr) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d arm = point - vector(dBodyGetPosition(body));
  return vector(dBodyGetLinearVel(body)) + vector(dBodyGetAngularVel(body)).cross(arm);
}

Eigen::Vector3d OdeWorld::angular_velocity(int link) const noexcept {
  const dBodyID body = impl_->commanded.body(link);
  return body == nullptr ? Eigen::Vector3d::Zero() : vector(dBodyGetAngularVel(body));
}

double OdeWorld::mass() const noexcept { return impl_->commanded.total_mass; }

Eigen::Vector3d OdeWorld::com() const noexcept {
  const OdeRobot& robot = impl_->commanded;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    const Eigen::Vector3d at =
        robot.bodies[i] != nullptr
            ? vector(dBodyGetPosition(robot.bodies[i]))
            : Eigen::Vector3d(robot.configuration.base * robot.com_in_link[i]);
    sum += robot.link_mass[i] * at;
  }
  return sum / robot.total_mass;
}

Eigen::Vector3d OdeWorld::com_velocity() const noexcept {
  const OdeRobot& robot = impl_->commanded;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    if (robot.bodies[i] == nullptr) continue;
    sum += robot.link_mass[i] * vector(dBodyGetLinearVel(robot.bodies[i]));
  }
  return sum / robot.total_mass;
}

const std::vector<ContactPoint>& OdeWorld::contacts() const noexcept { return impl_->contacts; }

double OdeWorld::corner_stiffness(int sole) const noexcept {
  const Impl& w = *impl_;
  return w.config.contact == ContactModel::kRigid ? kRigidStiffness
                                                  : w.commanded.surface(sole).stiffness;
}

double OdeWorld::corner_damping(int sole, double force) const noexcept {
  const Impl& w = *impl_;
  if (w.config.contact == ContactModel::kRigid) return 0.0;
  const ContactParams params = as_asked(w.config, w.commanded.surface(sole));
  return damping_at(params, force / params.stiffness);
}

double OdeWorld::elastic_energy() const noexcept { return impl_->elastic_energy(); }

long OdeWorld::engine_messages() noexcept {
  return engine_message_count.load(std::memory_order_relaxed);
}

}  // namespace twinbus
