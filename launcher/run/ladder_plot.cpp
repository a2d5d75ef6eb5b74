#include "launcher/run/ladder_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/math/index.h"
#include "common/text/svg.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kLeft = 80.0, kTop = 60.0, kWidth = 640.0, kHeight = 420.0, kRight = 230.0;
constexpr double kRow = 17.0, kNames = 190.0, kBars = 330.0, kWords = 420.0;
constexpr double kLeast = 1e-9;  // what is nearer to the yardstick is drawn there [m]
constexpr const char* kStrokes[] = {"", "stroke-dasharray=\"7 4\"", "stroke-dasharray=\"2 3\""};

struct Range {
  double low = 1e300, high = -1e300;  // decades
  void take(double x) {
    low = std::min(low, std::floor(std::log10(x)));
    high = std::max(high, std::ceil(std::log10(x)));
  }
  double share(double x) const { return high > low ? (std::log10(x) - low) / (high - low) : 0.5; }
};

constexpr int kInParts = 4;  // a marker beside those of the orders

std::string text_of(const char* format, double x) {
  char text[80];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

// Order 1: a circle, 2: a square, 3: a triangle; 4: a diamond for parts chosen by their local error.
std::string marker(int order, double x, double y, bool hollow) {
  const std::string fill = hollow ? "fill=\"white\" stroke=\"black\"" : "fill=\"black\" stroke=\"black\"";
  if (order == 1) return "<circle cx=\"" + svg_number(x) + "\" cy=\"" + svg_number(y) + "\" r=\"4\" " + fill + "/>\n";
  if (order == 2) return svg_box(x - 4.0, y - 4.0, 8.0, 8.0, fill);
  if (order == kInParts)
    return "<polygon points=\"" + svg_number(x) + "," + svg_number(y - 6.0) + " " + svg_number(x + 6.0) + "," + svg_number(y) + " " +
           svg_number(x) + "," + svg_number(y + 6.0) + " " + svg_number(x - 6.0) + "," + svg_number(y) + "\" " + fill + "/>\n";
  const auto corner = [](double at_x, double at_y) { return svg_number(at_x) + "," + svg_number(at_y) + " "; };
  return "<polygon points=\"" + corner(x, y - 5.5) + corner(x + 5.0, y + 4.0) + corner(x - 5.0, y + 4.0) + "\" " + fill + "/>\n";
}

}  // namespace

std::string front_svg(const std::string& title, const Ladder& ladder, int chosen, double error) {
  const auto off = [&](std::size_t i) { return std::max(kLeast, ladder.estimate(i)); };
  const auto drawn = [&](std::size_t i) {
    return ladder.rungs[i].whole && ladder.rungs[i].cost > 0.0 && std::isfinite(ladder.estimate(i));
  };
  Range across, up;
  for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
    if (!drawn(i)) continue;
    across.take(ladder.rungs[i].cost);
    up.take(1e3 * off(i));
  }
  if (error > 0.0) up.take(1e3 * error);
  if (across.high < across.low) across = up = {0.0, 1.0};
  const auto x_of = [&](double cost) { return kLeft + kWidth * across.share(cost); };
  const auto y_of = [&](double mm) { return kTop + kHeight * (1.0 - up.share(mm)); };
  std::string svg = svg_text(kLeft, 22.0, title, "font-size=\"14\"");
  for (double d = across.low; d <= across.high; d += 1.0) {
    const double x = x_of(std::pow(10.0, d));
    svg += svg_line(x, kTop, x, kTop + kHeight);
    svg += svg_text(x, kTop + kHeight + 16.0, svg_number(std::pow(10.0, d)), "text-anchor=\"middle\"");
  }
  for (double d = up.low; d <= up.high; d += 1.0) {
    const double y = y_of(std::pow(10.0, d));
    svg += svg_line(kLeft, y, kLeft + kWidth, y) + svg_text(kLeft - 6.0, y + 4.0, svg_number(std::pow(10.0, d)), "text-anchor=\"end\"");
  }
  svg += svg_box(kLeft, kTop, kWidth, kHeight, "fill=\"none\" stroke=\"#888\"");
  svg += svg_text(kLeft + 0.5 * kWidth, kTop + kHeight + 34.0, "physics [ms of CPU per simulated second]", "text-anchor=\"middle\"");
  svg += svg_text(kLeft, kTop - 8.0, "largest distance from the converged answer [mm]");
  if (error > 0.0) {
    const double y = y_of(1e3 * error);
    svg += svg_line(kLeft, y, kLeft + kWidth, y, "stroke=\"black\" stroke-width=\"1.5\" stroke-dasharray=\"10 3 2 3\"");
    svg += svg_text(kLeft + kWidth - 6.0, y - 6.0, "asked: " + text_of("%.4g mm", 1e3 * error), "text-anchor=\"end\"");
  }
  const auto kind_of = [](const Rung& rung) { return rung.local > 0.0 ? kInParts : rung.order; };
  for (int order = 1; order <= 3; ++order) {
    std::string points;
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
      if (drawn(i) && kind_of(ladder.rungs[i]) == order && ladder.rungs[i].less.none())
        points += svg_number(x_of(ladder.rungs[i].cost)) + "," + svg_number(y_of(1e3 * off(i))) + " ";
    }
    svg += "<polyline fill=\"none\" stroke=\"black\" " + std::string(kStrokes[order - 1]) + " points=\"" + points + "\"/>\n";
  }
  for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
    const Rung& rung = ladder.rungs[i];
    if (drawn(i)) svg += marker(kind_of(rung), x_of(rung.cost), y_of(1e3 * off(i)), !rung.less.none());
  }
  double y = kTop + 30.0;
  const double x = kLeft + kWidth + 16.0;
  const auto say = [&](int order, bool hollow, const std::string& words) {
    svg += marker(order, x, y - 4.0, hollow) + svg_text(x + 12.0, y, words);
    y += 20.0;
  };
  for (int order = 1; order <= 3; ++order) say(order, false, "order " + std::to_string(order));
  if (std::any_of(ladder.rungs.begin(), ladder.rungs.end(), [&](const Rung& rung) { return kind_of(rung) == kInParts; }))
    say(kInParts, false, "parts by local error");
  say(1, true, "hollow: less is modelled");
  if (chosen >= 0 && drawn(at(chosen))) {
    const Rung& rung = ladder.rungs[at(chosen)];
    svg += "<circle cx=\"" + svg_number(x_of(rung.cost)) + "\" cy=\"" + svg_number(y_of(1e3 * off(at(chosen)))) +
           "\" r=\"10\" fill=\"none\" stroke=\"black\" stroke-width=\"2\"/>\n";
    svg += svg_text(x - 8.0, y + 6.0, "ringed: the choice");
    svg += svg_text(x - 8.0, y + 22.0, "order " + std::to_string(rung.order) + text_of(" at %.4g ms", 1e3 * rung.step) +
                                                (rung.local > 0.0 ? text_of(" to %.3g m/s^2", rung.local) : ""));
    svg += svg_text(x - 8.0, y + 38.0, text_of("%.3g mm, ", 1e3 * ladder.estimate(at(chosen))) + text_of("%.3g ms/s", rung.cost));
  }
  return svg_sheet(kLeft + kWidth + kRight, kTop + kHeight + 48.0, svg);
}

std::string parts_svg(const std::string& title, const std::vector<ModelledPart>& parts, double error,
                      const std::vector<std::pair<std::string, double>>& costs) {
  Range across;
  across.take(1e3 * error);
  for (const ModelledPart& part : parts) {
    if (part.way > 0.0) across.take(1e3 * std::max(kLeast, part.way));
  }
  if (!(across.high > across.low)) across.high = across.low + 1.0;
  const double rows = kRow * static_cast<double>(parts.size());
  const double bars = kNames + 10.0, words = bars + kBars + 12.0;
  const auto x_of = [&](double mm) { return bars + kBars * std::clamp(across.share(mm), 0.0, 1.0); };
  std::string svg = svg_text(10.0, 22.0, title, "font-size=\"14\"");
  svg += svg_text(bars, kTop - 24.0, "what is behind it moves by [mm]; black: modelled, hollow: left out");
  for (double d = across.low; d <= across.high; d += 1.0) {
    const double x = x_of(std::pow(10.0, d));
    svg += svg_line(x, kTop, x, kTop + rows) + svg_text(x, kTop - 6.0, svg_number(std::pow(10.0, d)), "text-anchor=\"middle\"");
  }
  double y = kTop;
  for (const ModelledPart& part : parts) {
    svg += svg_text(kNames, y + 12.0, part.name, "text-anchor=\"end\"");
    if (part.way >= 0.0) {
      const double width = part.way > 0.0 ? std::max(1.0, x_of(1e3 * std::max(kLeast, part.way)) - bars) : 1.0;
      svg += svg_box(bars, y + 3.0, width, kRow - 6.0, part.left_out ? "fill=\"white\" stroke=\"black\"" : "fill=\"black\" stroke=\"black\"");
    }
    svg += svg_text(words, y + 12.0, part.modelled + (part.moves.empty() ? "" : " (" + part.moves + ")"));
    y += kRow;
  }
  svg += svg_line(x_of(1e3 * error), kTop, x_of(1e3 * error), y, "stroke=\"black\" stroke-width=\"1.5\" stroke-dasharray=\"10 3 2 3\"");
  svg += svg_text(x_of(1e3 * error), y + 14.0, "asked: " + text_of("%.4g mm", 1e3 * error), "text-anchor=\"middle\"");
  y += 44.0;
  double whole = 0.0;
  for (const auto& [name, cost] : costs) whole += std::max(0.0, cost);
  if (whole > 0.0) svg += svg_text(bars, y - 6.0, "share of the physics of a run of everything");
  for (const auto& [name, cost] : costs) {
    svg += svg_text(kNames, y + 12.0, name, "text-anchor=\"end\"");
    if (whole > 0.0)
      svg += svg_box(bars, y + 3.0, std::max(1.0, kBars * std::max(0.0, cost) / whole), kRow - 6.0,
                     &name == &costs.front().first ? "fill=\"black\" stroke=\"black\"" : "fill=\"white\" stroke=\"black\"");
    svg += svg_text(words, y + 12.0, text_of("%.2f ms/s", cost));
    y += kRow;
  }
  return svg_sheet(words + kWords, y + 16.0, svg);
}

}  // namespace twinbus::launcher
