// The replay process: the states of a log as a source of STATE, restamped with a run and term of its own.
//
// It is a source like any other (role parked until it is activated or switched to) whose robot is a recording: it
// obeys nobody, because what happened has happened.  Everything else of the log appears under REPLAY_, so that it moves
// nothing.  Words on the standard input: pause, play, seek S, speed X, loop on, loop off, where, quit.

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>

#include "bridge/source/source_main.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "viewer_log/log/log_player.h"

namespace twinbus::inline viewer_log {
namespace {

constexpr char kReplay[] = "REPLAY_";
constexpr std::size_t kMostReplayed = 1400;  // larger messages of a log are not sent again [bytes]
constexpr int kMostPerTick = 200;            // messages beside STATE
constexpr std::size_t kLongestChannel = 63;

struct Arguments {
  SourceMainOptions source;
  std::string file, recorded_prefix;
  double speed = 1.0, from = 0.0;
  bool loop = false, paused = false, quiet = false;
};

// A robot that is a recording.
class RecordedRobot : public RobotAdaptor {
 public:
  RecordedRobot(const Arguments& a, const Model& model)
      : model_(model),
        prefix_(a.recorded_prefix),
        quiet_(a.quiet),
        player_(a.file),
        bus_({.url = a.source.common.url, .prefix = a.source.common.prefix, .allow = {}}) {
    player_.set_loop(a.loop);
    player_.set_speed(a.speed);
    find_first_state(a.file);
    player_.seek(a.from);
    player_.pause(a.paused);
  }

  Status open(const Model&, const AdaptorConfig&) override { return Status::kOk; }
  void close() override {}
  bool is_hardware() const override { return false; }
  Status write(const JointCommand&) override { return Status::kOk; }

  // Moves on by one period; the newest state that was passed is what the robot measures.
  Status read(RobotState& state, double) override {
    take_words();
    sent_ = 0;
    player_.advance(model_.period(), [this](const LogEvent& event) { pass(event); });
    state.source_time_ns = state_.source_time_ns;
    state.enabled = state_.enabled;
    state.sensor_flags = state_.sensor_flags;
    state.wrench_kind = state_.wrench_kind;
    state.q = state_.q;
    state.qd = state_.qd;
    state.tau = state_.tau;
    state.attitude = state_.attitude;
    state.gyro = state_.gyro;
    state.accel = state_.accel;
    state.wrench = state_.wrench;
    if (player_.paused() || player_.at_end()) state.qd.fill(0.0F);  // it stands still
    return Status::kOk;
  }

  const LogPlayer& player() const { return player_; }

 private:
  void find_first_state(const std::string& file) {
    LogReader reader(file);
    for (LogEvent event; reader.next(event);) {
      RobotState state;
      if (event.channel != prefix_ + channel::kState || decode(event.data, state) != Status::kOk)
        continue;
      if (state.model_hash != model_.hash || state.joint_count != model_.bus_count()) {
        throw std::runtime_error("log " + file + ": its robot is not " + model_.name +
                                 " as it is now (model hash " + std::to_string(state.model_hash) +
                                 ", now " + std::to_string(model_.hash) +
                                 "); say which with --robot");
      }
      state_ = state;
      return;
    }
    throw std::runtime_error("log " + file +
                             ": no STATE of this bus's messages in it; recorded with a prefix? say "
                             "which with --recorded-prefix");
  }

  void pass(const LogEvent& event) {
    if (!event.channel.starts_with(prefix_)) return;
    const std::string_view name = event.channel.substr(prefix_.size());
    if (name == channel::kState) {
      RobotState state;
      if (decode(event.data, state) == Status::kOk && state.model_hash == model_.hash &&
          state.joint_count == model_.bus_count()) {
        state_ = state;
      }
      return;
    }
    if (quiet_ || event.data.size() > kMostReplayed || ++sent_ > kMostPerTick ||
        std::strlen(kReplay) + name.size() > kLongestChannel) {
      return;
    }
    char replayed[kLongestChannel + 1];
    std::snprintf(replayed, sizeof replayed, "%s%.*s", kReplay, static_cast<int>(name.size()),
                  name.data());
    (void)bus_.send_raw(replayed, event.data);
  }

  // At most one line per tick, without waiting.
  void take_words() {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (input_ended_ || poll(&input, 1, 0) <= 0) return;
    char bytes[256];
    const ssize_t got = ::read(STDIN_FILENO, bytes, sizeof bytes);
    if (got <= 0) {
      input_ended_ = true;
      return;
    }
    line_.append(bytes, static_cast<std::size_t>(got));
    for (std::size_t end = line_.find('\n'); end != std::string::npos; end = line_.find('\n')) {
      obey(line_.substr(0, end));
      line_.erase(0, end + 1);
    }
    if (line_.size() > 1000) line_.clear();
  }

  void obey(const std::string& line) {
    std::istringstream words(line);
    std::string word, on;
    double number = 0.0;
    words >> word;
    if (word == "pause") {
      player_.pause(true);
    } else if (word == "play") {
      player_.pause(false);
    } else if (word == "seek" && words >> number) {
      player_.seek(number);
    } else if (word == "speed" && words >> number && number >= 0.01 && number <= 100.0) {
      player_.set_speed(number);
    } else if (word == "loop" && words >> on && (on == "on" || on == "off")) {
      player_.set_loop(on == "on");
    } else if (word == "quit") {
      ::kill(::getpid(), SIGTERM);
    } else if (word != "where" && !word.empty()) {
      std::printf(
          "replay: '%s' is not one of: pause, play, seek S, speed X, loop on, loop off, where, "
          "quit\n",
          line.c_str());
    }
    std::printf("replay: %.3f of %.3f s, speed %g%s\n", player_.position(), player_.duration(),
                player_.speed(),
                player_.paused()   ? ", paused"
                : player_.at_end() ? ", at the end"
                                   : "");
  }

  const Model& model_;
  std::string prefix_, line_;
  bool quiet_, input_ended_ = false;
  int sent_ = 0;
  LogPlayer player_;
  Bus bus_;
  RobotState state_;
};

int run(int argc, char** argv) {
  Arguments a;
  a.source = source_main_options("replay", SourceKind::kReplay, ProcessKind::kReplay);
  Options options("twinbus_replay",
                  "Plays a log as a source of STATE; the rest of it appears under REPLAY_.\n"
                  "Standard input: pause, play, seek S, speed X, loop on, loop off, where, quit.");
  options.positional("FILE", a.file, true, "the log");
  options.number("--speed", "X", a.speed, 0.01, 100.0, "times as fast as it was");
  options.number("--from", "S", a.from, 0.0, 1e9, "begins so many seconds behind the first event");
  options.flag("--loop", a.loop, "begins again at the end");
  options.flag("--paused", a.paused, "waits for play");
  options.flag("--only-state", a.quiet, "without the REPLAY_ channels");
  options.text("--recorded-prefix", "P", a.recorded_prefix, "of the channels in the log");
  add_common(options, a.source.common);
  add_source_options(options, a.source, false);
  options.parse(argc, argv);

  const Model model = load_robot(a.source.common.robot);
  RecordedRobot robot(a, model);
  std::printf("replay: %s, %.3f s, speed %g\n", a.file.c_str(), robot.player().duration(),
              robot.player().speed());
  return run_source_main(a.source, model, robot);
}

}  // namespace
}  // namespace twinbus::viewer_log

int main(int argc, char** argv) { return twinbus::run_process("replay", twinbus::run, argc, argv); }
