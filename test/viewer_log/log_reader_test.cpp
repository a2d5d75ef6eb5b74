#include "viewer_log/log/log_reader.h"

#include <gtest/gtest.h>

#include <cstring>

#include "test/viewer_log/log_samples.h"

namespace twinbus {
namespace {

constexpr int kEvents = 100;

std::set<int> all_but(std::set<int> lost, int events = kEvents) {
  std::set<int> all;
  for (int i = 0; i < events; ++i) {
    if (lost.count(i) == 0) all.insert(i);
  }
  return all;
}

TEST(LogReader, GivesBackEveryEventOfAHealthyLog) {
  const SampleLog log = sample_log(kEvents);
  LogDamage damage;
  EXPECT_EQ(recovered(log, log.bytes, &damage), all_but({}));
  EXPECT_EQ(damage.places, 0);
  EXPECT_FALSE(damage.cut);
}

TEST(LogReader, CutAnywhereInItsLastThreeEventsALogLosesOnlyThem) {
  const SampleLog log = sample_log(kEvents);
  for (std::size_t cut = log.begins[kEvents - 3]; cut < log.bytes.size(); ++cut) {
    int whole = 0;
    while (log.begins[static_cast<std::size_t>(whole) + 1] <= cut) ++whole;
    LogDamage damage;
    const auto found = recovered(log, std::span(log.bytes.data(), cut), &damage);
    ASSERT_EQ(found.size(), static_cast<std::size_t>(whole)) << "cut at " << cut;
    const bool inside = cut != log.begins[static_cast<std::size_t>(whole)];
    EXPECT_EQ(damage.places, inside ? 1 : 0) << "cut at " << cut;
    EXPECT_EQ(damage.bytes,
              static_cast<std::int64_t>(cut - log.begins[static_cast<std::size_t>(whole)]));
  }
}

TEST(LogReader, AFlippedBitCostsAtMostTheEventItIsIn) {
  const SampleLog log = sample_log(kEvents);
  const std::size_t first = log.begins[49], last = log.begins[52];
  for (std::size_t at = first; at < last; ++at) {
    const int hit = at < log.begins[50] ? 49 : at < log.begins[51] ? 50 : 51;
    for (int bit = 0; bit < 8; ++bit) {
      std::vector<std::uint8_t> bytes = log.bytes;
      bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1 << bit));
      ASSERT_EQ(recovered(log, bytes), all_but({hit})) << "byte " << at - first << " bit " << bit;
    }
  }
}

TEST(LogReader, ManyFlippedBitsCostOnlyTheEventsTheyAreIn) {
  std::mt19937 random(7);
  for (const double rate : {1e-6, 1e-5, 1e-4, 1e-3}) {
    const SampleLog log = sample_log(2000, 3);
    std::vector<std::uint8_t> bytes = log.bytes;
    const auto flips = static_cast<int>(rate * 8.0 * static_cast<double>(bytes.size())) + 1;
    std::set<int> hit;
    for (int i = 0; i < flips; ++i) {
      const std::size_t at = random() % bytes.size();
      bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1 << (random() % 8)));
      int event = 0;
      while (log.begins[static_cast<std::size_t>(event) + 1] <= at) ++event;
      hit.insert(event);
    }
    // Two flips may undo each other, so more may come back than expected, never less.
    const auto found = recovered(log, bytes);
    for (const int event : all_but(hit, 2000))
      EXPECT_EQ(found.count(event), 1U) << event << " at " << rate;
  }
}

TEST(LogReader, ImpossibleAndWrongLengthsAreSteppedOver) {
  const SampleLog log = sample_log(kEvents);
  const std::size_t at = log.begins[50];
  const std::uint32_t right = read_u32(log.bytes.data() + at + 24);
  for (const std::uint32_t length : {0x7fffffffU, 0xffffffffU, 0x80000000U, right - 10, right + 10,
                                     right + 500, right + 2000, 0U, std::uint32_t{kLargestData}}) {
    std::vector<std::uint8_t> bytes = log.bytes;
    write_u32(bytes.data() + at + 24, length);
    LogDamage damage;
    EXPECT_EQ(recovered(log, bytes, &damage), all_but({50})) << length;
    EXPECT_EQ(damage.places, 1) << length;
  }
  for (const std::uint32_t length : {0U, 0x7fffffffU, 64U, 255U}) {
    std::vector<std::uint8_t> bytes = log.bytes;
    write_u32(bytes.data() + at + 20, length);
    EXPECT_EQ(recovered(log, bytes), all_but({50})) << "channel " << length;
  }
}

// One whose length is right for a boundary further on swallows nothing either: numbers count up by one.
TEST(LogReader, ALengthThatEndsAtALaterEventIsNotBelieved) {
  const SampleLog log = sample_log(kEvents);
  std::vector<std::uint8_t> bytes = log.bytes;
  const std::size_t grown = log.begins[54] - log.begins[51];
  write_u32(bytes.data() + log.begins[50] + 24,
            read_u32(bytes.data() + log.begins[50] + 24) + static_cast<std::uint32_t>(grown));
  EXPECT_EQ(recovered(log, bytes), all_but({50}));
}

TEST(LogReader, ZerosAndRubbishBetweenEventsCostNoEvent) {
  const SampleLog log = sample_log(kEvents);
  std::mt19937 random(5);
  for (const std::size_t count : {1UL, 28UL, 4096UL, 3000000UL}) {
    for (const bool zero : {true, false}) {
      std::vector<std::uint8_t> rubbish(count);
      if (!zero) {
        for (auto& byte : rubbish) byte = static_cast<std::uint8_t>(random());
      }
      std::vector<std::uint8_t> bytes = log.bytes;
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(log.begins[50]), rubbish.begin(),
                   rubbish.end());
      LogDamage damage;
      EXPECT_EQ(recovered(log, bytes, &damage), all_but({})) << count;
      EXPECT_EQ(damage.places, 1);
      EXPECT_EQ(damage.bytes, static_cast<std::int64_t>(count));
    }
  }
}

TEST(LogReader, ABlockOfZerosOverEventsCostsThoseItTouches) {
  const SampleLog log = sample_log(kEvents);
  std::vector<std::uint8_t> bytes = log.bytes;
  const std::size_t begin = log.begins[30] + 40;
  std::memset(bytes.data() + begin, 0, 512);
  std::set<int> touched;
  for (int i = 0; i < kEvents; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (log.begins[at] < begin + 512 && log.begins[at + 1] > begin) touched.insert(i);
  }
  EXPECT_EQ(recovered(log, bytes), all_but(touched));
}

TEST(LogReader, TwoLogsJoinedAreReadLikeOne) {
  const SampleLog a = sample_log(kEvents, 1), b = sample_log(kEvents, 2, 5'000'000);
  std::vector<std::uint8_t> bytes = a.bytes;
  bytes.insert(bytes.end(), b.bytes.begin(), b.bytes.end());
  LogDamage damage;
  EXPECT_EQ(recovered(a, bytes, &damage), all_but({}));
  EXPECT_EQ(recovered(b, bytes), all_but({}));
  EXPECT_EQ(damage.places, 0);
  // The first one cut: its last event is lost, the other log is whole.
  bytes = a.bytes;
  bytes.resize(a.begins[kEvents - 1] + 30);
  bytes.insert(bytes.end(), b.bytes.begin(), b.bytes.end());
  EXPECT_EQ(recovered(a, bytes, &damage), all_but({kEvents - 1}));
  EXPECT_EQ(recovered(b, bytes), all_but({}));
  EXPECT_EQ(damage.places, 1);
}

TEST(LogReader, WhatIsNoLogHasNoEventsAndIsOnePlaceOfDamage) {
  std::vector<std::uint8_t> bytes(100000, 'x');
  LogReader reader(bytes);
  LogEvent event;
  EXPECT_FALSE(reader.next(event));
  EXPECT_EQ(reader.damage().places, 1);
  EXPECT_EQ(reader.damage().bytes, 100000);
  LogReader nothing(std::span<const std::uint8_t>{});
  EXPECT_FALSE(nothing.next(event));
  EXPECT_THROW(LogReader("/nonexistent/x.log"), std::runtime_error);
  EXPECT_THROW(LogReader("/"), std::runtime_error);
}

TEST(LogReader, SeekFindsTheFirstEventAtOrAfterATime) {
  const SampleLog log = sample_log(5000);
  LogReader reader(log.bytes);
  LogEvent event;
  for (const int wanted : {0, 1, 777, 2500, 4998, 4999}) {
    reader.seek(1'000'000 + 2000 * wanted);
    ASSERT_TRUE(reader.next(event));
    EXPECT_EQ(event.number, wanted);
    reader.seek(1'000'000 + 2000 * wanted - 1);
    ASSERT_TRUE(reader.next(event));
    EXPECT_EQ(event.number, wanted);
  }
  reader.seek(1'000'000 + 2000 * 5000);
  EXPECT_FALSE(reader.next(event));
  reader.seek(0);
  ASSERT_TRUE(reader.next(event));
  EXPECT_EQ(event.number, 0);
}

}  // namespace
}  // namespace twinbus
