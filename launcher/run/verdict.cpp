#include "launcher/run/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/math/angle.h"
#include "common/text/formatted.h"
#include "lcmtypes/msg/labels.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kMissedWithFifo = 0.001;  // share of ticks
constexpr double kMissedWithoutFifo = 0.01;
constexpr double kMachineTooBad = 0.01;  // share of ticks that a bare timer missed
constexpr double kRateTolerance = 0.01;  // share of the rate asked for

bool is_source(ProcessKind kind) {
  return kind == ProcessKind::kSimulator || kind == ProcessKind::kBridge || kind == ProcessKind::kReplay;
}

double share_of(std::int64_t part, std::int64_t ticks) {
  return ticks > 0 ? static_cast<double>(part) / static_cast<double>(ticks) : 0.0;
}

// NaN and "never" become null: JSON has no words for them.
nlohmann::json number(double value) {
  if (!std::isfinite(value) || std::abs(value) >= 1e9) return nullptr;
  return value;
}

std::string cut_log_text(std::int64_t lost) {
  return formatted("the log is cut: the recorder lost %lld messages, as where the disk is full (./twinbus log info says where)",
                   static_cast<long long>(lost));
}

// As TRUTH has told them.
TrustCounts doubts_of(const RunFigures& figures) {
  static_assert(std::tuple_size_v<decltype(figures.doubted)> == kDoubts);
  TrustCounts counts;
  std::copy(figures.doubted.begin(), figures.doubted.end(), counts.steps.begin());
  counts.doubted = figures.doubted_steps;
  counts.first_at = figures.doubted_since;
  return counts;
}

}  // namespace

std::string doubts_line(const TrustCounts& trust) {
  if (trust.doubted == 0) return "";
  std::string line = "not to be trusted: " + std::to_string(trust.doubted) + " physics steps";
  const char* between = " (";
  for (std::size_t i = 0; i < kDoubts; ++i) {
    if (trust.steps[i] == 0) continue;
    line += between + std::string(kDoubtNames[i]) + " " + std::to_string(trust.steps[i]);
    between = ", ";
  }
  return line + formatted("), the first at %.3f s", trust.first_at);
}

std::string passed_line(std::int64_t doubted_steps, bool log_cut) {
  std::string line = "passed";
  if (doubted_steps > 0) line += formatted(" with %lld doubted steps: ./twinbus tune finds a step without", static_cast<long long>(doubted_steps));
  return line + (log_cut ? ", but the log is cut" : "");
}

nlohmann::ordered_json doubts_json(const TrustCounts& trust) {
  nlohmann::ordered_json doubted;
  doubted["any"] = trust.doubted;
  for (std::size_t i = 0; i < kDoubts; ++i) doubted[kDoubtNames[i]] = trust.steps[i];
  doubted["first_at_s"] = trust.doubted > 0 ? nlohmann::ordered_json(trust.first_at) : nlohmann::ordered_json();
  return doubted;
}

MissedCounts missed_so_far(const StackMonitor& seen, std::int64_t now_ns) {
  MissedCounts counts;
  for (const SeenProcess* process : seen.processes(now_ns, 2.0)) {
    const Heartbeat& beat = process->beat;
    if (beat.kind == ProcessKind::kController) {
      counts.controller += beat.ticks_missed;
      counts.controller_stalled += beat.ticks_stalled;
    } else if (is_source(beat.kind)) {
      counts.source += beat.ticks_missed;
      counts.source_stalled += beat.ticks_stalled;
      counts.timer = std::max(counts.timer, beat.timer_missed);
    }
  }
  return counts;
}

int real_time_of(const StackMonitor& seen, std::int64_t now_ns) {
  std::array<int, 3> least{-1, -1, -1};  // source, controller, programs of a user: -1, none is there
  for (const SeenProcess* process : seen.processes(now_ns, 2.0)) {
    const ProcessKind kind = process->beat.kind;
    const bool known = is_source(kind) || kind == ProcessKind::kController || kind == ProcessKind::kUser;
    if (!known) continue;
    int& of = least[is_source(kind) ? 0 : kind == ProcessKind::kController ? 1 : 2];
    const int has = process->beat.realtime;
    of = of < 0 ? has : std::min(of, has);
  }
  // Where no controller of ours is, a program of the user's is one.
  return std::max(0, std::min(least[0], least[1] >= 0 ? least[1] : least[2]));
}

std::string real_time_text(int real_time, bool patient) {
  if (patient) return real_time_text(real_time) + "; the simulated world waits up to 200 ms for a late command (--strict: it does not)";
  if (real_time == 0) return "WITHOUT FIFO priority (./twinbus doctor --rt says why)";
  return std::string("source and controller run with FIFO priority") +
         (real_time == 2 ? " and locked memory"
                         : ", but their memory is NOT LOCKED (./twinbus doctor --rt says why)");
}

RunVerdict judge(const StackMonitor& seen, const RunRequest& request, const MissedCounts& start,
                 std::int64_t now_ns) {
  RunVerdict verdict;
  verdict.ticks = seen.state().received();
  verdict.state_rate = seen.state().mean_rate();
  verdict.command_rate = seen.command().mean_rate();
  verdict.rate_wanted = request.rate / request.period;
  verdict.realtime_factor = verdict.state_rate / verdict.rate_wanted;
  verdict.fifo = real_time_of(seen, now_ns) >= 1;
  verdict.missed_allowed = verdict.fifo ? kMissedWithFifo : kMissedWithoutFifo;
  verdict.fell = seen.figures().fell;
  verdict.doubts = doubts_line(doubts_of(seen.figures()));
  verdict.doubted_steps = seen.figures().doubted_steps;
  if (const SeenSource* active = seen.active(now_ns)) {
    if (active->status.role == Role::kStopped) {
      verdict.failures.push_back(std::string("the source is stopped (") +
                                 label(active->status.stop_kind) + ") by " +
                                 label(active->status.stop_reason));
    }
    for (const SeenProcess* process : seen.processes(now_ns, 2.0)) {
      if (process->beat.process_id != active->status.run_id) continue;
      verdict.answer_median_us = static_cast<double>(process->beat.age_us);
      verdict.answer_p99_us = static_cast<double>(process->beat.age_p99_us);
    }
  } else {
    verdict.failures.push_back("no source is active at the end");
  }
  const MissedCounts end = missed_so_far(seen, now_ns);
  verdict.source_missed = std::max<std::int64_t>(end.source - start.source, 0);
  verdict.controller_missed = std::max<std::int64_t>(end.controller - start.controller, 0);
  const std::int64_t source_stalled =
      std::max<std::int64_t>(end.source_stalled - start.source_stalled, 0);
  const std::int64_t controller_stalled =
      std::max<std::int64_t>(end.controller_stalled - start.controller_stalled, 0);
  const std::int64_t source_own = verdict.source_missed - source_stalled;
  const std::int64_t controller_own = verdict.controller_missed - controller_stalled;
  verdict.missed = std::max(verdict.source_missed, verdict.controller_missed);
  verdict.stalled = verdict.missed - std::max(source_own, controller_own);
  for (const SeenProcess* process : seen.processes(now_ns, 2.0)) {
    if (process->beat.kind == ProcessKind::kLog) verdict.not_recorded += process->beat.messages_lost;
  }
  if (request.whole_log && verdict.not_recorded > 0) verdict.failures.push_back(cut_log_text(verdict.not_recorded));
  if (end.timer >= 0) verdict.timer_missed = end.timer - std::max<std::int64_t>(start.timer, 0);

  if (!request.lockstep) {
    // What never came because the machine stood still is no loss of ours either.
    const double tolerance = kRateTolerance + share_of(verdict.stalled, verdict.ticks);
    // A world that waits may be as slow as it must; whoever commands it keeps up with it.
    const double wanted = request.patient ? std::min(verdict.state_rate, verdict.rate_wanted) : verdict.rate_wanted;
    for (const auto& [name, rate] :
         {std::pair("STATE", verdict.state_rate), std::pair("COMMAND", verdict.command_rate)}) {
      if (!(std::abs(rate - wanted) <= tolerance * wanted) || !(rate > 0.0)) {
        verdict.failures.push_back(std::string(name) + formatted(" came at %.1f Hz, %.1f Hz were asked", rate, wanted));
      }
    }
    const double share =
        verdict.ticks > 0 ? share_of(verdict.missed - verdict.stalled, verdict.ticks) : 1.0;
    if (!(share <= verdict.missed_allowed)) {
      verdict.failures.push_back(formatted("%.3f %% of ticks missed, %.1f %% allowed", 1e2 * share,
                                           1e2 * verdict.missed_allowed));
    }
  }
  if (verdict.fell) verdict.failures.push_back("the robot fell");
  verdict.passed = verdict.failures.empty();
  return verdict;
}

void end_by_operator(RunVerdict& verdict, const RunRequest& request, double measured) {
  verdict.by_operator = true;
  verdict.measured = measured;
  if (request.duration > 0.0) verdict.failures.push_back(formatted("%.1f s were asked, the operator ended it before", request.duration));
  verdict.passed = verdict.failures.empty();
}

std::vector<std::string> verdict_lines(const RunVerdict& verdict, const RunRequest& request) {
  std::vector<std::string> lines;
  lines.push_back(
      formatted("STATE %.1f Hz, COMMAND %.1f Hz", verdict.state_rate, verdict.command_rate) +
      (request.lockstep ? " (lock-step)" : formatted(", asked %.1f Hz", verdict.rate_wanted)));
  std::string missed = formatted("missed %lld of %lld ticks (%.3f %%; source %lld, controller %lld)",
                                 static_cast<long long>(verdict.missed), static_cast<long long>(verdict.ticks),
                                 1e2 * share_of(verdict.missed, verdict.ticks),
                                 static_cast<long long>(verdict.source_missed),
                                 static_cast<long long>(verdict.controller_missed));
  if (verdict.timer_missed >= 0) {
    missed += formatted(
        ", of which %lld while the machine itself stood still (a bare timer of higher priority stood still too)",
        static_cast<long long>(verdict.stalled));
  }
  lines.push_back(missed);
  if (request.patient) {
    lines.push_back(formatted("the simulated world waited for late commands: %.3f times real time", verdict.realtime_factor));
  }
  if (!request.lockstep) {
    lines.push_back(formatted("our own: %lld ticks (%.3f %%, at most %.1f %% %s FIFO)",
                              static_cast<long long>(verdict.missed - verdict.stalled),
                              1e2 * share_of(verdict.missed - verdict.stalled, verdict.ticks), 1e2 * verdict.missed_allowed,
                              verdict.fifo ? "with" : "WITHOUT"));
  }
  if (verdict.timer_missed > 0 && share_of(verdict.timer_missed, verdict.ticks) > kMachineTooBad) {
    lines.push_back(
        formatted("this machine is too restless for real time: a bare timer misses %.1f %% of the ticks "
                  "by itself; "
                  "end other programs, or use a machine that is not shared (./twinbus doctor --rt)",
                  1e2 * share_of(verdict.timer_missed, verdict.ticks)));
  }
  if (verdict.answer_median_us > 0.0) {
    lines.push_back(formatted("STATE sent to COMMAND obeyed: median %.0f us, 99 %% within %.0f us",
                              verdict.answer_median_us, verdict.answer_p99_us));
  }
  lines.push_back(verdict.fell ? "the robot fell" : "no fall");
  if (!verdict.doubts.empty()) lines.push_back(verdict.doubts);
  if (verdict.not_recorded > 0 && !request.whole_log) lines.push_back(cut_log_text(verdict.not_recorded));
  if (verdict.by_operator) lines.push_back(formatted("ended by the operator after %.1f s", verdict.measured));
  for (const std::string& failure : verdict.failures) lines.push_back("FAILED: " + failure);
  if (verdict.passed) lines.push_back(passed_line(verdict.doubted_steps, verdict.not_recorded > 0));
  return lines;
}

std::string report_json(const RunVerdict& verdict, const RunRequest& request, const StackMonitor& seen,
                        double wall_s, const std::string& state_hash) {
  const RunFigures& f = seen.figures();
  const double sim_time = f.truths > 0 ? f.sim_time - f.first_sim_time
                                       : static_cast<double>(verdict.ticks) * request.period;
  nlohmann::ordered_json report;
  report["scene"] = request.scene;
  report["robot"] = request.robot;
  report["engine"] = request.engine;
  report["contact"] = request.contact;
  report["step_s"] = request.step_s;
  report["seed"] = request.seed;
  report["sim_time_s"] = sim_time;
  report["wall_s"] = wall_s;
  report["realtime_factor"] = wall_s > 0.0 ? number(sim_time / wall_s) : nlohmann::json();
  report["ticks"] = verdict.ticks;
  report["missed_ticks"] = verdict.missed;
  report["fell"] = verdict.fell;
  report["max_tilt_deg"] = number(kDegrees * f.max_tilt);
  report["base_final_xyyaw"] = {f.base[0], f.base[1], f.base[2]};
  report["zmp_margin_min_mm"] = number(1e3 * f.zmp_margin_min);
  report["slip_max_mm"] = number(1e3 * f.slip_max);
  report["penetration_max_mm"] = number(1e3 * f.penetration_max);
  report["self_collision_ticks"] = f.self_collision_ticks;
  report["doubted_steps"] = doubts_json(doubts_of(f));
  report["foot_force_rms_error_n"] = nullptr;  // needs the reference, which only `run` has
  report["state_hash"] =
      state_hash.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(state_hash);
  report["passed"] = verdict.passed;
  report["fifo"] = verdict.fifo;
  report["state_hz"] = number(verdict.state_rate);
  report["command_hz"] = number(verdict.command_rate);
  report["stalled_ticks"] = verdict.stalled;
  report["bare_timer_missed_ticks"] = verdict.timer_missed;
  report["answer_median_us"] = number(verdict.answer_median_us);
  report["answer_p99_us"] = number(verdict.answer_p99_us);
  report["source_missed_ticks"] = verdict.source_missed;
  report["controller_missed_ticks"] = verdict.controller_missed;
  report["lockstep"] = request.lockstep;
  report["waits_for_late_commands"] = request.patient;
  report["failures"] = verdict.failures;
  report["left_out"] = verdict.left_out;
  report["messages_not_recorded"] = verdict.not_recorded;
  report["ended_by"] = verdict.by_operator ? nlohmann::ordered_json("the operator") : nlohmann::ordered_json();
  return report.dump(2) + "\n";
}

}  // namespace twinbus::launcher
