#include "launcher/check.h"

#include <cstdio>

#include "launcher/arguments.h"
#include "robot/load.h"

namespace twinbus {

int check_command(const std::vector<std::string>& words) {
  const Arguments arguments({"check",
                             "ROBOT",
                             "Loads a robot (a name in config/robots, or a folder) with every "
                             "check of its files, and prints mass,\n"
                             "joints, soles, hands and poses.  Exit status 1 with one line naming "
                             "file and remedy if it is refused.",
                             {},
                             1,
                             1},
                            words);
  const Model model = load_robot(arguments.word(0));
  std::printf("%s: %d joints (%d on the bus), %d links, %.1f kg, period %.1f ms, model hash %lld\n",
              model.name.c_str(), model.joint_count(), model.bus_count(), model.link_count(),
              model.total_mass(), 1e3 * model.period(), static_cast<long long>(model.hash));
  std::printf("%4s  %-28s %8s %8s %8s %8s %8s %7s\n", "bus", "joint", "lower", "upper", "rad/s",
              "N m", "kp", "kd");
  for (int k = 0; k < model.bus_count(); ++k) {
    const Joint& joint =
        model.joints[static_cast<std::size_t>(model.bus_joints[static_cast<std::size_t>(k)])];
    std::printf("%4d  %-28s %8.3f %8.3f %8.2f %8.1f %8.0f %7.0f\n", k, joint.name.c_str(),
                joint.lower, joint.upper, joint.velocity, joint.effort, joint.kp, joint.kd);
  }
  for (const int side : {0, 1}) {
    const char* name = side == 0 ? "left" : "right";
    const Sole& sole = model.soles[static_cast<std::size_t>(side)];
    if (sole.link >= 0) {
      std::printf("%s sole on %s: %.0f x %.0f mm, %.3g N/m, %.3g N s/m, friction %.2f\n", name,
                  model.links[static_cast<std::size_t>(sole.link)].name.c_str(),
                  1e3 * (sole.front + sole.back), 1e3 * (sole.left + sole.right), sole.stiffness,
                  sole.damping, sole.friction);
    }
    const Hand& hand = model.hands[static_cast<std::size_t>(side)];
    if (hand.link >= 0) {
      std::printf("%s hand on %s: arm of %zu joints\n", name,
                  model.links[static_cast<std::size_t>(hand.link)].name.c_str(),
                  hand.joints.size());
    }
  }
  std::printf("poses:");
  for (const NamedPose& pose : model.poses) std::printf(" %s", pose.name.c_str());
  std::printf("\n%zu pairs of links are declared never to touch\n", model.disabled_pairs.size());
  return 0;
}

}  // namespace twinbus
