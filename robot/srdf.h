// SRDF: named poses (group_state) and pairs of links whose contact is no collision
// (disable_collisions).

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

struct Srdf {
  std::vector<SrdfPose> poses;  // group states of one name are put together
  std::vector<SrdfPair> disabled;
};

// Throws std::runtime_error naming file, line and element.
Srdf parse_srdf(const std::string& text, const std::string& file);

}  // namespace twinbus
