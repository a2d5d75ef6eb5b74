// state_hash of a run as the bus shows it: doc/protocol.md section 7, the same as `twinbus run` computes.

#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace twinbus::inline launcher {

class StateHash {
 public:
  // Encoded STATE of the next tick; a repeated tick changes nothing, a missing one makes the hash worthless.
  void add(std::span<const std::uint8_t> encoded);
  // 16 hexadecimal digits; empty when ticks are missing or none came.
  std::string text() const;

 private:
  std::int64_t last_tick_ = -1;
  std::uint64_t hash_ = 0;
  bool whole_ = true;
};

}  // namespace twinbus::launcher
