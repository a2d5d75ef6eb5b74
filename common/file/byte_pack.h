// Numbers one behind the other in a string of bytes, and back: for files that the same kind of machine reads again.
//
// Unpacker takes any bytes: what is not there reads as nothing, and whole() is false from then on.

#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace twinbus::inline common {

class Packer {
 public:
  template <class Item>
  Packer& put(const Item& item) {
    static_assert(std::is_trivially_copyable_v<Item>);
    bytes_.append(reinterpret_cast<const char*>(&item), sizeof item);
    return *this;
  }
  // How many, then each.
  template <class Item>
  Packer& put_all(const std::vector<Item>& items) {
    static_assert(std::is_trivially_copyable_v<Item>);
    put(static_cast<std::uint64_t>(items.size()));
    bytes_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
    return *this;
  }
  const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : left_(bytes) {}

  template <class Item>
  Item get() {
    static_assert(std::is_trivially_copyable_v<Item>);
    Item item{};
    if (left_.size() < sizeof item) {
      broken_ = true;
      left_ = {};
    } else {
      std::memcpy(static_cast<void*>(&item), left_.data(), sizeof item);
      left_.remove_prefix(sizeof item);
    }
    return item;
  }
  // Never makes room for more than is there.
  template <class Item>
  std::vector<Item> get_all() {
    static_assert(std::is_trivially_copyable_v<Item>);
    const auto count = get<std::uint64_t>();
    if (count > left_.size() / sizeof(Item)) broken_ = true;
    std::vector<Item> items(broken_ ? 0 : static_cast<std::size_t>(count));
    if (items.empty()) return items;
    std::memcpy(static_cast<void*>(items.data()), left_.data(), items.size() * sizeof(Item));
    left_.remove_prefix(items.size() * sizeof(Item));
    return items;
  }
  // All that was asked for was there, and nothing is left.
  bool whole() const noexcept { return !broken_ && left_.empty(); }
  bool broken() const noexcept { return broken_; }

 private:
  std::string_view left_;
  bool broken_ = false;
};

}  // namespace twinbus::common
