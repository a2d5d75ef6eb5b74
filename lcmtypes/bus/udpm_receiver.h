// Receives LCM's multicast datagrams in the thread that wants them.
//
// liblcm receives in a thread of its own, which hands every datagram over through a pipe: two
// wake-ups where one does.  On two processes and one answer per tick that is most of the time from
// STATE to COMMAND (./twinbus bench bus shows both).  Sending, memq and log files stay liblcm's.

#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace twinbus::inline lcmtypes {

// What udpm://ADDRESS:PORT?options names.
struct MulticastGroup {
  std::string address = "239.255.76.67";
  int port = 7667;
};

// What an account can do where no datagram finds a way.
inline constexpr char kNoRoute[] =
    "no multicast route? an administrator runs once: ip link set lo up && ip route add 224.0.0.0/4 "
    "dev lo (without one: ./twinbus --own-network ...)";

// Whether the kernel knows a way for a datagram to this address; else why not.  Sends none.
bool has_route(const std::string& address, std::string& why);

// Throws std::invalid_argument naming what is wrong with the URL.
MulticastGroup multicast_group(const std::string& url);

class UdpmReceiver {
 public:
  // Hears this machine and the allowed addresses (host byte order), and no channel yet.  Throws
  // std::runtime_error with the remedy if the socket cannot be opened or filtered.
  UdpmReceiver(const MulticastGroup& group, std::vector<std::uint32_t> allowed);
  ~UdpmReceiver();
  UdpmReceiver(const UdpmReceiver&) = delete;
  UdpmReceiver& operator=(const UdpmReceiver&) = delete;

  // From now on also this channel, or every channel.  Throws std::runtime_error.
  void hear(const std::string& channel);
  void hear_all();

  struct Datagram {
    const char* channel = nullptr;  // ends with a zero
    std::span<const std::uint8_t> bytes;
    std::int64_t wall_time_us = 0;  // when it reached this machine
  };

  // The next datagram, valid until the next call; false if none is waiting.  Never waits.
  bool next(Datagram& datagram) noexcept;

  int fileno() const noexcept { return socket_; }
  // Datagrams that were no message: no channel name, or one that never ends.
  std::int64_t malformed() const noexcept { return malformed_; }

 private:
  void filter();

  int socket_ = -1;
  std::vector<std::uint32_t> allowed_;
  std::vector<std::string> channels_;
  bool all_ = false;
  std::int64_t malformed_ = 0;
  std::unique_ptr<std::uint8_t[]> buffer_;
};

}  // namespace twinbus::lcmtypes
