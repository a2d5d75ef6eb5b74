// One event of a log file, byte for byte as lcm-logger writes it, so that stock LCM tools read our logs and we theirs.
//
//     mark 0xEDA1DA01 | number | time | channel length | data length | channel | data
//         4 bytes         8       8          4                4                          big endian
//
// The format has no checksum; log_index.h adds one.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace twinbus::inline viewer_log {

inline constexpr std::uint32_t kEventMark = 0xEDA1DA01;
inline constexpr std::size_t kEventHead = 28;         // [bytes] before the channel
inline constexpr std::size_t kLongestName = 255;      // of a channel; LCM itself allows 63
inline constexpr std::size_t kLargestData = 8 << 20;  // [bytes]; more is damage

// [us]; times outside 0 .. kLatestTime are damage, so that every time can be counted in nanoseconds.
inline constexpr std::int64_t kLatestTime = (std::int64_t{1} << 62) / 1000;

struct LogEvent {
  std::int64_t number = 0;  // counts up by one per event of a file
  std::int64_t utime = 0;   // [us] since 1970
  std::string_view channel;
  std::span<const std::uint8_t> data;
  std::int64_t offset = 0;              // in the log
  std::int64_t offset_in_part = 0;      // in the file, of a log that has several
  std::span<const std::uint8_t> bytes;  // the whole event
};

inline std::uint32_t read_u32(const std::uint8_t* p) noexcept {
  return std::uint32_t{p[0]} << 24 | std::uint32_t{p[1]} << 16 | std::uint32_t{p[2]} << 8 | p[3];
}
inline std::int64_t read_i64(const std::uint8_t* p) noexcept {
  return static_cast<std::int64_t>(std::uint64_t{read_u32(p)} << 32 | read_u32(p + 4));
}
inline void write_u32(std::uint8_t* p, std::uint32_t x) noexcept {
  for (int i = 0; i < 4; ++i) p[i] = static_cast<std::uint8_t>(x >> (24 - 8 * i));
}
inline void write_i64(std::uint8_t* p, std::int64_t x) noexcept {
  write_u32(p, static_cast<std::uint32_t>(static_cast<std::uint64_t>(x) >> 32));
  write_u32(p + 4, static_cast<std::uint32_t>(x));
}

}  // namespace twinbus::viewer_log
