#include "launcher/run/local_stack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>

#include "common/text/formatted.h"
#include "common/time/part_clock.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/handler.h"
#include "lcmtypes/bus/wire.h"
#include "lcmtypes/msg/refusal_text.h"
#include "planner/arm_path_pieces.h"
#include "planner/plan_start.h"
#include "robot/collision/thing_name.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/status.h"
#include "sim/scene/obstacle_pieces.h"
#include "sim/scene/scene_requests.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kRunId = 1;
constexpr std::int64_t kOperatorId = 4;
constexpr std::int64_t kPlannerId = 3;
constexpr int kArmHeld = 3;  // arm_state: by the guard
constexpr std::int64_t kStopEvery = 10;  // a stop the guard asks for is said that often [ticks]
constexpr std::size_t kMostCaughtUp = 8;  // states answered late in a row
constexpr int kActivationTicks = 100'000;

// The adaptor must be open before a source is built around it.
SimAdaptor& opened(SimAdaptor& sim, const Model& model, const OneProcessConfig& config) {
  AdaptorConfig adaptor{config.settings};
  const auto is_seed = [](const auto& setting) { return setting.first == "sensor.seed"; };
  if (std::none_of(config.settings.begin(), config.settings.end(), is_seed)) {
    adaptor.settings.emplace_back("sensor.seed", std::to_string(config.seed));
  }
  if (sim.open(model, adaptor) != Status::kOk)
    throw std::runtime_error("the simulator does not open");
  return sim;
}

SourceConfig source_config(const OneProcessConfig& config) {
  SourceConfig source;
  source.run_id = kRunId;
  source.pace = Pace::kFreeRun;
  source.seed = config.seed;
  return source;
}

std::int64_t now_or_one(std::int64_t now_ns) { return now_ns > 0 ? now_ns : 1; }

}  // namespace

// A message as its receiver gets it.  False: what could not be sent.
template <class T>
bool OneProcess::over_the_bus(const Channel<T>& channel, const T& sent, T& received, StateHash* hash,
                              std::int64_t* content) {
  const PartScope part("messages");
  std::array<std::uint8_t, kLargestMessage> bytes;
  const int size = encode(sent, bytes);
  if (size <= 0) return false;
  const std::span<const std::uint8_t> encoded(bytes.data(), static_cast<std::size_t>(size));
  if (hash != nullptr) hash->add(encoded);
  if (listener_) {
    listener_(channel, encoded, now_ns_);
    if (content != nullptr) *content = content_hash(encoded);
    if constexpr (requires { journal_input(sent); })
      journal_.consumed(channel == channel::kHeld ? JournalInput::kHeld : journal_input(sent), encoded, now_or_one(now_ns_));
  }
  return decode(encoded, received) == Status::kOk;
}

void OneProcess::SendPage::operator()(const JournalPage& page) const noexcept {
  if (!o->listener_) return;
  std::array<std::uint8_t, kLargestMessage> bytes;
  const auto size = static_cast<std::size_t>(encode(page, bytes));
  o->listener_(channel::kJournal, std::span<const std::uint8_t>(bytes).first(size), o->now_ns_);
}

OneProcess::OneProcess(const Model& model, const Scene& scene, const OneProcessConfig& config)
    : model_(model),
      sim_(scene),
      origin_(scene.origin.x(), scene.origin.y(), 0.0),
      source_(model, opened(sim_, model, config), source_config(config)),
      control_(config.control),
      loop_(std::make_unique<ControlLoop>(model, config.control)),
      planner_view_(model),
      script_(requests_of(scene), model.period(), kRunId),
      walked_(model, scene),
      swing_(model, scene, sim_.world_config()),
      energy_(model, scene),
      loose_(scene),
      touch_(scene),
      listener_(config.listener),
      journal_(ProcessKind::kController, config.control.controller_id,
               {static_cast<double>(config.control.first_mode),
                config.control.guard_in_loop ? 1.0 : 0.0},
               SendPage{this}),
      controller_(config.controller) {
  shown_obstacles_ = obstacle_pieces(scene.obstacles, 1);
  if (!scene.tiles.empty()) shown_terrain_ = obstacle_pieces(scene.tiles, kRunId);
  for (const LooseBody& body : scene.loose) loose_names_.push_back(body.name);
  for (const SceneRobot& robot : scene.robots) {
    const int index = static_cast<int>(further_robots_.size());
    further_robots_.push_back({robot.name, world().robot_link(index, 0).translation()});
  }
  tell_obstacles();
  activate();
}

int OneProcess::find_loose(const std::string& name) const {
  const auto found = std::find(loose_names_.begin(), loose_names_.end(), name);
  return found == loose_names_.end() ? -1 : static_cast<int>(found - loose_names_.begin());
}

void OneProcess::tell_obstacles() {
  for (const ObstaclesPiece& piece : shown_obstacles_) {
    ObstaclesPiece received;
    if (over_the_bus(channel::kObstacles, piece, received)) (void)obstacles_.add(received);
  }
  take_obstacles();
}

void OneProcess::take_obstacles() {
  journal_.consumed(JournalInput::kTakeObstacles, {}, now_or_one(now_ns_));
  loop_->set_obstacles(obstacles_.obstacles());
  if (planner_ != nullptr) planner_->set_obstacles(obstacles_.obstacles());
}

// What the simulated hands grip and let go.
void OneProcess::tell_held() {
  ObstaclesPiece piece;
  for (int hand = 0; hand < kMostHands; ++hand) {
    if (!sim_.held(hand, piece) || piece.scene_id == told_held_[static_cast<std::size_t>(hand)]) continue;
    told_held_[static_cast<std::size_t>(hand)] = piece.scene_id;
    say_held(piece);
  }
}

void OneProcess::say_held(const ObstaclesPiece& piece) {
  ObstaclesPiece received;
  if (over_the_bus(channel::kHeld, piece, received) && obstacles_.hold(received)) take_obstacles();
}

// Into the log, for whoever looks at it; nobody here obeys it.
template <class T>
void OneProcess::show(const Channel<T>& channel, T message) {
  message.utime = now_ns_ / 1000;
  std::array<std::uint8_t, kLargestMessage> bytes;
  const int size = encode(message, bytes);
  if (size <= 0) return;
  listener_(channel, std::span<const std::uint8_t>(bytes).first(static_cast<std::size_t>(size)),
            now_ns_);
}

// As often as a stack on a bus does.
void OneProcess::show_scene() {
  const auto every = [&](double seconds) {
    return ticks_ % std::max<std::int64_t>(1, std::llround(seconds / model_.period())) == 0;
  };
  if (every(1.0)) {
    for (const ObstaclesPiece& piece : shown_obstacles_) show(channel::kObstacles, piece);
    for (const ObstaclesPiece& piece : shown_terrain_) show(channel::kTerrain, piece);
  }
  ObstaclesPiece piece;
  for (int i = 0; every(0.02) && i < sim_.loose(i, piece); ++i) {
    piece.scene_id = kRunId;
    show(channel::kLoose, piece);
  }
  if (!every(0.05)) return;
  loop_->footsteps(piece);
  if (piece.count == 0 && !walked_on_) return;
  walked_on_ = piece.count > 0;
  piece.scene_id = kRunId;
  show(channel::kFootsteps, piece);
}

// A source listens for others before it may become active: time passes, but not for the robot.
void OneProcess::activate() {
  for (int i = 1; i < kActivationTicks; ++i) {
    now_ns_ += model_.period_ns;
    if (i % 100 == 0) {
      SourceRequest request;
      request.action = SourceAction::kActivate;
      request.policy = SwitchPolicy::kNow;
      request.sender_id = kOperatorId;
      request.run_id = request.target_run_id = kRunId;
      request.sequence = ++sequence_;
      source_.on_source_request(request, now_ns_);
    }
    source_.begin_tick(now_ns_);
    if (source_.publishes_on_state()) {
      first_tick_ = source_.state().tick;
      return;
    }
    source_.end_tick(now_ns_);
  }
  throw std::runtime_error(std::string("the simulator does not become active: ") +
                           refusal_text(source_.status().refusal));
}

std::vector<SimAdaptor*> OneProcess::sims_of(const std::vector<OneProcess*>& runs) {
  std::vector<SimAdaptor*> sims;
  for (OneProcess* run : runs) sims.push_back(&run->sim_);
  return sims;
}

bool OneProcess::observe() {
  if (!failure_.empty()) return false;
  if (ticks_ > 0) {
    now_ns_ += model_.period_ns;
    source_.begin_tick(now_ns_);
  }
  if (!over_the_bus(channel::kState, source_.state(), heard_, &hash_, &state_content_)) {
    failure_ = "tick " + std::to_string(source_.state().tick) + ": a state that cannot be sent";
    return false;
  }
  ++ticks_;
  return true;
}

bool OneProcess::act() {
  tell_held();
  if (controller_) {
    control();
  } else {
    obey();
  }
  watch();  // before the simulator moves on
  source_.end_tick(now_ns_);
  say_script();
  if (source_.status().adaptor_status != static_cast<std::int8_t>(Status::kOk)) {
    failure_ = "tick " + std::to_string(heard_.tick) + ": the simulation gave up";
  }
  return failure_.empty();
}

// As the controller's main: of what it finds after a silence it answers the oldest first, a few, then the newest.
void OneProcess::control() {
  planner_view_.update(heard_);
  if (heard_.tick < silent_until_) {
    if (missed_.size() < kMostCaughtUp) missed_.push_back(heard_);
    return;
  }
  for (const RobotState& state : missed_) answer(state);
  missed_.clear();
  answer(heard_);
}

// The command of somebody else, who needs no stop plan and no guard.
void OneProcess::obey() {
  own_command_.tick = heard_.tick;
  own_command_.run_id = kRunId;
  own_command_.term = heard_.term;
  own_command_.model_hash = model_.hash;
  own_command_.controller_id = control_.controller_id;
  own_command_.joint_count = heard_.joint_count;
  if (over_the_bus(channel::kCommand, own_command_, command_)) source_.on_command(command_, now_ns_);
}

void OneProcess::stall_controller(double seconds) {
  missed_.clear();
  silent_until_ = seconds < 0.0 ? std::numeric_limits<std::int64_t>::max()
                                : heard_.tick + 1 + std::llround(seconds / model_.period());
}

void OneProcess::restart_controller(std::int64_t controller_id) {
  control_.controller_id = controller_id;
  loop_ = std::make_unique<ControlLoop>(model_, control_);
  loop_->set_obstacles(obstacles_.obstacles());
  missed_.clear();
  silent_until_ = 0;
}

void OneProcess::answer(const RobotState& state) {
  JointCommand answer;
  std::int64_t answer_content = 0, report_content = 0;
  const auto controller = [&] {
    const PartScope part("controller");
    loop_->on_state(state, now_ns_);
    return loop_->step(now_ns_, answer);
  };
  if (controller() &&
      over_the_bus(channel::kCommand, answer, command_, nullptr, &answer_content)) {
    source_.on_command(command_, now_ns_);
    for (StopPlanPiece piece, received; loop_->take_plan(piece);) {
      if (over_the_bus(channel::kStopPlan, piece, received)) source_.on_stop_plan(received, now_ns_);
    }
    ControllerStatus status;
    if (over_the_bus(channel::kControllerStatus, loop_->status(), status, nullptr, &report_content))
      source_.on_controller_status(status, now_ns_);
  }
  if (listener_) journal_.stepped(state, state_content_, now_ns_, answer_content, report_content);
  if (const char* sentence = loop_->take_sentence())
    sentences_.push_back(std::string("controller: ") + sentence);
  const bool repeated = heard_.tick - stop_asked_tick_ < kStopEvery;
  if (loop_->guard_report().stop_asked && heard_.stop_kind == StopKind::kNone && !repeated) {
    stop_asked_tick_ = heard_.tick;
    StopRequest stop;
    stop.sender_id = kOperatorId;
    stop.kind = StopKind::kBalanced;
    stop.reason = StopReason::kGuard;
    if (stop_cause_.empty()) {
      stop_cause_ = "asked by the guard: " + loop_->guard_cause();
      sentences_.push_back("stop " + stop_cause_);
    }
    say(stop);
  }
}

// To whoever obeys it.
template <class T>
void OneProcess::deliver(const T& received) {
  if constexpr (std::is_same_v<T, StopRequest>) source_.on_stop(received, now_ns_);
  for_each_control_input([&]<auto kOn>() {
    if constexpr (std::is_same_v<MessageOf<kOn>, T>) hand_over<kOn>(received, *loop_, now_ns_);
  });
  if constexpr (std::is_same_v<T, ArmGoal>) plan(received);
}

template <class T>
void OneProcess::say(T request) {
  if constexpr (std::is_same_v<T, StopRequest>) {
    if (request.sender_id == 0) request.sender_id = kOperatorId;
  } else {
    request.sender_id = kOperatorId;
    request.run_id = kRunId;
  }
  request.sequence = ++sequence_;
  if (T received; over_the_bus(channel_of(request), request, received)) deliver(received);
}
template void OneProcess::say(ModeRequest);
template void OneProcess::say(WalkCommand);
template void OneProcess::say(StopRequest);
template void OneProcess::say(ArmGoal);

void OneProcess::say_script() {
  script_.after(heard_.tick, first_tick_, [this](auto& request) {
    auto received = request;
    if (over_the_bus(channel_of(request), request, received)) deliver(received);
  });
}

// The planner's process, but that the answer takes no simulated time.
void OneProcess::plan(const ArmGoal& goal) {
  if (goal.goal_id == planned_goal_) return;  // said again
  planned_goal_ = goal.goal_id;
  if (goal.kind == ArmGoalKind::kCancel) return;
  const PartScope part("planner");
  if (planner_ == nullptr) {
    planner_ = std::make_unique<ArmPlanner>(model_);
    planner_->set_obstacles(obstacles_.obstacles());
  }
  const Configuration start = plan_start(model_, planner_view_.configuration(), heard_, command_);
  planner_->set_balancing(loop_->status().mode == Mode::kBalance);
  const ArmPlan plan = planner_->plan(goal, start, planner_view_.ground_in_world(),
                                      static_cast<std::uint64_t>(goal.goal_id));
  sentences_.push_back("planner: " + describe(plan));
  const bool planned = !plan.path.empty();
  goals_.ask(goal, planned ? plan.joints : std::vector<int>{}, planned ? Eigen::VectorXd(plan.path.back().q) : Eigen::VectorXd());
  arm_answer_ = to_pieces(plan, {kPlannerId, goal.run_id, goal.goal_id, goal.goal_id});
  for (const ArmPathPiece& piece : arm_answer_) {
    ArmPathPiece received;
    if (over_the_bus(channel::kArmPath, piece, received)) loop_->on_arm_path(received);
  }
}

void OneProcess::note_touch(const GuardReport& report) {
  if (report.verdict != GuardVerdict::kInCollision || report.pairs_near < 1) return;
  const int a = report.link_a[0], b = report.link_b[0];
  if (touch_a_ < 0) {
    touch_a_ = a;
    touch_b_ = b;
    touch_time_ = static_cast<double>(heard_.tick - first_tick_) * model_.period();
  }
  if (a == touch_a_ && b == touch_b_) touch_depth_ = std::min(touch_depth_, static_cast<double>(report.distance[0]));
}

std::string OneProcess::first_touch() const {
  if (touch_a_ < 0) return "";
  const auto name = [&](int link) { return std::string(thing_name(model_, obstacles_.obstacles(), link).data()); };
  const std::string text = formatted(" by %.1f mm, first at %.3f s", -1e3 * touch_depth_, touch_time_);
  return ": " + name(touch_a_) + " and " + name(touch_b_) + text;
}

void OneProcess::watch() {
  const PartScope part("figures of the run");
  SimTruth truth = *sim_.truth();
  truth.tick = heard_.tick;
  truth.run_id = kRunId;
  seen_.on_state(heard_, now_ns_);
  seen_.on_command(command_, now_ns_);
  if (SimTruth received; listener_) (void)over_the_bus(channel::kTruth, truth, received);
  if (listener_) show_scene();
  seen_.on_truth(truth, now_ns_);
  seen_.on_guard(loop_->guard_report(), now_ns_);
  note_touch(loop_->guard_report());
  const bool held = loop_->status().arm_state == kArmHeld;
  if (held && !arm_held_) sentences_.push_back("the guard holds the arm: " + loop_->guard_cause());
  arm_held_ = held;
  walked_.add(truth, loop_->status().mode, loop_->foot_forces(),
              static_cast<double>(heard_.tick - first_tick_) * model_.period());
  const bool pushed = truth.push_force != decltype(truth.push_force){};
  swing_.add(pushed, heard_);
  energy_.add(pushed, heard_, world());
  loose_.add(world());
  touch_.add(static_cast<double>(heard_.tick - first_tick_) * model_.period(), world());
  const Estimator& view = planner_view_;
  goals_.add(static_cast<double>(heard_.tick - first_tick_) * model_.period(), loop_->status(), view.configuration(),
             [&](ArmSide side) -> Eigen::Vector3d {
               const Hand* hand = hand_of(model_, number_of(side));
               return view.ground_in_world().inverse() * view.kinematics().link_in_world(hand->link) * hand->frame.translation();
             });
  for (std::size_t foot = 0; foot < 2; ++foot) {
    if (model_.soles[foot].link < 0) continue;
    const auto x = static_cast<double>(truth.foot_attitude[foot][1]);
    const auto y = static_cast<double>(truth.foot_attitude[foot][2]);
    sole_tilt_max_ =
        std::max(sole_tilt_max_, std::acos(std::clamp(1.0 - 2.0 * (x * x + y * y), -1.0, 1.0)));
  }
}

}  // namespace twinbus::launcher
