#include "robot/onboarding/base_turn.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "robot/onboarding/anatomy.h"
#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus {

namespace {

constexpr std::size_t kJointsOfLegs = 12;  // of both

}  // namespace

int side_of_name(const std::string& name) {
  std::string lower = "_" + name + "_";
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  // Whole words first: the R of LLEG_ANKLE_R is for roll.
  for (const auto& [left, right] :
       std::initializer_list<std::pair<const char*, const char*>>{{"left", "right"},
                                                                  {"_lleg", "_rleg"},
                                                                  {"_lfoot", "_rfoot"},
                                                                  {"_lankle", "_rankle"},
                                                                  {"_l_", "_r_"}}) {
    const std::size_t l = lower.find(left);
    const std::size_t r = lower.find(right);
    if (l != r) return l < r ? 1 : -1;
  }
  return 0;
}

Eigen::Matrix3d find_base_turn(const Model& model) {
  const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
  const auto legs_named = [&](const Eigen::Matrix3d& turn) {  // 1: as they lie, -1: crosswise
    const Anatomy found = find_anatomy(model, {}, turn);
    if (found.soles[0].link < 0 || found.leg_joints.size() < kJointsOfLegs) return -2;
    const int left = side_of_name(model.links[at(found.soles[0].link)].name);
    const int right = side_of_name(model.links[at(found.soles[1].link)].name);
    return left == -right ? left : 0;
  };
  const int as_it_is = legs_named(none);
  if (as_it_is >= 0 || model.joint_count() < static_cast<int>(kJointsOfLegs)) return none;
  const Eigen::Matrix3d y_up = rotation_about(Eigen::Vector3d::UnitX(), 0.5 * std::numbers::pi);
  for (const Eigen::Matrix3d& up : {none, y_up}) {
    for (const double heading :
         {0.0, std::numbers::pi, 0.5 * std::numbers::pi, -0.5 * std::numbers::pi}) {
      const Eigen::Matrix3d turn = rotation_z(heading) * up;
      if (legs_named(turn) == 1) return turn;
    }
  }
  return none;
}

std::string with_upright_base(const std::string& urdf_text, const std::string& root_link,
                              const Eigen::Matrix3d& turn) {
  const std::size_t end = urdf_text.rfind("</robot>");
  if (end == std::string::npos) return urdf_text;
  const Eigen::Vector3d rpy = rpy_from_rotation(turn);
  char origin[120];
  std::snprintf(origin, sizeof(origin), "%.9f %.9f %.9f", rpy.x(), rpy.y(), rpy.z());
  std::string text = urdf_text.substr(0, end);
  text += "  <!-- Added by `twinbus check`: z up, x forward. -->\n";
  text += "  <link name=\"upright_base\"/>\n";
  text += "  <joint name=\"upright_base_turn\" type=\"fixed\">\n";
  text += std::string("    <origin xyz=\"0 0 0\" rpy=\"") + origin + "\"/>\n";
  text += "    <parent link=\"upright_base\"/>\n    <child link=\"" + root_link + "\"/>\n";
  text += "  </joint>\n";
  return text + urdf_text.substr(end);
}

}  // namespace twinbus
