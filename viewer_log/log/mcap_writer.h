// Writes MCAP files (mcap.dev): self-describing logs that Foxglove and PlotJuggler open, in chunks with an index at the end.
//
// Knows the container only; message_json.h says what a message is in JSON.  Chunks are compressed with zstd, each with its CRC.
// Chunks stand by themselves, so that several threads can fill one each; they are written in the order of the log.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace twinbus::inline viewer_log {

// Some messages that follow one another.
class McapChunk {
 public:
  void add(std::uint16_t channel, std::uint32_t sequence, std::int64_t time_ns,
           std::string_view json);
  // No more messages; sums it up and compresses it.
  void close();

 private:
  friend class McapWriter;
  std::string records_;                           // begins with the channels that are new in it
  std::string compressed_;                        // of a closed chunk
  std::map<std::uint16_t, std::string> indexes_;  // times and offsets per channel, encoded
  std::uint64_t first_ns_ = 0, last_ns_ = 0;
  std::int64_t messages_ = 0;
  std::uint32_t crc_ = 0;
};

class McapWriter {
 public:
  // Makes the file, or empties it.  Throws std::runtime_error naming it.
  explicit McapWriter(const std::string& file);
  ~McapWriter();  // without close() the file lacks its index
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  // A topic and the JSON schema of its messages; gives its id.  The same schema name is written once.
  std::uint16_t add_channel(const std::string& topic, const std::string& schema_name,
                            const std::string& schema);
  // For messages of the channels there are now, of so many bytes of JSON or more; has to be put before a chunk that is
  // begun later.
  McapChunk begin_chunk(std::size_t expected);
  // A closed chunk.  Throws std::runtime_error when the disk does not take it.
  void put(const McapChunk& chunk);
  // Writes the index.  Throws std::runtime_error.
  void close();

  std::int64_t messages() const { return messages_; }
  std::int64_t size() const { return size_; }  // [bytes]

 private:
  struct ChunkPlace {
    std::uint64_t first_ns = 0, last_ns = 0, offset = 0, length = 0, bytes = 0, compressed = 0,
                  index_length = 0;
    std::map<std::uint16_t, std::uint64_t> indexes;  // where the index of each channel lies
  };
  void write(std::string_view bytes);

  std::string file_;
  int fd_ = -1;
  std::int64_t size_ = 0, messages_ = 0;
  std::string declared_;       // schemas and channels, for the summary
  std::size_t in_chunks_ = 0;  // of them [bytes]
  std::uint64_t first_ns_ = 0, last_ns_ = 0;
  std::vector<ChunkPlace> chunks_;
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::uint16_t, std::uint64_t> counts_;
};

}  // namespace twinbus::viewer_log
