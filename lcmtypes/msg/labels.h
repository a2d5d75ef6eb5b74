// What the enumerations of messages are called in sentences for people.

#pragma once

#include <cstddef>

#include "lcmtypes/msg/reports.h"
#include "lcmtypes/msg/requests.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus {

// names[i] of the enumerator with value i; otherwise for a value that this version does not know.
template <class E, std::size_t N>
constexpr const char* name_of(E value, const char* const (&names)[N],
                              const char* otherwise = "unknown") noexcept {
  const auto i = static_cast<std::size_t>(value);
  return i < N ? names[i] : otherwise;
}

const char* label(SourceKind kind) noexcept;
const char* label(Role role) noexcept;
const char* label(StopKind kind) noexcept;
const char* label(StopReason reason) noexcept;
const char* label(Mode mode) noexcept;
const char* label(Motion motion) noexcept;
const char* label(ProcessKind kind) noexcept;
const char* label(GuardVerdict verdict) noexcept;

}  // namespace twinbus
