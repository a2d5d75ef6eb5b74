// `./twinbus reach`: brings a hand to a point: goal, plan, motion, and why not.

#include "common/math/angle.h"
#include "launcher/commands/commands.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "common/math/pose_math.h"
#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "common/text/printable.h"
#include "launcher/operate/asked_hand.h"
#include "launcher/operate/reach_goal.h"
#include "launcher/operate/reach_progress.h"
#include "launcher/bus/bus_link.h"
#include "launcher/stack/asked_robot.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/event_code.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/pace.h"
#include "lcmtypes/msg/plan_refusal.h"
#include "lcmtypes/msg/state_admission.h"
#include "robot/collision/thing_name.h"
#include "robot/description/model.h"
#include "robot/description/load.h"
#include "robot/estimation/estimator.h"
#include "robot/hand/tools.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kGoalAgain = 0.2;      // [s]
constexpr double kPlanTimeout = 15.0;  // [s]
constexpr double kWords = 0.3;         // [s] until the planner has said why
constexpr double kFarthest = 10.0;     // [m]

// What one `reach` hears of the stack.
class Watcher {
 public:
  Watcher(const Model& model, const BusOptions& options)
      : model_(model), bus_(options), estimator_(model) {
    bus_.listen<&Watcher::hear_state>(channel::kState, *this);
    bus_.listen<&Watcher::hear_path>(channel::kArmPath, *this);
    bus_.listen<&Watcher::hear_controller>(channel::kControllerStatus, *this);
    bus_.listen<&Watcher::hear_source>(channel::kSourceStatus, *this);
    bus_.listen<&Watcher::hear_truth>(channel::kTruth, *this);
    bus_.listen<&Watcher::hear_event>(channel::kEvent, *this);
    bus_.listen<&Watcher::hear_estimate>(channel::kEstimate, *this);
  }

  void receive(double seconds) {
    if (bus_.receive(seconds) < 0) throw std::runtime_error("the bus is gone");
  }
  Bus& bus() { return bus_; }
  // From now on the path that answers this goal is waited for.
  void expect(std::int64_t goal) {
    goal_id = goal;
    answered = false;
    first = {};
    have = 0;
    duration = 0.0;
    path_refusal.clear();
    goal_refusal.clear();
  }

  // Position and distance of the hand from where it should be, in the ground frame.
  Eigen::Isometry3d hand_in_ground(ArmSide side) const {
    const Hand& hand = *hand_of(model_, number_of(side));
    return estimator_.ground_in_world().inverse() *
           estimator_.kinematics().link_in_world(hand.link) * hand.frame;
  }

  const Estimator& estimator() const { return estimator_; }
  // As the source tells; empty before it did.
  const std::optional<Eigen::Isometry3d>& base_in_world() const { return base_in_world_; }
  std::int64_t run_id() const { return states_ > 0 ? admission_.run_id() : 0; }
  bool other_robot() const { return other_robot_; }
  StopKind stop_kind() const { return stop_kind_; }
  bool fell() const { return fell_; }  // a simulated robot
  std::int64_t states() const { return states_; }

  std::int64_t goal_id = 0;  // whose path is waited for
  bool answered = false;
  ArmPathPiece first;      // a piece of the answer
  std::uint64_t have = 0;  // bit per piece
  double duration = 0.0;   // [s] as far as known
  ControllerStatus status;
  std::int64_t statuses = 0;
  bool paused = false;  // the simulated world
  // By controller and planner, of this path and goal or of others at that time.
  std::string path_refusal, goal_refusal;

 private:
  void hear_state(const RobotState& state) {
    if (state.model_hash != model_.hash || state.joint_count != model_.bus_count()) {
      other_robot_ = true;
      return;
    }
    if (!admission_.admit(state, monotonic_ns()) || (states_ > 0 && state.tick == tick_)) return;
    tick_ = state.tick;
    stop_kind_ = state.stop_kind;
    ++states_;
    estimator_.update(state);
  }
  void hear_path(const ArmPathPiece& piece) {
    if (goal_id == 0 || piece.goal_id != goal_id || (answered && piece.path_id != first.path_id))
      return;
    answered = true;
    first = piece;
    if (piece.pieces <= 0 || piece.pieces > 64 || piece.piece < 0 || piece.piece >= piece.pieces)
      return;
    const std::uint64_t bit = std::uint64_t{1} << piece.piece;
    if ((have & bit) != 0 || piece.knot_count < 1 || piece.knot_count > kKnotsPerPiece) return;
    have |= bit;
    duration = std::max(duration, piece.time[static_cast<std::size_t>(piece.knot_count) - 1]);
  }
  void hear_controller(const ControllerStatus& heard) {
    status = heard;
    ++statuses;
  }

  void hear_source(const SourceStatus& source) {
    if (source.role == Role::kActive || source.role == Role::kStopped) paused = has_pace(source, Pace::kPaused);
  }

  void hear_event(const Event& event) {
    const bool of_path = event.kind == ProcessKind::kController && event.code == kArmPathRefused;
    const bool of_goal = event.kind == ProcessKind::kPlanner && event.code == kArmGoalRefused;
    if ((!of_path && !of_goal) || event.run_id != run_id()) return;
    (of_path ? path_refusal : goal_refusal) = printable({event.text.data(), strnlen(event.text.data(), event.text.size())});
  }

  void hear_truth(const SimTruth& truth) {
    if (truth.run_id == run_id()) fell_ = truth.fell;
  }

  void hear_estimate(const Estimate& estimate) {
    if (estimate.run_id != run_id()) return;
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
    base.translation() = vector_from_array(estimate.base_position);
    base.linear() = quaternion_from_array(estimate.base_attitude).toRotationMatrix();
    base_in_world_ = base;
  }

  const Model& model_;
  Bus bus_;
  Estimator estimator_;
  std::optional<Eigen::Isometry3d> base_in_world_;
  StateAdmission admission_;
  bool other_robot_ = false, fell_ = false;
  StopKind stop_kind_ = StopKind::kNone;
  std::int64_t tick_ = 0, states_ = 0;
};

// What was asked: the place of a tool in a frame.
struct Wish {
  ReachFrame frame;
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();  // of the tool, in that frame [m]
  Eigen::Isometry3d tool = Eigen::Isometry3d::Identity();   // in the hand's frame
  bool oriented = false;
  std::optional<Eigen::Isometry3d> in_ground;  // of the tool, once the frame was seen; ever anew where it stands still
};

Wish wish_from(const Arguments& arguments, const Model& model, ArmGoal& goal) {
  const Hand* hand = &asked_hand("reach", model, arguments.word(0));
  goal.side = static_cast<ArmSide>(number_of(model, *hand) + 1);
  const std::size_t count = arguments.words().size();
  if (count != 4 && count != 7) throw UsageError("reach: X Y Z, or X Y Z and R P Y");
  Wish wish;
  wish.frame = reach_frame(model, arguments.text("--frame", "ground"));
  if (arguments.has("--tool")) wish.tool = tool_in_hand(model, *hand, arguments.text("--tool", ""));
  static constexpr std::array<const char*, 3> kAxis{"X", "Y", "Z"};
  const double far = wish.frame.kind == ReachFrame::Kind::kWorld ? 1000.0 : 5.0;
  for (std::size_t k = 0; k < 3; ++k)
    wish.place.translation()[static_cast<Eigen::Index>(k)] = arguments.word_number(k + 1, kAxis[k], -far, far);
  wish.oriented = count == 7;
  if (wish.oriented) {
    wish.place.linear() = rotation_from_rpy(arguments.word_number(4, "roll", -7.0, 7.0), arguments.word_number(5, "pitch", -7.0, 7.0),
                                            arguments.word_number(6, "yaw", -7.0, 7.0));
  }
  goal.speed = static_cast<float>(arguments.number("--speed", 0.4, 0.01, 1.0));
  goal.sender_id = random_id();
  return wish;
}

// Where the tool is to go, as the robot stands now, into the goal of the hand.
void aim(const Watcher& watcher, const Model& model, Wish& wish, ArmGoal& goal) {
  if (!wish.in_ground || stands_still(wish.frame)) {
    const std::optional<Eigen::Isometry3d> frame =
        frame_in_ground(wish.frame, model, watcher.estimator(), watcher.base_in_world());
    if (!frame)
      throw std::runtime_error("no source tells where the base is in the world (ESTIMATE): reach in the frame base or ground");
    wish.in_ground = *frame * wish.place;
  }
  aim_hand(*wish.in_ground, wish.oriented, wish.tool, watcher.hand_in_ground(goal.side), goal);
  const Eigen::Vector3d hand(goal.position[0], goal.position[1], goal.position[2]);
  if (!(hand.norm() <= kFarthest))
    throw std::runtime_error("the goal is more than 10 m from the robot: which frame is it in? (--frame)");
}

// Nothing is planned for a robot that cannot move its arm.  A fall comes first: it has stopped the robot as well.
void refuse_unless_it_stands(const Watcher& watcher) {
  if (watcher.fell()) throw std::runtime_error("the robot has fallen: ./twinbus sim reset puts it on its feet, then ask again");
  if (watcher.stop_kind() == StopKind::kNone) return;
  throw std::runtime_error(std::string("the robot is stopped (") + label(watcher.stop_kind()) +
                           "): ./twinbus clear ends that, then ask again");
}

void ask(Watcher& watcher, ArmGoal& goal) {
  goal.run_id = watcher.run_id();
  const std::int64_t begin = monotonic_ns();
  std::int64_t asked = 0;
  while (!quit_requested() && !watcher.answered && seconds_since(begin) < kPlanTimeout) {
    if (asked == 0 || seconds_since(asked) > kGoalAgain) {
      asked = monotonic_ns();
      goal.utime = wall_us();
      ++goal.sequence;
      if (!watcher.bus().send(channel::kArmGoal, goal))
        throw std::runtime_error("the goal cannot be sent");
    }
    watcher.receive(0.02);
  }
  if (!watcher.answered) {
    throw std::runtime_error("no planner answers; ./twinbus status shows whether one is running");
  }
}

void cancel(Watcher& watcher, ArmGoal goal) {
  goal.kind = ArmGoalKind::kCancel;
  goal.utime = wall_us();
  ++goal.sequence;
  if (!watcher.bus().send(channel::kArmGoal, goal))
    print_typed(stderr, "reach: the cancel could not be sent\n");
}

// Until the controller says done; false with a sentence when it does not come to that.
bool follow(Watcher& watcher, const ArmGoal& goal) {
  const std::int64_t begin = monotonic_ns();
  const bool terminal = ::isatty(STDOUT_FILENO) != 0;
  ReachProgress progress(watcher.first.path_id, watcher.duration);
  const auto fail = [&](const char* sentence) {
    print_typed(stderr, "%sreach: %s\n", terminal && progress.moving() ? "\n" : "", sentence);
    return false;
  };
  std::int64_t shown = 0;
  do {
    if (quit_requested()) {
      cancel(watcher, goal);
      return fail("cancelled; the arm stops on its path");
    }
    watcher.receive(0.02);
    if (terminal && progress.moving() && seconds_since(shown) > 0.2) {
      shown = monotonic_ns();
      print_typed(stdout, "\r  %3.0f %%", 100.0 * progress.share(seconds_since(begin)));
      std::fflush(stdout);
    }
  } while (progress.goes_on(seconds_since(begin), watcher.stop_kind(),
                            watcher.statuses > 0 ? &watcher.status : nullptr));
  if (progress.must_cancel()) cancel(watcher, goal);
  const bool refused = !progress.moving() && !watcher.path_refusal.empty();
  if (!progress.arrived()) return fail(refused ? watcher.path_refusal.c_str() : progress.failure());
  if (terminal) print_typed(stdout, "\r  arrived after %.1f s      \n", seconds_since(begin));
  return true;
}

// One plan and its motion.  False, with a sentence, when the arm does not come to the end of it.
bool go(Watcher& watcher, const Model& model, ArmGoal& goal, bool say) {
  goal.goal_id = random_id();
  watcher.expect(goal.goal_id);
  ask(watcher, goal);
  const ArmPathPiece& first = watcher.first;
  if (first.status != ArmPathStatus::kOk) {
    // The message has no words; the event that follows it does.
    for (const std::int64_t start = monotonic_ns();
         first.status == ArmPathStatus::kBadGoal && watcher.goal_refusal.empty() && seconds_since(start) < kWords;)
      watcher.receive(0.02);
    const bool told = first.status == ArmPathStatus::kBadGoal && !watcher.goal_refusal.empty();
    const ThingName a = thing_name(model, {}, first.link_a), b = thing_name(model, {}, first.link_b);
    const bool oriented = goal.kind == ArmGoalKind::kPose;
    const std::string why = plan_refusal(first.status, a.data(), b.data(), static_cast<double>(first.miss), oriented);
    print_typed(stderr, "reach: %s\n", (told ? watcher.goal_refusal : why).c_str());
    return false;
  }
  const std::uint64_t all = ~std::uint64_t{0} >> (64 - watcher.first.pieces);
  for (const std::int64_t start = monotonic_ns();
       watcher.have != all && seconds_since(start) < 1.0;)
    watcher.receive(0.02);
  if (say) {
    print_typed(
        stdout, "path of %.1f s in %d pieces, proved to keep %.0f mm from the body and all obstacles\n",
        watcher.duration, static_cast<int>(watcher.first.pieces),
        1e3 * static_cast<double>(watcher.first.clearance));
    std::fflush(stdout);
  }
  if (!follow(watcher, goal)) return false;
  for (const std::int64_t start = monotonic_ns();
       !quit_requested() && seconds_since(start) < kReachSettle;)
    watcher.receive(0.02);
  return true;
}

}  // namespace

int reach_command(const std::vector<std::string>& words) {
  const Arguments arguments({"reach", 1, 7, R"(left|right|ARM X Y Z [R P Y]
Plans a motion of one arm around obstacles and the robot's own body and follows it; ARM: as robot.yaml calls another arm.  \
X Y Z [m], R P Y [rad] of the hand in the \
ground frame: midway between the feet, x forward, z up.
  --frame NAME  of the goal: ground, base (link), world (where the robot first stood, as ESTIMATE tells), or a link of the URDF \
      as it is when this is asked; default ground
  --tool T  what is to be there instead of the hand's own frame: X,Y,Z or X,Y,Z,R,P,Y in it, a name under tools: of robot.yaml, \
      or a link that the hand carries; without R P Y it keeps its turn
  --speed SHARE  of the joints' velocity limits, 0.01 to 1 (0.4)
  --robot R  default the robot of the running ./twinbus up, else hrp1s
  --prefix --url --allow)"}, words);
  catch_quit_signals();
  const Model model = load_robot(asked_robot(arguments));
  ArmGoal goal;
  Wish wish = wish_from(arguments, model, goal);
  const BusOptions options = bus_options(arguments);
  Watcher watcher(model, options);

  const std::int64_t begin = monotonic_ns();
  while (!quit_requested() && watcher.states() < 5 && seconds_since(begin) < kFirstState)
    watcher.receive(0.02);
  if (watcher.states() == 0) {
    throw std::runtime_error(
        watcher.paused ? "the simulated world is paused: ./twinbus sim go, then ask again"
        : watcher.other_robot()
            ? "the robot on the bus is not " + model.name + "; give its folder with --robot"
            : "no robot is heard on " + options.url + "; start one with ./twinbus up");
  }

  refuse_unless_it_stands(watcher);
  if (wish.frame.kind == ReachFrame::Kind::kWorld) {
    const std::int64_t start = monotonic_ns();
    while (!watcher.base_in_world() && !quit_requested() && seconds_since(start) < kFirstState) watcher.receive(0.02);
  }
  double miss = 0.0;
  for (int attempt = 0; attempt <= kReachCorrections; ++attempt) {
    aim(watcher, model, wish, goal);
    if (!go(watcher, model, goal, attempt == 0)) return 1;
    aim(watcher, model, wish, goal);
    miss = ((watcher.hand_in_ground(goal.side) * wish.tool).translation() - wish.in_ground->translation()).norm();
    if (quit_requested() || miss <= kReachNearEnough) break;
  }
  const Eigen::Isometry3d tool = watcher.hand_in_ground(goal.side) * wish.tool;
  // Said in the frame in which it was asked.
  const Eigen::Isometry3d shown = wish.place * wish.in_ground->inverse() * tool;
  const Eigen::Vector3d at = shown.translation();
  print_typed(stdout, "%s hand%s at %.3f %.3f %.3f m%s, %.1f mm from the goal", arguments.word(0).c_str(),
              arguments.has("--tool") ? "'s tool" : "", at.x(), at.y(), at.z(),
              arguments.has("--frame") ? (" in " + arguments.text("--frame", "")).c_str() : "", 1e3 * miss);
  if (wish.oriented) {
    const double angle = Eigen::Quaterniond(shown.linear()).angularDistance(Eigen::Quaterniond(wish.place.linear()));
    print_typed(stdout, ", turned %.1f degrees from it", kDegrees * angle);
  }
  print_typed(stdout, "\n");
  if (!(miss <= kReachFar)) {
    print_typed(stderr,
                 "reach: the hand came no nearer than %.0f mm; does the robot stand still?\n",
                 1e3 * miss);
    return 1;
  }
  return 0;
}

}  // namespace twinbus::launcher
