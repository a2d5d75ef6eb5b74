#include "viewer_log/log/log_index.h"

#include <zlib.h>

#include <algorithm>

namespace twinbus::inline viewer_log {

namespace {

constexpr std::uint32_t kSign = 0x54574958;  // TWIX
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kMostChannels = 4096;
constexpr std::size_t kMostPlaces = 20;

class Out {
 public:
  void u32(std::uint32_t x) {
    bytes.resize(bytes.size() + 4);
    write_u32(bytes.data() + bytes.size() - 4, x);
  }
  void i64(std::int64_t x) {
    bytes.resize(bytes.size() + 8);
    write_i64(bytes.data() + bytes.size() - 8, x);
  }
  std::vector<std::uint8_t> bytes;
};

class In {
 public:
  explicit In(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t u32() { return take(4) ? read_u32(bytes_.data() + at_ - 4) : 0; }
  std::int64_t i64() { return take(8) ? read_i64(bytes_.data() + at_ - 8) : 0; }
  std::string text(std::size_t count) {
    return take(count)
               ? std::string(reinterpret_cast<const char*>(bytes_.data()) + at_ - count, count)
               : std::string();
  }
  bool good() const { return good_; }

 private:
  bool take(std::size_t count) {
    good_ = good_ && count <= bytes_.size() - at_;
    if (good_) at_ += count;
    return good_;
  }
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

}  // namespace

std::uint32_t event_sum(std::span<const std::uint8_t> event) {
  return static_cast<std::uint32_t>(crc32(0, event.data(), static_cast<uInt>(event.size())));
}

std::vector<std::uint8_t> encode_index(const LogIndex& index) {
  Out out;
  out.u32(kSign);
  out.u32(kVersion);
  out.i64(index.offset);
  out.i64(index.first_utime);
  out.i64(index.first_number);
  out.u32(static_cast<std::uint32_t>(index.sums.size()));
  for (const std::uint32_t sum : index.sums) out.u32(sum);
  out.u32(static_cast<std::uint32_t>(index.channels.size()));
  for (const auto& [name, count] : index.channels) {
    out.u32(static_cast<std::uint32_t>(name.size()));
    out.bytes.insert(out.bytes.end(), name.begin(), name.end());
    out.i64(count.events);
    out.i64(count.bytes);
  }
  return std::move(out.bytes);
}

std::optional<LogIndex> decode_index(std::span<const std::uint8_t> data) {
  In in(data);
  if (in.u32() != kSign || in.u32() != kVersion) return {};
  LogIndex index;
  index.offset = in.i64();
  index.first_utime = in.i64();
  index.first_number = in.i64();
  const std::uint32_t sums = in.u32();
  if (!in.good() || sums > kMostSums) return {};
  for (std::uint32_t i = 0; i < sums; ++i) index.sums.push_back(in.u32());
  const std::uint32_t channels = in.u32();
  if (!in.good() || channels > kMostChannels) return {};
  for (std::uint32_t i = 0; i < channels && in.good(); ++i) {
    const std::uint32_t length = in.u32();
    if (length > kLongestName) return {};
    const std::string name = in.text(length);
    ChannelCount& count = index.channels[name];
    count.events = in.i64();
    count.bytes = in.i64();
  }
  if (!in.good()) return {};
  return index;
}

void LogCheck::add(const LogEvent& event) {
  if (event.channel != kLogIndex) {
    if (waiting_.size() == 2 * kMostSums) {
      waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(kMostSums));
    }
    waiting_.push_back({event.number, event.offset, event_sum(event.bytes)});
  } else if (const auto index = decode_index(event.data)) {
    compare(*index);
    waiting_.clear();
  }
}

void LogCheck::compare(const LogIndex& index) {
  std::vector<bool> found(index.sums.size());
  for (const Waiting& event : waiting_) {
    // Numbers of a damaged log may be anything: no signed difference.
    const std::uint64_t i =
        static_cast<std::uint64_t>(event.number) - static_cast<std::uint64_t>(index.first_number);
    const bool known = event.number >= index.first_number && i < index.sums.size();
    if (known && index.sums[i] == event.sum) {
      ++checked_;
      found[i] = true;
      continue;
    }
    // Also an event whose number was damaged comes here: its true number is then missing, and it is counted once.
    ++wrong_;
    if (known) found[i] = true;
    if (places_.size() < kMostPlaces) places_.push_back(event.offset);
  }
  missing_ += std::count(found.begin(), found.end(), false);
}

}  // namespace twinbus::viewer_log
