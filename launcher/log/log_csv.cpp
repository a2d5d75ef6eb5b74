// `log csv`: columns of a log as CSV, one row per tick: fields of channels and quantities that follow from them.

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <span>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/process.h"
#include "common/text/closest_name.h"
#include "launcher/log/log_channels.h"
#include "launcher/commands/commands.h"
#include "launcher/log/log_output.h"
#include "launcher/log/log_robot.h"
#include "launcher/log/log_scan.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/older.h"
#include "lcmtypes/bus/wire.h"
#include "viewer_log/log/message_schema.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::size_t kBuffer = 1 << 20;  // [bytes]

// The columns asked for: a field, or an array by its name.
std::vector<const MessageField*> columns_of(const MessageSchema& schema, const std::string& asked,
                                            const std::optional<Model>& model) {
  std::vector<const MessageField*> columns;
  if (asked.empty()) {
    for (const MessageField& field : schema.fields) columns.push_back(&field);
    return columns;
  }
  for (const std::string& name : parts_of(asked, ',')) {
    const std::size_t before = columns.size();
    for (const MessageField& field : schema.fields) {
      if (field.name == name || field.name.starts_with(name + "[") ||
          (model && field_with_joint(field.name, *model) == name)) {
        columns.push_back(&field);
      }
    }
    if (columns.size() > before) continue;
    std::vector<std::string> known;
    for (const MessageField& field : schema.fields)
      known.push_back(field.name.substr(0, field.name.find('[')));
    throw UsageError("log csv: " + schema.type + " has no field '" + name + "'" +
                     suggestion(name, known));
  }
  return columns;
}

// Entries of per-joint arrays that no joint uses are left out.
void drop_unused(std::vector<const MessageField*>& columns, const MessageSchema& schema,
                 std::span<const std::uint8_t> message) {
  const int count_field = schema.find("joint_count");
  if (count_field < 0 || schema.find("q[47]") < 0) return;
  const double joints = field_number(schema.fields[static_cast<std::size_t>(count_field)], message);
  std::erase_if(columns, [&](const MessageField* field) {
    for (const char* name : {"q[", "qd[", "tau[", "kp[", "kd["}) {
      if (field->name.starts_with(name))
        return std::stod(field->name.substr(std::string(name).size())) >= joints;
    }
    return false;
  });
}

class Output {
 public:
  // Nothing is written, and no file made, before there is something to write.
  explicit Output(const std::string& file) : name_(file) {}
  ~Output() {
    if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  void put(std::string& text) {
    if (text.empty()) return;
    if (file_ == nullptr) file_ = name_.empty() ? stdout : std::fopen(name_.c_str(), "wb");
    if (file_ == nullptr) throw std::runtime_error("cannot write " + name_);
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0)
      throw std::runtime_error("cannot write " + (name_.empty() ? "the output" : name_) + ": is the disk full?");
    text.clear();
  }

 private:
  std::string name_;
  std::FILE* file_ = nullptr;
};

}  // namespace

int log_csv(const std::vector<std::string>& words) {
  const Arguments arguments({"log csv", 2, 3, R"(FILE CHANNEL [OUT.csv]
A channel as a table with one row per message; without OUT.csv on the standard output.  Columns of joints
have their names, as in q.LLEG_KNEE.
  --fields A,B  fields, or arrays by their name, or q.LLEG_KNEE; default all
  --numbers  columns by number, as in q[3], instead of the names of joints
  --robot --from --to
  --type T  of a channel that is not ours, as in robot_state_t)"}, words);
  catch_quit_signals();
  const std::string file = arguments.word(0), channel = arguments.word(1);
  refuse_same_file(file, arguments.word(2));
  const ChannelInfo* info = find_channel(channel.c_str());
  for (std::size_t at = 1; info == nullptr && at < channel.size(); ++at) {
    if (channel[at - 1] == '_')
      info = find_channel(channel.c_str() + at);  // R1_STATE, REPLAY_COMMAND
  }
  const std::string type = arguments.text("--type", info != nullptr ? info->type : "");
  const MessageSchema* schema = find_schema(type);
  if (schema == nullptr) {
    require_channels("log csv", {channel}, file);
    std::vector<std::string> known;
    for (const ChannelInfo& one : channel_table()) known.emplace_back(one.type);
    throw UsageError(type.empty() ? "log csv: of which type is " + channel + "? say --type, as in robot_state_t"
                                  : "log csv: there is no type '" + type + "'" + suggestion(type, known));
  }
  const std::size_t ours = channel.find(info != nullptr ? info->channel : channel.c_str());
  const std::string prefix = ours == std::string::npos ? "" : channel.substr(0, ours);
  const std::optional<Model> model = robot_of_hash(
      model_hash_of_log(file, prefix + twinbus::channel::kState), arguments.text("--robot", ""));
  std::vector<const MessageField*> columns =
      columns_of(*schema, arguments.text("--fields", ""), model);
  const bool named = model.has_value() && !arguments.has("--numbers");
  Output output(arguments.word(2));
  std::string text;
  text.reserve(2 * kBuffer);
  std::int64_t rows = 0, strange = 0;
  scan_log(file, arguments.number("--from", 0.0, 0.0, 1e9),
           arguments.number("--to", kWholeLog, 0.0, 1e13), [&](const LogEvent& event) {
             if (event.channel != channel) return true;
             std::array<std::uint8_t, kLargestMessage> room;
             const std::span<const std::uint8_t> data = renewed(event.data, room);
             if (data.size() != schema->bytes) {
               ++strange;
               return true;
             }
             if (rows++ == 0) {
               drop_unused(columns, *schema, data);
               text = "utime";
               for (const MessageField* field : columns)
                 text += "," + (named ? field_with_joint(field->name, *model) : field->name);
               text += "\n";
             }
             text += std::to_string(event.utime);
             for (const MessageField* field : columns) {
               text += ',';
               append_field(text, *field, data);
             }
             text += '\n';
             if (text.size() >= kBuffer) output.put(text);
             return true;
           });
  output.put(text);
  if (rows == 0 && strange > 0)
    throw std::runtime_error("log csv: none of the " + std::to_string(strange) + " messages on " + channel + " is a " + type +
                             "; say --type");
  if (strange > 0)
    std::fprintf(stderr, "log csv: %lld messages on %s are not of type %s\n",
                 static_cast<long long>(strange), channel.c_str(), type.c_str());
  if (rows == 0) throw std::runtime_error(nothing_on("log csv", channel, file));
  return 0;
}

}  // namespace twinbus::launcher
