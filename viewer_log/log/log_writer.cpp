#include "viewer_log/log/log_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "viewer_log/log/log_reader.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr std::size_t kBuffer = 1 << 20;         // [bytes]
constexpr std::int64_t kIndexEvery = 1'000'000;  // [us] of the log's time
constexpr std::size_t kSumsEvery = kMostSums / 2;

// An event made by append_event().
struct Part {
  std::span<std::uint8_t> bytes;
  std::string_view channel;
  std::int64_t utime, data;
};

Part part_at(std::span<std::uint8_t> events, std::size_t at) {
  const std::uint8_t* p = events.data() + at;
  const std::size_t name = read_u32(p + 20), data = read_u32(p + 24);
  return {events.subspan(at, kEventHead + name + data),
          {reinterpret_cast<const char*>(p + kEventHead), name},
          read_i64(p + 12),
          static_cast<std::int64_t>(data)};
}

}  // namespace

void append_event(std::vector<std::uint8_t>& bytes, std::int64_t utime, std::string_view channel,
                  std::span<const std::uint8_t> data) {
  const std::size_t at = bytes.size();
  bytes.resize(at + kEventHead + channel.size() + data.size());
  std::uint8_t* p = bytes.data() + at;
  write_u32(p, kEventMark);
  write_i64(p + 4, 0);
  write_i64(p + 12, utime);
  write_u32(p + 20, static_cast<std::uint32_t>(channel.size()));
  write_u32(p + 24, static_cast<std::uint32_t>(data.size()));
  std::memcpy(p + kEventHead, channel.data(), channel.size());
  if (!data.empty()) std::memcpy(p + kEventHead + channel.size(), data.data(), data.size());
}

void refuse_if_there(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::exists(file, ignored) && log_parts(file).size() == 1) return;
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) return;  // as /dev/null
  throw std::runtime_error(file + " or a part of it is there already: name another file, or write over it with --force");
}

void remove_later_parts(const std::string& file) {
  const std::vector<std::string> parts = log_parts(file);
  for (std::size_t i = 1; i < parts.size(); ++i) (void)::unlink(parts[i].c_str());
}

LogWriter::LogWriter(const std::string& file) : file_(file) {
  fd_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd_ < 0) {
    throw std::runtime_error("log " + file + ": cannot be written: " + std::strerror(errno));
  }
}

LogWriter::~LogWriter() {
  try {
    close();
  } catch (const std::exception&) {  // who wants to know calls close()
  }
  if (fd_ >= 0) ::close(fd_);
}

// All of it, or the file stays as it was.
bool LogWriter::put(std::span<const std::uint8_t> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::write(fd_, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      error_ = n < 0 ? errno : ENOSPC;
      if (ftruncate(fd_, size_) != 0 || lseek(fd_, size_, SEEK_SET) < 0) return false;
      return false;
    }
    done += static_cast<std::size_t>(n);
  }
  size_ += static_cast<std::int64_t>(bytes.size());
  return true;
}

std::size_t LogWriter::write(std::span<std::uint8_t> events) {
  // In pieces of what one index may cover, so that no event is without its sum.
  std::size_t begin = 0;
  while (begin < events.size()) {
    const std::size_t sums = index_.sums.size();
    const std::int64_t number = number_;
    if (number == 0) index_.first_utime = indexed_utime_ = part_at(events, begin).utime;
    std::size_t end = begin;
    while (end < events.size() && index_.sums.size() < kSumsEvery) {
      const Part part = part_at(events, end);
      if (end > begin && part.utime - indexed_utime_ >= kIndexEvery) break;
      write_i64(part.bytes.data() + 4, number_++);
      index_.sums.push_back(event_sum(part.bytes));
      end += part.bytes.size();
    }
    const std::span<std::uint8_t> piece = events.subspan(begin, end - begin);
    if (!put(piece)) {
      index_.sums.resize(sums);
      number_ = number;
      return begin;
    }
    for (std::size_t at = 0; at < piece.size();) {
      const Part part = part_at(piece, at);
      auto found = index_.channels.find(part.channel);
      if (found == index_.channels.end())
        found = index_.channels.emplace(part.channel, ChannelCount{}).first;
      ++found->second.events;
      found->second.bytes += part.data;
      last_utime_ = part.utime;
      at += part.bytes.size();
    }
    begin = end;
    const bool due = last_utime_ - indexed_utime_ >= kIndexEvery || last_utime_ < indexed_utime_;
    // Where there is no room for the sums, their events go without.
    if ((due || index_.sums.size() >= kSumsEvery) && !write_index()) index_.sums.clear();
  }
  return begin;
}

bool LogWriter::write_index() {
  if (index_.sums.empty()) return true;
  index_.offset = size_;
  index_.first_number = number_ - static_cast<std::int64_t>(index_.sums.size());
  std::vector<std::uint8_t> event;
  append_event(event, last_utime_, kLogIndex, encode_index(index_));
  write_i64(event.data() + 4, number_);
  if (!put(event)) return false;
  ++number_;
  indexed_utime_ = last_utime_;
  index_.sums.clear();
  return true;
}

void LogWriter::add(std::int64_t utime, std::string_view channel,
                    std::span<const std::uint8_t> data) {
  if (channel == kLogIndex) return;  // this file gets its own
  append_event(buffer_, utime, channel, data);
  if (buffer_.size() < kBuffer) return;
  if (write(buffer_) < buffer_.size())
    throw std::runtime_error("log " + file_ + ": " + std::strerror(error_));
  buffer_.clear();
}

void LogWriter::close() {
  if (fd_ < 0) return;
  const bool good = write(buffer_) == buffer_.size() && write_index();
  const int why = error_;
  const bool closed = ::close(fd_) == 0;
  fd_ = -1;
  buffer_.clear();
  if (!good || !closed) {
    throw std::runtime_error("log " + file_ +
                             ": not all was written: " + std::strerror(good ? errno : why));
  }
}

}  // namespace twinbus::viewer_log
