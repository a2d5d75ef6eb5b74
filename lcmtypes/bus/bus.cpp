#include "lcmtypes/bus/bus.h"

#include <lcm/lcm.h>
#include <poll.h>
#include <regex.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "common/process/process.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/socket_filter.h"
#include "lcmtypes/bus/udpm_receiver.h"

namespace twinbus::inline lcmtypes {

namespace {

constexpr std::size_t kLongestPrefix = 20;
constexpr std::size_t kLongestChannel = LCM_MAX_CHANNEL_NAME_LENGTH;

bool starts_with(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

// Only letters, digits and _: as a pattern it matches nothing but itself.
bool is_plain(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  });
}

void check_prefix(const std::string& prefix) {
  if (!is_plain(prefix) || prefix.size() > kLongestPrefix) {
    throw std::invalid_argument("--prefix " + prefix +
                                ": only letters, digits and _, at most 20, as in R1_");
  }
}

// Each entry: nothing, one address, or several by commas.
std::vector<std::uint32_t> addresses_of(const std::vector<std::string>& allow) {
  std::vector<std::uint32_t> addresses;
  for (const std::string& list : allow) {
    for (std::size_t begin = 0; !list.empty() && begin <= list.size();) {
      const std::size_t end = std::min(list.find(',', begin), list.size());
      addresses.push_back(parse_ipv4(list.substr(begin, end - begin)));
      begin = end + 1;
    }
  }
  return addresses;
}

// As liblcm understands a channel: an extended regular expression that matches the whole name.
class Pattern {
 public:
  explicit Pattern(const std::string& expression) {
    const std::string whole = "^(" + expression + ")$";
    if (regcomp(&compiled_, whole.c_str(), REG_EXTENDED | REG_NOSUB) != 0) {
      throw std::runtime_error("bus: no regular expression: " + expression);
    }
  }
  ~Pattern() { regfree(&compiled_); }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;

  bool matches(const char* name) const noexcept {
    return regexec(&compiled_, name, 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_;
};

void check_provider(const std::string& url) {
  for (const char* provider : {"udpm://", "memq://", "file://"}) {
    if (starts_with(url, provider)) return;
  }
  throw std::invalid_argument("--url " + url + ": must begin with udpm://, memq:// or file://");
}

}  // namespace

struct Bus::Subscription {
  Bus* bus;
  void* target;
  Handle handle;
  std::string name;                  // with the prefix
  std::unique_ptr<Pattern> pattern;  // none: the name itself
  std::int8_t row = 0;               // in the table of channels, from 1; 0: a pattern
  ChannelHealth health{};

  bool takes(const char* channel) const noexcept {
    return pattern ? pattern->matches(channel) : name == channel;
  }
};

Bus::Bus(const BusOptions& options) : options_(options) {
  check_prefix(options.prefix);
  check_provider(options.url);
  const bool on_network = starts_with(options.url, "udpm://");
  const std::vector<std::uint32_t> allowed = addresses_of(options.allow);
  const MulticastGroup group = on_network ? multicast_group(options.url) : MulticastGroup{};
  // liblcm would say it in twelve lines of its own.
  if (std::string why; on_network && !has_route(group.address, why))
    throw std::runtime_error("bus: cannot open " + options.url + " (" + why + "): " + kNoRoute);
  lcm_ = lcm_create(options.url.c_str());
  if (lcm_ == nullptr) {
    throw std::runtime_error(
        "bus: cannot open " + options.url +
        (on_network ? std::string(": ") + kNoRoute : ": is the file there and readable?"));
  }
  try {
    if (on_network) receiver_ = std::make_unique<UdpmReceiver>(group, allowed);
  } catch (...) {
    lcm_destroy(lcm_);
    throw;
  }
}

Bus::~Bus() { lcm_destroy(lcm_); }

void Bus::subscribe(const char* channel, int queue, void* target, Handle handle) {
  const std::string name = options_.prefix + channel;
  if (name.size() > kLongestChannel) throw std::runtime_error("bus: channel too long: " + name);
  auto subscription =
      std::make_unique<Subscription>(Subscription{this, target, handle, name, nullptr});
  const std::span<const ChannelInfo> table = channel_table();
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (std::strcmp(table[i].channel, channel) == 0)
      subscription->row = static_cast<std::int8_t>(i + 1);
  }
  if (receiver_) {
    if (is_plain(name)) {
      receiver_->hear(name);
    } else {
      subscription->pattern = std::make_unique<Pattern>(name);
      receiver_->hear_all();
    }
  } else {
    lcm_subscription_t* of_lcm = lcm_subscribe(lcm_, name.c_str(), &on_message, subscription.get());
    if (of_lcm == nullptr) throw std::runtime_error("bus: cannot subscribe to " + name);
    lcm_subscription_set_queue_capacity(of_lcm, queue);
  }
  subscriptions_.push_back(std::move(subscription));
}

void Bus::on_message(const lcm_recv_buf_t* buffer, const char* channel, void* user) noexcept {
  Subscription& subscription = *static_cast<Subscription*>(user);
  Bus& bus = *subscription.bus;
  const bool whole = buffer->data_size <= LCM_MAX_MESSAGE_SIZE;  // a wrapped size is larger
  const Incoming in{
      .channel = channel + std::min(bus.options_.prefix.size(), std::strlen(channel)),
      .bytes = {static_cast<const std::uint8_t*>(buffer->data), whole ? buffer->data_size : 0},
      .wall_time_us = buffer->recv_utime,
      .now_ns = monotonic_ns(),
      .whole = whole};
  bus.give(subscription, in);
}

void Bus::give(Subscription& subscription, const Incoming& in) noexcept {
  ChannelHealth& health = subscription.health;
  const BusCounters before = health.counters;
  subscription.handle(subscription.target, in, health);
  counters_.received += health.counters.received - before.received;
  counters_.rejected += health.counters.rejected - before.rejected;
  counters_.lost += health.counters.lost - before.lost;
  counters_.repeated += health.counters.repeated - before.repeated;
  if (health.counters.received > before.received) health.arrived(in.now_ns);
}

bool Bus::send_heartbeat(const Heartbeat& beat) noexcept {
  return send(channel::kHeartbeat, with_channels(beat));
}

Heartbeat Bus::with_channels(Heartbeat beat) const noexcept {
  const std::int64_t now = monotonic_ns();
  const auto number = [](std::int64_t x) {
    return static_cast<std::int32_t>(std::min<std::int64_t>(x, INT32_MAX));
  };
  std::size_t rows = 0;
  for (const auto& one : subscriptions_) {
    if (one->row == 0 || rows == kHeardChannels) continue;
    const ChannelHealth& health = one->health;
    beat.channel[rows] = one->row;
    beat.channel_received[rows] = number(health.counters.received);
    beat.channel_lost[rows] = number(health.counters.lost);
    beat.channel_repeated[rows] = number(health.counters.repeated);
    beat.channel_rejected[rows] = number(health.counters.rejected);
    beat.channel_age_ms[rows] = static_cast<float>(1e-6 * static_cast<double>(health.age_ns(now)));
    beat.channel_jitter_us[rows] = static_cast<float>(1e-3 * health.jitter_ns());
    ++rows;
  }
  beat.channels = static_cast<std::int8_t>(rows);
  return beat;
}

int Bus::receive(double timeout_s) noexcept {
  pollfd ready{.fd = fileno(), .events = POLLIN, .revents = 0};
  const double wait = timeout_s > 0.0 ? std::min(timeout_s, 1e6) : 0.0;
  const double whole_seconds = std::floor(wait);
  const timespec timeout{.tv_sec = static_cast<time_t>(whole_seconds),
                         .tv_nsec = static_cast<long>(1e9 * (wait - whole_seconds))};
  if (ppoll(&ready, 1, &timeout, nullptr) <= 0) return 0;
  if (receiver_) return take_datagrams();
  int handled = 0;
  do {
    if (lcm_handle(lcm_) < 0) return handled > 0 ? handled : -1;
    ++handled;
  } while (handled < kMostPerCall && poll(&ready, 1, 0) > 0);
  return handled;
}

int Bus::take_datagrams() noexcept {
  const std::int64_t malformed = receiver_->malformed();
  UdpmReceiver::Datagram datagram;
  int handled = 0;
  for (; handled < kMostPerCall && receiver_->next(datagram); ++handled) {
    const std::size_t prefix = std::min(options_.prefix.size(), std::strlen(datagram.channel));
    const Incoming in{.channel = datagram.channel + prefix,
                      .bytes = datagram.bytes,
                      .wall_time_us = datagram.wall_time_us,
                      .now_ns = monotonic_ns(),
                      .whole = true};
    for (const auto& subscription : subscriptions_) {
      if (!subscription->takes(datagram.channel)) continue;
      give(*subscription, in);
    }
  }
  counters_.rejected += receiver_->malformed() - malformed;
  return handled;
}

bool Bus::send_raw(const char* channel, std::span<const std::uint8_t> bytes) noexcept {
  std::array<char, kLongestChannel + 1> name;
  const int length =
      std::snprintf(name.data(), name.size(), "%s%s", options_.prefix.c_str(), channel);
  if (!bytes.empty() && length > 0 && length <= static_cast<int>(kLongestChannel) &&
      lcm_publish(lcm_, name.data(), bytes.data(), static_cast<unsigned>(bytes.size())) == 0) {
    ++counters_.sent;
    return true;
  }
  ++counters_.send_failures;
  return false;
}

int Bus::fileno() const noexcept { return receiver_ ? receiver_->fileno() : lcm_get_fileno(lcm_); }

std::int64_t Bus::dropped_datagrams() const noexcept {
  return receiver_ ? twinbus::dropped_datagrams(receiver_->fileno()) : 0;
}

}  // namespace twinbus::lcmtypes
