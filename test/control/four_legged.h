// A robot on four or two point feet made of boxes and balls, in any size, proposed and loaded as a stranger's is.

#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "robot/description/load.h"
#include "robot/onboarding/proposal.h"
#include "test/temporary_folder.h"

namespace twinbus::test {

// size: 1 is 0.2 m of thigh and shank and 12 kg.
inline std::string point_legged_urdf(double size, int legs) {
  const double mass = size * size * size;
  char text[1600];
  std::string urdf = "<robot name=\"four\">\n";
  const auto link = [&](const std::string& name, double m, const std::array<double, 3>& com, const std::array<double, 3>& box,
                        double ball) {
    const double w = mass * m;
    const auto inertia = [&](double a, double b) { return w / 12.0 * (a * a + b * b) * size * size; };
    std::snprintf(text, sizeof text,
                  "<link name=\"%s\"><inertial><origin xyz=\"%g %g %g\"/><mass value=\"%g\"/><inertia ixx=\"%g\" iyy=\"%g\" "
                  "izz=\"%g\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial><collision><origin xyz=\"%g %g %g\"/><geometry>"
                  "<box size=\"%g %g %g\"/></geometry></collision>",
                  name.c_str(), com[0] * size, com[1] * size, com[2] * size, w, inertia(box[1], box[2]), inertia(box[0], box[2]),
                  inertia(box[0], box[1]), com[0] * size, com[1] * size, com[2] * size, box[0] * size, box[1] * size, box[2] * size);
    urdf += text;
    if (ball > 0.0) {
      std::snprintf(text, sizeof text, "<collision><origin xyz=\"0 0 %g\"/><geometry><sphere radius=\"%g\"/></geometry></collision>",
                    -0.2 * size, ball * size);
      urdf += text;
    }
    urdf += "</link>\n";
  };
  const auto joint = [&](const std::string& name, const std::string& parent, const std::string& child, const char* axis, double x,
                         double y, double z, double lower, double upper) {
    std::snprintf(text, sizeof text,
                  "<joint name=\"%s\" type=\"revolute\"><parent link=\"%s\"/><child link=\"%s\"/><origin xyz=\"%g %g %g\"/><axis "
                  "xyz=\"%s\"/><limit lower=\"%g\" upper=\"%g\" effort=\"%g\" velocity=\"25\"/></joint>\n",
                  name.c_str(), parent.c_str(), child.c_str(), x * size, y * size, z * size, axis, lower, upper,
                  30.0 * mass * size);
    urdf += text;
  };
  link("trunk", 6.0, {0, 0, 0}, {0.4, 0.2, 0.1}, 0.0);
  const std::vector<std::tuple<const char*, double, double>> four{{"fl", 1.0, 1.0}, {"fr", 1.0, -1.0}, {"hl", -1.0, 1.0}, {"hr", -1.0, -1.0}};
  const std::vector<std::tuple<const char*, double, double>> two{{"left", 0.0, 1.0}, {"right", 0.0, -1.0}};
  for (const auto& [name, x, y] : legs == 4 ? four : two) {
    const std::string n = name;
    link(n + "_hip", 0.5, {0, 0.02 * y, 0}, {0.06, 0.05, 0.06}, 0.0);
    link(n + "_thigh", 0.8, {0, 0, -0.06}, {0.04, 0.03, 0.14}, 0.0);
    link(n + "_shank", 0.2, {0, 0, -0.09}, {0.02, 0.02, 0.16}, 0.02);
    joint(n + "_abduct", "trunk", n + "_hip", "1 0 0", 0.19 * x, 0.06 * y, 0.0, -0.9, 0.9);
    joint(n + "_swing", n + "_hip", n + "_thigh", "0 1 0", 0.0, 0.08 * y, 0.0, -1.5, 3.0);
    joint(n + "_knee", n + "_thigh", n + "_shank", "0 1 0", 0.0, 0.0, -0.2, -2.7, -0.7);
  }
  return urdf + "</robot>\n";
}

// The folder lives until the program ends.
inline const Model& point_legged(double size, int legs) {
  static TemporaryFolder folder;
  static std::vector<std::pair<std::pair<double, int>, std::unique_ptr<Model>>> made;
  for (const auto& [of, model] : made) {
    if (of == std::pair{size, legs}) return *model;
  }
  const std::string urdf = point_legged_urdf(size, legs);
  ProposalSource source;
  source.urdf_name = "four.urdf";
  folder.write("bare.urdf", urdf);
  const Model bare = load_urdf(folder.path() + "/bare.urdf", {});
  const Proposal proposal = propose(bare, source);
  static std::vector<std::unique_ptr<TemporaryFolder>> folders;
  folders.push_back(std::make_unique<TemporaryFolder>());
  folders.back()->write("robot.yaml", proposal.yaml);
  folders.back()->write("four.srdf", proposal.srdf);
  folders.back()->write("four.urdf", urdf);
  made.emplace_back(std::pair{size, legs}, std::make_unique<Model>(load_robot(folders.back()->path())));
  return *made.back().second;
}

inline const Model& four_legged(double size) { return point_legged(size, 4); }

}  // namespace twinbus::test
