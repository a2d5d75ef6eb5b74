// `./twinbus scenes`: which scenes there are, by group.

#include "launcher/commands/commands.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "common/text/closest_name.h"
#include "launcher/run/fit_scene.h"
#include "robot/description/load.h"
#include "sim/scene/scene.h"

namespace twinbus::inline launcher {

namespace {

constexpr const char* kGroups[] = {"standing", "walking", "arms and hands", "bodies and mechanisms"};

std::string small(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// What a scene is about.
const char* scene_group(const Scene& scene) {
  const bool walks = !scene.walks.empty() || !scene.pads.empty() || !scene.steps.empty() ||
                     std::any_of(scene.modes.begin(), scene.modes.end(),
                                 [](const TimedMode& timed) { return timed.request.mode == Mode::kWalk; });
  if (walks) return kGroups[1];
  const bool humanoid = scene.start_pose == "half_sitting" && !scene.fixed_base;
  const bool moves = std::any_of(scene.modes.begin(), scene.modes.end(), [](const TimedMode& timed) {
    return timed.request.motion != Motion::kNone || timed.request.mode == Mode::kPose;
  });
  const bool asked = moves || !scene.pushes.empty() || scene.push_round.count > 0;
  if (!scene.goals.empty() || (humanoid && !scene.grasps.empty())) return kGroups[2];
  if (!humanoid || (!asked && (!scene.loose.empty() || scene.robot != Scene{}.robot))) return kGroups[3];
  return kGroups[0];
}

// Why the scene is not for the robot of --robot; empty where it is.
std::string why_not(const Scene& scene, const Model& model) {
  if (scene_group(scene) == kGroups[3]) return "";
  try {
    return why_scene_is_not_for(scene, model);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

bool has_all(const std::string& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return text.find(small(word)) != std::string::npos; });
}

// "; did you mean walk?" of the first word that is near a name, or a part of one between underscores, and none itself.
std::string meant(const std::vector<std::string>& words, const std::vector<std::string>& names) {
  std::set<std::string> parts(names.begin(), names.end());
  for (const std::string& name : names) {
    std::istringstream text(name);
    for (std::string part; std::getline(text, part, '_');) parts.insert(part);
  }
  for (const std::string& word : words) {
    const std::string near = nearest_name(word, {parts.begin(), parts.end()});
    if (!near.empty() && near != small(word)) return "; did you mean " + near + "?";
  }
  return "";
}

}  // namespace

int scenes_command(const std::vector<std::string>& words) {
  const Arguments arguments({"scenes", 0, 20, R"([WORD...] [OPTION...]
Lists the scenes of config/scenes and what happens in each; with words only those that have all of them in name or
text, small letters or capitals.  ./twinbus run SCENE judges one, ./twinbus up SCENE shows it.
  --robot NAME|DIR  those that are for this robot, then those that are not and what they need that it does not have)"}, words);
  const std::vector<std::string> names = scene_names();
  const std::string robot = arguments.text("--robot", "");
  const std::optional<Model> model = robot.empty() ? std::nullopt : std::optional(load_robot(robot));
  std::size_t width = 0;
  for (const std::string& name : names) width = std::max(width, name.size());
  bool any = false;
  std::map<std::string, std::string> listed, refused;  // by group, and by what is missing
  for (const std::string& name : names) {
    const Scene scene = load_scene(name);
    if (!has_all(small(name + " " + scene.about), arguments.words())) continue;
    any = true;
    const std::string why = model ? why_not(scene, *model) : "";
    if (why.empty())
      listed[scene_group(scene)] += "  " + name + std::string(width + 2 - name.size(), ' ') + scene.about + "\n";
    else
      refused[why] += "  " + name;
  }
  for (const char* group : kGroups) {
    const bool its_own = model && group == kGroups[3];  // bodies and mechanisms that a scene brings
    if (listed.contains(group) && !its_own) std::printf("%s\n%s", group, listed[group].c_str());
  }
  if (!refused.empty()) std::printf("not for %s\n", model->name.c_str());
  for (const auto& [why, scenes] : refused) std::printf("%s\n    %s\n", scenes.c_str(), why.c_str());
  if (!any) throw std::runtime_error("no scene has all of these words" + meant(arguments.words(), names) + "; ./twinbus scenes lists all");
  return 0;
}

}  // namespace twinbus::launcher
