// What an enumerator is called in sentences for people.

#pragma once

#include <cstddef>

namespace twinbus::inline common {

// names[i] of the enumerator with value i; otherwise for a value that this version does not know.
template <class E, std::size_t N>
constexpr const char* name_of(E value, const char* const (&names)[N],
                              const char* otherwise = "unknown") noexcept {
  const auto i = static_cast<std::size_t>(value);
  return i < N ? names[i] : otherwise;
}

}  // namespace twinbus::common
