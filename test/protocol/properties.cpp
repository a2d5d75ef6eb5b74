// What must hold in every period, and where the world must end once messages get through again.

#include <algorithm>

#include "test/protocol/world.h"

namespace twinbus::protocol {

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
    Node& node = nodes_[static_cast<std::size_t>(i)];
    check_plan(node);
    const Handover& h = node.core.handover();
    const StopLatch& latch = node.core.gate().latch();
    if (latch.kind < node.must_stop) fail("a stop is lost or lowered");
    if (h.holds_state() && h.obeys() && !latch.latched() && !node.core.gate().plan().running() &&
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

// At the end of a period, of the stop plan that is followed or should be.
void World::check_plan(Node& node) {
  if (!setting_->plans) return;
  const CommandGate& gate = node.core.gate();
  const std::int64_t tick = node.core.state().tick;
  const Handover& h = node.core.handover();
  const bool fed = node.fed;
  node.fed = false;
  const bool obeys = h.holds_state() && h.obeys() && gate.is_open();
  const std::int32_t before = node.followed;
  node.followed = gate.plan().number();
  if (node.followed != 0 && (before == 0 || before != node.followed)) {
    const auto& heard = node.plans[static_cast<std::size_t>(node.followed) % node.plans.size()];
    if (heard.head.number != node.followed || heard.pieces != 3) fail("a stop plan is followed of which a piece is missing");
    if (heard.head.run_id != node.run_id || heard.head.term != h.term) fail("a stop plan for another run or term is followed");
    if (tick - heard.head.tick > kResumePeriods) fail("a stop plan is followed that began long ago");
    if (node.followed < node.newest_whole) fail("a stop plan is followed although a newer one is there");
  }
  if (before != 0 && node.followed != 0 && before != node.followed && !fed)
    fail("another stop plan takes the place of the one that is followed");
  if (node.followed != 0) {
    if (gate.latch().kind == StopKind::kOff) fail("a stop plan is followed in spite of off");
    const StopPlan& plan = *gate.plan().whole();
    for (int k = 0; k < plan.head.knot_count; ++k) {
      if (plan.tau[static_cast<std::size_t>(k)][0] != static_cast<std::int16_t>(plan.head.number))
        fail("a stop plan is followed that is made of pieces of two");
    }
  } else {
    const auto& ended = node.plans[static_cast<std::size_t>(before) % node.plans.size()];
    if (before != 0 && !fed && obeys && ended.head.term == h.term && !gate.latch().latched())
      fail("the end of a stop plan does not latch a stop");
    node.plan_stopped = false;
  }
  // The newest plan that is whole and fits is followed at once when a command is missing.
  const auto& newest = node.plans[static_cast<std::size_t>(std::max(node.newest_whole, 0)) % node.plans.size()];
  const bool fits = newest.pieces == 3 && newest.head.number == node.newest_whole && newest.head.run_id == node.run_id &&
                    newest.head.term == h.term && newest.head.controller_id == gate.controller_id() &&
                    tick - newest.head.tick < kResumePeriods;
  if (fits && obeys && !fed && !node.cleared && node.fed_tick >= 0 && node.last_accepted_term == h.term && before == 0 &&
      !gate.latch().latched() && node.followed == 0) {
    fail("a command is missing, a stop plan is there, and it is not followed");
  }
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

}  // namespace twinbus::protocol
