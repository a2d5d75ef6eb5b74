// `log rerun`: computes every command, guard report and estimate of a log again, and compares bit for bit.

#include <cstdio>
#include <stdexcept>

#include "common/process/arguments.h"
#include "launcher/log/log_channels.h"
#include "launcher/commands/commands.h"
#include "launcher/log/log_scan.h"
#include "launcher/bus/stack_monitor.h"
#include "launcher/log/rerun.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/wire.h"
#include "robot/description/load.h"
#include "common/process/process.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kFarEnough = 200'000;  // events in which the robot must have been named

// The robot's name and model hash as the log tells them; empty and 0 when it does not.
struct LoggedRobot {
  std::string name;
  std::int64_t model_hash = 0;
};

LoggedRobot robot_of(const std::string& file, const std::string& prefix) {
  LoggedRobot robot;
  std::int64_t events = 0;
  LogReader reader(file);
  for (LogEvent event; events < kFarEnough && reader.next(event); ++events) {
    ModelTextPiece piece;
    RobotState state;
    if (event.channel == prefix + channel::kState && decode(event.data, state) == Status::kOk)
      robot.model_hash = state.model_hash;
    if (event.channel == prefix + channel::kLogText && decode(event.data, piece) == Status::kOk) {
      const std::string text(piece.text.data(), static_cast<std::size_t>(piece.count));
      const std::size_t at = text.find("robot: ");
      if (piece.kind == 6 && at != std::string::npos)
        robot.name = text.substr(at + 7, text.find('\n', at) - at - 7);
    }
    if (!robot.name.empty() && robot.model_hash != 0) break;
  }
  return robot;
}

}  // namespace

int log_rerun(const std::vector<std::string>& words) {
  const Arguments arguments({"log rerun", 1, 1, R"(FILE
Computes every command, guard report and estimate of a log again from the messages and the journal in it,
and compares bit for bit.  Exit status 0 only if all are the same and nothing is missing.
  --robot --prefix)"}, words);
  catch_quit_signals();
  const std::string file = arguments.word(0), prefix = arguments.text("--prefix", "");
  require_prefix("log rerun", prefix, file);
  const LoggedRobot logged = robot_of(file, prefix);
  const Model model =
      load_robot(arguments.text("--robot", logged.name.empty() ? "hrp1s" : logged.name));
  if (logged.model_hash != 0 && logged.model_hash != model.hash) {
    throw std::runtime_error("log " + file + ": was recorded with another robot than " +
                             model.name + " is now (model hash " +
                             std::to_string(logged.model_hash) + ", now " +
                             std::to_string(model.hash) + "); say which with --robot");
  }
  Rerun rerun(model);
  scan_log(file, 0.0, kWholeLog, [&](const LogEvent& event) {
    if (event.channel.starts_with(prefix))
      rerun.add(event.channel.substr(prefix.size()), event.utime, event.data);
    return true;
  });
  rerun.finish();
  std::int64_t answers = 0;
  const std::vector<RerunFigures> figures = rerun.figures();
  for (const RerunFigures& f : figures) {
    std::printf(
        "%s %lld: %lld steps, %lld answers, %lld different; %lld inputs, %lld missing, %lld "
        "damaged%s\n",
        process_name(f.kind), static_cast<long long>(f.id), static_cast<long long>(f.steps),
        static_cast<long long>(f.answers), static_cast<long long>(f.different),
        static_cast<long long>(f.inputs), static_cast<long long>(f.missing),
        static_cast<long long>(f.damaged), f.whole ? "" : "; NOT WHOLE");
    answers += f.answers;
  }
  for (const std::string& finding : rerun.findings()) std::printf("%s\n", finding.c_str());
  if (answers == 0) {
    std::printf("no JOURNAL in this log: nothing could be computed again\n");
    return 1;
  }
  std::printf("%s\n", rerun_verdict(figures).c_str());
  return is_same(figures) ? 0 : 1;
}

}  // namespace twinbus::launcher
