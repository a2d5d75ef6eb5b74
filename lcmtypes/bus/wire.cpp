#include "lcmtypes/bus/wire.h"

#include <array>
#include <cstring>

#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/convert.h"
#include "lcmtypes/bus/older.h"

namespace twinbus {

template <class T>
int encode(const T& value, std::span<std::uint8_t> bytes) noexcept {
  constexpr int size = Wire<T>::kBytes;
  static_assert(size <= kLargestMessage);
  Message<T> message;
  if (static_cast<int>(bytes.size()) < size || to_message(value, message) != Status::kOk) return 0;
  return message.encode(bytes.data(), 0, size) == size ? size : 0;
}

template <class T>
Status decode(std::span<const std::uint8_t> bytes, T& value) noexcept {
  constexpr int size = Wire<T>::kBytes;
  std::array<std::uint8_t, static_cast<std::size_t>(size)> room;
  bytes = renewed(bytes, room);
  Message<T> message;
  if (bytes.size() != room.size() || message.decode(bytes.data(), 0, size) != size) return Status::kWrongSize;
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
      row<ObstaclesPiece>(channel::kHeld),
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
