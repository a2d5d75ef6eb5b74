// Why a request to a source was refused.

#pragma once

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

// A sentence that says what is wrong and what to do; never null.
const char* refusal_text(Refusal refusal) noexcept;

}  // namespace twinbus::lcmtypes
