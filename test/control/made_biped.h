// A robot on two legs made of boxes, with joints and feet as a test asks for them, proposed and loaded as a stranger's is.

#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robot/description/load.h"
#include "robot/onboarding/proposal.h"
#include "test/temporary_folder.h"

namespace twinbus::test {

enum class FootShape { kBox, kLyingAlong, kLyingAcross };  // a cylinder lies

struct MadeBiped {
  std::string joints = "yrpkao";  // from the base: yaw, roll and pitch of a hip, knee, ankle's pitch and roll
  FootShape shape = FootShape::kBox;
  double length = 0.16, width = 0.12;  // of a foot; a cylinder is as long, its radius is the width [m]
  double toe_effort = -1.0;            // of a toe before the foot [N m]; 0: no motor drives it; < 0: there is none
  std::string springs{};               // of the toes in robot.yaml, instead of what is proposed
  std::string more{};                  // lines of robot.yaml
};

inline std::string made_biped_urdf(const MadeBiped& made) {
  std::array<char, 600> text{};
  std::string urdf = "<robot name=\"made\">\n";
  const auto place = [&](const char* key, double x, double y, double z, const char* rpy = "0 0 0") {
    std::snprintf(text.data(), text.size(), "<%s xyz=\"%g %g %g\" rpy=\"%s\"/>", key, x, y, z, rpy);
    return std::string(text.data());
  };
  const auto link = [&](const std::string& name, double m, std::array<double, 3> com, std::array<double, 3> box,
                        const std::string& collision) {
    const auto about = [&](double a, double b) { return m / 12.0 * (a * a + b * b); };
    urdf += "<link name=\"" + name + "\"><inertial>" + place("origin", com[0], com[1], com[2]);
    std::snprintf(text.data(), text.size(), "<mass value=\"%g\"/><inertia ixx=\"%g\" iyy=\"%g\" izz=\"%g\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>", m,
                  about(box[1], box[2]), about(box[0], box[2]), about(box[0], box[1]));
    urdf += text.data() + ("</inertial>" + collision) + "</link>\n";
  };
  const auto shape = [&](const std::string& origin, const char* format, double a, double b, double c) {
    std::snprintf(text.data(), text.size(), format, a, b, c);
    return "<collision>" + origin + "<geometry>" + text.data() + "</geometry></collision>";
  };
  const auto box = [&](double x, double z, double a, double b, double c) {
    return shape(place("origin", x, 0.0, z), "<box size=\"%g %g %g\"/>", a, b, c);
  };
  const auto joint = [&](const std::string& name, const std::string& parent, const std::string& child, const char* axis,
                         std::array<double, 3> at, double lower, double upper, double effort) {
    urdf += "<joint name=\"" + name + "\" type=\"revolute\"><parent link=\"" + parent + "\"/><child link=\"" + child + "\"/>" +
            place("origin", at[0], at[1], at[2]);
    std::snprintf(text.data(), text.size(), "<axis xyz=\"%s\"/><limit lower=\"%g\" upper=\"%g\" effort=\"%g\" velocity=\"15\"/></joint>\n", axis,
                  lower, upper, effort);
    urdf += text.data();
  };
  const auto foot = [&](double sole) {
    if (made.shape == FootShape::kBox) return box(0.02, sole + 0.02, made.length, made.width, 0.04);
    const char* turned = made.shape == FootShape::kLyingAlong ? "0 1.5707963267948966 0" : "1.5707963267948966 0 0";
    return shape(place("origin", 0.0, 0.0, sole + made.width, turned), "<cylinder radius=\"%g\" length=\"%g\"/>", made.width, made.length, 0.0);
  };
  link("trunk", 30.0, {0, 0, 0.15}, {0.2, 0.3, 0.4}, box(0.0, 0.2, 0.2, 0.28, 0.36));
  for (const double side : {1.0, -1.0}) {
    const std::string prefix = side > 0.0 ? "left_" : "right_";
    std::string parent = "trunk";
    std::array<double, 3> at{0.0, 0.09 * side, 0.0};
    for (const char& kind : made.joints) {
      const bool last = &kind == &made.joints.back();
      const std::string name = prefix + (kind == 'y'   ? "hip_yaw"
                                         : kind == 'r' ? "hip_roll"
                                         : kind == 'p' ? "hip_pitch"
                                         : kind == 'k' ? "knee"
                                         : kind == 'a' ? "ankle_pitch"
                                                       : "ankle_roll");
      const char* axis = kind == 'y' ? "0 0 1" : kind == 'r' || kind == 'o' ? "1 0 0" : "0 1 0";
      const double lower = kind == 'p' ? -1.8 : kind == 'k' ? 0.0 : kind == 'a' ? -1.2 : -0.6;
      const double upper = kind == 'p' ? 1.0 : kind == 'k' ? 2.4 : kind == 'a' ? 0.9 : 0.6;
      joint(name, parent, name + "_link", axis, at, lower, upper, 120.0);
      const bool bone = kind == 'p' || kind == 'k';
      const double sole = bone ? -0.35 : -0.07;
      std::string collision = bone ? box(0.0, -0.15, 0.06, 0.06, 0.2) : "";
      if (last) collision += foot(sole);
      const std::array<double, 3> com{last && !bone ? 0.02 : 0.0, 0.0, bone ? -0.15 : last ? -0.04 : 0.0};
      link(name + "_link", bone ? 2.5 : last ? 1.1 : 0.5, com, {0.07, 0.07, bone ? 0.3 : 0.07}, collision);
      parent = name + "_link";
      at = {0.0, 0.0, bone ? -0.30 : 0.0};
      if (!last || made.toe_effort < 0.0) continue;
      link(prefix + "toe_link", 0.15, {0.03, 0, 0}, {0.06, 0.1, 0.02}, box(0.03, 0.0, 0.06, made.width, 0.02));
      joint(prefix + "toe", parent, prefix + "toe_link", "0 1 0", {0.02 + 0.5 * made.length, 0.0, sole + 0.01}, -0.8, 0.3, made.toe_effort);
    }
  }
  return urdf + "</robot>\n";
}

// Its folder is gone, its model is whole.
struct ProposedBiped {
  explicit ProposedBiped(const MadeBiped& made) {
    const TemporaryFolder folder;
    const std::string urdf = made_biped_urdf(made);
    ProposalSource source;
    source.urdf_name = "made.urdf";
    proposal = propose(load_urdf(folder.write("made.urdf", urdf), {}), source);
    std::string yaml = proposal.yaml;
    if (const std::size_t from = yaml.find("passive_joints:"); !made.springs.empty() && from != std::string::npos) {
      yaml.replace(from, yaml.find("\n\n", from) - from,
                   "passive_joints:\n  - {joints: [left_toe, right_toe], " + made.springs + "}\n");
    }
    folder.write("robot.yaml", yaml + made.more);
    folder.write("made.srdf", proposal.srdf);
    model = load_robot(folder.path());
  }
  bool says(const std::string& words) const {
    for (const std::string& doubt : proposal.doubts) {
      if (doubt.find(words) != std::string::npos) return true;
    }
    return false;
  }
  Proposal proposal;
  Model model;
};

}  // namespace twinbus::test
