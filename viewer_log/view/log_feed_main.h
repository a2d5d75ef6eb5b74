// Decodes the events of a log for the library, which knows no messages.  For mains only.

#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/handler.h"
#include "lcmtypes/bus/wire.h"
#include "robot/description/model.h"
#include "viewer_log/log/log_marks.h"
#include "viewer_log/view/log_view.h"

namespace twinbus::inline viewer_log {

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
    for (const Row& row : kRows) {
      if (name == row.channel) row.pass(event, view, now);
    }
    return Kind::kOther;
  }

  void find_marks(const LogEvent& event, MarkFinder& finder) const {
    if (!event.channel.starts_with(prefix_)) return;
    const std::string_view name = event.channel.substr(prefix_.size());
    if (name == channel::kState) {
      pass<&MarkFinder::on_state>(event, finder, event.utime);
    } else if (name == channel::kEstimate) {
      pass<&MarkFinder::on_estimate>(event, finder, event.utime);
    } else if (name == channel::kGuard) {
      pass<&MarkFinder::on_guard>(event, finder, event.utime);
    } else if (name == channel::kSourceStatus) {
      pass<&MarkFinder::on_source_status>(event, finder, event.utime);
    } else if (name == channel::kEvent) {
      pass<&MarkFinder::on_event>(event, finder, event.utime);
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
  template <auto kMethod, class Owner>
  static void pass(const LogEvent& event, Owner& owner, std::int64_t now) {
    MessageOf<kMethod> message;
    if (read(event, message)) hand_over<kMethod>(message, owner, now);
  }

  // What the view is told of besides STATE, COMMAND and GUARD.
  struct Row {
    const char* channel;
    void (*pass)(const LogEvent& event, StackView& view, std::int64_t now);
  };
  static constexpr Row kRows[] = {
      {channel::kTruth, &pass<&StackView::on_truth>},
      {channel::kControllerStatus, &pass<&StackView::on_controller_status>},
      {channel::kStateSim, &pass<&StackView::on_standby_state>},
      {channel::kStateBridge, &pass<&StackView::on_standby_state>},
      {channel::kStateReplay, &pass<&StackView::on_standby_state>},
      {channel::kSourceStatus, &pass<&StackView::on_source_status>},
      {channel::kHeartbeat, &pass<&StackView::on_heartbeat>},
      {channel::kEvent, &pass<&StackView::on_event>},
      {channel::kObstacles, &pass<&StackView::on_obstacles>},
      {channel::kHeld, &pass<&StackView::on_held>},
      {channel::kTerrain, &pass<&StackView::on_terrain>},
      {channel::kLoose, &pass<&StackView::on_loose>},
      {channel::kFootsteps, &pass<&StackView::on_footsteps>},
      {channel::kCamera, &pass<&StackView::on_camera>},
      {channel::kArmPath, &pass<&StackView::on_arm_path>}};

  const Model* model_;
  std::string prefix_;
};

}  // namespace twinbus::viewer_log
