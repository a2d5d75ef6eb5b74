#include "lcmtypes/msg/labels.h"

namespace twinbus {

namespace {

constexpr const char* kSourceKind[] = {"none", "simulator", "robot", "replay"};
constexpr const char* kRole[] = {"none", "parked", "active", "releasing", "track", "shadow", "stopped"};
constexpr const char* kStopKind[] = {"none", "balanced", "hold", "off"};
constexpr const char* kStopReason[] = {"none",         "the operator",   "the gamepad",      "the viewer",     "the guard",
                                       "the launcher", "the controller", "missing commands", "a device error", "a switch",
                                       "a fall"};  // StopReason::kFallen
constexpr const char* kMode[] = {"none", "idle", "hold", "pose", "balance", "walk", "stop"};
constexpr const char* kMotion[] = {"none", "sway", "squat", "played"};
constexpr const char* kProcessKind[] = {"unknown", "simulator", "bridge",  "replay", "controller", "guard",
                                        "planner", "viewer",    "gamepad", "log",    "launcher",   "user"};
constexpr const char* kGuardVerdict[] = {"clear", "near", "will collide", "in collision"};

}  // namespace

const char* label(SourceKind kind) noexcept { return name_of(kind, kSourceKind); }
const char* label(Role role) noexcept { return name_of(role, kRole); }
const char* label(StopKind kind) noexcept { return name_of(kind, kStopKind); }
const char* label(StopReason reason) noexcept { return name_of(reason, kStopReason); }
const char* label(Mode mode) noexcept { return name_of(mode, kMode); }
const char* label(Motion motion) noexcept { return name_of(motion, kMotion); }
const char* label(ProcessKind kind) noexcept { return name_of(kind, kProcessKind); }
const char* label(GuardVerdict verdict) noexcept { return name_of(verdict, kGuardVerdict); }

}  // namespace twinbus
