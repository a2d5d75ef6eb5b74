// Places for connections from other machines that have shown no token yet: few, and none is kept by being slow.
//
// Knows nothing of sockets, so that it can be tested without.

#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <string>
#include <utility>

namespace twinbus::inline viewer_log {

class StrangerSeats {
 public:
  struct Seat {
    std::string address;          // of the other machine
    std::function<void()> close;  // the connection, which then leaves
  };
  using Place = std::list<Seat>::iterator;

  explicit StrangerSeats(std::size_t most) : most_(std::max<std::size_t>(1, most)) {}

  // When all are taken, the oldest of the machine that has most of them loses its own: whoever opens many connections keeps
  // out nobody else.  Counted in `crowds` then.
  template <class Count>
  Place take(Seat seat, Count& crowds) {
    if (seats_.size() >= most_) {
      ++crowds;
      std::map<std::string, int> count;
      for (const Seat& one : seats_) ++count[one.address];
      const auto most =
          std::max_element(count.begin(), count.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      const auto oldest = std::find_if(seats_.begin(), seats_.end(),
                                       [&](const Seat& one) { return one.address == most->first; });
      const std::function<void()> close = oldest->close;
      close();
    }
    return seats_.insert(seats_.end(), std::move(seat));
  }
  void leave(Place place) { seats_.erase(place); }
  std::size_t size() const { return seats_.size(); }

 private:
  std::size_t most_;
  std::list<Seat> seats_;  // the oldest first
};

}  // namespace twinbus::viewer_log
