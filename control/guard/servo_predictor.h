// Where joints go when servos do not follow their set-points, as the guard sees it: a learned policy puts set-points far from
// the joints on purpose, whatever its gains, and the torque is what it means.
//
// The motion follows from the measured joint, the gains and the set-point of the command, the effort limit and the robot's
// inertia (robot/dynamics/joint_inertia), the base and all other joints standing still:
//
//     H qdd + bias = clamp(kp (q_ref - q) + kd (qd_ref - qd) + tau, +-effort)
//
// the set-point as the gate lets it move, implicit in q and qd over steps of a tick, until a brake comes.  The brake of the
// gate (bridge/gate/masked_brake.h) is the same equation with the gains of a hold.  Four masks are foretold at once, a lane each:
// the steps wait for one another, not for the arithmetic.  Soft is what is too weak to follow, and what
// had its set-point far away within the last moments.  Where one joint is soft all but the legs are foretold so, since they
// move one another.  Legs bear on the ground, which is not in the equation: soft ones go on as they
// are measured.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/simd/vec4.h"
#include "control/guard/set_point_predictor.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/dynamics/joint_inertia.h"

namespace twinbus::inline control {

class ServoPredictor {
 public:
  // As SetPointTrack.
  ServoPredictor(const Model& model, int delay_ticks, double lag);

  void reset() noexcept;
  // As SetPointTrack::change_source.
  void change_source() noexcept { changed_ = true; }
  // One tick; says which joints are soft, and of these where they go.  mask: bit per joint that the last look held.
  // kinematics: of this configuration, of which the position of the base is not used.  kept: of earlier masks, which look_masked
  // will most likely be asked for, alone and with others, and those of other joints that are still on hold.
  void follow(const RobotState& state, const JointCommand& command, std::int64_t mask, const Kinematics& kinematics,
              const Configuration& configuration, std::int64_t kept = 0, std::int64_t others = 0) noexcept;

  std::int64_t soft() const noexcept { return soft_; }  // bit per joint of the bus
  double set_point(std::size_t k) const noexcept { return servos_[k].q; }  // as the gate has it, of any joint [rad or m]
  bool is_soft(std::size_t k) const noexcept { return (soft_ & bit_of(k)) != 0; }
  // As those of SetPointTrack, of soft joints.
  std::int64_t on_hold() const noexcept;
  const Course& if_obeyed(std::size_t k) const noexcept { return courses_[kObeyed][k]; }
  const Course& if_held(std::size_t k) const noexcept { return courses_[kHeld][k]; }
  // Looks what becomes of all when these are held from this look on and the others obey until the brake of the next one.
  // next: the mask that may be asked for after this one.
  void look_masked(std::int64_t mask, std::int64_t next) noexcept;
  const Course& if_masked(std::size_t k) const noexcept { return courses_[shown_][k]; }

 private:
  static constexpr std::int64_t bit_of(std::size_t k) noexcept { return std::int64_t{1} << k; }
  struct Servo {  // of a joint of the bus
    // of the robot
    int joint = 0;  // of the model
    double effort = 0.0, rate = 0.0, most_speed = 0.0, brake = 1.0, damping = 0.0, lower = 0.0, upper = 0.0;
    double hold_kp = 0.0, hold_kd = 0.0, follows_kp = 0.0;
    bool leg = false;
    const Joint* of = nullptr;
    // as commanded
    double q = 0.0, held_v = 0.0, held_tau = 0.0;    // as the gate has it, and its speed and torque while it is held
    bool feels = false;      // its torque is measured: it was not always 0
    double kp = 0.0, kd = 0.0, qd = 0.0, tau = 0.0;  // as the gate lets them through
    double asked = 0.0, speed = 0.0;                 // what it is asked to be, and how that moves
    double client_q = 0.0, client_speed = 0.0, step = 0.0;  // the same of the client alone, and how it moved last
    double heard_q = 0.0, goes_on = 0.0;             // q when that was heard; asked, once commands up to now are
    double moved = 0.0;                              // q, in the last tick
    // A fade's, minus the client's, and since when [s].
    double from_q = 0.0, from_v = 0.0, from_kp = 0.0, from_kd = 0.0, faded = 0.0;
    double strays = 0.0;  // its set-point was far away, and counts so for as long [s]
  };
  static constexpr int kLanes = 4;  // masks that are foretold at once
  // The alignment is said, as in vec4.h; a template forgets it, of the struct it does not.
  typedef double Lanes __attribute__((vector_size(32), aligned(32)));
  typedef std::int64_t Flags __attribute__((vector_size(32), aligned(32)));  // of lanes: 0 or -1
  struct Entry {
    Lanes x;
  };
  using Masks = std::array<std::int64_t, kLanes>;
  struct Motion {  // of a joint, from where it is measured
    Flags braked{};
    Lanes q{}, v{}, set{}, set_v{}, asked{};
    Lanes kp{}, kd{}, tau{};             // as they are while it obeys, or is held
    Lanes torque{};                      // of a step, for a joint that stands still [N m or N]
    Lanes limited{};                     // the torque is at its limit: 1 or -1
    Lanes stopped{};                     // the joint ran into its stop in this step: 1 or -1
    double lower = 0.0, upper = 0.0;     // stops
    Lanes first{}, speed{};              // when the brake has come
    Lanes least{}, most{};               // since then
  };
  TWINBUS_INLINE static Lanes clamped(const Lanes& x, const Lanes& low, const Lanes& high) noexcept {
    const Lanes least = x < low ? low : x;
    return high < least ? high : least;
  }
  TWINBUS_INLINE static Lanes lanes(double x) noexcept { return Lanes{} + x; }
  TWINBUS_INLINE static bool any(const Flags& flags) noexcept { return (flags[0] | flags[1] | flags[2] | flags[3]) != 0; }
  void hear(const RobotState& state, const JointCommand& command) noexcept;
  void hold(const RobotState& state, const JointCommand& command) noexcept;
  static void see_held(Servo& servo, double q, double v, double tau) noexcept;
  void move_set_points(const RobotState& state, const JointCommand& command) noexcept;
  void gather(const RobotState& state, const JointCommand& command) noexcept;
  void look(const RobotState& state, const Kinematics& kinematics, const Configuration& configuration, std::int64_t kept,
            std::int64_t others) noexcept;
  void run(const Masks& masks, std::size_t first) noexcept;
  void step(double h) noexcept;
  static void set_gains(Motion& motion, const Servo& servo) noexcept;
  void brake_those(const Masks& masks) noexcept;

  double period_, lag_, delay_, fade_s_;  // [s]
  int count_, delay_ticks_;
  bool started_ = false, changed_ = false;
  std::int64_t controller_ = 0, heard_tick_ = 0, looked_tick_ = 0;
  std::int64_t soft_ = 0, weak_ = 0, held_now_ = 0;  // weak: soft by their gains
  std::array<std::int64_t, SetPointTrack::kMostDelay> masks_{};  // on their way, the newest first
  PerJoint<Servo> servos_{};
  std::array<int, kMaxJoints> order_{};  // joints of the bus, parents first
  // Those that follow the equation, in the order of the tree.
  int moving_ = 0;
  std::array<int, kMaxJoints> of_bus_{}, joints_{};
  PerJoint<Motion> motion_{};
  PerJoint<double> bias_{};
  PerJoint<Entry> change_{}, added_{};
  std::vector<Entry> factor_;  // [JointInertia::kFactor]
  bool has_factor_ = false;
  JointInertia inertia_;
  InverseDynamics dynamics_;
  Eigen::VectorXd no_acceleration_, torque_;
  const std::vector<ExternalWrench> nothing_;
  PerJoint<double> q_{}, v_{};  // measured
  static constexpr std::size_t kObeyed = 0, kHeld = 1, kMasked = kLanes;  // after the first two come those of `kept`
  std::array<PerJoint<Course>, 2 * kLanes> courses_{};
  std::array<std::int64_t, 2 * kLanes> masked_of_{};  // joints that move, of those masks
  std::size_t known_ = 0;                             // of these
  std::size_t shown_ = kObeyed;
  std::int64_t all_moving_ = 0;  // bit per joint of the bus
};

}  // namespace twinbus::control
