#include "viewer_log/log/recorder.h"

#include <sys/statvfs.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "viewer_log/log/log_reader.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr auto kWriteEvery = std::chrono::milliseconds(200);
constexpr std::size_t kMostPending = 64 << 20;      // more waits for the disk no longer [bytes]
constexpr std::size_t kWriteSoon = 1 << 20;         // more is written at once [bytes]
constexpr std::int64_t kDescribeEvery = 1'000'000;  // [us]

std::int64_t events_in(std::span<const std::uint8_t> bytes) {
  std::int64_t count = 0;
  for (std::size_t at = 0; at < bytes.size(); ++count) {
    at += kEventHead + read_u32(bytes.data() + at + 20) + read_u32(bytes.data() + at + 24);
  }
  return count;
}

std::int64_t utime_of(std::span<const std::uint8_t> event) { return read_i64(event.data() + 12); }

// 0 of one without a whole head [us].
std::int64_t first_utime_of(const std::string& file) {
  std::array<std::uint8_t, kEventHead> head{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
  return stream ? utime_of(head) : 0;
}

// The number in a name that log_parts() gave.
int part_number(const std::string& part) {
  const std::string stem = std::filesystem::path(part).stem().string();
  return std::atoi(stem.c_str() + stem.rfind('-') + 1);
}

}  // namespace

Recorder::Recorder(const RecorderConfig& config) : config_(config) {
  if (config_.goes_on) go_on();
  next_part();
  first_file_ = part_file_;
  if (!config_.goes_on) remove_later_parts(config_.file);
  thread_ = std::thread([this] { work(); });
}

Recorder::~Recorder() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Recorder::add(std::int64_t utime, std::string_view channel,
                   std::span<const std::uint8_t> data) {
  bool soon = false;
  {
    const std::lock_guard lock(mutex_);
    if (pending_.size() > kMostPending || data.size() > kLargestData) {
      ++figures_.dropped;
      return;
    }
    append_event(pending_, utime, channel, data);
    ++pending_count_;
    soon = pending_.size() > kWriteSoon;
  }
  if (soon) wake_.notify_one();
}

void Recorder::describe(std::string_view channel, std::vector<std::vector<std::uint8_t>> messages) {
  const std::lock_guard lock(mutex_);
  description_channel_ = channel;
  description_ = std::move(messages);
}

RecorderFigures Recorder::figures() const {
  const std::lock_guard lock(mutex_);
  return figures_;
}

std::string Recorder::take_news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

void Recorder::say(const std::string& sentence) {
  const std::lock_guard lock(mutex_);
  news_ = sentence;
}

// Of a recorder that ended before its run did.
void Recorder::go_on() {
  const std::vector<std::string> there = log_parts(config_.file);
  std::error_code error;
  if (there.size() == 1 && !std::filesystem::exists(there.front(), error)) return;
  for (const std::string& file : there) {
    const auto bytes = std::filesystem::file_size(file, error);
    parts_.push_back({file, error ? 0 : static_cast<std::int64_t>(bytes), first_utime_of(file)});
  }
  // The oldest that the quota left has the name of the whole; numbers never come again.
  part_ = there.size() == 1 ? 1 : part_number(there.back());
}

void Recorder::next_part() {
  // Whoever sees the next part finds the one before complete.
  if (writer_ != nullptr) (void)writer_->write_index();
  const std::string file = log_part_name(config_.file, part_ + 1);
  auto next = std::make_unique<LogWriter>(file);  // may throw: then the old one goes on
  if (writer_ != nullptr) parts_.push_back({part_file_, writer_->size(), part_utime_});
  writer_ = std::move(next);
  part_file_ = file;
  ++part_;
  described_utime_ = 0;
  const std::lock_guard lock(mutex_);
  figures_.parts = part_;
}

void Recorder::apply_quota() {
  if (config_.quota_bytes <= 0) return;
  std::int64_t all = writer_->size();
  for (const Part& part : parts_) all += part.bytes;
  while (all > config_.quota_bytes && !parts_.empty()) {
    const std::int64_t next_utime = parts_.size() > 1 ? parts_[1].utime : part_utime_;
    if (1e-6 * static_cast<double>(newest_utime_ - next_utime) < config_.keep_seconds) return;
    // The oldest part that is left takes the place of the one that goes, so that the log keeps its name.
    std::string& next = parts_.size() > 1 ? parts_[1].file : part_file_;
    if (std::rename(next.c_str(), config_.file.c_str()) != 0) return;
    next = config_.file;
    all -= parts_.front().bytes;
    parts_.pop_front();
  }
}

bool Recorder::room() const {
  struct statvfs disk {};
  const std::string folder = std::filesystem::path(config_.file).parent_path().string();
  if (statvfs(folder.empty() ? "." : folder.c_str(), &disk) != 0) return true;
  const auto block = static_cast<std::int64_t>(disk.f_frsize);
  // Of a small disk a tenth, or nothing could ever be written there.
  const std::int64_t keep =
      std::min(config_.keep_free, static_cast<std::int64_t>(disk.f_blocks) * block / 10);
  return static_cast<std::int64_t>(disk.f_bavail) * block > keep;
}

void Recorder::write_out(std::vector<std::uint8_t>& events) {
  const std::int64_t size = writer_->size();
  const std::int64_t count = writer_->events();
  const bool has_room = room();
  const std::size_t done = has_room ? writer_->write(events) : 0;
  const std::int64_t lost = events_in(std::span(events).subspan(done));
  const bool failed = done < events.size();
  if (failed && !failing_) {
    const char* why = has_room ? std::strerror(writer_->error()) : "the disk is full";
    say("recording stopped: " + part_file_ + ": " + why + "; it goes on when there is room");
  } else if (!failed && failing_) {
    say("recording goes on in " + part_file_);
  }
  failing_ = failed;
  const std::lock_guard lock(mutex_);
  figures_.dropped += lost;
  figures_.written += writer_->events() - count;
  figures_.bytes += writer_->size() - size;
}

void Recorder::split_if_full() {
  const bool large = config_.split_bytes > 0 && writer_->size() >= config_.split_bytes;
  const bool long_ago =
      config_.split_seconds > 0.0 && part_utime_ != 0 &&
      1e-6 * static_cast<double>(newest_utime_ - part_utime_) >= config_.split_seconds;
  if ((!large && !long_ago) || failing_ || cannot_split_) return;
  try {
    next_part();
    part_utime_ = 0;
  } catch (const std::exception& error) {
    cannot_split_ = true;
    say(std::string(error.what()) + "; the file before goes on");
  }
}

void Recorder::work() {
  std::vector<std::uint8_t> events, text;
  std::vector<std::vector<std::uint8_t>> description;
  std::string channel;
  for (bool last = false; !last;) {
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, kWriteEvery, [this] { return quit_ || pending_.size() > kWriteSoon; });
      last = quit_;
      std::swap(events, pending_);
      pending_count_ = 0;
      description = description_;
      channel = description_channel_;
    }
    if (events.empty()) continue;
    newest_utime_ = utime_of(events);
    split_if_full();  // with something to put into the new part: none stays empty
    if (part_utime_ == 0) part_utime_ = newest_utime_;
    if (newest_utime_ - described_utime_ >= kDescribeEvery && !description.empty()) {
      described_utime_ = newest_utime_;
      text.clear();
      for (const auto& message : description) append_event(text, newest_utime_, channel, message);
      write_out(text);
    }
    write_out(events);
    events.clear();
    apply_quota();
  }
  (void)writer_->write_index();
}

}  // namespace twinbus::viewer_log
