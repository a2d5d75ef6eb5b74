// The gamepad process: a pad or a keyboard in, GAMEPAD, MODE_REQUEST, ARM_GOAL and STOP out.  What
// the controls mean is in control/teleop; this file joins it to SDL, the terminal and the bus.

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>

#include "common/process/command_word.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "common/text/formatted.h"
#include "control/gamepad_arm_main.h"
#include "control/gamepad_requests_main.h"
#include "control/teleop/raw_terminal.h"
#include "control/teleop/sdl_pad.h"
#include "control/teleop/teleop.h"
#include "lcmtypes/bus/node.h"
#include "lcmtypes/msg/state_admission.h"
#include "robot/description/load.h"

using namespace twinbus;

namespace {

constexpr double kPatience = 10.0;            // with a control that a pad does not have [s]
constexpr double kFirstPad = 1.0;             // SDL shows what is plugged in within [s]
constexpr double kRumble = 0.5;               // when the robot has been stopped [s]
constexpr std::int64_t kPeriod = 10'000'000;  // 100 Hz [ns]
constexpr int kLastZeros = 10;                // on leaving
constexpr double kStateFresh = 0.5;           // [s]
constexpr int kHeartbeatEvery = 10;           // cycles

volatile std::sig_atomic_t g_hung_up = 0;  // the terminal is gone

struct Arguments {
  CommonOptions common;
  bool keyboard = false;
  bool from_script = false;
  bool map = false;
  bool wait = false;
  std::string mappings = config_folder() + "/gamepads/own.txt";
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  Options options("twinbus_gamepad", "Drives the robot with a gamepad or the keyboard.\n\n" +
                                         cheat_sheet(false) + "\n" + cheat_sheet(true));
  add_common(options, a.common);
  options.flag("--keyboard", a.keyboard, "keys of this terminal instead of a pad");
  options.flag("--map", a.map,
               "teaches a pad that is not known: asks for one control after another");
  options.text("--mappings", "FILE", a.mappings,
               "where --map keeps what it learns, and whence it is known");
  options.flag("--wait", a.wait, "for a pad that is plugged in later, also where no terminal shows that it waits");
  options.flag("--virtual", a.from_script,
               "a pad that exists in SDL only, driven by lines on standard input: plug, unplug, "
               "axis 0..5 -32768..32767, press BIT, release BIT");
  options.parse(argc, argv);
  if (a.keyboard && a.from_script) {
    std::fprintf(stderr, "twinbus_gamepad: --keyboard and --virtual exclude each other\n");
    std::exit(2);
  }
  return a;
}

// With nobody at a terminal who could plug one in, waiting for a pad looks like work.  Throws std::runtime_error then.
void refuse_to_wait_unseen(const Arguments& arguments, const std::function<bool()>& pad_is_there) {
  if (arguments.wait || arguments.from_script || isatty(STDIN_FILENO) == 1) return;
  for (const std::int64_t begin = monotonic_ns(); seconds_since(begin) < kFirstPad && !quit_requested();) {
    if (pad_is_there()) return;
    sleep_until_ns(monotonic_ns() + kPeriod);
  }
  throw std::runtime_error("no pad is plugged in, and no terminal is there to wait at: plug one in first, or say --wait, or --keyboard in a terminal");
}

// The lines of --virtual.  Keys arrive through RawTerminal, a line at a time.
class PadScript {
 public:
  void read(RawTerminal& input, VirtualPad& pad) {
    for (int key : input.read_keys()) {
      if (key == 0) break;
      if (key != '\n') {
        if (line_.size() < 100) line_.push_back(static_cast<char>(key));
        continue;
      }
      obey(pad);
      line_.clear();
    }
  }

 private:
  void obey(VirtualPad& pad) const {
    int a = 0, b = 0;
    if (line_ == "plug") {
      if (!pad.plug()) std::fprintf(stderr, "twinbus_gamepad: SDL gives no virtual pad\n");
    } else if (line_ == "unplug") {
      pad.unplug();
    } else if (std::sscanf(line_.c_str(), "axis %d %d", &a, &b) == 2 && a >= 0 && a < 6) {
      pad.set_axis(a, static_cast<std::int16_t>(b));
    } else if (std::sscanf(line_.c_str(), "press %d", &a) == 1) {
      pad.set_button(a, true);
    } else if (std::sscanf(line_.c_str(), "release %d", &a) == 1) {
      pad.set_button(a, false);
    } else {
      std::fprintf(stderr, "twinbus_gamepad: unknown line \"%s\"; see --help\n", line_.c_str());
    }
  }

  std::string line_;
};

// One line that is written over, on a terminal only.
void show(const Teleop& teleop, const Gamepad& pad, const RobotState& state, bool fresh, bool walks,
          const std::string& hand) {
  const char* source = !fresh                                   ? "no source"
                       : state.source == SourceKind::kSimulator ? "SIMULATOR"
                       : state.source == SourceKind::kBridge    ? "ROBOT"
                                                                : "REPLAY";
  const char* grip = teleop.stop_latched() ? "STOP ASKED"
                     : !pad.connected      ? "no pad   "
                     : pad.deadman         ? "HOLDING  "
                                           : "let go   ";
  std::printf(
      "\r%-9s term %-4d %s%s  %s forward %+.2f left %+.2f  height %+.2f  turn %+.2f  %s \x1b[K",
      source, fresh ? state.term : 0, grip,
      fresh && state.stop_kind != StopKind::kNone ? "  (robot stopped)" : "",
      walks ? "walk" : "lean", static_cast<double>(pad.left_y), static_cast<double>(pad.left_x),
      static_cast<double>(pad.right_y), static_cast<double>(pad.right_x), hand.c_str());
  std::fflush(stdout);
}

void send_heartbeat(Node& node, std::int64_t cycles, bool ready) {
  Heartbeat& beat = node.beat();
  beat.ticks = cycles;
  beat.rate = 100.0f;
  beat.state = ready ? 2 : 1;
  node.send_heartbeat(beat);
}

// Asks for one control after another and keeps what it learned.
int map_a_pad(const Arguments& arguments) {
  SdlPad sdl;
  RawSdlPad pad;
  VirtualPad virtual_pad;
  PadScript script;
  std::unique_ptr<RawTerminal> terminal;
  if (arguments.from_script) terminal = std::make_unique<RawTerminal>();
  const auto pass_time = [&] {
    if (terminal) script.read(*terminal, virtual_pad);
    sleep_until_ns(monotonic_ns() + kPeriod);
  };
  std::printf("plug in the pad ...\n");
  std::fflush(stdout);
  refuse_to_wait_unseen(arguments, [&] { return pad.open(); });
  while (!quit_requested() && !pad.open()) pass_time();
  if (quit_requested()) return 1;
  std::printf("%s: hands off, then follow; what it does not have is left out after ten seconds\n",
              pad.name().c_str());
  sleep_until_ns(monotonic_ns() + 50 * kPeriod);
  PadMapper mapper;
  mapper.rest(pad.poll());
  std::string asked;
  std::int64_t asked_ns = 0;
  while (!quit_requested() && !mapper.question().empty()) {
    if (mapper.question() != asked) {
      asked = mapper.question();
      asked_ns = monotonic_ns();
      std::printf("  %s\n", asked.c_str());
      std::fflush(stdout);
    }
    (void)mapper.look(pad.poll());
    if (seconds_since(asked_ns) > kPatience) mapper.skip();
    pass_time();
  }
  if (quit_requested()) return 1;
  const std::filesystem::path folder = std::filesystem::path(arguments.mappings).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  std::ofstream file(arguments.mappings, std::ios::app);
  file << mapper.line(pad.guid(), pad.name()) << '\n';
  file.close();
  if (!file) throw std::runtime_error("cannot write " + arguments.mappings);
  print_typed(stdout, "kept in %s; ./twinbus gamepad knows this pad now\n", arguments.mappings.c_str());
  return 0;
}

void run(const Arguments& options) {
  go_ahead_of_ordinary_programs();  // letting go must not wait for somebody's compiler
  const Model model = load_robot(options.common.robot);
  Node node(options.common, ProcessKind::kGamepad);
  const std::int64_t id = node.id();
  Bus& bus = node.bus();
  GamepadArm arm(model, id);
  arm.listen(bus);
  StateAdmission believed;
  Latest<RobotState> newest;
  const auto admit = [&believed](const RobotState& state, const RobotState&) noexcept {
    return believed.admit(state, monotonic_ns());
  };
  newest.admit_by(admit);
  bus.listen(channel::kState, newest);

  std::unique_ptr<SdlPad> pad;
  if (!options.keyboard) {
    pad = std::make_unique<SdlPad>();
    const int known = pad->take_mappings(options.mappings);
    if (known <= 0 && options.mappings != Arguments().mappings) {
      throw std::runtime_error(
          "--mappings " + options.mappings +
          (known < 0 ? ": cannot be read" : ": has no mapping of a pad in it") +
          "; --map writes such a file");
    }
    refuse_to_wait_unseen(options, [&] {
      PadInput now;
      pad->poll(now);
      return now.connected;
    });
  }
  std::unique_ptr<RawTerminal> terminal;
  if (options.keyboard || options.from_script) terminal = std::make_unique<RawTerminal>();
  VirtualPad virtual_pad;
  PadScript script;
  Teleop teleop(id, options.keyboard);
  teleop.set_hands(arm.sides());
  Requests requests(id);
  PadInput input;

  std::printf("%s", cheat_sheet(options.keyboard).c_str());
  std::printf("twinbus_gamepad: ready%s\n",
              options.keyboard ? "" : "; pads may be plugged in at any time");
  std::fflush(stdout);
  const bool show_line = isatty(1) == 1;

  bool leaving = false, was_stopped = false;
  int zeros_left = kLastZeros, rumbles = 0;
  std::int64_t due = monotonic_ns();
  for (std::int64_t cycle = 0; zeros_left > 0; ++cycle) {
    due += kPeriod;
    for (double wait; (wait = 1e-9 * static_cast<double>(due - monotonic_ns())) > 0.0;) {
      if (bus.receive(wait) < 0) sleep_until_ns(due);  // the network is gone: keep the pace
    }
    const std::int64_t now = monotonic_ns();
    if (now - due > 10 * kPeriod) due = now;  // was suspended: no burst to catch up
    const RobotState& state = newest.message;
    const bool fresh = newest.age(now) < kStateFresh;
    if (fresh) {
      teleop.on_source(state.run_id, state.stop_kind != StopKind::kNone);
    } else {
      teleop.on_no_source();
    }

    const bool stopped = fresh && state.stop_kind != StopKind::kNone;
    if (pad && stopped && !was_stopped) pad->rumble(kRumble);
    was_stopped = stopped;
    if (quit_requested() || g_hung_up != 0) leaving = true;
    if (!leaving && options.keyboard) {
      for (int key : terminal->read_keys()) {
        if (key == 0) break;
        teleop.on_key(key, now);
      }
    }
    if (!leaving && options.from_script) script.read(*terminal, virtual_pad);
    if (const int shaken = virtual_pad.rumbles(); shaken > rumbles) {
      rumbles = shaken;
      std::printf("rumble\n");
      std::fflush(stdout);
    }
    if (terminal && terminal->at_end()) leaving = true;
    if (pad && !leaving) {
      pad->poll(input);
      teleop.on_pad(input);
    }
    for (TeleopAction action; (action = teleop.take_action()) != TeleopAction::kNone;) {
      if (action == TeleopAction::kQuit) leaving = true;
      arm.on_action(action);
      requests.start(action, state);
    }
    if (leaving) {
      teleop.let_go();
      --zeros_left;
    }
    const std::int64_t utime = wall_us();
    const Gamepad message = teleop.message(utime, now);
    node.send(channel::kGamepad, message);
    requests.send(bus);
    arm.update(state, fresh, teleop);
    arm.send(bus, state, utime, monotonic_ns());
    arm.ask_for_pose(monotonic_ns(), state, requests);
    if (const std::string why = arm.take_sentence(); !why.empty()) {
      print_typed(stdout, "%s%s\n", show_line ? "\r\x1b[K" : "", why.c_str());
      std::fflush(stdout);
    }
    if (cycle % kHeartbeatEvery == 0) {
      send_heartbeat(node, cycle, message.connected);
      if (show_line) show(teleop, message, state, fresh, arm.walks(), arm.words(state));
    }
  }
  if (show_line) std::printf("\n");
  std::printf("twinbus_gamepad: let go\n");
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = parse(argc, argv);
  catch_quit_signals();
  struct sigaction hang_up {};
  hang_up.sa_handler = [](int) { g_hung_up = 1; };
  sigaction(SIGHUP, &hang_up, nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // a closed terminal must not end us before the zeros are out
  if (arguments.map) return map_a_pad(arguments);
  run(arguments);
  return 0;
} catch (const std::exception& error) {
  print_typed(stderr, "twinbus_gamepad: %s\n", error.what());
  return 1;
}
