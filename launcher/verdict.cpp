#include "launcher/verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace twinbus {

namespace {

constexpr double kMissedWithFifo = 0.001;     // share of ticks
constexpr double kMissedWithoutFifo = 0.01;
constexpr double kRateTolerance = 0.01;       // share of the rate asked for
constexpr double kDegrees = 57.29577951308232;

std::string text(const char* format, double a, double b = 0.0) {
  char line[160];
  std::snprintf(line, sizeof line, format, a, b);
  return line;
}

// NaN and "never" become null: JSON has no words for them.
nlohmann::json number(double value) {
  if (!std::isfinite(value) || std::abs(value) >= 1e9) return nullptr;
  return value;
}

}  // namespace

std::int64_t controller_missed_ticks(const Lookout& seen, std::int64_t now_ns) {
  std::int64_t missed = 0;
  for (const SeenProcess* process : seen.processes(now_ns, 2.0)) {
    if (process->beat.kind == ProcessKind::kController) missed += process->beat.ticks_missed;
  }
  return missed;
}

bool runs_at_fifo(const Lookout& seen, std::int64_t now_ns) {
  bool source = false;
  bool controller = false;
  bool all = true;
  for (const SeenProcess* process : seen.processes(now_ns, 2.0)) {
    const ProcessKind kind = process->beat.kind;
    const bool is_source = kind == ProcessKind::kSimulator || kind == ProcessKind::kBridge;
    const bool is_controller = kind == ProcessKind::kController;
    if (!is_source && !is_controller) continue;
    source = source || is_source;
    controller = controller || is_controller;
    all = all && process->beat.realtime >= 1;
  }
  return source && controller && all;
}

RunVerdict judge(const Lookout& seen, const RunRequest& request, const CountersAtStart& start, std::int64_t now_ns) {
  RunVerdict verdict;
  verdict.ticks = seen.state().received();
  verdict.state_rate = seen.state().mean_rate();
  verdict.command_rate = seen.command().mean_rate();
  verdict.rate_wanted = request.rate / request.period;
  verdict.fifo = runs_at_fifo(seen, now_ns);
  verdict.missed_allowed = verdict.fifo ? kMissedWithFifo : kMissedWithoutFifo;
  verdict.fell = seen.figures().fell;
  if (const SeenSource* active = seen.active(now_ns)) {
    verdict.source_missed = active->status.ticks_missed - start.source_missed;
    if (active->status.role == Role::kStopped) {
      verdict.failures.push_back(std::string("the source is stopped (") + stop_name(active->status.stop_kind) + ")");
    }
  } else {
    verdict.failures.push_back("no source is active at the end");
  }
  verdict.controller_missed = controller_missed_ticks(seen, now_ns) - start.controller_missed;
  verdict.missed = std::max(verdict.source_missed, verdict.controller_missed);

  if (!request.lockstep) {
    for (const auto& [name, rate] : {std::pair("STATE", verdict.state_rate), std::pair("COMMAND", verdict.command_rate)}) {
      if (!(std::abs(rate - verdict.rate_wanted) <= kRateTolerance * verdict.rate_wanted)) {
        verdict.failures.push_back(std::string(name) + text(" came at %.1f Hz, %.1f Hz were asked", rate, verdict.rate_wanted));
      }
    }
    const double share = verdict.ticks > 0 ? static_cast<double>(verdict.missed) / static_cast<double>(verdict.ticks) : 1.0;
    if (!(share <= verdict.missed_allowed)) {
      verdict.failures.push_back(text("%.3f %% of ticks missed, %.1f %% allowed", 1e2 * share, 1e2 * verdict.missed_allowed));
    }
  }
  if (verdict.fell) verdict.failures.push_back("the robot fell");
  verdict.passed = verdict.failures.empty();
  return verdict;
}

std::vector<std::string> verdict_lines(const RunVerdict& verdict, const RunRequest& request) {
  std::vector<std::string> lines;
  lines.push_back(text("STATE %.1f Hz, COMMAND %.1f Hz", verdict.state_rate, verdict.command_rate) +
                  (request.lockstep ? " (lock-step)" : text(", asked %.1f Hz", verdict.rate_wanted)));
  const double share = verdict.ticks > 0 ? 1e2 * static_cast<double>(verdict.missed) / static_cast<double>(verdict.ticks) : 0.0;
  char line[200];
  std::snprintf(line, sizeof line, "missed %lld of %lld ticks (%.3f %%, at most %.1f %% %s FIFO; source %lld, controller %lld)",
                static_cast<long long>(verdict.missed), static_cast<long long>(verdict.ticks), share,
                1e2 * verdict.missed_allowed, verdict.fifo ? "with" : "without",
                static_cast<long long>(verdict.source_missed), static_cast<long long>(verdict.controller_missed));
  lines.push_back(line);
  lines.push_back(verdict.fell ? "the robot fell" : "no fall");
  for (const std::string& failure : verdict.failures) lines.push_back("FAILED: " + failure);
  if (verdict.passed) lines.push_back("passed");
  return lines;
}

std::string report_json(const RunVerdict& verdict, const RunRequest& request, const Lookout& seen, double wall_s,
                        const std::string& state_hash) {
  const RunFigures& f = seen.figures();
  const double sim_time = f.truths > 0 ? f.sim_time - f.first_sim_time : static_cast<double>(verdict.ticks) * request.period;
  nlohmann::ordered_json report;
  report["scene"] = request.scene;
  report["robot"] = request.robot;
  report["engine"] = request.engine;
  report["contact"] = "spring_damper";
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
  report["foot_force_rms_error_n"] = nullptr;  // needs the reference, which only `run` has
  report["state_hash"] = state_hash.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(state_hash);
  report["passed"] = verdict.passed;
  report["fifo"] = verdict.fifo;
  report["state_hz"] = number(verdict.state_rate);
  report["command_hz"] = number(verdict.command_rate);
  report["source_missed_ticks"] = verdict.source_missed;
  report["controller_missed_ticks"] = verdict.controller_missed;
  report["lockstep"] = request.lockstep;
  report["failures"] = verdict.failures;
  return report.dump(2) + "\n";
}

}  // namespace twinbus
