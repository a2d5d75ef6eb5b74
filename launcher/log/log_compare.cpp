// `log compare`: residuals of two logs or sources, tick by tick: joint angles, torques, foot forces, tilt.

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "common/file/write_file.h"
#include "common/math/index.h"
#include "common/process/arguments.h"
#include "common/process/process.h"
#include "launcher/log/log_channels.h"
#include "launcher/commands/commands.h"
#include "launcher/log/log_plot.h"
#include "launcher/log/log_robot.h"
#include "launcher/log/log_scan.h"
#include "launcher/stack/run_folder.h"
#include "lcmtypes/bus/wire.h"
#include "viewer_log/view/gap_meter.h"

namespace twinbus::inline launcher {

namespace {

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

// The states of one channel in order of ticks, one at a time, however long the log is.
class Stream {
 public:
  Stream(const std::string& file, std::string channel, const Arguments& arguments)
      : file_(file), channel_(std::move(channel)), reader_(file) {
    const std::int64_t start = start_ = first_time(reader_, file);
    const double from = arguments.number("--from", 0.0, 0.0, 1e9),
                 to = arguments.number("--to", kWholeLog, 0.0, 1e13);
    if (from > 0.0) reader_.seek(start + std::llround(1e6 * from));
    if (to < kWholeLog) last_utime_ = start + std::llround(1e6 * to);
    if (!next()) throw std::runtime_error(nothing_on("log compare", channel_, file));
    first_tick_ = state_.tick;
  }
  // False at the end.
  bool next() {
    for (LogEvent event; reader_.next(event) && event.utime <= last_utime_;) {
      if (++events_ % kLookEvery == 0 && quit_requested())
        throw std::runtime_error("ended by the user");
      RobotState state;
      if (event.channel != channel_ || decode(event.data, state) != Status::kOk) continue;
      if (state.tick <= state_.tick) {  // said again
        if (!begins_anew(state.tick)) continue;
        end_s_ = 1e-6 * (static_cast<double>(event.utime) - static_cast<double>(start_));
        return false;
      }
      fallen_tick_ = -1;
      state_ = state;
      return true;
    }
    return false;
  }
  const RobotState& state() const { return state_; }
  std::int64_t first_tick() const { return first_tick_; }
  // Where the stream ended because the world was begun anew, from the first event [s]; -1: it did not.
  double end_s() const { return end_s_; }

 private:
  // A few ticks one after the other, far below the last: no damaged number and nothing said again.
  bool begins_anew(std::int64_t tick) {
    if (tick >= state_.tick - kFar) return false;
    in_order_ = fallen_tick_ >= 0 && tick > fallen_tick_ && tick <= fallen_tick_ + kFar ? in_order_ + 1 : 1;
    fallen_tick_ = tick;
    return in_order_ >= kEnough;
  }

  static constexpr std::int64_t kFar = 100;  // [ticks]
  static constexpr int kEnough = 5;
  static constexpr std::int64_t kLookEvery = 1 << 14;
  std::string file_, channel_;
  LogReader reader_;
  RobotState state_{.tick = -1};
  std::int64_t first_tick_ = -1, events_ = 0, start_ = 0, fallen_tick_ = -1;
  int in_order_ = 0;
  double end_s_ = -1.0;
  std::int64_t
               last_utime_ = std::numeric_limits<std::int64_t>::max();
};

// Every tick that both have; visit(a, b).
void each_pair(Stream& a, Stream& b, std::int64_t offset,
               const std::function<void(const RobotState&, const RobotState&)>& visit) {
  for (bool more = true; more;) {
    const std::int64_t ahead = b.state().tick - offset - a.state().tick;
    if (ahead == 0) visit(a.state(), b.state());
    if (ahead >= 0) more = a.next();
    if (ahead <= 0) more = b.next() && more;
  }
}

struct LongCurve {
  Curve curve;
  CurveFiller filler;
  void add(double x, double y) { filler.add(curve, x, y); }
};

std::string joint_name(const std::optional<Model>& model, std::size_t k) {
  if (!model) return std::string("joint ").append(std::to_string(k));
  return model->joints[at(model->bus_joints[k])].name;
}

}  // namespace

int log_compare(const std::vector<std::string>& words) {
  const Arguments arguments({"log compare", 1, 2, R"(A [B]
Residuals between two logs, tick by tick from the first of each, or between two sources in one log,
at the same ticks: joint angles, torques, foot forces, tilt.
  --channels A,B  default STATE,STATE; for one log, as in STATE,STATE_BRIDGE
  --shift TICKS  B is this many ticks later
  --plot F.svg  foot forces, the joint that differs most, and its residual
  --from --to
  --most-mrad X  exit status 1 if a joint differs by more (root mean square)
  --robot)"}, words);
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
  Stream a(file_a, name_a, arguments), b(file_b, name_b, arguments);
  const std::int64_t offset = (one_log ? 0 : b.first_tick() - a.first_tick()) + shift;
  const RobotState first = a.state();
  if (first.model_hash != b.state().model_hash)
    throw std::runtime_error("log compare: the two are of different robots (model hash)");
  const std::size_t joints = at(first.joint_count);
  const double period = 1e-9 * static_cast<double>(first.period_ns);
  const auto time_of = [&](const RobotState& s) {
    return period * static_cast<double>(s.tick - first.tick);
  };
  std::vector<Column> q(joints), tau(joints), foot(3 * kMaxFeet), tilt(2);
  std::array<bool, kMaxFeet> felt{true, true};
  std::int64_t count = 0;
  each_pair(a, b, offset, [&](const RobotState& one, const RobotState& other) {
    const Gap gap = gap_between(one, other);
    const double time = time_of(one);
    for (std::size_t k = 0; k < joints; ++k) {
      q[k].add(static_cast<double>(gap.q[k]), time);
      tau[k].add(static_cast<double>(gap.tau[k]), time);
    }
    for (std::size_t i = 0; i < foot.size(); ++i) {
      foot[i].add(static_cast<double>(gap.foot_force[i / 3][i % 3]), time);
      felt[i / 3] = felt[i / 3] || one.wrench_kind[i / 3] != WrenchKind::kAbsent;
    }
    for (std::size_t i = 0; i < 2; ++i) tilt[i].add(static_cast<double>(gap.tilt[i]), time);
    ++count;
  });
  if (count == 0)
    throw std::runtime_error(
        "log compare: no tick is in both; two logs of different runs are aligned at their first "
        "STATE, two channels of one log at the same tick");

  const std::optional<Model> model = robot_of_hash(first.model_hash, arguments.text("--robot", ""));
  std::printf("%lld ticks, %.3f s: %s %s against %s %s\n", static_cast<long long>(count),
              period * static_cast<double>(count), file_b.c_str(), name_b.c_str(), file_a.c_str(),
              name_a.c_str());
  for (const auto& [stream, file] : {std::pair(&a, &file_a), std::pair(&b, &file_b)}) {
    if (stream->end_s() >= 0.0)
      std::printf("up to %.3f s of %s, where the world was begun anew; --from %.1f compares what follows\n", stream->end_s(),
                  file->c_str(), stream->end_s() + 0.1);
  }
  std::printf("%-24s %12s %12s %10s   %12s %12s\n", "", "rms [mrad]", "most [mrad]", "at [s]",
              "rms [N m]", "most [N m]");
  std::size_t worst = 0;
  for (std::size_t k = 0; k < joints; ++k) {
    if (q[k].sum > q[worst].sum) worst = k;
    std::printf("%-24s %12.4f %12.4f %10.3f   %12.4f %12.4f\n", joint_name(model, k).c_str(),
                kMilli * q[k].rms(count), kMilli * q[k].most, q[k].at, tau[k].rms(count),
                tau[k].most);
  }
  std::printf("%-24s %12s %12s %10s\n", "", "rms [N]", "most [N]", "at [s]");
  for (std::size_t i = 0; i < foot.size(); ++i) {
    if (!felt[i / 3]) continue;
    const std::string name = (i < 3 ? "left foot " : i < 6 ? "right foot " : "foot " + std::to_string(i / 3) + " ") + "xyz"[i % 3];
    std::printf("%-24s %12.4f %12.4f %10.3f\n", name.c_str(), foot[i].rms(count), foot[i].most, foot[i].at);
  }
  std::printf("%-24s %12s %12s %10s\n", "", "rms [mrad]", "most [mrad]", "at [s]");
  for (std::size_t i = 0; i < 2; ++i)
    std::printf("%-24s %12.4f %12.4f %10.3f\n", i == 0 ? "roll" : "pitch",
                kMilli * tilt[i].rms(count), kMilli * tilt[i].most, tilt[i].at);

  if (const std::string plot = arguments.text("--plot", ""); !plot.empty()) {
    Stream again_a(file_a, name_a, arguments), again_b(file_b, name_b, arguments);
    std::array<LongCurve, 7> curves;
    const std::array<const char*, 7> names = {"A", "B", "A", "B", "A", "B", "B - A"};
    for (std::size_t i = 0; i < curves.size(); ++i) curves[i].curve.name = names[i];
    each_pair(again_a, again_b, offset, [&](const RobotState& one, const RobotState& other) {
      const double time = time_of(one);
      for (std::size_t side = 0; side < 2; ++side) {
        curves[2 * side].add(time, static_cast<double>(one.wrench[side][2]));
        curves[2 * side + 1].add(time, static_cast<double>(other.wrench[side][2]));
      }
      curves[4].add(time, one.q[worst]);
      curves[5].add(time, other.q[worst]);
      curves[6].add(time, kMilli * (other.q[worst] - one.q[worst]));
    });
    const std::vector<Panel> panels = {
        {"left foot, vertical force [N]", {curves[0].curve, curves[1].curve}},
        {"right foot, vertical force [N]", {curves[2].curve, curves[3].curve}},
        {joint_name(model, worst) + " [rad], the joint that differs most",
         {curves[4].curve, curves[5].curve}},
        {joint_name(model, worst) + ", residual [mrad]", {curves[6].curve}}};
    write_file(plot,
               svg_of("A: " + file_a + " " + name_a + "\nB: " + file_b + " " + name_b, panels));
    std::printf("plot: %s\n", plot.c_str());
  }
  const double most = arguments.number("--most-mrad", 1e9, 0.0, 1e9);
  const double reached = kMilli * q[worst].rms(count);
  if (!(reached <= most)) std::printf("FAILED: %.4f mrad, at most %g asked\n", reached, most);
  return reached <= most ? 0 : 1;
}

}  // namespace twinbus::launcher
