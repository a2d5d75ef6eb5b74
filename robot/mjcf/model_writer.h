// A Model as MJCF or URDF, from its numbers alone: what MuJoCo or Drake simulate.
//
// Meshes are handed back as triangles to be written beside it, since both want other files than a robot may have (MuJoCo reads
// no DAE and takes the convex hull of what touches).

#pragma once

#include <map>
#include <string>

#include "geometry/shapes.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

// Meshes that a written model names: the name of the file without ending, and what to write there.
class ExportedMeshes {
 public:
  // The name under which this mesh, at this scale, is to be written.
  std::string name_of(const Shape& shape);
  const std::map<std::string, Shape>& all() const { return names_; }

 private:
  std::map<std::string, Shape> names_;
};

// How friction of two bodies is put together is another rule in MuJoCo, the larger of both, than here, the geometric mean:
// with the ground's at 0 and each body's put together with it beforehand, contacts with the ground have ours.
struct MjcfContact {
  double ground_friction = 0.8;
  double link_friction = 0.6;  // of links that are no soles, where robot.yaml says nothing under `mujoco`
  std::string robot_bits;      // contype and conaffinity of its geoms; empty: MuJoCo's own
  std::string foot_bits;       // of shapes of links that have a sole, beside it
};

// What of it is written.
struct MjcfParts {
  bool visual = true;      // shapes that touch nothing
  bool placeable = false;  // a robot without a floating base can be put elsewhere: its base is a mocap body
  bool drives = true;      // damping of joints, limits of their efforts, servos
};

struct MjcfText {
  std::string body;      // <body> of the robot, for <worldbody>
  std::string contact;   // <exclude> elements
  std::string equality;  // of joints that follow others
  std::string actuator;  // position servos with the gains of robot.yaml, motors where there are none
  std::string sensor;    // gyro, accelerometer, framequat at the IMU
  // Geoms that touch: name and whose they are.
  struct Geom {
    int link;
    int sole;  // 0 left, 1 right, -1 none
  };
  std::map<std::string, Geom> geoms;
};

inline constexpr const char* kMjcfBase = "floating_base";  // name of the free joint

// base: of link 0 in the world.  indent: of the body.
MjcfText mjcf_of_model(const Model& model, const Eigen::Isometry3d& base, const MjcfContact& contact, ExportedMeshes& meshes,
                       const MjcfParts& parts = {});

// One geom; friction as MuJoCo is to have it.  attributes: further ones.
std::string mjcf_geom(const Shape& shape, const std::string& attributes, ExportedMeshes& meshes);
// pos and quat.
std::string mjcf_place(const Eigen::Isometry3d& place);

// Links, joints, limits, friction, inertias, rotors as transmissions with drake:rotor_inertia; frames as fixed links.
std::string urdf_of_model(const Model& model, ExportedMeshes& meshes);

// The triangles of one mesh as OBJ, scaled.
std::string obj_of(const Shape& mesh);
// The triangles of its convex hull; of the mesh where it has none.
std::string obj_of_hull(const Shape& mesh);

}  // namespace twinbus::robot
