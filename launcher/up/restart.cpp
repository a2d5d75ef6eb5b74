#include "launcher/up/restart.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "common/file/write_file.h"
#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "common/text/formatted.h"
#include "launcher/commands/commands.h"
#include "launcher/stack/run_folder.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kLookForWish = 100'000'000;  // [ns]
constexpr double kMostWait = 10.0;                  // [s]
constexpr double kAnswerPause = 0.05;               // [s]

}  // namespace

RestartRequests::RestartRequests(const std::string& folder) : folder_(folder) {
  write_file(folder_ + "/pid", std::to_string(::getpid()) + "\n");
}

RestartRequests::~RestartRequests() { ::unlink((folder_ + "/pid").c_str()); }

void RestartRequests::look(Supervisor& supervisor, std::int64_t now_ns) {
  if (now_ns - looked_ns_ < kLookForWish) return;
  looked_ns_ = now_ns;
  const std::string file = folder_ + "/restart";
  if (::access(file.c_str(), F_OK) != 0) return;
  const std::string name = first_line_of(file);
  ::unlink(file.c_str());
  const std::string refusal = supervisor.restart(name, now_ns);
  std::string answer = refusal.empty() ? "ok" : refusal;
  for (const Supervised& one : supervisor.processes()) {
    const std::string& program = one.process.program;
    if (!refusal.empty() || one.process.name != name) continue;
    if (program == "twinbus_simulator") answer = "ok sim";
    if (program == "twinbus_bridge") answer = "ok bridge";
    if (program == "twinbus_replay") answer = "ok replay";
  }
  write_whole(folder_ + "/restarted", answer + "\n");
}

void keep_viewer_addresses() {
  for (const char* name : {"TWINBUS_VIEWER_TOKEN", "TWINBUS_VIEWER_WATCH_TOKEN"}) {
    const std::string token = formatted("%016llx%016llx", static_cast<unsigned long long>(random_id()),
                                        static_cast<unsigned long long>(random_id()));
    setenv(name, token.c_str(), 0);
  }
}

int restart_command(const std::vector<std::string>& words) {
  const Arguments arguments({"restart", 1, 1, R"(NAME
Ends one process of the running stack and starts it anew: controller, guard, simulator, ...
A source that is started anew is parked; it moves nothing until it is asked.)"}, words);
  const std::string folder = running_folder();
  const std::string answer = folder + "/restarted";
  ::unlink(answer.c_str());
  write_whole(folder + "/restart", arguments.word(0) + "\n");
  const std::int64_t begin = monotonic_ns();
  while (seconds_since(begin) < kMostWait) {
    ::usleep(static_cast<useconds_t>(1e6 * kAnswerPause));
    const std::string said = first_line_of(answer);
    if (said.empty()) continue;
    ::unlink(answer.c_str());
    if (said != "ok" && !said.starts_with("ok ")) throw std::runtime_error(said);
    print_typed(stdout, "%s is started anew%s%s%s\n", arguments.word(0).c_str(),
                said == "ok" ? "" : "; it is parked and moves nothing until ./twinbus switch ",
                said == "ok" ? "" : said.substr(3).c_str(), said == "ok" ? "" : " makes it active");
    return 0;
  }
  throw std::runtime_error("the stack in " + folder + " does not answer");
}

}  // namespace twinbus::launcher
