// `log mcap`: writes a log as MCAP, with what Foxglove draws in 3D.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <deque>
#include <future>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "launcher/log/log_channels.h"
#include "launcher/commands/commands.h"
#include "launcher/log/log_output.h"
#include "launcher/log/log_robot.h"
#include "launcher/log/log_scan.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/older.h"
#include "lcmtypes/bus/wire.h"
#include "viewer_log/log/mcap_writer.h"
#include "viewer_log/log/message_json.h"
#include "launcher/log/foxglove_scene.h"

namespace twinbus::inline launcher {

namespace {

// What becomes of one channel of the log.
struct Topic {
  const MessageSchema* schema = nullptr;  // null: of no type that is known, or JSON already
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
    std::size_t offset, size;  // in bytes
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
    const std::span data(part.bytes.data() + message.offset, message.size);
    if (topic.schema == nullptr) {
      chunk.add(topic.id, message.sequence, message.time_ns,
                {reinterpret_cast<const char*>(data.data()), data.size()});
      continue;
    }
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

void add_message(Part& part, Topic& topic, std::int64_t utime, std::span<const std::uint8_t> data) {
  part.messages.push_back({&topic, topic.sequence++, 1000 * utime, part.bytes.size(), data.size()});
  part.bytes.insert(part.bytes.end(), data.begin(), data.end());
}

// What Foxglove draws in 3D, made from what the log says.
class SceneTopics {
 public:
  SceneTopics(Model model, McapWriter& writer) : model_(std::move(model)), scene_(model_) {
    transforms_.id = writer.add_channel("/tf", kTransformsSchema, transforms_json_schema());
    shapes_.id = writer.add_channel("/scene", kSceneSchema, scene_json_schema());
  }

  void take(const LogEvent& event, const std::string& prefix, Part& part) {
    if (!event.channel.starts_with(prefix)) return;
    const std::string_view name = event.channel.substr(prefix.size());
    if (!told_) put(part, shapes_, event.utime, scene_.robot(event.utime));
    told_ = true;
    if (name == channel::kTruth) {
      SimTruth truth;
      if (decode(event.data, truth) != Status::kOk) return;
      scene_.on_truth(truth, event.utime);
      if (const auto text = scene_.forces(truth, event.utime))
        put(part, shapes_, event.utime, *text);
    } else if (name == channel::kControllerStatus) {
      ControllerStatus status;
      if (decode(event.data, status) == Status::kOk) scene_.on_status(status, event.utime);
    } else if (name == channel::kState) {
      RobotState state;
      if (decode(event.data, state) != Status::kOk) return;
      if (const auto text = scene_.transforms(state, event.utime))
        put(part, transforms_, event.utime, *text);
    } else if (name == channel::kObstacles || name == channel::kTerrain ||
               name == channel::kLoose) {
      ObstaclesPiece piece;
      if (decode(event.data, piece) != Status::kOk) return;
      put(part, shapes_, event.utime,
          FoxgloveScene::obstacles(piece, std::string(name), event.utime));
    }
  }

 private:
  static void put(Part& part, Topic& topic, std::int64_t utime, const std::string& text) {
    add_message(part, topic, utime,
                {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }

  Model model_;
  FoxgloveScene scene_;
  Topic transforms_, shapes_;
  bool told_ = false;
};

}  // namespace

int log_mcap(const std::vector<std::string>& words) {
  const Arguments arguments({"log mcap", 2, 2, R"(IN OUT.mcap
Writes a log as MCAP (zstd) with JSON messages and their schemas, for Foxglove and PlotJuggler, and what
Foxglove draws in 3D: frames of the links on /tf, their shapes, obstacles and contact forces on /scene.
Channels whose type is not the project's are left out and counted.
  --channels A,B  only these; default all
  --from --to
  --robot NAME  of config/robots, or a folder; default the one whose log it is
  --no-scene  without /tf and /scene
  --force --prefix)"}, words);
  catch_quit_signals();
  const std::string in = arguments.word(0), out = log_output(arguments, in), prefix = arguments.text("--prefix", "");
  const std::string only = between_commas(arguments.text("--channels", ""));
  require_channels("log mcap", parts_of(only, ','), in);
  require_prefix("log mcap", prefix, in);
  McapWriter writer(out);
  std::map<std::string, Topic, std::less<>> topics;  // longer there than the works
  std::optional<SceneTopics> scene;
  if (!arguments.has("--no-scene") && only == ",,") {
    const std::int64_t hash = model_hash_of_log(in, prefix + channel::kState);
    if (auto model = robot_of_hash(hash, arguments.text("--robot", ""))) {
      scene.emplace(std::move(*model), writer);
    } else if (hash != 0) {
      std::fprintf(
          stderr,
          "log mcap: no robot of config/robots is the one of this log, so nothing is there "
          "to be drawn in 3D: say --robot\n");
    }
  }
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
        std::array<std::uint8_t, kLargestMessage> room;
        const std::span<const std::uint8_t> data = renewed(event.data, room);
        if (topic.schema == nullptr || data.size() != topic.schema->bytes) {
          ++unknown;
          return true;
        }
        add_message(part, topic, event.utime, data);
        if (scene) scene->take(event, prefix, part);
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
  if (writer.messages() == 0) {
    (void)::unlink(out.c_str());
    throw std::runtime_error("log " + in + ": nothing to write");
  }
  return 0;
}

}  // namespace twinbus::launcher
