#include "launcher/log/log_plot.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace twinbus {

namespace {

constexpr double kWidth = 900.0, kHeight = 200.0, kLeft = 70.0, kTop = 40.0, kGap = 46.0;
constexpr std::size_t kMostPoints = 1500;
constexpr std::array<const char*, 8> kColours = {"#1f5fa8", "#d1602a", "#3a8f4d", "#8a5aa8",
                                                 "#b8860b", "#0f8b8d", "#c2185b", "#555555"};

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

std::string safe(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

std::string label(double x, double y, const std::string& text, const char* more = "") {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + more + ">" + safe(text) +
         "</text>\n";
}

void draw(const Panel& panel, double top, std::string& svg) {
  double x_low = 1e300, x_high = -1e300, y_low = 1e300, y_high = -1e300;
  for (const Curve& curve : panel.curves) {
    for (const double x : curve.x) x_low = std::min(x_low, x), x_high = std::max(x_high, x);
    for (const double y : curve.y) y_low = std::min(y_low, y), y_high = std::max(y_high, y);
  }
  if (!(x_high > x_low)) x_high = x_low + 1.0;
  if (!(y_high > y_low)) y_high = y_low + 1e-9;
  svg += "<rect x=\"" + number(kLeft) + "\" y=\"" + number(top) + "\" width=\"" + number(kWidth) +
         "\" height=\"" + number(kHeight) + "\" fill=\"none\" stroke=\"#888\"/>\n";
  svg += label(kLeft, top - 6.0, panel.title, "font-weight=\"bold\"");
  svg += label(kLeft - 6.0, top + 10.0, number(y_high), "text-anchor=\"end\"");
  svg += label(kLeft - 6.0, top + kHeight, number(y_low), "text-anchor=\"end\"");
  svg += label(kLeft, top + kHeight + 14.0, number(x_low) + " s");
  svg += label(kLeft + kWidth, top + kHeight + 14.0, number(x_high) + " s", "text-anchor=\"end\"");
  double name_x = kLeft + kWidth;
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    const char* colour = kColours[c % kColours.size()];
    svg += "<polyline fill=\"none\" stroke-width=\"1.2\" stroke=\"" + std::string(colour) +
           "\" points=\"";
    const std::size_t step = std::max<std::size_t>(1, curve.x.size() / kMostPoints);
    for (std::size_t i = 0; i < curve.x.size(); i += step) {
      const double x = kLeft + kWidth * (curve.x[i] - x_low) / (x_high - x_low);
      const double y = top + kHeight * (1.0 - (curve.y[i] - y_low) / (y_high - y_low));
      svg += number(x) + "," + number(y) + " ";
    }
    svg += "\"/>\n";
    std::string style = "text-anchor=\"end\" fill=\"";
    style += colour;
    style += "\"";
    svg += label(name_x, top - 6.0, curve.name, style.c_str());
    name_x -= 8.0 * static_cast<double>(curve.name.size()) + 16.0;
  }
}

}  // namespace

std::string svg_of(const std::string& title, const std::vector<Panel>& panels) {
  const double height = kTop + 20.0 + static_cast<double>(panels.size()) * (kHeight + kGap);
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(kLeft + kWidth + 20.0) +
      "\" height=\"" + number(height) +
      "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"white\"/>\n";
  svg += label(kLeft, 18.0, title, "font-size=\"15\"");
  double top = kTop + 10.0;
  for (const Panel& panel : panels) {
    draw(panel, top, svg);
    top += kHeight + kGap;
  }
  return svg + "</svg>\n";
}

}  // namespace twinbus
