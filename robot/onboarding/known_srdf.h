// What of an SRDF that is already there fits a robot: poses, disabled pairs, rotors, sizes of feet.

#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "robot/description/model.h"
#include "robot/description/srdf.h"

namespace twinbus::inline robot {

struct KnownSrdf {
  std::vector<NamedPose> poses;  // joints that are not named are as in the neutral posture
  std::vector<std::pair<std::string, std::string>> disabled;
  std::vector<SrdfRotor> rotors;
  std::array<SrdfFoot, 2> feet;
  std::vector<std::string> doubts;  // what was left out, and why
};

// Nothing throws: an SRDF that cannot be read is a doubt.  An empty text is no SRDF.  origin: what it is, for doubts.
KnownSrdf fit_srdf(const Model& model, const std::string& text, const std::string& file,
                   const std::string& origin = "the SRDF that was there");

// Whether the robot stands in a posture [joint_count]: soles flat and level, base upright, centre of
// mass well above them.  Empty, or why not.
std::string why_it_falls(const Model& model, const Eigen::VectorXd& q);

}  // namespace twinbus::robot
