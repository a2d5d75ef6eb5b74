// What Guard is made of.  Shared by guard.cpp (a tick, from the state to the report) and guard_ahead.cpp
// (the ways that may follow it, and who is to be held).

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "control/guard/braking_path.h"
#include "control/guard/guard.h"
#include "control/guard/servo_predictor.h"
#include "control/guard/set_point_predictor.h"
#include "common/math/index.h"
#include "robot/collision/near_pairs.h"

namespace twinbus::inline control {

struct Guard::Impl {
  static constexpr int kMostOpen = 128;  // pairs that are looked at one by one at once
  // A stretch that is not proved is looked at in parts, and so are these.
  static constexpr int kMostParts = 3;
  static constexpr int kMostStretches = 24, kMostLooks = 48;  // of a tick
  // Of the approach: joints that do less of it are not masked.
  static constexpr double kShare = 0.02;

  const Model* model;
  GuardConfig config;
  Collision collision;
  MarginShares margin_shares;
  SetPointTrack track;
  ServoPredictor servos;  // of joints that are too soft to follow their set-points
  Kinematics own_kinematics, then_kinematics;
  const Kinematics* now_kinematics = &own_kinematics;  // or the estimator's, of the same joints
  Configuration now, then;
  std::vector<int> leg;  // [joint_count], 1 for leg joints
  std::vector<std::uint8_t>
      moves;  // [link_count x joint_count]: the joint is on the way from the base to the link
  using Courses = std::vector<Course>;  // [joint_count]
  Courses braked, obeyed, masked;
  Eigen::VectorXd rests;              // of a course [joint_count]
  Eigen::VectorXd reaches;            // of joints [joint_count]
  Eigen::VectorXd changes;            // of a distance, by joints [joint_count, m]
  std::vector<std::int64_t> bits_of;  // of a joint, or of the one it follows, on the bus
  Collision::Ahead ahead_of_now;      // all courses that this tick may look along
  std::optional<Collision::PathsAhead> ahead;  // of this tick
  SweptShapes::Way places;
  std::array<PairDistance, kMaxPairs> pairs{};
  int pair_count = 0;
  std::array<std::pair<int, int>, 16> parting{};  // what a hand holds and what it stood on; (0, 0) is none
  std::array<std::array<Collision::PathPair, kMostOpen>, kMostParts> open;
  int suspect = -1;  // shapes that came too near when a way was looked along last
  int stretches_left = 0, looks_left = 0;
  GuardWork work;
  std::int64_t unproved = 0;
  std::int64_t mask = 0;  // the answer of this tick, like the next two
  bool leg_hit = false, danger = false;
  double least_share = kShare;
  std::int64_t all_but_legs = 0;
  std::array<int, kMaxJoints> keep{};  // ticks left of a mask
  std::int64_t run_id = 0, commanded_run_id = 0, seen_tick = 0;  // of the states and of the commands
  PerJoint<double> seen_q{};
  GuardReport report;
  GuardCause cause;
  std::vector<Obstacle> obstacles;

  Impl(const Model& robot, const GuardConfig& wanted);
  bool moves_link(int joint, int link) const noexcept {
    const int by = collision.carrier(link);
    return by >= 0 && moves[at(by * model->joint_count() + joint)] != 0;
  }

  const Course& if_held(int k) const noexcept { return servos.is_soft(at(k)) ? servos.if_held(at(k)) : track.if_held(at(k)); }
  std::int64_t on_hold() const noexcept { return track.on_hold() | servos.on_hold(); }
  std::int64_t kept() const noexcept {  // of earlier masks, in the next
    std::int64_t held = 0;
    for (int k = 0; k < kMaxJoints; ++k) held |= keep[at(k)] > 1 ? bit(k) : 0;
    return held;
  }
  double margin_of(int link_a, int link_b) const noexcept { return config.margin * margin_shares.of(link_a, link_b); }  // [m]
  void forget() noexcept;
  void set_obstacles(const std::vector<Obstacle>& given);
  void find_reaches() noexcept;
  bool stands_on(const PairDistance& pair) const noexcept;
  void look_what_parts() noexcept;
  bool goes_on(const RobotState& state) const noexcept;
  // What is now is known.
  const GuardReport& check(const RobotState& state, const JointCommand* command) noexcept;
  void predict(const RobotState& state, const JointCommand* command) noexcept;
  void predict_masked(std::int64_t held, std::int64_t next) noexcept;
  void keep_in_ranges(Courses& courses) const noexcept;
  bool runs_on() noexcept;
  void bound_moves() noexcept;
  const PairDistance* near_now(int link_a, int link_b) const noexcept;
  bool look_along(const Courses& courses) noexcept;
  double travel(const Courses& courses, const Courses* other) noexcept;
  void go_to(const CourseWay& way, double share) noexcept;
  bool judge(const CourseWay& way, const CourseWay::Shares& shares, const Courses& courses,
             const Collision::PathPlaces& path, Collision::PathPair& pair) noexcept;
  bool look(const CourseWay& way, const CourseWay::Shares& shares, const Courses& courses,
            const Collision::PathSearch& search, const Collision::PathPlaces& path, int part, int count) noexcept;
  void ask_joints(const Collision::PathPair* asked, int count) noexcept;
  bool hold_all() noexcept;
  // Then only what legs do can still change the answer.
  bool all_held() const noexcept { return (mask & all_but_legs) == all_but_legs; }
  void prove_mask() noexcept;
  bool comes_too_near(const PairDistance& before, const PairDistance& after) const noexcept;
  double approach(const Kinematics& kinematics, const PairDistance& pair, int joint,
                  double step) const noexcept;
  void blame(const PairDistance& before, const PairDistance& after, const CourseWay& way,
             double share, const Courses& courses) noexcept;
  bool blame_at(const Kinematics& kinematics, const PairDistance& pair,
                const Courses& courses) noexcept;
  double approach_speed(const PairDistance& pair) const noexcept;
  bool leads_nearer(const JointCommand& command) const noexcept;
  void fill_rows() noexcept;
};

}  // namespace twinbus::control
