// `./twinbus log`: its sub-commands; cut, filter, rename and events are here.

#include "launcher/commands/commands.h"

#include <regex.h>
#include <unistd.h>

#include <cstdio>
#include <map>
#include <utility>

#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "launcher/bus/stack_monitor.h"
#include "launcher/log/log_channels.h"
#include "launcher/log/log_doubts.h"
#include "launcher/log/log_output.h"
#include "launcher/log/log_scan.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/wire.h"
#include "lcmtypes/msg/labels.h"
#include "viewer_log/log/log_writer.h"

namespace twinbus::inline launcher {

namespace {

constexpr Command kTools[] = {
    {"info", "channels, rates, duration; --check reads every byte", &log_info},
    {"cut", "part of a log by time", &log_cut},
    {"filter", "only some channels", &log_filter},
    {"rename", "channels under other names", &log_rename},
    {"csv", "a channel as a table", &log_csv},
    {"mcap", "for Foxglove and PlotJuggler: MCAP with JSON messages", &log_mcap},
    {"plot", "any fields over time, as SVG or PNG", &log_plot},
    {"events", "what was said, asked, stopped and switched, in order", &log_events},
    {"compare",
     "two logs, or two sources in one: residuals per joint and foot force, table and plot",
     &log_compare},
    {"rerun", "controller, guard and estimator again, bit for bit", &log_rerun},
};

// A whole name against an extended regular expression.
class NamePattern {
 public:
  explicit NamePattern(const std::string& text) {
    if (regcomp(&compiled_, ("^(" + text + ")$").c_str(), REG_EXTENDED | REG_NOSUB) != 0)
      throw UsageError("log: '" + text + "' is no regular expression");
  }
  ~NamePattern() { regfree(&compiled_); }
  NamePattern(const NamePattern&) = delete;
  NamePattern& operator=(const NamePattern&) = delete;
  bool matches(std::string_view name) {
    auto [found, is_new] = known_.try_emplace(std::string(name), false);
    if (is_new) found->second = regexec(&compiled_, found->first.c_str(), 0, nullptr, 0) == 0;
    return found->second;
  }

 private:
  regex_t compiled_{};
  std::map<std::string, bool, std::less<>> known_;
};

constexpr std::size_t kMostSenders = 10'000;

// "balance", "sway"
const char* what_is_asked(const ModeRequest& request) {
  if (request.motion == Motion::kSway) return "sway";
  if (request.motion == Motion::kSquat) return "squat";
  return label(request.mode);
}

int copy(const Arguments& arguments,
         const std::function<std::string_view(std::string_view)>& name_now) {
  catch_quit_signals();
  const std::string in = arguments.word(0), out = log_output(arguments, in);
  LogWriter writer(out);
  remove_later_parts(out);
  scan_log(in, arguments.number("--from", 0.0, 0.0, 1e9),
           arguments.number("--to", kWholeLog, 0.0, 1e13), [&](const LogEvent& event) {
             const std::string_view name = name_now(event.channel);
             if (!name.empty()) writer.add(event.utime, name, event.data);
             return true;
           });
  writer.close();
  if (writer.events() == 0) {
    (void)::unlink(out.c_str());
    print_typed(stderr, "log: nothing of %s was asked: %s is not written (./twinbus log info %s lists channels and duration)\n",
                in.c_str(), out.c_str(), in.c_str());
    return 1;
  }
  std::printf("%s: %lld events, %.1f MB\n", out.c_str(), static_cast<long long>(writer.events()),
              1e-6 * static_cast<double>(writer.size()));
  return 0;
}

}  // namespace

int log_cut(const std::vector<std::string>& words) {
  const Arguments arguments({"log cut", 2, 2, R"(IN OUT
Copies the part of a log between two times.
  --from --to --force)"}, words);
  return copy(arguments, [](std::string_view name) { return name; });
}

int log_filter(const std::vector<std::string>& words) {
  const Arguments arguments({"log filter", 2, 2, R"(IN OUT
Copies some channels of a log.
  --channels RE  those that match this regular expression; default all
  --not RE  without those that match this one
  --from --to --force)"}, words);
  NamePattern wanted(arguments.text("--channels", ".*")), unwanted(arguments.text("--not", ""));
  return copy(arguments, [&](std::string_view name) {
    return wanted.matches(name) && !unwanted.matches(name) ? name : std::string_view();
  });
}

int log_rename(const std::vector<std::string>& words) {
  const Arguments arguments({"log rename", 3, 64, R"(IN OUT OLD=NEW...
Copies a log with channels under other names, as in STATE=STATE_YESTERDAY.
  --force)"}, words);
  std::map<std::string, std::string, std::less<>> names;
  for (std::size_t i = 2; i < arguments.words().size(); ++i) {
    const std::string& word = arguments.words()[i];
    const std::size_t equal = word.find('=');
    if (equal == 0 || equal == std::string::npos || equal + 1 == word.size() ||
        word.size() - equal > 64)
      throw UsageError("log rename: wants OLD=NEW, not '" + word + "'");
    names[word.substr(0, equal)] = word.substr(equal + 1);
  }
  std::vector<std::string> old;
  for (const auto& [name, new_name] : names) old.push_back(name);
  require_channels("log rename", old, arguments.word(0));
  return copy(arguments, [&](std::string_view name) {
    const auto found = names.find(name);
    return found != names.end() ? std::string_view(found->second) : name;
  });
}

int log_events(const std::vector<std::string>& words) {
  const Arguments arguments({"log events", 1, 1, R"(FILE
What was said, asked, stopped and switched, with time and tick.
  --from --to --prefix)"}, words);
  catch_quit_signals();
  const std::string file = arguments.word(0), prefix = arguments.text("--prefix", "");
  require_prefix("log events", prefix, file);
  LogReader first(file);
  const std::int64_t start = first_time(first, file);
  RobotState last;
  std::map<std::pair<std::int64_t, std::int32_t>, bool>
      told;  // sender and sequence of what is sent several times
  const auto line = [&](const LogEvent& event, std::int64_t tick, const std::string& text) {
    std::printf("%10.3f s  tick %-8lld %s\n",
                1e-6 * (static_cast<double>(event.utime) - static_cast<double>(start)),
                static_cast<long long>(tick), text.c_str());
  };
  std::map<std::int64_t, ProcessKind> senders;  // by heartbeat or event
  const auto who = [&](std::int64_t sender) -> std::string {
    const auto found = senders.find(sender);
    if (found == senders.end()) return "by a command or program";
    if (found->second == ProcessKind::kUser) return "by a command or program";
    return std::string("by the ") + process_name(found->second);
  };
  // The script of a scene is said by its source.
  const auto who_of_a_scene = [&](std::int64_t sender) -> std::string {
    const auto found = senders.find(sender);
    const bool source =
        found != senders.end() && (found->second == ProcessKind::kSimulator || found->second == ProcessKind::kBridge);
    return source ? "by the scene" : who(sender);
  };
  LogDoubts doubts;
  std::map<std::int64_t, std::string> switched;  // who asked a source for a switch, by its run
  const auto stop_line = [&](const StopRequest& m) -> std::string {
    if (m.kind == StopKind::kNone) return "clear asked, " + who(m.sender_id);
    if (m.reason != StopReason::kSwitch) return std::string("stop asked: ") + label(m.kind) + ", " + who(m.sender_id);
    const auto asker = switched.find(m.sender_id);
    return "rest asked before a switch, " + who(m.sender_id) +
           (asker != switched.end() ? "; the switch was asked " + asker->second : std::string());
  };
  const auto first_time_told = [&](const auto& m) {
    return told.emplace(std::pair(m.sender_id, m.sequence), true).second;
  };
  scan_log(file, arguments.number("--from", 0.0, 0.0, 1e9),
           arguments.number("--to", kWholeLog, 0.0, 1e13), [&](const LogEvent& event) {
             if (!event.channel.starts_with(prefix)) return true;
             const std::string_view name = event.channel.substr(prefix.size());
             if (name == channel::kTruth) {
               for (const std::string& sentence : doubts.add(name, event.data)) line(event, last.tick, sentence);
             } else if (name == channel::kState) {
               RobotState s;
               if (decode(event.data, s) != Status::kOk) return true;
               if (s.run_id != last.run_id || s.term != last.term)
                 line(event, s.tick,
                      std::string(source_name(s.source)) + " holds STATE, term " +
                          std::to_string(s.term));
               if (s.stop_kind != last.stop_kind)
                 line(event, s.tick, std::string("stop: ") + label(s.stop_kind));
               last = s;
             } else if (name == channel::kEvent) {
               Event m;
               if (decode(event.data, m) == Status::kOk)
                 line(event, m.tick, std::string(process_name(m.kind)) + ": " + m.text.data());
             } else if (name == channel::kModeRequest) {
               ModeRequest m;
               if (decode(event.data, m) == Status::kOk && first_time_told(m))
                 line(event, last.tick,
                      std::string("mode asked: ") + what_is_asked(m) + ", " + who_of_a_scene(m.sender_id));
             } else if (name == channel::kStop) {
               StopRequest m;
               if (decode(event.data, m) == Status::kOk && first_time_told(m))
                 line(event, last.tick, stop_line(m));
             } else if (name == channel::kSourceRequest) {
               SourceRequest m;
               if (decode(event.data, m) == Status::kOk && first_time_told(m)) {
                 line(event, last.tick,
                      std::string(label(m.action)) + " asked for run " +
                          std::to_string(m.target_run_id) + ", " + who(m.sender_id));
                 if (m.action == SourceAction::kSwitch && switched.size() < kMostSenders) switched[m.run_id] = who(m.sender_id);
               }
             } else if (name == channel::kHeartbeat) {
               Heartbeat m;
               if (decode(event.data, m) == Status::kOk && senders.size() < kMostSenders)
                 senders[m.process_id] = m.kind;
             }
             return true;
           });
  return 0;
}

int log_command(const std::vector<std::string>& words) {
  std::string help = "usage: ./twinbus log TOOL FILE...\n\n";
  std::vector<std::string> names;
  for (const Command& tool : kTools) {
    help += formatted("  %-8s %s\n", tool.name, tool.about);
    names.emplace_back(tool.name);
  }
  if (words.empty()) throw UsageError("log: which tool? ./twinbus log --help lists them");
  if (words[0] == "--help" || words[0] == "-h") {
    print_typed(stdout, "%s\n./twinbus log TOOL --help says more.\n", help.c_str());
    return 0;
  }
  for (const Command& tool : kTools) {
    if (words[0] == tool.name) return tool.run({words.begin() + 1, words.end()});
  }
  throw UsageError("log: no tool '" + words[0] + "'" + suggestion(words[0], names));
}

}  // namespace twinbus::launcher
