// Ticks, and pages of a journal, that a sender must have sent and a log does not have.
//
// Only what one sender sent for one holder of STATE counts up by one: a source that a switch takes away from STATE says its
// next tick there when it is switched back to, and a world that is begun anew begins at tick 1.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "viewer_log/log/log_event.h"
#include "viewer_log/log/message_schema.h"

namespace twinbus::inline launcher {

class LogGaps {
 public:
  // Every event of a log, in its order.
  void add(const LogEvent& event);
  std::int64_t missing(const std::string& channel) const;

 private:
  struct Columns {  // schema null: nothing of this channel is counted; a field that is null is not in it
    const MessageSchema* schema = nullptr;
    const MessageField *count = nullptr, *sender = nullptr, *run = nullptr, *term = nullptr;
  };
  static Columns columns_of(std::string_view channel);
  void see_holder(std::int64_t run, std::int64_t term);

  std::map<std::string, Columns, std::less<>> columns_;
  std::map<std::tuple<std::string, std::int64_t, std::int64_t>, std::int64_t> last_;  // by channel, sender and run
  std::map<std::string, std::int64_t> missing_;
  std::int64_t holder_ = 0, term_ = 0;
};

}  // namespace twinbus::launcher
