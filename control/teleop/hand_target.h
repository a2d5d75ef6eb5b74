// Where an operator wants a hand: moved by steps, and turned into one goal for the planner after the other.
//
// A goal is a place, and the planner finds a way that touches nothing; so a stick that is held moves the hand in short
// ways, each of which is gone to its end before the next is asked for.  A place that cannot be reached moves nothing: the
// wish falls back to where the hand was sent last.  How the hand is turned is left to the planner until somebody turns it; from
// then on it keeps that, until it is stopped or another hand is chosen.  Pure: neither bus nor clock.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline control {

class HandTarget {
 public:
  enum class Phase { kIdle, kAsked, kGoing, kRefused };

  // Another hand: the old one stops where it is.
  void choose(ArmSide side) noexcept;
  // by: forward, left, up [m]; turn: about these axes, through the hand [rad]; hand: where the hand is, where a wish begins.  All
  // in the ground frame.
  void move(const Eigen::Vector3d& by, const Eigen::Vector3d& turn, const Eigen::Isometry3d& hand) noexcept;
  // Whoever let go, or asked for it: the hand stops on its way.
  void stop() noexcept;

  // Every answer on ARM_PATH, every CONTROLLER_STATUS; those that are not of our goal do nothing.
  void on_path(const ArmPathPiece& piece) noexcept;
  void on_status(const ControllerStatus& status) noexcept;

  // What to send now, if anything: a new goal, or the last one once more.  new_id: random, for a new goal.
  [[nodiscard]] bool next(std::int64_t now_ns, std::int64_t run_id, std::int64_t new_id,
                          ArmGoal& goal) noexcept;

  Phase phase() const noexcept { return phase_; }
  ArmPathStatus refusal() const noexcept { return refusal_; }
  bool unanswered() const noexcept { return unanswered_; }  // the refusal is that nobody answered
  // Of a refusal because of two links: the two.
  std::array<int, 2> touching() const noexcept { return touching_; }
  double miss() const noexcept { return miss_; }            // of one that is out of reach [m]
  bool oriented() const noexcept { return oriented_; }      // the goal that was refused said how the hand is turned
  ArmSide side() const noexcept { return side_; }
  const Eigen::Vector3d& wanted() const noexcept { return wanted_; }

 private:
  void finish(Phase phase, std::int64_t now_ns) noexcept;

  ArmSide side_ = ArmSide::kLeft;
  Phase phase_ = Phase::kIdle;
  ArmPathStatus refusal_ = ArmPathStatus::kOk;
  bool begun_ = false;    // wanted_ and asked_ mean something
  bool arrived_ = false;  // to be noticed with the next now_ns
  bool moving_ = false;   // the controller follows our path
  bool turned_ = false;   // the hand keeps a turn
  bool turn_reached_ = false, unanswered_ = false;
  Eigen::Vector3d wanted_ = Eigen::Vector3d::Zero(), asked_ = Eigen::Vector3d::Zero(),
                  reached_ = Eigen::Vector3d::Zero();
  Eigen::Quaterniond wanted_turn_ = Eigen::Quaterniond::Identity(), asked_turn_ = wanted_turn_, reached_turn_ = wanted_turn_;
  std::array<int, 2> touching_{};
  double miss_ = 0.0;
  bool oriented_ = false;
  std::int64_t goal_id_ = 0, path_id_ = 0;
  std::int64_t asked_ns_ = 0, sent_ns_ = 0, idle_ns_ = 0, now_ns_ = 0;
  std::int32_t sequence_ = 0;
  int cancels_left_ = 0;
};

}  // namespace twinbus::control
