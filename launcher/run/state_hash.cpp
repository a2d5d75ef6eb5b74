#include "launcher/run/state_hash.h"

#include <array>

#include "common/text/formatted.h"
#include "lcmtypes/bus/older.h"
#include "lcmtypes/bus/wire.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline launcher {

namespace {

// FNV-1a, 64 bits.
std::uint64_t mix(std::uint64_t hash, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3ULL;
  return hash;
}

}  // namespace

void StateHash::add(std::span<const std::uint8_t> encoded) {
  RobotState state;
  if (decode(encoded, state) != Status::kOk || state.tick <= last_tick_) return;
  if (last_tick_ >= 0 && state.tick != last_tick_ + 1) whole_ = false;
  if (last_tick_ < 0) hash_ = 0xcbf29ce484222325ULL;
  last_tick_ = state.tick;
  // These differ from run to run by design and mean nothing to the physics.
  state.run_id = 0;
  state.grant_run_id = 0;
  state.source_time_ns = 0;
  state.stop_nonce = 0;
  std::array<std::uint8_t, kLargestMessage> bytes;
  const int size = encode(state, bytes);
  // As STATE was when it had two feet, so that a run keeps the hash that it had then; the others count where there are such.
  const std::span<const std::uint8_t> now(bytes.data(), static_cast<std::size_t>(size));
  std::array<std::uint8_t, kLargestMessage> room;
  hash_ = mix(hash_, as_before(now, room));
  for (std::size_t foot = kRightFoot + 1; foot < kMaxFeet; ++foot) {
    if (state.wrench_kind[foot] == WrenchKind::kAbsent) continue;
    hash_ = mix(hash_, now);
    break;
  }
}

std::string StateHash::text() const {
  if (!whole_ || last_tick_ < 0) return "";
  return formatted("%016llx", static_cast<unsigned long long>(hash_));
}

}  // namespace twinbus::launcher
