#include "lcmtypes/socket_filter.h"

#include <arpa/inet.h>
#include <dirent.h>
#include <linux/filter.h>
#include <linux/if_packet.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace twinbus {

namespace {

constexpr std::uint32_t kUnsplit = 0x4c433032;  // "LC02"; split messages start with "LC03"
constexpr std::uint32_t kSource = static_cast<std::uint32_t>(SKF_NET_OFF) + 12;  // IPv4 source
constexpr std::uint32_t kPacketType = static_cast<std::uint32_t>(SKF_AD_OFF + SKF_AD_PKTTYPE);
constexpr std::uint32_t kInterface = static_cast<std::uint32_t>(SKF_AD_OFF + SKF_AD_IFINDEX);
constexpr std::uint32_t kMagic = 8;  // first word after the UDP header
constexpr std::size_t kMostAllowed = 64;

sock_filter load(std::uint32_t where) {
  return {static_cast<std::uint16_t>(BPF_LD | BPF_W | BPF_ABS), 0, 0, where};
}
sock_filter jump_if(std::uint32_t value, std::size_t when_equal, std::size_t otherwise) {
  return {static_cast<std::uint16_t>(BPF_JMP | BPF_JEQ | BPF_K),
          static_cast<std::uint8_t>(when_equal), static_cast<std::uint8_t>(otherwise), value};
}
sock_filter answer(std::uint32_t bytes) {
  return {static_cast<std::uint16_t>(BPF_RET | BPF_K), 0, 0, bytes};
}

// The kernel marks multicast that it loops back to its own machine PACKET_LOOPBACK; no datagram
// from a wire can carry that mark, so own datagrams are known without knowing own addresses.
std::vector<sock_filter> program(const std::vector<std::uint32_t>& allowed) {
  const std::size_t n = allowed.size();
  std::vector<sock_filter> code;
  code.push_back(load(kMagic));
  code.push_back(jump_if(kUnsplit, 0, n + 6));  // -> refuse
  code.push_back(load(kPacketType));
  code.push_back(jump_if(PACKET_LOOPBACK, n + 3, 0));  // -> accept
  code.push_back(load(kInterface));
  code.push_back(jump_if(if_nametoindex("lo"), n + 1, 0));  // -> accept
  code.push_back(load(kSource));
  for (std::size_t i = 0; i < n; ++i) {
    code.push_back(jump_if(allowed[i], n - 1 - i, i + 1 == n ? 1 : 0));
  }
  if (n == 0) code.back() = answer(0);
  code.push_back(answer(0xffffffff));
  code.push_back(answer(0));
  return code;
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

std::set<int> udp_sockets(int port) {
  std::set<int> found;
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(opendir("/proc/self/fd"), &closedir);
  if (!folder) return found;
  while (const dirent* entry = readdir(folder.get())) {
    const int fd = std::atoi(entry->d_name);
    sockaddr_in self{};
    socklen_t size = sizeof self;
    int type = 0;
    socklen_t type_size = sizeof type;
    if (getsockopt(fd, SOL_SOCKET, SO_TYPE, &type, &type_size) != 0 || type != SOCK_DGRAM) continue;
    if (getsockname(fd, reinterpret_cast<sockaddr*>(&self), &size) != 0) continue;
    if (self.sin_family == AF_INET && ntohs(self.sin_port) == port) found.insert(fd);
  }
  return found;
}

bool attach_filter(int socket, const std::vector<std::uint32_t>& allowed) {
  if (allowed.size() > kMostAllowed) return false;
  std::vector<sock_filter> code = program(allowed);
  const sock_fprog fprog{static_cast<unsigned short>(code.size()), code.data()};
  return setsockopt(socket, SOL_SOCKET, SO_ATTACH_FILTER, &fprog, sizeof fprog) == 0;
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

}  // namespace twinbus
