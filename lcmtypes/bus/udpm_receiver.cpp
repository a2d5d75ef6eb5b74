#include "lcmtypes/bus/udpm_receiver.h"

#include <arpa/inet.h>
#include <lcm/lcm.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "lcmtypes/bus/socket_filter.h"

namespace twinbus::inline lcmtypes {

namespace {

constexpr int kReceiveBuffer = 4194304;          // [bytes]
constexpr std::size_t kLargestDatagram = 65536;  // [bytes]
constexpr std::size_t kHeader = 8;               // magic and sequence [bytes]
constexpr std::size_t kLongestName = LCM_MAX_CHANNEL_NAME_LENGTH;

[[noreturn]] void fail(const std::string& what, const std::string& remedy) {
  throw std::runtime_error("bus: " + what + " (" + std::strerror(errno) + "); " + remedy);
}

std::int64_t microseconds(const timeval& time) {
  return std::int64_t{1'000'000} * time.tv_sec + time.tv_usec;
}

// When the kernel received it, or now where it does not say.
std::int64_t arrival_us(msghdr& message) {
  for (cmsghdr* c = CMSG_FIRSTHDR(&message); c != nullptr; c = CMSG_NXTHDR(&message, c)) {
    if (c->cmsg_level != SOL_SOCKET || c->cmsg_type != SCM_TIMESTAMP) continue;
    timeval time;
    std::memcpy(&time, CMSG_DATA(c), sizeof time);
    return microseconds(time);
  }
  timeval now;
  gettimeofday(&now, nullptr);
  return microseconds(now);
}

}  // namespace

bool has_route(const std::string& address, std::string& why) {
  const int fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(9);
  inet_pton(AF_INET, address.c_str(), &to.sin_addr);
  const bool found = fd >= 0 && connect(fd, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  why = found ? "" : std::strerror(errno);
  if (fd >= 0) close(fd);
  return found;
}

MulticastGroup multicast_group(const std::string& url) {
  const std::size_t begin = std::strlen("udpm://");
  const std::string network = url.substr(begin, url.find('?', begin) - begin);
  const std::size_t colon = network.find(':');
  MulticastGroup group;
  if (const std::string address = network.substr(0, colon); !address.empty()) {
    in_addr parsed{};
    if (inet_pton(AF_INET, address.c_str(), &parsed) != 1 || !IN_MULTICAST(ntohl(parsed.s_addr))) {
      throw std::invalid_argument("--url " + url +
                                  ": the address must be a multicast one, as 239.255.76.67");
    }
    group.address = address;
  }
  if (colon == std::string::npos) return group;
  const std::string digits = network.substr(colon + 1);
  const bool number =
      !digits.empty() && digits.size() <= 5 &&
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  group.port = number ? std::stoi(digits) : 0;
  if (!(group.port > 0 && group.port < 65536)) {
    throw std::invalid_argument("--url " + url + ": the port must be 1 .. 65535");
  }
  return group;
}

UdpmReceiver::UdpmReceiver(const MulticastGroup& group, std::vector<std::uint32_t> allowed)
    : allowed_(std::move(allowed)), buffer_(new std::uint8_t[kLargestDatagram]) {
  socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket_ < 0) fail("no socket", "are too many files open? see ulimit -n");
  try {
    // Closed to everything before anything can arrive.
    filter();
    const int on = 1;
    (void)setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    (void)setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMP, &on, sizeof on);
    (void)enlarge_receive_buffer(socket_, kReceiveBuffer);
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_port = htons(static_cast<std::uint16_t>(group.port));
    (void)inet_pton(AF_INET, group.address.c_str(), &where.sin_addr);
    // Bound to the group, not to every address: what is sent to this machine alone is not LCM.
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&where), sizeof where) != 0) {
      fail("cannot listen to port " + std::to_string(group.port), "does another program own it?");
    }
    ip_mreq membership{};
    membership.imr_multiaddr = where.sin_addr;
    if (setsockopt(socket_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0) {
      fail("cannot join " + group.address, kNoRoute);
    }
  } catch (...) {
    close(socket_);
    throw;
  }
}

UdpmReceiver::~UdpmReceiver() { close(socket_); }

void UdpmReceiver::hear(const std::string& channel) {
  if (std::find(channels_.begin(), channels_.end(), channel) != channels_.end()) return;
  channels_.push_back(channel);
  filter();
}

void UdpmReceiver::hear_all() {
  all_ = true;
  filter();
}

void UdpmReceiver::filter() {
  if (!(all_ ? attach_filter(socket_, allowed_) : attach_filter(socket_, allowed_, channels_))) {
    fail("the kernel refuses the socket filter", "at most 64 --allow");
  }
}

bool UdpmReceiver::next(Datagram& datagram) noexcept {
  for (;;) {
    std::array<char, 64> control;
    iovec piece{buffer_.get(), kLargestDatagram};
    msghdr message{};
    message.msg_iov = &piece;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t size = recvmsg(socket_, &message, 0);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return false;
    const std::size_t whole = static_cast<std::size_t>(size);
    const std::size_t most = std::min(whole, kHeader + kLongestName + 1);
    const std::uint8_t* name = buffer_.get() + std::min(kHeader, whole);
    const void* end = most > kHeader ? std::memchr(name, 0, most - kHeader) : nullptr;
    if (end == nullptr) {
      ++malformed_;
      continue;
    }
    const std::uint8_t* payload = static_cast<const std::uint8_t*>(end) + 1;
    datagram.channel = reinterpret_cast<const char*>(name);
    datagram.bytes = {payload, static_cast<std::size_t>(buffer_.get() + whole - payload)};
    datagram.wall_time_us = arrival_us(message);
    return true;
  }
}

}  // namespace twinbus::lcmtypes
