// What of a scene need not be modelled: joints and further robots that hardly move in it (`fidelity: auto`).
//
// What moves is seen in one run of everything.  A held joint errs by about the way that it moves the links behind it, so sets
// of joints are proposed by that way; whether a set holds an error is decided by a run, never by this guess.

#pragma once

#include <limits>
#include <string>
#include <vector>

#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus::inline launcher {

// What is left out of a run; empty: nothing.
struct Less {
  std::vector<std::string> held;   // joints
  std::vector<std::string> rigid;  // further robots
  std::vector<std::string> still;  // further robots, or `base`: all of the robot
  std::vector<std::string> untouched;  // links of the robot: by anything loose and further robots
  std::vector<std::string> aloft;      // the same: but for their soles by ground and obstacles
  bool apart = false;              // links of one robot do not touch one another, though the scene lets them
  bool asleep = false;             // loose bodies where they lie still
  bool operator==(const Less&) const = default;
  bool none() const { return *this == Less{}; }
};

// How far everything came from its start in a run.
struct Moved {
  bool operator==(const Moved&) const = default;
  std::vector<double> joints;              // [joint_count] [rad or m]
  std::vector<std::string> robots;         // further ones
  std::vector<double> robot_ways;          // of their bases [m]
  double links = std::numeric_limits<double>::infinity();  // of the robot's link that came farthest [m]
  std::vector<double> clear;               // by link: nothing loose and no further robot came nearer [m]; empty: not known
  std::vector<double> above;               // by link: nothing but its soles came nearer to ground and obstacles [m]; empty: not known
  double lay = 0.0;                        // share of the time of all loose bodies in which they lay still
};

// Sets that may hold the error [m], the largest first; none is empty and no two are equal.  Each is followed by what it would
// be with contact within robots, and with loose bodies awake, and with joints held and robots rigid where it has them still.
// apart: the scene lets links of a robot touch one another.
std::vector<Less> proposals(const Model& model, const Moved& moved, double error, bool apart = false);

// The way of the farthest link behind each joint for what the joint moved, all others at 0 [m].
std::vector<double> ways(const Model& model, const Moved& moved);

// The scene with that left out, beside what it leaves out itself.
Scene without(const Scene& scene, const Less& less);

// "18 joints held, robot other rigid"; empty for nothing.
std::string words_of(const Less& less);

}  // namespace twinbus::launcher
