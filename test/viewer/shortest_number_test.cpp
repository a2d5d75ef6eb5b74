#include "viewer_log/log/shortest_number.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace twinbus {
namespace {

template <class Number>
std::string ours(Number value) {
  char text[kLongestNumber];
  return {text, write_shortest(text, value)};
}
template <class Number>
std::string library(Number value) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}
template <class Number>
void expect_same(Number value) {
  if (ours(value) != library(value)) ADD_FAILURE() << ours(value) << " for " << library(value);
}

TEST(ShortestNumber, IsLetterForLetterThatOfTheLibrary) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200'000; ++i) {
    const std::uint64_t bits = random();
    expect_same(std::bit_cast<double>(bits));
    expect_same(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  }
  // Sizes that a robot has, whole and round numbers.
  for (int i = -60'000; i < 60'000; ++i) {
    expect_same(static_cast<double>(i));
    expect_same(static_cast<float>(i));
    expect_same(0.001 * i);
    expect_same(1e-7 * i);
    expect_same(0.001F * static_cast<float>(i));
    expect_same(i / 1024.0);
  }
}

// Where the neighbours below and above are not equally far.
TEST(ShortestNumber, IsRightAtAllPowersOfTwoAndBesideThem) {
  for (std::uint64_t exponent = 0; exponent < 2048; ++exponent) {
    for (std::int64_t beside : {-2, -1, 0, 1, 2}) {
      expect_same(std::bit_cast<double>((exponent << 52) + static_cast<std::uint64_t>(beside)));
      expect_same(std::bit_cast<float>(static_cast<std::uint32_t>(exponent << 23) +
                                       static_cast<std::uint32_t>(beside)));
    }
  }
}

TEST(ShortestNumber, IsRightAtPowersOfTenAndWhatIsNoNumber) {
  for (int power = -320; power <= 308; ++power) {
    for (const char* digits : {"1", "9.5", "2.25", "9.999999999999999"}) {
      std::string text = digits;
      text += 'e';
      text += std::to_string(power);
      expect_same(std::strtod(text.c_str(), nullptr));
    }
  }
  for (double value :
       {0.0, -0.0, std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    expect_same(value);
    expect_same(static_cast<float>(value));
  }
}

}  // namespace
}  // namespace twinbus
