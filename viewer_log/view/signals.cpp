#include "viewer_log/view/signals.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "viewer_log/view/frame_number.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr double kFresh = 0.5;  // [s]

template <std::size_t N, class T>
Json all(const std::array<T, N>& values, int decimals = 4) {
  return numbers(values, static_cast<int>(N), decimals);
}

// In row order of the message; a limb without a sensor is left out.
Json wrenches(const StackView& view, const RobotState& state) {
  Json json = Json::object();
  for (std::size_t limb = 0; limb < kLimbs; ++limb) {
    if (state.wrench_kind[limb] == WrenchKind::kAbsent) continue;
    json[limb_name(view, limb)] = all(state.wrench[limb], 2);
  }
  return json;
}

Json less(const PerJoint<double>& a, const PerJoint<double>& b, int count) {
  PerJoint<double> difference{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) difference[i] = a[i] - b[i];
  return numbers(difference, count, 6);
}

// Force and torque on the limbs that both measure, b less a.
Json wrench_residual(const StackView& view, const RobotState& a, const RobotState& b) {
  Json json = Json::object();
  for (std::size_t limb = 0; limb < kLimbs; ++limb) {
    if (a.wrench_kind[limb] == WrenchKind::kAbsent || b.wrench_kind[limb] == WrenchKind::kAbsent)
      continue;
    std::array<double, 6> difference{};
    for (std::size_t i = 0; i < 6; ++i) {
      difference[i] =
          static_cast<double>(b.wrench[limb][i]) - static_cast<double>(a.wrench[limb][i]);
    }
    json[limb_name(view, limb)] = all(difference, 2);
  }
  return json;
}

void add_other(const StackView& view, const RobotState& state, const Recorded& recorded, int count, Json& frame) {
  frame["log_s"] = number(recorded.seconds, 4);
  if (recorded.other == nullptr) return;
  const RobotState& other = recorded.other->shown(recorded.other_now_ns);
  frame["OTHER"] = {{"q", numbers(other.q, count, 5)},
                    {"tau", numbers(other.tau, count, 2)},
                    {"wrench", wrenches(view, other)}};
  frame["RESIDUAL"] = {{"q", less(other.q, state.q, count)},
                       {"wrench", wrench_residual(view, state, other)}};
}

}  // namespace

std::string limb_name(const StackView& view, std::size_t limb) {
  if (limb == kLeftHand || limb == kRightHand) return limb == kLeftHand ? "left_hand" : "right_hand";
  const StandingFeet* feet = view.estimator().feet();
  if (feet != nullptr && static_cast<int>(limb) < feet->count())
    return view.model().links[static_cast<std::size_t>(feet->link(static_cast<int>(limb)))].name;
  return limb <= kRightFoot ? (limb == kLeftFoot ? "left_foot" : "right_foot") : "foot_" + std::to_string(limb);
}

std::string signals_frame(const StackView& view, std::int64_t now_ns, const Recorded* recorded) {
  const RobotState& state = view.shown(now_ns);
  const int count = view.model().bus_count();
  Json frame = {{"type", "signals"},
                {"time", number(1e-9 * static_cast<double>(state.time_ns), 3)},
                {"STATE",
                 {{"q", numbers(state.q, count, 5)},
                  {"qd", numbers(state.qd, count)},
                  {"tau", numbers(state.tau, count, 2)},
                  {"attitude", all(state.attitude, 5)},
                  {"gyro", all(state.gyro)},
                  {"accel", all(state.accel, 3)},
                  {"wrench", wrenches(view, state)}}}};
  if (recorded != nullptr) add_other(view, state, *recorded, count, frame);
  if (view.command_applies(now_ns)) {
    const JointCommand& command = view.command().value;
    frame["COMMAND"] = {{"q", numbers(command.q, count, 5)},
                        {"qd", numbers(command.qd, count)},
                        {"tau", numbers(command.tau, count, 2)},
                        {"kp", numbers(command.kp, count, 0)}};
    frame["TRACKING"] = {{"q", less(command.q, state.q, count)}};
  }
  if (view.standby_applies(now_ns)) {
    const RobotState& standby = view.standby().value;
    frame["STANDBY"] = {{"q", numbers(standby.q, count, 5)}, {"wrench", wrenches(view, standby)}};
    frame["DIFFERENCE"] = {{"q", less(standby.q, state.q, count)}};
  }
  if (view.controller().fresh(now_ns, kFresh)) {
    const ControllerStatus& c = view.controller().value;
    frame["CONTROLLER_STATUS"] = {{"com", all(c.com)},
                                  {"com_velocity", all(c.com_velocity)},
                                  {"com_reference", all(c.com_reference)},
                                  {"dcm", all(c.dcm)},
                                  {"zmp", all(c.zmp)},
                                  {"zmp_reference", all(c.zmp_reference)},
                                  {"zmp_margin", number(static_cast<double>(c.zmp_margin))},
                                  {"compute_us", number(1e-3 * c.compute_ns, 1)}};
  }
  if (view.guard().fresh(now_ns, kFresh)) {
    const GuardReport& g = view.guard().value;
    frame["GUARD"] = {{"compute_us", number(1e-3 * g.compute_ns, 1)}, {"pairs_near", g.pairs_near}};
    if (g.pairs_near > 0) frame["GUARD"]["distance"] = number(static_cast<double>(g.distance[0]));
  }
  if (view.truth_applies(now_ns)) {
    const SimTruth& t = view.truth().value;
    frame["TRUTH"] = {{"base_position", all(t.base_position)},
                      {"com", all(t.com)},
                      {"zmp", all(t.zmp)},
                      {"zmp_margin", number(static_cast<double>(t.zmp_margin))},
                      {"penetration", number(static_cast<double>(t.penetration), 6)},
                      {"doubted_steps", t.doubted_steps}};
    for (std::size_t foot = 0; foot < static_cast<std::size_t>(std::clamp<int>(t.foot_count, 0, kMaxFeet)); ++foot) {
      const std::string name = limb_name(view, foot);
      frame["TRUTH"][name + "_force"] = all(t.foot_force[foot], 1);
      frame["TRUTH"]["foot_slip"][name] = number(static_cast<double>(t.foot_slip[foot]), 5);
    }
  }
  return dump(frame);
}

}  // namespace twinbus::viewer_log
