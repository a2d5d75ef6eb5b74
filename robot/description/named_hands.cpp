#include "robot/description/named_hands.h"

#include "robot/description/robot_yaml.h"

namespace twinbus::inline robot {

const Hand* hand_called(const Model& model, const std::string& name) noexcept {
  for (const Hand& hand : model.more_hands) {
    if (hand.name == name) return &hand;
  }
  return name == "left" ? hand_of(model, 0) : name == "right" ? hand_of(model, 1) : nullptr;
}

std::string hand_names(const Model& model) {
  std::string names;
  for (const Hand* hand : hands_of(model)) names += (names.empty() ? "" : ", ") + hand->name;
  return names;
}

std::string spoken_name(const Model& model, const Hand& hand) {
  return number_of(model, hand) < 2 ? "the " + hand.name + " hand" : "arm " + hand.name;
}

Gripper gripper_of(const Model& model, const Hand& hand) {
  const auto number = static_cast<std::size_t>(number_of(model, hand));
  if (number < model.grippers.size()) return model.grippers[number];
  if (model.yaml_text.empty()) return {};
  return read_grippers(parse_robot_yaml(model.yaml_text, model.folder + "/robot.yaml"), model)[number];
}

}  // namespace twinbus::robot
