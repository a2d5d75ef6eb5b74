// What a SimAdaptor is made of, for sim/sim_adaptor.cpp and sim/adaptor_lanes.cpp.

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "sim/lanes/lane_worlds.h"
#include "sim/live_pushes.h"
#include "sim/scene/rigid_object_pieces.h"
#include "sim/scene/scene_ties.h"
#include "sim/scene/sensors.h"
#include "sim/scene/settings.h"
#include "sim/sim_adaptor.h"
#include "sim/world/static_equilibrium.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

inline constexpr int kMaxDelay = 64;  // ticks of servo delay

struct SimAdaptor::Impl {
  explicit Impl(const Scene& s) : scene(s) {}

  Scene scene;
  LoosePieces loose;
  SceneTies ties;
  const Model* model = nullptr;
  std::optional<Model> changed;  // the robot that is simulated, where the scene changes its bodies
  SimSettings settings;
  std::unique_ptr<World> own_world;
  std::shared_ptr<LaneWorlds> lanes;  // or a world among these, number `lane`
  int lane = 0;
  World* world = nullptr;  // of the two; null: not open
  std::optional<Sensors> sensors;
  Standing standing;
  std::array<double, 2> corner_stiffness{};
  double standing_height = 0.0;
  double standing_mass = 0.0;  // of the nominal robot [kg]
  int substeps = 1;
  double step = 0.0;

  std::vector<ServoTarget> hold;  // in force before the first command and after set_state
  bool commanded = false;
  std::array<JointCommand, kMaxDelay> line;  // commands on their way to the servo
  std::array<bool, kMaxDelay> line_used{};
  int delay = 0;
  std::int64_t writes = 0;
  JointCommand command;  // in force
  bool fall = false;

  bool first_read = true;
  bool ahead = false;  // write() has computed the period that the next read() measures
  Status ahead_status = Status::kOk;
  std::int64_t steps = 0;
  std::optional<StepWatch> watch;
  double scene_time = -1.0;  // [s] since the first command; pushes go by it
  struct ScenePush {
    int link;
    Push push;
  };
  std::vector<ScenePush> pushes;
  LivePushes live_pushes;
  SimTruth truth;
  Configuration imposed_to;  // scratch of set_state
  Eigen::VectorXd imposed_tau;
  std::optional<Kinematics> kinematics;
  std::int64_t pace_since_ns = 0;  // of realtime_factor
  std::int64_t pace_steps = 0;

  void set_hold(const Configuration& at, const Eigen::VectorXd& tau) noexcept;
  void continue_corner_forces(const std::array<std::array<double, 4>, 2>& force) noexcept;
  bool imposed_corner_forces(const ImposedState& imposed,
                             std::array<std::array<double, 4>, 2>& force) const noexcept;
  void time_pace() noexcept;
  Eigen::Vector3d origin() const { return {scene.origin.x(), scene.origin.y(), 0.0}; }
  void start();
  void drive_servos() noexcept;
  void apply_pushes() noexcept;
  void begin_step() noexcept;
  void end_step() noexcept;
  void relax_corner_offsets() noexcept;
  Status advance() noexcept;
};

}  // namespace twinbus::sim
