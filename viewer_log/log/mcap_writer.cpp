#include "viewer_log/log/mcap_writer.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace twinbus::inline viewer_log {

namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr char kCompression[] = "zstd";
constexpr int kLevel = 1;  // of zstd: a tenth of the bytes, faster than a disk

enum Opcode : char {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunkRecord = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kDataEnd = 0x0F
};

// Little endian, as MCAP wants it.
template <class T>
void put_number(std::string& out, T value) {
  char bytes[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = static_cast<char>(value >> (8 * i) & 0xff);
  out.append(bytes, sizeof bytes);
}
void put_text(std::string& out, std::string_view value) {
  put_number(out, static_cast<std::uint32_t>(value.size()));
  out.append(value);
}
void put_head(std::string& out, Opcode opcode, std::uint64_t length) {
  out.push_back(opcode);
  put_number(out, length);
}
std::string record(Opcode opcode, std::string_view content) {
  std::string out;
  put_head(out, opcode, content.size());
  out.append(content);
  return out;
}
std::string offsets(const std::map<std::uint16_t, std::uint64_t>& map) {
  std::string out;
  put_number(out, static_cast<std::uint32_t>(map.size() * 10));
  for (const auto& [key, value] : map) {
    put_number(out, key);
    put_number(out, value);
  }
  return out;
}

}  // namespace

McapWriter::McapWriter(const std::string& file) : file_(file) {
  fd_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd_ < 0)
    throw std::runtime_error("mcap " + file + ": cannot be written: " + std::strerror(errno));
  std::string header;
  put_text(header, "");
  put_text(header, "twinbus");
  write(kMagic);
  write(record(kHeader, header));
}

McapWriter::~McapWriter() {
  if (fd_ >= 0) ::close(fd_);
}

void McapWriter::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      throw std::runtime_error("mcap " + file_ + ": cannot be written: " + std::strerror(errno));
    bytes.remove_prefix(static_cast<std::size_t>(written));
    size_ += written;
  }
}

std::uint16_t McapWriter::add_channel(const std::string& topic, const std::string& schema_name,
                                      const std::string& schema) {
  const auto [found, is_new] =
      schemas_.try_emplace(schema_name, static_cast<std::uint16_t>(schemas_.size() + 1));
  if (is_new) {
    std::string content;
    put_number(content, found->second);
    put_text(content, schema_name);
    put_text(content, "jsonschema");
    put_text(content, schema);
    declared_ += record(kSchema, content);
  }
  const auto id = static_cast<std::uint16_t>(counts_.size());
  std::string content;
  put_number(content, id);
  put_number(content, found->second);
  put_text(content, topic);
  put_text(content, "json");
  put_number(content, std::uint32_t{0});  // no metadata
  declared_ += record(kChannel, content);
  counts_[id] = 0;
  return id;
}

void McapChunk::add(std::uint16_t channel, std::uint32_t sequence, std::int64_t time_ns,
                    std::string_view json) {
  const auto time = static_cast<std::uint64_t>(std::max<std::int64_t>(time_ns, 0));
  std::string& index = indexes_[channel];
  put_number(index, time);
  put_number(index, static_cast<std::uint64_t>(records_.size()));
  first_ns_ = messages_ == 0 ? time : std::min(first_ns_, time);
  last_ns_ = std::max(last_ns_, time);
  ++messages_;
  put_head(records_, kMessage, 22 + json.size());
  put_number(records_, channel);
  put_number(records_, sequence);
  put_number(records_, time);
  put_number(records_, time);
  records_.append(json);
}

void McapChunk::close() {
  crc_ = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(records_.data()),
                                          static_cast<uInt>(records_.size())));
  compressed_.resize(ZSTD_compressBound(records_.size()));
  const std::size_t bytes = ZSTD_compress(compressed_.data(), compressed_.size(), records_.data(),
                                          records_.size(), kLevel);
  if (ZSTD_isError(bytes) != 0)
    throw std::runtime_error(std::string("mcap: zstd: ") + ZSTD_getErrorName(bytes));
  compressed_.resize(bytes);
}

McapChunk McapWriter::begin_chunk(std::size_t expected) {
  McapChunk chunk;
  chunk.records_.reserve(expected);
  chunk.records_ = std::string_view(declared_).substr(in_chunks_);
  in_chunks_ = declared_.size();
  return chunk;
}

void McapWriter::put(const McapChunk& chunk) {
  if (chunk.records_.empty()) return;
  ChunkPlace place;
  place.first_ns = chunk.first_ns_;
  place.last_ns = chunk.last_ns_;
  place.offset = static_cast<std::uint64_t>(size_);
  place.bytes = chunk.records_.size();
  place.compressed = chunk.compressed_.size();
  std::string out;
  put_head(out, kChunkRecord, 8 + 8 + 8 + 4 + 4 + std::strlen(kCompression) + 8 + place.compressed);
  put_number(out, place.first_ns);
  put_number(out, place.last_ns);
  put_number(out, place.bytes);
  put_number(out, chunk.crc_);
  put_text(out, kCompression);
  put_number(out, place.compressed);
  write(out);
  write(chunk.compressed_);
  place.length = static_cast<std::uint64_t>(size_) - place.offset;
  out.clear();
  for (const auto& [channel, index] : chunk.indexes_) {
    place.indexes[channel] = static_cast<std::uint64_t>(size_) + out.size();
    put_head(out, kMessageIndex, 2 + 4 + index.size());
    put_number(out, channel);
    put_text(out, index);
    counts_[channel] += index.size() / 16;
  }
  place.index_length = out.size();
  write(out);
  if (chunk.messages_ > 0) {
    first_ns_ = messages_ == 0 ? place.first_ns : std::min(first_ns_, place.first_ns);
    last_ns_ = std::max(last_ns_, place.last_ns);
  }
  messages_ += chunk.messages_;
  chunks_.push_back(std::move(place));
}

void McapWriter::close() {
  std::string end;
  put_number(end, std::uint32_t{0});  // no CRC of the whole
  write(record(kDataEnd, end));
  const auto summary = static_cast<std::uint64_t>(size_);
  write(declared_);
  std::string content;
  put_number(content, static_cast<std::uint64_t>(messages_));
  put_number(content, static_cast<std::uint16_t>(schemas_.size()));
  put_number(content, static_cast<std::uint32_t>(counts_.size()));
  put_number(content, std::uint32_t{0});  // attachments
  put_number(content, std::uint32_t{0});  // metadata
  put_number(content, static_cast<std::uint32_t>(chunks_.size()));
  put_number(content, first_ns_);
  put_number(content, last_ns_);
  content += offsets(counts_);
  write(record(kStatistics, content));
  for (const ChunkPlace& place : chunks_) {
    content.clear();
    put_number(content, place.first_ns);
    put_number(content, place.last_ns);
    put_number(content, place.offset);
    put_number(content, place.length);
    content += offsets(place.indexes);
    put_number(content, place.index_length);
    put_text(content, kCompression);
    put_number(content, place.compressed);
    put_number(content, place.bytes);
    write(record(kChunkIndex, content));
  }
  content.clear();
  put_number(content, summary);
  put_number(content, std::uint64_t{0});  // no table of the summary
  put_number(content, std::uint32_t{0});
  write(record(kFooter, content));
  write(kMagic);
  if (::close(std::exchange(fd_, -1)) != 0)
    throw std::runtime_error("mcap " + file_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace twinbus::viewer_log
