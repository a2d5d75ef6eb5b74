// Decodes the events of a log for the library, which knows no messages.  For mains only.

#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/wire.h"
#include "robot/description/model.h"
#include "viewer_log/log/log_marks.h"
#include "viewer_log/view/log_view.h"

namespace twinbus {

class MessageFeed : public LogFeed {
 public:
  MessageFeed(const Model& model, std::string prefix)
      : model_(&model), prefix_(std::move(prefix)) {}

  Kind feed(const LogEvent& event, StackView& view, std::int64_t now) override {
    if (!event.channel.starts_with(prefix_)) return Kind::kOther;
    const std::string_view name = event.channel.substr(prefix_.size());
    if (name == channel::kState) {
      RobotState state;
      if (!read(event, state) || state.model_hash != model_->hash) return Kind::kOther;
      view.on_state(state, now);
      return Kind::kState;
    }
    if (name == channel::kCommand) {
      JointCommand command;
      if (!read(event, command)) return Kind::kOther;
      view.on_command(command, now);
      return Kind::kCommand;
    }
    if (name == channel::kGuard) {
      GuardReport report;
      if (!read(event, report)) return Kind::kOther;
      view.on_guard(report, now);
      return Kind::kGuard;
    }
    if (name == channel::kTruth) {
      pass<SimTruth>(event, [&](const SimTruth& m) { view.on_truth(m, now); });
    } else if (name == channel::kControllerStatus) {
      pass<ControllerStatus>(event,
                             [&](const ControllerStatus& m) { view.on_controller_status(m, now); });
    } else if (name == channel::kStateSim || name == channel::kStateBridge ||
               name == channel::kStateReplay) {
      pass<RobotState>(event, [&](const RobotState& m) { view.on_standby_state(m, now); });
    } else if (name == channel::kSourceStatus) {
      pass<SourceStatus>(event, [&](const SourceStatus& m) { view.on_source_status(m, now); });
    } else if (name == channel::kHeartbeat) {
      pass<Heartbeat>(event, [&](const Heartbeat& m) { view.on_heartbeat(m, now); });
    } else if (name == channel::kEvent) {
      pass<Event>(event, [&](const Event& m) { view.on_event(m); });
    } else if (name == channel::kObstacles) {
      pass<ObstaclesPiece>(event, [&](const ObstaclesPiece& m) { view.on_obstacles(m); });
    } else if (name == channel::kTerrain) {
      pass<ObstaclesPiece>(event, [&](const ObstaclesPiece& m) { view.on_terrain(m); });
    } else if (name == channel::kLoose) {
      pass<ObstaclesPiece>(event, [&](const ObstaclesPiece& m) { view.on_loose(m, now); });
    } else if (name == channel::kFootsteps) {
      pass<ObstaclesPiece>(event, [&](const ObstaclesPiece& m) { view.on_footsteps(m, now); });
    } else if (name == channel::kCamera) {
      pass<ModelTextPiece>(event, [&](const ModelTextPiece& m) { view.on_camera(m, now); });
    } else if (name == channel::kArmPath) {
      pass<ArmPathPiece>(event, [&](const ArmPathPiece& m) { view.on_arm_path(m); });
    }
    return Kind::kOther;
  }

  void find_marks(const LogEvent& event, MarkFinder& finder) const {
    if (!event.channel.starts_with(prefix_)) return;
    const std::string_view name = event.channel.substr(prefix_.size());
    if (name == channel::kState) {
      pass<RobotState>(event, [&](const RobotState& m) { finder.on_state(m, event.utime); });
    } else if (name == channel::kGuard) {
      pass<GuardReport>(event, [&](const GuardReport& m) { finder.on_guard(m, event.utime); });
    } else if (name == channel::kSourceStatus) {
      pass<SourceStatus>(event,
                         [&](const SourceStatus& m) { finder.on_source_status(m, event.utime); });
    } else if (name == channel::kEvent) {
      pass<Event>(event, [&](const Event& m) { finder.on_event(m, event.utime); });
    }
  }

  Kind kind_of(const LogEvent& event) const override {
    if (!event.channel.starts_with(prefix_)) return Kind::kOther;
    const std::string_view name = event.channel.substr(prefix_.size());
    if (name == channel::kState) return Kind::kState;
    if (name == channel::kCommand) return Kind::kCommand;
    if (name == channel::kGuard) return Kind::kGuard;
    const bool each_tick = name == channel::kTruth || name == channel::kEstimate || name == channel::kControllerStatus ||
                           name == channel::kStateSim || name == channel::kStateBridge ||
                           name == channel::kStateReplay;
    return each_tick ? Kind::kEachTick : Kind::kOther;
  }

 private:
  template <class T>
  static bool read(const LogEvent& event, T& message) {
    return decode(event.data, message) == Status::kOk;
  }
  template <class T, class Use>
  static void pass(const LogEvent& event, Use use) {
    T message;
    if (read(event, message)) use(message);
  }

  const Model* model_;
  std::string prefix_;
};

}  // namespace twinbus
