// What is told of a device that does not answer: at once when it lasts, seldom and counted when it is ridden out.
//
// A source rides out read failures of 20 ms; on a busy machine single ones come by the dozen, and nobody has to act.

#pragma once

#include <cstdint>
#include <cstdio>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/status.h"

namespace twinbus::inline bridge {

class DeviceTeller {
 public:
  // The adaptor's status at this instant of the steady clock [ns], once per tick or more often.  Fills text and severity of
  // event; false when there is nothing to say.
  bool next(Status status, std::int64_t now_ns, Event& event) noexcept {
    const bool good = status == Status::kOk;
    if (good != good_) {
      if (good) ended(now_ns);
      good_ = good;
      since_ns_ = now_ns;
    }
    if (!good) {
      if (now_ns - since_ns_ < kRiddenOut_ns || told_ == status) return false;
      told_ = status;
      return say(event, 1, "device: %s", to_text(status));
    }
    if (told_ != Status::kOk) {
      if (now_ns - since_ns_ < kRiddenOut_ns) return false;
      told_ = Status::kOk;
      return say(event, 0, "device: %s", to_text(Status::kOk));
    }
    if (short_ < kMany || (told_ns_ != 0 && now_ns - told_ns_ < kSeldom_ns)) return false;
    say(event, 0, "device: %d short failures, the longest %.0f ms, in the last %.0f s; they were ridden out", short_,
        1e-6 * static_cast<double>(longest_ns_), 1e-9 * static_cast<double>(now_ns - first_ns_));
    told_ns_ = now_ns;
    short_ = 0;
    longest_ns_ = 0;
    return true;
  }

 private:
  static constexpr std::int64_t kRiddenOut_ns = 20'000'000, kSeldom_ns = 60'000'000'000;
  static constexpr int kMany = 25;  // fewer short failures are not told

  void ended(std::int64_t now_ns) noexcept {
    if (told_ != Status::kOk) return;  // a long one, which was told
    if (short_++ == 0) first_ns_ = since_ns_;
    if (now_ns - since_ns_ > longest_ns_) longest_ns_ = now_ns - since_ns_;
  }

  template <class... Values>
  static bool say(Event& event, int severity, const char* format, Values... values) noexcept {
    event.severity = static_cast<std::int8_t>(severity);
    event.text.fill('\0');
    std::snprintf(event.text.data(), event.text.size(), format, values...);
    return true;
  }

  bool good_ = true;
  Status told_ = Status::kOk;
  int short_ = 0;  // since they were told last
  std::int64_t since_ns_ = 0, first_ns_ = 0, longest_ns_ = 0, told_ns_ = 0;
};

}  // namespace twinbus::bridge
