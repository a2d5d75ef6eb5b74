#include "launcher/log/log_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace twinbus {

namespace {

constexpr double kWidth = 900.0, kHeight = 200.0, kLeft = 70.0, kTop = 40.0, kGap = 46.0;
constexpr std::size_t kMostPoints = 1500;
constexpr int kTicksUp = 5, kTicksAcross = 10;
constexpr std::size_t kTitle = 110;  // letters of a line
constexpr double kLine = 18.0;
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

// Round numbers, at most so many of them between two limits: 1, 2 or 5 times a power of ten apart.
std::vector<double> ticks(double low, double high, int most) {
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

// What does not fit on a line loses its middle.
std::string fitted(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  const std::size_t half = most / 2 - 2;
  return text.substr(0, half) + " ... " + text.substr(text.size() - half);
}

void line(double x1, double y1, double x2, double y2, std::string& svg) {
  svg += "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
         "\" y2=\"" + number(y2) + "\" stroke=\"#ddd\"/>\n";
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
  for (const double tick : ticks(y_low, y_high, kTicksUp)) {
    const double y = top + kHeight * (1.0 - (tick - y_low) / (y_high - y_low));
    line(kLeft, y, kLeft + kWidth, y, svg);
    svg += label(kLeft - 6.0, y + 4.0, number(tick), "text-anchor=\"end\"");
  }
  for (const double tick : ticks(x_low, x_high, kTicksAcross)) {
    const double x = kLeft + kWidth * (tick - x_low) / (x_high - x_low);
    line(x, top, x, top + kHeight, svg);
    svg += label(x, top + kHeight + 14.0, number(tick) + " s", "text-anchor=\"middle\"");
  }
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
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin <= title.size();) {
    const std::size_t end = std::min(title.find('\n', begin), title.size());
    lines.push_back(fitted(title.substr(begin, end - begin), kTitle));
    begin = end + 1;
  }
  const double head = kTop + kLine * static_cast<double>(lines.size() - 1);
  const double height = head + 20.0 + static_cast<double>(panels.size()) * (kHeight + kGap);
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(kLeft + kWidth + 20.0) +
      "\" height=\"" + number(height) +
      "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"white\"/>\n";
  for (std::size_t i = 0; i < lines.size(); ++i)
    svg += label(kLeft, 18.0 + kLine * static_cast<double>(i), lines[i], "font-size=\"14\"");
  double top = head + 10.0;
  for (const Panel& panel : panels) {
    draw(panel, top, svg);
    top += kHeight + kGap;
  }
  return svg + "</svg>\n";
}

}  // namespace twinbus
