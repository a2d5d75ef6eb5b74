#include "launcher/log/log_plot.h"

#include <algorithm>
#include <array>

#include "common/text/svg.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kWidth = 900.0, kHeight = 200.0, kLeft = 70.0, kTop = 40.0, kGap = 46.0;
constexpr std::size_t kMostPoints = 1500;
constexpr std::size_t kMostKept = 200'000;  // points of a curve
constexpr int kTicksUp = 5, kTicksAcross = 10;
constexpr std::size_t kTitle = 110;  // letters of a line
constexpr double kLine = 18.0;
constexpr std::array<const char*, 8> kColours = {"#1f5fa8", "#d1602a", "#3a8f4d", "#8a5aa8",
                                                 "#b8860b", "#0f8b8d", "#c2185b", "#555555"};

// What does not fit on a line loses its middle.
std::string fitted(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  const std::size_t half = most / 2 - 2;
  return text.substr(0, half) + " ... " + text.substr(text.size() - half);
}

void draw(const Panel& panel, double top, std::string& svg) {
  double x_low = 1e300, x_high = -1e300, y_low = 1e300, y_high = -1e300;
  for (const Curve& curve : panel.curves) {
    for (const double x : curve.x) x_low = std::min(x_low, x), x_high = std::max(x_high, x);
    for (const double y : curve.y) y_low = std::min(y_low, y), y_high = std::max(y_high, y);
  }
  if (!(x_high > x_low)) x_high = x_low + 1.0;
  if (!(y_high > y_low)) y_high = y_low + 1e-9;
  svg += svg_box(kLeft, top, kWidth, kHeight, "fill=\"none\" stroke=\"#888\"");
  svg += svg_text(kLeft, top - 6.0, panel.title, "font-weight=\"bold\"");
  for (const double tick : svg_ticks(y_low, y_high, kTicksUp)) {
    const double y = top + kHeight * (1.0 - (tick - y_low) / (y_high - y_low));
    svg += svg_line(kLeft, y, kLeft + kWidth, y);
    svg += svg_text(kLeft - 6.0, y + 4.0, svg_number(tick), "text-anchor=\"end\"");
  }
  for (const double tick : svg_ticks(x_low, x_high, kTicksAcross)) {
    const double x = kLeft + kWidth * (tick - x_low) / (x_high - x_low);
    svg += svg_line(x, top, x, top + kHeight);
    svg += svg_text(x, top + kHeight + 14.0, svg_number(tick) + " s", "text-anchor=\"middle\"");
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
      svg += svg_number(x) + "," + svg_number(y) + " ";
    }
    svg += "\"/>\n";
    std::string style = "text-anchor=\"end\" fill=\"";
    style += colour;
    style += "\"";
    svg += svg_text(name_x, top - 6.0, curve.name, style);
    name_x -= 8.0 * static_cast<double>(curve.name.size()) + 16.0;
  }
}

}  // namespace

void CurveFiller::add(Curve& curve, double x, double y) {
  if (seen_++ % every_ != 0) return;
  curve.x.push_back(x);
  curve.y.push_back(y);
  if (curve.x.size() < kMostKept) return;
  for (std::vector<double>* values : {&curve.x, &curve.y}) {
    for (std::size_t i = 0; 2 * i < values->size(); ++i) (*values)[i] = (*values)[2 * i];
    values->resize((values->size() + 1) / 2);
  }
  every_ *= 2;
}

std::string svg_of(const std::string& title, const std::vector<Panel>& panels) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin <= title.size();) {
    const std::size_t end = std::min(title.find('\n', begin), title.size());
    lines.push_back(fitted(title.substr(begin, end - begin), kTitle));
    begin = end + 1;
  }
  const double head = kTop + kLine * static_cast<double>(lines.size() - 1);
  const double height = head + 20.0 + static_cast<double>(panels.size()) * (kHeight + kGap);
  std::string svg;
  for (std::size_t i = 0; i < lines.size(); ++i)
    svg += svg_text(kLeft, 18.0 + kLine * static_cast<double>(i), lines[i], "font-size=\"14\"");
  double top = head + 10.0;
  for (const Panel& panel : panels) {
    draw(panel, top, svg);
    top += kHeight + kGap;
  }
  return svg_sheet(kLeft + kWidth + 20.0, height, svg);
}

}  // namespace twinbus::launcher
