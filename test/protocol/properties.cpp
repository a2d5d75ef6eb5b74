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
