// Pose and velocity of the base from the accelerometer, corrected by the feet that stand; for ESTIMATE.
//
// The velocity v of the IMU's origin, which is where the accelerometer is, goes on by what it feels, f, and is pulled to what
// each standing foot says: its point that the ground presses is at rest.  One Kalman filter per axis of the world,
//     v' = R f + g,  P' = q;      K = P / (P + r / (w dt)),  v += K (v_foot - v),  P -= K P,
// with the certainty w of the foot; q and r give T = sqrt(r / q) = 0.1 s on one foot.  A foot that contradicts v counts
// less (Huber), and so does one that accelerates, whatever v is: it lands, sinks into soft ground and comes up again, or swings,
//     r (1 + |c|^2 / c_0^2) for r,   c = v_foot' - (R f + g), low-passed twice.
// As in Bloesch et al., State estimation for legged robots - consistent fusion of leg kinematics and IMU, RSS
// 2012, without their states for biases and foot places.
//
// Roll and pitch are the IMU's.  Heading is the IMU's but for an offset, so that it begins with 0 and goes on across a switch.
// x and y are the integral of the velocity; z is pulled to the height of the base above the points of the feet that stand.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/estimation/standing_feet.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

class InertialLegOdometry {
 public:
  explicit InertialLegOdometry(const Model& model);  // the model must outlive this

  // The next state is the first: it stands at x = y = 0 with heading 0.
  void reset() noexcept;
  // The next state goes on from an estimate of somebody else's, such as that of the source before.
  void resume(const Estimate& last) noexcept;

  // One call per tick; a tick that was seen changes nothing.  A new run_id goes on where the last one was.
  void update(const RobotState& state) noexcept;

  const Estimate& estimate() const noexcept { return estimate_; }  // of the last state
  const StandingFeet& feet() const noexcept { return feet_; }

 private:
  // Of a foot.
  struct Seen {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // v_foot, world [m/s]
    Eigen::Vector3d rough = Eigen::Vector3d::Zero();     // c filtered once [m/s^2]
    Eigen::Vector3d change = Eigen::Vector3d::Zero();    // c [m/s^2]
  };

  void look(const RobotState& state) noexcept;
  void look_at_feet(double dt, bool follows) noexcept;
  void predict(bool imu, double dt) noexcept;
  void correct(double dt) noexcept;
  void move(double dt) noexcept;
  void report() noexcept;

  const Model* model_;
  StandingFeet feet_;
  Configuration configuration_;
  Kinematics kinematics_;     // in the axes of the base, its origin at rest
  std::vector<int> joints_;   // before feet and IMU
  std::array<Seen, kMaxFeet> seen_;
  Estimate estimate_;

  Eigen::Matrix3d imu_ = Eigen::Matrix3d::Identity();     // IMU in its own world
  Eigen::Matrix3d base_ = Eigen::Matrix3d::Identity();    // base in world
  Eigen::Matrix3d imu_in_base_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d imu_place_ = Eigen::Vector3d::Zero();   // axes of the base [m]
  Eigen::Vector3d imu_drift_ = Eigen::Vector3d::Zero();   // velocity of the IMU against the base, by joints; axes of the base
  Eigen::Vector3d omega_ = Eigen::Vector3d::Zero();       // of the base, its axes [rad/s]
  Eigen::Vector3d felt_ = Eigen::Vector3d::Zero();        // specific force, axes of the IMU [m/s^2]
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();    // of the base's origin, world [m]
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();    // of the IMU's origin, world [m/s]
  Eigen::Vector3d variance_ = Eigen::Vector3d::Ones();    // of it
  Eigen::Vector3d position_variance_ = Eigen::Vector3d::Zero();
  double yaw_variance_ = 0.0;
  double yaw_offset_ = 0.0;  // heading in world less that of the IMU
  double unsupported_ = 0.0;  // since a foot stood [s]
  std::int64_t time_ns_ = 0;
  bool started_ = false, resumed_ = false, imu_valid_ = false, stood_ = false, lifted_ = false;
};

}  // namespace twinbus::robot
