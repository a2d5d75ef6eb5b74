// Sentences for people about what a source did: from the difference of two of its statuses.

#pragma once

#include <array>

#include "bridge/gate/command_gate.h"
#include "lcmtypes/msg/reports.h"
#include "robot/description/model.h"

namespace twinbus {

// "LLEG_KNEE: position 2.7 rad asked, 2.62 given"; empty when nothing was cut.
std::array<char, 200> cut_sentence(const FirstCut& cut, const Model& model) noexcept;

// Fills text and severity of the next sentence that leads from `told` to `now` and brings `told`
// that much closer. False when nothing is left to say.  Call until false.  cut: what the gate cut first.
bool next_sentence(SourceStatus& told, const SourceStatus& now, Event& event, const char* cut = "") noexcept;

}  // namespace twinbus
