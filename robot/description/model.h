// A robot as the rest of twinbus sees it: a tree of links joined by moving joints, plus what
// robot.yaml adds.
//
// Links joined by fixed joints are merged at load, so link 0 is the base and link i > 0 is moved by
// joint i - 1; parents come before children.  Arrays of messages have bus order instead, which is
// the order of the URDF file and need not put parents first: always go through bus_joints or
// bus_index.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/shapes.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/description/loops.h"
#include "robot/description/mujoco_config.h"
#include "robot/description/walking_config.h"

namespace twinbus::inline robot {

enum class JointKind { kRevolute, kContinuous, kPrismatic };

struct Joint {
  std::string name;
  JointKind kind = JointKind::kRevolute;
  int parent = 0;  // link index
  int child = 0;   // link index, always joint index + 1
  Eigen::Isometry3d placement =
      Eigen::Isometry3d::Identity();  // joint frame at q = 0, in the parent link frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit, in the joint frame
  double lower = 0.0;                               // [rad or m]; -inf for continuous joints
  double upper = 0.0;
  double velocity = 0.0;       // limit [rad/s or m/s]
  double effort = 0.0;         // limit [N m or N]
  bool passive = false;        // without a motor: moved by spring, damper, friction and stops alone
  double spring = 0.0, spring_rest = 0.0;  // of a passive one [N m/rad or N/m], [rad or m]
  double damping = 0.0;        // [N m s/rad]
  double friction = 0.0;       // Coulomb [N m]
  double rotor_inertia = 0.0;  // reflected through the gear [kg m^2]
  double kp = 0.0;             // default gains, robot.yaml
  double kd = 0.0;
  double stop_kp = 0.0;  // gains of a hold stop
  double stop_kd = 0.0;
  double rate = 0.0;  // gate: largest change of a commanded position [rad/s]
  int mimic = -1;     // joint index it follows, -1 none; mimic joints are not on the bus
  double mimic_multiplier = 1.0;
  double mimic_offset = 0.0;
};

struct Link {
  std::string name;
  int parent = -1;                                    // link index
  double mass = 0.0;                                  // [kg]
  Eigen::Vector3d com = Eigen::Vector3d::Zero();      // in the link frame [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the com, link axes [kg m^2]
  std::vector<Shape> collision;
  std::vector<Shape> visual;  // what a picture shows; nothing is computed with it
};

// A link of the URDF, moving or fixed, where it ended up.
struct Frame {
  std::string name;
  int link = -1;
  Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();
};

// A flat rectangular sole.  Its frame has z up and x forward and lies on the ground when the foot
// stands flat.
struct Sole {
  int link = -1;
  std::string place;  // the link of the URDF that robot.yaml puts it in
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();   // in the link frame
  Eigen::Isometry3d sensor = Eigen::Isometry3d::Identity();  // force sensor, in the link frame
  double front = 0.0;  // from the frame's origin to the edges, all positive [m]
  double back = 0.0;
  double left = 0.0;
  double right = 0.0;
  double stiffness = 0.0;  // of the whole sole against the ground [N/m]
  double damping = 0.0;    // [N s/m]
  double friction = 0.0;   // Coulomb coefficient
};

struct Hand {
  std::string name;  // left, right, or as robot.yaml calls a further one
  int link = -1;
  std::string place;  // as of a sole
  Eigen::Isometry3d frame =
      Eigen::Isometry3d::Identity();  // what reach() places, in the link frame
  Eigen::Isometry3d sensor = Eigen::Isometry3d::Identity();
  std::vector<int> joints;  // of the arm, from shoulder to wrist
  // Joints that the arm hangs on and that may move for a goal which it does not reach by itself: of a base that moves on the plane, of
  // a lift; from the base of the robot on, no one left out.
  std::vector<int> carriers;
};

// Fingers of a hand that open and close together.
struct Gripper {
  std::vector<int> joints;           // of the model, each on the bus; none: no gripper
  std::vector<double> open, closed;  // [rad or m]
};

// What a hand carries: robot/hand/tools.h.
struct Tool {
  std::string name, frame;                                   // frame: a link of the URDF
  Eigen::Isometry3d offset = Eigen::Isometry3d::Identity();  // in that link
  std::string where;                                         // file, line and key
};

// Links that the robot's own shape keeps near each other: robot/collision/near_pairs.h.
struct NearPair {
  int link_a = 0, link_b = 0;
  double margin = 0.0;  // [m]
};

struct NamedPose {
  std::string name;
  std::vector<double> q;  // [joint_count]
};

enum class OffAction { kTorqueOff, kDamp };

struct Model {
  std::string name;
  std::string folder;         // where its files are
  std::vector<Joint> joints;  // all moving joints, mimic ones included
  std::vector<Link> links;    // links.size() == joints.size() + 1
  std::vector<Frame> frames;  // every link of the URDF, fixed ones included, in file order
  std::vector<int>
      bus_joints;  // actuated non-mimic joints: entry k is the joint with index k on the bus
  std::vector<int>
      bus_index;  // the inverse: entry j is the bus index of joint j, -1 when not on the bus
  std::array<Sole, 2> soles;  // left, right; link -1 when absent
  std::array<Hand, 2> hands;  // left, right; link -1 when absent
  std::array<Gripper, 2> grippers;  // left, right
  std::vector<Hand> more_hands;  // of a robot with other arms than a left and a right one, in the order of robot.yaml
  std::vector<int> plane_joints;  // x, y and turn of a base that moves on the plane z = 0; empty: it does not
  int imu_link = 0;
  std::string imu_place;  // as of a sole; empty: the base
  Eigen::Isometry3d imu = Eigen::Isometry3d::Identity();  // in its link's frame
  std::vector<int> leg_joints;  // of both legs: never masked while walking
  std::vector<NamedPose> poses;
  std::vector<std::array<int, 2>> disabled_pairs;  // link indices, SRDF disable_collisions
  std::vector<NearPair> near_pairs;  // without those that fixed joints make one link
  std::vector<Tool> tools;
  std::vector<Loop> loops;
  Walking walking;
  MujocoConfig mujoco;
  std::vector<std::pair<std::string, std::string>> packages;  // of mesh files: name, folder
  bool floating_base = true;

  std::int32_t period_ns = 2'000'000;
  double command_timeout = 0.040;  // [s]
  double state_timeout = 0.025;
  double guard_timeout = 0.030;
  double device_timeout = 0.050;
  double blend_s = 0.3;
  OffAction off_action = OffAction::kDamp;
  std::int64_t hash = 0;  // doc/protocol.md section 7, below 2^53

  std::vector<std::string> notes;  // what the files say that is not used, with file and line

  std::string urdf_text;  // as read, for MODEL_TEXT; all that is used of them is above
  std::string srdf_text;
  std::string yaml_text;

  int joint_count() const { return static_cast<int>(joints.size()); }
  int link_count() const { return static_cast<int>(links.size()); }
  int bus_count() const { return static_cast<int>(bus_joints.size()); }
  double period() const { return 1e-9 * period_ns; }
  double total_mass() const;
  // Index in joints / links / poses, or -1.
  int find_joint(const std::string& name) const;
  int find_link(const std::string& name) const;
  int find_pose(const std::string& name) const;
};

inline constexpr int kMostHands = 8;  // as ArmSide has

// 0 left, 1 right, from 2 on the further ones; left and right of a robot with one of them are that one, of one with neither the first
// of the others.  Null: it has none of that number.
inline const Hand* hand_of(const Model& model, int number) noexcept {
  const int more = static_cast<int>(model.more_hands.size());
  if (number >= 2) return number - 2 < more ? &model.more_hands[static_cast<std::size_t>(number - 2)] : nullptr;
  if (number < 0) return nullptr;
  for (const int one : {number, 1 - number}) {
    const Hand& hand = model.hands[static_cast<std::size_t>(one)];
    if (hand.link >= 0) return &hand;
  }
  return more > 0 ? model.more_hands.data() : nullptr;
}

// All that the robot has.
std::vector<const Hand*> hands_of(const Model& model);
// The number of one of its own, and that of an arm in messages.
int number_of(const Model& model, const Hand& hand) noexcept;
inline int number_of(ArmSide side) noexcept { return static_cast<int>(side) - 1; }

// The link of the URDF called so, in the link it was merged into.  Throws std::runtime_error that begins with `where`, with the
// nearest name.
const Frame& frame_called(const Model& model, const std::string& name, const std::string& where);

struct PassiveJoint {
  int joint = -1;
  double stiffness = 0.0;  // [N m/rad or N/m]
  double rest = 0.0;       // [rad or m]
};
// The joints without a motor.
std::vector<PassiveJoint> passive_joints_of(const Model& model);

}  // namespace twinbus::robot
