// SRDF: named poses (group_state), pairs of links whose contact is no collision
// (disable_collisions), rotors (rotor_params), sizes of feet (specificities).

#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace twinbus::inline robot {

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

// <specificities><feet>: only used to propose soles.
struct SrdfFoot {
  bool present = false;
  double length = 0.0, width = 0.0;  // [m]; the longer edge is the length
  // Of the ankle, seen from the middle of the foot on the ground [m].
  double ankle_forward = 0.0, ankle_left = 0.0, ankle_height = 0.0;
};

struct Srdf {
  std::vector<SrdfPose> poses;  // group states of one name are put together
  std::vector<SrdfPair> disabled;
  std::vector<SrdfRotor> rotors;
  std::array<SrdfFoot, 2> feet;    // left, right
  std::vector<std::string> notes;  // what is ignored, with file and line
};

// Throws std::runtime_error naming file, line and element.
Srdf parse_srdf(const std::string& text, const std::string& file);

}  // namespace twinbus::robot
