#include "sim/sim_adaptor_impl.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/process/process.h"
#include "sim/scene/fidelity.h"
#include "sim/scene_robots.h"
#include "sim/scene/scene_seed.h"
#include "sim/world/truth.h"
#include "sim/world/world_origin.h"
#include "sim/engine/make_world.h"

namespace twinbus::inline sim {

namespace {

constexpr double kMimicKp = 2000.0;  // holds a joint that follows another
constexpr double kOffsetDecay =
    1.0;  // corner offsets after set_state vanish with this time constant [s]
constexpr double kTouches = 0.02;      // share of the weight from which a measured foot stands
constexpr double kFallDamping = 0.03;  // fall_safe: kd per N m of effort limit [s/rad]

bool is_finite(const JointCommand& command, int count) noexcept {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (!std::isfinite(command.q[i]) || !std::isfinite(command.qd[i]) ||
        !std::isfinite(command.tau[i]) || !std::isfinite(command.kp[i]) ||
        !std::isfinite(command.kd[i])) {
      return false;
    }
    if (!(command.kp[i] >= 0.0F) || !(command.kd[i] >= 0.0F)) return false;
  }
  return true;
}

}  // namespace

// The posture the servos are to keep; where there is play it is the servo's side that counts.
void SimAdaptor::Impl::set_hold(const Configuration& at, const Eigen::VectorXd& torque) noexcept {
  for (int j = 0; j < model->joint_count(); ++j) {
    const Joint& joint = model->joints[static_cast<std::size_t>(j)];
    hold[static_cast<std::size_t>(j)] = {
        .q = world->encoder(j), .qd = at.qd[j], .tau = torque[j], .kp = joint.kp, .kd = joint.kd};
  }
}

void SimAdaptor::Impl::start() {
  const Eigen::VectorXd q = Configuration(*model, scene.start_pose).q;
  corner_stiffness = {world->corner_stiffness(0), world->corner_stiffness(1)};
  standing = stand(*model, q, settings.world.mass_scale, corner_stiffness,
                   settings.world.ground_height, settings.world.fixed_base);
  for (const auto& [name, speed] : scene.start_velocity) {
    const int joint = model->find_joint(name);
    if (joint < 0)
      throw std::runtime_error("scene " + scene.name + ": start_velocity: the robot " +
                               model->name + " has no joint '" + name + "'");
    standing.configuration.qd[joint] = speed;
  }
  kinematics.emplace(*model);
  kinematics->update(standing.configuration);
  standing_height = kinematics->com().z();
  standing.configuration.base.translation() += origin();
  hold.resize(model->joints.size());
  imposed_to = standing.configuration;
  imposed_tau = standing.tau;
  standing_mass = model->total_mass();
}

Status SimAdaptor::Impl::advance() noexcept {
  drive_servos();
  for (int i = 0; i < substeps; ++i) {
    begin_step();
    const Status status = watch->step(*world, step * static_cast<double>(steps + 1));
    if (status != Status::kOk) return status;
    end_step();
  }
  relax_corner_offsets();
  return Status::kOk;
}

void SimAdaptor::Impl::begin_step() noexcept {
  apply_pushes();
  live_pushes.apply(*world, step, truth,
                    [this](int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) {
                      watch->push(*world, link, point, force);
                    });
  // Half a step of slack, as for a push.
  if (scene_time >= 0.0) ties.update(scene_time + 0.5 * step, *world);
}

void SimAdaptor::Impl::end_step() noexcept {
  ++steps;
  if (scene_time >= 0.0) scene_time += step;
}

void SimAdaptor::Impl::drive_servos() noexcept {
  // The command of `delay` ticks ago, if there was one.
  if (writes > delay) {
    const auto slot = static_cast<std::size_t>((writes - 1 - delay) % kMaxDelay);
    if (line_used[slot]) {
      watch->driven_by(line[slot], command);
      command = line[slot];
      commanded = true;
    }
  }
  const bool obeys = commanded || fall;
  for (int k = 0; k < model->bus_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const int j = model->bus_joints[i];
    if (obeys) {
      ServoTarget target{.q = static_cast<double>(command.q[i]),
                         .qd = static_cast<double>(command.qd[i]),
                         .tau = static_cast<double>(command.tau[i]),
                         .kp = static_cast<double>(command.kp[i]),
                         .kd = static_cast<double>(command.kd[i])};
      if (fall) {
        target = {.q = 0.0,
                  .qd = 0.0,
                  .tau = 0.0,
                  .kp = 0.0,
                  .kd = kFallDamping * model->joints[static_cast<std::size_t>(j)].effort};
      }
      if (world->set_servo(j, target) == Status::kOk) continue;
    }
    (void)world->set_servo(j, hold[static_cast<std::size_t>(j)]);
  }
  const Configuration& now = world->configuration();
  for (int j = 0; j < model->joint_count(); ++j) {
    const Joint& joint = model->joints[static_cast<std::size_t>(j)];
    if (joint.mimic < 0) continue;
    (void)world->set_servo(j,
                           {.q = joint.mimic_multiplier * now.q[joint.mimic] + joint.mimic_offset,
                            .qd = joint.mimic_multiplier * now.qd[joint.mimic],
                            .tau = 0.0,
                            .kp = joint.kp > 0.0 ? joint.kp : kMimicKp,
                            .kd = joint.kp > 0.0 ? joint.kd : 0.02 * kMimicKp});
  }
}

void SimAdaptor::Impl::apply_pushes() noexcept {
  truth.push_force = {};
  truth.push_point = {};
  for (const ScenePush& p : pushes) {
    // Half a step of slack: the number of pushed steps must not depend on rounding.
    if (!(scene_time > p.push.at - 0.5 * step &&
          scene_time < p.push.at + p.push.duration - 0.5 * step))
      continue;
    const Eigen::Vector3d force = p.push.impulse / p.push.duration;
    const Eigen::Vector3d point = world->link_in_world(p.link) * p.push.point;
    (void)world->push(p.link, point, force);
    watch->push(*world, p.link, p.push.point, force);
    for (int i = 0; i < 3; ++i) {
      truth.push_force[static_cast<std::size_t>(i)] = static_cast<float>(force[i]);
      truth.push_point[static_cast<std::size_t>(i)] = static_cast<float>(point[i]);
    }
  }
}

void SimAdaptor::Impl::relax_corner_offsets() noexcept {
  const double keep = std::exp(-step * substeps / kOffsetDecay);
  for (int side = 0; side < 2; ++side) {
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      const double offset = world->corner_offset(side, corner);
      if (offset != 0.0)
        world->set_corner_offset(side, corner, std::abs(offset) > 1e-9 ? keep * offset : 0.0);
    }
  }
}

// Simulated seconds per real second, for people; nothing else here looks at a clock.
void SimAdaptor::Impl::time_pace() noexcept {
  const std::int64_t now_ns = monotonic_ns();
  if (now_ns - pace_since_ns < 500'000'000) return;
  const double simulated = step * static_cast<double>(steps - pace_steps);
  truth.realtime_factor =
      static_cast<float>(1e9 * simulated / static_cast<double>(now_ns - pace_since_ns));
  pace_since_ns = now_ns;
  pace_steps = steps;
}

SimAdaptor::SimAdaptor(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
SimAdaptor::~SimAdaptor() = default;

Status SimAdaptor::open(const Model& nominal, const AdaptorConfig& config) {
  Impl& s = *impl_;
  try {
    s.changed.reset();
    if (!s.scene.bodies.empty()) s.changed = changed_model(nominal, s.scene);
    const Model& model = s.changed ? *s.changed : nominal;
    s.model = &model;
    s.settings = SimSettings{};
    if (!engine_of(s.scene.engine, s.settings.world.engine)) {
      throw std::runtime_error("scene " + s.scene.name + ": there is no engine '" + s.scene.engine +
                               "'; use articulated, ode or mujoco");
    }
    (void)contact_of(s.scene.contact, s.settings.world.contact);
    s.settings.world.ground_friction = s.scene.ground_friction;
    s.settings.world.obstacles = s.scene.obstacles;
    s.settings.world.tiles = s.scene.tiles;
    s.settings.world.loose = s.scene.loose;
    s.settings.world.robots = robots_of(s.scene);
    apply_fidelity(s.scene, model, s.settings.world);
    s.settings.world.self_contact = s.scene.self_contact;
    s.settings.world.asleep = s.scene.asleep;
    if (s.scene.accuracy > 0.0) s.settings.world.accuracy = s.scene.accuracy;
    s.settings.world.bands = s.scene.bands;
    s.settings.world.fixed_base = s.scene.fixed_base || !model.floating_base;
    apply_settings(s.scene.settings, model.period(), s.settings);
    apply_settings(config.settings, model.period(), s.settings);
    s.substeps = s.scene.step > 0.0
                     ? std::max(1, static_cast<int>(std::lround(model.period() / s.scene.step)))
                     : 1;
    s.step = model.period() / s.substeps;
    s.settings.world.step = s.step;
    s.delay =
        std::clamp(static_cast<int>(std::lround(1e-3 * s.settings.servo_delay_ms / model.period())),
                   0, kMaxDelay - 1);
    if (s.scene.start_pose != "zero" && model.find_pose(s.scene.start_pose) < 0 &&
        !s.scene.start_pose.empty()) {
      throw std::runtime_error("scene " + s.scene.name + ": the robot " + model.name +
                               " has no pose '" + s.scene.start_pose +
                               "'; name one of its SRDF group_states as start_pose");
    }
    s.pushes.clear();
    for (const Push& push : s.scene.pushes) {
      const int link = model.find_link(push.link);
      if (link < 0) {
        throw std::runtime_error("scene " + s.scene.name + ": push: the robot " + model.name +
                                 " has no moving link '" + push.link + "'");
      }
      s.pushes.push_back({link, push});
    }
    s.ties = SceneTies(model, s.settings.world.robots, s.scene);
    s.settings.world.ties = s.ties.ties();
    move_everything(s.origin(), s.settings.world);
    s.lanes.reset();
    s.own_world = make_world(model, s.settings.world);
    s.world = s.own_world.get();
    s.loose = LoosePieces(s.settings.world);
    s.sensors.emplace(model, s.settings.sensors);
    s.start();
    s.commanded = s.fall = false;
    s.first_read = true;
    s.ahead = false;
    s.writes = s.steps = 0;
    s.scene_time = -1.0;
    s.line_used.fill(false);
    s.truth = SimTruth{};
    const Status placed = s.world->set(s.standing.configuration, &s.standing.tau);
    s.set_hold(s.standing.configuration, s.standing.tau);
    s.watch.emplace(model, s.settings.world, s.pushes.size() + LivePushes::kMost);
    s.watch->begin(*s.world);
    return placed;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "simulator: %s\n", error.what());
    s.world = nullptr;
    return Status::kOutOfRange;
  }
}

Status SimAdaptor::read(RobotState& state, double) {
  Impl& s = *impl_;
  if (!s.world) return Status::kNotOpen;
  Status status = Status::kOk;
  if (s.first_read) {
    s.first_read = false;  // the start pose itself is the first measurement
  } else {
    status = s.ahead ? s.ahead_status : s.advance();
    s.ahead = false;
  }
  const PartScope part("sensors and TRUTH");
  s.sensors->measure(*s.world, s.step, state);
  state.enabled =
      s.model->bus_count() == 0
          ? 0
          : static_cast<std::int64_t>((~std::uint64_t{0}) >> (64 - s.model->bus_count()));
  if (s.fall) state.enabled = 0;
  state.source_time_ns = std::llround(1e9 * s.step * static_cast<double>(s.steps));
  s.truth.sim_time = s.step * static_cast<double>(s.steps);
  fill_truth(*s.model, s.sensors->feet(), *s.world, s.standing_height, s.truth);
  fill_doubts(s.watch->counts(), s.truth);
  s.time_pace();
  return status;
}

Status SimAdaptor::push(int link, const Eigen::Vector3d& force, const Eigen::Vector3d& point,
                        double seconds) {
  if (!impl_->world) return Status::kNotOpen;
  return impl_->live_pushes.add(*impl_->model, link, force, point, seconds);
}

Status SimAdaptor::write(const JointCommand& command) {
  Impl& s = *impl_;
  if (!s.world) return Status::kNotOpen;
  if (command.joint_count != s.model->bus_count()) return Status::kWrongSize;
  if (!is_finite(command, command.joint_count)) return Status::kNotFinite;
  const auto slot = static_cast<std::size_t>(s.writes % kMaxDelay);
  s.line[slot] = command;
  s.line_used[slot] = true;
  ++s.writes;
  if (s.scene_time < 0.0) s.scene_time = 0.0;
  // The command of this period is known: what follows is computed now and not when the next tick is
  // due, so that a measurement is published the moment it is due.
  if (!s.first_read && !s.ahead && !s.lanes) {
    s.ahead_status = s.advance();
    s.ahead = true;
  }
  return Status::kOk;
}

void SimAdaptor::close() {
  impl_->world = nullptr;
  impl_->own_world.reset();
  impl_->lanes.reset();
  impl_->sensors.reset();
}

Status SimAdaptor::fall_safe() {
  if (!impl_->world) return Status::kNotOpen;
  impl_->fall = true;  // all joints damp; the knees bend by themselves
  return Status::kOk;
}

// Normal forces at the corners that continue those of the source.  False if a number is not finite.
bool SimAdaptor::Impl::imposed_corner_forces(
    const ImposedState& imposed, std::array<std::array<double, 4>, 2>& force) const noexcept {
  force = standing.corner_force;
  if (!imposed.forces_known) return true;
  for (std::size_t side = 0; side < 2; ++side) {
    force[side].fill(0.0);
    const Sole& sole = model->soles[side];
    if (sole.link < 0) continue;
    Eigen::Matrix<double, 6, 1> wrench;
    for (int i = 0; i < 6; ++i)
      wrench[i] = static_cast<double>(imposed.foot_wrench[side][static_cast<std::size_t>(i)]);
    if (!wrench.allFinite()) return false;
    const Eigen::Isometry3d sensor = sole.frame.inverse() * sole.sensor;
    const Eigen::Vector3d f = sensor.linear() * wrench.head<3>();
    const Eigen::Vector3d t = sensor.linear() * wrench.tail<3>() + sensor.translation().cross(f);
    // Less is the noise of a foot in the air, which would pull the body down to the ground.
    if (f.z() > kTouches * kGravity * settings.world.mass_scale * standing_mass)
      force[side] = corner_forces(sole, f.z(), t.x(), t.y());
  }
  return true;
}

// What the fit of the base leaves (the ground of the other source is not ours) is put into the
// ground below each corner, and vanishes slowly.
void SimAdaptor::Impl::continue_corner_forces(
    const std::array<std::array<double, 4>, 2>& force) noexcept {
  for (int side = 0; side < 2; ++side) {
    const auto at = static_cast<std::size_t>(side);
    const Sole& sole = model->soles[at];
    if (sole.link < 0) continue;
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      const Eigen::Vector3d point =
          world->link_in_world(sole.link) * (sole.frame * sole_corner(sole, corner));
      const double wanted = force[at][static_cast<std::size_t>(corner)];
      const double speed = world->point_velocity(sole.link, point).z();
      const double depth =
          (wanted + world->corner_damping(side, wanted) * speed) / corner_stiffness[at];
      const double now = settings.world.ground_height[at] - point.z();
      // A corner that is to carry nothing is only kept from pressing.
      if (wanted > 0.0 || now > 0.0)
        world->set_corner_offset(side, corner, now - (wanted > 0.0 ? depth : 0.0));
    }
  }
}

Status SimAdaptor::set_state(const ImposedState& imposed) {
  Impl& s = *impl_;
  if (!s.world) return Status::kNotOpen;
  const Model& model = *s.model;
  Configuration& to = s.imposed_to;
  Eigen::VectorXd& tau = s.imposed_tau;
  to = s.world->configuration();
  tau = s.standing.tau;
  if (!s.settings.world.fixed_base) {
    to.base = imposed.base;
    to.base_velocity = imposed.base_velocity;
    to.base_angular_velocity = imposed.base_angular_velocity;
  }
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    to.q[model.bus_joints[i]] = imposed.q[i];
    to.qd[model.bus_joints[i]] = imposed.qd[i];
    if (imposed.forces_known) tau[model.bus_joints[i]] = static_cast<double>(imposed.tau[i]);
  }
  set_mimics(model, to);
  std::array<std::array<double, 4>, 2> force;
  if (!to.base.matrix().allFinite() || !to.q.allFinite() || !tau.allFinite() ||
      !s.imposed_corner_forces(imposed, force)) {
    return Status::kNotFinite;
  }
  // Depth of the soles is tenths of a millimetre, less than any estimate knows: it follows from the
  // forces.
  if (!s.settings.world.fixed_base) {
    fit_base_to_corner_forces(model, force, s.corner_stiffness, s.settings.world.ground_height,
                              *s.kinematics, to);
  }
  const Status status = s.world->set(to, &tau);
  if (status != Status::kOk) return status;
  if (!s.settings.world.fixed_base) s.continue_corner_forces(force);
  s.world->estimate_contact_forces();
  s.watch->begin(*s.world);
  s.set_hold(to, tau);
  s.commanded = s.fall = false;
  s.writes = 0;
  s.line_used.fill(false);
  s.sensors->forget();
  RobotState scratch;
  s.sensors->measure(*s.world, 0.0,
                     scratch);  // so that the next acceleration is that of the step to come
  s.first_read = s.ahead = false;
  return Status::kOk;
}

const StepWatch& SimAdaptor::watch() const { return *impl_->watch; }
void SimAdaptor::time_steps() { impl_->watch->time_steps(); }
const WorldConfig& SimAdaptor::world_config() const { return impl_->settings.world; }
const World* SimAdaptor::world() const { return impl_->world; }

int SimAdaptor::loose(int piece, ObstaclesPiece& out) const {
  return impl_->world ? impl_->loose.fill(*impl_->world, piece, out) : 0;
}

bool SimAdaptor::held(int hand, ObstaclesPiece& out) const {
  return impl_->world && impl_->ties.held(hand, impl_->loose, out);
}

const SimTruth* SimAdaptor::truth() const { return impl_->world ? &impl_->truth : nullptr; }

}  // namespace twinbus::sim
