// Through which face of a box each probe came: the side from which it is pushed out for as long as it touches.
//
// The nearest face turns round when a probe passes the middle of the box, and a thin plate then pushes a fast body out on the other
// side; a spring of k [N/m] lets through what has m v^2 > k (r + t/2)^2 (mass m, speed v, radius r, thickness t).  With the
// face of entry kept it brings back whatever comes, however soft it is (Redon, Kheddar, Coquillart 2002: continuous detection
// keeps the order of things along the way).  Without allocation but for the first time that so many probes touch.

#pragma once

#include <cstddef>
#include <vector>

namespace twinbus::inline sim {

class EntryFaces {
 public:
  void reserve(std::size_t most) {
    now_.reserve(most);
    next_.reserve(most);
    saved_.reserve(most);
  }
  // The face (axis * 2, + 1 for the negative side) by which the contact of this key came; -1: it is new.
  int of(int key) noexcept {
    for (std::size_t seen = 0; seen < now_.size(); ++seen) {
      const Entry& entry = now_[cursor_++ % now_.size()];
      if (entry.key == key) return entry.face;
    }
    return -1;
  }
  // Found in this step, and near enough to touch in it.
  void found(int key, int face) { next_.push_back({key, face}); }
  void begin_search() noexcept {
    next_.clear();
    cursor_ = 0;
  }
  // The step was taken as it was found.
  void remember() noexcept { now_ = next_; }
  void forget() noexcept { now_.clear(); }
  void save() noexcept { saved_ = now_; }
  void restore() noexcept { now_ = saved_; }

 private:
  struct Entry {
    int key, face;
  };
  std::vector<Entry> now_, next_, saved_;
  std::size_t cursor_ = 0;  // they are found in the same order at each step
};

}  // namespace twinbus::sim
