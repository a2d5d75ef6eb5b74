// Sentences for people about what a source did: from the difference of two of its statuses.

#pragma once

#include <array>

#include "bridge/gate/command_gate.h"
#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"

namespace twinbus::inline bridge {

// "LLEG_KNEE: position 2.7 rad asked, 2.62 given"; empty when nothing was cut.
std::array<char, 200> cut_sentence(const FirstCut& cut, const Model& model) noexcept;

// Tells the first cut of a command, an alarm, and the first step that made up for missing commands, which is none: each
// once.  Cuts too small to be spoken of, and later ones, are counted in the status (clamped).
class CutTeller {
 public:
  // Fills text and severity of event; false when there is nothing to say.  Call until false.
  bool next(const FirstCut& cut, const FirstCut& catch_up, const Model& model, Event& event) noexcept;

 private:
  bool cut_told_ = false, catch_up_told_ = false;
};

// Fills text and severity of the next sentence that leads from `told` to `now` and brings `told`
// that much closer. False when nothing is left to say.  Call until false.  Cuts and the device have their own tellers.
bool next_sentence(SourceStatus& told, const SourceStatus& now, Event& event) noexcept;

}  // namespace twinbus::bridge
