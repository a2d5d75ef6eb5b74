// Where numbered things are in a list: open addressing, without allocation after reserve().

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace twinbus::inline common {

class KeyIndex {
 public:
  // Of keys that are not negative.
  void reserve(std::size_t most) {
    places_.assign(std::bit_ceil(2 * most + 1), {-1, -1});
    used_.reserve(most);
  }
  void clear() noexcept {
    for (const std::size_t place : used_) places_[place].key = -1;
    used_.clear();
  }
  // The first of a key is kept.
  void add(int key, int index) noexcept {
    const std::size_t place = place_of(key);
    if (places_[place].key >= 0 || used_.size() == used_.capacity()) return;
    places_[place] = {key, index};
    used_.push_back(place);
  }
  int find(int key) const noexcept {  // -1: not there
    if (places_.empty()) return -1;
    const Place& place = places_[place_of(key)];
    return place.key >= 0 ? place.index : -1;
  }

 private:
  struct Place {
    int key, index;
  };
  std::size_t place_of(int key) const noexcept {
    const std::size_t last = places_.size() - 1;
    std::size_t place = (static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15ULL >> 32) & last;
    while (places_[place].key >= 0 && places_[place].key != key) place = (place + 1) & last;
    return place;
  }

  std::vector<Place> places_;
  std::vector<std::size_t> used_;
};

}  // namespace twinbus::common
