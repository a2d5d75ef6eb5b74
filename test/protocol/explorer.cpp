#include "test/protocol/explorer.h"

#include <chrono>
#include <unordered_set>

namespace twinbus::protocol {

namespace {

struct Choice {
  int order = 0;
  Fault fault;
  Happening happening;
};

std::vector<Fault> faults(int sources, bool plans) {
  std::vector<Fault> all{{}};
  for (int from = sources + 1; plans && from <= sources + 3; ++from) {
    for (const Fate fate : {Fate::kLost, Fate::kLate, Fate::kDoubled}) all.push_back({from, 0, fate});
  }
  for (int from = 0; from <= sources; ++from) {
    for (int to = 0; to <= sources; ++to) {
      if (from == to) continue;
      for (const Fate fate : {Fate::kLost, Fate::kLate, Fate::kDoubled})
        all.push_back({from, to, fate});
    }
    all.push_back({from, -1, Fate::kLost});
  }
  all.push_back({-2, -1, Fate::kLost});
  all.push_back({-2, -1, Fate::kLate});
  return all;
}

std::vector<Happening> happenings(int sources, bool plans) {
  std::vector<Happening> all{{}};
  using E = EventKind;
  if (plans) {
    for (const E kind : {E::kControllerDies, E::kControllerReturns, E::kNoMorePlans, E::kPlanOfOtherTerm, E::kPlanOfOther,
                         E::kStaleCommand, E::kSecondController, E::kStopHold, E::kStopOff, E::kClear}) {
      all.push_back({kind, 0, 0xff});
    }
    all.push_back({E::kSwitch, 1, 0xff});
    all.push_back({E::kCrash, 0, 0xff});
    return all;
  }
  for (int i = 0; i < sources; ++i) {
    for (const E kind : {E::kActivate, E::kSwitch, E::kSwitchElsewhere, E::kPark, E::kTrack,
                         E::kShadow, E::kCrash, E::kRestart, E::kClear}) {
      all.push_back({kind, i, 0xff});
    }
    all.push_back({E::kStopHold, i, 1 << i});  // only this one hears it
    all.push_back({E::kStopOff, i, 1 << i});
  }
  for (const E kind :
       {E::kRepeatRequest, E::kStopHold, E::kStopOff, E::kOldClear, E::kControllerDies,
        E::kForgedState, E::kSecondController, E::kFutureCommand}) {
    all.push_back({kind, 0, 0xff});
  }
  return all;
}

const char* event_name(EventKind kind) {
  static const char* const names[] = {"",
                                      "activate",
                                      "switch to",
                                      "switch (named another active source) to",
                                      "track",
                                      "shadow",
                                      "park",
                                      "the last request again",
                                      "stop hold",
                                      "stop off",
                                      "clear",
                                      "old clear",
                                      "crash of",
                                      "restart of",
                                      "controller dies",
                                      "controller returns",
                                      "forged STATE",
                                      "second controller",
                                      "command from the future",
                                      "no more plans",
                                      "plan of another term",
                                      "plan of another controller",
                                      "command from before the silence"};
  return names[static_cast<int>(kind)];
}

std::string node_name(int i, int sources) {
  if (i == sources) return "controller";
  if (i == sources + 3) return "plan";
  if (i > sources) return "piece " + std::to_string(i - sources) + " of the plan";
  return i < 0 ? "all" : std::string(1, static_cast<char>('A' + i));
}

std::string text_of(const Choice& choice, int sources) {
  static const char* const fates[] = {"arrives", "lost", "late", "doubled"};
  std::string text;
  if (choice.happening.kind != EventKind::kNone) {
    text += std::string(event_name(choice.happening.kind)) + " " +
            node_name(choice.happening.subject, sources) + "; ";
  }
  if (choice.fault.fate != Fate::kDelivered) {
    text += node_name(choice.fault.from, sources) + " -> " + node_name(choice.fault.to, sources) +
            " " + fates[static_cast<int>(choice.fault.fate)] + "; ";
  }
  if (choice.order != 0) text += "reverse order; ";
  return text;
}

class Explorer {
 public:
  Explorer(const Setting& setting, const Bounds& bounds)
      : setting_(setting),
        bounds_(bounds),
        faults_(faults(setting.sources, setting.plans)),
        happenings_(happenings(setting.sources, setting.plans)),
        seen_(static_cast<std::size_t>(bounds.depth) + 1),
        begin_(std::chrono::steady_clock::now()) {}

  Outcome run(const World& root) {
    visit(root, 0, bounds_.faults, bounds_.happenings);
    return outcome_;
  }

 private:
  bool out_of_time() {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    if (spent.count() < bounds_.seconds) return false;
    outcome_.complete = false;
    return true;
  }

  void report(const World& world) {
    outcome_.violation = world.violation();
    for (const Choice& choice : path_) outcome_.trace.push_back(text_of(choice, setting_.sources));
    outcome_.trace.push_back(world.describe());
  }

  // True when the search is over.
  bool visit(const World& world, int depth, int faults_left, int happenings_left) {
    const std::uint64_t key =
        world.digest() * 64 + static_cast<std::uint64_t>(faults_left * 8 + happenings_left);
    if (!seen_[static_cast<std::size_t>(depth)].insert(key).second) return false;
    ++outcome_.states;
    if (depth == bounds_.depth) {
      World end = world;
      end.judge_the_end();
      ++outcome_.ends;
      if (end.violation().empty()) return false;
      report(end);
      return true;
    }
    if ((outcome_.states & 63) == 0 && out_of_time()) return true;
    for (const Happening& happening : happenings_) {
      const bool happens = happening.kind != EventKind::kNone;
      if (happens && happenings_left == 0) break;
      for (const Fault& fault : faults_) {
        const bool faulty = fault.fate != Fate::kDelivered;
        if (faulty && faults_left == 0) break;
        for (int order = 0; order < 2; ++order) {
          World next = world;
          next.step(order, fault, happening);
          ++outcome_.steps;
          path_.push_back({order, fault, happening});
          if (!next.violation().empty()) {
            report(next);
            return true;
          }
          if (visit(next, depth + 1, faults_left - faulty, happenings_left - happens)) return true;
          path_.pop_back();
        }
      }
    }
    return false;
  }

  const Setting& setting_;
  const Bounds bounds_;
  const std::vector<Fault> faults_;
  const std::vector<Happening> happenings_;
  std::vector<std::unordered_set<std::uint64_t>> seen_;
  std::vector<Choice> path_;
  std::chrono::steady_clock::time_point begin_;
  Outcome outcome_;
};

}  // namespace

const char* start_name(Start start) {
  static const char* const names[] = {"fresh",       "cold",       "track",         "switch",
                                      "switch-back", "shadow",     "shadow-switch", "far-shadow",
                                      "stopped",     "two-active", "cancel",        "grant-lost",
                                      "plans",       "plan-runs",  "plan-late",     "old-plan"};
  return names[static_cast<int>(start)];
}

std::vector<Start> all_starts() {
  std::vector<Start> all;
  for (int i = 0; i < static_cast<int>(Start::kCount); ++i) all.push_back(static_cast<Start>(i));
  return all;
}

Setting setting_for(Start start, int sources, RuleSet off) {
  const bool hardware =
      start == Start::kShadow || start == Start::kShadowSwitch || start == Start::kFarShadow;
  const bool plans = start == Start::kPlans || start == Start::kPlanRuns || start == Start::kPlanLate || start == Start::kOldPlan;
  return Setting(sources, hardware, start == Start::kFarShadow ? 0.2 : 0.0, off, plans);
}

World world_at(Start start, const Setting& setting) {
  World world(setting);
  const auto happen = [&](EventKind kind, int subject, int receivers = 0xff) {
    world.step(0, {}, {kind, subject, receivers});
  };
  if (start == Start::kFresh) return world;
  world.quiet(12);
  if (start == Start::kCold) return world;
  if (start == Start::kTwoActive) {  // in two halves of a split network
    world.step(0, {-2, -1, Fate::kLost}, {EventKind::kActivate, 0, 1});
    for (int i = 0; i < 3; ++i) world.step(0, {-2, -1, Fate::kLost}, {});
    world.step(0, {-2, -1, Fate::kLost}, {EventKind::kActivate, 1, 2});
    return world;
  }
  happen(EventKind::kActivate, 0);
  world.quiet(4);
  const bool hardware = setting.robots[1].is_hardware();
  happen(hardware ? EventKind::kShadow : EventKind::kTrack, 1);
  if (setting.sources > 2) happen(EventKind::kTrack, 2);
  world.quiet(3);
  if (start == Start::kOldPlan) {
    happen(EventKind::kNoMorePlans, 0);
    world.quiet(9);
  }
  if (start == Start::kPlanRuns || start == Start::kPlanLate) {
    happen(EventKind::kControllerDies, 0);
    world.quiet(start == Start::kPlanLate ? 10 : 3);
  }
  if (start == Start::kStopped) {
    happen(EventKind::kStopHold, 0);
    world.quiet(2);
    happen(EventKind::kClear, 0);
    world.quiet(2);
    happen(EventKind::kStopHold, 0);
    world.quiet(2);
  }
  if (start == Start::kSwitch || start == Start::kShadowSwitch || start == Start::kSwitchBack ||
      start == Start::kCancel || start == Start::kGrantLost) {
    happen(EventKind::kSwitch, 1);
  }
  if (start == Start::kCancel) {
    happen(EventKind::kCrash, 1);
    world.quiet(4);
    return world;
  }
  if (start == Start::kGrantLost) {
    world.quiet(1);
    happen(EventKind::kStopHold, 1, 2);
    for (int i = 0; i < 7; ++i) world.step(0, {0, 1, Fate::kLost}, {});
    return world;
  }
  if (start == Start::kSwitchBack) {
    world.quiet(20);  // a robot changes its source seldom
    happen(EventKind::kSwitch, 0);
  }
  world.message_faults = 0;
  world.interventions = start == Start::kStopped || !world.controller_alive() ? 1 : 0;
  return world;
}

Outcome explore(Start start, int sources, const Bounds& bounds, RuleSet off) {
  const Setting setting = setting_for(start, sources, off);
  const World root = world_at(start, setting);
  if (!root.violation().empty()) {
    Outcome outcome;
    outcome.violation = root.violation();
    outcome.trace = {"on the way to the start", root.describe()};
    return outcome;
  }
  return Explorer(setting, bounds).run(root);
}

}  // namespace twinbus::protocol
