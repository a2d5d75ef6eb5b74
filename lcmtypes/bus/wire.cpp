#include "lcmtypes/bus/wire.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/convert.h"

namespace twinbus {

template <class T>
int encode(const T& value, std::span<std::uint8_t> bytes) noexcept {
  constexpr int size = Wire<T>::kBytes;
  static_assert(size <= kLargestMessage);
  Message<T> message;
  if (static_cast<int>(bytes.size()) < size || to_message(value, message) != Status::kOk) return 0;
  return message.encode(bytes.data(), 0, size) == size ? size : 0;
}

namespace {

// SOURCE_STATUS as logs have it that were written before it said how far a controller is faded in: then one was at once.
constexpr std::size_t kOlderStatusBytes = 154, kFadedInAt = 144;
constexpr std::uint64_t kOlderStatusFingerprint = 0xa10fffc4d8b72360;

// Writes the bytes that the same status has now; false when they are no older one.
bool renew(std::span<const std::uint8_t> older, std::span<std::uint8_t, Wire<SourceStatus>::kBytes> now) noexcept {
  if (older.size() != kOlderStatusBytes) return false;
  std::uint64_t fingerprint = 0;
  for (std::size_t i = 0; i < 8; ++i) fingerprint = fingerprint << 8 | older[i];
  if (fingerprint != kOlderStatusFingerprint) return false;
  constexpr std::array<std::uint8_t, 4> kOne{0x3f, 0x80, 0x00, 0x00};  // 1.0f
  const auto current = static_cast<std::uint64_t>(Message<SourceStatus>::getHash());
  for (std::size_t i = 0; i < 8; ++i) now[i] = static_cast<std::uint8_t>(current >> (56 - 8 * i));
  auto to = std::copy(older.begin() + 8, older.begin() + kFadedInAt, now.begin() + 8);
  to = std::copy(kOne.begin(), kOne.end(), to);
  std::copy(older.begin() + kFadedInAt, older.end(), to);
  return true;
}

}  // namespace

template <class T>
Status decode(std::span<const std::uint8_t> bytes, T& value) noexcept {
  constexpr int size = Wire<T>::kBytes;
  Message<T> message;
  if constexpr (std::is_same_v<T, SourceStatus>) {
    std::array<std::uint8_t, static_cast<std::size_t>(size)> now{};
    if (renew(bytes, now)) return message.decode(now.data(), 0, size) == size ? from_message(message, value) : Status::kWrongSize;
  }
  if (bytes.size() != static_cast<std::size_t>(size) ||
      message.decode(bytes.data(), 0, size) != size) {
    return Status::kWrongSize;
  }
  return from_message(message, value);
}

namespace {

template <class T>
Status check(std::span<const std::uint8_t> bytes) noexcept {
  T value;
  return decode(bytes, value);
}

template <class T>
ChannelInfo row(const char* channel) {
  return {.channel = channel,
          .type = Message<T>::getTypeName(),
          .bytes = Message<T>().getEncodedSize(),
          .fingerprint = Message<T>::getHash(),
          .check = &check<T>};
}

}  // namespace

std::span<const ChannelInfo> channel_table() {
  // HEARTBEAT names a channel by its row, in logs too: new rows come last.
  static const std::array table{
      row<RobotState>(channel::kState),
      row<RobotState>(channel::kStateSim),
      row<RobotState>(channel::kStateBridge),
      row<RobotState>(channel::kStateReplay),
      row<JointCommand>(channel::kCommand),
      row<SourceStatus>(channel::kSourceStatus),
      row<SourceRequest>(channel::kSourceRequest),
      row<ControllerRequest>(channel::kControllerRequest),
      row<ModeRequest>(channel::kModeRequest),
      row<StopRequest>(channel::kStop),
      row<SimTruth>(channel::kTruth),
      row<GuardReport>(channel::kGuard),
      row<Gamepad>(channel::kGamepad),
      row<WalkCommand>(channel::kWalk),
      row<StepList>(channel::kSteps),
      row<ArmGoal>(channel::kArmGoal),
      row<ArmPathPiece>(channel::kArmPath),
      row<ControllerStatus>(channel::kControllerStatus),
      row<Gap>(channel::kGap),
      row<ObstaclesPiece>(channel::kObstacles),
      row<Heartbeat>(channel::kHeartbeat),
      row<ModelTextPiece>(channel::kModelText),
      row<Event>(channel::kEvent),
      row<JournalPage>(channel::kJournal),
      row<ModelTextPiece>(channel::kLogText),
      row<ObstaclesPiece>(channel::kTerrain),
      row<ObstaclesPiece>(channel::kLoose),
      row<ObstaclesPiece>(channel::kFootsteps),
      row<ModelTextPiece>(channel::kCamera),
      row<SimRequest>(channel::kSimRequest),
      row<StopPlanPiece>(channel::kStopPlan),
      row<Estimate>(channel::kEstimate),
      row<MotionPiece>(channel::kMotion),
  };
  return table;
}

const ChannelInfo* find_channel(const char* channel) noexcept {
  for (const ChannelInfo& info : channel_table()) {
    if (std::strcmp(info.channel, channel) == 0) return &info;
  }
  return nullptr;
}

#define TWINBUS_WIRE(T)                                               \
  template int encode<T>(const T&, std::span<std::uint8_t>) noexcept; \
  template Status decode<T>(std::span<const std::uint8_t>, T&) noexcept;
TWINBUS_MESSAGES(TWINBUS_WIRE)
#undef TWINBUS_WIRE

}  // namespace twinbus
