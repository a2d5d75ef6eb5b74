#include "launcher/operate/asked_hand.h"

#include <stdexcept>
#include <vector>

#include "common/process/arguments.h"
#include "common/text/closest_name.h"
#include "robot/description/named_hands.h"

namespace twinbus::inline launcher {

const Hand& asked_hand(const std::string& where, const Model& model, const std::string& name) {
  if (const Hand* hand = hand_called(model, name)) return *hand;
  const std::string names = hand_names(model);
  if (names.empty()) throw std::runtime_error(model.name + " has no hand (robot.yaml, hands)");
  std::vector<std::string> known;
  for (const Hand* hand : hands_of(model)) known.push_back(hand->name);
  const std::string near = nearest_name(name, known);
  throw UsageError(where + ": " + model.name + " has no arm called " + name + (near.empty() ? "" : " (did you mean " + near + "?)") + "; say one of: " + names);
}

}  // namespace twinbus::launcher
