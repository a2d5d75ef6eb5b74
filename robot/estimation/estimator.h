// Where the base is, from what a robot can measure: IMU, encoders and foot forces.
//
// Used by the controller and by a simulator that tracks another source, so that both mean the same.
// World: z up, origin and heading where the first state was; goes on across a switch.  Roll and pitch come from the IMU,
// or where robot.yaml says `walking: {attitude: estimated}` from its gyro and accelerometer; heading and position come from
// the loaded soles, which stand still on the plane z = 0, so a drifting IMU heading turns nothing.

#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/estimation/attitude_filter.h"
#include "robot/estimation/inertial_leg_odometry.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/estimation/support_polygon.h"

namespace twinbus::inline robot {

class Estimator {
 public:
  explicit Estimator(const Model& model);

  // Attitude from gyro and accelerometer (attitude_filter.h) instead of the IMU's own.
  void estimate_attitude(bool own) noexcept { own_attitude_ = own; }

  // Starts again: the base stands with its loaded soles on the ground plane z = 0, midway at x = y
  // = 0, heading 0.
  void reset() noexcept;

  // One call per tick.  With a new run_id (a switch) the ground frame stays where it was, so the
  // estimate does not jump though the new source has a heading of its own.  again: this tick was seen
  // before, of another robot; what follows in time stays as it is.
  void update(const RobotState& state, bool again = false) noexcept;

  // States were missed while somebody else moved the robot: at the next state the soles that stand are where they are said to
  // be, world, and velocities are what that state says.
  void resume(const std::array<bool, 2>& stands, const std::array<Eigen::Vector2d, 2>& place,
              const std::array<double, 2>& yaw) noexcept;

  const Configuration& configuration() const noexcept {
    return configuration_;
  }  // base pose and velocity, joints
  const Kinematics& kinematics() const noexcept { return kinematics_; }  // updated for it
  // Of the base's z axis from up [rad].
  double tilt() const noexcept { return std::acos(std::clamp(configuration_.base.linear()(2, 2), -1.0, 1.0)); }
  // Sole frames, and the frame midway between them with z up: the ground frame of arm_goal_t.
  const Eigen::Isometry3d& sole_in_world(int foot) const noexcept {
    return sole_[static_cast<std::size_t>(foot)];
  }
  const Eigen::Isometry3d& ground_in_world() const noexcept { return ground_; }
  // The feet of a robot that stands on points (point_legs.h); null: on soles.  Its base is where inertial_leg_odometry says, the
  // ground frame is below the base, and both sides count as loaded while any foot stands.
  const StandingFeet* feet() const noexcept { return odometry_ ? &odometry_->feet() : nullptr; }
  // Force and torque on a sole about its sole frame's origin, in world [N, N m]; zero when not
  // measured.
  const Eigen::Vector3d& sole_force(int foot) const noexcept {
    return force_[static_cast<std::size_t>(foot)];
  }
  const Eigen::Vector3d& sole_torque(int foot) const noexcept {
    return torque_[static_cast<std::size_t>(foot)];
  }
  bool loaded(int foot) const noexcept { return loaded_[static_cast<std::size_t>(foot)]; }
  // Of the centre of mass, as the joints say it now, world [m/s].
  const Eigen::Vector3d& com_velocity() const noexcept { return com_velocity_; }
  // Measured zero-moment point in world, z of the ground; com projection when no foot is loaded.
  const Eigen::Vector3d& zmp() const noexcept { return zmp_; }
  // Of the centre of mass with the angular momentum L about it, v + (L_y, -L_x) / (m h), as the joints say it now, world
  // [m/s].
  const Eigen::Vector2d& spun_velocity() const noexcept { return spun_velocity_; }
  // Horizontal velocity whose DCM is com + this / omega, world [m/s]: spun_velocity(), led by the measured ZMP p and pulled to what
  // the joints say, so that it is neither late nor noisy:  s' = g / h (x - p)
  const Eigen::Vector2d& dcm_velocity() const noexcept { return dcm_velocity_; }
  // Convex hull of the loaded soles, seen from above, in world.
  const SupportPolygon& support() const noexcept { return support_; }
  // Distance of a ground point (world) to the edge of the hull, positive inside [m]; -1 when no
  // foot is loaded.
  double support_margin(const Eigen::Vector3d& point) const noexcept {
    return support_.margin(point.head<2>());
  }

 private:
  // A sole as the robot sees it: in a frame at the base's origin with z up and the IMU's heading.
  struct Seen {
    Eigen::Vector3d position;
    Eigen::Matrix3d rotation;
    Eigen::Vector3d centre;           // of the rectangle
    Eigen::Vector3d centre_velocity;  // while the base's origin is at rest
    Eigen::Matrix3d sensor_rotation;
    Eigen::Vector3d sensor_arm;  // from the sole frame's origin to the force sensor
    double yaw = 0.0;
    double spin = 0.0;    // angular velocity about z [rad/s]
    double height = 0.0;  // of the sole frame's origin above the ground while loaded [m]
    double weight = 0.0;  // share in the average
  };

  void look_at_imu(const RobotState& state, bool anew) noexcept;
  void look(const RobotState& state) noexcept;
  void measure_load(const RobotState& state) noexcept;
  void place_base(bool start, bool switched) noexcept;
  void move_base() noexcept;
  void finish() noexcept;
  void follow_points(const RobotState& state, bool again) noexcept;
  void follow_dcm() noexcept;

  const Model* model_;
  std::optional<InertialLegOdometry> odometry_;  // of a robot that stands on points
  double weight_force_;  // of the whole robot [N]
  Configuration configuration_;
  Kinematics kinematics_;
  std::vector<int> seen_joints_;  // before the soles and the IMU
  std::array<Seen, 2> seen_;
  Eigen::Matrix3d upright_base_;           // base rotation with the IMU's heading
  Eigen::Vector3d position_;               // of the base's origin, world
  std::array<Eigen::Vector2d, 2> anchor_;  // where a loaded sole's origin stands, world
  std::array<double, 2> anchor_yaw_{};
  std::array<bool, 2> anchored_{};
  double yaw_offset_ = 0.0;  // heading in world minus heading of the IMU
  std::int64_t run_id_ = 0;
  bool own_attitude_ = false;
  AttitudeFilter attitude_;
  Eigen::Vector3d imu_velocity_ = Eigen::Vector3d::Zero();  // frame of the filter [m/s]
  Eigen::Matrix3d imu_ = Eigen::Matrix3d::Identity();       // attitude as it is believed
  Eigen::Vector3d gyro_bias_ = Eigen::Vector3d::Zero();     // IMU's axes, horizontal [rad/s]
  std::int64_t time_ns_ = 0;
  double dt_ = 0.0;  // since the last state [s]
  bool started_ = false;
  bool resumed_ = false;  // the next state is the first after a silence

  std::array<Eigen::Isometry3d, 2> sole_;
  Eigen::Isometry3d ground_;
  std::array<Eigen::Vector3d, 2> force_, torque_;
  std::array<bool, 2> loaded_{};
  Eigen::Vector3d zmp_, com_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d dcm_velocity_ = Eigen::Vector2d::Zero(), spun_velocity_ = dcm_velocity_;
  SupportPolygon support_;
};

}  // namespace twinbus::robot
