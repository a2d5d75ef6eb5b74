#include "lcmtypes/bus/wire.h"

#include <array>
#include <cstring>

#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/convert.h"
#include "lcmtypes/bus/older.h"

namespace twinbus::inline lcmtypes {

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
ChannelInfo row(const Channel<T>& channel) {
  return {.channel = channel.name,
          .type = Message<T>::getTypeName(),
          .bytes = Message<T>().getEncodedSize(),
          .fingerprint = Message<T>::getHash(),
          .check = &check<T>};
}

}  // namespace

std::span<const ChannelInfo> channel_table() {
  // HEARTBEAT names a channel by its row, in logs too: new rows come last.
  static const std::array table{
      row(channel::kState),
      row(channel::kStateSim),
      row(channel::kStateBridge),
      row(channel::kStateReplay),
      row(channel::kCommand),
      row(channel::kSourceStatus),
      row(channel::kSourceRequest),
      row(channel::kControllerRequest),
      row(channel::kModeRequest),
      row(channel::kStop),
      row(channel::kTruth),
      row(channel::kGuard),
      row(channel::kGamepad),
      row(channel::kWalk),
      row(channel::kSteps),
      row(channel::kArmGoal),
      row(channel::kArmPath),
      row(channel::kControllerStatus),
      row(channel::kGap),
      row(channel::kObstacles),
      row(channel::kHeartbeat),
      row(channel::kModelText),
      row(channel::kEvent),
      row(channel::kJournal),
      row(channel::kLogText),
      row(channel::kTerrain),
      row(channel::kLoose),
      row(channel::kFootsteps),
      row(channel::kCamera),
      row(channel::kSimRequest),
      row(channel::kStopPlan),
      row(channel::kEstimate),
      row(channel::kMotion),
      row(channel::kHeld),
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

}  // namespace twinbus::lcmtypes
