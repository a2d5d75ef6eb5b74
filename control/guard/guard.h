// Self-collision and obstacle guard: looks at one state and the command that answers it, and names
// the joints that must be braked so that nothing touches.
//
// Once per tick it asks: if the command is obeyed for the ticks that a mask needs to arrive, and
// everything is braked after that, does anything come nearer than the margin?  It asks the same of a
// brake that begins now, as commands may change at once, and of joints that are still held and stay so
// while others go on.  If so, the arm and waist joints that bring the pair together are masked; joints
// that take it apart never are, so a robot that was started in collision, or was stopped in front of
// one, can always be moved out.  Ways are proved as a whole (robot/swept_shapes): between the places
// looked at nothing comes nearer than half the margin, or half of what is left of it; what cannot be
// proved in a tick is answered like a danger.
// Legs are never masked: a pair that legs bring together asks for a balanced stop.

#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/estimation/estimator.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline control {

struct GuardConfig {
  std::int64_t guard_id = 1;
  double margin = GuardDefaults::kInController;  // left when everything has come to rest, less of near_pairs of robot.yaml [m]
  double near = 0.050;       // pairs nearer than this are reported [m]
  int delay_ticks = 2;       // from the state that shows a danger to the brake that answers it
  double servo_lag = 0.005;  // by which a joint runs on behind a set-point that is braked [s]
};

// What a tick looked at.
struct GuardWork {
  int ways = 0;       // to rest
  int open = 0;       // pairs that no direction at hand proved to stay apart all along a way, of all ways
  int looks = 0;      // distances measured on the ways
  int stretches = 0;  // parts of ways that were looked at by themselves
};

// What a tick held or stopped the robot for.
struct GuardCause {
  bool found = false;
  int link_a = -1, link_b = -1;  // links >= link_count are obstacles; -1: a way that took more looks than a tick has
  double now = 0.0, then = 0.0;  // distance of the two at the tick, and where they come nearest [m]
  int joint = -1;                // that brings them together most
  double speed = 0.0;            // of it, as the look-ahead has it [rad/s or m/s]
  double margin = 0.0;           // that is kept of the two [m]
};

class Guard {
 public:
  static constexpr int kMaxPairs = 64;  // near pairs kept per tick

  // The model must outlive the guard.  Allocates everything; throws std::runtime_error if a mesh
  // cannot be read.
  Guard(const Model& model, const GuardConfig& config);
  ~Guard();

  // Judges one tick; call for every tick.  state and command are finite (convert).  command: what
  // the controller asks for, before any mask is applied to it; null when unknown.  base: only its
  // base pose is read, and only obstacles depend on it.  The report holds until the next call;
  // compute_ns is left 0 for the caller to fill.
  const GuardReport& check(const RobotState& state, const JointCommand* command,
                           const Configuration& base) noexcept;

  // The same of an estimator that has taken the state: its kinematics are used, and how fast it sees the base move.
  const GuardReport& check(const RobotState& state, const JointCommand* command,
                           const Estimator& seen) noexcept;

  const GuardReport& report() const noexcept;

  // Why the last tick that held joints or asked for a stop did so.
  const GuardCause& cause() const noexcept;

  // All near pairs of the last tick, nearest first, points in world; links >= link_count are
  // obstacles.
  const PairDistance* pairs() const noexcept;
  int pair_count() const noexcept;

  const GuardWork& work() const noexcept;  // of the last tick

  // Stretches of a way to rest, since the start, that were too long or too near something to be proved
  // free within the looks that a tick has.
  std::int64_t unproved() const noexcept;

  // Forgets the past: the next call is the first.
  void reset() noexcept;

  // Obstacles in the world of `base`; the first kMaxObstacles are kept.
  void set_obstacles(const std::vector<Obstacle>& obstacles);
  const std::vector<Obstacle>& obstacles() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// In words: "A and B, 12.1 mm apart, would come to 8.3 mm by JOINT at 0.52 rad/s; 10 mm are kept".  Cut off at the end of
// the text.  obstacles: those that the guard was given.
void describe(const Model& model, const std::vector<Obstacle>& obstacles, const GuardCause& cause, std::span<char> text) noexcept;

}  // namespace twinbus::control
