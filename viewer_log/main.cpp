// The viewer process: listens to the whole stack, shows it in a browser, passes on what the
// operator asks for.
//
// It runs at the lowest priority and never slows anybody: it only reads the newest of what it
// hears, 60 times a second.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "lcmtypes/bus/node.h"
#include "lcmtypes/bus/outgoing.h"
#include "robot/description/load.h"
#include "robot/description/named_hands.h"
#include "common/file/beside_program.h"
#include "common/process/oom_priority.h"
#include "common/process/options.h"
#include "common/process/priority.h"
#include "common/process/process.h"
#include "common/process/ticker.h"
#include "lcmtypes/msg/state_admission.h"
#include "viewer_log/view/frame.h"
#include "viewer_log/view/log_button.h"
#include "viewer_log/server/open_browser.h"
#include "viewer_log/server/page_document.h"
#include "viewer_log/server/page_inbox.h"
#include "viewer_log/view/scene_frame.h"
#include "viewer_log/view/setup_desk.h"
#include "viewer_log/view/signals.h"
#include "viewer_log/view/stack_view.h"
#include "viewer_log/view/switch_plan.h"
#include "viewer_log/server/robot_roots.h"
#include "viewer_log/server/web_server.h"

using namespace twinbus;

namespace {

constexpr std::int64_t kFramePeriod = 16'666'667;  // 60 Hz [ns]
constexpr std::int64_t kPrompt = 40'000'000;        // between two looks at the bus; later, the viewer is late itself [ns]
constexpr int kStatusEvery = 12;                   // frames: 5 Hz
constexpr int kHeartbeatEvery = 6;                 // frames: 10 Hz
constexpr std::size_t kLargestMessage =
    32 * 1024;                        // from who may act: a setup with many pairs [bytes]
constexpr float kWalkTimeout = 0.3F;  // a page that falls silent stops the walk [s]
constexpr float kPoseTime = 2.0F;     // at least, to get there [s]
constexpr float kPoseLongest = 60.0F;
constexpr double kPoseSpeed = 0.3;    // share of the joint velocity limits, in the mean
constexpr float kReachSpeed = 0.4F;   // share of the joint velocity limits

enum Slot : int { kLive, kStatus, kScene, kSignals, kPath, kCamera, kRecording };

struct Arguments {
  CommonOptions common;
  std::string web = beside_program("viewer_log/web/dist", TWINBUS_WEB_FOLDER);  // folder of the page
  std::string listen, run_folder;
  std::int64_t port = 8040;
  bool no_open = false;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  Options options(
      "twinbus_viewer",
      "Shows the running stack in a browser, with a stop button.\n"
      "TWINBUS_VIEWER_TOKEN and TWINBUS_VIEWER_WATCH_TOKEN in the environment keep the addresses "
      "the same over a restart; TWINBUS_VIEWER_AT=HOST:PORT is where a forwarded port (a "
      "container's) shows the page to others.");
  add_common(options, a.common);
  options.integer("--port", "N", a.port, 0, 65535,
                  "first port to try on 127.0.0.1, then the next free; 0: any");
  options.text("--listen", "ADDR", a.listen,
               "an address of this machine on which others may watch and stop, with the token that "
               "is printed; 0.0.0.0: all.  Not encrypted: for a network you trust");
  options.text("--run-folder", "FOLDER", a.run_folder,
               "of the ./twinbus up whose stack the page may set up anew");
  options.flag("--no-open", a.no_open, "does not open the browser");
  options.text("--web", "FOLDER", a.web, "folder of the page");
  options.parse(argc, argv);
  return a;
}

// Beside the run that `up` records; where it is started, without one.
std::string logs_folder(const Arguments& a) {
  if (a.run_folder.empty()) return "runs";
  return std::filesystem::absolute(a.run_folder).lexically_normal().parent_path().string();
}

std::vector<std::string> recorder_words(const Arguments& a) {
  std::vector<std::string> words;
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--url", a.common.url);
  add("--prefix", a.common.prefix);
  add("--allow", a.common.allow);
  add("--run-folder", a.run_folder);
  return words;
}

class Viewer {
 public:
  explicit Viewer(const Arguments& arguments)
      : arguments_(arguments),
        model_(load_robot(arguments.common.robot)),
        view_(model_),
        log_button_(logs_folder(arguments), recorder_words(arguments)),
        node_(arguments.common, ProcessKind::kViewer),
        server_(web_config()) {
    stop_.message.sender_id = node_.id();
    switch_.message.sender_id = node_.id();
    mode_.message.sender_id = node_.id();
    walk_.message.sender_id = node_.id();
    sim_.message.sender_id = node_.id();
    goal_.message.sender_id = node_.id();
    view_.say_stand_in(!arguments.run_folder.empty() && std::filesystem::exists(arguments.run_folder + "/setup/stand_in"));
    state_.admit_by(admit_);
    bus_.listen(channel::kState, state_);
    bus_.listen(channel::kCommand, command_);
    bus_.listen(channel::kTruth, truth_);
    bus_.listen(channel::kGuard, guard_);
    bus_.listen(channel::kControllerStatus, controller_);
    bus_.listen(channel::kStateSim, standby_[0]);
    bus_.listen(channel::kStateBridge, standby_[1]);
    bus_.listen(channel::kStateReplay, standby_[2]);
    bus_.listen<&StackView::on_source_status>(channel::kSourceStatus, view_);
    bus_.listen<&StackView::on_heartbeat>(channel::kHeartbeat, view_);
    bus_.listen<&StackView::on_event>(channel::kEvent, view_);
    bus_.listen<&StackView::on_obstacles>(channel::kObstacles, view_);
    bus_.listen<&StackView::on_held>(channel::kHeld, view_);
    bus_.listen<&StackView::on_terrain>(channel::kTerrain, view_);
    bus_.listen<&StackView::on_loose>(channel::kLoose, view_);
    bus_.listen<&StackView::on_footsteps>(channel::kFootsteps, view_);
    bus_.listen<&StackView::on_arm_path>(channel::kArmPath, view_);
    bus_.listen<&StackView::on_camera>(channel::kCamera, view_);
  }

  void run() {
    announce();
    Ticker ticker(kFramePeriod);
    for (std::int64_t frame = 0; !quit_requested(); ++frame) {
      ticker.wait();
      const int handled = bus_.receive(0.0);
      if (handled < 0 && frame % 60 == 0) {
        std::fprintf(stderr, "twinbus_viewer: the bus is gone\n");
      }
      const std::int64_t now = monotonic_ns();
      const bool prompt = handled < Bus::kMostPerCall && now - read_ns_ < kPrompt;
      read_ns_ = now;
      collect(now, prompt ? Receiver::kPrompt : Receiver::kLate);
      obey_pages(now);
      publish(frame, now);
      if (frame % kHeartbeatEvery == 0) beat(frame);
      busy_us_ = 1e-3 * static_cast<double>(monotonic_ns() - now);
    }
  }

 private:
  // Empty when it is not given: a random one is drawn.
  static std::string token_of(const char* name) {
    const char* token = std::getenv(name);
    if (token != nullptr && std::strlen(token) < 16)
      throw std::runtime_error(std::string(name) + ": at least 16 characters are needed");
    return token != nullptr ? token : "";
  }

  WebConfig web_config() {
    WebConfig config;
    config.port = static_cast<int>(arguments_.port);
    config.listen = arguments_.listen;
    if (const char* as = std::getenv("TWINBUS_VIEWER_AT")) {
      config.reached_as = as;
      if (config.reached_as.find_first_not_of(
              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-:[]") !=
          std::string::npos)
        throw std::runtime_error("TWINBUS_VIEWER_AT: HOST:PORT is needed, as in localhost:8040");
    }
    config.token = token_of("TWINBUS_VIEWER_TOKEN");
    config.watch_token = token_of("TWINBUS_VIEWER_WATCH_TOKEN");
    const std::string& web = arguments_.web;
    config.documents.push_back(page_document(web));
    config.roots = robot_roots(model_);
    config.roots.push_back({"/", web});
    config.documents.push_back({"/robot.urdf", "application/xml", model_.urdf_text});
    config.documents.push_back(
        {"/setup.json", "application/json", setup_choices(model_, config_folder() + "/scenes")});
    if (!arguments_.run_folder.empty())
      config.roots.push_back({"/setup/", arguments_.run_folder + "/setup"});
    config.max_trusted_message = kLargestMessage;
    config.on_message = [this](const std::string& text, bool trusted) {
      return inbox_.on_message(model_, arguments_.run_folder, text, trusted);
    };
    return config;
  }

  void announce() {
    const std::string address = server_.address();
    const std::string others = server_.watch_address();
    if (!others.empty())
      std::printf("twinbus_viewer: watch and stop from elsewhere: %s\n", others.c_str());
    std::printf("twinbus_viewer: ready at %s\n", address.c_str());
    std::fflush(stdout);
    if (!arguments_.no_open) open_browser(address);
  }

  void collect(std::int64_t now, Receiver receiver) {
    RobotState state;
    for (Latest<RobotState>& standby : standby_) {
      if (standby.take(state)) view_.on_standby_state(state, now);
    }
    if (state_.take(state)) view_.on_state(state, now);
    ControllerStatus controller;
    if (controller_.take(controller)) view_.on_controller_status(controller, now);
    // A standby simulator publishes TRUTH too: only the active one's is of interest.
    const Latest<SimTruth>* truth = truth_.find(view_.state().value.run_id);
    if (truth != nullptr && truth->received_ns > truth_ns_) {
      truth_ns_ = truth->received_ns;
      view_.on_truth(truth->message, now);
    }
    GuardReport guard;
    if (guard_.take(guard)) view_.on_guard(guard, now);
    JointCommand command;
    if (command_.take(command)) view_.on_command(command, now);
    view_.on_totals(state_.received, command_.received, guard_.received, now, receiver);
  }

  void obey_pages(std::int64_t now) {
    const StopKind stop = inbox_.take(asked_);
    const RobotState& state = view_.state().value;
    for (const PageRequest& request : asked_) {
      switch (request.what) {
        case PageRequest::What::kClear:
          stop_.start({.stop_nonce = state.stop_nonce, .reason = StopReason::kViewer});
          break;
        case PageRequest::What::kMode:
          mode_.start({.run_id = state.run_id, .mode = request.mode, .motion = request.motion, .amplitude = request.amplitude,
                       .frequency = request.frequency});
          break;
        case PageRequest::What::kPose: {
          ModeRequest pose = request.pose;
          pose.run_id = state.run_id;
          pose.mode = Mode::kPose;
          pose.duration = kPoseTime;
          for (int k = 0; k < model_.bus_count(); ++k) {
            const auto i = static_cast<std::size_t>(k);
            if ((pose.joint_mask >> k & 1) == 0) continue;
            const double speed = kPoseSpeed * model_.joints[static_cast<std::size_t>(model_.bus_joints[i])].velocity;
            if (speed > 0.0)
              pose.duration = std::max(pose.duration, static_cast<float>(std::abs(pose.q[i] - state.q[i]) / speed));
          }
          pose.duration = std::min(pose.duration, kPoseLongest);
          mode_.start(pose);
          break;
        }
        case PageRequest::What::kSwitch:
          switch_plan_.start(request.run_id, now);
          break;
        case PageRequest::What::kWalk:
          walk_.start({.run_id = state.run_id, .vx = request.vx, .vy = request.vy, .wz = request.wz, .timeout = kWalkTimeout});
          break;
        case PageRequest::What::kSim: {
          SimRequest sim = request.sim;
          sim.run_id = state.run_id;
          sim.model_hash = model_.hash;
          sim.link = static_cast<std::int16_t>(model_.find_link(request.link));
          const Eigen::Vector3d force = view_.world_from_sim().linear().transpose() *
                                        Eigen::Vector3f(request.sim.force.data()).cast<double>();
          for (std::size_t i = 0; i < 3; ++i)
            sim.force[i] = static_cast<float>(force[static_cast<Eigen::Index>(i)]);
          sim_.start(sim);
          break;
        }
        case PageRequest::What::kRecord:
          log_button_.turn(request.on);
          break;
        case PageRequest::What::kReach:
        case PageRequest::What::kCancel:
          ask_arm(request, now);
          break;
        default:
          break;
      }
    }
    asked_.clear();
    // After the rest, so that a stop in the same batch as a clear wins.
    if (stop != StopKind::kNone) {
      walk_.left = 0;
      stop_.start({.kind = stop, .reason = StopReason::kViewer});
    }
    SourceRequest change;
    if (switch_plan_.next(view_, now, change)) switch_.start(change);
    stop_.send(bus_);
    switch_.send(bus_);
    mode_.send(bus_);
    walk_.send(bus_);
    sim_.send(bus_);
    goal_.send(bus_);
  }

  // The page points into the world it draws; goals are in the robot's ground frame.
  void ask_arm(const PageRequest& request, std::int64_t now) {
    ArmGoal goal = goal_.message;
    goal.run_id = view_.state().value.run_id;
    goal.kind = ArmGoalKind::kCancel;
    if (request.what == PageRequest::What::kReach) {
      const Eigen::Isometry3d ground =
          view_.drawn_from_estimated(now) * view_.estimator().ground_in_world();
      const Eigen::Vector3d at = ground.inverse() * Eigen::Vector3d(request.at.data());
      goal.kind = ArmGoalKind::kPosition;
      goal.side = static_cast<ArmSide>(number_of(model_, *hand_called(model_, request.hand)) + 1);  // page_inbox.h has looked
      goal.goal_id = random_id();
      goal.position = {at.x(), at.y(), at.z()};
      goal.speed = kReachSpeed;
    }
    goal_.start(goal);
  }

  void publish(std::int64_t frame, std::int64_t now) {
    server_.publish(kLive, live_frame(view_, now));
    if (server_.stats().clients > 0) server_.publish(kSignals, signals_frame(view_, now));
    if (view_.arm_path().version() != shown_path_) {
      shown_path_ = view_.arm_path().version();
      server_.publish(kPath, path_frame(view_));
    }
    if (view_.camera().version() != shown_camera_) {
      shown_camera_ = view_.camera().version();
      server_.publish(kCamera, view_.camera().frame());
    }
    if (log_button_.version() != shown_recording_) {
      shown_recording_ = log_button_.version();
      server_.publish(kRecording, log_button_.frame());
    }
    if (frame % kStatusEvery == 0) {
      log_button_.look();
      view_.forget_silent(now);
      server_.publish(kStatus, status_frame(view_, now));
    }
    if (view_.scene_version() != shown_scene_) {
      shown_scene_ = view_.scene_version();
      server_.publish(kScene, scene_frame(view_));
    }
  }

  void beat(std::int64_t frame) {
    Heartbeat& beat = node_.beat();
    beat.state = view_.state().at_ns != 0 ? 2 : 1;
    beat.ticks = frame;
    beat.rate = 60.0f;
    beat.tick_median_us = static_cast<float>(busy_us_);
    node_.send_heartbeat(beat);
  }

  const Arguments arguments_;
  const Model model_;
  StackView view_;
  PageInbox inbox_;
  StateAdmission believed_;
  Latest<RobotState> state_;
  std::array<Latest<RobotState>, 3> standby_;
  Latest<JointCommand> command_;
  Slots<SimTruth, 8> truth_;
  std::int64_t truth_ns_ = 0, read_ns_ = 0;
  Latest<GuardReport> guard_;
  Latest<ControllerStatus> controller_;
  Outgoing<StopRequest> stop_;
  Outgoing<SourceRequest> switch_;
  Outgoing<ModeRequest> mode_;
  Outgoing<WalkCommand> walk_;
  Outgoing<SimRequest> sim_;
  Outgoing<ArmGoal> goal_;
  SwitchPlan switch_plan_;
  LogButton log_button_;
  std::int64_t shown_recording_ = -1;
  std::vector<PageRequest> asked_;
  std::int64_t shown_scene_ = -1;
  std::int64_t shown_path_ = 0, shown_camera_ = 0;
  double busy_us_ = 0.0;

  struct Admit {
    StateAdmission& believed;
    bool operator()(const RobotState& state, const RobotState&) noexcept {
      return believed.admit(state, monotonic_ns());
    }
  } admit_{believed_};
  Node node_;         // after what it fills
  Bus& bus_ = node_.bus();
  WebServer server_;  // last: its thread uses the members above
};

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = parse(argc, argv);
  catch_quit_signals();
  end_first_without_memory();
  give_way();
  Viewer viewer(arguments);
  viewer.run();
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "twinbus_viewer: %s\n", error.what());
  return 1;
}
