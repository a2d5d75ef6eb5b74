// Writes log files that stock LCM tools read, with an index event once a second (log_index.h).

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer_log/log/log_index.h"

namespace twinbus::inline viewer_log {

// Appends one event to bytes; its number is given when it is written.
void append_event(std::vector<std::uint8_t>& bytes, std::int64_t utime, std::string_view channel,
                  std::span<const std::uint8_t> data);

// Nobody's log is lost to a name that was used before.  Throws std::runtime_error when a log of that name, or a part of one,
// is there.
void refuse_if_there(const std::string& file);
// Of a log whose first file is written anew: the parts of the one before, which would be read as its own.
void remove_later_parts(const std::string& file);

class LogWriter {
 public:
  // Makes the file, or empties it.  Throws std::runtime_error naming it.
  explicit LogWriter(const std::string& file);
  ~LogWriter();  // close() without asking how it went
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  // For tools: buffers.  Throws std::runtime_error when the disk does not take it.
  void add(std::int64_t utime, std::string_view channel, std::span<const std::uint8_t> data);
  // Writes what is buffered and the last index.  Throws std::runtime_error.
  void close();

  // For a recorder: whole events made by append_event(), written now.  Returns how many bytes of them, whole events
  // again, the disk took; error() says why it did not take all.
  [[nodiscard]] std::size_t write(std::span<std::uint8_t> events);
  [[nodiscard]] bool write_index();
  int error() const { return error_; }

  std::int64_t size() const { return size_; }  // [bytes] in the file
  std::int64_t events() const { return number_; }
  const ChannelCounts& channels() const { return index_.channels; }

 private:
  bool put(std::span<const std::uint8_t> bytes);

  std::string file_;
  int fd_ = -1, error_ = 0;
  std::int64_t size_ = 0, number_ = 0, last_utime_ = 0, indexed_utime_ = 0;
  LogIndex index_;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace twinbus::viewer_log
