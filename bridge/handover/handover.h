// Who is active: roles, terms and grants of one source, as doc/protocol.md section 4 says.  Pure and
// copyable.
//
// What is heard only leaves evidence; the role changes in begin_tick() and nowhere else, so that no
// message can move a source twice in one tick.  Rules this adds to doc/protocol.md, each found by the
// explorer in test/protocol:
//
//  * A grant counts for the target only while it is fresh: the target takes over if it has heard
//    the holder, with the grant, within the three ticks before the grant tick.  Three ticks later
//    the holder has cancelled.  Until two ticks after the grant tick it waits for the holder's last
//    tick, so that a standby that counts ahead or a holder that is late loses none.
//  * Until the old holder shows the new term on its own channel (or has been silent for 0.1 s), the
//    successor is unconfirmed, and only an unconfirmed successor stands down for a cancel.
//  * A stop at the old holder before it has seen its successor cancels the switch, term + 2, at
//    once: the stop is not lost by handing over.  A stop latches in every role; a source with a
//    latched stop does not take over.
//  * Two sources that both publish on STATE (activated in two halves of a split network): the one
//    whose commands ran out gives way when it hears the other for three ticks.  One that obeys
//    commands never does, so no old log can depose it; nor does one that somebody stopped, so no
//    stop is lost, unless the other is stopped too and higher in (term, run).  Of several rivals one is watched at a time, until
//    it is silent or another has a higher term.
//  * A holder that has been silent for the listening time is forgotten.  A shadow follows a new
//    holder only if its term was believed by grant, cancel or activation; otherwise it parks, so
//    that an old log cannot move a robot that shadows.
//  * A robot changes its source at most once in 0.8 s: neither who granted nor who took over grants
//    again before.  A request is obeyed once: its sequence must be higher than
//    the last of that sender.

#pragma once

#include <array>
#include <cstdint>

#include "bridge/handover/rules.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus {
struct ProtocolProbe;
}  // namespace twinbus

namespace twinbus::inline bridge {

struct HandoverConfig {
  std::int64_t run_id = 1;
  std::int64_t model_hash = 0;
  std::int32_t period_ns = 2'000'000;
  bool can_be_set = false;
  bool hardware = true;
  bool real_time = true;
  std::int64_t state_timeout_ns = 25'000'000;
  std::int64_t listen_ns = 1'000'000'000;
  std::int64_t silence_ns = 100'000'000;
  std::int64_t switch_interval_ns = 800'000'000;
  std::int64_t when_safe_ns = 8'000'000'000;  // how long a safe moment is waited for
  std::int64_t late_ns = 200'000'000;         // a target that was heard so recently is late, and waited for
  RuleSet off = 0;
};

enum class Transition : std::int8_t {
  kNone = 0,
  kActivated,  // by request, no source was active
  kTookOver,   // by grant
  kGranted,
  kReleased,   // the successor was seen
  kCancelled,  // it was not, or a stop came between
  kStoodDown,  // the old holder cancelled
  kGaveWay,    // another source is on STATE and this one is stopped
  kStandby,    // asked for
  kParked,     // asked for, or a shadow has lost whom it followed
  kNewHolder,  // somebody else is active now, or in a new term
};

// What the source knows about itself when a tick begins.
struct HandoverInput {
  const RobotState* measured = nullptr;  // published last
  StopKind stop_kind = StopKind::kNone;
  bool stop_was_asked = false;  // by somebody, not drawn by the gate itself
  bool device_ok = true;
  bool stable = true;    // could be left as it stands
  bool walking = false;  // the controller walks: a moment later it may stand
};

struct Handover {
  explicit Handover(const HandoverConfig& config) noexcept;

  // Evidence.
  void heard_state(const RobotState& state, std::int64_t now_ns) noexcept;  // on STATE, another run
  void heard_standby(const RobotState& state, std::int64_t now_ns) noexcept;  // on its own channel
  // Answers at once with a refusal (see refusal below) or leaves something to do for begin_tick().
  void request(const SourceRequest& request, const HandoverInput& input,
               std::int64_t now_ns) noexcept;

  // Once per tick, before the robot is read: numbers the tick and moves the role.
  Transition begin_tick(const HandoverInput& input, std::int64_t now_ns) noexcept;

  bool holds_state() const noexcept {
    return role == Role::kActive || role == Role::kReleasing || role == Role::kStopped;
  }
  // As active, up to the grant tick.
  bool obeys() const noexcept {
    return holds_state() && (successor == 0 || tick < grant_tick ||
                             !holds(config.off, Rule::kOldHolderStopsObeying));
  }
  bool holder_fresh(std::int64_t now_ns) const noexcept {
    return holder != 0 && now_ns - holder_ns <= config.state_timeout_ns;
  }

  HandoverConfig config;
  Role role = Role::kParked;
  std::int64_t tick = 0;  // of the state being published
  std::int64_t time_ns = 0;
  std::int32_t term = 0;  // mine when I hold it, else the believed holder's

  // The believed holder.
  std::int64_t holder = 0;     // 0: none known
  std::int64_t holder_ns = 0;  // last heard
  std::int64_t holder_tick = 0;
  std::int64_t holder_time_ns = 0;
  std::int64_t granted_run = 0;  // by the holder, as last heard
  std::int64_t granted_tick = 0;
  bool believed_by_rule = false;  // grant, cancel or activation; not mere persistence
  bool new_holder = false;        // since the last tick
  std::int32_t highest_term = 0;  // heard of at all
  std::int64_t other_ns = 0;      // STATE of anybody else, last heard
  bool other_heard = false;

  // While I hold STATE.
  std::int64_t successor = 0;  // granted to, 0 none
  std::int64_t grant_tick = 0;
  bool successor_seen = false;
  std::int64_t predecessor = 0;  // took over from, unconfirmed; 0: confirmed
  std::int64_t predecessor_ns = 0;
  std::int32_t cancels_heard =
      0;  // of the predecessor, on different ticks; one datagram is not enough
  std::int64_t cancel_tick = 0;
  std::int64_t cancelled_run = 0;   // whose grant I cancelled last
  Role role_after = Role::kParked;  // standby I go back to
  std::int64_t last_grant_ns = 0;
  bool has_granted = false;

  // A switch that waits for a safe moment, or for the target to align.
  SourceRequest pending{};
  bool pending_switch = false;
  bool wants_rest = false;  // the controller should come to rest
  std::int64_t pending_since_ns = 0;
  bool pending_activation = false;

  // Another run claims STATE.
  std::int64_t rival = 0, rival_tick = 0;
  std::int64_t rival_ns = 0, rival_since_ns = 0;
  std::int32_t rival_term = 0, rival_count = 0;
  bool rival_stopped = false;
  std::int64_t terms_ignored = 0;

  // An activation of somebody else, heard.
  std::int64_t asked_run = 0;
  std::int64_t asked_ns = 0;

  Refusal refusal = Refusal::kNone;
  std::int32_t refusal_sequence = 0;
  std::int64_t refusals = 0;

  std::int64_t started_ns = 0;
  bool started = false;
  std::int64_t counted_holder_tick = 0;  // holder_tick at the last begin_tick

 private:
  friend struct twinbus::ProtocolProbe;  // test/protocol looks inside to tell states apart
  struct Peer {
    std::int64_t heard_ns = 0;
    RobotState state{};
  };
  struct Sender {
    std::int64_t id = 0;
    std::int32_t sequence = 0;
  };
  static constexpr std::size_t kPeers = 4;
  static constexpr std::size_t kSenders = 8;

  void believe(const RobotState& state, std::int64_t now_ns) noexcept;
  void follow(const RobotState& state, bool by_rule, std::int64_t now_ns) noexcept;
  void note_rival(const RobotState& state, std::int64_t now_ns) noexcept;
  bool first_time(const SourceRequest& request) noexcept;
  const Peer* find_peer(std::int64_t run) const noexcept;
  bool alone(std::int64_t now_ns) const noexcept;
  void refuse(Refusal why, std::int32_t sequence) noexcept;
  Refusal activation_refusal(const HandoverInput& input, std::int64_t now_ns) const noexcept;
  Refusal switch_refusal(const HandoverInput& input, std::int64_t now_ns) const noexcept;
  Refusal role_refusal(const SourceRequest& request) const noexcept;
  void become(Role next) noexcept;
  void start_term(std::int32_t new_term, std::int64_t now_ns) noexcept;
  void leave_to(std::int64_t new_holder, std::int32_t new_term, std::int64_t now_ns) noexcept;
  Transition tick_holding(const HandoverInput& input, std::int64_t now_ns) noexcept;
  Transition tick_waiting(const HandoverInput& input, std::int64_t now_ns) noexcept;
  Transition tick_grant(const HandoverInput& input, std::int64_t now_ns) noexcept;

  std::array<Peer, kPeers> peers_{};
  std::array<Sender, kSenders> senders_{};
  unsigned next_sender_ = 0;
  Role asked_role_ = Role::kNone;
};

}  // namespace twinbus::bridge
