// Curves over time, in panels one above the other, as SVG.  A title may have several lines.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace twinbus::inline launcher {

struct Curve {
  std::string name;
  std::vector<double> x, y;  // of equal length
};

// Adds points to a curve; of a long run every second, fourth ... of them.
class CurveFiller {
 public:
  void add(Curve& curve, double x, double y);

 private:
  std::size_t every_ = 1, seen_ = 0;
};

struct Panel {
  std::string title;  // with its unit
  std::vector<Curve> curves;
};

std::string svg_of(const std::string& title, const std::vector<Panel>& panels);

}  // namespace twinbus::launcher
