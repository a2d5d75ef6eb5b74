// Simulator and control loop tick by tick, with nothing between them: no source, no gate, no bus.

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "control/loop/control_loop.h"
#include "sim/scene/scene.h"
#include "sim/sim_adaptor.h"

namespace twinbus {

using Settings = std::vector<std::pair<std::string, std::string>>;

inline Scene flat_scene() {
  Scene scene;
  scene.name = "flat";
  return scene;
}

// For a tenth of a second; the sequence is the sender's.
inline WalkCommand walk_command(std::int64_t run_id, double vx, double vy, double wz) {
  return {.run_id = run_id,
          .vx = static_cast<float>(vx),
          .vy = static_cast<float>(vy),
          .wz = static_cast<float>(wz),
          .timeout = 0.1F};
}

// The worst of what only the simulator knows.
struct RigRecord {
  bool fell = false;
  double zmp_margin_min = std::numeric_limits<double>::infinity();  // [m]
  double sole_tilt_max = 0.0;                                       // [rad]
  double base_tilt_max = 0.0;                                       // [rad]
  double slip_max = 0.0;          // of a sole from where it stood first [m]
  double effort_share_max = 0.0;  // measured torque over limit
};

class SimRig {
 public:
  SimRig(const Model& model, const Scene& scene, const Settings& settings,
         const ControlConfig& config)
      : SimRig(model, model, scene, settings, config) {}
  // simulated: the robot as it is, model: as its controller knows it.
  SimRig(const Model& model, const Model& simulated, const Scene& scene, const Settings& settings,
         const ControlConfig& config)
      : model_(model), sim_(scene), loop_(model, config) {
    if (sim_.open(simulated, {settings}) != Status::kOk)
      throw std::runtime_error("the simulator does not open");
    state_.run_id = 7;
    state_.term = 1;
    state_.model_hash = model.hash;
    state_.period_ns = model.period_ns;
    state_.source = SourceKind::kSimulator;
    state_.role = Role::kActive;
    state_.joint_count = static_cast<std::int16_t>(model.bus_count());
  }

  // False when the simulation or the controller gave up.
  bool tick() {
    if (sim_.read(state_, 0.0) != Status::kOk) return false;
    state_.tick = ticks_;
    state_.time_ns = ticks_ * model_.period_ns;
    ++ticks_;
    loop_.on_state(state_, state_.time_ns);
    if (!loop_.step(state_.time_ns, command_)) return false;
    watch();
    return sim_.write(command_) == Status::kOk;
  }
  bool run(double seconds) {
    const auto n = static_cast<int>(std::lround(seconds / model_.period()));
    for (int i = 0; i < n; ++i) {
      if (!tick()) return false;
    }
    return true;
  }
  void ask(Mode mode, Motion motion = Motion::kNone, double amplitude = 0.0,
           double frequency = 0.0) {
    ModeRequest request;
    request.run_id = state_.run_id;
    request.sender_id = 11;
    request.sequence = ++sequence_;
    request.mode = mode;
    request.motion = motion;
    request.amplitude = static_cast<float>(amplitude);
    request.frequency = static_cast<float>(frequency);
    loop_.on_mode_request(request);
  }
  void forget() { record_ = {}; }

  ControlLoop& loop() { return loop_; }
  SimAdaptor& sim() { return sim_; }
  RobotState& state() { return state_; }
  const JointCommand& command() const { return command_; }
  const SimTruth& truth() const { return *sim_.truth(); }
  const RigRecord& record() const { return record_; }
  std::int64_t ticks() const { return ticks_; }

 private:
  static double tilt(double w, double x, double y, double z) {
    (void)w;
    (void)z;
    return std::acos(std::clamp(1.0 - 2.0 * (x * x + y * y), -1.0, 1.0));
  }
  void watch() {
    const SimTruth& t = *sim_.truth();
    RigRecord& r = record_;
    r.fell = r.fell || t.fell;
    if (t.contact_count > 0)
      r.zmp_margin_min = std::min(r.zmp_margin_min, static_cast<double>(t.zmp_margin));
    const auto& b = t.base_attitude;
    r.base_tilt_max = std::max(r.base_tilt_max, tilt(b[0], b[1], b[2], b[3]));
    for (std::size_t s = 0; s < 2; ++s) {
      const auto& a = t.foot_attitude[s];
      r.sole_tilt_max =
          std::max(r.sole_tilt_max, tilt(static_cast<double>(a[0]), static_cast<double>(a[1]),
                                         static_cast<double>(a[2]), static_cast<double>(a[3])));
      const double x = static_cast<double>(t.foot_position[s][0]);
      const double y = static_cast<double>(t.foot_position[s][1]);
      if (ticks_ == 1) first_[s] = {x, y};
      r.slip_max = std::max(r.slip_max, std::hypot(x - first_[s][0], y - first_[s][1]));
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(model_.bus_count()); ++k) {
      const double effort = model_.joints[static_cast<std::size_t>(model_.bus_joints[k])].effort;
      if (effort > 0.0) {
        r.effort_share_max =
            std::max(r.effort_share_max, std::abs(static_cast<double>(state_.tau[k])) / effort);
      }
    }
  }

  const Model& model_;
  SimAdaptor sim_;
  ControlLoop loop_;
  RobotState state_;
  JointCommand command_;
  std::int64_t ticks_ = 0;
  std::int32_t sequence_ = 0;
  std::array<std::array<double, 2>, 2> first_{};
  RigRecord record_;
};

}  // namespace twinbus
