#include "planner/shortcut.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace twinbus {

namespace {

struct Place {
  std::size_t line = 0;  // between corner `line` and the next
  JointPoint q;
};

Place place_at(const JointPath& path, double length) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double line = (path[i + 1] - path[i]).norm();
    if (length <= line || i + 2 == path.size()) {
      const double share = line > 0.0 ? std::min(1.0, length / line) : 0.0;
      return {i, path[i] + share * (path[i + 1] - path[i])};
    }
    length -= line;
  }
  return {0, path.front()};
}

void drop_needless_corners(FreeSpace& space, JointPath& path) {
  for (std::size_t i = 1; i + 1 < path.size();) {
    if (space.line_free(path[i - 1], path[i + 1])) {
      path.erase(path.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

}  // namespace

double length_of(const JointPath& path) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1] - path[i]).norm();
  return length;
}

void shortcut(FreeSpace& space, JointPath& path, int rounds, Random& random) {
  drop_needless_corners(space, path);
  for (int round = 0; round < rounds && path.size() > 2; ++round) {
    const double length = length_of(path);
    double first = random.uniform(0.0, length);
    double second = random.uniform(0.0, length);
    if (first > second) std::swap(first, second);
    const Place a = place_at(path, first);
    const Place b = place_at(path, second);
    if (a.line == b.line || !space.line_free(a.q, b.q)) continue;
    JointPath shorter(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(a.line) + 1);
    shorter.push_back(a.q);
    shorter.push_back(b.q);
    shorter.insert(shorter.end(), path.begin() + static_cast<std::ptrdiff_t>(b.line) + 1,
                   path.end());
    if (length_of(shorter) < length - 1e-6) path = std::move(shorter);
  }
  drop_needless_corners(space, path);
}

}  // namespace twinbus
