// SRDF: named poses (group_state), pairs of links whose contact is no collision
// (disable_collisions), rotors (rotor_params).

#pragma once

#include <string>
#include <utility>
#include <vector>

namespace twinbus {

struct SrdfPose {
  std::string name;
  int line = 0;
  std::vector<std::pair<std::string, double>> joints;  // name, [rad or m]
};

struct SrdfPair {
  std::string link_a, link_b;
  int line = 0;
};

// <rotor_params>, as Pinocchio writes them.
struct SrdfRotor {
  std::string joint;
  int line = 0;
  double reflected_inertia = 0.0;  // at the joint: gear ratio^2 times that of the rotor [kg m^2]
};

struct Srdf {
  std::vector<SrdfPose> poses;  // group states of one name are put together
  std::vector<SrdfPair> disabled;
  std::vector<SrdfRotor> rotors;
};

// Throws std::runtime_error naming file, line and element.
Srdf parse_srdf(const std::string& text, const std::string& file);

}  // namespace twinbus
