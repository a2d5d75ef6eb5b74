// `./twinbus up`: starts and supervises a stack, says what happens to it, ends it.

#include "launcher/commands/commands.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "common/file/write_file.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "common/text/formatted.h"
#include "launcher/bus/bus_health.h"
#include "launcher/bus/bus_link.h"
#include "launcher/bus/event_groups.h"
#include "launcher/bus/live_table.h"
#include "launcher/bus/redraw.h"
#include "launcher/run/judge_scene.h"
#include "launcher/run/state_hash.h"
#include "launcher/run/verdict.h"
#include "launcher/stack/face_program.h"
#include "launcher/stack/run_folder.h"
#include "launcher/stack/stack.h"
#include "launcher/stack/supervisor.h"
#include "launcher/up/first_command.h"
#include "launcher/up/restart.h"
#include "launcher/up/robot_script.h"
#include "launcher/up/setup_wish.h"
#include "launcher/up/shadow.h"
#include "launcher/up/up_accuracy.h"
#include "launcher/up/up_syntax.h"
#include "launcher/up/who_is_there.h"
#include "lcmtypes/msg/refusal_text.h"
#include "robot/description/load.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_requests.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kListenFirst = 0.4;         // sources and processes speak at 10 Hz [s]
constexpr double kActivationTimeout = 10.0;  // a source listens 1 s for other terms first [s]
constexpr double kAskAgain = 0.25, kTableEvery = 0.25;  // table: on a terminal [s]
constexpr double kLineEvery = 20.0;                     // elsewhere [s]
constexpr double kWithoutSource = 10.0;     // a stack stays for who restarts one by hand [s]
constexpr double kSettle = 0.5;  // from the first answered tick to the first counted one [s]

double seconds(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

class Up {
 public:
  explicit Up(const Arguments& arguments);
  int run();

 private:
  void refuse_if_someone_publishes();
  void start_all();
  void note_ready();
  void activate(const std::string& name);
  void wait_for_first_commands();
  bool work();  // until the end; false if something broke
  void set_up(const std::string& wish);
  bool asked_to_judge() const { return request_.duration > 0.0 || !report_.empty(); }
  bool judge_and_report(bool whole, double wall_s);
  void show(std::int64_t now_ns);
  std::string cpu_line(std::int64_t now_ns);
  void say(const std::string& line);
  bool elapsed(std::int64_t now_ns) const;
  bool is_over(std::int64_t now_ns);

  RunRequest request_;
  Scene scene_;
  Stack stack_;
  std::string report_, folder_, viewer_address_, watch_address_;
  bool terminal_ = isatty(STDOUT_FILENO) != 0;
  std::string active_;  // the process that was made active last
  StateHash hash_;
  std::unique_ptr<BusLink> bus_;
  std::unique_ptr<Supervisor> supervisor_;
  std::unique_ptr<RestartRequests> restarts_;
  std::unique_ptr<SetupWishes> wishes_;
  Placeholders values_;
  std::vector<std::string> own_settings_;  // of values_, without those of the accuracy
  double own_step_ = 0.0;                  // [s]
  std::unique_ptr<UpAccuracy> accuracy_;
  std::int64_t model_hash_ = 0;  // of the robot that runs
  Redraw redraw_;
  std::vector<std::string>* held_back_ = nullptr;  // while the run begins anew: what is said only if that fails
  CpuShare shares_;
  BusHealth health_;
  EventGroups groups_;
  MissedCounts at_start_;
  // Start of the measured part; the last table; since when no source runs.
  std::int64_t start_ns_ = 0, shown_ns_ = 0, sourceless_ns_ = 0;
  RobotScript script_;
};

Up::Up(const Arguments& arguments) {
  scene_ = load_scene(arguments.word(0, "stand"));
  request_ = request_of("up", arguments, scene_);
  request_.lockstep = arguments.has("--lockstep");
  request_.rate = arguments.number("--rate", 1.0, 0.01, 100.0);
  request_.duration = arguments.number("--for", 0.0, 0.1, 1e6);
  report_ = arguments.text("--report", "");
  const Model model = load_robot(request_.robot);  // the same error for every process, said once
  fit_scene(scene_, model);
  start_in(arguments.text("--start-pose", scene_.start_pose), model, scene_);
  request_.contact = scene_.contact;
  request_.period = model.period();
  request_.step_s = scene_.step > 0.0 ? scene_.step : model.period();
  if (arguments.has("--no-fifo")) setenv("TWINBUS_FIFO", "0", 1);  // every process inherits it
  go_ahead_of_ordinary_programs();
  // Lock-step goes as fast as it can: with real-time priority it would leave those who watch no time.
  if (request_.lockstep) setenv("TWINBUS_FIFO", "0", 1);
  stack_ = load_stack(arguments.text("--stack", arguments.has("--face") ? "client" : "sim"));
  if (arguments.has("--face")) add_face(stack_, arguments.text("--face", ""), face_options(arguments));
  request_.patient = waits_for_late_commands(arguments, stack_);
  refuse_without_log(arguments, stack_);
  request_.whole_log = records(arguments) && (arguments.has("--split") || arguments.has("--quota"));
  if (arguments.has("--no-viewer")) {
    stack_.leave_out([](const StackProcess& process) { return process.viewer; });
  }
  if (!records(arguments)) {
    stack_.leave_out([](const StackProcess& process) { return process.recorder; });
  }

  bus_ = std::make_unique<BusLink>(arguments.text("--url", ""), arguments.text("--prefix", ""),
                                   arguments.all("--allow"));
  refuse_if_someone_publishes();
  accuracy_ = std::make_unique<UpAccuracy>(arguments, model, scene_, stack_, request_);
  own_step_ = request_.step_s;
  request_.step_s = accuracy_->step_or(own_step_);
  bus_->on_raw_state([this](std::span<const std::uint8_t> bytes) { hash_.add(bytes); });

  keep_viewer_addresses();
  folder_ = make_run_folder();
  write_file(folder_ + "/stack.yaml", stack_.text);
  write_file(folder_ + "/scene.yaml", scene_.text);
  write_file(folder_ + "/commit", commit_of_program() + "\n");
  values_ = placeholders_of(arguments, request_, folder_);
  own_settings_ = values_["settings"];
  const std::vector<std::string> chosen = accuracy_->words();
  values_["settings"].insert(values_["settings"].end(), chosen.begin(), chosen.end());
  supervisor_ = std::make_unique<Supervisor>(stack_, values_, folder_,
                                             [this](const std::string& line) { say(line); });
  restarts_ = std::make_unique<RestartRequests>(folder_);
  model_hash_ = model.hash;
  const Setup now{arguments.word(0, "stand"), request_.robot, request_.engine, model.hash};
  wishes_ = std::make_unique<SetupWishes>(folder_ + "/setup", now, stack_);
}

void Up::say(const std::string& line) {
  if (held_back_ != nullptr) return held_back_->push_back(line);
  redraw_.clear();
  print_typed(stdout, "up: %s\n", line.c_str());
  std::fflush(stdout);
}

void Up::refuse_if_someone_publishes() {
  bus_->listen(kListenFirst);
  const std::string who = who_is_in_the_way(bus_->seen(), stack_, monotonic_ns());
  if (!who.empty()) {
    throw std::runtime_error(
        "someone already publishes on " + bus_->url() + ": " + who +
        "; end it first, or give this robot channels of its own with --prefix R2_");
  }
}

// Messages say which processes are there: a heartbeat has the process id, a state the run id of a heartbeat.
void Up::note_ready() {
  const StackMonitor& seen = bus_->seen();
  for (const Supervised& one : supervisor_->processes()) {
    if (one.ready || one.child.empty() || one.process.ready_when != ReadyWhen::kMessage) continue;
    const SeenProcess* process = seen.process_of_pid(one.child.front().pid());
    if (process == nullptr) continue;
    const std::string& channel = one.process.ready_channel;
    const SeenSource* source = seen.source(process->beat.process_id);
    const bool is_state =
        channel.starts_with("STATE") && source != nullptr && source->states.received() > 0;
    const bool is_status = channel == "SOURCE_STATUS" && source != nullptr && source->heard_ns > 0;
    const bool is_beat = channel == "HEARTBEAT" && process->beat.state != 0;
    if (is_state || is_status || is_beat) supervisor_->heard_from_name(one.process.name);
  }
}

void Up::start_all() {
  const std::int64_t begin = monotonic_ns();
  std::vector<std::string> told;
  while (!quit_requested()) {
    bus_->receive(0.02);
    note_ready();
    supervisor_->start_more(monotonic_ns());
    for (const Supervised& one : supervisor_->processes()) {
      if (!one.ready || std::find(told.begin(), told.end(), one.process.name) != told.end())
        continue;
      told.push_back(one.process.name);
      for (const std::string& line : one.child.front().last_lines(20)) {
        const std::size_t at = line.find("http://");
        if (one.process.viewer && at != std::string::npos) {
          const bool ours = line.find("ready at") != std::string::npos;
          (ours ? viewer_address_ : watch_address_) = line.substr(at, line.find(' ', at) - at);
        }
      }
    }
    if (supervisor_->all_ready()) break;
  }
  if (quit_requested()) return say("ended by the operator before everything was ready");
  say(std::accumulate(
      told.begin(), told.end(), formatted("ready after %.2f s:", seconds(begin, monotonic_ns())),
      [](const std::string& all, const std::string& one) { return all + " " + one; }));
}

void Up::activate(const std::string& name) {
  active_ = name;
  if (name.empty()) return;
  const SeenProcess* process = bus_->seen().process_of_pid(supervisor_->pid_of(name));
  if (process == nullptr)
    throw std::runtime_error("'" + name + "' sends no heartbeat, so it cannot be activated");
  SourceRequest request;
  request.action = SourceAction::kActivate;
  request.policy = SwitchPolicy::kNow;
  request.run_id = request.target_run_id = process->beat.process_id;
  const std::int64_t begin = monotonic_ns();
  std::int64_t asked = 0;
  while (!quit_requested()) {
    const std::int64_t now = monotonic_ns();
    if (asked == 0 || seconds(asked, now) > kAskAgain) {
      asked = now;
      request.sequence =
          0;  // a new one: a refusal answers one sequence, and the reason may have gone since
      bus_->send(request);
    }
    bus_->receive(0.02);
    supervisor_->watch(monotonic_ns());
    const SeenSource* source = bus_->seen().source(request.run_id);
    // Its own word is enough: on a busy machine its states may lie in our socket for a while.
    if (source != nullptr && source->status.role == Role::kActive) {
      say(describe(*source) + " holds STATE");
      return;
    }
    if (supervisor_->broken())
      throw std::runtime_error("a required process ended before the robot was running");
    if (seconds(begin, now) > kActivationTimeout) {
      const bool refused = source != nullptr && source->status.refusal != Refusal::kNone;
      throw std::runtime_error("'" + name + "' did not become active within 10 s" +
                               (refused ? std::string(": ") + refusal_text(source->status.refusal) : ""));
    }
  }
}

void Up::wait_for_first_commands() {
  const bool ours = stack_.find("controller") != nullptr;
  wait_for_command(*bus_, *supervisor_, {ours ? folder_ + "/controller.log" : "", [this](const std::string& line) { say(line); }});
  if (!stack_.shadow.empty() && put_in_shadow(*bus_, *supervisor_, stack_.shadow))
    say("'" + stack_.shadow + "' shadows it: GAP is the difference");
  // The first ticks of a source and a controller fill caches and page tables: they are run, but not counted.
  if (!request_.lockstep && !quit_requested()) bus_->listen(kSettle);
  if (quit_requested()) return;
  start_ns_ = monotonic_ns();
  // A simulator says what its scene asks; a robot does not.
  script_.end();
  if (const StackProcess* first = stack_.find(active_); first != nullptr && first->program != "twinbus_simulator")
    script_.begin(requests_of(scene_), request_.period, bus_->seen().newest_state().tick);
  at_start_ = missed_so_far(bus_->seen(), start_ns_);
  if (!request_.lockstep) bus_->seen().restart_counts();
  say((request_.lockstep ? std::string("in lock-step, without FIFO priority")
                         : real_time_text(real_time_of(bus_->seen(), start_ns_), request_.patient)) +
      "; output of each process: " + folder_);
  for (const SeenProcess* process : bus_->seen().processes(start_ns_))
    shares_.of(process->beat.pid, start_ns_);
  if (!watch_address_.empty()) say("to watch and stop from a phone: " + watch_address_);
  if (!viewer_address_.empty()) say("viewer: " + viewer_address_);
}

// As if it had been started so: the run begins anew, its log goes on.
void Up::set_up(const std::string& wish) {
  if (only_saves(wish)) {
    bool saved = false;
    const std::string said = wishes_->save(wish, request_.robot, saved);
    bus_->tell(said, saved ? 0 : 2);
    return;
  }
  std::string problem;
  std::vector<std::string> lines;
  bool dropped = false;
  held_back_ = &lines;
  try {
    const StackProcess* active = holder_of_state(stack_, *supervisor_, bus_->seen());
    const Setup setup = wishes_->prepare(wish, request_.robot, stack_, active);
    const std::string first = active_anew(wish, stack_, active);
    scene_ = load_scene(setup.scene);
    resolve_poses(scene_, load_robot(setup.robot));
    const Placeholders before = values_;
    fill_in(setup, values_);
    if (!begins_as_before(wish)) values_["start"].clear();  // the wish names its own
    if (values_ != before && accuracy_->drop()) {
      values_["settings"] = own_settings_;
      request_.step_s = own_step_;
      dropped = true;
    }
    supervisor_->fit(values_);
    start_anew(first, setup.model_hash != model_hash_, *supervisor_, *bus_);
    model_hash_ = setup.model_hash;
    activate(first);
    wait_for_first_commands();
  } catch (const std::exception& error) {
    problem = error.what();
  }
  held_back_ = nullptr;
  std::vector<std::string> events = bus_->seen().take_events();
  // That everything ended and started is what was asked; only where it failed it is told how far it came.
  if (problem.empty()) {
    lines.clear();
    if (dropped) lines.emplace_back("accuracy: was that of the world before; this one has its scene's own order and step");
    drop_events_of_the_loop(events);
  }
  for (const std::string& line : groups_.take(events, monotonic_ns())) lines.push_back(line);
  for (const std::string& line : lines) say(line);
  health_ = BusHealth();  // everybody counts from another tick on
  // It comes back as an event and is said then.
  bus_->tell(wishes_->answer(wish, problem), problem.empty() ? 0 : 2);
}

bool Up::elapsed(std::int64_t now_ns) const {
  return request_.duration > 0.0 && !request_.lockstep &&
         seconds(start_ns_, now_ns) >= request_.duration;
}

// A required process is gone for good, or every source is and nobody starts one anew.
bool Up::is_over(std::int64_t now_ns) {
  if (supervisor_->broken()) return true;
  if (!supervisor_->every_source_ended()) {
    sourceless_ns_ = 0;
    return false;
  }
  if (sourceless_ns_ == 0) {
    sourceless_ns_ = now_ns;
    say("no source is left: ./twinbus restart NAME starts one anew; else all ends in 10 s");
  }
  return seconds(sourceless_ns_, now_ns) > kWithoutSource;
}

void Up::show(std::int64_t now_ns) {
  for (const std::string& line : groups_.take(bus_->seen().take_events(), now_ns)) say(line);
  for (const std::string& alarm :
       health_.look(bus_->seen().processes(now_ns), now_ns, has_own_clock(bus_->seen(), now_ns)))
    bus_->alarm(alarm);  // it comes back as an event and is said then
  const std::int64_t last = shown_ns_ == 0 && !terminal_ ? start_ns_ : shown_ns_;
  if (last != 0 && seconds(last, now_ns) < (terminal_ ? kTableEvery : kLineEvery)) return;
  shown_ns_ = now_ns;
  if (!terminal_) {
    say(formatted("%6.1f s  ", seconds(start_ns_, now_ns)) + summary_line(bus_->seen(), now_ns));
    return;
  }
  std::vector<std::string> lines = table_lines(bus_->seen(), shares_, now_ns);
  // Lines of its own: a narrow terminal shows the end of none that is longer.
  if (!viewer_address_.empty()) lines.insert(lines.begin(), "viewer: " + viewer_address_);
  lines.insert(lines.begin(), formatted("twinbus up: %.1f s   (Ctrl-C stops everything)   %s, %s, %s, stack %s",
                                        seconds(start_ns_, now_ns), request_.scene.c_str(), request_.robot.c_str(),
                                        request_.engine.c_str(), stack_.name.c_str()));
  redraw_.draw(lines);
}

bool Up::work() {
  const bool ends_itself = request_.lockstep && request_.duration > 0.0;
  while (!quit_requested()) {
    bus_->receive(0.02);
    const std::int64_t now = monotonic_ns();
    if (ends_itself) {
      for (const Supervised& one : supervisor_->processes()) {
        const bool gone = one.process.name == stack_.activate && !one.child.empty() &&
                          one.child.front().wait_is_over();
        if (gone) {
          // What is still in the socket: a launcher without priority may be seconds behind.
          for (std::int64_t heard = -1; heard != bus_->seen().state().received();) {
            heard = bus_->seen().state().received();
            bus_->listen(0.1);
          }
          return true;
        }
      }
    }
    supervisor_->watch(now);
    restarts_->look(*supervisor_, now);
    if (const std::string wish = wishes_->take(now); !wish.empty()) set_up(wish);
    note_ready();
    if (is_over(now)) return false;
    script_.hear(bus_->seen().newest_state(), [this](auto& request) { bus_->send(request); });
    if (elapsed(now)) return true;
    show(now);
  }
  return true;
}

std::string Up::cpu_line(std::int64_t now_ns) {
  std::string line = "CPU:";
  double all = 0.0;
  for (const SeenProcess* process : bus_->seen().processes(now_ns)) {
    const double share = shares_.of(process->beat.pid, now_ns);
    all += share;
    line += formatted(" %s %.0f %%,", process_name(process->beat.kind), 1e2 * share);
  }
  return line + formatted(" together %.2f of %ld CPUs", all, sysconf(_SC_NPROCESSORS_ONLN));
}

bool Up::judge_and_report(bool whole, double wall_s) {
  const std::int64_t now = monotonic_ns();
  RunVerdict verdict = judge(bus_->seen(), request_, at_start_, now);
  if (request_.lockstep) {
    // The source has ended by itself, so it is no longer active: only ticks and falls count.
    std::erase_if(verdict.failures,
                  [](const std::string& failure) { return failure.starts_with("no source"); });
    const auto wanted = static_cast<std::int64_t>(request_.duration / request_.period + 0.5);
    if (whole && !quit_requested() && verdict.ticks < wanted) {
      verdict.failures.push_back(std::to_string(verdict.ticks) + " of " + std::to_string(wanted) +
                                 " ticks came");
    }
  }
  if (!whole) verdict.failures.push_back("a required process ended");
  if (const std::string failure = accuracy_->failure(); !failure.empty()) verdict.failures.push_back("accuracy: " + failure);
  verdict.passed = verdict.failures.empty();
  if (quit_requested()) end_by_operator(verdict, request_, wall_s);
  const std::string hash = request_.lockstep ? hash_.text() : "";
  if (!asked_to_judge() && whole) {
    redraw_.leave();
    for (const std::string& failure : verdict.failures) say("went wrong: " + failure);
  } else {
    redraw_.clear();
    for (const std::string& line : verdict_lines(verdict, request_)) say(line);
    say(cpu_line(now));
    if (!hash.empty()) say("state_hash " + hash);
  }
  const std::string json = accuracy_->in_report(report_json(verdict, request_, bus_->seen(), wall_s, hash));
  if (!report_.empty()) write_file(report_, json);
  if (const std::string trouble = write_unasked(folder_ + "/report.json", json); !trouble.empty()) say(trouble);
  if (quit_requested()) say("figures up to here: " + (report_.empty() ? folder_ + "/report.json" : report_));
  return verdict.passed || (whole && !asked_to_judge());
}

int Up::run() {
  say("stack " + stack_.name + ", scene " + request_.scene + ", robot " + request_.robot +
      ", bus " + bus_->url());
  for (const std::string& line : accuracy_->lines()) say(line);
  start_all();
  if (!quit_requested()) activate(stack_.activate);
  if (!quit_requested()) wait_for_first_commands();
  bool good = true;
  if (start_ns_ != 0) {
    good = work();
    good = judge_and_report(good, seconds(start_ns_, monotonic_ns()));
  } else if (asked_to_judge()) {
    say("nothing was measured" + (report_.empty() ? "" : ": no " + report_));
    good = false;
  }
  redraw_.leave();
  say("stops " + std::to_string(supervisor_->processes().size()) + " processes");
  const bool ended_well = supervisor_->stop_all();
  say(ended_well ? "all processes ended" : "all processes ended, not all of them well");
  return good ? 0 : 1;
}

}  // namespace

int up_command(const std::vector<std::string>& words) {
  const Arguments arguments(up_syntax(), words);
  catch_quit_signals();
  Up up(arguments);
  return up.run();
}

}  // namespace twinbus::launcher
