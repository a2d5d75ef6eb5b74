// Feet, hands and trunk of a humanoid nobody has described, from names and geometry.
//
// Looked at in the posture nearest to zero, with the base upright: z up, x forward, left at
// positive y.  A limb is the largest part of the tree that lies on one side and has three joints in
// a row; the pair of limbs that reaches lowest are the legs unless they are named like arms, of the
// others the heavier are the arms.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "robot/description/model.h"
#include "robot/description/srdf.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

struct Anatomy {
  std::array<Sole, 2> soles;  // left, right: link, frame and edges; link -1 when not found
  std::array<Hand, 2> hands;  // left, right: link, frame, joints
  std::vector<Hand> more_hands;  // of a hand that no arm carries: its fingers
  std::array<std::string, 2> sole_sensor, hand_sensor;  // names of frames, empty when none is there
  std::vector<int> leg_joints;
  std::string imu_frame;            // a frame of the trunk
  double height = 0.0;              // lowest to highest point of the geometry [m]
  double hip_height = 0.0;          // of the first leg joint above the ground [m]
  std::vector<std::string> doubts;  // what was guessed or not found, for people
};

// Nothing throws: what is not found is said in doubts.  feet: sizes for feet without geometry, as an
// SRDF may give them; without these they are guessed from the length of the legs.
// turn: of the base, from the frame of its file to one that is upright and looks along x.
Anatomy find_anatomy(const Model& model, const std::array<SrdfFoot, 2>& feet = {},
                     const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity());

// Joints between the base and legs of five to seven joints, from the base on: of a robot whose base is above its waist.  Our controller
// balances legs that hang on the base.
std::vector<std::string> joints_above_legs(const Model& model);

// The posture nearest to zero within the limits [joint_count].
Eigen::VectorXd neutral_posture(const Model& model);
// Where its links are then, the base at the origin.
Kinematics at_rest(const Model& model);

// A posture to stand in: soles flat, knees a little bent, the centre of mass above the middle of the
// soles, legs that would all but touch a little apart; all other joints as they are in q, or as in neutral_posture when it is empty.  Needs model.soles; false when
// the legs cannot do it.
bool find_standing_posture(const Model& model, Eigen::VectorXd& q);

// How far the arms are from the legs in a posture [m], at most 0.08.
double arms_to_legs(const Model& model, const Anatomy& anatomy, const Eigen::VectorXd& q);
// How far the legs are from each other in a posture [m], at most 0.08.
double leg_to_leg(const Model& model, const std::array<Sole, 2>& soles, const Eigen::VectorXd& q);
// Turns arms that hang beside the legs outwards until they are 0.08 m from them, or as far as 0.5 rad do it; how far
// they were turned [rad].
double hold_arms_out(const Model& model, const Anatomy& anatomy, Eigen::VectorXd& q);
// Lifts the arms of a robot on a fixed base whose lowest point is less than 0.02 m above the ground, that need more than 0.8 of a
// joint's effort to be held, or that are boxed in by the robot itself, by the smallest turn of one of its joints, or of two by the same angle, that mends it.  What was turned, in words; empty when nothing was.
std::string lift_arms(const Model& model, const Anatomy& anatomy, Eigen::VectorXd& q);

}  // namespace twinbus::robot
