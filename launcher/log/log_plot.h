// Curves over time, in panels one above the other, as SVG.  A title may have several lines.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

struct Curve {
  std::string name;
  std::vector<double> x, y;  // of equal length
};

struct Panel {
  std::string title;  // with its unit
  std::vector<Curve> curves;
};

std::string svg_of(const std::string& title, const std::vector<Panel>& panels);

}  // namespace twinbus
