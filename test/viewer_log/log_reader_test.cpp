#include "viewer_log/log/log_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

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

TEST(LogReader, TimesThatCannotBeCountedInNanosecondsAreDamage) {
  for (const std::int64_t utime : {INT64_MIN, std::int64_t{-1}, kLatestTime + 1, INT64_MAX}) {
    const SampleLog log = sample_log(kEvents);
    std::vector<std::uint8_t> bytes = log.bytes;
    write_i64(bytes.data() + log.begins[50] + 12, utime);
    LogDamage damage;
    EXPECT_EQ(recovered(log, bytes, &damage), all_but({50})) << utime;
    EXPECT_EQ(damage.places, 1) << utime;
  }
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

// Logs in several files, in a folder of their own.
class LogParts : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  // Ticks from first on, one per 2 ms.
  void write(const std::string& name, int first, int count) const {
    LogWriter writer(file(name));
    std::vector<std::uint8_t> data(100);
    for (int i = first; i < first + count; ++i) {
      data[0] = static_cast<std::uint8_t>(i);
      writer.add(1'000'000 + 2000 * i, "STATE", data);
    }
    writer.close();
  }
  static std::vector<std::int64_t> times(LogReader& reader) {
    std::vector<std::int64_t> all;
    for (LogEvent event; reader.next(event);) {
      if (event.channel == "STATE") all.push_back((event.utime - 1'000'000) / 2000);
    }
    return all;
  }
  const std::string folder_ =
      (std::filesystem::temp_directory_path() / ("twinbus_log_parts." + std::to_string(getpid())))
          .string();
};

TEST_F(LogParts, TheFirstPartStandsForAllOfThem) {
  write("run.log", 0, 1000);
  write("run-0002.log", 1000, 700);
  write("run-0010.log", 1700, 800);
  write("run-12.log", 5000, 10);   // no part
  write("other-0002.log", 1, 10);  // of another log
  LogReader reader(file("run.log"));
  EXPECT_EQ(reader.parts(), 3);
  const std::vector<std::int64_t> all = times(reader);
  ASSERT_EQ(all.size(), 2500U);
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], static_cast<std::int64_t>(i));
  EXPECT_EQ(reader.damage().places, 0);
  EXPECT_EQ(log_of_part(file("run-0002.log")), file("run.log"));
  EXPECT_EQ(log_of_part(file("run-12.log")), "");
  LogReader alone(file("run-0002.log"));
  EXPECT_EQ(alone.parts(), 1);
  EXPECT_EQ(times(alone).size(), 700U);
}

TEST_F(LogParts, ASeekFindsAnyMomentOfAnyPart) {
  for (int part = 0; part < 20; ++part)
    write(part == 0 ? "run.log" : log_part_name("run.log", part + 1), 300 * part, 300);
  LogReader reader(file("run.log"));
  EXPECT_EQ(reader.parts(), 20);
  LogEvent event;
  for (int tick = 0; tick < 6000; tick += 37) {
    reader.seek(1'000'000 + 2000 * tick);
    do {
      ASSERT_TRUE(reader.next(event));
    } while (event.channel != "STATE");
    ASSERT_EQ(event.utime, 1'000'000 + 2000 * tick);
  }
}

TEST_F(LogParts, EveryEventOfEveryPartHasItsSum) {
  write("run.log", 0, 1000);
  write("run-0002.log", 1000, 1000);
  LogReader reader(file("run.log"));
  LogCheck check;
  for (LogEvent event; reader.next(event);) check.add(event);
  EXPECT_EQ(check.checked(), 2000);
  EXPECT_EQ(check.wrong() + check.missing(), 0);
}

TEST_F(LogParts, APartThatIsCutCostsOnlyItsEnd) {
  write("run.log", 0, 1000);
  write("run-0002.log", 1000, 1000);
  std::filesystem::resize_file(file("run.log"), 50'000);
  LogReader reader(file("run.log"));
  const std::vector<std::int64_t> all = times(reader);
  EXPECT_EQ(all.back(), 1999);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](auto tick) { return tick >= 1000; }), 1000);
  EXPECT_EQ(reader.damage().places, 1);
}

TEST_F(LogParts, PartsOfAnOlderRecordingAreNotOfThisOne) {
  write("run-0002.log", 0, 100);
  write("run.log", 5000, 100);
  LogReader reader(file("run.log"));
  EXPECT_EQ(reader.parts(), 1);
  EXPECT_EQ(times(reader).size(), 100U);
}

}  // namespace
}  // namespace twinbus
