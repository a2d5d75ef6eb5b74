#include "viewer_log/view/frame.h"

#include <algorithm>
#include <array>
#include <span>

#include "viewer_log/view/frame_number.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "robot/collision/thing_name.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/refusal_text.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "viewer_log/view/health.h"
#include "viewer_log/view/scene_frame.h"
#include "viewer_log/view/signals.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr double kSenderFresh = 0.5;    // [s]
constexpr double kMinShownForce = 1.0;  // [N]
constexpr double kGuardKeeps = GuardDefaults::kInController;
constexpr double kActedOn = 0.030;  // a pair that the guard acts on may be so far apart when it brakes [m]

Json age_ms(double age) { return age > 1e6 ? Json(nullptr) : number(1e3 * age, 1); }

// Corners of a sole on the ground, counter-clockwise from front left, in world.
std::array<Vector3d, 4> corners(const Sole& sole, const Eigen::Isometry3d& in_world) {
  return {in_world * Vector3d(sole.front, sole.left, 0),
          in_world * Vector3d(-sole.back, sole.left, 0),
          in_world * Vector3d(-sole.back, -sole.right, 0),
          in_world * Vector3d(sole.front, -sole.right, 0)};
}

// Convex hull seen from above (Andrew's monotone chain), counter-clockwise.
std::vector<Vector3d> hull(std::vector<Vector3d> points) {
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(), [](const Vector3d& a, const Vector3d& b) {
    return a.x() < b.x() || (!(b.x() < a.x()) && a.y() < b.y());
  });
  const auto turns_right = [](const Vector3d& o, const Vector3d& a, const Vector3d& b) {
    return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x()) <= 0.0;
  };
  std::vector<Vector3d> chain;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = chain.size();
    for (const Vector3d& p : points) {
      while (chain.size() >= start + 2 && turns_right(chain[chain.size() - 2], chain.back(), p)) {
        chain.pop_back();
      }
      chain.push_back(p);
    }
    chain.pop_back();  // the other pass begins with it
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

int point_feet(const StackView& view) {
  const StandingFeet* feet = view.estimator().feet();
  return feet == nullptr ? 0 : feet->count();
}

// Where it presses the ground, below the robot as it is drawn.
Vector3d point_foot(const StackView& view, std::int64_t now_ns, int foot) {
  const Estimator& estimator = view.estimator();
  return view.drawn_from_estimated(now_ns) * (estimator.configuration().base * estimator.feet()->point(foot));
}

// Upward force on a foot without a sole: what its sensor says, in the axes of its link, else what the torques before it say [N].
double load_on_point(const StackView& view, const RobotState& state, int foot) {
  const StandingFeet& feet = *view.estimator().feet();
  const auto row = static_cast<std::size_t>(foot);
  if (state.wrench_kind[row] == WrenchKind::kAbsent) return feet.load(foot) * kGravity * view.model().total_mass();
  const auto& w = state.wrench[row];
  return view.estimator().kinematics().link_in_world(feet.link(foot)).linear().row(2).dot(vector(std::array{w[0], w[1], w[2]}));
}

// Below the robot as it is drawn: the estimate of where it walked drifts from the truth.
void add_feet(const StackView& view, std::int64_t now_ns, Json& frame) {
  const Estimator& estimator = view.estimator();
  const Eigen::Isometry3d drawn = view.drawn_from_estimated(now_ns);
  Json names = Json::array(), soles = Json::array(), loaded = Json::array(), force = Json::array();
  std::vector<Vector3d> support;
  const auto add = [&](int foot, std::span<const Vector3d> outline, bool stands, double load) {
    Json shown = Json::array();
    for (const Vector3d& corner : outline) {
      shown.push_back(point(corner));
      if (stands) support.push_back(corner);
    }
    names.push_back(limb_name(view, static_cast<std::size_t>(foot)));
    soles.push_back(shown);
    loaded.push_back(stands);
    force.push_back(number(load, 1));
  };
  for (int foot = 0; foot < 2; ++foot) {
    const Sole& sole = view.model().soles[static_cast<std::size_t>(foot)];
    if (sole.link < 0) continue;
    add(foot, corners(sole, drawn * estimator.sole_in_world(foot)), estimator.loaded(foot), estimator.sole_force(foot).z());
  }
  for (int foot = 0; foot < point_feet(view); ++foot) {
    const Vector3d place = point_foot(view, now_ns, foot);
    add(foot, std::span(&place, 1), estimator.feet()->stands(foot), load_on_point(view, view.shown(now_ns), foot));
  }
  Json polygon = Json::array();
  for (const Vector3d& corner : hull(support)) polygon.push_back(point(corner));
  frame["feet"] = names;
  frame["soles"] = soles;
  frame["loaded"] = loaded;
  frame["foot_force"] = force;
  frame["polygon"] = polygon;
}

// Contact forces are a simulator's secret; without them the measured foot forces are drawn at the
// ZMP side of each sole.
void add_forces(const StackView& view, std::int64_t now_ns, Json& frame) {
  Json forces = Json::array();
  const auto add = [&](const Vector3d& at, const Vector3d& force) {
    if (!(force.norm() > kMinShownForce)) return;
    Json row = point(at);
    for (int i = 0; i < 3; ++i) row.push_back(number(force[i], 1));
    forces.push_back(row);
  };
  const bool truth_applies = view.truth_applies(now_ns);
  if (truth_applies) {
    const SimTruth& truth = view.truth().value;
    const Eigen::Isometry3d& world = view.world_from_sim();
    const auto rows = static_cast<std::size_t>(std::clamp<int>(truth.contact_count, 0, 8));
    for (std::size_t i = 0; i < rows; ++i) {
      add(world * vector(truth.contact_point[i]), world.linear() * vector(truth.contact_force[i]));
    }
    if (vector(truth.push_force).norm() > kMinShownForce) {
      Json push = point(world * vector(truth.push_point));
      const Vector3d force = world.linear() * vector(truth.push_force);
      for (int i = 0; i < 3; ++i) push.push_back(number(force[i], 1));
      frame["push"] = push;
    }
  } else {
    for (int foot = 0; foot < 2; ++foot) {
      add(view.estimator().sole_in_world(foot).translation(), view.estimator().sole_force(foot));
    }
    for (int foot = 0; foot < point_feet(view); ++foot) {
      add(point_foot(view, now_ns, foot), Vector3d(0.0, 0.0, load_on_point(view, view.shown(now_ns), foot)));
    }
  }
  frame["forces"] = forces;
  frame["forces_from"] = truth_applies ? "simulated contacts" : "foot sensors";
}

// Nothing without feet, and where those that stand span no area.
Json margin_mm(const StackView& view, double margin) {
  const auto& soles = view.model().soles;
  const bool has_feet = soles[0].link >= 0 || soles[1].link >= 0 || point_feet(view) > 0;
  return has_feet && margin > -1.0 ? number(1e3 * margin, 1) : Json(nullptr);
}

void add_balance(const StackView& view, std::int64_t now_ns, Json& frame) {
  const Eigen::Isometry3d& world = view.world_from_sim();
  if (view.truth_applies(now_ns)) {
    const SimTruth& truth = view.truth().value;
    const Vector3d zmp(static_cast<double>(truth.zmp[0]), static_cast<double>(truth.zmp[1]), 0.0);
    frame["zmp"] = point(world * zmp);
    frame["com"] = point(world * vector(truth.com));
    frame["margin_mm"] = margin_mm(view, static_cast<double>(truth.zmp_margin));
  } else {
    const Estimator& estimator = view.estimator();
    frame["zmp"] = point(estimator.zmp());
    frame["com"] = point(estimator.kinematics().com());
    frame["margin_mm"] = margin_mm(view, estimator.support_margin(estimator.zmp()));
  }
  if (view.controller().fresh(now_ns, kSenderFresh)) {
    const ControllerStatus& status = view.controller().value;
    const Eigen::Isometry3d ground =
        view.drawn_from_estimated(now_ns) * view.estimator().ground_in_world();
    const auto on_ground = [&](const std::array<float, 2>& p) {
      return point(ground * Vector3d(static_cast<double>(p[0]), static_cast<double>(p[1]), 0.0));
    };
    frame["zmp_reference"] = on_ground(status.zmp_reference);
    frame["dcm"] = on_ground(status.dcm);
  }
}

// "" for a pair that is only near, as many are in every posture of a robot; "close" when the guard acts on it or its gap is
// less than the guard keeps of the two; "touch" when half of that is gone, below which the guard lets nothing come.
const char* pair_level(double distance, double keeps, bool guard_acts) {
  if (!(distance >= 0.5 * keeps)) return "touch";
  return distance < keeps || (guard_acts && distance < kActedOn) ? "close" : "";
}

void add_pairs(const StackView& view, std::int64_t now_ns, Json& frame) {
  Json pairs = Json::array();
  if (view.guard().fresh(now_ns, kSenderFresh)) {
    const GuardReport& report = view.guard().value;
    const Eigen::Isometry3d base = view.base(now_ns);
    const auto rows = static_cast<std::size_t>(std::clamp<int>(report.pairs_near, 0, kGuardPairs));
    const auto name = [&](int link) { return std::string(thing_name(view.model(), view.things(), link).data()); };
    const bool acts = report.hold_mask != 0 || report.stop_asked || report.verdict >= GuardVerdict::kWillCollide;
    for (std::size_t i = 0; i < rows; ++i) {
      const double keeps = kGuardKeeps * view.margin_share(report.link_a[i], report.link_b[i]);
      pairs.push_back({{"a", name(report.link_a[i])},
                       {"level", pair_level(static_cast<double>(report.distance[i]), keeps, acts)},
                       {"b", name(report.link_b[i])},
                       {"mm", number(1e3 * static_cast<double>(report.distance[i]), 1)},
                       {"s", number(static_cast<double>(report.time_to_contact[i]), 2)},
                       {"from", point(base * vector(report.point_a[i]))},
                       {"to", point(base * vector(report.point_b[i]))}});
    }
  }
  frame["pairs"] = pairs;
}

Json sources(const StackView& view, std::int64_t now_ns) {
  Json list = Json::array();
  for (const Heard<SourceStatus>& heard : view.sources()) {
    const SourceStatus& s = heard.value;
    list.push_back({{"run", s.run_id},
                    {"kind", label(s.source)},
                    {"role", label(s.role)},
                    {"term", s.term},
                    {"age_ms", age_ms(heard.age(now_ns))},
                    {"hardware", s.hardware},
                    {"can_be_set", s.can_be_set},
                    {"pace", s.pace},
                    {"stop", label(s.stop_kind)},
                    {"accepted", s.commands_accepted},
                    {"rejected", s.commands_rejected},
                    {"late", s.commands_late},
                    {"clamped", s.clamped},
                    {"missed", s.ticks_missed},
                    {"refusal", s.refusal == Refusal::kNone ? "" : refusal_text(s.refusal)}});
  }
  return list;
}

Json processes(const StackView& view, std::int64_t now_ns) {
  Json list = Json::array();
  for (const Heard<Heartbeat>& heard : view.processes()) {
    const Heartbeat& h = heard.value;
    list.push_back({{"id", h.process_id},
                    {"kind", label(h.kind)},
                    {"pid", h.pid},
                    {"age_ms", age_ms(heard.age(now_ns))},
                    {"rate", number(static_cast<double>(h.rate), 1)},
                    {"median_us", number(static_cast<double>(h.tick_median_us), 1)},
                    {"p99_us", number(static_cast<double>(h.tick_p99_us), 1)},
                    {"input_age_us", number(static_cast<double>(h.age_us), 0)},
                    {"missed", h.ticks_missed},
                    {"ticks", h.ticks},
                    {"lost", h.messages_lost},
                    {"rejected", h.messages_rejected},
                    {"realtime", h.realtime},
                    {"state", h.state}});
  }
  std::sort(list.begin(), list.end(), [](const Json& a, const Json& b) {
    return a["kind"] == b["kind"] ? a["id"] < b["id"] : a["kind"] < b["kind"];
  });
  return list;
}

// Postures to be drawn as ghosts, and where the hands are.
void add_ghosts(const StackView& view, std::int64_t now_ns, Json& frame) {
  const int count = view.model().bus_count();
  if (view.command_applies(now_ns)) frame["command"] = numbers(view.command().value.q, count, 4);
  if (view.standby_applies(now_ns)) {
    const RobotState& standby = view.standby().value;
    frame["standby"] = {{"source", label(standby.source)},
                        {"role", label(standby.role)},
                        {"q", numbers(standby.q, count, 4)}};
  }
  const Eigen::Isometry3d drawn = view.drawn_from_estimated(now_ns);
  Json hands = Json::array();
  for (const Hand* hand : hands_of(view.model()))
    hands.push_back(point(drawn * view.estimator().kinematics().link_in_world(hand->link) * hand->frame.translation()));
  frame["hands"] = hands;
}

// A row that begins with a point, and goes on with a vector where it has six numbers: seen from another world.
void move_row(const Eigen::Isometry3d& place, Json& row) {
  if (!row.is_array() || row.size() < 3 || !row[0].is_number() || !row[1].is_number()) return;
  const auto at = [&](std::size_t i) { return row[i].is_number() ? row[i].get<double>() : 0.0; };
  const Vector3d moved = place * Vector3d(at(0), at(1), at(2));
  row[0] = number(moved.x());
  row[1] = number(moved.y());
  if (row.size() != 6) return;
  const Vector3d turned = place.linear() * Vector3d(at(3), at(4), at(5));
  for (int i = 0; i < 3; ++i) row[static_cast<std::size_t>(3 + i)] = number(turned[i], 1);
}

// Everything of a live frame that has a place; the ground stays where it is.
void move_all(const Eigen::Isometry3d& place, Json& frame) {
  for (const char* key : {"zmp", "com", "zmp_reference", "dcm", "push"}) {
    if (frame.contains(key)) move_row(place, frame[key]);
  }
  for (const char* key : {"polygon", "forces", "hands"}) {
    for (Json& row : frame[key]) move_row(place, row);
  }
  for (Json& sole : frame["soles"]) {
    for (Json& corner : sole) move_row(place, corner);
  }
  for (Json& pair : frame["pairs"]) {
    move_row(place, pair["from"]);
    move_row(place, pair["to"]);
  }
}

}  // namespace

std::string live_frame(const StackView& view, std::int64_t now_ns, const Recorded* recorded) {
  const RobotState& state = view.shown(now_ns);
  Json frame = {{"type", "live"},
                {"source", label(state.source)},
                {"role", label(state.role)},
                {"term", state.term},
                {"tick", state.tick},
                {"time", number(1e-9 * static_cast<double>(state.time_ns), 3)},
                {"run", state.run_id},
                {"age_ms", age_ms(view.state().age(now_ns))},
                {"stop", label(state.stop_kind)}};
  frame["q"] = numbers(state.q, view.model().bus_count(), 5);
  frame["base"] = pose(view.base(now_ns));
  add_feet(view, now_ns, frame);
  add_forces(view, now_ns, frame);
  add_balance(view, now_ns, frame);
  add_pairs(view, now_ns, frame);
  add_ghosts(view, now_ns, frame);
  add_moving(view, now_ns, recorded != nullptr ? recorded->place : Eigen::Isometry3d::Identity(),
             frame);
  if (recorded != nullptr) {
    frame["log_s"] = number(recorded->seconds, 4);
    move_all(recorded->place, frame);
    frame["base"] = pose(recorded->place * view.base(now_ns));
    if (recorded->other != nullptr) {
      const RobotState& other = recorded->other->shown(recorded->other_now_ns);
      frame["other"] = {
          {"q", numbers(other.q, view.model().bus_count(), 5)},
          {"base", pose(recorded->other_place * recorded->other->base(recorded->other_now_ns))},
          {"tick", other.tick}};
    }
  }
  return dump(frame);
}

std::string status_frame(const StackView& view, std::int64_t now_ns) {
  const Health health = assess(view, now_ns);
  Json frame = {{"type", "status"},
                {"health", {{"level", label(health.level)}, {"text", health.text}, {"remedy", health.remedy}, {"anew", health.anew}}},
                {"stop", label(view.state().value.stop_kind)},
                {"state_hz", number(view.rates().state(), 1)},
                {"command_hz", number(view.rates().command(), 1)},
                {"guard_hz", number(view.rates().guard(), 1)},
                {"realtime_factor", number(view.rates().realtime_factor(), 3)},
                {"sources", sources(view, now_ns)},
                {"processes", processes(view, now_ns)}};
  if (view.controller().fresh(now_ns, kSenderFresh)) {
    const ControllerStatus& c = view.controller().value;
    frame["controller"] = {{"mode", label(c.mode)},
                           {"motion", label(c.motion)},
                           {"stopping", label(c.stopping)},
                           {"arm_state", c.arm_state},
                           {"compute_us", number(1e-3 * c.compute_ns, 1)}};
  }
  if (view.guard().fresh(now_ns, kSenderFresh)) {
    const GuardReport& g = view.guard().value;
    frame["guard"] = {{"verdict", label(g.verdict)},
                      {"pairs", g.pairs_checked},
                      {"holding", g.hold_mask != 0},
                      {"compute_us", number(1e-3 * g.compute_ns, 1)}};
  }
  Json events = Json::array();
  for (const ShownEvent& event : view.events()) {
    events.push_back({{"n", event.number},
                      {"utime", event.utime},
                      {"from", label(event.kind)},
                      {"severity", event.severity},
                      {"count", event.count},
                      {"text", event.text}});
  }
  frame["events"] = events;
  return dump(frame);
}

std::string path_frame(const StackView& view) {
  const ArmPathView& path = view.arm_path();
  Json joints = Json::array(), knots = Json::array();
  for (int index : path.joints()) {
    const bool known = index >= 0 && index < static_cast<int>(view.model().joints.size());
    joints.push_back(known ? view.model().joints[static_cast<std::size_t>(index)].name : "");
  }
  for (const ArmPathView::Knot& knot : path.knots()) {
    knots.push_back(numbers(knot.q, static_cast<int>(path.joints().size())));
  }
  return dump({{"type", "path"},
               {"id", path.id()},
               {"status", path.status_text()},
               {"seconds", number(path.duration(), 2)},
               {"joints", joints},
               {"knots", knots}});
}

std::string hello_frame(const Model& model, bool trusted) {
  Json joints = Json::array();
  for (int index : model.bus_joints) {
    joints.push_back(model.joints[static_cast<std::size_t>(index)].name);
  }
  Json hands = Json::array();
  for (const Hand* hand : hands_of(model)) {
    hands.push_back({{"name", hand->name},
                     {"link", model.links[static_cast<std::size_t>(hand->link)].name},
                     {"at", point(hand->frame.translation())}});
  }
  return dump({{"type", "hello"},
               {"trusted", trusted},
               {"robot", model.name},
               {"fixed", !model.floating_base},
               {"joints", joints},
               {"hands", hands},
               {"mass", number(model.total_mass(), 1)},
               {"period_ms", number(1e3 * model.period(), 3)}});
}

}  // namespace twinbus::viewer_log
