#include "viewer_log/log/log_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "common/text/formatted.h"

namespace twinbus::inline viewer_log {

namespace {
constexpr std::size_t kWindow = 1 << 20;         // read at once [bytes]
constexpr std::int64_t kNowhere = -1;            // no such place
constexpr std::int64_t kFineEnough = 64 * 1024;  // a seek reads so much in order [bytes]
constexpr int kMostSuspects =
    200;  // looked at inside one event, so that no file costs more than reading it
constexpr std::size_t kPartDigits = 4, kMostPartDigits = 9;  // of run-0002.log
constexpr std::size_t kMostOpen = 256;                       // parts whose files stay open
namespace fs = std::filesystem;
}  // namespace

std::string log_part_name(const std::string& file, int part) {
  if (part <= 1) return file;
  const fs::path path(file);
  return (path.parent_path() / (path.stem().string() + formatted("-%04d", part) + path.extension().string())).string();
}

std::vector<std::string> log_parts(const std::string& file) {
  const fs::path path(file);
  const std::string stem = path.stem().string() + "-", ending = path.extension().string();
  std::vector<std::pair<long, std::string>> found;
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(stem) || !name.ends_with(ending) ||
        name.size() < stem.size() + ending.size())
      continue;
    const std::string number = name.substr(stem.size(), name.size() - stem.size() - ending.size());
    if (number.size() < kPartDigits || number.size() > kMostPartDigits ||
        number.find_first_not_of("0123456789") != std::string::npos) {
      continue;
    }
    const long part = std::stol(number);
    std::error_code ignored;
    if (part < 2 || fs::path(log_part_name(file, static_cast<int>(part))).filename() != name ||
        !at->is_regular_file(ignored))
      continue;
    found.emplace_back(part, log_part_name(file, static_cast<int>(part)));
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> files = {file};
  for (auto& [part, name] : found) files.push_back(std::move(name));
  return files;
}

std::string log_of_part(const std::string& file) {
  const fs::path path(file);
  const std::string stem = path.stem().string();
  const std::size_t dash = stem.rfind('-');
  if (dash == std::string::npos || dash == 0) return "";
  const std::string whole =
      (path.parent_path() / (stem.substr(0, dash) + path.extension().string())).string();
  std::error_code ignored;
  if (!fs::is_regular_file(whole, ignored)) return "";
  const std::vector<std::string> parts = log_parts(whole);
  return std::find(parts.begin() + 1, parts.end(), file) != parts.end() ? whole : "";
}

namespace {

// The time of the first event of a file [us]; the smallest number when there is none.
std::int64_t first_time_of(int fd, std::int64_t size) {
  std::vector<std::uint8_t> head(
      static_cast<std::size_t>(std::min<std::int64_t>(size, kFineEnough)));
  const ssize_t got = pread(fd, head.data(), head.size(), 0);
  LogReader reader(
      std::span<const std::uint8_t>(head.data(), got > 0 ? static_cast<std::size_t>(got) : 0));
  LogEvent event;
  return reader.next(event) ? event.utime : std::numeric_limits<std::int64_t>::min();
}

}  // namespace

LogReader::LogReader(const std::string& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat about {};
  if (fd < 0 || fstat(fd, &about) != 0) {
    throw std::runtime_error("log " + file + ": cannot be read: " + std::strerror(errno));
  }
  if (!S_ISREG(about.st_mode)) {
    ::close(fd);
    throw std::runtime_error("log " + file + ": is not a file");
  }
  parts_.push_back({file, fd, 0, about.st_size});
  size_ = about.st_size;
  const std::vector<std::string> files = log_parts(file);
  for (std::size_t i = 1; i < files.size(); ++i) add_part(files[i]);
}

LogReader::LogReader(std::span<const std::uint8_t> bytes)
    : memory_(bytes), size_(static_cast<std::int64_t>(bytes.size())) {}

LogReader::~LogReader() {
  for (const Part& part : parts_) {
    if (part.fd >= 0) ::close(part.fd);
  }
}

// A part that is gone by now is left out, so is one that is older than the log: it is of another recording.
void LogReader::add_part(const std::string& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat about {};
  const bool there =
      fd >= 0 && fstat(fd, &about) == 0 && S_ISREG(about.st_mode) && about.st_size > 0;
  if (!there ||
      first_time_of(fd, about.st_size) < first_time_of(parts_.front().fd, parts_.front().size)) {
    if (fd >= 0) ::close(fd);
    return;
  }
  // What a part before it got in the meantime belongs in front of it.
  Part& last = parts_.back();
  struct stat before {};
  if (last.fd >= 0 && fstat(last.fd, &before) == 0 && before.st_size > last.size) {
    size_ += before.st_size - last.size;
    last.size = before.st_size;
  }
  parts_.push_back({file, fd, size_, about.st_size});
  size_ += about.st_size;
  // Files that are open outlive their removal by a quota; very many cannot all be open.
  if (parts_.size() > kMostOpen) ::close(std::exchange(parts_.back().fd, -1));
}

std::int64_t LogReader::part_begin(int part) const {
  return parts_.empty() ? 0 : parts_[static_cast<std::size_t>(part)].begin;
}

std::int64_t LogReader::part_end(int part) const {
  if (parts_.empty()) return size_;
  const Part& p = parts_[static_cast<std::size_t>(part)];
  return p.begin + p.size;
}

const LogReader::Part* LogReader::part_at(std::int64_t offset) const {
  const auto behind =
      std::upper_bound(parts_.begin(), parts_.end(), offset,
                       [](std::int64_t at, const Part& part) { return at < part.begin; });
  return behind == parts_.begin() ? nullptr : &*(behind - 1);
}

bool LogReader::is_part_begin(std::int64_t offset) const {
  if (parts_.size() < 2) return false;
  const Part* part = part_at(offset);
  return part != nullptr && part->begin == offset;
}

void LogReader::go_to(std::int64_t offset) { offset_ = std::clamp<std::int64_t>(offset, 0, size_); }

// So many bytes from offset on; null if the log ends before.
const std::uint8_t* LogReader::view(std::int64_t offset, std::size_t count) {
  if (offset < 0 || static_cast<std::int64_t>(count) > size_ - offset) return nullptr;
  if (parts_.empty()) return memory_.data() + offset;
  const std::int64_t before = offset - window_offset_;
  if (before >= 0 &&
      before + static_cast<std::int64_t>(count) <= static_cast<std::int64_t>(window_count_)) {
    return window_.data() + before;
  }
  return read(offset, count) ? window_.data() : nullptr;
}

// Fills the window from offset on, across parts, with at least count bytes.
bool LogReader::read(std::int64_t offset, std::size_t count) {
  const std::size_t wanted = std::max(count, kWindow);
  if (window_.size() < wanted) window_.resize(wanted);
  window_offset_ = offset;
  window_count_ = 0;
  while (window_count_ < count) {
    const std::int64_t at = offset + static_cast<std::int64_t>(window_count_);
    const Part& part = *part_at(at);
    const std::int64_t in_part = part.begin + part.size - at;
    if (in_part <= 0) return false;
    const int fd = part.fd >= 0 ? part.fd : ::open(part.file.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) return false;
    const ssize_t got =
        pread(fd, window_.data() + window_count_,
              std::min(wanted - window_count_, static_cast<std::size_t>(in_part)), at - part.begin);
    const bool again = got < 0 && errno == EINTR;
    if (fd != part.fd) ::close(fd);
    if (again) continue;
    if (got <= 0) return false;  // cut while it was read, or the disk fails
    window_count_ += static_cast<std::size_t>(got);
  }
  return true;
}

// Could an event begin here?  Everything but its end is asked.
bool LogReader::head_at(std::int64_t offset, Head& head) {
  const std::uint8_t* p = view(offset, kEventHead);
  if (p == nullptr || read_u32(p) != kEventMark) return false;
  head.number = read_i64(p + 4);
  const std::int64_t utime = read_i64(p + 12);
  if (utime < 0 || utime > kLatestTime) return false;
  head.name = read_u32(p + 20);
  head.data = read_u32(p + 24);
  if (head.name < 1 || head.name > kLongestName || head.data > kLargestData) return false;
  const std::uint8_t* name = view(offset, kEventHead + head.name);
  if (name == nullptr) return false;
  return std::all_of(name + kEventHead, name + kEventHead + head.name,
                     [](std::uint8_t c) { return c > 0x20 && c < 0x7f; });
}

// The log or a part of it ends here, or the event of this number begins.
bool LogReader::begins_well(std::int64_t offset, std::int64_t number) {
  Head head;
  return offset == size_ || is_part_begin(offset) ||
         (head_at(offset, head) && head.number == number);
}

std::int64_t LogReader::next_mark(std::int64_t from, std::int64_t to) {
  constexpr std::size_t kMarkBytes = 4;
  while (from + static_cast<std::int64_t>(kMarkBytes) <= to) {
    const auto count = static_cast<std::size_t>(
        std::min<std::int64_t>(to - from, static_cast<std::int64_t>(kWindow)));
    const std::uint8_t* begin = view(from, count);
    if (begin == nullptr) return kNowhere;
    const std::uint8_t* end = begin + count - (kMarkBytes - 1);
    for (const std::uint8_t* p = begin; p < end; ++p) {
      p = static_cast<const std::uint8_t*>(
          std::memchr(p, kEventMark >> 24, static_cast<std::size_t>(end - p)));
      if (p == nullptr) break;
      if (read_u32(p) == kEventMark) return from + (p - begin);
    }
    from += static_cast<std::int64_t>(count - (kMarkBytes - 1));
  }
  return kNowhere;
}

// A wrong length makes an event swallow others: one that is the successor by its number, or that ends where a
// third begins, is believed rather than the length.
std::int64_t LogReader::other_event_inside(std::int64_t offset, const Head& head) {
  const std::int64_t end =
      std::min(offset + head.total() + 3, size_);  // a mark may lie across the end
  int suspects = 0;
  for (std::int64_t at = next_mark(offset + 4, end); at != kNowhere && suspects < kMostSuspects;
       at = next_mark(at + 1, end), ++suspects) {
    Head other, third;
    if (!head_at(at, other) || at + other.total() > size_) continue;
    const std::int64_t behind = at + other.total();
    if (other.number == head.number + 1 || behind == size_ || head_at(behind, third)) return at;
  }
  return kNowhere;
}

// The first intact event at or behind offset, which moves behind it.
bool LogReader::event_at(std::int64_t& offset, LogEvent& event, LogDamage& damage) {
  std::int64_t bad_from = kNowhere;
  Head head;
  while (offset < size_) {
    std::int64_t other = kNowhere;
    const bool possible = head_at(offset, head);
    const bool whole = possible && offset + head.total() <= size_;
    if (whole && !begins_well(offset + head.total(), head.number + 1)) {
      other = other_event_inside(offset, head);
    }
    if (whole && other == kNowhere) break;
    if (bad_from == kNowhere) bad_from = offset;
    if (other == kNowhere) other = next_mark(offset + 1, size_);
    if (other == kNowhere) {
      damage.cut = possible || size_ - offset < static_cast<std::int64_t>(kEventHead);
      other = size_;
    }
    offset = other;
  }
  if (bad_from != kNowhere) {
    ++damage.places;
    damage.bytes += offset - bad_from;
  }
  if (offset >= size_) return false;
  const auto total = static_cast<std::size_t>(head.total());
  const std::uint8_t* p = view(offset, total);
  if (p == nullptr) return false;
  event.number = head.number;
  event.utime = read_i64(p + 12);
  event.channel = {reinterpret_cast<const char*>(p + kEventHead), head.name};
  event.data = {p + kEventHead + head.name, head.data};
  event.offset = offset;
  event.offset_in_part = parts_.empty() ? offset : offset - part_at(offset)->begin;
  event.bytes = {p, total};
  offset += static_cast<std::int64_t>(total);
  return true;
}

bool LogReader::next(LogEvent& event) { return event_at(offset_, event, damage_); }

void LogReader::seek(std::int64_t utime) {
  LogEvent event;
  LogDamage ignored;
  std::int64_t low = 0, high = size_;  // the event wanted begins in low .. high
  while (high - low > kFineEnough) {
    const std::int64_t middle = low + (high - low) / 2;
    std::int64_t at = middle;
    if (!event_at(at, event, ignored) || event.utime >= utime || event.offset >= high) {
      high = middle;
    } else {
      low = event.offset;
    }
  }
  for (offset_ = low; event_at(offset_, event, ignored);) {
    if (event.utime >= utime) {
      offset_ = event.offset;
      return;
    }
  }
}

}  // namespace twinbus::viewer_log
