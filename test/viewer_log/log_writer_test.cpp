#include "viewer_log/log/log_writer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "test/viewer_log/log_samples.h"

namespace twinbus {
namespace {

class LogWriterTest : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }
  // Two channels, 500 Hz each, so many events of each.
  void write(int events) const {
    LogWriter writer(file_);
    std::vector<std::uint8_t> data(100);
    for (int i = 0; i < events; ++i) {
      data[0] = static_cast<std::uint8_t>(i);
      writer.add(1'000'000 + 2000 * i, "STATE", data);
      writer.add(1'000'000 + 2000 * i + 500, "COMMAND", data);
    }
    writer.close();
  }
  LogCheck checked() const {
    LogReader reader(file_);
    LogCheck check;
    for (LogEvent event; reader.next(event);) check.add(event);
    return check;
  }
  void flip(std::int64_t at) const {
    std::fstream stream(file_, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(at);
    const char byte = static_cast<char>(stream.get() ^ 4);
    stream.seekp(at);
    stream.put(byte);
  }
  const std::string file_ = std::filesystem::temp_directory_path() /
                            ("twinbus_log_writer_test." + std::to_string(getpid()) + ".log");
};

TEST_F(LogWriterTest, WhatIsWrittenIsReadAndNumberedFromZero) {
  write(3000);
  LogReader reader(file_);
  std::int64_t number = 0;
  std::map<std::string, int> counts;
  for (LogEvent event; reader.next(event); ++number) {
    ASSERT_EQ(event.number, number);
    ++counts[std::string(event.channel)];
  }
  EXPECT_EQ(counts["STATE"], 3000);
  EXPECT_EQ(counts["COMMAND"], 3000);
  EXPECT_GE(counts[kLogIndex], 6);
  EXPECT_EQ(reader.damage().places, 0);
}

TEST_F(LogWriterTest, EveryEventHasItsSumAndTheLastIndexCountsAll) {
  write(3000);
  const LogCheck check = checked();
  EXPECT_EQ(check.checked(), 6000);
  EXPECT_EQ(check.wrong(), 0);
  EXPECT_EQ(check.missing(), 0);
  LogReader reader(file_);
  std::optional<LogIndex> last;
  for (LogEvent event; reader.next(event);) {
    if (event.channel != kLogIndex) continue;
    last = decode_index(event.data);
    ASSERT_TRUE(last.has_value());
    EXPECT_EQ(last->offset, event.offset);
  }
  EXPECT_EQ(last->channels.at("STATE").events, 3000);
  EXPECT_EQ(last->channels.at("COMMAND").bytes, 300000);
  EXPECT_EQ(last->first_utime, 1'000'000);
}

TEST_F(LogWriterTest, AFlippedBitInAPayloadIsFoundByItsSum) {
  write(3000);
  LogReader reader(file_);
  LogEvent event;
  for (int i = 0; i <= 777; ++i) ASSERT_TRUE(reader.next(event));
  flip(event.offset + 60);
  const LogCheck check = checked();
  EXPECT_EQ(check.wrong(), 1);
  ASSERT_EQ(check.places().size(), 1U);
  EXPECT_EQ(check.places()[0], event.offset);
}

TEST_F(LogWriterTest, ManyEventsWithinOneSecondAllHaveSums) {
  {
    LogWriter writer(file_);
    const std::vector<std::uint8_t> data(10);
    for (int i = 0; i < 50000; ++i) writer.add(1'000'000 + i, "X", data);
    writer.close();
  }
  EXPECT_EQ(checked().checked(), 50000);
}

TEST_F(LogWriterTest, AFullDiskTakesNothingAndSaysWhy) {
  if (access("/dev/full", W_OK) != 0) GTEST_SKIP();
  LogWriter writer("/dev/full");
  std::vector<std::uint8_t> events;
  append_event(events, 1, "X", std::vector<std::uint8_t>(10));
  EXPECT_EQ(writer.write(events), 0U);
  EXPECT_EQ(writer.error(), ENOSPC);
  EXPECT_EQ(writer.events(), 0);
  EXPECT_THROW(LogWriter("/nonexistent/x.log"), std::runtime_error);
}

// Of a log, of what is left of one whose first file is gone, and of what is no file.
TEST_F(LogWriterTest, ANameThatIsUsedIsRefusedAndItsLaterPartsCanBeRemoved) {
  EXPECT_NO_THROW(refuse_if_there(file_));
  EXPECT_NO_THROW(refuse_if_there("/dev/null"));
  write(1);
  EXPECT_THROW(refuse_if_there(file_), std::runtime_error);
  const std::string part = log_part_name(file_, 3);
  std::filesystem::copy_file(file_, part);
  std::filesystem::remove(file_);
  EXPECT_THROW(refuse_if_there(file_), std::runtime_error);
  write(1);
  remove_later_parts(file_);
  EXPECT_TRUE(std::filesystem::exists(file_));
  EXPECT_FALSE(std::filesystem::exists(part));
}

TEST(LogIndex, BytesThatAreNoIndexAreNone) {
  LogIndex index;
  index.sums = {1, 2, 3};
  index.channels["A"] = {4, 5};
  const std::vector<std::uint8_t> bytes = encode_index(index);
  ASSERT_TRUE(decode_index(bytes).has_value());
  for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
    EXPECT_FALSE(decode_index(std::span(bytes.data(), cut)).has_value()) << cut;
  }
}

}  // namespace
}  // namespace twinbus
