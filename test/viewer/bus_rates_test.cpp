// Rates of the bus, told by a process that reads it late and loses some of it.

#include <gtest/gtest.h>

#include <algorithm>

#include "viewer_log/view/bus_rates.h"

namespace twinbus::inline viewer_log {
namespace {

constexpr std::int64_t kRatesMs = 1'000'000, kBegin = 1'000'000 * kRatesMs;

// What has been said on a bus of 500 Hz after so many milliseconds, by a source whose time goes on at that factor.
BusTotals said(std::int64_t ms, double factor = 1.0) {
  const auto tick = static_cast<std::int64_t>(factor * static_cast<double>(ms) / 2.0);
  return {.states = tick, .commands = tick, .guards = tick / 2, .run_id = 7, .tick = 1000 + tick, .time_ns = 2 * kRatesMs * tick, .state_at_ns = kBegin + ms * kRatesMs};
}

TEST(BusRates, CountsPerSecond) {
  BusRates rates;
  for (int ms = 0; ms <= 2100; ms += 16) rates.update(said(ms), kBegin + ms * kRatesMs, Receiver::kPrompt);
  EXPECT_NEAR(rates.state(), 500.0, 1.0);
  EXPECT_NEAR(rates.command(), 500.0, 1.0);
  EXPECT_NEAR(rates.guard(), 250.0, 1.0) << "that answers every second tick";
  EXPECT_NEAR(rates.realtime_factor(), 1.0, 0.005);
}

TEST(BusRates, ASlowWorldIsToldAsItIs) {
  BusRates rates;
  for (int ms = 0; ms <= 2100; ms += 16) rates.update(said(ms, 0.6), kBegin + ms * kRatesMs, Receiver::kPrompt);
  EXPECT_NEAR(rates.realtime_factor(), 0.6, 0.005);
  EXPECT_NEAR(rates.state(), 300.0, 1.0);
}

// A reader that stands still for most of every second and then has only what was said until some moment of the pause.
TEST(BusRates, AReaderThatIsLateDoesNotChangeThem) {
  BusRates rates;
  double lowest = 1e9, highest = 0.0;
  for (int ms = 0; ms <= 20000; ms += 16) {
    const int phase = ms % 1000;
    if (phase < 784) continue;  // stands still
    const bool late = phase < 840;
    BusTotals totals = said(late ? ms - 100 * (ms / 1000 * 3 % 8) : ms);
    totals.state_at_ns = kBegin + ms * kRatesMs;
    rates.update(totals, kBegin + ms * kRatesMs, late ? Receiver::kLate : Receiver::kPrompt);
    if (ms < 4000) continue;
    for (const double rate : {rates.state(), 500.0 * rates.realtime_factor()}) {
      lowest = std::min(lowest, rate);
      highest = std::max(highest, rate);
    }
  }
  EXPECT_GT(lowest, 495.0);
  EXPECT_LT(highest, 505.0);
}

TEST(BusRates, WhatOnlyTheReaderLostIsCounted) {
  BusRates rates;
  for (int ms = 0; ms <= 4200; ms += 16) {
    BusTotals totals = said(ms);
    totals.states = totals.states * 2 / 5;
    totals.commands = totals.commands * 2 / 5;
    rates.update(totals, kBegin + ms * kRatesMs, Receiver::kPrompt);
  }
  EXPECT_NEAR(rates.state(), 500.0, 5.0);
  EXPECT_NEAR(rates.command(), 500.0, 5.0);
}

TEST(BusRates, ALogIsCountedAsItIs) {
  BusRates rates;
  for (int ms = 0; ms <= 4200; ms += 16) {
    BusTotals totals = said(ms);
    totals.states /= 2;
    rates.update(totals, kBegin + ms * kRatesMs, Receiver::kExact);
  }
  EXPECT_NEAR(rates.state(), 250.0, 2.0);
}

TEST(BusRates, SilenceIsNoRateAndAnotherSourceBeginsAnew) {
  BusRates rates;
  std::int64_t ms = 0;
  for (; ms <= 2100; ms += 16) rates.update(said(ms), kBegin + ms * kRatesMs, Receiver::kPrompt);
  BusTotals last = said(ms);
  for (; ms <= 7000; ms += 16) rates.update(last, kBegin + ms * kRatesMs, Receiver::kPrompt);
  EXPECT_EQ(rates.state(), 0.0);
  EXPECT_EQ(rates.realtime_factor(), 0.0);
  for (const std::int64_t to = ms + 4200; ms <= to; ms += 16) {
    BusTotals totals = said(ms);
    totals.run_id = 8;
    totals.tick += 1'000'000'000;
    rates.update(totals, kBegin + ms * kRatesMs, Receiver::kPrompt);
    EXPECT_LT(rates.state(), 505.0);
  }
  EXPECT_NEAR(rates.state(), 500.0, 1.0);
}

// Too busy to be on time ever: after ten seconds its word is better than none.
TEST(BusRates, AReaderThatIsAlwaysLateTellsAtLast) {
  BusRates rates;
  for (int ms = 0; ms <= 30000; ms += 100) rates.update(said(ms), kBegin + ms * kRatesMs, Receiver::kLate);
  EXPECT_NEAR(rates.state(), 500.0, 5.0);
}

}  // namespace
}  // namespace twinbus::viewer_log
