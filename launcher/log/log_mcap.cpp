#include <chrono>
#include <cstdio>
#include <deque>
#include <future>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "common/process/arguments.h"
#include "launcher/log/log_command.h"
#include "launcher/log/log_scan.h"
#include "lcmtypes/bus/wire.h"
#include "common/process/process.h"
#include "viewer_log/log/mcap_writer.h"
#include "viewer_log/log/message_json.h"

namespace twinbus {

namespace {

// What becomes of one channel of the log.
struct Topic {
  const MessageSchema* schema = nullptr;  // null: of no type that is known
  std::optional<MessageJson> json;
  std::uint16_t id = 0;
  std::uint32_t sequence = 0;
};

// A part of the log that becomes a chunk.
struct Part {
  struct Message {
    const Topic* topic;
    std::uint32_t sequence;
    std::int64_t time_ns;
    std::size_t offset;  // in bytes
  };
  std::vector<std::uint8_t> bytes;
  std::vector<Message> messages;
};

constexpr std::size_t kPart =
    384 << 10;  // of the log; twice as much in JSON, which a cache holds [bytes]
constexpr std::size_t kAtOnce = 8;  // parts that wait or are made into chunks

McapChunk chunk_of(McapChunk chunk, const Part& part) {
  std::map<std::uint16_t, JsonRoom> rooms;
  for (const Part::Message& message : part.messages) {
    const Topic& topic = *message.topic;
    const std::span data(part.bytes.data() + message.offset, topic.schema->bytes);
    chunk.add(topic.id, message.sequence, message.time_ns,
              topic.json->json_of(data, rooms[topic.id]));
  }
  chunk.close();
  return chunk;
}

// Chunks are made side by side and written in order.
class Works {
 public:
  explicit Works(McapWriter& writer) : writer_(&writer) {}

  void add(Part part) {
    if (waiting_.size() >= kAtOnce) put_oldest();
    waiting_.push_back(std::async(std::launch::async, chunk_of,
                                  writer_->begin_chunk(3 * part.bytes.size()), std::move(part)));
  }
  void finish() {
    while (!waiting_.empty()) put_oldest();
  }

 private:
  void put_oldest() {
    const McapChunk chunk = waiting_.front().get();
    waiting_.pop_front();
    writer_->put(chunk);
  }

  McapWriter* writer_;
  std::deque<std::future<McapChunk>> waiting_;
};

std::string between_commas(const std::string& text) {
  std::string out = ",";
  out += text;
  out += ',';
  return out;
}

}  // namespace

int log_mcap(const std::vector<std::string>& words) {
  const Arguments arguments(
      {"log mcap",
       "IN OUT.mcap",
       "Writes a log as MCAP with JSON messages and their schemas, for Foxglove and PlotJuggler.\n"
       "Channels whose type is not the project's are left out and counted.",
       {{"--channels", "A,B", "only these; default all"},
        {"--from", "S", "seconds from the first event"},
        {"--to", "S", "seconds from the first event"},
        prefix_option()},
       2,
       2},
      words);
  catch_quit_signals();
  const std::string in = arguments.word(0), out = arguments.word(1),
                    prefix = arguments.text("--prefix", "");
  if (in == out)
    throw UsageError("log mcap: " + out + " is the log itself; write into another file");
  const std::string only = between_commas(arguments.text("--channels", ""));
  McapWriter writer(out);
  std::map<std::string, Topic, std::less<>> topics;  // longer there than the works
  Works works(writer);
  Part part;
  std::int64_t unknown = 0, bytes = 0;
  const auto started = std::chrono::steady_clock::now();
  scan_log(
      in, arguments.number("--from", 0.0, 0.0, 1e9), arguments.number("--to", kWholeLog, 0.0, 1e13),
      [&](const LogEvent& event) {
        auto found = topics.find(event.channel);
        if (found == topics.end()) {
          Topic topic;
          const std::string name(event.channel);
          const std::string ours = name.starts_with(prefix) ? name.substr(prefix.size()) : name;
          const ChannelInfo* info = find_channel(ours.c_str());
          const bool wanted = only == ",," || only.find(between_commas(name)) != std::string::npos;
          if (info != nullptr && wanted) topic.schema = find_schema(info->type);
          if (topic.schema != nullptr) {
            topic.json.emplace(*topic.schema);
            topic.id = writer.add_channel(name, topic.schema->type, topic.json->json_schema());
          }
          found = topics.emplace(name, std::move(topic)).first;
        }
        Topic& topic = found->second;
        bytes += static_cast<std::int64_t>(event.bytes.size());
        if (topic.schema == nullptr || event.data.size() != topic.schema->bytes) {
          ++unknown;
          return true;
        }
        part.messages.push_back({&topic, topic.sequence++, 1000 * event.utime, part.bytes.size()});
        part.bytes.insert(part.bytes.end(), event.data.begin(), event.data.end());
        if (part.bytes.size() >= kPart) {
          works.add(std::exchange(part, {}));
          part.bytes.reserve(kPart + kPart / 8);
        }
        return true;
      });
  works.add(std::move(part));
  works.finish();
  writer.close();
  const double took =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  std::printf("%s: %lld messages on %zu channels, %.1f MB, %.0f MB/s of log, %.0f MB/s written",
              out.c_str(), static_cast<long long>(writer.messages()), topics.size(),
              1e-6 * static_cast<double>(writer.size()), 1e-6 * static_cast<double>(bytes) / took,
              1e-6 * static_cast<double>(writer.size()) / took);
  if (unknown > 0)
    std::printf("; %lld events are not of the project's types or were not asked for",
                static_cast<long long>(unknown));
  std::printf("\n");
  if (writer.messages() == 0) throw std::runtime_error("log " + in + ": nothing to write");
  return 0;
}

}  // namespace twinbus
