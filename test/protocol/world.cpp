#include "test/protocol/world.h"

#include <algorithm>
#include <cmath>

namespace twinbus::protocol {

namespace {

constexpr std::int64_t kController = 7;
constexpr std::int64_t kOtherController = 8;
constexpr std::int64_t kOperator = 5;

Model small_model() {
  Model model;
  model.links.resize(2);
  Joint joint;
  joint.child = 1;
  joint.lower = -3.0;
  joint.upper = 3.0;
  joint.velocity = 3.0;
  joint.effort = 100.0;
  joint.kp = joint.stop_kp = 1000.0;
  joint.kd = joint.stop_kd = 10.0;
  model.joints.push_back(joint);
  model.bus_joints = {0};
  model.floating_base = false;
  model.period_ns = static_cast<std::int32_t>(kPeriod);
  model.command_timeout = 1e-9 * static_cast<double>(kTimeoutPeriods * kPeriod);
  model.state_timeout = 3e-9 * static_cast<double>(kPeriod);
  model.hash = 4711;
  return model;
}

}  // namespace

Setting::Setting(int n, bool target_is_hardware, double target_q, RuleSet rules_off, bool sends_plans)
    : sources(n), off(rules_off), plans(sends_plans), model(small_model()), limits(std::make_shared<const GateLimits>(model)) {
  for (int i = 0; i < n; ++i) {
    const bool hardware = i == 1 && target_is_hardware;
    robots.emplace_back(!hardware, i == 1 ? target_q : 0.0);
  }
}

HandoverConfig Setting::handover_config(int source, std::int64_t run_id) const {
  HandoverConfig c;
  const StillRobot& robot = robots[static_cast<std::size_t>(source)];
  c.run_id = run_id;
  c.model_hash = model.hash;
  c.period_ns = model.period_ns;
  c.can_be_set = robot.can_be_set();
  c.hardware = robot.is_hardware();
  c.state_timeout_ns = 3 * kPeriod;
  c.listen_ns = 10 * kPeriod;
  c.silence_ns = 5 * kPeriod;
  c.late_ns = 4 * kPeriod;
  c.switch_interval_ns = 12 * kPeriod;
  c.off = off;
  return c;
}

SourceConfig Setting::source_config(int source, std::int64_t run_id) const {
  SourceConfig c;
  c.run_id = run_id;
  c.kind = robots[static_cast<std::size_t>(source)].is_hardware() ? SourceKind::kBridge
                                                                  : SourceKind::kSimulator;
  return c;
}

World::World(const Setting& setting) : setting_(&setting) {
  nodes_.reserve(kMaxSources);
  late_.reserve(4);
  for (int i = 0; i < setting.sources; ++i) add_node(i);
}

void World::add_node(int i) {
  const std::int64_t run = ++next_run_;
  auto& robot = const_cast<StillRobot&>(setting_->robots[static_cast<std::size_t>(i)]);
  Node node(Source(setting_->model, setting_->limits, robot, setting_->source_config(i, run),
                   setting_->handover_config(i, run)));
  node.run_id = run;
  node.born_ns = now_ns_;
  if (static_cast<std::size_t>(i) < nodes_.size()) {
    nodes_[static_cast<std::size_t>(i)] = std::move(node);
  } else {
    nodes_.push_back(std::move(node));
  }
}

int World::index_of(std::int64_t run) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].alive && nodes_[i].run_id == run) return static_cast<int>(i);
  }
  return -1;
}

int World::holders() const {
  int n = 0;
  for (const Node& node : nodes_) n += node.alive && node.core.handover().holds_state();
  return n;
}

Fate World::fate_of(const Fault& fault, int from, int to) const {
  if (fault.from != from && fault.from != -2) return Fate::kDelivered;
  return fault.to == to || fault.to == -1 ? fault.fate : Fate::kDelivered;
}

void World::deliver_state(int to, const RobotState& state, bool on_state) {
  Node& node = nodes_[static_cast<std::size_t>(to)];
  if (!node.alive) return;
  if (on_state) {
    node.core.on_state(state, now_ns_);
    if (state.run_id != kStranger) node.highest_term = std::max(node.highest_term, state.term);
    node.heard_state_ns = now_ns_;
  } else {
    node.core.on_standby_state(state, now_ns_);
  }
}

void World::deliver_command(int to, const JointCommand& command) {
  Node& node = nodes_[static_cast<std::size_t>(to)];
  if (!node.alive) return;
  const bool holding = node.core.handover().holds_state();
  const std::int64_t before = node.core.gate().counters().accepted;
  const StopKind latched = node.must_stop;
  const bool led = node.core.gate().plan().running();
  const bool ended = led && node.core.gate().plan().ended(node.core.state().tick);
  const std::int64_t bound = node.core.gate().controller_id();
  node.core.on_command(command, now_ns_);
  if (!holding || node.core.gate().counters().accepted == before) return;
  // It obeyed.
  const Handover& h = node.core.handover();
  if (command.run_id != node.run_id) fail("a source obeys a command that is for another source");
  if (command.term != h.term) fail("a source obeys a command of another term");
  if (command.controller_id == kOtherController && command.tick > 0 &&
      node.last_accepted_tick >= 0 && node.last_accepted_term == h.term && !led) {
    fail("a second controller is obeyed beside the bound one");
  }
  if (node.last_accepted_term == h.term && command.tick <= node.last_accepted_tick) {
    fail("a command is obeyed twice, or after a newer one");
  }
  if (command.tick > node.core.state().tick) fail("a command from the future is obeyed");
  if (node.core.state().tick - command.tick > kTimeoutPeriods)
    fail("a command older than the timeout is obeyed");
  if (latched >= StopKind::kHold) fail("a command is obeyed in spite of a stop");
  if (h.successor != 0 && h.tick >= h.grant_tick)
    fail("the old holder obeys beyond the grant tick");
  if (led && !ended) {
    const std::int64_t silent = node.core.state().tick - node.fed_tick;
    if (command.controller_id != kController || bound != kController)
      fail("a controller that was not obeyed ends a stop plan");
    if (silent > kResumePeriods) fail("a controller that was silent for long ends its stop plan");
    if (node.core.state().tick - command.tick > node.usual_age + 2)
      fail("a command from before the silence ends a stop plan");
    if (node.plan_stopped) fail("a stop plan is ended in spite of a stop");
  }
  node.usual_age = node.core.state().tick - command.tick;
  node.fed_tick = node.core.state().tick;
  node.fed = true;
  node.cleared = false;
  auto& owner = run_of_term_[static_cast<std::size_t>(command.term) % run_of_term_.size()];
  if (owner != 0 && owner != node.run_id && !double_activation_)
    fail("two sources obey in one term");
  owner = node.run_id;
  node.last_accepted_tick = command.tick;
  node.last_accepted_term = h.term;
  node.fed_ns = now_ns_;
}

// A plan whose torques tell its number, so that what is followed can be told from what was sent.
StopPlanHead World::plan_for(const RobotState& state) const {
  StopPlanHead head;
  head.run_id = state.run_id;
  head.model_hash = state.model_hash;
  head.controller_id = kController;
  head.tick = state.tick;
  head.joints = 1;
  head.term = state.term;
  head.number = static_cast<std::int32_t>(state.tick) + 1;
  head.pieces = 2;
  head.knot_count = kPlanKnotsPerPiece + 1;
  head.spacing = static_cast<std::int16_t>(kPlanPeriods / kPlanKnotsPerPiece);
  head.joint_count = state.joint_count;
  return head;
}

void World::deliver_plan(int to, const StopPlanHead& head, int piece) {
  Node& node = nodes_[static_cast<std::size_t>(to)];
  if (!node.alive) return;
  StopPlanPiece message;
  message.head = head;
  message.piece = static_cast<std::int16_t>(piece);
  for (PlanRow& row : message.tau) row[0] = static_cast<std::int16_t>(head.number);
  for (PlanRow& row : message.q) row[0] = static_cast<std::int16_t>(std::lround(node.core.state().q[0] / kPlanPosition));
  const CommandGate& gate = node.core.gate();
  const std::int64_t before = gate.counters().plans_accepted;
  auto& heard = node.plans[static_cast<std::size_t>(head.number) % node.plans.size()];
  if (!(heard.head == head)) heard = {.head = head, .pieces = 0};
  heard.pieces |= 1 << piece;
  const bool followed = gate.plan().running();
  node.core.on_stop_plan(message, now_ns_);
  const bool whole = heard.pieces == 3;
  if (gate.counters().plans_accepted == before) return;
  const Handover& h = node.core.handover();
  if (!whole) fail("a stop plan is taken of which a piece is missing");
  if (head.run_id != node.run_id || head.term != h.term) fail("a stop plan for another run or term is taken");
  if (head.controller_id != gate.controller_id()) fail("a stop plan of a controller that is not obeyed is taken");
  if (followed) fail("another stop plan takes the place of the one that is followed");
  if (head.number < node.newest_whole) fail("an older stop plan takes the place of a newer one");
  node.newest_whole = std::max(node.newest_whole, head.number);
}

void World::send_plan(const RobotState& state, const Fault& fault) {
  if (!setting_->plans || !plans_) return;
  const StopPlanHead head = plan_for(state);
  const int n = setting_->sources;
  for (int piece = 0; piece < 2; ++piece) {
    for (int to = 0; to < n; ++to) {
      Fate fate = fate_of(fault, n + 1 + piece, to);
      if (fate == Fate::kDelivered) fate = fate_of(fault, n + 3, to);
      if (fate == Fate::kDelivered || fate == Fate::kDoubled) deliver_plan(to, head, piece);
      if (fate == Fate::kLate || fate == Fate::kDoubled) {
        late_.push_back({.plan = true, .piece = piece, .to = to, .state = {}, .body = {}, .head = head});
      }
    }
  }
}

void World::controller_hears(const RobotState& state, const Fault& fault) {
  if (!controller_alive_ || !admission_.admit(state, now_ns_)) return;
  believed_tick_ = state.tick;
  believed_ns_ = now_ns_;
  believed_grant_ = state.grant_run_id * 1000 + state.grant_tick;
  if (state.role != Role::kActive && state.role != Role::kReleasing && state.role != Role::kStopped)
    return;
  JointCommand command;
  command.tick = state.tick;
  command.run_id = state.run_id;
  command.term = state.term;
  command.model_hash = state.model_hash;
  command.controller_id = kController;
  command.joint_count = state.joint_count;
  command.flags = state.stop_kind == StopKind::kBalanced ? kCommandStopping : std::int16_t{0};
  command.q[0] = state.q[0];
  command.kp[0] = 1000.0F;
  command.kd[0] = 10.0F;
  const int n = setting_->sources;
  for (int to = 0; to < n; ++to) {
    const Fate fate = fate_of(fault, n, to);
    if (fate == Fate::kDelivered || fate == Fate::kDoubled) deliver_command(to, command);
    if (fate == Fate::kLate || fate == Fate::kDoubled) {
      late_.push_back({.command = true, .to = to, .state = {}, .body = command, .head = {}});
    }
  }
  send_plan(state, fault);
}

void World::send_request(SourceRequest request, int receivers, bool again) {
  if (!again) {
    request.sender_id = kOperator;
    request.sequence = ++sequence_;
    last_request_ = request;
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    if ((receivers & (1 << i)) == 0 || !node.alive) continue;
    if (request.action == SourceAction::kActivate && request.target_run_id == node.run_id &&
        !again) {
      ++node.activations_asked;
    }
    if (request.action == SourceAction::kSwitch && request.run_id != node.run_id &&
        node.core.handover().holds_state()) {
      node.switch_addressed_elsewhere = request.sequence;
    }
    node.core.on_source_request(request, now_ns_);
  }
}

void World::send_stop(StopKind kind, int receivers) {
  StopRequest stop;
  stop.sender_id = kOperator;
  stop.sequence = ++sequence_;
  stop.kind = kind;
  stop.reason = StopReason::kOperator;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    if ((receivers & (1 << i)) == 0 || !node.alive) continue;
    const bool led = node.core.gate().plan().running();
    node.core.on_stop(stop, now_ns_);
    node.plan_stopped = node.plan_stopped || led;
    if (kind == StopKind::kOff) {  // it forgets its plans
      node.newest_whole = -1;
      node.plans = {};
    }
    node.must_stop = std::max(node.must_stop, kind);
    node.stopped_ns = now_ns_;
    const Handover& h = node.core.handover();
    if (h.holds_state() && !h.successor_seen) stop_reached_holder_ = true;
  }
}

void World::send_clear(std::int32_t nonce, std::int64_t born_ns, int receivers) {
  StopRequest clear;
  clear.sender_id = kOperator;
  clear.sequence = ++sequence_;
  clear.stop_nonce = nonce;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    if ((receivers & (1 << i)) == 0 || !node.alive) continue;
    const StopKind before = node.core.gate().latch().kind;
    node.core.on_stop(clear, now_ns_);
    if (before == StopKind::kNone || node.core.gate().latch().latched()) continue;
    if (node.must_stop != StopKind::kNone && born_ns < node.stopped_ns) {
      fail("a stop is undone by a clear that was sent before it");
    }
    if (node.core.handover().holds_state()) {
      stop_reached_holder_ = false;
      node.fed_ns = now_ns_;
      node.cleared = true;
    }
    node.must_stop = StopKind::kNone;
  }
}

void World::apply(const Happening& happening) {
  const int subject = happening.subject;
  Node& node = nodes_[static_cast<std::size_t>(subject)];
  int holder = -1;
  for (int i = 0; i < setting_->sources; ++i) {
    if (alive(i) && source(i).handover().holds_state()) holder = i;
  }
  const std::int64_t holder_run = holder >= 0 ? nodes_[static_cast<std::size_t>(holder)].run_id : 0;
  SourceRequest request;
  request.target_run_id = node.run_id;
  request.policy = SwitchPolicy::kNow;
  switch (happening.kind) {
    case EventKind::kNone:
      return;
    case EventKind::kActivate:
      request.action = SourceAction::kActivate;
      if (holder >= 0) double_activation_ = true;
      send_request(request, happening.receivers, false);
      return;
    case EventKind::kSwitch:
      request.action = SourceAction::kSwitch;
      request.run_id = holder_run;
      send_request(request, happening.receivers, false);
      return;
    case EventKind::kSwitchElsewhere:
      request.action = SourceAction::kSwitch;
      request.run_id = kStranger;
      send_request(request, happening.receivers, false);
      return;
    case EventKind::kTrack:
    case EventKind::kShadow:
    case EventKind::kPark:
      request.action = happening.kind == EventKind::kTrack    ? SourceAction::kStandbyTrack
                       : happening.kind == EventKind::kShadow ? SourceAction::kStandbyShadow
                                                              : SourceAction::kPark;
      request.run_id = node.run_id;
      send_request(request, happening.receivers, false);
      return;
    case EventKind::kRepeatRequest:
      send_request(last_request_, happening.receivers, true);
      return;
    case EventKind::kStopHold:
    case EventKind::kStopOff:
      ++interventions;
      send_stop(happening.kind == EventKind::kStopHold ? StopKind::kHold : StopKind::kOff,
                happening.receivers);
      return;
    case EventKind::kClear:
      ++interventions;
      known_nonce_ = node.core.state().stop_nonce;
      known_nonce_ns_ = now_ns_;
      send_clear(known_nonce_, now_ns_, happening.receivers);
      return;
    case EventKind::kOldClear:
      ++interventions;
      send_clear(known_nonce_, known_nonce_ns_, happening.receivers);
      return;
    case EventKind::kCrash:
      ++interventions;
      if (node.alive && node.core.handover().holds_state()) {
        holder_crashed_ = true;
        if (node.must_stop != StopKind::kNone)
          stop_reached_holder_ = false;  // its latch went with it
      }
      node.alive = false;
      return;
    case EventKind::kRestart:
      ++interventions;
      if (!node.alive) add_node(subject);
      return;
    case EventKind::kControllerDies:
    case EventKind::kControllerReturns:
      ++interventions;
      controller_alive_ = happening.kind == EventKind::kControllerReturns;
      return;
    case EventKind::kForgedState: {
      ++interventions;
      RobotState forged = holder >= 0 ? source(holder).state() : RobotState{};
      forged.run_id = kStranger;
      forged.term += 1;
      forged.tick += 1;
      forged.role = Role::kActive;
      for (int i = 0; i < setting_->sources; ++i) deliver_state(i, forged, true);
      return;
    }
    case EventKind::kNoMorePlans:
      plans_ = false;
      return;
    case EventKind::kPlanOfOtherTerm:
    case EventKind::kPlanOfOther: {
      if (holder < 0) return;
      StopPlanHead head = plan_for(source(holder).state());
      head.number += 50;
      if (happening.kind == EventKind::kPlanOfOther) {
        head.controller_id = kOtherController;
      } else {
        head.term += 1;
      }
      for (const int piece : {0, 1}) deliver_plan(holder, head, piece);
      return;
    }
    case EventKind::kStaleCommand:
    case EventKind::kSecondController:
    case EventKind::kFutureCommand: {
      ++interventions;
      if (holder < 0) return;
      const RobotState& state = source(holder).state();
      JointCommand command;
      command.run_id = state.run_id;
      command.term = state.term;
      command.model_hash = state.model_hash;
      command.joint_count = state.joint_count;
      const bool future = happening.kind == EventKind::kFutureCommand;
      command.controller_id = happening.kind == EventKind::kSecondController ? kOtherController : kController;
      command.tick = state.tick + (future ? 5 : 0);
      command.q[0] = state.q[0];
      if (happening.kind == EventKind::kStaleCommand) {
        command.tick = state.tick - 3;
        deliver_command(holder, command);
        return;
      }
      // Beside a command of the controller that is not bound yet, the second one would be the
      // first.
      const bool led = source(holder).gate().plan().running();
      if (!future && !led && source(holder).gate().controller_id() != kController) return;
      if (!future) command.tick = led ? state.tick : source(holder).gate().last_accepted_tick() + 1;
      deliver_command(holder, command);
      return;
    }
  }
}

void World::step(int order, const Fault& fault, const Happening& happening) {
  if (fault.fate != Fate::kDelivered) ++message_faults;
  now_ns_ += kPeriod;
  const std::vector<Letter> mail = std::move(late_);
  late_.clear();
  const auto open_mail = [&] {
    for (const Letter& letter : mail) {
      if (letter.plan) {
        deliver_plan(letter.to, letter.head, letter.piece);
      } else if (letter.command) {
        deliver_command(letter.to, letter.body);
      } else if (letter.to < setting_->sources) {
        deliver_state(letter.to, letter.state, letter.on_state);
      } else {
        controller_hears(letter.state, {});
      }
    }
  };
  if (order == 0) open_mail();
  apply(happening);
  const int n = setting_->sources;
  for (int k = 0; k < n; ++k) {
    const int i = order == 0 ? k : n - 1 - k;
    Node& node = nodes_[static_cast<std::size_t>(i)];
    if (!node.alive) continue;
    node.core.begin_tick(now_ns_);
    after_tick(i);
    const RobotState state = node.core.state();
    const bool on_state = node.core.handover().holds_state();
    for (int to = 0; to <= n; ++to) {
      if (to == i || (to == n && !on_state)) continue;
      const Fate fate = fate_of(fault, i, to);
      if (fate == Fate::kDelivered || fate == Fate::kDoubled) {
        if (to < n) deliver_state(to, state, on_state);
        if (to == n) controller_hears(state, fault);
      }
      if (fate == Fate::kLate || fate == Fate::kDoubled) {
        late_.push_back(
            {.command = false, .on_state = on_state, .to = to, .state = state, .body = {}, .head = {}});
      }
    }
  }
  if (order != 0) open_mail();
  for (Node& node : nodes_) {
    if (node.alive) node.core.end_tick(now_ns_ + 3 * kPeriod / 5);
  }
  check_period();
}

std::string World::describe() const {
  static const char* const roles[] = {"-",     "parked", "active", "releasing",
                                      "track", "shadow", "stopped"};
  std::string text;
  for (int i = 0; i < setting_->sources; ++i) {
    const Handover& h = source(i).handover();
    text += "  " + std::string(1, static_cast<char>('A' + i)) + ": ";
    text += alive(i)
                ? std::string(roles[static_cast<int>(h.role)]) + " term " + std::to_string(h.term) +
                      " tick " + std::to_string(h.tick) + " holder " + std::to_string(h.holder) +
                      (h.successor != 0 ? " grants at " + std::to_string(h.grant_tick) : "") +
                      (source(i).gate().plan().running() ? " follows plan " + std::to_string(source(i).gate().plan().number()) : "") +
                      (source(i).gate().latch().latched() ? " LATCHED" : "")
                : "crashed";
  }
  return text;
}

}  // namespace twinbus::protocol
