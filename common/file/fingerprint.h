// 128 bits that stand for some bytes: the name of what was found from them, and a check that a file is whole.
//
// Every step is a bijection of the state, so two inputs of one length that differ in a single word never share a
// fingerprint.  No defence against somebody who looks for two inputs alike.

#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "common/math/splitmix64.h"
#include "common/text/formatted.h"

namespace twinbus::inline common {

struct Fingerprint {
  std::uint64_t high = 0, low = 0;
  bool operator==(const Fingerprint&) const = default;
  std::string text() const {
    return formatted("%016llx%016llx", static_cast<unsigned long long>(high), static_cast<unsigned long long>(low));
  }
};

class FingerprintMaker {
 public:
  FingerprintMaker& add(std::string_view bytes) {
    word(bytes.size());
    while (bytes.size() >= 8) {
      std::uint64_t next = 0;
      std::memcpy(&next, bytes.data(), 8);
      word(next);
      bytes.remove_prefix(8);
    }
    std::uint64_t last = 0;
    std::memcpy(&last, bytes.data(), bytes.size());
    word(last);
    return *this;
  }
  // Numbers bit by bit.
  template <class Number>
  requires std::is_arithmetic_v<Number> FingerprintMaker& add(Number value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof value);
    word(bits);
    return *this;
  }
  // Of things without holes: numbers and arrays of them.
  template <class Item>
  FingerprintMaker& add_all(const std::vector<Item>& items) {
    return add(
        std::string_view(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item)));
  }
  Fingerprint value() const { return {SplitMix64::mixed(high_ ^ low_ << 1), SplitMix64::mixed(low_ + high_)}; }

 private:
  void word(std::uint64_t w) {
    high_ = (high_ ^ w) * 0x9e3779b97f4a7c15U;
    high_ ^= high_ >> 32;
    low_ = (low_ + w) * 0xd6e8feb86659fd93U;
    low_ ^= low_ >> 29;
  }

  std::uint64_t high_ = 0x243f6a8885a308d3U, low_ = 0x13198a2e03707344U;
};

}  // namespace twinbus::common
