#include <chrono>
#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>

#include "launcher/arguments.h"
#include "launcher/log_command.h"
#include "launcher/log_scan.h"
#include "lcmtypes/wire.h"
#include "robot/process.h"
#include "viewer_log/mcap_writer.h"
#include "viewer_log/message_json.h"

namespace twinbus {

namespace {

// What becomes of one channel of the log.
struct Topic {
  const MessageSchema* schema = nullptr;  // null: of no type that is known
  std::optional<MessageJson> json;
  std::uint16_t id = 0;
  std::uint32_t sequence = 0;
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
  std::map<std::string, Topic, std::less<>> topics;
  std::int64_t unknown = 0, bytes = 0;
  std::string json;
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
        json.clear();
        topic.json->append(json, event.data);
        writer.add(topic.id, topic.sequence++, 1000 * event.utime, json);
        return true;
      });
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
