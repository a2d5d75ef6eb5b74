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
#include "sim/contact/ties.h"

namespace twinbus::inline sim {

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

OdeWorld::OdeWorld(const Model& model, const WorldConfig& config)
    : config_(config),
      h_(config.step),
      robots_(robots_of(model, config_)),
      commanded_(robots_.front()),
      ground_(fixed(config.ground_friction)) {
  const std::vector<Tie> tied = checked_ties(model, config_);
  open_engine();
  world_ = dWorldCreate();
  queue_ = dThreadingAllocateSelfThreadedImplementation();
  dWorldSetStepThreadingImplementation(world_, dThreadingImplementationGetFunctions(queue_), queue_);
  dWorldSetGravity(world_, 0.0, 0.0, -kGravity);
  dWorldSetERP(world_, 0.2);
  dWorldSetCFM(world_, 1e-9);
  const bool rigid = config_.contact == ContactModel::kRigid;
  dWorldSetContactSurfaceLayer(world_, rigid ? kRigidLayer : 0.0);
  dWorldSetContactMaxCorrectingVel(world_, rigid ? kRigidReturn : dInfinity);
  dWorldSetAutoDisableFlag(world_, 0);
  contact_group_ = dJointGroupCreate(0);
  pushes_.reserve(16);
  create_robots();
  add_geoms();
  add_loose();
  add_ties(tied);
  for (const OdeRobot& robot : robots_) {
    for (const dBodyID each : robot.bodies) {
      if (each != nullptr) moving_.push_back(each);
    }
  }
  for (const Loose& each : loose_) moving_.push_back(each.body);
  saved_.resize(moving_.size());
  const bool meet = config_.self_contact || robots_.size() > 1;
  const std::size_t of_robots = robots_.size() * (meet ? 2 : 1) * kMaxContacts;
  contacts_.reserve(kMaxContacts);
  feedback_.resize(of_robots + loose_.size() * static_cast<std::size_t>(kMostLooseContacts));
  rows_.reserve(feedback_.size());
  deep_.reserve(feedback_.size());
}

void OdeWorld::create_robots() {
  for (OdeRobot& robot : robots_) robot.create(world_);
  for (std::size_t i = 0; i < config_.robots.size(); ++i) {
    const OtherRobot& asked = config_.robots[i];
    OdeRobot& robot = robots_[i + 1];
    robot.place(asked.start);
    for (int j = 0; j < robot.model.joint_count(); ++j) {
      const ServoTarget& servo = asked.servos[static_cast<std::size_t>(j)];
      robot.set_servo(j, servo);
      robot.set_tau(j, servo.tau);
    }
  }
}

OdeWorld::~OdeWorld() {
  for (const dGeomID geom : obstacle_geoms_) dGeomDestroy(geom);
  for (const dGeomID geom : tile_geoms_) dGeomDestroy(geom);
  for (const Loose& each : loose_) dGeomDestroy(each.geom);
  if (plane_ != nullptr) dGeomDestroy(plane_);
  robots_.clear();  // geoms before the bodies that carry them
  dJointGroupDestroy(contact_group_);
  dWorldDestroy(world_);
  dThreadingFreeImplementation(queue_);
}

void OdeWorld::save() noexcept {
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    dCopyVector3(saved_[i].position, dBodyGetPosition(moving_[i]));
    dCopyVector4(saved_[i].attitude, dBodyGetQuaternion(moving_[i]));
    dCopyVector3(saved_[i].linear, dBodyGetLinearVel(moving_[i]));
    dCopyVector3(saved_[i].angular, dBodyGetAngularVel(moving_[i]));
  }
  for (OdeRobot& robot : robots_) robot.start_of_step = robot.configuration;
}

void OdeWorld::restore() noexcept {
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    const SavedBody& s = saved_[i];
    dBodySetPosition(moving_[i], s.position[0], s.position[1], s.position[2]);
    dBodySetQuaternion(moving_[i], s.attitude);
    dBodySetLinearVel(moving_[i], s.linear[0], s.linear[1], s.linear[2]);
    dBodySetAngularVel(moving_[i], s.angular[0], s.angular[1], s.angular[2]);
    dBodySetForce(moving_[i], 0.0, 0.0, 0.0);
    dBodySetTorque(moving_[i], 0.0, 0.0, 0.0);
  }
  for (OdeRobot& robot : robots_) robot.configuration = robot.start_of_step;
}

bool OdeWorld::state_is_sane() const noexcept {
  for (const dBodyID body : moving_) {
    if (!sane(vector(dBodyGetPosition(body)), kMaxDistance) ||
        !sane(vector(dBodyGetLinearVel(body)), kMaxSpeed) ||
        !sane(vector(dBodyGetAngularVel(body)), kMaxSpeed)) {
      return false;
    }
    const dReal* q = dBodyGetQuaternion(body);
    if (!(std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]) + std::abs(q[3]) < 3.0)) return false;
  }
  return std::all_of(robots_.begin(), robots_.end(), [](const OdeRobot& robot) {
    return robot.configuration.q.allFinite() && robot.configuration.qd.allFinite();
  });
}

void OdeWorld::prepare_step() noexcept {
  for (OdeRobot& robot : robots_) robot.prepare_rows();
  create_contact_joints();
  for (const Push& push : pushes_) {
    if (commanded_.body(push.link) == nullptr) continue;
    dBodyAddForceAtPos(commanded_.body(push.link), push.force.x(), push.force.y(), push.force.z(),
                       push.point.x(), push.point.y(), push.point.z());
  }
}

bool OdeWorld::read_step() noexcept {
  dJointGroupEmpty(contact_group_);
  for (OdeRobot& robot : robots_) robot.read_state();
  return state_is_sane();
}

Status OdeWorld::set(const Configuration& to, const Eigen::VectorXd* tau) noexcept {
  const Status status = check_configuration(commanded_.joints.size(), to);
  if (status != Status::kOk) return status;
  commanded_.place(to);
  estimate_contact_forces();
  const bool known = tau != nullptr && tau->size() == to.q.size();
  for (int j = 0; j < commanded_.model.joint_count(); ++j)
    commanded_.set_tau(j, known ? (*tau)[j] : 0.0);
  pushes_.clear();
  frozen_ = false;
  placed_ = true;
  return Status::kOk;
}

Status OdeWorld::set_servo(int joint, const ServoTarget& t) noexcept {
  if (joint < 0 || joint >= commanded_.model.joint_count()) return Status::kWrongSize;
  const Status status = check_target(t);
  if (status == Status::kOk) commanded_.set_servo(joint, t);
  return status;
}

Status OdeWorld::push(int link, const Eigen::Vector3d& point,
                      const Eigen::Vector3d& force) noexcept {
  if (link < 0 || link >= commanded_.model.link_count()) return Status::kWrongSize;
  if (!point.allFinite() || !force.allFinite()) return Status::kNotFinite;
  if (!sane(point, kMaxDistance) || !sane(force, kMaxPush) ||
      pushes_.size() == pushes_.capacity()) {
    return Status::kOutOfRange;
  }
  pushes_.push_back({link, point, force});
  return Status::kOk;
}

void OdeWorld::set_corner_offset(int sole, int corner, double offset) noexcept {
  if (!std::isfinite(offset)) return;
  commanded_.offset[static_cast<std::size_t>(sole)][static_cast<std::size_t>(corner)] = offset;
}

Status OdeWorld::step() noexcept {
  trust_ = {};
  if (frozen_) return Status::kDiverged;
  const long messages = engine_messages();
  try {
    save();
    find_contacts();
    doubt_rows();
    placed_ = false;
    // Every pass solves the exact problem of the rows that have limits; a pass that finds another
    // joint beyond its limit gives it a limited row and is taken back.  Joints only gain limits
    // within a step, so this ends.
    for (;;) {
      prepare_step();
      if (dWorldStep(world_, h_) == 0 || !read_step()) throw EngineFailure{};
      bool beyond = false;
      for (OdeRobot& robot : robots_) beyond = robot.read_torques() || beyond;
      if (!beyond) break;
      restore();
    }
    read_contact_forces();
    for (OdeRobot& robot : robots_) {
      robot.update_play();
      robot.kinematics.update(robot.configuration);
    }
    pushes_.clear();
    trust_.doubt[static_cast<std::size_t>(Doubt::kUnconverged)] = engine_messages() > messages;
    return Status::kOk;
  } catch (const EngineFailure&) {
    dJointGroupEmpty(contact_group_);
    restore();
    trust_ = {};
    frozen_ = true;
    return Status::kDiverged;
  }
}

Eigen::Vector3d OdeWorld::point_velocity(int link, const Eigen::Vector3d& point) const noexcept {
  const dBodyID body = commanded_.body(link);
  if (body == nullptr) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d arm = point - vector(dBodyGetPosition(body));
  return vector(dBodyGetLinearVel(body)) + vector(dBodyGetAngularVel(body)).cross(arm);
}

Eigen::Vector3d OdeWorld::angular_velocity(int link) const noexcept {
  const dBodyID body = commanded_.body(link);
  return body == nullptr ? Eigen::Vector3d::Zero() : vector(dBodyGetAngularVel(body));
}

Eigen::Vector3d OdeWorld::com() const noexcept {
  const OdeRobot& robot = commanded_;
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
  const OdeRobot& robot = commanded_;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    if (robot.bodies[i] == nullptr) continue;
    sum += robot.link_mass[i] * vector(dBodyGetLinearVel(robot.bodies[i]));
  }
  return sum / robot.total_mass;
}

double OdeWorld::corner_stiffness(int sole) const noexcept {
  return config_.contact == ContactModel::kRigid ? kRigidStiffness
                                                  : commanded_.surface(sole).stiffness;
}

double OdeWorld::corner_damping(int sole, double force) const noexcept {
  if (config_.contact == ContactModel::kRigid) return 0.0;
  const ContactParams params = as_asked(config_, commanded_.surface(sole));
  return damping_at(params, force / params.stiffness);
}

long OdeWorld::engine_messages() noexcept {
  return engine_message_count.load(std::memory_order_relaxed);
}

}  // namespace twinbus::sim
