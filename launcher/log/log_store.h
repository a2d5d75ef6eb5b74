// The messages of a log around the present moment, found by the hash of their bytes.
//
// Bounded: what comes every tick is kept for seconds, what comes on demand for minutes.

#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

namespace twinbus::inline launcher {

struct StoredMessage {
  std::string channel;
  std::int64_t utime = 0;
  std::vector<std::uint8_t> bytes;
  // Of CONTROLLER_STATUS and GUARD also without compute_ns, which no re-run has again; else the same.
  std::int64_t hash = 0, plain_hash = 0;
};

class LogStore {
 public:
  void add(const std::string& channel, std::int64_t utime, std::vector<std::uint8_t> bytes);
  // Null when it is not there.
  const StoredMessage* find(std::int64_t hash) const;
  // The newest first; until visit says true.
  const StoredMessage* look(const std::string& channel,
                            const std::function<bool(const StoredMessage&)>& visit) const;

 private:
  struct Shelf {
    std::deque<StoredMessage> messages;
    std::int64_t first = 0;  // number of the front one
    std::int64_t keep_us = 0;
    std::size_t most = 0;
  };
  void drop_front(Shelf& shelf);
  static bool on_demand(const std::string& channel);

  Shelf shelves_[2];
  struct Place {
    int shelf;
    std::int64_t number;
  };
  std::unordered_map<std::int64_t, Place> places_;

 public:
  LogStore();
};

// bytes with the one bit flipped that gives them this hash; empty when there is none.
std::vector<std::uint8_t> with_one_bit_mended(std::vector<std::uint8_t> bytes, std::int64_t hash,
                                              std::size_t& byte);

// The first field in which two messages differ, with both numbers: "q[3]: 0.1 in the log, 0.2 now"; empty if none does.
std::string first_difference(const std::string& channel, const std::vector<std::uint8_t>& logged,
                             const std::vector<std::uint8_t>& now, const char* word_for_now);

}  // namespace twinbus::launcher
