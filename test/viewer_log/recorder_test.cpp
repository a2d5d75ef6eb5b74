#include "viewer_log/log/recorder.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "test/temporary_folder.h"
#include "viewer_log/log/log_reader.h"

namespace twinbus {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::uint8_t, 8> kData{1, 2, 3, 4, 5, 6, 7, 8};

// So many messages, from this time on [us].
std::string record(RecorderConfig config, std::int64_t from, int count) {
  Recorder recorder(config);
  for (int i = 0; i < count; ++i) recorder.add(from + i, "A", kData);
  return fs::path(recorder.first_file()).filename().string();
}

std::vector<std::int64_t> times_in(const std::string& file) {
  LogReader reader(file);
  std::vector<std::int64_t> times;
  for (LogEvent event; reader.next(event);) {
    if (event.channel == "A") times.push_back(event.utime);
  }
  return times;
}

TEST(Recorder, ThatIsStartedAgainGoesOnAfterWhatIsThere) {
  const test::TemporaryFolder folder;
  RecorderConfig config;
  config.file = (fs::path(folder.path()) / "run.log").string();
  config.goes_on = true;
  EXPECT_EQ(record(config, 1'000, 10), "run.log");
  EXPECT_EQ(record(config, 2'000, 20), "run-0002.log");
  EXPECT_EQ(record(config, 3'000, 30), "run-0003.log");
  const std::vector<std::int64_t> times = times_in(config.file);
  ASSERT_EQ(times.size(), 60u);
  EXPECT_EQ(times.front(), 1'000);
  EXPECT_EQ(times.back(), 3'029);
}

// The quota gives the name of the whole to the oldest part that is left; numbers are not used again.
TEST(Recorder, GoesOnWhereAQuotaHasRemovedParts) {
  const test::TemporaryFolder folder;
  const fs::path place = folder.path();
  RecorderConfig config;
  config.file = (place / "run.log").string();
  config.goes_on = true;
  for (int i = 1; i <= 3; ++i) record(config, 1'000 * i, 10);
  fs::rename(place / "run-0002.log", place / "run.log");
  EXPECT_EQ(record(config, 4'000, 10), "run-0004.log");
  EXPECT_EQ(times_in(config.file).size(), 30u);
  config.quota_bytes = 1;
  record(config, 5'000, 10);
  const std::vector<std::int64_t> left = times_in(config.file);
  ASSERT_EQ(left.size(), 10u);
  EXPECT_EQ(left.front(), 5'000);
}

TEST(Recorder, ReplacesALogWithItsPartsWhereItIsToldTo) {
  const test::TemporaryFolder folder;
  RecorderConfig config;
  config.file = (fs::path(folder.path()) / "run.log").string();
  config.goes_on = true;
  record(config, 1'000, 10);
  record(config, 2'000, 10);
  config.goes_on = false;
  EXPECT_EQ(record(config, 3'000, 5), "run.log");
  EXPECT_EQ(times_in(config.file), (std::vector<std::int64_t>{3'000, 3'001, 3'002, 3'003, 3'004}));
}

TEST(Recorder, GoesOnAfterAFileThatIsNoLog) {
  const test::TemporaryFolder folder;
  RecorderConfig config;
  config.file = (fs::path(folder.path()) / "run.log").string();
  config.goes_on = true;
  { std::ofstream(config.file) << "x"; }
  config.quota_bytes = 1 << 20;
  EXPECT_EQ(record(config, 1'000, 3), "run-0002.log");
  EXPECT_EQ(fs::file_size(config.file), 1u);
}

}  // namespace
}  // namespace twinbus
