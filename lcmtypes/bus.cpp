#include "lcmtypes/bus.h"

#include <lcm/lcm.h>
#include <poll.h>
#include <time.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <stdexcept>

#include "lcmtypes/socket_filter.h"

namespace twinbus {

namespace {

constexpr char kOwnUrl[] = "udpm://239.255.76.67:17667?ttl=0&recv_buf_size=4194304";
constexpr int kReceiveBuffer = 4194304;  // [bytes]
constexpr int kLcmPort = 7667;           // of an URL without a port
constexpr std::size_t kLongestPrefix = 20;
constexpr std::size_t kLongestChannel = LCM_MAX_CHANNEL_NAME_LENGTH;

std::int64_t steady_ns() noexcept {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return std::int64_t{1'000'000'000} * t.tv_sec + t.tv_nsec;
}

bool starts_with(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

// The port of udpm://ADDRESS:PORT?options.
int port_of(const std::string& url) {
  const std::size_t begin = std::strlen("udpm://");
  const std::string network = url.substr(begin, url.find('?', begin) - begin);
  const std::size_t colon = network.find(':');
  if (colon == std::string::npos) return kLcmPort;
  const std::string digits = network.substr(colon + 1);
  const bool number =
      !digits.empty() && digits.size() <= 5 &&
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int port = number ? std::atoi(digits.c_str()) : 0;
  if (!(port > 0 && port < 65536)) {
    throw std::invalid_argument("--url " + url + ": the port must be 1 .. 65535");
  }
  return port;
}

void check_prefix(const std::string& prefix) {
  const bool plain = std::all_of(prefix.begin(), prefix.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  });
  if (!plain || prefix.size() > kLongestPrefix) {
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

void check_provider(const std::string& url) {
  for (const char* provider : {"udpm://", "memq://", "file://"}) {
    if (starts_with(url, provider)) return;
  }
  throw std::invalid_argument("--url " + url + ": must begin with udpm://, memq:// or file://");
}

}  // namespace

std::string default_url() {
  const char* url = std::getenv("LCM_DEFAULT_URL");
  return url != nullptr && *url != '\0' ? url : kOwnUrl;
}

const char kBusOptionsHelp[] =
    "  --url URL      LCM network (default: $LCM_DEFAULT_URL, else this project's own port)\n"
    "  --prefix P     put before every channel name, as in R1_\n"
    "  --allow A,B    IPv4 addresses of other machines that may send to this process\n";

bool take_bus_option(int argc, char** argv, int& i, BusOptions& options) {
  const std::string name = argv[i];
  if (name != "--url" && name != "--prefix" && name != "--allow") return false;
  if (i + 1 >= argc) throw std::invalid_argument(name + ": needs a value");
  const std::string value = argv[++i];
  if (name == "--url") {
    check_provider(value);
    options.url = value;
  } else if (name == "--prefix") {
    check_prefix(value);
    options.prefix = value;
  } else {
    (void)addresses_of({value});
    options.allow.push_back(value);
  }
  return true;
}

Bus::Bus(const BusOptions& options) : options_(options) {
  check_prefix(options.prefix);
  check_provider(options.url);
  has_socket_ = starts_with(options.url, "udpm://");
  if (has_socket_) (void)port_of(options.url);
  (void)addresses_of(options.allow);
  lcm_ = lcm_create(options.url.c_str());
  if (lcm_ == nullptr) {
    throw std::runtime_error(
        "bus: cannot open " + options.url +
        (has_socket_ ? ": no multicast route? try `ip route add 224.0.0.0/4 dev lo` as root"
                     : ": is the file there and readable?"));
  }
}

Bus::~Bus() { lcm_destroy(lcm_); }

void Bus::subscribe(const char* channel, int queue, void* target, Handle handle) {
  const std::string name = options_.prefix + channel;
  if (name.size() > kLongestChannel) throw std::runtime_error("bus: channel too long: " + name);
  subscriptions_.push_back(std::make_unique<Subscription>(Subscription{this, target, handle}));

  // LCM opens its receiving socket on the first subscription: the one that was not there before is
  // ours.
  const bool first = has_socket_ && socket_ < 0;
  const int port = first ? port_of(options_.url) : 0;
  const std::set<int> before = first ? udp_sockets(port) : std::set<int>{};
  lcm_subscription_t* subscription =
      lcm_subscribe(lcm_, name.c_str(), &on_message, subscriptions_.back().get());
  if (subscription == nullptr) throw std::runtime_error("bus: cannot subscribe to " + name);
  lcm_subscription_set_queue_capacity(subscription, queue);
  if (!first) return;

  const std::vector<std::uint32_t> allowed = addresses_of(options_.allow);
  for (const int fd : udp_sockets(port)) {
    if (before.count(fd) != 0) continue;
    if (!attach_filter(fd, allowed)) {
      throw std::runtime_error("bus: the kernel refuses the socket filter (at most 64 --allow)");
    }
    (void)enlarge_receive_buffer(fd, kReceiveBuffer);
    socket_ = fd;
  }
  if (socket_ < 0) {
    throw std::runtime_error(
        "bus: LCM's receiving socket was not found, so it cannot be filtered; is the multicast "
        "route "
        "there? try `ip route add 224.0.0.0/4 dev lo` as root");
  }
}

void Bus::on_message(const lcm_recv_buf_t* buffer, const char* channel, void* user) noexcept {
  const Subscription& subscription = *static_cast<const Subscription*>(user);
  Bus& bus = *subscription.bus;
  const bool whole = buffer->data_size <= LCM_MAX_MESSAGE_SIZE;  // a wrapped size is larger
  const Incoming in{
      .channel = channel + std::min(bus.options_.prefix.size(), std::strlen(channel)),
      .bytes = {static_cast<const std::uint8_t*>(buffer->data), whole ? buffer->data_size : 0},
      .wall_time_us = buffer->recv_utime,
      .now_ns = steady_ns(),
      .whole = whole};
  subscription.handle(subscription.target, in, bus.counters_);
}

int Bus::receive(double timeout_s) noexcept {
  pollfd ready{.fd = lcm_get_fileno(lcm_), .events = POLLIN, .revents = 0};
  const double wait = timeout_s > 0.0 ? std::min(timeout_s, 1e6) : 0.0;
  const double whole_seconds = std::floor(wait);
  const timespec timeout{.tv_sec = static_cast<time_t>(whole_seconds),
                         .tv_nsec = static_cast<long>(1e9 * (wait - whole_seconds))};
  if (ppoll(&ready, 1, &timeout, nullptr) <= 0) return 0;
  int handled = 0;
  do {
    if (lcm_handle(lcm_) < 0) return handled > 0 ? handled : -1;
    ++handled;
  } while (handled < kMostPerCall && poll(&ready, 1, 0) > 0);
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

int Bus::fileno() const noexcept { return lcm_get_fileno(lcm_); }

std::int64_t Bus::dropped_datagrams() const noexcept {
  return socket_ < 0 ? 0 : twinbus::dropped_datagrams(socket_);
}

}  // namespace twinbus
