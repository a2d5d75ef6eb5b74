// Two worlds of one digest go on alike, so that only one of them need be explored.

#include <algorithm>

#include "test/protocol/world.h"

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
    const PlanRun& plan = x.plan_;
    if (plan.assembler_.controller_ == 0 && plan.whole() == nullptr) return;
    h.add(plan.running());
    h.add(plan.since());
    h.add(plan.whole() != nullptr ? plan.whole()->head.number : 0);
    h.add(plan.assembler_.newest_number_);
    h.add(plan.assembler_.have_);
    h.add(x.fed_tick_);
    h.add(x.usual_age_);
    h.add(x.resumable_);
    h.add(x.plan_asked_);
    h.add(x.have_client_);
  }
  static void hash(Hash& h, const Source& x) {
    hash(h, x.handover_);
    hash(h, x.gate_);
    h.add(x.holder_new_);
    h.add(x.written_);
  }
};

namespace protocol {

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
    if (letter.plan) {
      h.add(letter.head.number);
      h.add(letter.piece);
    }
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
  if (setting_->plans) h.add(plans_);
  h.add(stop_reached_holder_);
  h.add(std::min(message_faults, 2));
  h.add(interventions > 0);
  h.add(ever_active_ + 2 * holder_crashed_ + 4 * gave_way_ + 8 * double_activation_);
  return h.value;
}

}  // namespace protocol
}  // namespace twinbus
