#include "bridge/handover/handover.h"

#include <algorithm>

#include "bridge/handover/switch_check.h"

namespace twinbus::inline bridge {

namespace {

constexpr std::int64_t kTicksToGrant = 6;   // from the tick of the request to the grant tick
constexpr std::int64_t kTicksToAppear = 3;  // then the grant is cancelled
constexpr std::int32_t kTicksToConvince = 3;
constexpr std::int32_t kHighestTerm = 1 << 30;  // nobody counts that far: not a term

bool holds_state_role(Role role) noexcept {
  return role == Role::kActive || role == Role::kReleasing || role == Role::kStopped;
}

bool can_be_set(const RobotState& peer) noexcept {
  return peer.source == SourceKind::kSimulator || peer.role == Role::kStandbyTrack;
}

}  // namespace

Handover::Handover(const HandoverConfig& c) noexcept : config(c) {}

void Handover::heard_state(const RobotState& state, std::int64_t now_ns) noexcept {
  if (state.run_id == config.run_id || !holds_state_role(state.role)) return;
  if (!(state.term > 0 && state.term < kHighestTerm)) {
    ++terms_ignored;
    return;
  }
  highest_term = std::max(highest_term, state.term);
  other_ns = now_ns;
  other_heard = true;
  if (!holds_state()) {
    believe(state, now_ns);
    return;
  }
  if (successor != 0 && state.run_id == successor && state.term == term + 1 &&
      state.tick >= grant_tick) {
    successor_seen = true;
    holder_tick = state.tick;
    holder_time_ns = state.time_ns;
  } else if (predecessor != 0 && state.run_id == predecessor && state.term == term + 1) {
    predecessor_ns = now_ns;
    if (state.tick > cancel_tick) ++cancels_heard;
    cancel_tick = std::max(cancel_tick, state.tick);
    holder_tick = state.tick;
    holder_time_ns = state.time_ns;
  } else if (predecessor != 0 && state.run_id == predecessor && state.term == term - 1) {
    predecessor_ns = now_ns;  // it has not seen me yet
  } else if (state.run_id == cancelled_run && state.term == term - 1) {
    // It has not seen yet that I cancelled, and will.
  } else {
    ++terms_ignored;
    note_rival(state, now_ns);
  }
}

void Handover::note_rival(const RobotState& state, std::int64_t now_ns) noexcept {
  const bool fresh = rival != 0 && now_ns - rival_ns <= config.state_timeout_ns;
  // Of several rivals one is watched at a time: if each took the other's place none would last.
  if (fresh && state.run_id != rival && state.term <= rival_term) return;
  if (!fresh || state.run_id != rival) {
    rival = state.run_id;
    rival_count = 1;
    rival_since_ns = now_ns;
  } else if (state.tick > rival_tick) {
    ++rival_count;
  } else {
    return;  // the same again
  }
  rival_tick = state.tick;
  rival_ns = now_ns;
  rival_term = state.term;
  rival_stopped = state.role == Role::kStopped;
}

// A source that is not active follows whom it believes to be.
void Handover::believe(const RobotState& state, std::int64_t now_ns) noexcept {
  const bool anything = !holds(config.off, Rule::kBelieveByRule);
  if (state.run_id == holder && state.term == term) {
    if (state.tick > holder_tick) follow(state, believed_by_rule, now_ns);
    return;
  }
  if (anything && state.term > term) {
    follow(state, true, now_ns);
    return;
  }
  const bool silent = now_ns - holder_ns >= config.silence_ns;
  if (holder == 0) {
    // Nobody known.  While listening the highest term wins.
    follow(state, asked_run == state.run_id && now_ns - asked_ns <= 2 * config.listen_ns, now_ns);
  } else if (state.run_id == holder && state.term == term + 2 && state.tick > holder_tick) {
    follow(state, true, now_ns);  // its own cancel
  } else if (state.run_id == granted_run && state.term == term + 1 && state.tick >= granted_tick) {
    follow(state, true, now_ns);
  } else if (!believed_by_rule && state.term > term && now_ns - started_ns < config.listen_ns) {
    follow(state, false, now_ns);
  } else if (silent && state.term > term && asked_run == state.run_id) {
    follow(state, true, now_ns);  // an operator activated it and nobody else was there
  } else {
    if (state.term > term || state.run_id != holder) note_rival(state, now_ns);
    const bool persistent = rival_count >= kTicksToConvince && rival == state.run_id &&
                            now_ns - rival_since_ns >= config.silence_ns;
    if (silent && persistent && state.term > term) {
      follow(state, false, now_ns);
    } else if (state.term > term || (state.term == term && state.run_id != holder)) {
      ++terms_ignored;
    }
  }
}

void Handover::follow(const RobotState& state, bool by_rule, std::int64_t now_ns) noexcept {
  if (state.run_id != holder || state.term != term) {
    new_holder = true;
    granted_run = 0;
    rival_count = 0;
  }
  holder = state.run_id;
  term = state.term;
  believed_by_rule = by_rule;
  holder_ns = now_ns;
  holder_tick = state.tick;
  holder_time_ns = state.time_ns;
  granted_run = state.role == Role::kReleasing ? state.grant_run_id : 0;
  granted_tick = state.grant_tick;
}

void Handover::heard_standby(const RobotState& state, std::int64_t now_ns) noexcept {
  if (state.run_id == config.run_id || state.run_id == 0) return;
  if (state.term > 0 && state.term < kHighestTerm)
    highest_term = std::max(highest_term, state.term);
  if (state.run_id == predecessor && state.term >= term) predecessor = 0;  // it knows: confirmed
  Peer* slot = &peers_[0];
  for (Peer& peer : peers_) {
    if (peer.state.run_id == state.run_id) {
      slot = &peer;
      break;
    }
    if (peer.heard_ns < slot->heard_ns) slot = &peer;
  }
  slot->heard_ns = now_ns;
  slot->state = state;
}

const Handover::Peer* Handover::find_peer(std::int64_t run) const noexcept {
  for (const Peer& peer : peers_) {
    if (run != 0 && peer.state.run_id == run) return &peer;
  }
  return nullptr;
}

bool Handover::first_time(const SourceRequest& request) noexcept {
  for (Sender& sender : senders_) {
    if (sender.id != request.sender_id) continue;
    if (request.sequence <= sender.sequence) return false;
    sender.sequence = request.sequence;
    return true;
  }
  senders_[next_sender_] = {request.sender_id, request.sequence};
  next_sender_ = (next_sender_ + 1) % static_cast<unsigned>(kSenders);
  return true;
}

bool Handover::alone(std::int64_t now_ns) const noexcept {
  return !other_heard || now_ns - other_ns >= config.silence_ns;
}

void Handover::refuse(Refusal why, std::int32_t sequence) noexcept {
  refusal = why;
  refusal_sequence = sequence;
  if (why != Refusal::kNone) ++refusals;
}

Refusal Handover::activation_refusal(const HandoverInput& input,
                                     std::int64_t now_ns) const noexcept {
  if (holds_state()) return Refusal::kAlreadyActive;
  if (input.stop_kind != StopKind::kNone) return Refusal::kStopped;
  if (!input.device_ok) return Refusal::kDevice;
  if (!alone(now_ns) && holds(config.off, Rule::kActivateAlone)) return Refusal::kAnotherActive;
  const bool other_asked = asked_run != 0 && now_ns - asked_ns < config.silence_ns;
  return other_asked ? Refusal::kAnotherActive : Refusal::kNone;
}

Refusal Handover::role_refusal(const SourceRequest& request) const noexcept {
  if (holds_state()) return Refusal::kAlreadyActive;
  if (request.action == SourceAction::kStandbyTrack && !config.can_be_set)
    return Refusal::kCannotBeSet;
  return Refusal::kNone;
}

Refusal Handover::switch_refusal(const HandoverInput& input, std::int64_t now_ns) const noexcept {
  if (pending.target_run_id == config.run_id) return Refusal::kAlreadyActive;
  if (has_granted && now_ns - last_grant_ns < config.switch_interval_ns &&
      holds(config.off, Rule::kSwitchRate)) {
    return Refusal::kBusy;
  }
  if (!holds(config.off, Rule::kSwitchChecked)) return Refusal::kNone;
  if (input.stop_kind != StopKind::kNone) return Refusal::kStopped;
  const Peer* peer = find_peer(pending.target_run_id);
  if (peer == nullptr) return Refusal::kUnknownTarget;
  const RobotState& target = peer->state;
  if (target.model_hash != config.model_hash) return Refusal::kModelHash;
  if (target.period_ns != config.period_ns) return Refusal::kPeriod;
  if (now_ns - peer->heard_ns > config.state_timeout_ns || !input.device_ok) return Refusal::kStale;
  if (target.stop_kind != StopKind::kNone) return Refusal::kStopped;
  if (!config.real_time && target.source == SourceKind::kBridge) return Refusal::kPace;
  if ((target.sensor_flags & kEncodersValid) == 0) return Refusal::kDevice;
  const bool standby = target.role == Role::kStandbyTrack || target.role == Role::kStandbyShadow;
  if (!standby && !can_be_set(target)) return Refusal::kNotStandby;
  if (!can_be_set(target)) {
    const Refusal difference = compare_measured(*input.measured, target);
    if (difference != Refusal::kNone) return difference;
  }
  // Nobody takes over in mid-step from hardware, nor hardware from anybody.
  const bool to_hardware = !can_be_set(target);
  const bool in_step =
      input.walking &&
      (to_hardware || (config.hardware && pending.policy == SwitchPolicy::kWhenSafe));
  const bool unsettled = !input.stable && (config.hardware || (to_hardware && wants_rest));
  return in_step || unsettled ? Refusal::kUnstable : Refusal::kNone;
}

void Handover::request(const SourceRequest& request, const HandoverInput& input,
                       std::int64_t now_ns) noexcept {
  const bool for_me = request.target_run_id == config.run_id;
  if (request.action == SourceAction::kActivate && !for_me) {
    if (!first_time(request)) return;
    if (holds(config.off, Rule::kActivateAsked)) {
      asked_run = request.target_run_id;
      asked_ns = now_ns;
      return;
    }
  }
  if (request.action == SourceAction::kSwitch) {
    if (request.run_id != config.run_id && holds(config.off, Rule::kSwitchAddressed)) return;
    if (!first_time(request)) return;
    // Operators repeat a request that may have been lost: one that is under way or done is no
    // second one.
    const std::int64_t under_way = pending_switch ? pending.target_run_id : successor;
    if (request.target_run_id == under_way && under_way != 0) return;
    if (!holds_state() && request.target_run_id == holder) return;
    if (!holds_state()) return refuse(Refusal::kNotAddressed, request.sequence);
    if (under_way != 0) return refuse(Refusal::kBusy, request.sequence);
    refuse(Refusal::kNone, request.sequence);
    pending = request;
    pending_switch = true;
    pending_since_ns = now_ns;
    return;
  }
  if (request.action == SourceAction::kActivate) {
    if (for_me && (!first_time(request) || pending_activation)) return;
    if (request.run_id != 0 && request.run_id != config.run_id) {
      return refuse(Refusal::kNotAddressed, request.sequence);
    }
    const Refusal why = activation_refusal(input, now_ns);
    refuse(why, request.sequence);
    pending_activation = why == Refusal::kNone;
    return;
  }
  if (!for_me || !first_time(request)) return;
  const Refusal why = role_refusal(request);
  refuse(why, request.sequence);
  if (why != Refusal::kNone) return;
  if (request.action == SourceAction::kStandbyTrack) asked_role_ = Role::kStandbyTrack;
  if (request.action == SourceAction::kStandbyShadow) asked_role_ = Role::kStandbyShadow;
  if (request.action == SourceAction::kPark) asked_role_ = Role::kParked;
}

void Handover::start_term(std::int32_t new_term, std::int64_t now_ns) noexcept {
  term = new_term;
  highest_term = std::max(highest_term, term);
  holder = config.run_id;
  holder_ns = now_ns;
  granted_run = 0;
  successor = 0;
  grant_tick = 0;
  successor_seen = false;
  predecessor = 0;
  cancels_heard = 0;
  cancel_tick = 0;
  rival_count = 0;
  pending_switch = false;
  pending_activation = false;
  wants_rest = false;
  asked_role_ = Role::kNone;
}

void Handover::leave_to(std::int64_t new_holder_run, std::int32_t new_term,
                        std::int64_t now_ns) noexcept {
  start_term(new_term, now_ns);
  holder = new_holder_run;
  believed_by_rule = true;
  counted_holder_tick = holder_tick;
  role = role_after;
}

Transition Handover::begin_tick(const HandoverInput& input, std::int64_t now_ns) noexcept {
  if (!started) {
    started = true;
    started_ns = now_ns;
  }
  return holds_state() ? tick_holding(input, now_ns) : tick_waiting(input, now_ns);
}

Transition Handover::tick_holding(const HandoverInput& input, std::int64_t now_ns) noexcept {
  ++tick;
  time_ns += config.period_ns;
  const bool stopped = input.stop_kind != StopKind::kNone;
  Transition happened = Transition::kNone;

  if (predecessor != 0) {
    if (cancels_heard >= 2 && holds(config.off, Rule::kStandDown)) {
      leave_to(predecessor, term + 1, now_ns);
      return Transition::kStoodDown;
    }
    if (now_ns - predecessor_ns >= config.silence_ns) predecessor = 0;
  }
  if (stopped && rival_count >= kTicksToConvince && now_ns - rival_ns <= config.state_timeout_ns &&
      holds(config.off, Rule::kGiveWay)) {
    const bool lower = rival_term > term || (rival_term == term && rival > config.run_id);
    if (rival_stopped ? lower : !input.stop_was_asked) {
      holder_tick = rival_tick;
      role_after = Role::kParked;
      leave_to(rival, rival_term, now_ns);
      believed_by_rule = false;
      return Transition::kGaveWay;
    }
  }
  if (successor != 0) {
    const bool stop_revokes = stopped && holds(config.off, Rule::kStopRevokesGrant);
    const bool overdue =
        tick >= grant_tick + kTicksToAppear && holds(config.off, Rule::kCancelSilent);
    if (successor_seen && !stop_revokes && holds(config.off, Rule::kReleaseOnSuccessor)) {
      leave_to(successor, term + 1, now_ns);
      return Transition::kReleased;
    }
    if (stop_revokes || overdue) {
      refuse(stop_revokes ? Refusal::kStopped : Refusal::kStale, pending.sequence);
      cancelled_run = successor;
      start_term(holds(config.off, Rule::kCancelRaisesTerm) ? term + 2 : term, now_ns);
      happened = Transition::kCancelled;
    }
  } else if (pending_switch) {
    happened = tick_grant(input, now_ns);
  }
  role = stopped ? Role::kStopped : successor != 0 ? Role::kReleasing : Role::kActive;
  return happened;
}

Transition Handover::tick_grant(const HandoverInput& input, std::int64_t now_ns) noexcept {
  const Refusal why = switch_refusal(input, now_ns);
  if (why == Refusal::kNone) {
    successor = pending.target_run_id;
    successor_seen = false;
    grant_tick = tick + kTicksToGrant - 1;
    pending_switch = false;
    wants_rest = false;
    last_grant_ns = now_ns;
    has_granted = true;
    return Transition::kGranted;
  }
  const bool differs = why >= Refusal::kPosture && why <= Refusal::kLoad;
  const bool rest_helps = pending.policy != SwitchPolicy::kNow &&
                          (why == Refusal::kUnstable || (differs && (input.walking || wants_rest)));
  const bool aligning = pending.align && (why == Refusal::kNotStandby || differs);
  const Peer* target = find_peer(pending.target_run_id);
  // The machine stood still, and the target will be heard again.
  if (why == Refusal::kStale && input.device_ok && target != nullptr && now_ns - target->heard_ns <= config.late_ns)
    return Transition::kNone;
  if ((rest_helps || aligning) && now_ns - pending_since_ns < config.when_safe_ns) {
    wants_rest = rest_helps;
    return Transition::kNone;
  }
  pending_switch = false;
  wants_rest = false;
  refuse(why, pending.sequence);
  return Transition::kNone;
}

Transition Handover::tick_waiting(const HandoverInput& input, std::int64_t now_ns) noexcept {
  Transition happened = new_holder ? Transition::kNewHolder : Transition::kNone;
  if (holder != 0 && holder_tick > counted_holder_tick) {
    tick = holder_tick + 1;
    time_ns = holder_time_ns + config.period_ns;
    counted_holder_tick = holder_tick;
  } else if (new_holder) {
    counted_holder_tick = holder_tick;
    tick = holder_tick + 1;
    time_ns = holder_time_ns + config.period_ns;
  } else {
    ++tick;
    time_ns += config.period_ns;
  }
  if (new_holder && !believed_by_rule && role == Role::kStandbyShadow) {
    role = Role::kParked;
    happened = Transition::kParked;
  }
  new_holder = false;
  if (holder != 0 && now_ns - holder_ns >= config.listen_ns) holder = 0;  // forgotten

  if (asked_role_ != Role::kNone) {
    role = asked_role_;
    asked_role_ = Role::kNone;
    happened = role == Role::kParked ? Transition::kParked : Transition::kStandby;
  }
  const bool named =
      granted_run == config.run_id || (granted_run != 0 && !holds(config.off, Rule::kGrantNamed));
  if (holder != 0 && named) {
    if (role == Role::kParked && config.can_be_set) {
      role = Role::kStandbyTrack;
      happened = Transition::kStandby;
    }
    const bool time =
        (tick >= granted_tick || !holds(config.off, Rule::kGrantTick)) &&
        (tick < granted_tick + kTicksToAppear || !holds(config.off, Rule::kGrantFresh));
    const bool fresh = holder_tick >= granted_tick - kTicksToAppear ||
                       !holds(config.off, Rule::kGrantFresh) ||
                       !holds(config.off, Rule::kGrantTick);
    // A standby that woke late counts one tick ahead until STATE comes again; taking over then would
    // leave the holder's last tick to nobody.
    const bool heard_last = holder_tick >= granted_tick - 1 ||
                            tick >= granted_tick + kTicksToAppear - 1 ||
                            !holds(config.off, Rule::kGrantTick);
    const bool free =
        input.stop_kind == StopKind::kNone || !holds(config.off, Rule::kStoppedStaysOut);
    if (role != Role::kParked && time && fresh && heard_last && free && input.device_ok) {
      const std::int64_t from = holder;
      role_after = role;
      start_term(term + 1, now_ns);
      predecessor = from;
      predecessor_ns = now_ns;
      // The limit is the robot's: who has taken over waits as who has granted.
      last_grant_ns = now_ns;
      has_granted = true;
      role = Role::kActive;
      return Transition::kTookOver;
    }
  }
  const bool listened =
      now_ns - started_ns >= config.listen_ns || !holds(config.off, Rule::kListenFirst);
  if (pending_activation && listened) {
    pending_activation = false;
    const Refusal why = activation_refusal(input, now_ns);
    if (why != Refusal::kNone) {
      refuse(why, refusal_sequence);
      return happened;
    }
    if (!other_heard) {
      tick = 1;
      time_ns = config.period_ns;
    }
    role_after = role == Role::kParked && config.can_be_set ? Role::kStandbyTrack : role;
    start_term(holds(config.off, Rule::kTermAdvances) ? highest_term + 1 : term, now_ns);
    role = Role::kActive;
    return Transition::kActivated;
  }
  return happened;
}

}  // namespace twinbus::bridge
