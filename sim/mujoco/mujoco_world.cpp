#include "sim/mujoco/mujoco_world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/parallel/drive_torque.h"

namespace twinbus::inline sim {

namespace {

// How deep one point at rest is on MuJoCo's default contact, whatever its mass: (1 - d) g / (d k), with the impedance d = 0.9
// of a shallow contact and k = 1 / (0.95 * 0.02 s)^2.  Soles are about as deep; it is where a robot is put, not a law.
constexpr double kRestDepth = 0.1 * kGravity / 0.9 * (0.95 * 0.02) * (0.95 * 0.02);  // [m]
constexpr double kTimeConstant = 0.02;                                              // of that contact [s]
constexpr double kSoleCornersOfBoth = 2.0 * kSoleCorners;

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("engine mujoco " + what + "; say --engine articulated or --engine ode");
}

const WorldConfig& known(const Model& model, const WorldConfig& config) {
  if (config.contact != ContactModel::kSpringDamper && config.contact != ContactModel::kSoft)
    refuse(std::string("has its own soft contact, and no contact ") + kContactNames[static_cast<std::size_t>(config.contact)]);
  if (config.continuous) refuse("knows no contact.continuous");
  if (config.order != 1) refuse("knows no solver.order " + std::to_string(config.order));
  if (config.flight != Flight::kImplicit) refuse("knows no solver.flight");
  if (config.stiffness_scale != 1.0) refuse("knows no contact.stiffness_scale: its contacts have no stiffness of a sole");
  if (config.damping_scale != 1.0) refuse("knows no contact.damping_scale");
  if (config.ground_height[0] != 0.0 || config.ground_height[1] != 0.0) refuse("knows one ground for both soles only");
  if (!config.ties.empty()) refuse("knows no loops and no grasps");
  if (!config.robots.empty()) refuse("knows no further robots");
  for (const LooseBody& body : config.loose) {
    if (body.mesh != nullptr) refuse("knows no loose meshes (" + body.name + ")");
  }
  for (const Joint& joint : model.joints) {
    if (!(joint.effort >= 0.0))
      throw std::runtime_error("joint '" + joint.name + "' cannot be simulated: its effort limit must be a number");
  }
  check_links(model, config.fixed_base);
  return config;
}

constexpr double kReweigh = 1.25;  // once an armature has changed by this factor

}  // namespace

// Contacts are as hard as the bodies that they move are heavy, at the joints' present stiffness.
void MujocoWorld::weigh() noexcept {
  const double h = config_.step;
  const auto changed = [h](const MujocoServo& servo) {
    const double now = servo.armature(h);
    return servo.weighed < 0.0 || now > kReweigh * servo.weighed || kReweigh * now < servo.weighed;
  };
  if (std::none_of(servos_.begin(), servos_.end(), changed)) return;
  for (std::size_t j = 0; j < servos_.size(); ++j) {
    servos_[j].weighed = servos_[j].armature(h);
    armatures_.set(joints_[j].v, servos_[j].weighed);
  }
  (void)mujoco_.guarded([this] { mujoco_.set_const(simulated_, scratch_); });
}

// What multiplies the velocity of the end of the step is inertia, the rest a force.
void MujocoWorld::drive() noexcept {
  const double h = config_.step;
  for (std::size_t j = 0; j < servos_.size(); ++j) {
    const MujocoServo& servo = servos_[j];
    const ServoTarget& t = servo.target;
    const double q = start_qpos_[joints_[j].q], qd = start_qvel_[joints_[j].v];
    double force = -servo.damping * qd;
    if (servo.bounded) {
      force += servo.tau;
    } else if (!servo.follows) {
      force += t.kp * (t.q - q - servo.play) + t.kd * t.qd + t.tau - servo.gain(h) * qd;
    }
    armatures_.set(joints_[j].v, servo.bounded ? servo.rotor + h * servo.damping : servo.armature(h));
    forces_[joints_[j].v] = force;
  }
  mujoco_.set_state(simulated_, data_, forces_.data(), mujoco_.bits().qfrc_applied);
}

// The law itself at the end of the step.  True: a servo went beyond its limit, which from now on is its torque.
bool MujocoWorld::read_torques() noexcept {
  bool beyond = false;
  for (std::size_t j = 0; j < servos_.size(); ++j) {
    MujocoServo& servo = servos_[j];
    if (servo.follows || servo.bounded) continue;
    const ServoTarget& t = servo.target;
    const double q = start_qpos_[joints_[j].q], qd = qvel_[joints_[j].v];
    const double asked = t.kp * (t.q - q - servo.play) + t.kd * t.qd + t.tau - servo.gain(config_.step) * qd;
    servo.bounded = !(std::abs(asked) <= servo.limit);
    beyond = beyond || servo.bounded;
    servo.tau = std::clamp(asked, -servo.limit, servo.limit);
  }
  // Of joints that two motors turn over rods: what the motors give is both joints' torque of the step, by the speeds of its first pass.
  for (const ParallelJoints& pair : pairs_) {
    MujocoServo &first = servos_[at(pair.joints[0])], &second = servos_[at(pair.joints[1])];
    RodPosture posture;
    const Eigen::Vector2d q(start_qpos_[joints_[at(pair.joints[0])].q], start_qpos_[joints_[at(pair.joints[1])].q]);
    if (first.bounded || !pair.drive.at(q, posture)) continue;
    const LimitedTorque given = limit_at_motors(posture.jacobian, pair.drive.torque_limits(), {first.tau, second.tau});
    if (!given.limited) continue;
    first.tau = given.tau[0];
    second.tau = given.tau[1];
    first.bounded = second.bounded = beyond = true;
  }
  return beyond;
}

void MujocoWorld::apply_pushes() noexcept {
  if (pushes_.empty() && !pushed_) return;
  std::fill(xfrc_.begin(), xfrc_.end(), 0.0);
  for (const Push& push : pushes_) {
    double* to = &xfrc_[6 * at(bodies_[at(push.link)])];
    const Eigen::Vector3d torque = (push.point - kinematics_.com_of_link(push.link)).cross(push.force);
    for (int i = 0; i < 3; ++i) {
      to[i] += push.force[i];
      to[i + 3] += torque[i];
    }
  }
  pushed_ = !pushes_.empty();
  pushes_.clear();
  mujoco_.set_state(simulated_, data_, xfrc_.data(), mujoco_.bits().xfrc_applied);
}

MujocoWorld::MujocoWorld(const Model& model, const WorldConfig& config, Unloaded)
    : config_(known(model, config)),
      model_(changed_by(model, config)),
      kinematics_(model_),
      configuration_(model_),
      mujoco_(MujocoLibrary::get()) {}

MujocoWorld::MujocoWorld(const Model& model, const WorldConfig& config) : MujocoWorld(model, config, Unloaded{}) {
  load();
  for (std::size_t i = 0; i < config.loose.size(); ++i) (void)set_loose(static_cast<int>(i), config.loose[i].start);
  kinematics_.update(configuration_);
}

MujocoWorld::~MujocoWorld() {
  if (data_ != nullptr) mujoco_.delete_data(data_);
  if (scratch_ != nullptr) mujoco_.delete_data(scratch_);
  if (simulated_ != nullptr) mujoco_.delete_model(simulated_);
}

Status MujocoWorld::set(const Configuration& to, const Eigen::VectorXd* tau) noexcept {
  const Status status = check_configuration(joints_.size(), to);
  if (status != Status::kOk) return status;
  configuration_ = to;
  write_state();
  kinematics_.update(configuration_);
  const bool known = tau != nullptr && tau->size() == to.q.size();
  for (std::size_t j = 0; j < servos_.size(); ++j) {
    MujocoServo& servo = servos_[j];
    const double torque = known ? (*tau)[static_cast<Eigen::Index>(j)] : 0.0;
    servo.tau = std::isfinite(torque) ? std::clamp(torque, -servo.limit, servo.limit) : 0.0;
    servo.play = flank(servo);
    servo.bounded = false;
  }
  pushes_.clear();
  frozen_ = false;
  estimate_contact_forces();
  return Status::kOk;
}

Status MujocoWorld::set_servo(int joint, const ServoTarget& target) noexcept {
  if (joint < 0 || joint >= model_.joint_count()) return Status::kWrongSize;
  const Status status = check_target(target);
  if (status != Status::kOk) return status;
  ServoTarget& own = servos_[at(joint)].target;
  own = target;
  own.kp *= config_.servo_kp_scale;
  own.kd *= config_.servo_kd_scale;
  return Status::kOk;
}

Status MujocoWorld::push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept {
  if (link < 0 || link >= model_.link_count()) return Status::kWrongSize;
  if (!point.allFinite() || !force.allFinite()) return Status::kNotFinite;
  if (point.cwiseAbs().maxCoeff() > kMaxDistance || force.cwiseAbs().maxCoeff() > kMaxPush ||
      pushes_.size() == pushes_.capacity()) {
    return Status::kOutOfRange;
  }
  pushes_.push_back({link, point, force});
  return Status::kOk;
}


// With the torques that act, not the servos' next ones, but as stiff as the servos are.
void MujocoWorld::estimate_contact_forces() noexcept {
  weigh();
  for (std::size_t j = 0; j < servos_.size(); ++j) {
    const MujocoServo& servo = servos_[j];
    armatures_.set(joints_[j].v, servo.armature(config_.step));
    forces_[joints_[j].v] = servo.follows ? 0.0 : servo.tau;
  }
  mujoco_.set_state(simulated_, data_, forces_.data(), mujoco_.bits().qfrc_applied);
  contacts_.clear();
  if (mujoco_.guarded([this] { mujoco_.forward(simulated_, data_); })) read_contacts();
}

bool MujocoWorld::advance() noexcept {
  for (MujocoServo& servo : servos_) servo.bounded = false;
  for (;;) {  // joints only gain limits, so this ends
    drive();
    if (!mujoco_.guarded([this] { mujoco_.step(simulated_, data_); })) return false;
    read_state();
    if (!sane()) return false;
    if (!read_torques()) return true;
    go_back();
  }
}

void MujocoWorld::go_back() noexcept {
  mujoco_.set_state(simulated_, data_, start_qpos_.data(), mujoco_.bits().qpos);
  mujoco_.set_state(simulated_, data_, start_qvel_.data(), mujoco_.bits().qvel);
  mujoco_.set_state(simulated_, data_, start_warmstart_.data(), mujoco_.bits().warmstart);
}

Status MujocoWorld::step() noexcept {
  trust_ = {};
  if (frozen_) return Status::kDiverged;
  start_qpos_ = qpos_;  // of the same size: nothing is allocated
  start_qvel_ = qvel_;
  mujoco_.get_state(simulated_, data_, start_warmstart_.data(), mujoco_.bits().warmstart);
  apply_pushes();
  weigh();
  if (!advance()) {
    go_back();
    read_state();
    contacts_.clear();
    frozen_ = true;
    return Status::kDiverged;
  }
  read_contacts();
  kinematics_.update(configuration_);
  for (MujocoServo& servo : servos_) servo.play += kPlayRate * (flank(servo) - servo.play);
  return Status::kOk;
}


LooseState MujocoWorld::loose(int body) const noexcept {
  const Place& place = loose_[at(body)];
  LooseState state;
  state.pose = read_mujoco_pose(&qpos_[place.q]);
  const double* v = &qvel_[place.v];
  state.velocity = Eigen::Vector3d(v[0], v[1], v[2]);
  state.angular_velocity = state.pose.linear() * Eigen::Vector3d(v[3], v[4], v[5]);
  return state;
}

Status MujocoWorld::set_loose(int body, const LooseState& state) noexcept {
  if (body < 0 || at(body) >= loose_.size()) return Status::kWrongSize;
  const Status status = check_loose(state);
  if (status != Status::kOk) return status;
  const Place& place = loose_[at(body)];
  write_mujoco_pose(state.pose, &qpos_[place.q]);
  write_mujoco_velocity(state.pose.linear(), state.velocity, state.angular_velocity, &qvel_[place.v]);
  mujoco_.set_state(simulated_, data_, qpos_.data(), mujoco_.bits().qpos);
  mujoco_.set_state(simulated_, data_, qvel_.data(), mujoco_.bits().qvel);
  return Status::kOk;
}


double MujocoWorld::corner_stiffness(int) const noexcept { return mass() * kGravity / (kSoleCornersOfBoth * kRestDepth); }
// Critically damped, as the contact is: 2 / timeconst times the mass that it carries.
double MujocoWorld::corner_damping(int, double force) const noexcept {
  return 2.0 / kTimeConstant * std::max(0.0, force) / kGravity;
}

}  // namespace twinbus::sim
