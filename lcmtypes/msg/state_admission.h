// Which messages on STATE a listener (controller, guard, planner, viewer) believes: doc/protocol.md
// section 4.
//
// A source is believed when it goes on with the term it holds, when the holder granted it the next
// term, when it is the holder taking its own grant back, or when nobody has been heard for a while.
// Everything else is counted and ignored, so neither one datagram nor an old log can take a
// listener away from its robot.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline lcmtypes {

class StateAdmission {
 public:
  // A higher term is believed without a grant after this silence, any term after the longer one
  // [ns].
  static constexpr std::int64_t kSilence = 100'000'000;
  static constexpr std::int64_t kLongSilence = 1'000'000'000;
  static constexpr std::int64_t kFarthestJump = 1000;  // ticks ahead of the last one

  // True if the message is to be used.  A repeated tick is admitted too: in lock-step it asks for
  // the same answer.
  bool admit(const RobotState& state, std::int64_t now_ns) noexcept {
    if (!believed(state, now_ns)) {
      ++ignored_;
      return false;
    }
    if (state.run_id != run_id_) {
      former_run_id_ = run_id_;
      former_term_ = term_;
      run_id_ = state.run_id;
      if (heard_) ++changes_;
    }
    term_ = state.term;
    tick_ = state.tick;
    grant_run_id_ = state.grant_run_id;
    grant_tick_ = state.grant_tick;
    heard_ = true;
    heard_ns_ = now_ns;
    return true;
  }

  std::int64_t run_id() const noexcept { return run_id_; }
  std::int32_t term() const noexcept { return term_; }
  std::int64_t ignored() const noexcept {
    return ignored_;
  }  // messages not believed, or older than the last
  std::int64_t changes() const noexcept { return changes_; }  // times another source took over

 private:
  bool believed(const RobotState& state, std::int64_t now_ns) const noexcept {
    const std::int64_t silence = now_ns - heard_ns_;
    if (!heard_ || silence >= kLongSilence) return true;
    const bool in_order = state.tick >= tick_ && state.tick - tick_ <= kFarthestJump;
    if (state.run_id == run_id_ && state.term == term_) return in_order;
    if (state.run_id == run_id_ && state.term == term_ + 2 && grant_run_id_ != 0) {
      return in_order;  // cancel
    }
    if (state.run_id == former_run_id_ && state.term == former_term_ + 2 &&
        state.term == term_ + 1) {
      return state.tick - tick_ >= -kGrantTicks &&
             state.tick - tick_ <= kFarthestJump;  // cancel, after its successor
    }
    if (grant_run_id_ != 0 && state.run_id == grant_run_id_ && state.term == term_ + 1) {
      // The holder goes on until it sees its successor, so a slow one may be a few ticks behind it.
      return state.tick >= grant_tick_ && state.tick - tick_ >= -kGrantTicks &&
             state.tick - tick_ <= kFarthestJump;
    }
    return silence >= kSilence && state.term > term_;
  }

  static constexpr std::int64_t kGrantTicks =
      16;  // a successor may be so many ticks behind the holder, and a cancel behind the successor

  bool heard_ = false;
  std::int64_t heard_ns_ = 0;
  std::int64_t run_id_ = 0;
  std::int64_t former_run_id_ = -1;
  std::int32_t term_ = 0;
  std::int32_t former_term_ = 0;
  std::int64_t tick_ = 0;
  std::int64_t grant_run_id_ = 0;
  std::int64_t grant_tick_ = 0;
  std::int64_t ignored_ = 0;
  std::int64_t changes_ = 0;
};

}  // namespace twinbus::lcmtypes
