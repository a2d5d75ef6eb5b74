#include "test/bench/collision_cases.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "common/math/index.h"
#include "robot/description/load.h"

namespace twinbus {

namespace {

Model jvrc29() {
  const char* data = std::getenv("TWINBUS_DATA");
  const std::string folder =
      std::filesystem::absolute(data != nullptr ? data : "../shared/data").string() +
      "/robots/jvrc1";
  if (!std::filesystem::exists(folder)) {
    std::printf("no JVRC-1 (set TWINBUS_DATA): hrp1s instead\n");
    return load_robot("hrp1s");
  }
  Model model = load_urdf(folder + "/jvrc1.urdf", {{"jvrc1", folder}});
  for (Link& link : model.links) {
    for (const char* part : {"_LINDEX", "_LLITTLE", "_LTHUMB"}) {
      if (link.name.find(part) != std::string::npos) link.collision.clear();
    }
  }
  return model;
}

Model load(const std::string& robot, const std::string& package) {
  if (robot == "jvrc29") return jvrc29();
  if (!robot.ends_with(".urdf")) return load_robot(robot);
  const std::size_t equal = package.find('=');
  if (equal == std::string::npos) return load_urdf(robot, {});
  return load_urdf(robot, {{package.substr(0, equal), package.substr(equal + 1)}});
}

}  // namespace

Model load_case(const std::string& robot, const std::string& package, const std::string& drop) {
  Model model = load(robot, package);
  for (Link& link : model.links) {
    if (!drop.empty() && link.name.find(drop) != std::string::npos) link.collision.clear();
  }
  return model;
}

const Configuration& Postures::draw(bool near_home) {
  for (int j = 0; j < model_.joint_count(); ++j) {
    const Joint& joint = model_.joints[at(j)];
    const double low = std::max(joint.lower, -M_PI), high = std::min(joint.upper, M_PI);
    now_.q[j] = near_home ? std::clamp(0.15 * normal_(random_), low, high)
                          : low + (high - low) * uniform_(random_);
  }
  for (int j = 0; j < model_.joint_count(); ++j) {
    const Joint& joint = model_.joints[at(j)];
    if (joint.mimic >= 0)
      now_.q[j] = joint.mimic_multiplier * now_.q[joint.mimic] + joint.mimic_offset;
  }
  return now_;
}

}  // namespace twinbus
