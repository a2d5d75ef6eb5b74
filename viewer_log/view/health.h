// Is the stack well?  One level and one sentence that says what is wrong and what to do, for the
// top of the page.

#pragma once

#include <cstdint>
#include <string>

#include "viewer_log/view/stack_view.h"

namespace twinbus::inline viewer_log {

enum class HealthLevel { kWaiting, kGood, kWarning, kStopped, kBad };

const char* label(HealthLevel level) noexcept;

struct Health {
  HealthLevel level = HealthLevel::kWaiting;
  std::string text;
  std::string remedy{};  // for who may act, a sentence; may be empty
  bool anew = false;   // the way out is to begin anew
};

// The worst thing first; the rest can be read in the tables.
Health assess(const StackView& view, std::int64_t now_ns);

}  // namespace twinbus::viewer_log
