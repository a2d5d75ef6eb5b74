// `log plot`: fields of channels as curves: SVG or PNG.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>

#include "common/file/write_file.h"
#include "common/process/arguments.h"
#include "launcher/log/log_channels.h"
#include "launcher/commands/commands.h"
#include "launcher/log/log_plot.h"
#include "launcher/log/log_scan.h"
#include "launcher/stack/run_folder.h"
#include "lcmtypes/bus/older.h"
#include "lcmtypes/bus/wire.h"
#include "common/math/index.h"
#include "robot/description/load.h"
#include "common/text/closest_name.h"
#include "common/process/process.h"
#include "viewer_log/log/message_schema.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::size_t kCurvesOfPanel = 8;

// A curve: a field of a channel, filled while the log is read.
struct Plotted {
  const MessageField* field = nullptr;
  std::size_t panel = 0, curve = 0;
  CurveFiller filler;
};

// "LLEG_KNEE" -> 3, of the bus; -1 when the robot has no such joint.
int joint_index(const std::optional<Model>& model, const std::string& name) {
  if (!model) return -1;
  for (std::size_t k = 0; k < model->bus_joints.size(); ++k) {
    if (model->joints[at(model->bus_joints[k])].name == name) return static_cast<int>(k);
  }
  return -1;
}

class PlotReader {
 public:
  PlotReader(std::string prefix, const std::string& robot) : prefix_(std::move(prefix)) {
    try {
      model_.emplace(load_robot(robot));
    } catch (const std::exception&) {  // joints then have numbers only
    }
  }

  // "STATE.q[3],COMMAND.q[3]" or "STATE.q.LLEG_KNEE": one panel.
  void add_panel(const std::string& asked) {
    panels_.push_back({asked, {}});
    for (const std::string& one : parts_of(asked, ',')) add_curves(one);
    if (panels_.back().curves.empty()) throw UsageError("log plot: '" + asked + "' names no field");
  }

  void take(const LogEvent& event, double seconds) {
    const auto found = wanted_.find(event.channel);
    if (found == wanted_.end()) return;
    std::array<std::uint8_t, kLargestMessage> room;
    const std::span<const std::uint8_t> data = renewed(event.data, room);
    if (data.size() != found->second.schema->bytes) return;
    for (Plotted& plotted : found->second.curves) {
      plotted.filler.add(panels_[plotted.panel].curves[plotted.curve], seconds, field_number(*plotted.field, data));
    }
  }

  const std::vector<Panel>& panels() const { return panels_; }
  std::string first_channel() const { return wanted_.empty() ? "" : wanted_.begin()->first; }

 private:
  struct Wanted {
    const MessageSchema* schema = nullptr;
    std::vector<Plotted> curves;
  };

  void add_curves(const std::string& asked) {
    const std::size_t dot = asked.find('.');
    if (dot == std::string::npos)
      throw UsageError("log plot: '" + asked +
                       "' is not CHANNEL.FIELD, as in STATE.q[3] or STATE.q.LLEG_KNEE");
    const std::string channel = asked.substr(0, dot);
    std::string name = asked.substr(dot + 1);
    const ChannelInfo* info = find_channel(channel.c_str());
    const MessageSchema* schema = info != nullptr ? find_schema(info->type) : nullptr;
    if (schema == nullptr) {
      std::vector<std::string> known;
      for (const ChannelInfo& one : channel_table()) known.emplace_back(one.channel);
      throw UsageError("log plot: no channel '" + channel + "'" + suggestion(channel, known));
    }
    if (const std::size_t last = name.find('.'); last != std::string::npos) {
      const int joint = joint_index(model_, name.substr(last + 1));
      if (joint < 0)
        throw UsageError("log plot: the robot has no joint '" + name.substr(last + 1) +
                         "'; which one? --robot");
      name = name.substr(0, last);
      name += '[';
      name += std::to_string(joint);
      name += ']';
    }
    Wanted& wanted = wanted_[prefix_ + channel];
    wanted.schema = schema;
    const std::size_t before = panels_.back().curves.size();
    for (const MessageField& field : schema->fields) {
      if (field.name != name && !field.name.starts_with(name + "[")) continue;
      if (panels_.back().curves.size() >= kCurvesOfPanel) break;
      wanted.curves.push_back({&field, panels_.size() - 1, panels_.back().curves.size(), {}});
      std::string shown = channel;
      shown += '.';
      shown += field.name;
      panels_.back().curves.push_back({shown, {}, {}});
    }
    if (panels_.back().curves.size() > before) return;
    std::vector<std::string> known;
    for (const MessageField& field : schema->fields)
      known.push_back(field.name.substr(0, field.name.find('[')));
    throw UsageError("log plot: " + schema->type + " has no field '" + name + "'" +
                     suggestion(name, known));
  }

  std::string prefix_;
  std::optional<Model> model_;
  std::map<std::string, Wanted, std::less<>> wanted_;
  std::vector<Panel> panels_;
};

// True when the program was there and did it.
bool ran(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) == nullptr ||
        std::freopen("/dev/null", "w", stderr) == nullptr)
      _exit(1);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

void write_png(const std::string& svg_text, std::size_t panels, const std::string& png) {
  const std::string svg = png + ".svg";
  write_file(svg, svg_text);
  std::string size = "--window-size=990,";
  size += std::to_string(60 + 246 * panels);
  std::string page = "file://", shot = "--screenshot=";
  page += std::filesystem::absolute(svg).string();
  shot += std::filesystem::absolute(png).string();
  const bool done = ran({"rsvg-convert", "-o", png, svg}) ||
                    ran({"chromium", "--headless", "--no-sandbox", "--disable-gpu",
                         "--hide-scrollbars", size, shot, page});
  std::error_code ignored;
  std::filesystem::remove(svg, ignored);
  if (!done || !std::filesystem::exists(png))
    throw std::runtime_error(
        "log plot: " + png +
        " needs rsvg-convert (apt install librsvg2-bin) or chromium; or ask for .svg");
}

}  // namespace

int log_plot(const std::vector<std::string>& words) {
  const Arguments arguments({"log plot", 2, 12, R"(FILE FIELD...
Draws fields over time, one panel per FIELD: STATE.q[3], STATE.q.LLEG_KNEE, or several with commas,
as in STATE.q.LLEG_KNEE,COMMAND.q.LLEG_KNEE; an array by its name draws its first eight.
  --out F.svg|F.png  default plot.svg
  --from --to --robot --prefix)"}, words);
  catch_quit_signals();
  const std::string file = arguments.word(0), out = arguments.text("--out", "plot.svg");
  const bool png = out.ends_with(".png");
  if (!png && !out.ends_with(".svg"))
    throw UsageError("log plot: --out ends with .svg or .png, not '" + out + "'");
  PlotReader reader(arguments.text("--prefix", ""), arguments.text("--robot", "hrp1s"));
  for (std::size_t i = 1; i < arguments.words().size(); ++i) reader.add_panel(arguments.words()[i]);
  LogReader log(file);
  const std::int64_t start = first_time(log, file);
  scan_log(file, arguments.number("--from", 0.0, 0.0, 1e9),
           arguments.number("--to", kWholeLog, 0.0, 1e13), [&](const LogEvent& event) {
             reader.take(event,
                         1e-6 * (static_cast<double>(event.utime) - static_cast<double>(start)));
             return true;
           });
  std::size_t points = 0;
  for (const Panel& panel : reader.panels()) {
    for (const Curve& curve : panel.curves) points += curve.x.size();
  }
  if (points == 0) throw std::runtime_error(nothing_on("log plot", reader.first_channel(), file));
  const std::string svg = svg_of(file, reader.panels());
  if (png) {
    write_png(svg, reader.panels().size(), out);
  } else {
    write_file(out, svg);
  }
  std::printf("%s: %zu points\n", out.c_str(), points);
  return 0;
}

}  // namespace twinbus::launcher
