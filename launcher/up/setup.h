// A running stack set up anew, as the page asks: another scene, the posture it begins in, pushes, and which pairs of links
// are checked for collision.
//
// A wish is a JSON text, SETUP/wish.json in the run folder.  It becomes what a user would write by hand: a scene file and a
// robot's folder (a copy with other soles, hands, IMU, disabled pairs and one more pose), both kept with the run, both read by the
// same strict readers.  Nothing else of the robot can be changed.
//
//   {"scene": "stand", "engine": "ode", "pose": "half_sitting", "joints": {"WAIST_P": 0.1},
//    "pushes": [{"link": "CHEST", "at": 3, "impulse": [30, 0, 0], "duration": 0.1}],
//    "unchecked": [["A", "B"], ...], "limbs": {see robot_copy.h}, "save": 7}
//
// Every key but scene may be left out; unchecked: all of them.  save: only the robot's folder is written, and nothing starts anew;
// its number, a whole one from 0 to 2^53, stands in the answer.  More than 8 brackets within each other are refused.

#pragma once

#include <cstdint>
#include <string>

namespace twinbus::inline launcher {

struct Setup {
  std::string scene;  // file
  std::string robot;  // folder or name
  std::string engine;
  std::int64_t model_hash = 0;  // of the robot
};

// Writes the files into folder and reads them back.  robot: name or folder of the robot that runs.  Throws
// std::runtime_error with one sentence that says what is wrong; the files of an earlier wish are then as they were.
Setup write_setup(const std::string& wish, const std::string& robot, const std::string& folder);

// The robot's folder of the wish alone, folder/saved/NAME, which no process has been started with; what it gives and throws as
// write_setup(), without scene and engine.
Setup save_robot(const std::string& wish, const std::string& robot, const std::string& folder);

// Whether it is a wish that only saves the robot, if with a wrong number.
bool only_saves(const std::string& wish);

// The number of such a wish.  Throws std::runtime_error where it is none.
std::int64_t save_number(const std::string& wish);

}  // namespace twinbus::launcher
