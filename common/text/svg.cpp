#include "common/text/svg.h"

#include <cmath>

#include "common/text/formatted.h"
#include "common/text/xml.h"

namespace twinbus::inline common {

std::string svg_number(double x) {
  return formatted("%.6g", x);
}

std::string svg_text(double x, double y, const std::string& text, const std::string& more) {
  return "<text x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" " + more + ">" + xml_escaped(text) + "</text>\n";
}

std::string svg_line(double x1, double y1, double x2, double y2, const std::string& more) {
  return "<line x1=\"" + svg_number(x1) + "\" y1=\"" + svg_number(y1) + "\" x2=\"" + svg_number(x2) + "\" y2=\"" +
         svg_number(y2) + "\" " + more + "/>\n";
}

std::string svg_box(double x, double y, double width, double height, const std::string& more) {
  return "<rect x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" width=\"" + svg_number(width) + "\" height=\"" +
         svg_number(height) + "\" " + more + "/>\n";
}

std::string svg_sheet(double width, double height, const std::string& pieces) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + svg_number(width) + "\" height=\"" + svg_number(height) +
         "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" + pieces +
         "</svg>\n";
}

std::vector<double> svg_ticks(double low, double high, int most) {
  const double least = (high - low) / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= least) step = factor * power;
  }
  std::vector<double> found;
  if (!(step > 0.0) || !std::isfinite(step)) return found;
  for (double at = std::ceil(low / step) * step; at <= high + 1e-9 * step && found.size() < 30;
       at += step)
    found.push_back(std::abs(at) < 1e-9 * step ? 0.0 : at);
  return found;
}

}  // namespace twinbus::common
