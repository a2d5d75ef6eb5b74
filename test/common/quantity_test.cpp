#include "common/text/quantity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace twinbus {
namespace {

constexpr Unit kLengths[] = {{"", 1.0}, {"m", 1.0}, {"mm", 1e-3}};

TEST(Quantity, IsANumberTimesItsUnit) {
  EXPECT_EQ(quantity_of("0.001", kLengths), 0.001);
  EXPECT_EQ(quantity_of("2m", kLengths), 2.0);
  EXPECT_EQ(quantity_of("2 mm", kLengths), 2e-3);
  EXPECT_EQ(quantity_of("-1e3  mm", kLengths), -1.0);
}

TEST(Quantity, IsNoNumberWithoutOneOrWithAnotherUnit) {
  for (const char* text : {"", "mm", "1 km", "1 m m", "1,5", "1 mm ", "1e"}) EXPECT_TRUE(std::isnan(quantity_of(text, kLengths))) << text;
}

}  // namespace
}  // namespace twinbus
