// A world that can be drawn on paper: two joints, and walls with doors between them.

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "planner/search/free_space.h"

namespace twinbus {

inline JointPoint point2(double x, double y) {
  JointPoint q(2);
  q << x, y;
  return q;
}

class FlatWorld : public FreeSpace {
 public:
  struct Wall {  // |x - at| < 0.1 is solid but for |y - door| < half
    double at, door, half;
  };
  std::vector<Wall> walls;
  int asked = 0;  // lines

  bool point_free(const JointPoint& q) override {
    return std::none_of(walls.begin(), walls.end(), [&](const Wall& wall) {
      return std::abs(q[0] - wall.at) < 0.1 && !(std::abs(q[1] - wall.door) < wall.half);
    });
  }
  bool line_free(const JointPoint& from, const JointPoint& to) override {
    ++asked;
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / 1e-3)));
    for (int i = 0; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      if (!point_free(from + share * (to - from))) return false;
    }
    return true;
  }
  bool path_free(const JointPath& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      if (!line_free(path[i], path[i + 1])) return false;
    }
    return true;
  }
};

}  // namespace twinbus
