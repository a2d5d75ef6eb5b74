// A running stack set up anew, as the page asks: another scene, the posture it begins in, pushes, and which pairs of links
// are checked for collision.
//
// A wish is a JSON text, SETUP/wish.json in the run folder.  It becomes what a user would write by hand: a scene file and a
// robot's folder (a copy whose SRDF has one more pose and other disabled pairs), both kept with the run, both read by the
// same strict readers.  Nothing else of the robot can be changed: its model hash stays.
//
//   {"scene": "stand", "engine": "ode", "pose": "half_sitting", "joints": {"WAIST_P": 0.1},
//    "pushes": [{"link": "CHEST", "at": 3, "impulse": [30, 0, 0], "duration": 0.1}],
//    "unchecked": [["A", "B"], ...]}          every key but scene may be left out; unchecked: all of them

#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace twinbus {

struct Setup {
  std::string scene;  // file
  std::string robot;  // folder or name
  std::string engine;
};

// Writes the files into folder and reads them back.  robot: name or folder of the robot that runs.  Throws
// std::runtime_error with one sentence that says what is wrong; files of an earlier wish may then be half replaced.
Setup write_setup(const std::string& wish, const std::string& robot, const std::string& folder);

// The SRDF text with these disabled pairs in the place of its own, and one more pose; no pose without joints.
std::string edited_srdf(const std::string& srdf, const std::string& robot,
                        const std::vector<std::array<std::string, 2>>& unchecked,
                        const std::string& pose,
                        const std::vector<std::pair<std::string, double>>& joints);

}  // namespace twinbus
