// Joint and link numbers are int, as in the messages; containers count in std::size_t.

#pragma once

#include <cstddef>
#include <cstdint>

namespace twinbus::inline common {

constexpr std::size_t at(int index) noexcept { return static_cast<std::size_t>(index); }

// The bit of a joint in a hold mask; 0 <= joint < 64.
constexpr std::int64_t bit(int joint) noexcept { return std::int64_t{1} << joint; }

}  // namespace twinbus::common
