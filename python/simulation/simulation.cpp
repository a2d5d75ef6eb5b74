#include "python/simulation/simulation.h"

#include <cmath>
#include <stdexcept>

#include "launcher/run/fit_scene.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"
#include "sim/scene/settings.h"

namespace twinbus {

SceneAndRobot load(const SimulationConfig& config) {
  SceneAndRobot loaded;
  loaded.scene = load_scene(config.scene);
  Scene& scene = loaded.scene;
  if (!config.robot.empty()) scene.robot = config.robot;
  if (!config.engine.empty()) scene.engine = config.engine;
  Engine engine;
  if (!engine_of(scene.engine, engine))
    throw std::runtime_error("there is no engine '" + scene.engine + "'; use articulated, ode or mujoco");
  loaded.model = std::make_unique<Model>(load_robot(scene.robot));
  fit_scene(scene, *loaded.model);
  start_in(config.start_pose.empty() ? scene.start_pose : config.start_pose, *loaded.model, scene);
  SimSettings scratch;
  for (const auto& [key, value] : config.settings) {
    const std::string complaint = apply_setting(key, value, loaded.model->period(), scratch);
    if (!complaint.empty()) throw std::runtime_error(complaint);
  }
  return loaded;
}

void hold_posture(const Model& model, const RobotState& state, JointCommand& command) {
  command = JointCommand{};
  command.joint_count = state.joint_count;
  command.q = state.q;
  command.tau = state.tau;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
    command.kp[k] = static_cast<float>(joint.kp);
    command.kd[k] = static_cast<float>(joint.kd);
  }
}

void check_command(const Model& model, const JointCommand& command) {
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    const bool finite = std::isfinite(command.q[k]) && std::isfinite(command.qd[k]) && std::isfinite(command.tau[k]) &&
                        std::isfinite(command.kp[k]) && std::isfinite(command.kd[k]);
    if (finite && command.kp[k] >= 0.0F && command.kd[k] >= 0.0F) continue;
    throw std::invalid_argument("command of joint " + model.joints[static_cast<std::size_t>(model.bus_joints[k])].name +
                                (finite ? ": a gain below zero" : ": a number that is not finite"));
  }
}

Simulation::Simulation(const SimulationConfig& config) : config_(config), loaded_(load(config)) { reset(config.seed); }

void Simulation::reset(std::uint64_t seed) {
  Scene scene = loaded_.scene;
  apply_seed(scene, *loaded_.model, seed);
  OneProcessConfig config;
  config.settings = config_.settings;
  config.seed = seed;
  config.control.guard_in_loop = config_.guard;
  config.controller = config_.controller;
  process_ = std::make_unique<OneProcess>(*loaded_.model, scene, config);
  seed_ = seed;
  steps_ = 0;
  observe();
  hold_posture(*loaded_.model, state_, command_);
}

void Simulation::step(int ticks) {
  if (ticks < 1) throw std::invalid_argument("step: at least one tick");
  if (!config_.controller) check_command();
  for (int i = 0; i < ticks; ++i) {
    if (!config_.controller) {
      process_->own_command() = command_;
      process_->own_command().flags = config_.fade ? std::int16_t{0} : kCommandNoFade;
    }
    if (!process_->act()) throw std::runtime_error(process_->failure() + "; reset() begins anew");
    ++steps_;
    observe();
  }
}

void Simulation::observe() {
  if (!process_->observe()) throw std::runtime_error(process_->failure() + "; reset() begins anew");
  state_ = process_->state();
  truth_ = process_->truth();
  truth_.tick = state_.tick;
}

void Simulation::check_command() const { twinbus::check_command(*loaded_.model, command_); }

}  // namespace twinbus
