// The known name a user probably meant.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace twinbus::inline common {

// Edits of one character that turn a into b (Levenshtein), capitals ignored.
std::size_t edits(const std::string& a, const std::string& b);

// The candidate with the fewest edits to name, or empty if all are too far away to be a typing
// mistake.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

// The candidate that name is a misspelling of: at most `most` letters added, lost or changed, capitals ignored; empty if
// there is none.
std::string misspelt_name(const std::string& name, const std::vector<std::string>& candidates,
                          std::size_t most);

// "; did you mean X?", or "; known: a, b, c" when nothing is near (at most 12 are listed).
std::string suggestion(const std::string& name, const std::vector<std::string>& candidates);

// The same among the names of what there is.
template <class Named>
std::string suggestion(const std::string& name, const std::vector<Named>& candidates) {
  std::vector<std::string> names;
  for (const Named& each : candidates) names.push_back(each.name);
  return suggestion(name, names);
}

}  // namespace twinbus::common
