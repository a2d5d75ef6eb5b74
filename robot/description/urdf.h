// A URDF file as it is written: links and joints, fixed ones included.  load.h makes a Model of it.
//
// urdfdom accepts weightless links, cycles beside a root and axes of any length, and tells no line,
// so the XML is checked here before urdfdom reads it.

#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "common/text/xml.h"
#include "robot/names/asset_path.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

struct UrdfLink {
  std::string name;
  int line = 0;
  int parent_joint = -1;                                       // -1 for the root
  double mass = 0.0;                                           // [kg]; 0 without <inertial>
  Eigen::Isometry3d inertial = Eigen::Isometry3d::Identity();  // CoM frame, in the link frame
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the CoM, in the CoM frame [kg m^2]
  std::vector<Shape> collision, visual;
};

struct UrdfJoint {
  std::string name;
  int line = 0;
  bool fixed = false;
  JointKind kind = JointKind::kRevolute;
  int parent = 0;  // link index
  int child = 0;
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double lower = 0.0, upper = 0.0, velocity = 0.0, effort = 0.0;
  double damping = 0.0, friction = 0.0;
  double rotor_inertia = 0.0;  // of its transmission, at the joint [kg m^2]
  std::string mimic;           // name of the joint it follows
  double mimic_multiplier = 1.0, mimic_offset = 0.0;
};

struct UrdfTree {
  std::string name;
  std::vector<UrdfLink> links;    // in document order
  std::vector<UrdfJoint> joints;  // in document order
  int root = 0;
  std::vector<std::string> notes;  // what could not be used and does no harm, with file and line
};

// A base that moves on the plane, such as one on omnidirectional wheels: three joints with servos between the ground and the root link.
// Nothing rolls; the wheels stand a little above the ground.
struct PlaneBase {
  double area = 3.0;        // it moves so far from where it begins, along x and along y [m]
  double speed = 0.5;       // along x, and along y [m/s]
  double turn_speed = 1.0;  // [rad/s]
  double height = 0.0;      // of the root link's frame above the ground [m]
};

// Of these joints, x first.
inline constexpr const char* kPlaneJoints[3] = {"base_x", "base_y", "base_yaw"};

// The URDF with them (planar_base.cpp), or as it is if it has them already.  Throws as parse_urdf does when a name is taken.
std::string with_plane_joints(const std::string& text, const std::string& file, const PlaneBase& base);

// file: for messages.  Throws std::runtime_error, one line naming file, line and element.
UrdfTree parse_urdf(const std::string& text, const std::string& file, const AssetRoots& roots);

// The checks alone, on the XML (urdf_check.cpp).  Throws on the first element that is wrong; notes gets what is ignored.
void check_urdf(const XmlElement& robot, const std::string& file, std::vector<std::string>& notes);

}  // namespace twinbus::robot
