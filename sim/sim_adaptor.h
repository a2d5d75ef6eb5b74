// The simulator as a robot: section 3.2 of the OpenHRP paper calls it the emulation adaptor.

#pragma once

#include <memory>
#include <vector>

#include "bridge/adaptor/adaptor.h"
#include "sim/scene/scene.h"
#include "sim/step_watch.h"

namespace twinbus::inline sim {

class SimAdaptor final : public RobotAdaptor {
 public:
  explicit SimAdaptor(const Scene& scene);
  ~SimAdaptor() override;
  Status open(const Model&,
              const AdaptorConfig&) override;  // settings: see sim/README section of scene.h
  Status read(RobotState& state,
              double timeout_s) override;  // advances by one period, then measures
  Status write(const JointCommand& command) override;
  void close() override;
  Status fall_safe() override;
  bool can_be_set() const override { return true; }
  Status set_state(const ImposedState&) override;
  const SimTruth* truth() const override;
  int loose(int piece, ObstaclesPiece&) const override;
  bool held(int hand, ObstaclesPiece&) const override;
  const World* world() const;  // null: not open
  const WorldConfig& world_config() const;
  const StepWatch& watch() const;  // of the steps since open()
  void time_steps();               // from now on the CPU time of the world's steps is measured
  Status push(int link, const Eigen::Vector3d& force, const Eigen::Vector3d& point,
              double seconds) override;
  bool is_hardware() const override { return false; }

  // Worlds of robots alike in the lanes of one vector (sim/lanes/lane_worlds.h), up to four.
  // Their steps go together from now on: write() leaves the period that follows to advance_together(); read() without it takes it alone.
  // Throws std::runtime_error with what forbids it.
  static void share_lanes(const std::vector<SimAdaptor*>& sims);
  static void advance_together(const std::vector<SimAdaptor*>& sims) noexcept;
  static constexpr std::size_t kMostTogether = 4;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus::sim
