#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>

#include "common/process/arguments.h"
#include "launcher/log/log_command.h"
#include "launcher/log/log_plot.h"
#include "launcher/log/log_scan.h"
#include "launcher/stack/run_folder.h"
#include "lcmtypes/bus/wire.h"
#include "common/math/index.h"
#include "robot/description/load.h"
#include "common/process/process.h"
#include "viewer_log/view/gap_meter.h"

namespace twinbus {

namespace {

constexpr std::size_t kMostCompared = 300'000;  // compared at once: ten minutes at 500 Hz
constexpr double kMilli = 1e3;

struct Column {
  double sum = 0.0, most = 0.0, at = 0.0;
  void add(double difference, double time) {
    sum += difference * difference;
    if (std::abs(difference) > most) most = std::abs(difference), at = time;
  }
  double rms(std::int64_t count) const {
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
  }
};

struct Stream {
  std::vector<RobotState> states;  // in order of ticks
  std::int64_t first_tick = -1;
};

Stream read(const std::string& file, const std::string& channel, const Arguments& arguments) {
  Stream stream;
  scan_log(file, arguments.number("--from", 0.0, 0.0, 1e9),
           arguments.number("--to", kWholeLog, 0.0, 1e13), [&](const LogEvent& event) {
             RobotState state;
             if (event.channel != channel || decode(event.data, state) != Status::kOk) return true;
             if (!stream.states.empty() && state.tick <= stream.states.back().tick)
               return true;  // said again
             if (stream.first_tick < 0) stream.first_tick = state.tick;
             stream.states.push_back(state);
             return stream.states.size() < kMostCompared;
           });
  if (stream.states.empty()) throw std::runtime_error("log " + file + ": nothing on " + channel);
  return stream;
}

std::string joint_name(const std::optional<Model>& model, std::size_t k) {
  if (!model) return std::string("joint ").append(std::to_string(k));
  return model->joints[at(model->bus_joints[k])].name;
}

}  // namespace

int log_compare(const std::vector<std::string>& words) {
  const Arguments arguments(
      {"log compare",
       "A [B]",
       "Residuals between two logs, tick by tick from the first of each, or between two sources in "
       "one log,\n"
       "at the same ticks: joint angles, torques, foot forces, tilt.",
       {{"--channels", "A,B", "default STATE,STATE; for one log, as in STATE,STATE_BRIDGE"},
        {"--shift", "TICKS", "B is this many ticks later"},
        {"--plot", "F.svg", "foot forces, the joint that differs most, and its residual"},
        {"--from", "S", "seconds from the first event"},
        {"--to", "S", "seconds from the first event"},
        {"--most-mrad", "X", "exit status 1 if a joint differs by more (root mean square)"},
        robot_option()},
       1,
       2},
      words);
  catch_quit_signals();
  const bool one_log = arguments.words().size() == 1;
  const std::string channels = arguments.text("--channels", "STATE,STATE");
  const std::size_t comma = channels.find(',');
  if (comma == std::string::npos)
    throw UsageError("log compare: --channels wants two, as in STATE,STATE_BRIDGE");
  const std::string name_a = channels.substr(0, comma), name_b = channels.substr(comma + 1);
  if (one_log && name_a == name_b)
    throw UsageError(
        "log compare: one log and one channel: say which two, as in --channels STATE,STATE_BRIDGE");
  const std::string file_a = arguments.word(0), file_b = one_log ? file_a : arguments.word(1);
  const auto shift = static_cast<std::int64_t>(arguments.number("--shift", 0.0, -1e9, 1e9));
  const Stream a = read(file_a, name_a, arguments), b = read(file_b, name_b, arguments);
  const std::int64_t offset = (one_log ? 0 : b.first_tick - a.first_tick) + shift;

  std::map<std::int64_t, const RobotState*> by_tick;
  for (const RobotState& state : b.states) by_tick[state.tick - offset] = &state;
  const RobotState& first = a.states.front();
  if (first.model_hash != b.states.front().model_hash)
    throw std::runtime_error("log compare: the two are of different robots (model hash)");
  const std::size_t joints = at(first.joint_count);
  const double period = 1e-9 * static_cast<double>(first.period_ns);
  std::vector<Column> q(joints), tau(joints), foot(6), tilt(2);
  std::vector<const RobotState*> pairs[2];
  for (const RobotState& state : a.states) {
    const auto found = by_tick.find(state.tick);
    if (found == by_tick.end()) continue;
    const Gap gap = gap_between(state, *found->second);
    const double time = period * static_cast<double>(state.tick - a.first_tick);
    for (std::size_t k = 0; k < joints; ++k) {
      q[k].add(static_cast<double>(gap.q[k]), time);
      tau[k].add(static_cast<double>(gap.tau[k]), time);
    }
    for (std::size_t i = 0; i < 6; ++i)
      foot[i].add(static_cast<double>(gap.foot_force[i / 3][i % 3]), time);
    for (std::size_t i = 0; i < 2; ++i) tilt[i].add(static_cast<double>(gap.tilt[i]), time);
    pairs[0].push_back(&state);
    pairs[1].push_back(found->second);
  }
  const auto count = static_cast<std::int64_t>(pairs[0].size());
  if (count == 0)
    throw std::runtime_error(
        "log compare: no tick is in both; two logs of different runs are aligned at their first "
        "STATE, two channels of one log at the same tick");

  std::optional<Model> model;
  try {
    Model loaded = load_robot(arguments.text("--robot", "hrp1s"));
    if (loaded.hash == first.model_hash) model.emplace(std::move(loaded));
  } catch (const std::exception&) {  // names are a kindness, not a need
  }
  std::printf("%lld ticks, %.3f s: %s %s against %s %s\n", static_cast<long long>(count),
              period * static_cast<double>(count), file_b.c_str(), name_b.c_str(), file_a.c_str(),
              name_a.c_str());
  std::printf("%-24s %12s %12s %10s   %12s %12s\n", "", "rms [mrad]", "most [mrad]", "at [s]",
              "rms [N m]", "most [N m]");
  std::size_t worst = 0;
  for (std::size_t k = 0; k < joints; ++k) {
    if (q[k].sum > q[worst].sum) worst = k;
    std::printf("%-24s %12.4f %12.4f %10.3f   %12.4f %12.4f\n", joint_name(model, k).c_str(),
                kMilli * q[k].rms(count), kMilli * q[k].most, q[k].at, tau[k].rms(count),
                tau[k].most);
  }
  const char* feet[] = {"left foot x",  "left foot y",  "left foot z",
                        "right foot x", "right foot y", "right foot z"};
  std::printf("%-24s %12s %12s %10s\n", "", "rms [N]", "most [N]", "at [s]");
  for (std::size_t i = 0; i < 6; ++i)
    std::printf("%-24s %12.4f %12.4f %10.3f\n", feet[i], foot[i].rms(count), foot[i].most,
                foot[i].at);
  std::printf("%-24s %12s %12s %10s\n", "", "rms [mrad]", "most [mrad]", "at [s]");
  for (std::size_t i = 0; i < 2; ++i)
    std::printf("%-24s %12.4f %12.4f %10.3f\n", i == 0 ? "roll" : "pitch",
                kMilli * tilt[i].rms(count), kMilli * tilt[i].most, tilt[i].at);

  if (const std::string plot = arguments.text("--plot", ""); !plot.empty()) {
    const auto curve = [&](std::size_t which, const std::string& name, auto&& value) {
      Curve c{name, {}, {}};
      for (std::size_t i = 0; i < pairs[0].size(); ++i) {
        c.x.push_back(period * static_cast<double>(pairs[0][i]->tick - a.first_tick));
        c.y.push_back(value(*pairs[which][i]));
      }
      return c;
    };
    std::vector<Panel> panels;
    for (std::size_t side = 0; side < 2; ++side) {
      const auto force = [side](const RobotState& s) {
        return static_cast<double>(s.wrench[side][2]);
      };
      panels.push_back(
          {side == 0 ? "left foot, vertical force [N]" : "right foot, vertical force [N]",
           {curve(0, "A", force), curve(1, "B", force)}});
    }
    const auto angle = [worst](const RobotState& s) { return s.q[worst]; };
    panels.push_back({joint_name(model, worst) + " [rad], the joint that differs most",
                      {curve(0, "A", angle), curve(1, "B", angle)}});
    Curve residual = curve(1, "B - A", angle);
    for (std::size_t i = 0; i < residual.y.size(); ++i)
      residual.y[i] = kMilli * (residual.y[i] - pairs[0][i]->q[worst]);
    panels.push_back({joint_name(model, worst) + ", residual [mrad]", {residual}});
    write_file(plot,
               svg_of("A: " + file_a + " " + name_a + "   B: " + file_b + " " + name_b, panels));
    std::printf("plot: %s\n", plot.c_str());
  }
  const double most = arguments.number("--most-mrad", 1e9, 0.0, 1e9);
  const double reached = kMilli * q[worst].rms(count);
  if (!(reached <= most)) std::printf("FAILED: %.4f mrad, at most %g asked\n", reached, most);
  return reached <= most ? 0 : 1;
}

}  // namespace twinbus
