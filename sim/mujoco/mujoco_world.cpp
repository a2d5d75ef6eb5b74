#include "sim/mujoco/mujoco_world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/mujoco/mujoco_impl.h"

namespace twinbus {

namespace {

// How deep one point at rest is on MuJoCo's default contact, whatever its mass: (1 - d) g / (d k), with the impedance d = 0.9
// of a shallow contact and k = 1 / (0.95 * 0.02 s)^2.  Soles are about as deep; it is where a robot is put, not a law.
constexpr double kRestDepth = 0.1 * kGravity / 0.9 * (0.95 * 0.02) * (0.95 * 0.02);  // [m]
constexpr double kTimeConstant = 0.02;                                              // of that contact [s]
constexpr double kSoleCornersOfBoth = 2.0 * kSoleCorners;

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("engine mujoco " + what + "; say --engine articulated or --engine ode");
}

void check_known(const Model& model, const WorldConfig& config) {
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
}

constexpr double kReweigh = 1.25;  // once an armature has changed by this factor

}  // namespace

// Contacts are as hard as the bodies that they move are heavy, at the joints' present stiffness.
void MujocoWorld::Impl::weigh() noexcept {
  const double h = config.step;
  const auto changed = [h](const MujocoServo& servo) {
    const double now = servo.armature(h);
    return servo.weighed < 0.0 || now > kReweigh * servo.weighed || kReweigh * now < servo.weighed;
  };
  if (std::none_of(servos.begin(), servos.end(), changed)) return;
  for (std::size_t j = 0; j < servos.size(); ++j) {
    servos[j].weighed = servos[j].armature(h);
    armatures.set(joints[j].v, servos[j].weighed);
  }
  (void)mujoco.guarded([this] { mujoco.set_const(simulated, scratch); });
}

// What multiplies the velocity of the end of the step is inertia, the rest a force.
void MujocoWorld::Impl::drive() noexcept {
  const double h = config.step;
  for (std::size_t j = 0; j < servos.size(); ++j) {
    const MujocoServo& servo = servos[j];
    const ServoTarget& t = servo.target;
    const double q = start_qpos[joints[j].q], qd = start_qvel[joints[j].v];
    double force = -servo.damping * qd;
    if (servo.bounded) {
      force += servo.tau;
    } else if (!servo.follows) {
      force += t.kp * (t.q - q - servo.play) + t.kd * t.qd + t.tau - servo.gain(h) * qd;
    }
    armatures.set(joints[j].v, servo.bounded ? servo.rotor + h * servo.damping : servo.armature(h));
    forces[joints[j].v] = force;
  }
  mujoco.set_state(simulated, data, forces.data(), mujoco.bits().qfrc_applied);
}

// The law itself at the end of the step.  True: a servo went beyond its limit, which from now on is its torque.
bool MujocoWorld::Impl::read_torques() noexcept {
  bool beyond = false;
  for (std::size_t j = 0; j < servos.size(); ++j) {
    MujocoServo& servo = servos[j];
    if (servo.follows || servo.bounded) continue;
    const ServoTarget& t = servo.target;
    const double qd = qvel[joints[j].v];
    const double asked = t.kp * (t.q - start_qpos[joints[j].q] - servo.play) + t.kd * t.qd + t.tau - servo.gain(config.step) * qd;
    servo.bounded = !(std::abs(asked) <= servo.limit);
    beyond = beyond || servo.bounded;
    servo.tau = std::clamp(asked, -servo.limit, servo.limit);
  }
  return beyond;
}

void MujocoWorld::Impl::apply_pushes() noexcept {
  if (pushes.empty() && !pushed) return;
  std::fill(xfrc.begin(), xfrc.end(), 0.0);
  for (const Push& push : pushes) {
    double* to = &xfrc[6 * at(bodies[at(push.link)])];
    const Eigen::Vector3d torque = (push.point - kinematics.com_of_link(push.link)).cross(push.force);
    for (int i = 0; i < 3; ++i) {
      to[i] += push.force[i];
      to[i + 3] += torque[i];
    }
  }
  pushed = !pushes.empty();
  pushes.clear();
  mujoco.set_state(simulated, data, xfrc.data(), mujoco.bits().xfrc_applied);
}

MujocoWorld::MujocoWorld(const Model& model, const WorldConfig& config) {
  check_known(model, config);
  check_links(model, config.fixed_base);
  impl_ = std::make_unique<Impl>(model, config);
  impl_->load();
  for (std::size_t i = 0; i < config.loose.size(); ++i) (void)set_loose(static_cast<int>(i), config.loose[i].start);
  impl_->kinematics.update(impl_->configuration);
}
MujocoWorld::~MujocoWorld() = default;

Status MujocoWorld::set(const Configuration& to, const Eigen::VectorXd* tau) noexcept {
  Impl& w = *impl_;
  const Status status = check_configuration(w.joints.size(), to);
  if (status != Status::kOk) return status;
  w.configuration = to;
  w.write_state();
  w.kinematics.update(w.configuration);
  const bool known = tau != nullptr && tau->size() == to.q.size();
  for (std::size_t j = 0; j < w.servos.size(); ++j) {
    MujocoServo& servo = w.servos[j];
    const double torque = known ? (*tau)[static_cast<Eigen::Index>(j)] : 0.0;
    servo.tau = std::isfinite(torque) ? std::clamp(torque, -servo.limit, servo.limit) : 0.0;
    servo.play = w.flank(servo);
    servo.bounded = false;
  }
  w.pushes.clear();
  w.frozen = false;
  estimate_contact_forces();
  return Status::kOk;
}

Status MujocoWorld::set_servo(int joint, const ServoTarget& target) noexcept {
  Impl& w = *impl_;
  if (joint < 0 || joint >= w.model.joint_count()) return Status::kWrongSize;
  const Status status = check_target(target);
  if (status != Status::kOk) return status;
  ServoTarget& own = w.servos[at(joint)].target;
  own = target;
  own.kp *= w.config.servo_kp_scale;
  own.kd *= w.config.servo_kd_scale;
  return Status::kOk;
}

Status MujocoWorld::push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept {
  Impl& w = *impl_;
  if (link < 0 || link >= w.model.link_count()) return Status::kWrongSize;
  if (!point.allFinite() || !force.allFinite()) return Status::kNotFinite;
  if (point.cwiseAbs().maxCoeff() > kMaxDistance || force.cwiseAbs().maxCoeff() > kMaxPush ||
      w.pushes.size() == w.pushes.capacity()) {
    return Status::kOutOfRange;
  }
  w.pushes.push_back({link, point, force});
  return Status::kOk;
}

void MujocoWorld::set_corner_offset(int, int, double) noexcept {}
double MujocoWorld::corner_offset(int, int) const noexcept { return 0.0; }

// With the torques that act, not the servos' next ones, but as stiff as the servos are.
void MujocoWorld::estimate_contact_forces() noexcept {
  Impl& w = *impl_;
  w.weigh();
  for (std::size_t j = 0; j < w.servos.size(); ++j) {
    const MujocoServo& servo = w.servos[j];
    w.armatures.set(w.joints[j].v, servo.armature(w.config.step));
    w.forces[w.joints[j].v] = servo.follows ? 0.0 : servo.tau;
  }
  w.mujoco.set_state(w.simulated, w.data, w.forces.data(), w.mujoco.bits().qfrc_applied);
  w.contacts.clear();
  if (w.mujoco.guarded([&w] { w.mujoco.forward(w.simulated, w.data); })) w.read_contacts();
}

bool MujocoWorld::Impl::advance() noexcept {
  for (MujocoServo& servo : servos) servo.bounded = false;
  for (;;) {  // joints only gain limits, so this ends
    drive();
    if (!mujoco.guarded([this] { mujoco.step(simulated, data); })) return false;
    read_state();
    if (!sane()) return false;
    if (!read_torques()) return true;
    go_back();
  }
}

void MujocoWorld::Impl::go_back() noexcept {
  mujoco.set_state(simulated, data, start_qpos.data(), mujoco.bits().qpos);
  mujoco.set_state(simulated, data, start_qvel.data(), mujoco.bits().qvel);
  mujoco.set_state(simulated, data, start_warmstart.data(), mujoco.bits().warmstart);
}

Status MujocoWorld::step() noexcept {
  Impl& w = *impl_;
  trust_ = {};
  if (w.frozen) return Status::kDiverged;
  w.start_qpos = w.qpos;  // of the same size: nothing is allocated
  w.start_qvel = w.qvel;
  w.mujoco.get_state(w.simulated, w.data, w.start_warmstart.data(), w.mujoco.bits().warmstart);
  w.apply_pushes();
  w.weigh();
  if (!w.advance()) {
    w.go_back();
    w.read_state();
    w.contacts.clear();
    w.frozen = true;
    return Status::kDiverged;
  }
  w.read_contacts();
  w.kinematics.update(w.configuration);
  for (MujocoServo& servo : w.servos) servo.play += kPlayRate * (w.flank(servo) - servo.play);
  return Status::kOk;
}

const Configuration& MujocoWorld::configuration() const noexcept { return impl_->configuration; }
double MujocoWorld::encoder(int joint) const noexcept { return impl_->configuration.q[joint] + impl_->servos[at(joint)].play; }
double MujocoWorld::tau(int joint) const noexcept { return impl_->servos[at(joint)].tau; }
Eigen::Isometry3d MujocoWorld::link_in_world(int link) const noexcept { return impl_->kinematics.link_in_world(link); }
Eigen::Vector3d MujocoWorld::point_velocity(int link, const Eigen::Vector3d& point) const noexcept {
  return impl_->kinematics.point_velocity(link, point);
}
Eigen::Vector3d MujocoWorld::angular_velocity(int link) const noexcept { return impl_->kinematics.angular_velocity(link); }
double MujocoWorld::mass() const noexcept { return impl_->kinematics.mass(); }
Eigen::Vector3d MujocoWorld::com() const noexcept { return impl_->kinematics.com(); }
Eigen::Vector3d MujocoWorld::com_velocity() const noexcept { return impl_->kinematics.com_velocity(); }
const std::vector<ContactPoint>& MujocoWorld::contacts() const noexcept { return impl_->contacts; }
int MujocoWorld::loose_count() const noexcept { return static_cast<int>(impl_->loose.size()); }

LooseState MujocoWorld::loose(int body) const noexcept {
  const Impl& w = *impl_;
  const Impl::Place& place = w.loose[at(body)];
  LooseState state;
  state.pose = read_mujoco_pose(&w.qpos[place.q]);
  const double* v = &w.qvel[place.v];
  state.velocity = Eigen::Vector3d(v[0], v[1], v[2]);
  state.angular_velocity = state.pose.linear() * Eigen::Vector3d(v[3], v[4], v[5]);
  return state;
}

Status MujocoWorld::set_loose(int body, const LooseState& state) noexcept {
  Impl& w = *impl_;
  if (body < 0 || at(body) >= w.loose.size()) return Status::kWrongSize;
  const Status status = check_loose(state);
  if (status != Status::kOk) return status;
  const Impl::Place& place = w.loose[at(body)];
  write_mujoco_pose(state.pose, &w.qpos[place.q]);
  write_mujoco_velocity(state.pose.linear(), state.velocity, state.angular_velocity, &w.qvel[place.v]);
  w.mujoco.set_state(w.simulated, w.data, w.qpos.data(), w.mujoco.bits().qpos);
  w.mujoco.set_state(w.simulated, w.data, w.qvel.data(), w.mujoco.bits().qvel);
  return Status::kOk;
}

Eigen::Isometry3d MujocoWorld::robot_link(int, int) const noexcept { return Eigen::Isometry3d::Identity(); }
Status MujocoWorld::hold(int, bool) noexcept { return Status::kWrongSize; }

double MujocoWorld::corner_stiffness(int) const noexcept { return mass() * kGravity / (kSoleCornersOfBoth * kRestDepth); }
// Critically damped, as the contact is: 2 / timeconst times the mass that it carries.
double MujocoWorld::corner_damping(int, double force) const noexcept {
  return 2.0 / kTimeConstant * std::max(0.0, force) / kGravity;
}
double MujocoWorld::elastic_energy() const noexcept { return impl_->elastic; }

}  // namespace twinbus
