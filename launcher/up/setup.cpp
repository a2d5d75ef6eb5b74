#include "launcher/up/setup.h"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/file/write_file.h"
#include "common/text/json_depth.h"
#include "launcher/run/judge_scene.h"
#include "launcher/up/robot_copy.h"
#include "launcher/stack/run_folder.h"
#include "robot/description/load.h"
#include "sim/scene/scene.h"
#include "sim/sim_adaptor.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;
using Pairs = std::vector<std::array<std::string, 2>>;

constexpr std::size_t kMostPushes = 100;
constexpr std::size_t kMostPairs = 5000;
constexpr double kLargestImpulse = 1000.0;  // [N s]

std::string text_member(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return {};
  if (!found->is_string()) refuse_change(std::string(key) + " must be a text");
  return found->get<std::string>();
}

double number_within(const Json& json, const std::string& what, double least, double most) {
  const double value = json.is_number() ? json.get<double>() : std::nan("");
  if (!(value >= least && value <= most))
    refuse_change(what + " must be a number from " + std::to_string(least) + " to " +
           std::to_string(most));
  return value;
}

const Json& array_member(const Json& json, const char* key, std::size_t most) {
  static const Json kNone = Json::array();
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return kNone;
  if (!found->is_array() || found->size() > most)
    refuse_change(std::string(key) + " must be a list of at most " + std::to_string(most));
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
    if (model.find_joint(joint) < 0) refuse_change("the robot has no joint '" + joint + "'");
  }
  return joints;
}

Pairs unchecked_pairs(const Json& wish, const Model& model) {
  Pairs pairs;
  for (const Json& pair : array_member(wish, "unchecked", kMostPairs)) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string())
      refuse_change("unchecked must be pairs of two names of links");
    for (const Json& link : pair) {
      const std::string name = link.get<std::string>();
      if (model.find_link(name) < 0) refuse_change("the robot has no moving link '" + name + "'");
    }
    pairs.push_back({pair[0].get<std::string>(), pair[1].get<std::string>()});
  }
  return pairs;
}

Pairs disabled_pairs(const Model& model) {
  Pairs pairs;
  for (const auto& [a, b] : model.disabled_pairs)
    pairs.push_back({model.links[static_cast<std::size_t>(a)].name, model.links[static_cast<std::size_t>(b)].name});
  return pairs;
}

// The scene as it is in config/scenes, with other beginnings.
std::string scene_text(const Json& wish, const Model& model, const std::string& pose) {
  YAML::Node scene = YAML::Load(load_scene(text_member(wish, "scene")).text);
  if (!pose.empty()) scene["start_pose"] = pose;
  for (const Json& push : array_member(wish, "pushes", kMostPushes)) {
    if (!push.is_object()) refuse_change("a push has link, at and impulse");
    const std::string link = text_member(push, "link");
    if (model.find_link(link) < 0) refuse_change("push: the robot has no moving link '" + link + "'");
    const Json& impulse = array_member(push, "impulse", 3);
    if (impulse.size() != 3) refuse_change("push: impulse must be three numbers [N s]");
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

Json parsed(const std::string& wish) {
  if (nests_deeper(wish, kDeepestWish)) refuse_change("a setup is at most " + std::to_string(kDeepestWish) + " brackets deep");
  Json json = Json::parse(wish, nullptr, false);
  if (!json.is_object()) refuse_change("a setup is a JSON object");
  return json;
}

RobotChange robot_change(const Json& wish, const Model& model) {
  const auto limbs = wish.find("limbs");
  return {.limbs = limbs == wish.end() || limbs->is_null() ? std::string() : limbs->dump(-1, ' ', true, Json::error_handler_t::replace),
          .unchecked = wish.contains("unchecked") ? unchecked_pairs(wish, model) : disabled_pairs(model),
          .joints = page_posture(wish, model)};
}

bool changes_robot(const Json& wish, const RobotChange& change) {
  return !change.limbs.empty() || !change.joints.empty() || wish.contains("unchecked");
}

// Of the robot's name, which a file gives: letters that mean something to the file system are replaced.
std::string folder_name(const Model& model) {
  std::string name = model.name.empty() ? "robot" : model.name.substr(0, 64);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  }
  return name == "saved" || name == "answer" ? name + '_' : name;  // these lie beside it
}

// Files that are written beside those of an earlier wish, and take their places when they are good.
class Draft {
 public:
  explicit Draft(const std::string& folder) : folder_(folder), draft_(folder_ / ".draft") {
    fs::remove_all(draft_);
    fs::create_directories(draft_);
  }
  ~Draft() {
    std::error_code ignored;
    fs::remove_all(draft_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  std::string file(const std::string& name) const { return draft_ / name; }
  std::string keep(const std::string& name) const {
    fs::remove_all(folder_ / name);
    fs::rename(draft_ / name, folder_ / name);
    return folder_ / name;
  }

 private:
  fs::path folder_, draft_;
};

// The changed robot, written and read back.
Model written_robot(const std::string& from, const std::string& to, const Model& model, const RobotChange& change) {
  copy_robot(from, to, model.name, change);
  Model changed = load_robot(to);
  if (change.limbs.empty() && changed.hash != model.hash)
    refuse_change("the changed robot is another one: its model hash differs");
  return changed;
}

}  // namespace

Setup write_setup(const std::string& wish_text, const std::string& robot,
                  const std::string& folder) {
  const Json wish = parsed(wish_text);
  const std::string name = text_member(wish, "scene");
  if (name.empty() || name.find('/') != std::string::npos)
    refuse_change("scene must be a name in config/scenes");
  Setup setup{.scene = folder + "/scene.yaml", .robot = robot, .engine = text_member(wish, "engine")};
  Engine engine;
  if (!setup.engine.empty() && !engine_of(setup.engine, engine))
    refuse_change("there is no engine '" + setup.engine + "'; use articulated, ode or mujoco");
  const std::string from = robot_folder(robot);
  const Model model = load_robot(from);
  const RobotChange change = robot_change(wish, model);
  const std::string pose = change.joints.empty() ? text_member(wish, "pose") : kPagePose;
  if (change.joints.empty() && !pose.empty() && model.find_pose(pose) < 0)
    refuse_change("the robot " + model.name + " has no pose '" + pose + "'");
  Draft draft(folder);
  write_file(draft.file("scene.yaml"), scene_text(wish, model, pose));
  Model changed = model;
  const bool other = changes_robot(wish, change);
  if (other) changed = written_robot(from, draft.file(folder_name(model)), model, change);
  Scene scene = load_scene(draft.file("scene.yaml"));
  if (setup.engine.empty()) setup.engine = scene.engine;
  scene.engine = setup.engine;
  resolve_poses(scene, changed);
  check_motions(scene, changed);
  // A simulator that cannot begin would end the whole stack.
  SimAdaptor trial(scene);
  if (trial.open(changed, {}) != Status::kOk)
    refuse_change("the simulator cannot begin like this; it says why where ./twinbus up runs");
  trial.close();
  draft.keep("scene.yaml");
  if (other) setup.robot = draft.keep(folder_name(model));
  setup.model_hash = changed.hash;
  return setup;
}

Setup save_robot(const std::string& wish_text, const std::string& robot, const std::string& folder) {
  const Json wish = parsed(wish_text);
  const std::string from = robot_folder(robot);
  const Model model = load_robot(from);
  const RobotChange change = robot_change(wish, model);
  Draft draft(folder + "/saved");  // processes that run may have been started with the folder of write_setup()
  const Model changed = written_robot(from, draft.file(folder_name(model)), model, change);
  return {.scene = {}, .robot = draft.keep(folder_name(model)), .engine = {}, .model_hash = changed.hash};
}

bool only_saves(const std::string& wish_text) {
  return Json::parse(wish_text, nullptr, false).contains("save");  // what is no object contains nothing
}

std::int64_t save_number(const std::string& wish_text) {
  const Json wish = parsed(wish_text);
  const auto save = wish.find("save");
  if (save == wish.end() || !save->is_number_unsigned() || save->get<std::uint64_t>() > kLargestSave)
    refuse_change("save must be a whole number from 0 to 2^53");
  return save->get<std::int64_t>();
}

}  // namespace twinbus::launcher
