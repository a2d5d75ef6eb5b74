#include "robot/mjcf/mjcf_defaults.h"

#include <algorithm>

#include "common/text/closest_name.h"

namespace twinbus::inline robot {

namespace {

std::string kind_of(const std::string& element) { return is_actuator_element(element) ? "actuator" : element; }

}  // namespace

bool is_actuator_element(const std::string& name) {
  static const std::vector<std::string> kNames = {"general",     "motor", "position", "velocity", "intvelocity",
                                                  "orientation", "pid",   "damper",   "cylinder", "muscle",
                                                  "adhesion",    "dcmotor"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

MjcfDefaults::MjcfDefaults(const MjcfElement& mujoco) {
  for (const MjcfElement& section : mujoco.children) {
    if (section.name != "default") continue;
    // Further top sections add to the top class, and may give it another name.
    const Class known = classes_.count(top_) != 0 ? classes_[top_] : Class();
    top_ = section.text("class", top_);
    classes_.erase(top_);
    read(section, known, top_);
  }
  classes_.emplace(top_, Class());
}

void MjcfDefaults::read(const MjcfElement& section, const Class& parent, const std::string& name) {
  Class mine = parent;
  for (const MjcfElement& element : section.children) {
    if (element.name == "default") continue;
    std::vector<MjcfAttribute>& known = mine[kind_of(element.name)];
    for (const MjcfAttribute& attribute : element.attributes) {
      const auto same = std::find_if(known.begin(), known.end(),
                                     [&](const MjcfAttribute& each) { return each.name == attribute.name; });
      if (same != known.end()) known.erase(same);
      known.insert(known.begin(), attribute);  // what is said last comes first, as with an element's own
    }
  }
  if (!classes_.emplace(name, mine).second) section.fail("class", name.substr(0, 60) + " is there twice; rename one");
  for (const MjcfElement& element : section.children) {
    if (element.name != "default") continue;
    const std::string child = element.text("class");
    if (child.empty()) element.fail("a default class inside another needs class=\"...\"");
    read(element, mine, child);
  }
}

const MjcfDefaults::Class& MjcfDefaults::find(const MjcfElement& element, const std::string& key,
                                              const std::string& name) const {
  const auto found = classes_.find(name.empty() ? top_ : name);
  if (found != classes_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& each : classes_) known.push_back(each.first);
  element.fail(key, "names the default class " + name.substr(0, 60) + ", which is not there" + suggestion(name, known));
}

MjcfElement MjcfDefaults::resolved(const MjcfElement& element, const std::string& childclass) const {
  const std::string own = element.text("class");
  const Class& found = find(element, "class", own.empty() ? childclass : own);
  MjcfElement full;
  full.name = element.name;
  full.place = element.place;
  full.attributes = element.attributes;
  const auto defaults = found.find(kind_of(element.name));
  if (defaults == found.end()) return full;
  for (const MjcfAttribute& attribute : defaults->second) {
    if (!full.has(attribute.name)) full.attributes.push_back(attribute);
  }
  return full;
}

void MjcfDefaults::check_childclass(const MjcfElement& element) const {
  if (element.has("childclass")) (void)find(element, "childclass", element.text("childclass"));
}

}  // namespace twinbus::robot
