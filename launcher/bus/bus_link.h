// The launcher's end of the bus: everything heard goes into a StackMonitor, operator messages go out.

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "launcher/bus/stack_monitor.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/step_list.h"

namespace twinbus::inline lcmtypes {
struct BusOptions;
}  // namespace twinbus::lcmtypes

namespace twinbus::inline launcher {

constexpr double kFirstState = 2.0;  // until a robot must be heard [s]

class BusLink {
 public:
  // url empty: $LCM_DEFAULT_URL, else the project's own.  Throws std::runtime_error if the bus cannot be opened.
  // allow: IPv4 addresses of other machines whose messages are taken.
  BusLink(const std::string& url, const std::string& prefix,
          const std::vector<std::string>& allow = {});
  ~BusLink();

  // Waits up to so many seconds for anything, then takes in all that is there.
  void receive(double seconds);
  // Goes on receiving for so many seconds, or until the program is asked to end.
  void listen(double seconds);
  // Also gives every encoded STATE to handler, as it came.
  void on_raw_state(std::function<void(std::span<const std::uint8_t>)> handler);

  StackMonitor& seen() { return seen_; }
  const std::string& url() const { return url_; }
  std::int64_t sender_id() const { return sender_id_; }

  // A request: fills in utime, sender_id and, where it is 0, the next sequence.  Throws std::runtime_error if the datagram
  // cannot be sent.
  template <class T>
  void send(T& request);
  // Sends it every so many seconds until answered() holds.  False when it does not in time.
  template <class Request, class Answered>
  bool ask(Request& request, double every, double timeout, const Answered& answered) {
    const std::int64_t begin = monotonic_ns();
    std::int64_t asked = 0;
    while (!quit_requested() && seconds_since(begin) < timeout) {
      if (asked == 0 || seconds_since(asked) > every) {
        asked = monotonic_ns();
        send(request);
      }
      receive(0.01);
      if (answered()) return true;
    }
    return false;
  }
  // Plain text on EVENT; severity as in event_t, that of an alarm is 2.
  void tell(const std::string& sentence, int severity);
  void alarm(const std::string& sentence);

 private:
  struct Impl;
  template <class T>
  void stamp(T& message);

  StackMonitor seen_;
  std::string url_;
  std::int64_t sender_id_;
  std::int32_t sequence_;  // begins anywhere: a source answers by it, and an answer to somebody before is none to us
  std::unique_ptr<Impl> impl_;
};

// As --url, --prefix and --allow say.
BusOptions bus_options(const Arguments& arguments);
// On that bus; Ctrl-C ends what waits on it.
BusLink open_bus(const Arguments& arguments);

// Waits up to so many seconds for a source that holds STATE; null if there is none.
const SeenSource* wait_for_active(BusLink& bus, double seconds);
// After a second of waiting.  Throws std::runtime_error if there is none.
const SeenSource& active_source(BusLink& bus);

// "simulator run 123 (term 4, active)"
std::string describe(const SeenSource& source);

}  // namespace twinbus::launcher
