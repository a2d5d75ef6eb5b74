// Writes MCAP files (mcap.dev): self-describing logs that Foxglove and PlotJuggler open, in chunks with an index at the end.
//
// Knows the container only; message_json.h says what a message is in JSON.  Uncompressed, each chunk with its CRC.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace twinbus {

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
  // Throws std::runtime_error when the disk does not take it.
  void add(std::uint16_t channel, std::uint32_t sequence, std::int64_t time_ns,
           std::string_view json);
  // Writes what is buffered, and the index.  Throws std::runtime_error.
  void close();

  std::int64_t messages() const { return messages_; }
  std::int64_t size() const { return size_; }  // [bytes]

 private:
  struct ChunkPlace {
    std::uint64_t first_ns = 0, last_ns = 0, offset = 0, length = 0, bytes = 0, index_length = 0;
    std::map<std::uint16_t, std::uint64_t> indexes;  // where the index of each channel lies
  };
  void end_chunk();
  void put(std::string_view bytes);

  std::string file_;
  int fd_ = -1;
  std::int64_t size_ = 0, messages_ = 0;
  std::string chunk_,
      declared_;  // records of the open chunk; schemas and channels, for the summary
  std::uint64_t chunk_first_ = 0, chunk_last_ = 0, first_ns_ = 0, last_ns_ = 0;
  std::map<std::uint16_t, std::string> chunk_index_;  // times and offsets, encoded
  std::vector<ChunkPlace> chunks_;
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::uint16_t, std::uint64_t> counts_;
};

}  // namespace twinbus
