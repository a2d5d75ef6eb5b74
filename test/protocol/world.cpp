#include "test/protocol/world.h"

#include <algorithm>

namespace twinbus {

// Everything that decides what a source does next; set-points and counters are left out.
struct ProtocolProbe {
  struct Hash {
    std::uint64_t value = 0xcbf29ce484222325ULL;
    template <class T>
    void add(T x) {
      value ^= static_cast<std::uint64_t>(x) + 0x9e3779b97f4a7c15ULL + (value << 6) + (value >> 2);
      value *= 0xff51afd7ed558ccdULL;
      value ^= value >> 32;
    }
  };
  static void hash(Hash& h, const Handover& x) {
    for (const std::int64_t v : {x.tick,
                                 x.time_ns,
                                 x.holder,
                                 x.holder_ns,
                                 x.holder_tick,
                                 x.granted_run,
                                 x.granted_tick,
                                 x.other_ns,
                                 x.successor,
                                 x.grant_tick,
                                 x.predecessor,
                                 x.predecessor_ns,
                                 x.cancel_tick,
                                 x.cancelled_run,
                                 x.last_grant_ns,
                                 x.pending_since_ns,
                                 x.rival,
                                 x.rival_tick,
                                 x.rival_ns,
                                 x.rival_since_ns,
                                 x.asked_run,
                                 x.asked_ns,
                                 x.counted_holder_tick,
                                 x.pending.target_run_id}) {
      h.add(v);
    }
    for (const std::int32_t v :
         {x.term, x.highest_term, x.cancels_heard, x.rival_term, x.rival_count})
      h.add(v);
    for (const bool v :
         {x.believed_by_rule, x.new_holder, x.other_heard, x.successor_seen, x.has_granted,
          x.pending_switch, x.wants_rest, x.pending_activation, x.rival_stopped}) {
      h.add(v);
    }
    h.add(x.role);
    h.add(x.role_after);
    h.add(x.asked_role_);
    for (const auto& peer : x.peers_) {
      h.add(peer.heard_ns);
      h.add(peer.state.run_id);
      h.add(peer.state.role);
      h.add(peer.state.stop_kind);
    }
    for (const auto& sender : x.senders_) h.add(sender.sequence);
  }
  static void hash(Hash& h, const CommandGate& x) {
    for (const std::int64_t v : {x.run_id_, x.controller_, x.next_controller_, x.last_tick_,
                                 x.last_accepted_ns_, x.stop_since_ns_}) {
      h.add(v);
    }
    h.add(x.term_);
    h.add(x.open_);
    h.add(x.watched_);
    h.add(x.ticks_without_stopping_);
    h.add(x.latch_.kind);
    h.add(x.latch_.reason);
    h.add(x.latch_.nonce);
    h.add(x.latch_.shared_nonce);
    h.add(x.latch_.spent_nonce);
  }
  static void hash(Hash& h, const SourceCore& x) {
    hash(h, x.handover_);
    hash(h, x.gate_);
    h.add(x.holder_new_);
    h.add(x.written_);
  }
};

namespace protocol {

namespace {

constexpr std::int64_t kController = 7;
constexpr std::int64_t kOtherController = 8;
constexpr std::int64_t kStranger = 999;  // the run of a forged STATE
constexpr std::int64_t kOperator = 5;
constexpr std::int64_t kTimeoutPeriods = 4;

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

Setting::Setting(int n, bool target_is_hardware, double target_q, RuleSet rules_off)
    : sources(n), off(rules_off), model(small_model()), limits(model) {
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
  Node node(SourceCore(setting_->model, setting_->limits, robot, setting_->source_config(i, run),
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
  node.core.on_command(command, now_ns_);
  if (!holding || node.core.gate().counters().accepted == before) return;
  // It obeyed.
  const Handover& h = node.core.handover();
  if (command.run_id != node.run_id) fail("a source obeys a command that is for another source");
  if (command.term != h.term) fail("a source obeys a command of another term");
  if (command.controller_id == kOtherController && command.tick > 0 &&
      node.last_accepted_tick >= 0 && node.last_accepted_term == h.term) {
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
  auto& owner = run_of_term_[static_cast<std::size_t>(command.term) % run_of_term_.size()];
  if (owner != 0 && owner != node.run_id && !double_activation_)
    fail("two sources obey in one term");
  owner = node.run_id;
  node.last_accepted_tick = command.tick;
  node.last_accepted_term = h.term;
  node.fed_ns = now_ns_;
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
      late_.push_back({.command = true, .to = to, .state = {}, .body = command});
    }
  }
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
    node.core.on_stop(stop, now_ns_);
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
      command.controller_id = future ? kController : kOtherController;
      command.tick = state.tick + (future ? 5 : 0);
      command.q[0] = state.q[0];
      // Beside a command of the controller that is not bound yet, the second one would be the
      // first.
      if (!future && source(holder).gate().controller_id() != kController) return;
      if (!future) command.tick = source(holder).gate().last_accepted_tick() + 1;
      deliver_command(holder, command);
      return;
    }
  }
}

void World::after_tick(int i) {
  Node& node = nodes_[static_cast<std::size_t>(i)];
  const Handover& h = node.core.handover();
  const Transition transition = node.core.last_transition();
  if (node.role_before == h.role && h.refusals != node.refusals_before &&
      h.term != node.term_before && transition == Transition::kNone) {
    fail("a refused request changes the term");
  }
  switch (transition) {
    case Transition::kActivated:
      ever_active_ = true;
      node.fed_ns = now_ns_;
      if (--node.activations_asked < 0) fail("an activation nobody asked for");
      if (now_ns_ - node.born_ns < 9 * kPeriod)
        fail("an activation before the listening time is over");
      if (node.heard_state_ns >= 0 && now_ns_ - node.heard_state_ns < 4 * kPeriod) {
        fail("an activation while another source is heard");
      }
      if (h.term <= node.highest_term) fail("an activation in a term that has been heard before");
      if (node.must_stop != StopKind::kNone) fail("a stopped source becomes active");
      break;
    case Transition::kTookOver: {
      ever_active_ = true;
      node.fed_ns = now_ns_;
      const Grant* grant = nullptr;
      for (const Grant& g : grants_) {
        if (g.run == node.run_id && g.term == h.term - 1) grant = &g;
      }
      if (grant == nullptr) {
        fail("a source takes over that was not granted the term");
      } else if (h.tick < grant->tick) {
        fail("a source takes over before the grant tick");
      } else if (h.tick >= grant->tick + 3) {
        fail("a source takes over after the grant has run out");
      }
      if (node.must_stop != StopKind::kNone) fail("a stopped source takes over");
      break;
    }
    case Transition::kGranted: {
      grants_[next_grant_] = {h.successor, h.grant_tick, h.term};
      next_grant_ = (next_grant_ + 1) % static_cast<unsigned>(grants_.size());
      if (node.last_grant_ns >= 0 && now_ns_ - node.last_grant_ns < 12 * kPeriod)
        fail("switches too fast");
      node.last_grant_ns = now_ns_;
      const int target = index_of(h.successor);
      if (target >= 0) {
        const StillRobot& robot = setting_->robots[static_cast<std::size_t>(target)];
        const double gap = source(target).state().q[0] - node.core.state().q[0];
        if (robot.is_hardware() && !(gap * gap <= 0.05 * 0.05))
          fail("a grant in spite of another posture");
      }
      if (node.must_stop != StopKind::kNone) fail("a stopped source grants");
      if (h.pending.run_id != node.run_id)
        fail("a switch that named another active source is obeyed");
      break;
    }
    case Transition::kCancelled:
      node.fed_ns = now_ns_;
      if (h.term != node.term_before + 2) fail("a cancel that nobody can tell from the old term");
      break;
    case Transition::kReleased:
      if (node.must_stop != StopKind::kNone) fail("a stopped source hands over");
      break;
    case Transition::kGaveWay:
      gave_way_ = true;
      if (node.core.gate().latch().kind == StopKind::kNone) fail("a source that obeys gives way");
      break;
    default:
      break;
  }
  node.highest_term = std::max(node.highest_term, h.term);
  node.role_before = h.role;
  node.term_before = h.term;
  node.refusals_before = h.refusals;
}

void World::check_period() {
  for (int i = 0; i < setting_->sources; ++i) {
    if (!alive(i)) continue;
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    const Handover& h = node.core.handover();
    const StopLatch& latch = node.core.gate().latch();
    if (latch.kind < node.must_stop) fail("a stop is lost or lowered");
    if (h.holds_state() && h.obeys() && !latch.latched() &&
        now_ns_ - node.fed_ns > (kTimeoutPeriods + 1) * kPeriod) {
      fail("a source without commands does not stop");
    }
    const bool heard = node.heard_state_ns >= 0 && now_ns_ - h.holder_ns < 4 * kPeriod;
    if (!h.holds_state() && h.holder == kStranger && heard && holders() > 0 && ever_active_ &&
        now_ns_ > 0 && h.believed_by_rule) {
      fail("a forged term is believed");
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
      if (letter.command) {
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
            {.command = false, .on_state = on_state, .to = to, .state = state, .body = {}});
      }
    }
  }
  if (order != 0) open_mail();
  for (Node& node : nodes_) {
    if (node.alive) node.core.end_tick(now_ns_ + 3 * kPeriod / 5);
  }
  check_period();
}

void World::judge_the_end() {
  const bool controller_was_dead = !controller_alive_;
  quiet(60);
  if (!violation_.empty()) return;
  int n = holders();
  for (const Node& node : nodes_) {
    // Somebody stopped it: it stays, stopped, until he clears it.
    n -= n > 1 && node.alive && node.core.handover().holds_state() &&
         node.must_stop != StopKind::kNone;
  }
  if (n > 1) return fail("with messages getting through, two sources stay on STATE");
  if (n == 0) {
    if (ever_active_ && !holder_crashed_ && !gave_way_) {
      fail("no source is left on STATE and nobody crashed or gave way");
    }
    return;
  }
  for (int i = 0; i < setting_->sources; ++i) {
    if (!alive(i) || !source(i).handover().holds_state()) continue;
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    const Role role = node.core.handover().role;
    const StopLatch& latch = node.core.gate().latch();
    if (role == Role::kReleasing) fail("a switch never ends");
    if (stop_reached_holder_ && !latch.latched() && holders() == 1)
      fail("a stop is lost by handing over");
    const bool fed = now_ns_ - node.fed_ns <= 2 * kPeriod;
    if (!latch.latched() && !fed && !controller_was_dead)
      fail("the active source is not commanded");
    if (interventions == 0 && message_faults <= 1 && latch.latched()) {
      fail("a single lost, doubled or late message ends in a stop");
    }
  }
  if (interventions > 0 || message_faults > 1) return;
  for (int i = 0; i < setting_->sources; ++i) {
    if (alive(i) && source(i).gate().latch().latched())
      fail("a single faulty message leaves a source stopped");
  }
}

std::uint64_t World::digest() const {
  ProtocolProbe::Hash h;
  for (const Node& node : nodes_) {
    h.add(node.alive);
    h.add(node.run_id);
    if (!node.alive) continue;
    ProtocolProbe::hash(h, node.core);
    h.add(node.must_stop);
    h.add(node.activations_asked);
    h.add(node.fed_ns);
    h.add(node.last_accepted_tick);
    h.add(node.heard_state_ns);
    h.add(node.stopped_ns);
  }
  for (const Letter& letter : late_) {
    h.add(letter.command);
    h.add(letter.to);
    h.add(letter.command ? letter.body.tick : letter.state.tick);
    h.add(letter.command ? letter.body.run_id : letter.state.run_id);
    h.add(letter.state.role);
  }
  for (const std::int64_t v :
       {admission_.run_id(), static_cast<std::int64_t>(admission_.term()), believed_tick_,
        believed_ns_, believed_grant_, last_request_.target_run_id}) {
    h.add(v);
  }
  h.add(known_nonce_);
  h.add(controller_alive_);
  h.add(stop_reached_holder_);
  h.add(std::min(message_faults, 2));
  h.add(interventions > 0);
  h.add(ever_active_ + 2 * holder_crashed_ + 4 * gave_way_ + 8 * double_activation_);
  return h.value;
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
                      (source(i).gate().latch().latched() ? " LATCHED" : "")
                : "crashed";
  }
  return text;
}

}  // namespace protocol
}  // namespace twinbus
