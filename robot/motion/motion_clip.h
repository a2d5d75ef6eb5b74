// A motion as a robot plays it: frames every 20 ms or a little less of all its joints, what the centre of mass and the trunk do, bound by
// name.
//
// Joints that are of no leg go exactly where the motion says.  A standing robot cannot leave its soles, so of the legs
// there is kept what balance can do: where the centre of mass is over the feet, how deep it is, how the trunk leans.

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"
#include "robot/kinematics/kinematics.h"
#include "robot/motion/motion_file.h"

namespace twinbus::inline robot {

// Of one instant.
struct MotionPoint {
  PerJoint<double> q{}, qd{}, qdd{};  // bus order [rad or m], per second, per second squared
  Eigen::Vector3d com = Eigen::Vector3d::Zero(), com_velocity = com,
                  com_acceleration = com;  // from standing, ground frame [m]
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero(),
                  tilt_rate = tilt;  // of the base, roll and pitch [rad]
};

struct MotionOptions {
  double speed = 1.0;                  // 0.05 to 1: how fast it is played
  std::string stand = "half_sitting";  // the named pose in which the robot stands
  bool upper_only = false;             // nothing of what the legs do
};

class MotionClip {
 public:
  // Throws std::runtime_error: a joint that the robot has not (with the nearest name), none of its joints, or one that
  // follows another.
  MotionClip(const Model& model, const MotionFile& file, const MotionOptions& options);

  int frames() const { return static_cast<int>(frames_.size()); }
  double period() const { return period_; }  // between frames [s]
  double duration() const { return (frames() - 1) * period_; }
  std::int64_t mask() const { return mask_; }  // bit per bus joint that is moved as the motion says
  bool moves_legs() const { return moves_legs_; }  // and the centre of mass, by them
  double speed() const { return speed_; }
  // The share of the sideways and forward motion of the centre of mass that balance allows; 1: all.
  double com_share() const { return com_share_; }
  // The deepest of the centre of mass below standing, positive [m], and what the file asked.
  double depth() const { return depth_; }
  double asked_depth() const { return asked_depth_; }
  // Joints of the robot that the file does not name stay as the robot stands.
  const PerJoint<double>& stand() const { return stand_; }  // bus order
  // Standing, in the ground frame: the origin midway between the soles, z up.
  const Configuration& standing() const { return standing_; }

  MotionPoint at_time(double time) const;
  // Every joint as the file has it, legs too; base as well if has_root.
  void as_recorded(double time, Configuration& configuration) const;
  bool has_root() const { return has_root_; }
  // Joints of the file, also those of legs, as bits of bus joints.
  std::int64_t named() const { return named_; }

  // For the channel MOTION, each to be said a little before it is played.
  std::vector<MotionPiece> pieces(std::int64_t motion_id) const;
  double time_of(const MotionPiece& piece) const { return piece.first * period_; }

 private:
  void find_stand(const Model& model, const std::string& pose);
  void sample_file(const MotionFile& file);
  void project_legs(const Model& model);
  Eigen::Isometry3d ground_of(const Kinematics& kinematics) const;

  struct Frame {
    PerJoint<double> q{};
    Eigen::Vector3d com = Eigen::Vector3d::Zero();
    Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  };
  const Model* model_;
  double period_ = 0.02, speed_ = 1.0, com_share_ = 1.0, depth_ = 0.0, asked_depth_ = 0.0;
  std::int64_t mask_ = 0, named_ = 0;
  bool moves_legs_ = false, has_root_ = false;
  PerJoint<double> stand_{};
  Configuration standing_;
  std::vector<int> column_;                 // of each bus joint, -1 none
  std::vector<Frame> frames_;               // control points of the spline
  std::vector<PerJoint<double>> recorded_;  // at the frames, every joint
  std::vector<Eigen::Isometry3d> root_;
};

}  // namespace twinbus::robot
