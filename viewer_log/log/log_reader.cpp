#include "viewer_log/log/log_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace twinbus {

namespace {
constexpr std::size_t kWindow = 1 << 20;         // read at once [bytes]
constexpr std::int64_t kNowhere = -1;            // no such place
constexpr std::int64_t kFineEnough = 64 * 1024;  // a seek reads so much in order [bytes]
constexpr int kMostSuspects =
    200;  // looked at inside one event, so that no file costs more than reading it
}  // namespace

LogReader::LogReader(const std::string& file) {
  fd_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat about {};
  if (fd_ < 0 || fstat(fd_, &about) != 0) {
    throw std::runtime_error("log " + file + ": cannot be read: " + std::strerror(errno));
  }
  if (!S_ISREG(about.st_mode)) {
    ::close(fd_);
    throw std::runtime_error("log " + file + ": is not a file");
  }
  size_ = about.st_size;
}

LogReader::LogReader(std::span<const std::uint8_t> bytes)
    : memory_(bytes), size_(static_cast<std::int64_t>(bytes.size())) {}

LogReader::~LogReader() {
  if (fd_ >= 0) ::close(fd_);
}

void LogReader::look_for_more() {
  struct stat about {};
  if (fd_ >= 0 && fstat(fd_, &about) == 0) size_ = std::max<std::int64_t>(size_, about.st_size);
}

void LogReader::go_to(std::int64_t offset) { offset_ = std::clamp<std::int64_t>(offset, 0, size_); }

// So many bytes from offset on; null if the log ends before.
const std::uint8_t* LogReader::view(std::int64_t offset, std::size_t count) {
  if (offset < 0 || static_cast<std::int64_t>(count) > size_ - offset) return nullptr;
  if (fd_ < 0) return memory_.data() + offset;
  const std::int64_t before = offset - window_offset_;
  if (before >= 0 &&
      before + static_cast<std::int64_t>(count) <= static_cast<std::int64_t>(window_count_)) {
    return window_.data() + before;
  }
  const std::size_t wanted = std::max(count, kWindow);
  if (window_.size() < wanted) window_.resize(wanted);
  window_offset_ = offset;
  window_count_ = 0;
  while (window_count_ < count) {
    const ssize_t got = pread(fd_, window_.data() + window_count_, wanted - window_count_,
                              offset + static_cast<std::int64_t>(window_count_));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return nullptr;  // cut while it was read, or the disk fails
    window_count_ += static_cast<std::size_t>(got);
  }
  return window_.data();
}

// Could an event begin here?  Everything but its end is asked.
bool LogReader::head_at(std::int64_t offset, Head& head) {
  const std::uint8_t* p = view(offset, kEventHead);
  if (p == nullptr || read_u32(p) != kEventMark) return false;
  head.number = read_i64(p + 4);
  head.name = read_u32(p + 20);
  head.data = read_u32(p + 24);
  if (head.name < 1 || head.name > kLongestName || head.data > kLargestData) return false;
  const std::uint8_t* name = view(offset, kEventHead + head.name);
  if (name == nullptr) return false;
  return std::all_of(name + kEventHead, name + kEventHead + head.name,
                     [](std::uint8_t c) { return c > 0x20 && c < 0x7f; });
}

// The log ends here, or the event of this number begins.
bool LogReader::begins_well(std::int64_t offset, std::int64_t number) {
  Head head;
  return offset == size_ || (head_at(offset, head) && head.number == number);
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

}  // namespace twinbus
