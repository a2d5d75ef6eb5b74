#include "launcher/up/setup_wish.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "common/file/write_file.h"
#include "launcher/stack/run_folder.h"
#include "common/process/process.h"

namespace twinbus::inline launcher {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLookForSetup = 100'000'000;  // [ns]
constexpr std::uintmax_t kLargestWish = 1 << 20;     // [bytes]
constexpr char kAgain[] = "{\"again\": true}";        // begin anew as before
constexpr double kMostStart = 10.0;                  // [s]

bool concerns(const StackProcess& process, bool other_robot) {
  if ((other_robot && process.program == "twinbus_viewer") || is_stand_in(process)) return true;
  constexpr std::array<const char*, 4> kPrograms = {"twinbus_simulator", "twinbus_controller",
                                                    "twinbus_guard", "twinbus_planner"};
  return std::find(kPrograms.begin(), kPrograms.end(), process.program) != kPrograms.end();
}

// The sentence; where its files cannot be written, as on a full disk, it says that too: what runs goes on.
template <class Write>
std::string answered(const std::string& sentence, const Write& write) {
  try {
    write();
  } catch (const std::exception& error) {
    return sentence + "; the page is not told: " + error.what();
  }
  return sentence;
}

}  // namespace

SetupWishes::SetupWishes(const std::string& folder, Setup now, const Stack& stack)
    : folder_(folder), now_(std::move(now)), stand_in_(std::any_of(stack.processes.begin(), stack.processes.end(), is_stand_in)) {
  fs::create_directories(folder_);
  say_robot();
  if (stand_in_) write_file(folder_ + "/stand_in", "the robot behind the bridge is simulated: it begins anew with the rest\n");
}

std::string SetupWishes::take(std::int64_t now_ns) {
  if (now_ns - looked_ns_ < kLookForSetup) return {};
  looked_ns_ = now_ns;
  const std::string file = folder_ + "/wish.json";
  if (::access(file.c_str(), F_OK) != 0) return {};
  std::error_code ignored;
  std::string wish = "{}";
  if (fs::file_size(file, ignored) <= kLargestWish) {
    std::ifstream stream(file);
    wish.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  ::unlink(file.c_str());
  return wish;
}

Setup SetupWishes::prepare(const std::string& wish, const std::string& robot, const Stack& stack, const StackProcess* active) {
  for (const StackProcess& process : stack.processes) {
    if (process.hardware) throw std::runtime_error("this stack moves a real robot");
  }
  const auto simulates = [](const StackProcess* process) { return process != nullptr && process->program == "twinbus_simulator"; };
  const bool stand_in = wish == kAgain && active != nullptr && is_stand_in(*active);
  if (!stand_in && !simulates(stack.find(stack.activate))) throw std::runtime_error("this stack does not begin with a simulator");
  if (!stand_in && !simulates(active)) throw std::runtime_error("switch to the simulator first");
  if (wish != kAgain) {
    now_ = write_setup(wish, robot, folder_);
    say_robot();
    keep_changes(wish);
  }
  return now_;
}

std::string SetupWishes::save(const std::string& wish, const std::string& robot, bool& saved) {
  nlohmann::json answer = {{"save", nullptr}};
  std::string sentence;
  saved = false;
  try {
    answer["save"] = save_number(wish);
    const Setup written = save_robot(wish, robot, folder_);
    keep_changes(wish);
    saved = true;
    sentence = "robot saved as " + written.robot;
    answer["folder"] = written.robot;
  } catch (const std::exception& error) {
    sentence = std::string("robot not saved: ") + error.what();
  }
  answer["ok"] = saved;
  answer["text"] = sentence;
  const auto replace = nlohmann::json::error_handler_t::replace;
  return answered(sentence, [&] { write_whole(folder_ + "/saved.json", answer.dump(-1, ' ', true, replace)); });
}

// A folder is named from anywhere.
void SetupWishes::say_robot() const {
  std::error_code error;
  const bool named = !fs::exists(now_.robot, error);
  write_file(folder_ + "/" + kRunningRobot, (named ? now_.robot : fs::absolute(now_.robot).string()) + "\n");
}

// What of the robot is changed, for a page that is opened later.
void SetupWishes::keep_changes(const std::string& wish) const {
  const nlohmann::json json = nlohmann::json::parse(wish, nullptr, false);
  nlohmann::json changes = nlohmann::json::object();
  for (const char* key : {"limbs", "unchecked"}) {
    if (json.contains(key)) changes[key] = json[key];
  }
  write_file(folder_ + "/robot.json", changes.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

std::string SetupWishes::answer(const std::string& wish, const std::string& problem) const {
  const bool again = wish == kAgain;
  const std::string sentence = !problem.empty() ? "not set up: " + problem
                               : !again         ? "set up as the page asked"
                               : stand_in_      ? "the simulated world has begun anew, and the stand-in robot with it"
                                                : "the simulated world has begun anew";
  return answered(sentence, [&] {
    if (problem.empty() && !again) write_file(folder_ + "/now.json", wish);
    write_file(folder_ + "/answer", (problem.empty() ? "ok " : "no ") + sentence + "\n");
  });
}

void fill_in(const Setup& setup, Placeholders& values) {
  values["scene"] = {setup.scene};
  values["robot"] = {"--robot", setup.robot};
  values["engine"] = {"--engine", setup.engine};
}

const StackProcess* holder_of_state(const Stack& stack, const Supervisor& supervisor, const StackMonitor& seen) {
  const std::int64_t run = seen.newest_state().run_id;
  for (const Supervised& one : supervisor.processes()) {
    const std::int32_t pid = one.child.empty() ? 0 : one.child.front().pid();
    const SeenProcess* process = pid > 0 ? seen.process_of_pid(pid) : nullptr;
    if (process != nullptr && process->beat.process_id == run) return stack.find(one.process.name);
  }
  if (seen.active(monotonic_ns()) != nullptr) return nullptr;
  const auto ended = [&](const Supervised& one) {
    const bool simulates = seen.newest_state().source == SourceKind::kSimulator;
    return one.child.empty() && one.process.program == (simulates ? "twinbus_simulator" : "twinbus_bridge");
  };
  const auto held = std::find_if(supervisor.processes().begin(), supervisor.processes().end(), ended);
  return held == supervisor.processes().end() ? nullptr : stack.find(held->process.name);
}

bool begins_as_before(const std::string& wish) { return wish == kAgain; }

std::string active_anew(const std::string& wish, const Stack& stack, const StackProcess* active) {
  return !begins_as_before(wish) || active == nullptr || active->name == stack.shadow ? stack.activate : active->name;
}

void start_anew(const std::string& first, bool other_robot, Supervisor& supervisor, BusLink& bus) {
  const std::int32_t old = supervisor.pid_of(first);
  for (const Supervised& one : supervisor.processes()) {
    if (!concerns(one.process, other_robot)) continue;
    const std::string refusal = supervisor.restart(one.process.name, monotonic_ns());
    if (!refusal.empty()) throw std::runtime_error(refusal);
  }
  const std::int64_t begin = monotonic_ns();
  while (!quit_requested()) {
    bus.receive(0.02);
    supervisor.watch(monotonic_ns());
    const std::int32_t pid = supervisor.pid_of(first);
    if (pid != 0 && pid != old && bus.seen().process_of_pid(pid) != nullptr) return;
    if (seconds_since(begin) > kMostStart) throw std::runtime_error("'" + first + "' was not heard within 10 s");
  }
}

void drop_events_of_the_loop(std::vector<std::string>& events) {
  constexpr std::array kKinds = {ProcessKind::kSimulator, ProcessKind::kBridge, ProcessKind::kReplay,
                                 ProcessKind::kController, ProcessKind::kGuard, ProcessKind::kPlanner};
  std::erase_if(events, [&](const std::string& event) {
    return std::any_of(kKinds.begin(), kKinds.end(), [&](ProcessKind kind) {
      return event.starts_with(std::string(process_name(kind)) + ": ");
    });
  });
}

}  // namespace twinbus::launcher
