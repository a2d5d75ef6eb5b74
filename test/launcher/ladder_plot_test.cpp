#include "launcher/run/ladder_plot.h"

#include <gtest/gtest.h>

#include <limits>

namespace twinbus {
namespace {

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

Rung rung_at(int order, double cost, double apart, bool less = false) {
  Rung rung;
  rung.order = order;
  rung.step = 1e-3;
  rung.cost = cost;
  rung.apart = apart;
  rung.less.apart = less;
  return rung;
}

TEST(LadderPlot, EveryRunIsDrawnByItsOrderAndTheChoiceIsRinged) {
  Ladder ladder;
  ladder.rungs = {rung_at(1, 2.0, 1e-3), rung_at(2, 5.0, 1e-4), rung_at(1, 1.0, 1.1e-3, true), rung_at(3, 20.0, 0.0)};
  ladder.agreement = 1e-7;
  const std::string svg = front_svg("a <scene>", ladder, 2, 2e-3);
  EXPECT_EQ(count(svg, "<circle") - 2, 3);  // two runs, the ring; two in the legend
  EXPECT_EQ(count(svg, "<polygon"), 2);     // one run, one in the legend
  EXPECT_NE(svg.find("a &lt;scene"), std::string::npos);
  EXPECT_NE(svg.find("asked: 2 mm"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_EQ(count(front_svg("t", ladder, -1, 0.0), "stroke-width=\"2\""), 0);
}

TEST(LadderPlot, WhatEndedEarlyOrCostNothingIsLeftOut) {
  Ladder ladder;
  ladder.rungs = {rung_at(1, 0.0, 1e-3), rung_at(1, 2.0, std::numeric_limits<double>::infinity()), rung_at(3, 9.0, 0.0)};
  ladder.rungs.front().whole = false;
  ladder.agreement = std::numeric_limits<double>::infinity();
  const std::string svg = front_svg("t", ladder, -1, 1e-3);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_EQ(count(svg, "<polygon"), 1);  // the legend's
}

TEST(LadderPlot, WhatIsLeftOutIsHollow) {
  const std::string svg = parts_svg("t", {{"KNEE", "1 degrees", 2e-2, "yes", false}, {"NECK", "0 degrees", 0.0, "held", true}}, 1e-3,
                                    {{"what is modelled", 3.0}, {"what was left out", 1.0}});
  EXPECT_EQ(count(svg, "fill=\"white\" stroke=\"black\""), 2);
  EXPECT_EQ(count(svg, "fill=\"black\" stroke=\"black\""), 2);
  EXPECT_NE(svg.find("KNEE"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace twinbus
