#include "launcher/run/scenes.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "sim/scene/scene.h"

namespace twinbus {

namespace {

Syntax scenes_syntax() {
  return {"scenes",
          "[WORD...]",
          "Lists the scenes of config/scenes and what happens in each; with words only those that "
          "have all of them in name or\ntext, small letters or capitals.  ./twinbus run SCENE judges "
          "one, ./twinbus up SCENE shows it.",
          {},
          0,
          20};
}

std::string small(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

int scenes_command(const std::vector<std::string>& words) {
  const Arguments arguments(scenes_syntax(), words);
  const std::vector<std::string> names = scene_names();
  std::size_t width = 0;
  for (const std::string& name : names) width = std::max(width, name.size());
  bool any = false;
  for (const std::string& name : names) {
    const std::string about = load_scene(name).about;
    const std::string text = small(name + " " + about);
    const bool wanted = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      return text.find(small(word)) != std::string::npos;
    });
    if (!wanted) continue;
    any = true;
    std::printf("%-*s  %s\n", static_cast<int>(width), name.c_str(), about.c_str());
  }
  if (!any) throw std::runtime_error("no scene has all of these words; ./twinbus scenes lists all");
  return 0;
}

}  // namespace twinbus
