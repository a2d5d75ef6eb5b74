// Mode requests that were heard and wait for their tick.
//
// Only requests for the run that is followed count, each once, so that an old log played over a
// live robot does nothing.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/obeyed_once.h"

namespace twinbus::inline control {

class ModeQueue {
 public:
  // run_id: of the source that is followed now.  False when the request is not for it, was heard
  // before, or when too many wait.
  bool add(const ModeRequest& request, std::int64_t run_id) noexcept;
  // The next request that is due at this tick, earliest first; null when none is.  Valid until the
  // next call.
  const ModeRequest* take(std::int64_t tick) noexcept;
  void clear() noexcept { count_ = 0; }

 private:
  static constexpr std::size_t kCapacity = 8;
  std::array<ModeRequest, kCapacity> waiting_{};
  std::size_t count_ = 0;
  ModeRequest taken_;
  SenderSequences<64> heard_;
};

}  // namespace twinbus::control
