#include "launcher/up/setup.h"

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "launcher/run/judge_scene.h"
#include "launcher/stack/run_folder.h"
#include "robot/description/load.h"
#include "sim/scene/scene.h"
#include "sim/sim_adaptor.h"
#include "sim/world/world.h"

namespace twinbus {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;
using Pairs = std::vector<std::array<std::string, 2>>;

constexpr char kPagePose[] = "set_on_page";
constexpr std::size_t kMostPushes = 100;
constexpr std::size_t kMostPairs = 5000;
constexpr double kLargestImpulse = 1000.0;  // [N s]

[[noreturn]] void refuse(const std::string& why) { throw std::runtime_error(why); }

std::string text_member(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return {};
  if (!found->is_string()) refuse(std::string(key) + " must be a text");
  return found->get<std::string>();
}

double number_within(const Json& json, const std::string& what, double least, double most) {
  const double value = json.is_number() ? json.get<double>() : std::nan("");
  if (!(value >= least && value <= most))
    refuse(what + " must be a number from " + std::to_string(least) + " to " +
           std::to_string(most));
  return value;
}

const Json& array_member(const Json& json, const char* key, std::size_t most) {
  static const Json kNone = Json::array();
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return kNone;
  if (!found->is_array() || found->size() > most)
    refuse(std::string(key) + " must be a list of at most " + std::to_string(most));
  return *found;
}

// Every joint of the pose, the given ones in its place.
std::vector<std::pair<std::string, double>> page_posture(const Json& wish, const Model& model) {
  const std::string name = text_member(wish, "pose");
  const auto given = wish.find("joints");
  const bool some = given != wish.end() && given->is_object() && !given->empty();
  if (!some) return {};
  const int pose = model.find_pose(name.empty() ? "half_sitting" : name);
  std::vector<std::pair<std::string, double>> joints;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.mimic >= 0) continue;
    double value = pose < 0 ? 0.0 : model.poses[static_cast<std::size_t>(pose)].q[j];
    const auto changed = given->find(joint.name);
    if (changed != given->end())
      value = number_within(*changed, "joint " + joint.name, joint.lower, joint.upper);
    joints.emplace_back(joint.name, value);
  }
  for (const auto& [joint, value] : given->items()) {
    if (model.find_joint(joint) < 0) refuse("the robot has no joint '" + joint + "'");
  }
  return joints;
}

Pairs unchecked_pairs(const Json& wish, const Model& model) {
  Pairs pairs;
  for (const Json& pair : array_member(wish, "unchecked", kMostPairs)) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string())
      refuse("unchecked must be pairs of two names of links");
    for (const Json& link : pair) {
      const std::string name = link.get<std::string>();
      if (model.find_link(name) < 0) refuse("the robot has no moving link '" + name + "'");
    }
    pairs.push_back({pair[0].get<std::string>(), pair[1].get<std::string>()});
  }
  return pairs;
}

// The scene as it is in config/scenes, with other beginnings.
std::string scene_text(const Json& wish, const Model& model, const std::string& pose) {
  YAML::Node scene = YAML::Load(load_scene(text_member(wish, "scene")).text);
  if (!pose.empty()) scene["start_pose"] = pose;
  for (const Json& push : array_member(wish, "pushes", kMostPushes)) {
    if (!push.is_object()) refuse("a push has link, at and impulse");
    const std::string link = text_member(push, "link");
    if (model.find_link(link) < 0) refuse("push: the robot has no moving link '" + link + "'");
    const Json& impulse = array_member(push, "impulse", 3);
    if (impulse.size() != 3) refuse("push: impulse must be three numbers [N s]");
    YAML::Node node;
    node["link"] = link;
    for (const Json& part : impulse)
      node["impulse"].push_back(
          number_within(part, "push: impulse", -kLargestImpulse, kLargestImpulse));
    node["at"] = number_within(push.value("at", Json()), "push: at", 0.0, 1e5);
    node["duration"] =
        number_within(push.value("duration", Json(0.1)), "push: duration", 0.002, 10.0);
    scene["pushes"].push_back(node);
  }
  YAML::Emitter emitter;
  emitter.SetDoublePrecision(12);
  emitter << scene;
  return std::string(emitter.c_str()) + "\n";
}

// The same robot with another SRDF.
void copy_robot(const std::string& from, const fs::path& to, const Model& model, const Pairs& pairs,
                const std::vector<std::pair<std::string, double>>& joints) {
  fs::remove_all(to);
  fs::copy(from, to, fs::copy_options::recursive);
  YAML::Node yaml = YAML::Load(read_text_file(to / "robot.yaml"));
  const std::string name = yaml["srdf"] ? yaml["srdf"].as<std::string>() : "set_up.srdf";
  const std::string old = yaml["srdf"] ? read_text_file(to / name) : std::string();
  if (!yaml["srdf"]) {
    yaml["srdf"] = name;
    YAML::Emitter emitter;
    emitter << yaml;
    write_file(to / "robot.yaml", std::string(emitter.c_str()) + "\n");
  }
  write_file(to / name, edited_srdf(old, model.name, pairs, kPagePose, joints));
}

}  // namespace

std::string edited_srdf(const std::string& srdf, const std::string& robot, const Pairs& unchecked,
                        const std::string& pose,
                        const std::vector<std::pair<std::string, double>>& joints) {
  std::string text = srdf.empty() ? "<robot name=\"" + robot + "\">\n</robot>\n" : srdf;
  const std::string element = "<disable_collisions";
  for (std::size_t at = 0; (at = text.find(element, at)) != std::string::npos;) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) break;
    const std::string closing = "</disable_collisions>";
    std::size_t next = end + 1;
    if (text[end - 1] != '/') {
      const std::size_t closed = text.find(closing, end);
      if (closed == std::string::npos) break;
      next = closed + closing.size();
    }
    text.erase(at, next - at);
  }
  std::string more;
  for (const auto& [a, b] : unchecked)
    more += "  " + element + " link1=\"" + a + "\" link2=\"" + b + "\" reason=\"User\"/>\n";
  if (!joints.empty()) {
    more += "  <group_state name=\"" + pose + "\" group=\"all\">\n";
    for (const auto& [name, value] : joints) {
      more += "    <joint name=\"" + name + formatted("\" value=\"%.12g\"/>\n", value);
    }
    more += "  </group_state>\n";
  }
  const std::size_t end = text.rfind("</robot>");
  if (end == std::string::npos) refuse("the SRDF has no </robot>");
  return text.insert(end, more);
}

Setup write_setup(const std::string& wish_text, const std::string& robot,
                  const std::string& folder) {
  const Json wish = Json::parse(wish_text, nullptr, false);
  if (!wish.is_object()) refuse("a setup is a JSON object");
  const std::string name = text_member(wish, "scene");
  if (name.empty() || name.find('/') != std::string::npos)
    refuse("scene must be a name in config/scenes");
  Setup setup{
      .scene = folder + "/scene.yaml", .robot = robot, .engine = text_member(wish, "engine")};
  Engine engine;
  if (!setup.engine.empty() && !engine_of(setup.engine, engine))
    refuse("there is no engine '" + setup.engine + "'; use articulated, ode or mujoco");
  const std::string from = robot_folder(robot);
  const Model model = load_robot(from);
  const std::vector<std::pair<std::string, double>> joints = page_posture(wish, model);
  const std::string pose = joints.empty() ? text_member(wish, "pose") : kPagePose;
  if (joints.empty() && !pose.empty() && model.find_pose(pose) < 0)
    refuse("the robot " + model.name + " has no pose '" + pose + "'");
  fs::create_directories(folder);
  write_file(setup.scene, scene_text(wish, model, pose));
  if (!joints.empty() || wish.contains("unchecked")) {
    setup.robot = folder + "/" + model.name;
    copy_robot(from, setup.robot, model, unchecked_pairs(wish, model), joints);
  }
  const Model changed = load_robot(setup.robot);
  if (changed.hash != model.hash)
    refuse("the changed robot is another one: its model hash differs");
  Scene scene = load_scene(setup.scene);
  if (setup.engine.empty()) setup.engine = scene.engine;
  scene.engine = setup.engine;
  resolve_poses(scene, changed);
  check_motions(scene, changed);
  // A simulator that cannot begin would end the whole stack.
  SimAdaptor trial(scene);
  if (trial.open(changed, {}) != Status::kOk)
    refuse("the simulator cannot begin like this; it says why where ./twinbus up runs");
  trial.close();
  return setup;
}

}  // namespace twinbus
