// What the MuJoCo model of a robot says of the solver and of contacts: the map `mujoco` of robot.yaml.
//
// Engine mujoco and `export --to mjcf` use it, nobody else; an export leaves iterations and ls_iterations out, since its implicit
// integrator wants contacts that are solved to the end.  A robot without it has MuJoCo's defaults.  Not part of the model's
// hash: it is the same robot whatever simulates it.

#pragma once

#include <array>
#include <string>
#include <vector>

namespace twinbus::inline common {
class ConfigNode;
}  // namespace twinbus::common

namespace twinbus::inline robot {

struct Model;

// Of links with the ground, in MuJoCo's words; it is written on their geoms, so obstacles and loose bodies meet it too.
struct MujocoContact {
  std::vector<std::string> links;  // of the URDF, fixed ones included
  std::array<double, 3> friction{1.0, 0.005, 0.0001};  // sliding, spinning [m], rolling [m]; on a ground of kMujocoGround
  int condim = 3;
  std::array<double, 2> solref{0.02, 1.0};
  std::array<double, 5> solimp{0.9, 0.95, 0.001, 0.5, 2.0};

  bool same_but_links(const MujocoContact& other) const {
    return friction == other.friction && condim == other.condim && solref == other.solref && solimp == other.solimp;
  }
};

// The ground of a scene that does not say `contact.friction`; another one scales friction by the root of their ratio.
inline constexpr double kMujocoGround = 0.8;

struct MujocoConfig {
  // Of the solver, at most; 0: as many as MuJoCo does by itself.  A model of which a policy was trained with one iteration behaves
  // otherwise when its contacts are solved to the end.
  int iterations = 0, ls_iterations = 0, noslip_iterations = 0;
  bool elliptic = false;  // cone: elliptic, else pyramidal
  double impratio = 1.0;
  std::vector<MujocoContact> contacts;

  // That of the link with this index, null where nothing is said; of several the one with the most friction.
  const MujocoContact* of_link(const Model& model, int link) const;
};

// Throws std::runtime_error naming file, line and key.
MujocoConfig read_mujoco_config(const ConfigNode& node);
// The map as text, with its comment; empty where everything is MuJoCo's default.
std::string mujoco_yaml(const MujocoConfig& config);

}  // namespace twinbus::robot
