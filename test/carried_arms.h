// A robot for tests, made of boxes: two arms of six joints on a lift, on a trolley whose wheels reach the ground.

#pragma once

#include <string>
#include <vector>

#include "common/text/formatted.h"
#include "robot/description/load.h"
#include "robot/onboarding/proposal.h"

namespace twinbus::test {

inline std::string box_link(const std::string& name, double x, double y, double z, double dx, double dy, double dz, double mass) {
  const double i = mass / 12.0;
  return formatted("<link name='%s'><inertial><origin xyz='%g %g %g'/><mass value='%g'/><inertia ixx='%g' iyy='%g' izz='%g' ixy='0' ixz='0' "
                   "iyz='0'/></inertial><collision><origin xyz='%g %g %g'/><geometry><box size='%g %g %g'/></geometry></collision></link>\n",
                   name.c_str(), x, y, z, mass, i * (dy * dy + dz * dz), i * (dx * dx + dz * dz), i * (dx * dx + dy * dy), x, y, z, dx, dy, dz);
}

inline std::string moving_joint(const std::string& name, const char* kind, const std::string& parent, const std::string& child, double x,
                                double y, double z, const char* axis, double lower, double upper) {
  return formatted("<joint name='%s' type='%s'><parent link='%s'/><child link='%s'/><origin xyz='%g %g %g'/><axis xyz='%s'/>"
                   "<limit lower='%g' upper='%g' effort='%g' velocity='%g'/></joint>\n",
                   name.c_str(), kind, parent.c_str(), child.c_str(), x, y, z, axis, lower, upper, kind[0] == 'p' ? 900.0 : 120.0,
                   kind[0] == 'p' ? 0.1 : 1.5);
}

inline std::string carried_arms_urdf() {
  std::string text = "<robot name='carried_arms'>\n" + box_link("trolley", 0.0, 0.0, 0.15, 0.5, 0.5, 0.3, 40.0) +
                     box_link("carriage", 0.0, 0.0, 0.0, 0.12, 0.2, 0.12, 6.0) +
                     moving_joint("lift", "prismatic", "trolley", "carriage", 0.0, 0.0, 0.6, "0 0 1", 0.0, 0.4);
  for (const double side : {1.0, -1.0}) {
    const std::string s = side > 0.0 ? "left_" : "right_";
    text += box_link(s + "shoulder", 0.0, 0.0, 0.0, 0.08, 0.08, 0.08, 1.5) + box_link(s + "upper_arm", 0.15, 0.0, 0.0, 0.22, 0.06, 0.06, 1.5) +
            box_link(s + "elbow", 0.0, 0.0, 0.0, 0.06, 0.06, 0.06, 0.5) + box_link(s + "forearm", 0.12, 0.0, 0.0, 0.18, 0.05, 0.05, 1.0) +
            box_link(s + "wrist", 0.0, 0.0, 0.0, 0.04, 0.04, 0.04, 0.3) + box_link(s + "hand", 0.06, 0.0, 0.0, 0.08, 0.06, 0.03, 0.3) +
            moving_joint(s + "shoulder_yaw", "revolute", "carriage", s + "shoulder", 0.0, 0.22 * side, 0.0, "0 0 1", -2.0, 2.0) +
            moving_joint(s + "shoulder_pitch", "revolute", s + "shoulder", s + "upper_arm", 0.0, 0.0, 0.0, "0 1 0", -1.6, 1.6) +
            moving_joint(s + "elbow_pitch", "revolute", s + "upper_arm", s + "elbow", 0.3, 0.0, 0.0, "0 1 0", -2.4, 2.4) +
            moving_joint(s + "forearm_roll", "revolute", s + "elbow", s + "forearm", 0.0, 0.0, 0.0, "1 0 0", -2.9, 2.9) +
            moving_joint(s + "wrist_pitch", "revolute", s + "forearm", s + "wrist", 0.25, 0.0, 0.0, "0 1 0", -2.0, 2.0) +
            moving_joint(s + "wrist_roll", "revolute", s + "wrist", s + "hand", 0.0, 0.0, 0.0, "1 0 0", -2.9, 2.9);
  }
  return text + "</robot>\n";
}

// A post with three arms of four joints around it, which robot.yaml calls east, north and west.
inline Model three_arms() {
  const std::vector<std::string> arms{"east", "north", "west"};
  std::string urdf = "<robot name='three_arms'>\n" + box_link("post", 0.0, 0.0, 0.4, 0.1, 0.1, 0.8, 20.0), yaml = "urdf: three_arms.urdf\nbase: fixed\nhands:\n";
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const std::string s = arms[i] + "_";
    const double x = i == 0 ? 0.1 : i == 2 ? -0.1 : 0.0, y = i == 1 ? 0.1 : 0.0;
    urdf += box_link(s + "turret", 0.0, 0.0, 0.0, 0.06, 0.06, 0.06, 1.0) + box_link(s + "upper", x < 0 ? -0.14 : x > 0 ? 0.14 : 0.0, y > 0 ? 0.14 : 0.0, 0.0, y > 0 ? 0.05 : 0.2, y > 0 ? 0.2 : 0.05, 0.05, 0.8) +
            box_link(s + "lower", x < 0 ? -0.14 : x > 0 ? 0.14 : 0.0, y > 0 ? 0.14 : 0.0, 0.0, y > 0 ? 0.04 : 0.2, y > 0 ? 0.2 : 0.04, 0.04, 0.5) +
            moving_joint(s + "turn", "revolute", "post", s + "turret", x, y, 0.7, "0 0 1", -1.5, 1.5) +
            moving_joint(s + "pitch", "revolute", s + "turret", s + "upper", 0.0, 0.0, 0.0, y > 0 ? "1 0 0" : "0 1 0", -1.5, 1.5) +
            moving_joint(s + "elbow", "revolute", s + "upper", s + "lower", x < 0 ? -0.26 : x > 0 ? 0.26 : 0.0, y > 0 ? 0.26 : 0.0, 0.0, y > 0 ? "1 0 0" : "0 1 0", -2.2, 2.2);
    yaml += "  " + arms[i] + ": {frame: " + s + "lower, at: [" + formatted("%g, %g", x < 0 ? -0.24 : x > 0 ? 0.24 : 0.0, y > 0 ? 0.24 : 0.0) +
            ", 0], joints: [" + s + "turn, " + s + "pitch, " + s + "elbow]}\n";
  }
  return load_robot_texts({.folder = ".", .yaml = yaml, .urdf = urdf + "</robot>\n", .srdf = ""});
}

inline Proposal carried_arms_proposal(const Model& bare, bool planar) {
  ProposalSource source;
  source.urdf_name = "carried_arms.urdf";
  source.planar = planar;
  source.floating = false;
  return propose(bare, source);
}

// As `check --propose` makes it.
inline Model carried_arms(bool planar) {
  UrdfRepairs repairs;
  const Model bare = load_repaired_urdf(carried_arms_urdf(), "carried_arms.urdf", {}, repairs);
  const Proposal proposal = carried_arms_proposal(bare, planar);
  return load_robot_texts({.folder = ".", .yaml = proposal.yaml, .urdf = carried_arms_urdf(), .srdf = proposal.srdf});
}

}  // namespace twinbus::test
