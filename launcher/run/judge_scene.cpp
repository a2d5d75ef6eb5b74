#include "launcher/run/judge_scene.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/math/angle.h"
#include "common/text/formatted.h"
#include "control/point_feet/point_feet_body.h"
#include "lcmtypes/msg/labels.h"

namespace twinbus::inline launcher {

namespace {

std::string goals_text(const GoalWatch& goals) {
  return formatted("arm goals: %d asked, %d reached; the hand at most %.1f mm off, joints %.3f rad\n", goals.asked(),
                   goals.reached(), 1e3 * goals.hand_off(), goals.joint_off());
}

// Which goals the arm did not come to, and by how much or why; empty: none.
std::string missed_text(const GoalWatch& goals) {
  std::string text;
  for (const MissedGoal& missed : goals.missed()) {
    const ArmGoal& goal = missed.goal;
    const bool of_hand = goal.kind != ArmGoalKind::kJoints;
    text += formatted("%sgoal %d (", text.empty() ? ": " : "; ", missed.number);
    const std::string side = goal.side == ArmSide::kRight ? "right hand" : goal.side == ArmSide::kLeft ? "left hand" : "hand";
    const auto at = [&](std::size_t i) { return static_cast<double>(goal.position[i]); };
    text += of_hand ? side + formatted(" to %.3f %.3f %.3f m): ", at(0), at(1), at(2)) : std::string("joints): ");
    switch (missed.why) {
      case MissedGoal::Why::kNoPath: text += "there was no path"; break;
      case MissedGoal::Why::kNotBegun: text += "its path was not begun"; break;
      case MissedGoal::Why::kUnderWay: text += "its path had not come to its end when the next goal came or the run ended"; break;
      case MissedGoal::Why::kOff:
        text += of_hand ? formatted("the hand was %.1f mm off, at most %.0f mm", 1e3 * missed.off, 1e3 * GoalWatch::kFar)
                        : formatted("a joint was %.4f rad off, at most %.2f rad", missed.off, GoalWatch::kFarJoint);
    }
  }
  return text;
}

// What was reached and what was asked.  A figure that there is none of is "?", and why is said.
std::string sentence(const char* format, double reached, double asked) {
  if (std::isfinite(reached)) return formatted(format, reached, asked);
  std::string whole = format;
  std::size_t at = whole.find('%');
  while (at != std::string::npos && whole[at + 1] == '%') at = whole.find('%', at + 2);
  if (at != std::string::npos) whole.replace(at, whole.find_first_of("feg", at) + 1 - at, "?");
  return formatted(whole.c_str(), asked) + "; the run ended before it could be measured";
}

// Of a further robot's base.
struct RobotNow {
  double moved;  // level, from where it began [m]
  double tilt_deg;
};

RobotNow robot_now(const OneProcess& run, int robot) {
  const Eigen::Isometry3d base = run.world().robot_link(robot, 0);
  const Eigen::Vector3d start = run.further_robots()[static_cast<std::size_t>(robot)].start;
  return {(base.translation() - start).head<2>().norm(),
          kDegrees * std::acos(std::clamp(base.linear()(2, 2), -1.0, 1.0))};
}

void judge_swing(const SwingWatch& watch, const SwingAsked& asked,
                 std::vector<std::string>& failures) {
  const auto seen = watch.seen();
  if (!seen) {
    failures.push_back("joint " + asked.joint + " did not swing after the push");
    return;
  }
  const auto compare = [&](double reached, double expected, double percent, const char* format) {
    const double off = 1e2 * std::abs(reached / expected - 1.0);
    if (!(off <= percent)) failures.push_back(sentence(format, off, percent));
  };
  compare(seen->period, watch.expected().period, asked.period_percent,
          "the swing's period was %.1f %% from the linear model's, at most %.1f %% were asked");
  compare(seen->decay, watch.expected().decay, asked.decay_percent,
          "the swing's decay was %.1f %% from the linear model's, at most %.1f %% were asked");
}

void judge_joint(const OneProcess& run, const JointEnd& end, std::vector<std::string>& failures) {
  const int joint = run.model().find_joint(end.name);
  if (joint < 0) {
    failures.push_back("the robot has no joint '" + end.name + "'");
    return;
  }
  const Configuration& now = run.world().configuration();
  const auto judge = [&](double reached, double asked, double within, const char* format) {
    const double off = std::abs(reached - asked);
    if (!(off <= within)) failures.push_back("joint " + end.name + sentence(format, off, within));
  };
  judge(now.q[joint], end.position, end.within,
        " ended %.3g off where it was asked to be, at most %.3g were asked");
  if (!std::isnan(end.speed))
    judge(now.qd[joint], end.speed, end.speed_within,
          " ended %.3g /s off the speed that was asked, at most %.3g were asked");
}

void judge_loose(const LooseWatch& watch, const Criteria& asked,
                 std::vector<std::string>& failures) {
  const auto at_most = [&](double reached, double most, const std::string& who,
                           const char* format) {
    if (!std::isnan(most) && !(reached <= most))
      failures.push_back(who + sentence(format, reached, most));
  };
  at_most(watch.drift(), asked.loose_energy_drift_j, "",
          "the energy of the loose bodies was %.3g J off, at most %.3g J were asked");
  at_most(watch.gain(), asked.loose_energy_gain_j, "",
          "the loose bodies gained %.3g J, at most %.3g J were asked");
  for (std::size_t i = 0; i < asked.spins.size(); ++i) {
    const SpinAsked& spin = asked.spins[i];
    const LooseWatch::Spin& seen = watch.spins()[i];
    const std::string who = "loose body '" + spin.name + "' ";
    at_most(seen.energy_drift, spin.energy_drift, who,
            "turned with an energy that was off by %.2e of itself, at most %.2e was asked");
    at_most(seen.momentum_drift, spin.momentum_drift, who,
            "turned with a momentum that was off by %.2e of itself, at most %.2e was asked");
    if (spin.flips >= 0 && seen.flips != spin.flips) {
      failures.push_back(who + "flipped " + std::to_string(seen.flips) + " times, " +
                         std::to_string(spin.flips) + " were asked");
    }
  }
}

void judge_touch(const TouchWatch& watch, const TouchAsked& asked,
                 std::vector<std::string>& failures) {
  if (!watch.begun()) failures.push_back("touch: the run ended before it was looked at");
  if (watch.wrong_count() > 0) {
    failures.push_back("the robot was touched at " + std::to_string(watch.wrong_count()) +
                       " points more or fewer than the " + std::to_string(asked.points) +
                       " that were asked");
  }
  if (!(watch.off() <= asked.within)) {
    failures.push_back(
        sentence("a point was touched by a force that was off by %.2e of itself, at "
                 "most %.2e was asked",
                 watch.off(), asked.within));
  }
}

}  // namespace

RunRequest request_of(const std::string& command, const Arguments& arguments, const Scene& scene) {
  RunRequest request;
  request.scene = scene.name;
  request.robot = arguments.text("--robot", scene.robot);
  request.engine = arguments.text("--engine", scene.engine);
  request.seed = static_cast<std::uint64_t>(arguments.number("--seed", 1.0, 0.0, 1e9));
  Engine engine;
  if (!engine_of(request.engine, engine))
    throw UsageError(command + ": there is no engine '" + request.engine + "'; use articulated, ode or mujoco");
  return request;
}

namespace {

// What is asked of a scene's end is not asked before.
Criteria without_the_end(Criteria criteria, std::vector<std::string>& left_out) {
  const auto leave_out = [&](bool asked, const std::string& what) {
    if (asked) left_out.push_back(what);
  };
  leave_out(!std::isnan(criteria.travel_min_m) || !std::isnan(criteria.drift_max_m), "how far the robot ends from its start");
  criteria.travel_min_m = criteria.drift_max_m = std::nan("");
  leave_out(!std::isnan(criteria.goals_reached_min), "how many arm goals are reached");
  criteria.goals_reached_min = std::nan("");
  for (const LooseEnd& end : criteria.loose) leave_out(true, "where loose body '" + end.name + "' ends");
  for (const RobotEnd& end : criteria.robots) leave_out(true, "where robot '" + end.name + "' ends");
  for (const JointEnd& end : criteria.joints) leave_out(true, "where joint " + end.name + " ends");
  criteria.loose.clear();
  criteria.robots.clear();
  criteria.joints.clear();
  for (SpinAsked& spin : criteria.spins) {
    leave_out(spin.flips >= 0, "how often loose body '" + spin.name + "' flips");
    spin.flips = -1;
  }
  return criteria;
}

}  // namespace

RunVerdict judge_scene(const OneProcess& run, const Criteria& whole, std::int64_t ticks, bool part) {
  const RunFigures& f = run.seen().figures();
  const WalkFigures& w = run.walked();
  RunVerdict verdict;
  const Criteria asked = part ? without_the_end(whole, verdict.left_out) : whole;
  verdict.ticks = run.ticks();
  verdict.source_missed = run.source().status().ticks_missed;
  verdict.controller_missed = run.seen().command().lost();
  verdict.missed = std::max(verdict.source_missed, verdict.controller_missed);
  verdict.fell = f.fell;
  std::vector<std::string>& failures = verdict.failures;
  if (!run.failure().empty()) failures.push_back(run.failure());
  if (run.ticks() < ticks) failures.push_back("the run ended early");
  if (asked.no_fall && f.fell) failures.push_back("the robot fell");
  if (asked.no_self_collision && f.self_collision_ticks > 0) {
    failures.push_back("the robot touched itself or an obstacle in " +
                       std::to_string(f.self_collision_ticks) + " ticks" + run.first_touch());
  }
  // NaN: not asked; a figure that is none fails, or is left out of a part.
  const auto at_most = [&](double reached, double most, const char* format) {
    if (!std::isnan(most) && !(reached <= most))
      (part && !std::isfinite(reached) ? verdict.left_out : failures).push_back(sentence(format, reached, most));
  };
  const auto at_least = [&](double reached, double least, const char* format) {
    if (!std::isnan(least) && !(reached >= least))
      (part && !std::isfinite(reached) ? verdict.left_out : failures).push_back(sentence(format, reached, least));
  };
  at_most(kDegrees * f.max_tilt, asked.max_tilt_deg,
          "the base tilted %.2f degrees, at most %.2f were asked");
  at_least(1e3 * f.zmp_margin_min, asked.zmp_margin_min_mm,
           "the ZMP came as near as %.1f mm to the edge, %.1f mm were asked");
  at_least(1e3 * w.margin_percentile(0.05), asked.zmp_margin_p5_mm,
           "of all ticks the ZMP was in 5 %% nearer than %.0f mm to the edge, %.1f mm were asked");
  at_most(1e3 * f.slip_max, asked.slip_max_mm, "a sole slid %.2f mm, at most %.2f mm were asked");
  at_most(1e3 * w.step_slip_max(), asked.step_slip_max_mm,
          "a sole slid %.2f mm in a step, at most %.2f mm were asked");
  at_most(kDegrees * run.sole_tilt_max(), asked.sole_tilt_max_deg,
          "a sole tilted %.2f degrees, at most %.2f were asked");
  at_most(1e2 * w.force_error(), asked.force_rms_percent,
          "the feet's normal forces were %.1f %% of the weight from the wanted ones (root mean "
          "square), at most %.1f %% were asked");
  at_most(1e2 * w.velocity_error(), asked.velocity_error_percent,
          "the velocity was %.1f %% from the commanded one, at most %.1f %% were asked");
  at_least(w.travel(), asked.travel_min_m,
           "the robot ended %.2f m from its start, at least %.2f m were asked");
  at_most(w.travel(), asked.drift_max_m,
          "the robot ended %.2f m from its start, at most %.2f m were asked");
  if (!std::isnan(asked.goals_reached_min) && !(run.goals().reached() >= asked.goals_reached_min)) {
    failures.push_back(formatted("%d of the arm goals were reached, at least %.0f were asked", run.goals().reached(), asked.goals_reached_min) +
                       missed_text(run.goals()));
  }
  for (const LooseEnd& end : asked.loose) {
    const int body = run.find_loose(end.name);
    if (body < 0) continue;
    const LooseState now = run.world().loose(body);
    const double off = (now.pose.translation() - run.origin() - end.position).norm();
    const double speed = now.velocity.norm();
    const std::string who = "loose body '" + end.name + "' ";
    if (!(off <= end.within)) {
      failures.push_back(who + sentence("ended %.4f m from where it was asked to be, at most %.4f "
                                        "m were asked",
                                        off, end.within));
    }
    if (!(speed <= end.speed)) {
      failures.push_back(
          who + sentence("ended at %.4f m/s, at most %.4f m/s were asked", speed, end.speed));
    }
  }
  for (std::size_t i = 0; i < run.further_robots().size(); ++i) {
    for (const RobotEnd& end : asked.robots) {
      if (end.name != run.further_robots()[i].name) continue;
      const std::string who = "robot '" + end.name + "' ";
      const RobotNow now = robot_now(run, static_cast<int>(i));
      if (!(now.moved <= end.within)) {
        failures.push_back(who + sentence("ended %.4f m from where it began, at most %.4f m were "
                                          "asked",
                                          now.moved, end.within));
      }
      if (!(now.tilt_deg <= end.max_tilt_deg)) {
        failures.push_back(who + sentence("ended tilted by %.2f degrees, at most %.2f were asked",
                                          now.tilt_deg, end.max_tilt_deg));
      }
    }
  }
  at_most(static_cast<double>(run.trust().doubted), asked.max_doubted_steps,
          "the engine does not trust %.0f of its steps, at most %.0f were asked");
  if (run.energy().on() && !run.energy().begun())
    (part ? verdict.left_out : failures).push_back("the servos worked all the time: of energy nothing can be said");
  at_most(run.energy().drift(), asked.energy_drift_j,
          "the robot's energy was %.3g J off, at most %.3g J were asked");
  for (const JointEnd& end : asked.joints) judge_joint(run, end, failures);
  judge_loose(run.loose(), asked, failures);
  if (run.touch().on()) {
    if (part && !run.touch().begun()) {
      verdict.left_out.push_back("the points at which the robot is touched");
    } else {
      judge_touch(run.touch(), asked.touch, failures);
    }
  }
  if (run.swing().on()) {
    if (part && !run.swing().seen()) {
      verdict.left_out.push_back("the swing of joint " + asked.swing.joint);
    } else {
      judge_swing(run.swing(), asked.swing, failures);
    }
  }
  if (run.state().role == Role::kStopped) {
    const std::string cause = run.stop_cause();
    failures.push_back(std::string("the source is stopped (") + label(run.state().stop_kind) + ") by " +
                       label(run.source().status().stop_reason) + (cause.empty() ? "" : ": " + cause));
  }
  verdict.passed = failures.empty();
  return verdict;
}

std::string scene_figures(const OneProcess& run, const Criteria& asked) {
  const RunFigures& f = run.seen().figures();
  const WalkFigures& w = run.walked();
  std::string lines;
  const bool feet = run.model().soles[0].link >= 0 || run.model().soles[1].link >= 0;
  if (!feet)
    lines = formatted("tilt %.2f degrees, %s\n", kDegrees * f.max_tilt,
                      why_no_point_feet(run.model()) != nullptr ? "no feet"
                      : std::isnan(asked.zmp_margin_min_mm)
                          ? "on point feet: nothing is asked of soles"
                          : formatted("on point feet, ZMP margin %.1f mm", 1e3 * f.zmp_margin_min).c_str());
  else
    lines = formatted("tilt %.2f degrees, ZMP margin %.1f mm, slip %.2f mm, penetration %.2f mm, sole tilt %.2f degrees\n",
                      kDegrees * f.max_tilt, 1e3 * f.zmp_margin_min, 1e3 * f.slip_max, 1e3 * f.penetration_max,
                      kDegrees * run.sole_tilt_max());
  if (const auto far = static_cast<float>(run.origin().lpNorm<Eigen::Infinity>()); far > 0.0F) {
    lines += formatted("begun %g m from the origin: TRUTH rounds where feet are to %.1g mm, and slip in a step with it\n",
                       static_cast<double>(far), 1e3 * static_cast<double>(std::nextafter(far, 2.0F * far) - far));
  }
  for (int i = 0; i < run.world().loose_count(); ++i) {
    const LooseState now = run.world().loose(i);
    const Eigen::Vector3d p = now.pose.translation() - run.origin();
    lines += formatted("loose body %s ended at %.4f %.4f %.4f m, %.1f mm/s\n", run.loose_name(i).c_str(), p.x(), p.y(),
                       p.z(), 1e3 * now.velocity.norm());
  }
  for (std::size_t i = 0; i < run.further_robots().size(); ++i) {
    const RobotNow now = robot_now(run, static_cast<int>(i));
    lines += formatted("robot %s ended %.1f mm from where it began, tilt %.2f degrees\n",
                       run.further_robots()[i].name.c_str(), 1e3 * now.moved, now.tilt_deg);
  }
  if (run.trust().doubted > 0) lines += doubts_line(run.trust()) + "\n";
  if (run.energy().begun()) {
    lines += formatted("energy %.4f J, at most %.2e J off\n", run.energy().first(), run.energy().drift());
  }
  for (const JointEnd& end : asked.joints) {
    const int joint = run.model().find_joint(end.name);
    if (joint < 0) continue;
    const Configuration& now = run.world().configuration();
    lines += formatted("joint %s ended at %.9f, %.9f /s\n", end.name.c_str(), now.q[joint], now.qd[joint]);
  }
  if (run.world().loose_count() > 0) {
    lines += formatted("energy of the loose bodies %.4f J, %.2e J off, %.2e J above\n", run.loose().first(),
                       run.loose().drift(), run.loose().gain());
  }
  for (const LooseWatch::Spin& spin : run.loose().spins()) {
    lines += formatted("loose body %s flipped %d times, energy of turning off by %.1e, momentum by %.1e\n",
                       run.loose_name(spin.body).c_str(), spin.flips, spin.energy_drift, spin.momentum_drift);
  }
  if (run.touch().begun()) {
    lines += formatted("touched at every point by the same force within %.1e\n", run.touch().off());
  }
  if (const auto seen = run.swing().seen()) {
    const Swing& expected = run.swing().expected();
    lines += formatted("swings with a period of %.4f s and a decay of %.3f /s; the linear model says %.4f s and %.3f /s\n",
                       seen->period, seen->decay, expected.period, expected.decay);
  }
  if (run.goals().asked() > 0)
    lines += goals_text(run.goals());
  if (w.steps() == 0 && std::isfinite(w.velocity_error())) {  // on points: no sole lands
    lines += formatted("velocity error %.1f %%, ended %.2f m from its start\n", 1e2 * w.velocity_error(), w.travel());
  }
  if (w.steps() == 0) return lines;
  lines += formatted("%lld steps: slip in a step %.2f mm, ", static_cast<long long>(w.steps()), 1e3 * w.step_slip_max());
  if (std::isfinite(w.margin_percentile(0.05)) && std::isfinite(w.force_error())) {
    lines += formatted("5 %% of the ZMP margins below %.0f mm, normal force error %.1f %% of the weight, ",
                       1e3 * w.margin_percentile(0.05), 1e2 * w.force_error());
  }
  if (std::isfinite(w.velocity_error()))
    lines += formatted("velocity error %.1f %%, ", 1e2 * w.velocity_error());
  else
    lines += "no stretch of steady walking, ";
  return lines + formatted("ended %.2f m from its start\n", w.travel());
}

}  // namespace twinbus::launcher
