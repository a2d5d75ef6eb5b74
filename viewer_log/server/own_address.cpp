#include "viewer_log/server/own_address.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>

#include <array>

namespace twinbus::inline viewer_log {

std::string address_for_others(bool v6) {
  std::string found = v6 ? "[::1]" : "127.0.0.1";
  ifaddrs* list = nullptr;
  if (getifaddrs(&list) != 0) return found;
  for (const ifaddrs* one = list; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != (v6 ? AF_INET6 : AF_INET)) continue;
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (v6) {
      const in6_addr& address = reinterpret_cast<const sockaddr_in6*>(one->ifa_addr)->sin6_addr;
      if (IN6_IS_ADDR_LOOPBACK(&address) || IN6_IS_ADDR_LINKLOCAL(&address)) continue;
      if (inet_ntop(AF_INET6, &address, text.data(), text.size()) == nullptr) continue;
      found = std::string("[") + text.data() + "]";
    } else {
      const in_addr& address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr;
      if ((ntohl(address.s_addr) >> 24) == 127) continue;
      if (inet_ntop(AF_INET, &address, text.data(), text.size()) == nullptr) continue;
      found = text.data();
    }
    break;
  }
  freeifaddrs(list);
  return found;
}

}  // namespace twinbus::viewer_log
