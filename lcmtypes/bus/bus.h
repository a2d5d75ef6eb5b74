// The only class that talks to LCM.
//
//   Bus bus(options);
//   Latest<RobotState> state;
//   bus.listen(channel::kState, state);
//   bus.receive(0.002);                       // waits, then handles all that has come
//   if (state.take(newest)) ...
//   bus.send(channel::kCommand, command);
//
// Messages have fixed size, so sending and receiving allocate nothing and a malformed datagram can
// only be dropped. One thread owns a bus.  Handlers must not throw and must not call receive().

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/process/options.h"
#include "lcmtypes/bus/channel_health.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/handler.h"
#include "lcmtypes/bus/inbox.h"
#include "lcmtypes/bus/wire.h"

struct _lcm_t;
struct _lcm_recv_buf_t;

namespace twinbus::inline lcmtypes {

class UdpmReceiver;

struct BusOptions {
  std::string url = default_url();  // udpm:// memq:// file://
  std::string prefix;               // before every channel: letters, digits and _, at most 20
  std::vector<std::string>
      allow;  // IPv4 addresses of other machines that may send to us, or several by commas
};

class Bus {
 public:
  // Throws std::runtime_error if the network cannot be opened, std::invalid_argument for a bad
  // option.
  explicit Bus(const BusOptions& options);
  ~Bus();

  // Before the loop: these allocate, and throw std::runtime_error if the channel cannot be opened.
  // What is passed by reference must outlive the bus; a handler that is a temporary, as a lambda written in the call, is kept.

  // The newest admitted message.
  template <class T>
  void listen(const Channel<T>& channel, Latest<T>& latest) {
    subscribe(channel, kQueue, &latest, &on_latest<T>);
  }
  // The newest admitted message of each sender.
  template <class T, int N>
  void listen(const Channel<T>& channel, Slots<T, N>& slots) {
    subscribe(channel, kLongQueue, &slots, &on_slots<T, N>);
  }
  // Every message, in order: handler(const T&), with std::span<const std::uint8_t> bytes or std::int64_t now_ns (the steady
  // clock when it came) where it takes one, called inside receive().
  template <class T, class Handler>
  void listen(const Channel<T>& channel, Handler& handler) {
    static_assert(kHears<Handler, T>,
                  "Bus::listen: the handler takes const T& of the channel's message T, then std::span<const std::uint8_t> or std::int64_t "
                  "where it wants the bytes or the time");
    subscribe(channel, kLongQueue, const_cast<std::remove_const_t<Handler>*>(&handler),
              &on_each<T, CallItself{}, Handler>);
  }
  template <class T, class Handler>
    requires(!std::is_lvalue_reference_v<Handler>)
  void listen(const Channel<T>& channel, Handler&& handler) {
    const auto kept = std::make_shared<std::remove_const_t<Handler>>(std::move(handler));
    kept_.push_back(kept);
    listen(channel, *kept);
  }
  // The same to a method: listen<&Guard::hear_state>(channel::kState, *this).
  template <auto kMethod, class Owner>
  void listen(const Channel<MessageOf<kMethod>>& channel, Owner& owner) {
    subscribe(channel, kLongQueue, &owner, &on_each<MessageOf<kMethod>, kMethod, Owner>);
  }
  // For tools: everything on channels that match a regular expression, with the prefix taken off
  // and unchecked: handler(const char* channel, std::span<const std::uint8_t> bytes, std::int64_t
  // wall_time_us).  queue: messages that may wait for receive().
  template <class Handler>
  void listen_raw(const char* pattern, Handler& handler, int queue = kLongQueue) {
    subscribe(pattern, queue, const_cast<std::remove_const_t<Handler>*>(&handler),
              &on_raw<Handler>);
  }

  // Waits up to timeout_s (0: does not wait; finer than a millisecond) for anything to arrive, then
  // handles what is queued, at most kMostPerCall messages.  Returns how many; -1 at the end of a
  // log or when the network is gone.
  int receive(double timeout_s) noexcept;

  // False if the message is not fit to send or could not be sent.
  template <class T>
  [[nodiscard]] bool send(const Channel<T>& channel, const T& value) noexcept {
    std::array<std::uint8_t, kLargestMessage> bytes;
    const int size = encode(value, bytes);
    return send_raw(channel, std::span(bytes.data(), static_cast<std::size_t>(size)));
  }
  [[nodiscard]] bool send_raw(const char* channel, std::span<const std::uint8_t> bytes) noexcept;

  // Readable when receive(0) has something to do: for poll() together with other descriptors.
  int fileno() const noexcept;
  const BusCounters& counters() const noexcept { return counters_; }
  // The heartbeat with how each channel does that is listened to by its name.
  Heartbeat with_channels(Heartbeat beat) const noexcept;
  [[nodiscard]] bool send_heartbeat(const Heartbeat& beat) noexcept;
  // Datagrams dropped by the kernel: foreign, split, of a channel nobody here listens to, or no room.
  // 0 where there is no socket.
  std::int64_t dropped_datagrams() const noexcept;

  static constexpr int kMostPerCall = 2048;  // bounds the work of one call under a flood

 private:
  static constexpr int kQueue = 64;  // memq and logs: LCM drops the newest when full
  static constexpr int kLongQueue = 1024;  // channels on which no message replaces another

  struct Incoming {
    const char* channel;
    std::span<const std::uint8_t> bytes;
    std::int64_t wall_time_us;
    std::int64_t now_ns;  // steady clock
    bool whole;           // false: LCM gave an impossible size
  };
  template <class Handler, class T>
  static constexpr bool kHears =
      std::is_invocable_v<Handler&, const T&> || std::is_invocable_v<Handler&, const T&, std::int64_t> ||
      std::is_invocable_v<Handler&, const T&, std::span<const std::uint8_t>>;

  using Handle = void (*)(void* target, const Incoming&, ChannelHealth&) noexcept;
  struct Subscription;

  void subscribe(const char* channel, int queue, void* target, Handle handle);
  void give(Subscription& subscription, const Incoming& in) noexcept;
  static void on_message(const _lcm_recv_buf_t* buffer, const char* channel, void* user) noexcept;
  int take_datagrams() noexcept;

  template <class T>
  static bool decode_or_count(const Incoming& in, T& value, BusCounters& counters) noexcept {
    if (in.whole && decode(in.bytes, value) == Status::kOk) return true;
    ++counters.rejected;
    return false;
  }
  static void tally(Verdict verdict, std::int64_t lost, BusCounters& counters) noexcept {
    counters.received += verdict == Verdict::kTaken;
    counters.repeated += verdict == Verdict::kRepeated;
    counters.rejected += verdict == Verdict::kRejected;
    counters.lost += lost;
  }

  template <class T>
  static void on_latest(void* target, const Incoming& in, ChannelHealth& health) noexcept {
    BusCounters& counters = health.counters;
    auto& latest = *static_cast<Latest<T>*>(target);
    T value;
    if (!decode_or_count(in, value, counters)) {
      ++latest.rejected;
      return;
    }
    const std::int64_t lost = latest.lost;
    const Verdict verdict = latest.offer(value, in.now_ns);
    tally(verdict, latest.lost - lost, counters);
  }
  template <class T, int N>
  static void on_slots(void* target, const Incoming& in, ChannelHealth& health) noexcept {
    BusCounters& counters = health.counters;
    auto& slots = *static_cast<Slots<T, N>*>(target);
    T value;
    if (!decode_or_count(in, value, counters)) {
      ++slots.rejected;
      return;
    }
    tally(slots.offer(value, in.now_ns), 0, counters);
  }
  template <class T, auto kCall, class Target>
  static void on_each(void* target, const Incoming& in, ChannelHealth& health) noexcept {
    BusCounters& counters = health.counters;
    T value;
    if (!decode_or_count(in, value, counters)) return;
    ++counters.received;
    if constexpr (Wire<T>::kCounted) health.follow(Wire<T>::sender(value), Wire<T>::count(value));
    auto& called = *static_cast<Target*>(target);
    if constexpr (std::is_invocable_v<decltype(kCall), Target&, const T&, decltype(in.bytes)>) {
      std::invoke(kCall, called, value, in.bytes);
    } else if constexpr (std::is_invocable_v<decltype(kCall), Target&, const T&, std::int64_t>) {
      std::invoke(kCall, called, value, in.now_ns);
    } else {
      std::invoke(kCall, called, value);
    }
  }
  template <class Handler>
  static void on_raw(void* target, const Incoming& in, ChannelHealth& health) noexcept {
    BusCounters& counters = health.counters;
    if (!in.whole) {
      ++counters.rejected;
      return;
    }
    ++counters.received;
    (*static_cast<Handler*>(target))(in.channel, in.bytes, in.wall_time_us);
  }

  BusOptions options_;
  _lcm_t* lcm_ = nullptr;
  std::unique_ptr<UdpmReceiver> receiver_;  // of udpm; the other providers are received by liblcm
  BusCounters counters_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  std::vector<std::shared_ptr<void>> kept_;  // handlers that were temporaries
};

}  // namespace twinbus::lcmtypes
