// `./twinbus scenes`: which scenes there are, by group.

#include "launcher/commands/commands.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "sim/scene/scene.h"

namespace twinbus {

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

}  // namespace

int scenes_command(const std::vector<std::string>& words) {
  const Arguments arguments({"scenes", 0, 20, R"([WORD...]
Lists the scenes of config/scenes and what happens in each; with words only those that have all of them in name or
text, small letters or capitals.  ./twinbus run SCENE judges one, ./twinbus up SCENE shows it.)"}, words);
  const std::vector<std::string> names = scene_names();
  std::size_t width = 0;
  for (const std::string& name : names) width = std::max(width, name.size());
  bool any = false;
  std::map<std::string, std::string> listed;  // by group
  for (const std::string& name : names) {
    const Scene scene = load_scene(name);
    const std::string& about = scene.about;
    const std::string text = small(name + " " + about);
    const bool wanted = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      return text.find(small(word)) != std::string::npos;
    });
    if (!wanted) continue;
    any = true;
    listed[scene_group(scene)] += "  " + name + std::string(width + 2 - name.size(), ' ') + about + "\n";
  }
  for (const char* group : kGroups) {
    if (listed.contains(group)) std::printf("%s\n%s", group, listed[group].c_str());
  }
  if (!any) throw std::runtime_error("no scene has all of these words; ./twinbus scenes lists all");
  return 0;
}

}  // namespace twinbus
