// Sentences for people about what a source did: from the difference of two of its statuses.

#pragma once

#include "lcmtypes/msg/reports.h"

namespace twinbus {

// Fills text and severity of the next sentence that leads from `told` to `now` and brings `told`
// that much closer. False when nothing is left to say.  Call until false.
bool next_sentence(SourceStatus& told, const SourceStatus& now, Event& event) noexcept;

}  // namespace twinbus
