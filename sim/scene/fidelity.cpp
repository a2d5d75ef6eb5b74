#include "sim/scene/fidelity.h"

#include <algorithm>
#include <stdexcept>

#include "common/math/index.h"
#include "common/text/closest_name.h"
#include "sim/world/weld.h"

namespace twinbus::inline sim {

namespace {

template <class Named>
[[noreturn]] void not_there(const Scene& scene, const char* key, const std::string& what, const std::string& name,
                            const std::vector<Named>& names) {
  throw std::runtime_error("scene " + scene.name + ": " + key + ": there is no " + what + " '" + name + "'" + suggestion(name, names));
}

std::size_t find_robot(const WorldConfig& config, const std::string& name) {
  const auto named = [&](const OtherRobot& robot) { return robot.name == name; };
  return static_cast<std::size_t>(std::find_if(config.robots.begin(), config.robots.end(), named) - config.robots.begin());
}

// A name that fits nothing, or two things.
[[noreturn]] void refuse_held(const Scene& scene, const Model& model, const WorldConfig& config, const std::string& name) {
  std::vector<std::string> fits, known{"base"};
  if (name == "base") fits.push_back("the base");
  if (model.find_joint(name) >= 0) fits.push_back("a joint");
  if (find_robot(config, name) < config.robots.size()) fits.push_back("a further robot");
  if (fits.size() > 1)
    throw std::runtime_error("scene " + scene.name + ": held: '" + name + "' is " + fits[0] + " and " + fits[1] +
                             "; give one of them another name");
  for (const OtherRobot& robot : config.robots) known.push_back(robot.name);
  for (const Joint& joint : model.joints) known.push_back(joint.name);
  throw std::runtime_error("scene " + scene.name + ": held: there is no joint or further robot '" + name + "'" +
                           suggestion(name, known));
}

int link_of(const Scene& scene, const Model& model, const char* key, const std::string& name) {
  const int link = model.find_link(name);
  if (link >= 0) return link;
  std::vector<std::string> links;
  for (const Link& each : model.links) links.push_back(each.name);
  throw std::runtime_error("scene " + scene.name + ": " + key + ": there is no link '" + name + "'" + suggestion(name, links));
}

void add_shapes(const Model& model, int link, std::vector<std::array<int, 2>>& to) {
  const int shapes = static_cast<int>(model.links[at(link)].collision.size());
  for (int shape = 0; shape < shapes; ++shape) to.push_back({link, shape});
}

}  // namespace

void apply_fidelity(const Scene& scene, const Model& model, WorldConfig& config) {
  config.held.clear();
  config.rigid_robots.clear();
  config.aloft.clear();
  config.untouched.clear();
  if (scene.fidelity == "rigid") config.held.assign(model.joints.size(), true);
  if (scene.fidelity == "legs") {
    if (model.leg_joints.empty())
      throw std::runtime_error("scene " + scene.name + ": fidelity: the robot " + model.name +
                               " has no legs; list the joints to hold as held: [JOINT, ...]");
    config.held.assign(model.joints.size(), true);
    for (const int joint : model.leg_joints) config.held[at(joint)] = false;
  }
  for (const std::string& name : scene.held) {
    const int joint = model.find_joint(name);
    const std::size_t robot = find_robot(config, name);
    if ((joint >= 0) + (name == "base") + (robot < config.robots.size()) != 1) refuse_held(scene, model, config, name);
    const std::size_t index = joint >= 0 ? at(joint) : model.joints.size() + (name == "base" ? 0 : 1 + robot);
    config.held.resize(std::max({config.held.size(), model.joints.size(), index + 1}), false);
    config.held[index] = true;
  }
  if (!config.held.empty()) hold_followers(model, config.held);
  if (!scene.untouched.empty() && scene.self_contact)
    throw std::runtime_error("scene " + scene.name + ": untouched: with self_contact links meet one another; leave out one of the two keys");
  for (const std::string& name : scene.untouched) {
    const int link = link_of(scene, model, "untouched", name);
    add_shapes(model, link, config.untouched);
    for (std::size_t side = 0; side < 2; ++side) {
      if (model.soles[side].link == link) config.untouched.push_back({static_cast<int>(side), -1});
    }
  }
  for (const std::string& name : scene.aloft) add_shapes(model, link_of(scene, model, "aloft", name), config.aloft);
  for (const std::string& name : scene.rigid) {
    config.rigid_robots.resize(config.robots.size(), false);
    const std::size_t robot = find_robot(config, name);
    if (robot == config.robots.size()) not_there(scene, "rigid", "further robot", name, config.robots);
    config.rigid_robots[robot] = true;
  }
}

}  // namespace twinbus::sim
