#include "common/text/closest_name.h"

#include <algorithm>
#include <cctype>

namespace twinbus::inline common {

std::size_t edits(const std::string& a, const std::string& b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row[b.size()];
}

namespace {

// With the fewest edits, at most `most`; short: also one of which nothing would be left.
std::string closest(const std::string& name, const std::vector<std::string>& candidates,
                    std::size_t most, bool short_ones) {
  if (name.size() > 200) return {};
  std::string best;
  std::size_t fewest = most + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t count = edits(name, candidate);
    if (count >= fewest || (!short_ones && count >= candidate.size())) continue;
    fewest = count;
    best = candidate;
  }
  return best;
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  return closest(name, candidates, std::max<std::size_t>(2, name.size() / 3), true);
}

std::string misspelt_name(const std::string& name, const std::vector<std::string>& candidates,
                          std::size_t most) {
  return closest(name, candidates, most, false);
}

std::string suggestion(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string near = nearest_name(name, candidates);
  if (!near.empty()) return "; did you mean " + near + "?";
  if (candidates.empty()) return {};
  std::string list = "; known: ";
  for (std::size_t i = 0; i < candidates.size() && i < 12; ++i) {
    if (i > 0) list += ", ";
    list += candidates[i];
  }
  if (candidates.size() > 12) list += ", ...";
  return list;
}

}  // namespace twinbus::common
