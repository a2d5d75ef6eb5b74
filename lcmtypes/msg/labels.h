// What the enumerations of messages are called in sentences for people.

#pragma once

#include "common/text/name_of.h"
#include "lcmtypes/msg/reports.h"
#include "lcmtypes/msg/requests.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus {

const char* label(SourceKind kind) noexcept;
const char* label(Role role) noexcept;
const char* label(StopKind kind) noexcept;
const char* label(StopReason reason) noexcept;
const char* label(Mode mode) noexcept;
const char* label(Motion motion) noexcept;
const char* label(ProcessKind kind) noexcept;
const char* label(GuardVerdict verdict) noexcept;

}  // namespace twinbus
