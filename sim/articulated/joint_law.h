// What acts in one joint besides the inertia of its links: the servo within its effort limit,
// damping, Coulomb friction and the mechanical stops, all at the end of the step.
//
// Each is piecewise linear in the joint's speed qd+ at the end of the step h:
//
//     servo     kp (q_ref - q - play - h qd+) + kd (qd_ref - qd+) + tau_ff, within +-effort
//     friction  -damping qd+ - friction sat(qd+ / kStickSpeed)
//     stop      -kStopGain (qd+ - bound) where qd+ passes the bound at which q+ meets the stop
//
// The solver works with the line of one piece (JointRow) and then asks whether it holds() at the
// speed found.  So a second pass is needed only in steps in which a joint changes piece.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "robot/description/model.h"
#include "sim/articulated/aba.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// So stiff that a stop is passed by less than 1e-9 rad at any torque a robot has.
inline constexpr double kStopGain = 1e11;  // [N m s/rad]
// A joint set beyond its stop comes back by this share of the excess per step, not faster than so.
inline constexpr double kStopShare = 0.2;
inline constexpr double kStopReturn = 2.0;  // [rad/s or m/s]
inline constexpr double kStopGuess =
    1e-12;  // a joint so near its stop is expected to lean on it [rad]

inline constexpr double kSpringLimit = 1e9;  // of a passive joint: none [N m or N]

// How fast a joint may come nearer to a stop that is so far away [rad/s].
inline double stop_bound(double room, double rate) noexcept {
  return room >= 0.0 ? room * rate : std::max(kStopShare * room * rate, -kStopReturn);
}

// One step of the Fowler-Noll-Vo hash, of which patterns are made.
inline std::uint64_t mix(std::uint64_t pattern, int value) noexcept {
  return (pattern ^ static_cast<std::uint64_t>(value)) * 0x100000001b3ULL;
}

class JointLaw {
 public:
  JointLaw(const Joint& joint, const WorldConfig& config);

  // Leaves a spring as it is.
  void set_target(const ServoTarget& target) noexcept {
    if (!passive_) target_ = target;
  }
  // No motor from now on: a spring without limits.
  void make_spring(double stiffness, double rest) noexcept {
    target_ = {.q = rest, .kp = stiffness};
    limit_ = kSpringLimit;
    backlash_ = 0.0;
    passive_ = true;
  }
  // For two joints that share two motors (sim/motors/motor_limits.h), which say what the servo gives of the torque it asks for: its line
  // in this step, and the one to be taken instead.
  void limit_elsewhere() noexcept {
    limit_ = std::numeric_limits<double>::infinity();
    shared_ = true;
  }
  JointRow servo_line() const noexcept { return servo_; }
  void take_servo_line(const JointRow& line) noexcept { servo_ = line; }
  // After a jump: torque of the servo until now, which says on which flank of its play it is.
  void set_tau(double tau) noexcept;

  // A step begins; the pieces are those of the present speed.
  void begin(double q, double qd, double h) noexcept;
  JointRow row() const noexcept;
  // Whether the assumed pieces are those of that end speed; approach() assumes them, or the one
  // in between where they are opposite: the middle of the law is steep, a leap over it returns.
  bool holds(double qd_end) const noexcept {
    return within_all(qd_end) ? pieces_ == Pieces{} : pieces_at(qd_end) == pieces_;
  }
  void approach(double qd_end) noexcept;
  // The same for one piece of them only.
  void approach_by_one(double qd_end) noexcept;
  // A number that tells the assumed pieces apart.
  int pattern() const noexcept { return 9 * pieces_.servo + 3 * pieces_.friction + pieces_.stop; }
  // The step is done: torque of the servo, play.  share: how much of a whole step it was.
  void finish(double qd_end, double share) noexcept;
  // Torque and play as they are, for a step that is taken again.
  void save() noexcept {
    saved_play_ = play_;
    saved_tau_ = tau_;
  }
  void restore() noexcept {
    play_ = saved_play_;
    tau_ = saved_tau_;
  }

  // For motion that is not solved implicitly: nothing in the joint depends on the step.
  bool smooth() const noexcept { return !(friction_ > 0.0) && !(backlash_ > 0.0) && !shared_; }
  double torque_at(double q, double qd) const noexcept;  // servo and damping
  double stiffness() const noexcept { return target_.kp; }
  double damping() const noexcept { return target_.kd + damping_; }
  bool within_stops(double q) const noexcept { return q > lower_ && q < upper_; }
  double beyond_stops(double q) const noexcept { return std::max(q - upper_, lower_ - q); }
  void settle(double q, double qd) noexcept { tau_ = torque_at(q, qd) + damping_ * qd; }

  double tau() const noexcept { return tau_; }    // of the servo, within the limit [N m]
  double play() const noexcept { return play_; }  // servo side minus link side [rad]

 private:
  friend class LaneWorlds;
  struct Pieces {
    int servo = 0;     // -1, 1: at the limit
    int friction = 0;  // -1, 1: sliding that way
    int stop = 0;      // -1, 1: at the lower or upper stop
    bool operator==(const Pieces&) const = default;
  };

  // Most joints in most steps: no limit, friction or stop in reach of that end speed.
  bool within_all(double qd_end) const noexcept {
    return std::abs(servo_.force - servo_.gain * qd_end) <= limit_ && std::abs(qd_end) <= stick_ &&
           qd_end >= low_bound_ && qd_end <= high_bound_;
  }
  Pieces pieces_at(double qd_end) const noexcept;
  double flank() const noexcept;  // where the play settles under the joint's torque

  double lower_, upper_, limit_, damping_, friction_, backlash_;
  double stick_;       // speed beyond which friction slides; none without friction
  double stick_gain_;  // of friction that does not [N m s/rad]
  ServoTarget target_;
  bool passive_ = false, shared_ = false;
  double play_ = 0.0, tau_ = 0.0;
  double saved_play_ = 0.0, saved_tau_ = 0.0;
  // Of this step.
  JointRow servo_;                           // not limited, but for joints that share motors
  double low_bound_ = 0.0, high_bound_ = 0;  // of qd+ by the stops
  Pieces pieces_;
};

inline void JointLaw::begin(double q, double qd, double h) noexcept {
  const ServoTarget& t = target_;
  servo_.force = t.kp * (t.q - q - play_) + t.kd * t.qd + t.tau;
  servo_.gain = h * t.kp + t.kd;
  const double rate = 1.0 / h;
  high_bound_ = stop_bound(upper_ - q, rate);
  low_bound_ = -stop_bound(q - lower_, rate);
  pieces_ = within_all(qd) ? Pieces{} : pieces_at(qd);
  if (upper_ - q <= kStopGuess && qd >= 0.0) pieces_.stop = 1;
  if (q - lower_ <= kStopGuess && qd <= 0.0) pieces_.stop = -1;
}

inline JointRow JointLaw::row() const noexcept {
  JointRow row = servo_;
  if (pieces_ == Pieces{}) {
    row.gain = row.gain + damping_ + stick_gain_;
    return row;
  }
  if (pieces_.servo != 0) row = {.force = pieces_.servo * limit_, .gain = 0.0};
  row.gain += damping_;
  if (pieces_.friction != 0) {
    row.force -= pieces_.friction * friction_;
  } else {
    row.gain += stick_gain_;
  }
  if (pieces_.stop != 0) {
    row.force += kStopGain * (pieces_.stop > 0 ? high_bound_ : low_bound_);
    row.gain += kStopGain;
  }
  return row;
}

inline void JointLaw::finish(double qd, double share) noexcept {
  tau_ = pieces_.servo != 0 ? pieces_.servo * limit_
                            : std::clamp(servo_.force - servo_.gain * qd, -limit_, limit_);
  if (backlash_ > 0.0) play_ += share * kPlayRate * (flank() - play_);
}

inline JointLaw::Pieces JointLaw::pieces_at(double qd) const noexcept {
  const double asked = servo_.force - servo_.gain * qd;
  const auto side = [](double x, double low, double high) {
    return static_cast<int>(x > high) - static_cast<int>(x < low);
  };
  return {side(asked, -limit_, limit_), side(qd, -stick_, stick_),
          side(qd, low_bound_, high_bound_)};
}

// Whether a method that is not implicit in the joints follows these servos: of each, stiffness h^2 k and damping h c over the
// inertia that the joint moves are below limit.  inverse_inertia: of a joint.
template <class InverseInertia>
bool gentle(const std::vector<JointLaw>& joints, double h, double limit,
            InverseInertia&& inverse_inertia) noexcept {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double mobility = inverse_inertia(static_cast<int>(j));
    if (!(h * h * joints[j].stiffness() * mobility < limit)) return false;
    if (!(h * joints[j].damping() * mobility < limit)) return false;
  }
  return true;
}

}  // namespace twinbus::sim
