// Walking without forces: which foot stands, where the other one goes, and the reference of DCM and ZMP that belongs to it.
//
// Everything is planned anew every tick, so velocity, footholds and the end of walking may change at any time; what the
// reference must not do is jump, and that is the business of its reader (walk_stabilizer).

#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "control/walk/dcm_plan.h"
#include "control/walk/footsteps.h"
#include "control/walk/ground_roughness.h"
#include "control/walk/ground_slope.h"
#include "control/walk/preview_plan.h"
#include "control/walk/step_adjust.h"
#include "control/walk/swing_foot.h"
#include "lcmtypes/msg/step_list.h"

namespace twinbus::inline control {

class WalkPattern {
 public:
  static constexpr int kMostFootholds = kMostSteps;  // of a list

  // Allocates if the gait asks for preview control.
  explicit WalkPattern(const Gait& gait, const SwingGains& swing = {});

  // Stands on both feet; left, right.
  void start(const std::array<Foothold, 2>& feet) noexcept;
  // Wanted from now on: vx, vy, wz in the heading of the feet; zero: comes to stand with the feet side by side.
  void want(const Eigen::Vector3d& velocity) noexcept;
  // Ends walking as soon as can be: the step under way brakes, or if it is half over the next one does, and where both
  // soles then stand the robot comes to rest if that catches it.
  void halt() noexcept;
  // A halt has been foreseen, but the robot walks on: at that speed, of those between the present one and the one before the
  // halt, whose reference this DCM is nearest to.
  void walk_on(const Eigen::Vector2d& measured_dcm, double omega) noexcept;
  // Once it stands, and before it is settled, the feet come side by side, as far apart as the robot stands.
  void square() noexcept { squares_ = tidy_ = true; }
  // Walks these instead, in this order, beginning with the foot that is not `first_support`; then stands.  World.
  void follow(const Foothold* list, int count, int first_support) noexcept;

  // One tick: the phase goes on.  touching: whether a foot carries load; measured: where the soles are.
  void advance(const std::array<bool, 2>& touching, const std::array<Foothold, 2>& measured,
               double dt) noexcept;
  // Moves the next step so that this DCM can be caught, and plans.
  void plan(const Eigen::Vector2d& measured_dcm, double omega) noexcept;
  // Standing, or about to walk, and pushed: a step at once, with the foot that needs to step less far to catch this DCM.
  void capture(const Eigen::Vector2d& measured_dcm, double omega) noexcept;

  bool walking() const noexcept { return walking_; }
  bool settled() const noexcept { return !walking_ && !squares_; }
  bool single() const noexcept { return walking_ && single_; }  // on one foot
  int support() const noexcept { return support_; }
  bool swings(int foot) const noexcept { return single() && foot != support_; }
  const Foothold& foot(int foot) const noexcept { return feet_[static_cast<std::size_t>(foot)]; }
  const SwingFoot& swing() const noexcept { return swing_; }
  const Foothold& target() const noexcept { return target_; }
  // The reference.
  Eigen::Vector2d dcm() const noexcept { return preview_ ? preview_->dcm() : dcm_; }
  Eigen::Vector2d zmp() const noexcept { return preview_ ? preview_->zmp() : zmp_; }
  const Eigen::Vector3d& velocity() const noexcept { return velocity_; }
  double heading() const noexcept;  // between the feet [rad]
  Eigen::Vector2d middle() const noexcept;
  // Height of what carries the robot [m].
  double ground() const noexcept {
    return single() ? foot(support_).height : 0.5 * (feet_[0].height + feet_[1].height);
  }
  // The same under a point of the plane that the ground is taken for.
  double ground_at(const Eigen::Vector2d& point) const noexcept {
    const Eigen::Vector2d on = single()
                                   ? foot(support_).position
                                   : Eigen::Vector2d(0.5 * (feet_[0].position + feet_[1].position));
    return ground() + slope_.gradient().dot(point - on);
  }
  const GroundSlope& slope() const noexcept { return slope_; }
  // Where the ZMP rests while the robot stands; soon the middle.
  const Eigen::Vector2d& rest() const noexcept { return rest_; }
  int steps() const noexcept { return steps_; }  // landed
  // For whoever draws.  The footholds to come as they are planned now, beginning with the foot that does not carry; and
  // where the foot in the air will be until it lands, `most` places evenly in time.  How many were filled.
  int ahead(Foothold* list, int most) const noexcept;
  int swing_way(Foothold* list, int most) const noexcept;
  double adjusted() const noexcept { return adjusted_; }
  const Gait& gait() const noexcept { return gait_; }

 private:
  // What is wanted, as fast as the ground lets it: where landings find steps or soles stand on edges, at most a share of the
  // fastest walk, which leaves steps that still catch the robot when a sole bears on its rim only.
  Eigen::Vector3d dared() const noexcept;
  double rough_share() const noexcept;  // 0: smooth ground, 1: rough
  std::size_t plan_pieces(double omega) noexcept;  // how many
  StepAdjusted adjusted_step(const Eigen::Vector2d& measured_dcm, double omega) const noexcept;
  bool try_to_stand(const Eigen::Vector2d& measured_dcm, double omega) noexcept;
  void stand(const Eigen::Vector2d& rest, double time) noexcept;
  Eigen::Vector2d on_both_soles(const Eigen::Vector2d& point) const noexcept;
  void begin_step(int support, double double_time) noexcept;
  // stood: the other one, that carried the robot; both as measured.
  void land(const Foothold& where, const Foothold& stood) noexcept;
  Eigen::Vector2d apart() const noexcept;  // the left foot from the right one, in its axes [m]
  bool side_by_side() const noexcept;
  Foothold on_ground(Foothold at, const Foothold& from) const noexcept;
  Foothold after(const Foothold& from, int foot, int steps_ahead) const noexcept;
  bool wants_to_walk() const noexcept {
    return wanted_.squaredNorm() > 1e-10 || listed_ < list_count_;
  }

  static constexpr int kAhead = 3;  // steps planned beyond the next

  Gait gait_;
  SwingFoot swing_;
  GroundSlope slope_;
  GroundRoughness rough_;
  std::optional<PreviewPlan> preview_;
  bool unforeseen_ = false;                          // a stop or a step that no preview knew of
  std::array<ZmpPiece, 2 + 2 * kAhead + 1> pieces_;  // of the ZMP to come
  std::array<Foothold, 2> feet_;
  std::array<Foothold, kMostFootholds> list_;
  int listed_ = 0, list_count_ = 0, list_support_ = 0;
  Eigen::Vector3d wanted_ = Eigen::Vector3d::Zero(), velocity_ = wanted_, before_halt_ = wanted_;
  bool walking_ = false, single_ = false, halting_ = false, braking_ = false;
  int support_ = 0, steps_ = 0, square_ = 0;
  bool squares_ = false;  // the feet are still to be put side by side
  bool tidy_ = false;     // and as far apart as the robot stands
  double uneven_ = 0.0;   // the steps up and down that the last landings met [m]
  double time_ = 0.0, double_ = 0.0, single_time_ = 0.0;  // in the step; its two parts [s]
  double since_landing_ = 0.0, period_;                   // measured, of a step [s]
  Foothold planned_, target_;  // of the foot that moves; the latter adjusted to catch the robot
  double adjusted_ = 0.0;
  Eigen::Vector2d rest_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d zmp_from_ = Eigen::Vector2d::Zero();  // where this double support began
  Eigen::Vector2d dcm_ = Eigen::Vector2d::Zero(), zmp_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d dcm_landing_ = Eigen::Vector2d::Zero();  // planned at the next touchdown
};

}  // namespace twinbus::control
