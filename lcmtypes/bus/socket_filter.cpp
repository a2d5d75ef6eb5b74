#include "lcmtypes/bus/socket_filter.h"

#include <arpa/inet.h>
#include <linux/filter.h>
#include <linux/if_packet.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <stdexcept>

namespace twinbus::inline lcmtypes {

namespace {

constexpr std::uint32_t kUnsplit = 0x4c433032;  // "LC02"; split messages start with "LC03"
constexpr std::uint32_t kSource = static_cast<std::uint32_t>(SKF_NET_OFF) + 12;  // IPv4 source
constexpr std::uint32_t kPacketType = static_cast<std::uint32_t>(SKF_AD_OFF + SKF_AD_PKTTYPE);
constexpr std::uint32_t kInterface = static_cast<std::uint32_t>(SKF_AD_OFF + SKF_AD_IFINDEX);
constexpr std::uint32_t kMagic = 8;           // first word after the UDP header
constexpr std::uint32_t kChannel = 16;        // after magic and sequence; the name ends with a zero
constexpr std::uint32_t kWhole = 0xffffffff;  // of a datagram
constexpr std::size_t kMostAllowed = 64;

sock_filter load(std::uint32_t where, std::uint16_t size = BPF_W) {
  return {static_cast<std::uint16_t>(BPF_LD | size | BPF_ABS), 0, 0, where};
}
sock_filter jump_if(std::uint32_t value, std::size_t when_equal, std::size_t otherwise) {
  return {static_cast<std::uint16_t>(BPF_JMP | BPF_JEQ | BPF_K),
          static_cast<std::uint8_t>(when_equal), static_cast<std::uint8_t>(otherwise), value};
}
sock_filter answer(std::uint32_t bytes) {
  return {static_cast<std::uint16_t>(BPF_RET | BPF_K), 0, 0, bytes};
}

// Goes on behind itself if the datagram is unsplit and its sender may be heard, refuses otherwise.
//
// The kernel marks multicast that it loops back to its own machine PACKET_LOOPBACK; no datagram
// from a wire can carry that mark, so own datagrams are known without knowing own addresses.
void check_sender(const std::vector<std::uint32_t>& allowed, std::vector<sock_filter>& code) {
  const std::size_t n = allowed.size();
  code.push_back(load(kMagic));
  code.push_back(jump_if(kUnsplit, 1, 0));
  code.push_back(answer(0));
  code.push_back(load(kPacketType));
  code.push_back(jump_if(PACKET_LOOPBACK, n + 4, 0));  // -> behind
  code.push_back(load(kInterface));
  code.push_back(jump_if(if_nametoindex("lo"), n + 2, 0));  // -> behind
  code.push_back(load(kSource));
  for (std::size_t i = 0; i < n; ++i) code.push_back(jump_if(allowed[i], n - i, 0));  // -> behind
  code.push_back(answer(0));
}

// Accepts the channel of this name, and goes on behind itself with any other.
void accept_channel(const std::string& name, std::vector<sock_filter>& code) {
  const std::size_t size = name.size() + 1;  // with its zero
  struct Piece {
    std::size_t at;
    std::uint16_t load;
    std::size_t bytes;
  };
  std::vector<Piece> pieces;
  std::size_t at = 0;
  for (; at + 4 <= size; at += 4) pieces.push_back({at, BPF_W, 4});
  if (at + 2 <= size) pieces.push_back({at, BPF_H, 2}), at += 2;
  if (at < size) pieces.push_back({at, BPF_B, 1});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < pieces[i].bytes; ++k) {
      const auto byte = static_cast<unsigned char>(name.c_str()[pieces[i].at + k]);
      value = value << 8 | byte;
    }
    code.push_back(load(kChannel + static_cast<std::uint32_t>(pieces[i].at), pieces[i].load));
    code.push_back(jump_if(value, 0, 2 * (pieces.size() - 1 - i) + 1));  // -> behind
  }
  code.push_back(answer(kWhole));
}

bool attach(int socket, std::vector<sock_filter>& code) {
  const sock_fprog fprog{static_cast<unsigned short>(code.size()), code.data()};
  return setsockopt(socket, SOL_SOCKET, SO_ATTACH_FILTER, &fprog, sizeof fprog) == 0;
}

}  // namespace

std::uint32_t parse_ipv4(const std::string& text) {
  in_addr address{};
  if (inet_pton(AF_INET, text.c_str(), &address) != 1) {
    throw std::invalid_argument("--allow " + text +
                                ": not an IPv4 address; write it as 10.0.0.2, several by commas");
  }
  return ntohl(address.s_addr);
}

bool attach_filter(int socket, const std::vector<std::uint32_t>& allowed) {
  if (allowed.size() > kMostAllowed) return false;
  std::vector<sock_filter> code;
  check_sender(allowed, code);
  code.push_back(answer(kWhole));
  return attach(socket, code);
}

bool attach_filter(int socket, const std::vector<std::uint32_t>& allowed,
                   const std::vector<std::string>& channels) {
  if (allowed.size() > kMostAllowed) return false;
  std::vector<sock_filter> code;
  check_sender(allowed, code);
  for (const std::string& name : channels) accept_channel(name, code);
  code.push_back(answer(0));
  return code.size() <= BPF_MAXINSNS ? attach(socket, code) : attach_filter(socket, allowed);
}

std::int64_t dropped_datagrams(int socket) {
  std::array<std::uint32_t, SK_MEMINFO_VARS> info{};
  socklen_t size = sizeof info;
  if (getsockopt(socket, SOL_SOCKET, SO_MEMINFO, info.data(), &size) != 0) return -1;
  return info[SK_MEMINFO_DROPS];
}

int enlarge_receive_buffer(int socket, int bytes) {
  if (setsockopt(socket, SOL_SOCKET, SO_RCVBUFFORCE, &bytes, sizeof bytes) != 0) {
    (void)setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
  }
  int now = 0;
  socklen_t size = sizeof now;
  (void)getsockopt(socket, SOL_SOCKET, SO_RCVBUF, &now, &size);
  return now;
}

}  // namespace twinbus::lcmtypes
