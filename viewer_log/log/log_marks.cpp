#include "viewer_log/log/log_marks.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "common/text/formatted.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/lies_down.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr std::int64_t kSilence = 25'000;     // without STATE [us]
constexpr std::int64_t kGuardRest = 200'000;  // a guard that lets go for less goes on [us]
constexpr std::size_t kMostSenders = 64;

}  // namespace

const char* label(MarkKind kind) noexcept {
  constexpr const char* kNames[] = {"switch", "stop", "fall", "guard", "missed", "message"};
  return kNames[static_cast<std::size_t>(kind)];
}

void MarkFinder::add(std::int64_t utime, MarkKind kind, std::string text) {
  if (marks_.size() >= kMostMarks) {
    ++left_out_;
    return;
  }
  marks_.push_back({1e-6 * static_cast<double>(utime - first_utime_), kind, std::move(text)});
}

void MarkFinder::on_state(const RobotState& state, std::int64_t utime) {
  const bool anew = last_state_utime_ != 0 && state.run_id != last_.run_id && state.tick < last_.tick;
  if (last_state_utime_ != 0 && utime - last_state_utime_ > kSilence) {
    // Nothing is missing of a world that stood still because it was asked to, or is another one now.
    const bool paused = paused_run_ == state.run_id && state.tick == last_.tick + 1;
    const char* const what = anew ? "the world ended; it was begun anew after" : paused ? "paused for" : "no STATE for";
    const std::string text = formatted("%s %.0f ms", what, 1e-3 * static_cast<double>(utime - last_state_utime_));
    add(last_state_utime_, anew || paused ? MarkKind::kMessage : MarkKind::kMissed, text);
  }
  paused_run_ = 0;
  if (anew) upright_ = true;  // another robot than the one that lay
  if (state.run_id != last_.run_id || state.term != last_.term) {
    std::string text = label(state.source);
    text += " holds STATE, term ";
    text += std::to_string(state.term);
    add(utime, MarkKind::kSwitch, std::move(text));
  }
  if (state.stop_kind != last_.stop_kind) {
    std::string text = state.stop_kind == StopKind::kNone ? "stop cleared" : "stop: ";
    if (state.stop_kind != StopKind::kNone) text += label(state.stop_kind);
    add(utime, MarkKind::kStop, std::move(text));
  }
  last_ = state;
  last_state_utime_ = utime;
}

void MarkFinder::on_estimate(const Estimate& estimate, std::int64_t utime) {
  const bool now = !lies_down(estimate);
  if (upright_ && !now) add(utime, MarkKind::kFall, "tilted by more than 60 degrees");
  upright_ = now;
}

void MarkFinder::on_guard(const GuardReport& report, std::int64_t utime) {
  if (report.hold_mask != 0) {
    if (!holding_) {
      std::string text = "guard holds joints (";
      text += label(report.verdict);
      text += ")";
      add(utime, MarkKind::kGuard, std::move(text));
    }
    holding_ = true;
    quiet_since_ = utime;
  } else if (utime - quiet_since_ > kGuardRest) {
    holding_ = false;
  }
}

void MarkFinder::on_source_status(const SourceStatus& status, std::int64_t utime) {
  const auto [known, is_new] = missed_.try_emplace(status.run_id, status.ticks_missed);
  const std::int64_t more = status.ticks_missed - known->second;
  if (!is_new && more > 0) {
    std::string text = label(status.source);
    text += ": ";
    text += std::to_string(more);
    text += more == 1 ? " tick missed" : " ticks missed";
    add(utime, MarkKind::kMissed, std::move(text));
  }
  known->second = status.ticks_missed;
  constexpr std::int8_t kPaused = 4;  // of SourceStatus::pace
  if (status.pace == kPaused) paused_run_ = status.run_id;
  if (missed_.size() > kMostSenders) missed_.erase(missed_.begin());
}

void MarkFinder::on_event(const Event& event, std::int64_t utime) {
  const auto known = std::find_if(told_.begin(), told_.end(),
                                  [&](const auto& e) { return e.first == event.sender_id; });
  if (known != told_.end() && known->second == event.sequence) return;  // said again
  if (known != told_.end()) {
    known->second = event.sequence;
  } else {
    if (told_.size() >= kMostSenders) told_.erase(told_.begin());
    told_.emplace_back(event.sender_id, event.sequence);
  }
  const std::string words(event.text.data(), strnlen(event.text.data(), event.text.size()));
  std::string text = label(event.kind);
  text += ": ";
  text += words;
  const bool fall =
      words.find("fell") != std::string::npos || words.find("fallen") != std::string::npos;
  add(utime, fall ? MarkKind::kFall : MarkKind::kMessage, std::move(text));
}

}  // namespace twinbus::viewer_log
