// A stack that is not there: publishes what the viewer and the gamepad listen to, and prints the
// requests it hears.
//
// For tests and for looking at the page without a simulator.  The robot sways by a formula; nothing
// is simulated.
//
//   fake_robot [--robot NAME] [--source 1|2|3] [--url U] [--for SECONDS]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <utility>

#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "robot/description/load.h"
#include "common/process/process.h"
#include "test/tools/bus_options.h"

using namespace twinbus;

namespace {

constexpr std::int64_t kRun = 1001, kOtherRun = 1002, kController = 2001;
constexpr double kTurn = 6.283185307179586;

template <std::size_t N>
void set_text(std::array<char, N>& target, const std::string& text) {
  std::snprintf(target.data(), N, "%s", text.c_str());
}

// A PNG of 8 x 6 pixels.
constexpr std::array<std::uint8_t, 82> kPicture{
    137, 80,  78, 71,  13,  10,  26, 10,  0,   0,  0,   13,  73,  72,  68,  82,  0,
    0,   0,   8,  0,   0,   0,   6,  8,   0,   0,  0,   0,   219, 110, 128, 39,  0,
    0,   0,   25, 73,  68,  65,  84, 120, 218, 99, 208, 208, 248, 255, 31,  132, 25,
    224, 12,  8,  165, 161, 129, 96, 96,  168, 1,  0,   228, 84,  27,  169, 243, 44,
    179, 135, 0,  0,   0,   0,   73, 69,  78,  68, 174, 66,  96,  130};

class FakeStack {
 public:
  FakeStack(const Model& model, SourceKind source, const BusOptions& bus)
      : model_(model), bus_(bus) {
    state_.run_id = kRun;
    state_.model_hash = model.hash;
    state_.period_ns = model.period_ns;
    state_.term = 1;
    state_.joint_count = static_cast<std::int16_t>(model.bus_count());
    state_.source = source;
    state_.role = Role::kActive;
    state_.sensor_flags =
        kEncodersValid | kImuValid | wrench_valid(kLeftFoot) | wrench_valid(kRightFoot);
    state_.wrench_kind = {WrenchKind::kMeasured, WrenchKind::kMeasured, WrenchKind::kAbsent,
                          WrenchKind::kAbsent};
    state_.stop_nonce = 77;
    pose_ = model.find_pose("half_sitting");
    bus_.listen<&FakeStack::hear_stop>(channel::kStop, *this);
    bus_.listen<&FakeStack::hear_mode>(channel::kModeRequest, *this);
    bus_.listen<&FakeStack::hear_source>(channel::kSourceRequest, *this);
    bus_.listen<&FakeStack::hear_gamepad>(channel::kGamepad, *this);
    bus_.listen<&FakeStack::hear_walk>(channel::kWalk, *this);
    bus_.listen<&FakeStack::hear_goal>(channel::kArmGoal, *this);
  }

  void tick() {
    ++state_.tick;
    state_.time_ns += state_.period_ns;
    state_.source_time_ns = state_.time_ns;
    posture(1e-9 * static_cast<double>(state_.time_ns));
    bool sent = bus_.send(channel::kState, state_);
    JointCommand command{.tick = state_.tick, .run_id = kRun, .controller_id = kController, .joint_count = state_.joint_count};
    command.q = state_.q;
    command.q[0] += 0.02;  // a tracking error that can be seen
    sent = bus_.send(channel::kCommand, command) && sent;
    RobotState standby = state_;
    standby.run_id = kOtherRun;
    standby.source =
        state_.source == SourceKind::kBridge ? SourceKind::kSimulator : SourceKind::kBridge;
    standby.role = Role::kStandbyShadow;
    standby.q[1] += 0.03;
    sent = bus_.send(
               standby.source == SourceKind::kBridge ? channel::kStateBridge : channel::kStateSim,
               standby) &&
           sent;
    sent = bus_.send(channel::kControllerStatus, controller()) && sent;
    sent = bus_.send(channel::kGuard, guard()) && sent;
    if (state_.tick % 50 == 0) slow();
    if (state_.tick % 10 == 0) moving(1e-9 * static_cast<double>(state_.time_ns));
    if (!sent && state_.tick == 1)
      std::fprintf(stderr, "fake_robot: a message could not be sent\n");
    bus_.receive(0.0);
  }

 private:
  // Sways by ankles and hips: the feet stay flat, the weight moves over.
  void posture(double time) {
    const double lean =
        state_.stop_kind == StopKind::kNone ? 0.045 * std::sin(kTurn * 0.25 * time) : 0.0;
    for (int k = 0; k < model_.bus_count(); ++k) {
      const int joint = model_.bus_joints[static_cast<std::size_t>(k)];
      const std::string& name = model_.joints[static_cast<std::size_t>(joint)].name;
      double q =
          pose_ < 0
              ? 0.0
              : model_.poses[static_cast<std::size_t>(pose_)].q[static_cast<std::size_t>(joint)];
      if (name.find("HIP_R") != std::string::npos) q += lean;
      if (name.find("ANKLE_R") != std::string::npos) q -= lean;
      if (name.find("SHOULDER_P") != std::string::npos) q += 4.0 * lean;
      state_.q[static_cast<std::size_t>(k)] = q;
    }
    const double weight = 9.81 * model_.total_mass();
    const double left = 0.5 + 3.0 * lean;
    state_.wrench[kLeftFoot][2] = static_cast<float>(weight * left);
    state_.wrench[kRightFoot][2] = static_cast<float>(weight * (1.0 - left));
  }

  ControllerStatus controller() const {
    ControllerStatus status;
    status.tick = state_.tick;
    status.run_id = kRun;
    status.controller_id = kController;
    status.mode = mode_.mode;
    status.motion = mode_.motion;
    status.zmp_margin = 0.05f;
    status.compute_ns = 41'000;
    return status;
  }

  GuardReport guard() const {
    GuardReport report;
    report.tick = state_.tick;
    report.run_id = kRun;
    report.guard_id = 3001;
    report.pairs_checked = 371;
    report.pairs_near = 2;
    report.verdict = GuardVerdict::kNear;
    report.link_a = {1, 7, 0, 0, 0, 0};
    report.link_b = {14, 0, 0, 0, 0, 0};
    report.distance = {0.062f, 0.041f, 0, 0, 0, 0};
    report.point_a[0] = {0.0f, -0.05f, -0.3f};
    report.point_b[0] = {0.0f, 0.05f, -0.3f};
    report.point_a[1] = {0.0f, -0.22f, 0.1f};
    report.point_b[1] = {0.0f, -0.15f, 0.1f};
    return report;
  }

  void slow() {
    SourceStatus status;
    status.utime = wall_us();
    status.run_id = kRun;
    status.model_hash = model_.hash;
    status.tick = state_.tick;
    status.term = state_.term;
    status.period_ns = state_.period_ns;
    status.source = state_.source;
    status.role = state_.role;
    status.stop_kind = state_.stop_kind;
    status.stop_reason =
        state_.stop_kind == StopKind::kNone ? StopReason::kNone : StopReason::kViewer;
    status.pace = 1;
    bool sent = bus_.send(channel::kSourceStatus, status);
    status.run_id = kOtherRun;
    status.source =
        state_.source == SourceKind::kBridge ? SourceKind::kSimulator : SourceKind::kBridge;
    status.role = other_role_;
    status.stop_kind = StopKind::kNone;
    sent = bus_.send(channel::kSourceStatus, status) && sent;
    static constexpr ProcessKind kKinds[] = {ProcessKind::kSimulator, ProcessKind::kBridge,
                                             ProcessKind::kController, ProcessKind::kGuard,
                                             ProcessKind::kPlanner};
    for (ProcessKind kind : kKinds) {
      Heartbeat beat;
      beat.utime = wall_us();
      beat.process_id = 4000 + static_cast<int>(kind);
      beat.pid = 100 + static_cast<int>(kind);
      beat.kind = kind;
      beat.state = kind == ProcessKind::kPlanner ? 1 : 2;
      beat.rate = kind == ProcessKind::kPlanner ? 0.0f : 500.0f;
      beat.ticks = state_.tick;
      beat.tick_median_us = 35;
      beat.tick_p99_us = 90;
      sent = bus_.send(channel::kHeartbeat, beat) && sent;
    }
    ObstaclesPiece piece;
    piece.scene_id = 5;
    piece.pieces = 1;
    piece.count = 1;
    piece.shape[0] = ObstacleShape::kBox;
    piece.size[0] = {0.2f, 0.5f, 0.8f};
    piece.position[0] = {0.35f, -0.75f, 0.4f};
    piece.attitude[0] = {1, 0, 0, 0};
    for (std::size_t i = 1; i < piece.attitude.size(); ++i) piece.attitude[i] = {1, 0, 0, 0};
    sent = bus_.send(channel::kObstacles, piece) && sent;
    piece.scene_id = kRun;
    piece.count = 2;
    piece.size[0] = piece.size[1] = {0.3f, 0.3f, 0.04f};
    piece.shape[1] = ObstacleShape::kBox;
    piece.position[0] = {0.6f, 0.3f, 0.0f};
    piece.position[1] = {0.9f, 0.3f, 0.0f};
    sent = bus_.send(channel::kTerrain, piece) && sent;
    ModelTextPiece picture;
    picture.utime = wall_us();
    picture.run_id = kRun;
    picture.kind = 8;
    picture.size = picture.count = static_cast<std::int16_t>(kPicture.size());
    picture.pieces = 1;
    std::copy(kPicture.begin(), kPicture.end(), picture.text.begin());
    sent = bus_.send(channel::kCamera, picture) && sent;
    // Twice: a viewer that starts beside this may not listen yet.
    if (state_.tick == 50 || state_.tick == 1000) say("The scene has started.", 0);
    if (!sent && state_.tick == 50)
      std::fprintf(stderr, "fake_robot: a slow message could not be sent\n");
  }

  // A ball that circles, a box, and steps to come while it is asked to walk.
  void moving(double time) {
    ObstaclesPiece piece;
    piece.utime = wall_us();
    piece.scene_id = kRun;
    piece.pieces = 1;
    piece.count = 2;
    for (auto& attitude : piece.attitude) attitude = {1, 0, 0, 0};
    piece.shape[0] = ObstacleShape::kSphere;
    piece.size[0] = {0.12f, 0, 0};
    piece.position[0] = {static_cast<float>(0.8 + 0.3 * std::cos(time)),
                         static_cast<float>(0.3 * std::sin(time)), 0.12f};
    piece.shape[1] = ObstacleShape::kCylinder;
    piece.size[1] = {0.08f, 0.3f, 0};
    piece.position[1] = {-0.4f, 0.6f, 0.15f};
    bool sent = bus_.send(channel::kLoose, piece);
    if (mode_.mode == Mode::kWalk) {
      piece.shape[0] = ObstacleShape::kBox;
      piece.size[0] = {0.24f, 0.14f, 0.004f};
      piece.position[0] = {0.3f, 0.1f, 0.0f};
      piece.shape[1] = ObstacleShape::kSphere;
      piece.size[1] = {0.008f, 0, 0};
      piece.position[1] = {0.2f, 0.1f, 0.05f};
      sent = bus_.send(channel::kFootsteps, piece) && sent;
    }
    if (!sent && state_.tick == 50)
      std::fprintf(stderr, "fake_robot: nothing that moves was sent\n");
  }

  void say(const std::string& text, int severity) {
    Event event;
    event.utime = wall_us();
    event.sender_id = kRun;
    event.run_id = kRun;
    event.tick = state_.tick;
    event.sequence = ++event_sequence_;
    event.severity = static_cast<std::int8_t>(severity);
    event.kind = ProcessKind::kSimulator;
    set_text(event.text, text);
    if (!bus_.send(channel::kEvent, event)) std::fprintf(stderr, "fake_robot: no event\n");
  }

  void print(const char* what, long value, std::int64_t run) {
    std::printf("%s %ld run %ld\n", what, value, static_cast<long>(run));
    std::fflush(stdout);
  }

  template <class T>
  bool repeated(const T& request, std::int64_t& last) {
    const std::int64_t key = request.sender_id * 1000 + request.sequence;
    return std::exchange(last, key) == key;
  }

  void hear_stop(const StopRequest& stop) {
    if (repeated(stop, last_stop_)) return;
    print(stop.kind == StopKind::kNone ? "clear" : "stop",
          stop.kind == StopKind::kNone ? stop.stop_nonce : static_cast<long>(stop.kind), 0);
    const bool clears = stop.kind == StopKind::kNone && stop.stop_nonce == state_.stop_nonce;
    if (stop.kind != StopKind::kNone) {
      state_.stop_kind = stop.kind;
      state_.role = Role::kStopped;
      say("Stopped by request.", 2);
    } else if (clears) {
      state_.stop_kind = StopKind::kNone;
      state_.role = Role::kActive;
      ++state_.stop_nonce;
      say("The stop is cleared.", 0);
    }
  }
  void hear_mode(const ModeRequest& mode) {
    if (repeated(mode, last_mode_)) return;
    mode_ = mode;
    print("mode", 10 * static_cast<long>(mode.mode) + static_cast<long>(mode.motion),
          mode.run_id);
  }
  void hear_source(const SourceRequest& request) {
    if (repeated(request, last_source_)) return;
    print("source", static_cast<long>(request.action), request.target_run_id);
    if (request.action == SourceAction::kStandbyShadow) other_role_ = Role::kStandbyShadow;
  }
  // A line whenever the velocity changes.
  void hear_walk(const WalkCommand& walk) {
    char line[96];
    std::snprintf(line, sizeof line, "walk %.2f %.2f %.2f run %ld", static_cast<double>(walk.vx),
                  static_cast<double>(walk.vy), static_cast<double>(walk.wz), static_cast<long>(walk.run_id));
    if (last_walk_ == line) return;
    last_walk_ = line;
    std::printf("%s\n", line);
    std::fflush(stdout);
  }
  void hear_goal(const ArmGoal& goal) {
    if (repeated(goal, last_goal_)) return;
    std::printf("goal %d side %d at %.3f %.3f %.3f run %ld\n", static_cast<int>(goal.kind),
                static_cast<int>(goal.side), goal.position[0], goal.position[1], goal.position[2],
                static_cast<long>(goal.run_id));
    std::fflush(stdout);
    send_path(goal);
  }

  // The arm's first joints swing a little, so that there is a path to be drawn.
  void send_path(const ArmGoal& goal) {
    const Hand& hand = model_.hands[goal.side == ArmSide::kRight ? 1 : 0];
    if (hand.joints.empty()) return;
    ArmPathPiece piece;
    piece.run_id = kRun;
    piece.goal_id = goal.goal_id;
    piece.path_id = ++paths_;
    piece.pieces = 1;
    piece.joint_count = static_cast<std::int16_t>(hand.joints.size());
    piece.knot_count = kKnotsPerPiece;
    for (std::size_t i = 0; i < hand.joints.size(); ++i) {
      piece.joint[i] = static_cast<std::int16_t>(hand.joints[i]);
    }
    for (std::size_t row = 0; row < kKnotsPerPiece; ++row) {
      piece.time[row] = 0.4 * static_cast<double>(row);
      piece.q[row][0] = -0.25 * static_cast<double>(row);
    }
    if (!bus_.send(channel::kArmPath, piece)) std::fprintf(stderr, "fake_robot: no path\n");
  }
  // A line whenever what the pad says changes, with how many messages came since.
  void hear_gamepad(const Gamepad& pad) {
    char line[160];
    std::snprintf(
        line, sizeof line,
        "pad connected %d deadman %d stop %d lx %.2f ly %.2f rx %.2f ry %.2f buttons %d run %ld",
        pad.connected, pad.deadman, pad.stop, static_cast<double>(pad.left_x), static_cast<double>(pad.left_y),
        static_cast<double>(pad.right_x), static_cast<double>(pad.right_y), pad.buttons, static_cast<long>(pad.run_id));
    ++pads_;
    if (last_pad_ == line) return;
    last_pad_ = line;
    std::printf("%s after %d\n", line, std::exchange(pads_, 0));
    std::fflush(stdout);
  }

  const Model& model_;
  RobotState state_;
  ModeRequest mode_{.mode = Mode::kBalance, .motion = Motion::kSway};
  int pose_ = -1;
  std::int32_t event_sequence_ = 0;
  std::int64_t last_stop_ = 0, last_mode_ = 0, last_source_ = 0, last_goal_ = 0, paths_ = 0;
  Role other_role_ = Role::kParked;
  std::string last_walk_;
  std::string last_pad_;
  int pads_ = 0;
  Bus bus_;
};

}  // namespace

int main(int argc, char** argv) try {
  BusOptions bus;
  std::string robot = "hrp1s";
  int source = 1;
  double seconds = 1e9;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--robot" && i + 1 < argc) {
      robot = argv[++i];
    } else if (word == "--source" && i + 1 < argc) {
      source = std::atoi(argv[++i]);
    } else if (word == "--for" && i + 1 < argc) {
      seconds = std::atof(argv[++i]);
    } else if (!take_bus_option(argc, argv, i, bus)) {
      std::fprintf(stderr, "fake_robot: unknown option %s\n", argv[i]);
      return 2;
    }
  }
  catch_quit_signals();
  const Model model = load_robot(robot);
  FakeStack stack(model, SourceKind(source), bus);
  std::printf("fake_robot: ready\n");
  std::fflush(stdout);
  std::int64_t due = monotonic_ns();
  const double end = 1e-9 * static_cast<double>(due) + seconds;
  while (!quit_requested() && 1e-9 * static_cast<double>(monotonic_ns()) < end) {
    due += model.period_ns;
    sleep_until_ns(due);
    stack.tick();
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "fake_robot: %s\n", error.what());
  return 1;
}
