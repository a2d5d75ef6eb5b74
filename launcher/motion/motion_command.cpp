// `./twinbus motion`: checks a recorded motion tick by tick, and asks the robot that runs to play it.

#include "launcher/commands/commands.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/text/formatted.h"
#include "control/motion/motion_check.h"
#include "launcher/bus/bus_link.h"
#include "launcher/motion/motion_play.h"
#include "launcher/stack/asked_robot.h"
#include "robot/description/load.h"
#include "robot/motion/motion_clip.h"
#include "robot/motion/motion_file.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::size_t kMostRows = 40;  // that people are shown; --csv has all
constexpr double kSpeedRoom = 0.99;

MotionFormat format_of(const Arguments& arguments) {
  MotionFormat format;
  if (arguments.has("--rate")) format.rate = arguments.number("--rate", 0.0, 1.0, 10'000.0);
  if (arguments.has("--columns")) format.columns = motion_columns(arguments.text("--columns", ""));
  format.quaternion_xyzw = !arguments.has("--wxyz");
  format.from = arguments.number("--from", 0.0, 0.0, 1e6);
  format.until = arguments.number("--until", 0.0, 0.0, 1e6);
  if (format.until > 0.0 && !(format.until > format.from))
    throw UsageError("motion: --until must be later than --from");
  return format;
}

const char* unit_of(const MotionFault& fault, const Model& model) {
  const int joint = model.find_joint(fault.what);
  const bool slides =
      joint >= 0 && model.joints[static_cast<std::size_t>(joint)].kind == JointKind::kPrismatic;
  switch (fault.kind) {
    case FaultKind::kPosition:
      return slides ? "m" : "rad";
    case FaultKind::kSpeed:
      return slides ? "m/s" : "rad/s";
    case FaultKind::kEffort:
      return slides ? "N" : "N m";
    default:
      return "m";
  }
}

void write_csv(const std::string& file, const std::vector<MotionFault>& faults,
               const Model& model) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (out == nullptr) throw std::runtime_error(file + ": cannot be written");
  std::fprintf(out, "tick,time,last_tick,worst_tick,check,what,value,limit,unit\n");
  for (const MotionFault& f : faults)
    std::fprintf(out, "%" PRId64 ",%.4f,%" PRId64 ",%" PRId64 ",%s,%s,%.6g,%.6g,%s\n", f.tick,
                 static_cast<double>(std::max<std::int64_t>(0, f.tick)) * model.period(),
                 f.last_tick, f.worst_tick, label(f.kind), f.what.c_str(), f.value, f.limit,
                 unit_of(f, model));
  if (std::fclose(out) != 0) throw std::runtime_error(file + ": cannot be written to its end");
}

void print_faults(const std::vector<MotionFault>& faults, const Model& model) {
  if (faults.empty()) return;
  std::printf("%8s %9s  %-9s %-44s %10s %10s  %s\n", "tick", "time [s]", "check", "joint or links",
              "value", "limit", "lasts [s]");
  for (std::size_t i = 0; i < faults.size() && i < kMostRows; ++i) {
    const MotionFault& f = faults[i];
    if (f.tick < 0) {
      std::printf("%8s %9s", "-", "on a way");
    } else {
      std::printf("%8" PRId64 " %9.3f", f.tick, static_cast<double>(f.tick) * model.period());
    }
    std::printf("  %-9s %-44s %10.4g %10.4g  %.3f %s\n", label(f.kind), f.what.c_str(), f.value,
                f.limit, static_cast<double>(f.last_tick - f.tick) * model.period(),
                unit_of(f, model));
  }
  if (faults.size() > kMostRows)
    print_typed(stdout, "... and %zu more (--csv FILE has all)\n", faults.size() - kMostRows);
}

void print_summary(const MotionClip& clip, const MotionFile& file, const MotionVerdict& v,
                   const Model& model, bool as_recorded) {
  int named = 0;
  for (int k = 0; k < model.bus_count(); ++k) named += static_cast<int>(clip.named() >> k & 1);
  std::printf("motion: %s on %s: %d frames, %.2f s at speed %.2f, %d of %d joints, %s root\n",
              file.file.c_str(), model.name.c_str(), file.frames(), clip.duration(), clip.speed(),
              named, model.bus_count(), clip.has_root() ? "with" : "without");
  if (clip.moves_legs() && !as_recorded)
    std::printf(
        "motion: legs: the soles stand; %.0f %% of the way of the centre of mass, %.0f mm deep of "
        "%.0f mm asked\n",
        100.0 * clip.com_share(), 1e3 * clip.depth(), 1e3 * clip.asked_depth());
  std::string line;
  if (!v.speed_joint.empty()) {
    line += formatted("fastest %s, %.0f %% of its limit", v.speed_joint.c_str(), 100.0 * v.speed_share);
  }
  if (!v.effort_joint.empty()) {
    line += formatted("; strongest %s, %.0f %%", v.effort_joint.c_str(), 100.0 * v.effort_share);
  }
  if (!v.nearest_pair.empty()) {
    line += formatted("; nearest %s, %.1f mm", v.nearest_pair.c_str(), 1e3 * v.nearest);
  }
  if (v.balance_known) {
    line += formatted("; zero-moment point %.1f mm inside the soles", 1e3 * v.least_margin);
  }
  if (!line.empty())
    std::printf("motion: %s\n", line.starts_with("; ") ? line.c_str() + 2 : line.c_str());
  if (v.speed_share > 1.0)
    print_typed(stdout, "motion: at --speed %.2f its speeds are within the limits\n",
                std::floor(100.0 * kSpeedRoom * clip.speed() / v.speed_share) / 100.0);
}

}  // namespace

int motion_file_command(const std::vector<std::string>& words) {
  const Arguments arguments({"motion", 1, 1, R"(FILE
Checks a motion before it plays: positions, speeds and efforts of the joints, links that touch, balance.
FILE is CSV with a row of names (time, root_x root_y root_z root_qw root_qx root_qy root_qz, joints), CSV
without one and --columns, or NPZ (joint_pos or dof_pos, joint_names, fps, root_pos and root_rot).
A standing robot plays the joints of its trunk and arms as they are; its legs keep the soles where they stand
and move the centre of mass as far as balance allows.  Exit status 1 if anything is wrong: then it is not played.
  --robot R  default the robot of the running ./twinbus up, else hrp1s
  --check  only check, which is what it does without --play
  --play  and then play it on the robot that runs (./twinbus up); a walk is brought to rest first
  --as-recorded  every joint as the file has it, legs too: for a policy that tracks it
  --columns lafan1|FILE  names of the columns of a CSV without a row of names
  --rate HZ  frames a second of a file that does not say
  --from S  the part that is taken [s]
  --until S  its end [s]
  --speed SHARE  how fast it is played, 0.05 to 1; default 1
  --upper  nothing of what the legs do
  --wxyz  root_rot of an NPZ has w first
  --csv FILE  every fault
  --prefix --url --allow)"}, words);
  if (arguments.has("--play") && (arguments.has("--check") || arguments.has("--as-recorded")))
    throw UsageError(
        "motion: --play stands without --check and --as-recorded; legs as recorded are for a "
        "policy");
  const Model model = load_robot(asked_robot(arguments));
  const MotionFile file = read_motion(arguments.word(0), format_of(arguments));
  MotionOptions options;
  options.speed = arguments.number("--speed", 1.0, 0.05, 1.0);
  options.upper_only = arguments.has("--upper");
  const MotionClip clip(model, file, options);
  MotionCheckConfig config;
  config.as_recorded = arguments.has("--as-recorded");
  const MotionVerdict verdict = check_motion(model, clip, config);
  print_faults(verdict.faults, model);
  print_summary(clip, file, verdict, model, config.as_recorded);
  if (arguments.has("--csv")) write_csv(arguments.text("--csv", ""), verdict.faults, model);
  if (!verdict.passed()) {
    std::printf("motion: refused: %zu fault%s\n", verdict.faults.size(), verdict.faults.size() == 1 ? "" : "s");
    return 1;
  }
  std::printf("motion: passed\n");
  if (!arguments.has("--play")) return 0;
  std::fflush(stdout);
  BusLink bus = open_bus(arguments);
  return play_motion(bus, model, clip);
}

}  // namespace twinbus::launcher
