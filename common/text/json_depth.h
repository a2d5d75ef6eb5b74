// How deep a JSON text nests, before anything that calls itself for every level copies or writes it.

#pragma once

#include <cstdint>
#include <string>

namespace twinbus::inline common {

// Of what a page asks, the same for the viewer, which takes it, and for `up`, which does it.
constexpr int kDeepestWish = 8;                                  // brackets within each other
constexpr std::int64_t kLargestSave = std::int64_t{1} << 53;  // what a page counts to

// A text that is no JSON is refused by its parser, whatever this says of it.
inline bool nests_deeper(const std::string& json, int most) {
  int depth = 0;
  bool within_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (within_string && c == '\\') ++i;
    else if (c == '"') within_string = !within_string;
    else if (within_string) continue;
    else if (c == '{' || c == '[') ++depth;
    else if (c == '}' || c == ']') --depth;
    if (depth > most) return true;
  }
  return false;
}

}  // namespace twinbus::common
