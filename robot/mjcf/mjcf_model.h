// An MJCF model as it is written, with defaults, angles and orientations resolved: bodies, joints, geoms, sites, actuators,
// keyframes.  mjcf_to_urdf.h makes a robot of it.
//
// Lengths [m], masses [kg], angles [rad]; frames of a body's parts are in the body, that of a body in its parent.

#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <string>
#include <vector>

#include "robot/mjcf/mjcf_compiler.h"
#include "robot/mjcf/mjcf_element.h"
#include "robot/description/mujoco_config.h"

namespace twinbus::inline robot {

enum class MjcfJointKind { kHinge, kSlide, kBall, kFree };

struct MjcfJoint {
  std::string name;
  MjcfJointKind kind = MjcfJointKind::kHinge;
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit
  bool limited = false;
  double lower = 0.0, upper = 0.0;  // of qpos [rad or m]
  double ref = 0.0;                 // qpos in the posture that is written
  double armature = 0.0, damping = 0.0, frictionloss = 0.0, stiffness = 0.0;
  double effort = std::numeric_limits<double>::infinity();  // actuatorfrcrange [N m or N]
  int qpos = 0;                                             // where its numbers begin in a keyframe
  MjcfElement element;                                      // for messages
};

enum class MjcfGeomKind { kPlane, kHeightField, kSphere, kCapsule, kEllipsoid, kCylinder, kBox, kMesh, kSdf };

// What a geom is to another one that it touches.
struct MjcfSurface {
  MujocoContact contact;  // its links are empty
  int priority = 0;
  double solmix = 1.0;
};

struct MjcfGeom {
  std::string name;
  MjcfGeomKind kind = MjcfGeomKind::kSphere;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // as in MJCF: radii, half lengths
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  int mesh = -1;        // index in MjcfModel::meshes; a kind other than kMesh is fitted to it
  bool touches = true;  // by contype, conaffinity or a <pair>
  int group = 0;
  double friction = 1.0;  // sliding; of a <pair> with the ground, where there is one
  MjcfSurface surface;    // once read: with the ground, by a <pair> or as both are put together; its own where there is no ground
  double mass = std::numeric_limits<double>::quiet_NaN();  // NaN: by density
  double density = 1000.0;                                // [kg/m^3]
  MjcfElement element;
};

struct MjcfSite {
  std::string name;
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
};

struct MjcfInertia {
  double mass = 0.0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Matrix3d about_com = Eigen::Matrix3d::Zero();  // in the body's axes [kg m^2]
};

struct MjcfBody {
  std::string name;
  int parent = -1;  // 0 is the world
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  std::vector<MjcfJoint> joints;
  std::vector<MjcfGeom> geoms;
  std::vector<MjcfSite> sites;
  bool has_inertial = false;
  MjcfInertia inertia;  // of <inertial>
  bool mocap = false;
  double gravcomp = 0.0;
  MjcfElement element;
};

struct MjcfMesh {
  std::string name, file;  // file: full name, empty without one
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Isometry3d ref = Eigen::Isometry3d::Identity();  // refpos, refquat
  std::vector<Eigen::Vector3d> points;                    // of a mesh that is written in the model
  int inertia = 2;                                        // convex, exact, legacy, shell
  MjcfElement element;
};

// What drives a joint, at the joint: force = kp (target - q) - kd qd, cut at effort.
struct MjcfActuator {
  std::string joint;
  double kp = 0.0, kd = 0.0;
  double effort = std::numeric_limits<double>::infinity();
  MjcfElement element;
};

struct MjcfKey {
  std::string name;
  std::vector<double> qpos;
  MjcfElement element;
};

// joint = offset + multiplier * follows, by an equality.
struct MjcfMimic {
  std::string joint, follows;
  double offset = 0.0, multiplier = 1.0;
};

struct MjcfModel {
  std::string name, folder;
  MjcfCompiler compiler;
  std::vector<MjcfBody> bodies;  // [0] is the world; parents come first
  std::vector<MjcfMesh> meshes;
  std::vector<MjcfActuator> actuators;
  std::vector<MjcfKey> keys;
  std::vector<MjcfMimic> mimics;
  std::vector<std::pair<std::string, std::string>> excludes;  // bodies that never touch
  std::string imu_site;                                       // of a gyro or accelerometer
  int qpos_count = 0;
  MujocoConfig option;  // without contacts
  std::vector<std::string> notes;  // what is not read or not modelled

  int find_body(const std::string& body) const;
};

// Throws std::runtime_error, one line with file and line: what MuJoCo would refuse too, and what no robot here can have
// (deformable bodies, loops, references to what is not there).
MjcfModel read_mjcf_model(const std::string& file);
MjcfModel read_mjcf_model_text(const std::string& text, const std::string& file);

}  // namespace twinbus::robot
