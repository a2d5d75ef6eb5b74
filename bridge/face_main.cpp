// The face process: answers as a Unitree robot on DDS and drives whatever source is active, as a controller.
//
// What it does is bridge/unitree/face.h; this file joins that to DDS, the bus and the clock.

#include <poll.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bridge/adaptors/unitree_dds/unitree_dds.h"
#include "bridge/unitree/face.h"
#include "common/process/options.h"
#include "common/process/priority.h"
#include "common/process/process.h"
#include "lcmtypes/bus/node.h"
#include "lcmtypes/msg/state_admission.h"
#include "robot/description/load.h"

namespace twinbus::inline bridge {
namespace {

constexpr int kPriority = 55;       // FIFO, as a controller's
constexpr int kWait_ms = 20;        // for a message, then the heartbeat gets its turn
constexpr int kFramesPerLook = 256;  // a flood of them must not keep STATE waiting

struct Arguments {
  CommonOptions common;
  std::string robot_kind;
  DdsOptions dds;
  FaceOptions face;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  std::int64_t mode_machine = -1, domain = 0;
  double volts = 0.0, celsius = 0.0;
  bool no_fade = false;
  Options options("twinbus_face",
                  "Answers on DDS as a Unitree robot: STATE becomes rt/lowstate, rt/lowcmd becomes COMMAND, and programs written for\n"
                  "the robot drive whatever source is active.  Until one commands, the posture that is found is held.\n"
                  "unitree_hg: G1; unitree_go: Go2 (a Go1 model takes its programs too).  The robot's joints must be named as there.");
  options.positional("unitree_hg|unitree_go", a.robot_kind, true, "whose messages are spoken");
  add_common(options, a.common);
  options.text("--interface", "NAME", a.dds.interface, "network interface of DDS; anybody who reaches it can command the robot");
  options.integer("--domain", "N", domain, 0, 230, "of DDS; the SDK's is 0");
  options.integer("--mode-machine", "N", mode_machine, -1, 255, "that the robot reports and asks for; -1: that of its table");
  options.flag("--ab-as-series", a.face.ab_as_series,
               "obeys mode_pr 1 as simulators do: motors A and B move roll and pitch; without it such commands are refused, since the "
               "model has no linkage");
  options.flag("--no-fade", no_fade, "a program's first command is obeyed at once, for policies that cannot wait 0.3 s");
  options.number("--rate", "HZ", a.face.rate, 10.0, 500.0,
                 "rt/lowstate per second; fewer than the robot's 500 for programs in Python that cannot read so many on this machine");
  options.number("--patience", "S", a.face.patience, 0.0, 1.0, "how long a LowCmd goes on when the next is late; the command timeout at least");
  options.number("--volts", "V", volts, 0.0, 1000.0, "voltage that is reported, since no source measures one; 0: not known");
  options.number("--celsius", "T", celsius, -100.0, 200.0, "temperature of motors that is reported; 0: not known");
  options.parse(argc, argv);
  if (a.robot_kind != "unitree_hg" && a.robot_kind != "unitree_go") {
    std::fprintf(stderr, "twinbus_face: no robot '%s'; write unitree_hg or unitree_go\n", a.robot_kind.c_str());
    std::exit(2);
  }
  a.dds.domain = static_cast<int>(domain);
  a.face.family = a.robot_kind == "unitree_hg" ? UnitreeFamily::kHg : UnitreeFamily::kGo;
  a.face.mode_machine = static_cast<int>(mode_machine);
  a.face.fade = !no_fade;
  a.face.volts = static_cast<float>(volts);
  a.face.celsius = static_cast<float>(celsius);
  a.face.first_id = random_id() & ((std::int64_t{1} << 52) - 1);  // room to count up below 2^53
  return a;
}

class FaceProcess {
 public:
  FaceProcess(const Arguments& a, const Model& model, RealTime real_time)
      : family_(a.face.family),
        face_(model, a.face),
        node_(a.common, ProcessKind::kUser, real_time),
        dds_(a.face.family, UnitreeDds::Side::kRobot, a.dds) {
    Bus& bus = node_.bus();
    bus.listen<&FaceProcess::hear_state>(channel::kState, *this);
    bus.listen<&FaceProcess::hear_command>(channel::kCommand, *this);
    bus.listen<&Face::on_source>(channel::kSourceStatus, face_);
    bus.listen<&FaceProcess::hear_gamepad>(channel::kGamepad, *this);
  }

  const Face& face() const { return face_; }

  void run() {
    while (!quit_requested()) {
      std::array<pollfd, 2> waits = {pollfd{node_.bus().fileno(), POLLIN, 0}, pollfd{dds_.fileno(), POLLIN, 0}};
      if (!more_) ::poll(waits.data(), waits.size(), kWait_ms);
      node_.receive(0.0);
      hear_dds();
      answer();
      tell();
      if (pulse_.due(monotonic_ns())) send_heartbeat();
    }
  }

 private:
  void hear_state(const RobotState& state) noexcept {
    const std::int64_t now = monotonic_ns();
    if (!admission_.admit(state, now)) return;
    heard_ns_ = now;
    face_.on_state(state, now);
    if (face_.reading_due()) {
      encode(face_.reading(now), family_, frame_);
      if (!dds_.write(std::span(frame_).first(state_bytes(family_)))) ++frames_lost_;
    }
    answer();
  }

  void hear_command(const JointCommand& command) noexcept { face_.on_command(command.controller_id, monotonic_ns()); }
  void hear_gamepad(const Gamepad& pad) noexcept { face_.on_gamepad(pad, monotonic_ns()); }

  void hear_dds() noexcept {
    dds_.quiet();
    dds_.serve();
    DdsSample sample;
    int frames = 0;
    while (frames < kFramesPerLook && dds_.take(sample)) {
      ++frames;
      face_.on_frame(sample.bytes, sample.writer, sample.stamp_ns, 1000 * wall_us(), monotonic_ns());
    }
    more_ = frames == kFramesPerLook;
  }

  void answer() noexcept {
    const std::int64_t now = monotonic_ns();
    ControllerRequest request;
    if (face_.take_request(request, now)) {
      request.utime = wall_us();
      request.sender_id = node_.id();
      request.sequence = ++request_sequence_;
      node_.send(channel::kControllerRequest, request);
    }
    JointCommand command;
    if (!face_.take_command(command, now)) return;
    node_.send(channel::kCommand, command);
    const std::int64_t end = monotonic_ns();
    pulse_.tick(end, end - now);
    pulse_.answered(end - heard_ns_);
  }

  void tell() noexcept {
    FaceLine line;
    while (face_.take_line(line)) {
      std::fprintf(line.severity > 0 ? stderr : stdout, "face: %s\n", line.text.data());
      Event event;
      event.run_id = admission_.run_id();
      event.severity = static_cast<std::int8_t>(line.severity);
      std::snprintf(event.text.data(), event.text.size(), "face: %s", line.text.data());
      node_.tell(event);
    }
  }

  void send_heartbeat() noexcept {
    Heartbeat& beat = node_.beat();
    beat.messages_received += face_.frames_taken();
    beat.messages_rejected += admission_.ignored() + face_.frames_refused();
    beat.send_failures = static_cast<std::int32_t>(std::min<std::int64_t>(beat.send_failures + frames_lost_, INT32_MAX));
    node_.send_heartbeat(beat);
  }

  UnitreeFamily family_;
  Face face_;
  Node node_;
  UnitreeDds dds_;
  StateAdmission admission_;
  Pulse& pulse_ = node_.pulse();
  std::array<std::byte, kLargestFrame> frame_{};
  bool more_ = false;  // frames that were not taken in one look
  std::int64_t heard_ns_ = 0, frames_lost_ = 0;  // frames that DDS did not take
  std::int32_t request_sequence_ = 0;
};

std::string absent_motors(const MotorOrder& order) {
  if (order.absent.empty()) return "";
  std::string text = "; no joint for motors";
  for (const int motor : order.absent) text += " " + std::to_string(motor);
  return text;
}

int run(int argc, char** argv) {
  const Arguments a = parse(argc, argv);
  catch_quit_signals();
  const Model model = load_robot(a.common.robot);
  FaceProcess process(a, model, enter_real_time(kPriority, "face"));
  const MotorOrder& order = process.face().order();
  std::printf("face ready: %s answers as %s (%s) on %s, domain %d: rt/lowstate %.0f times a second, rt/lowcmd%s\n", model.name.c_str(),
              a.robot_kind.c_str(), order.robot.c_str(), a.dds.interface.c_str(), a.dds.domain, process.face().rate(),
              absent_motors(order).c_str());
  process.run();
  return 0;
}

}  // namespace
}  // namespace twinbus::bridge

int main(int argc, char** argv) { return twinbus::run_process("face", twinbus::run, argc, argv); }
