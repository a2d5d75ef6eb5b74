// Pieces of a picture in SVG, as text.

#pragma once

#include <string>
#include <vector>

namespace twinbus::inline common {

// Six digits.
std::string svg_number(double x);
// `more`: further attributes.
std::string svg_text(double x, double y, const std::string& text, const std::string& more = "");
std::string svg_line(double x1, double y1, double x2, double y2, const std::string& more = "stroke=\"#ddd\"");
std::string svg_box(double x, double y, double width, double height, const std::string& more);
// A white sheet with these pieces.
std::string svg_sheet(double width, double height, const std::string& pieces);
// Round numbers, at most so many of them between two limits: 1, 2 or 5 times a power of ten apart.
std::vector<double> svg_ticks(double low, double high, int most);

}  // namespace twinbus::common
