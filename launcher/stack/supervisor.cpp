#include "launcher/stack/supervisor.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "launcher/stack/run_folder.h"

namespace twinbus::inline launcher {

namespace {

constexpr int kMostRestarts = 5;
constexpr int kLastLines = 6;

std::uintmax_t size_of(const std::string& file) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(file, none);
  return none ? 0 : size;
}

// The first line of a child's output is its sign of life where it has no bus.
bool has_output(const Supervised& one) { return size_of(one.spec.log_file) > one.log_begin; }

std::string last_lines_of(const Supervised& one) {
  if (!has_output(one)) return "; it printed nothing";
  std::string text;
  for (const std::string& line : one.child.front().last_lines(kLastLines)) text += "\n    " + line;
  return "; its output: " + one.spec.log_file + (text.empty() ? "" : ", the last lines:") + text;
}

}  // namespace

Supervisor::Supervisor(const Stack& stack, const Placeholders& placeholders,
                       const std::string& folder, Say say)
    : say_(std::move(say)) {
  for (const StackProcess& process : stack.processes) {
    Supervised one;
    one.process = process;
    one.spec.name = process.name;
    one.spec.command.push_back(program_folder() + "/" + process.program);
    for (std::string& argument : fill_in(process, placeholders))
      one.spec.command.push_back(std::move(argument));
    one.spec.log_file = folder + "/" + process.name + ".log";
    one.spec.dies_with_launcher = !process.hardware;
    one.spec.grace = process.grace;
    if (!std::filesystem::exists(one.spec.command[0])) {
      throw std::runtime_error("process '" + process.name + "': there is no program " +
                               one.spec.command[0] +
                               "; build it with: cmake --build --preset release");
    }
    processes_.push_back(std::move(one));
  }
}

Supervisor::~Supervisor() { stop_all(); }

void Supervisor::start(Supervised& one, std::int64_t now_ns) {
  one.ready = false;
  one.started_ns = now_ns;
  one.child.clear();
  one.log_begin = size_of(one.spec.log_file);
  one.child.emplace_back(one.spec);
}

void Supervisor::start_more(std::int64_t now_ns) {
  for (Supervised& one : processes_) {
    if (one.ready || one.died) continue;
    if (one.child.empty()) {
      const bool may_start = std::all_of(
          one.process.after.begin(), one.process.after.end(), [&](const std::string& name) {
            return std::any_of(processes_.begin(), processes_.end(), [&](const Supervised& other) {
              return other.process.name == name && other.ready;
            });
          });
      if (may_start) start(one, now_ns);
      continue;
    }
    Child& child = one.child.front();
    if (child.take_end()) {
      throw std::runtime_error("process '" + one.process.name + "' ended before it was ready: " +
                               child.how_it_ended() + last_lines_of(one));
    }
    if (one.process.ready_when == ReadyWhen::kLine && has_output(one))
      one.ready = true;
    if (!one.ready &&
        1e-9 * static_cast<double>(now_ns - one.started_ns) > one.process.ready_timeout) {
      const std::string waited_for = one.process.ready_when == ReadyWhen::kLine
                                         ? "a line of output"
                                         : "a message on " + one.process.ready_channel;
      throw std::runtime_error("process '" + one.process.name + "' is not ready after " +
                               std::to_string(static_cast<int>(one.process.ready_timeout)) +
                               " s (waited for " + waited_for + ")" + last_lines_of(one));
    }
  }
}

bool Supervisor::all_ready() const {
  return std::all_of(processes_.begin(), processes_.end(),
                     [](const Supervised& one) { return one.ready || one.died; });
}

void Supervisor::heard_from_name(const std::string& name) {
  for (Supervised& one : processes_) {
    if (one.process.name == name && !one.child.empty()) one.ready = true;
  }
}

bool Supervisor::every_source_ended() const {
  return std::all_of(processes_.begin(), processes_.end(), [](const Supervised& one) {
    return one.died || !one.process.ready_channel.starts_with("STATE_");
  });
}

void Supervisor::report_end(const Supervised& one, const Child& child) const {
  say_(one.process.name + " ended: " + child.how_it_ended() + last_lines_of(one));
}

std::string Supervisor::restart(const std::string& name, std::int64_t now_ns) {
  std::string known;
  for (Supervised& one : processes_) {
    known += " " + one.process.name;
    if (one.process.name != name) continue;
    say_(name + " is started anew by hand");
    if (one.child.empty()) {
      start(one, now_ns);
      one.died = false;
      if (one.process.required) broken_ = false;
      return "";
    }
    one.asked_anew = true;
    one.asked_ns = now_ns;
    one.child.front().ask_to_stop();
    return "";
  }
  return "this stack has no process '" + name + "'; it has" + known;
}

void Supervisor::fit(const Placeholders& placeholders) {
  for (Supervised& one : processes_) {
    one.spec.command.resize(1);
    for (std::string& argument : fill_in(one.process, placeholders))
      one.spec.command.push_back(std::move(argument));
  }
}

std::int32_t Supervisor::pid_of(const std::string& name) const {
  for (const Supervised& one : processes_) {
    if (one.process.name == name && !one.child.empty() && one.child.front().running())
      return one.child.front().pid();
  }
  return 0;
}

bool Supervisor::waits(const Supervised& one) const {
  return std::any_of(processes_.begin(), processes_.end(), [&](const Supervised& other) {
    const std::vector<std::string>& after = one.process.after;
    if (other.died || std::find(after.begin(), after.end(), other.process.name) == after.end()) return false;
    return other.asked_anew || (other.process.ready_when == ReadyWhen::kLine && !other.ready);
  });
}

void Supervisor::watch(std::int64_t now_ns) {
  for (Supervised& one : processes_) {
    if (one.child.empty()) continue;
    if (one.process.ready_when == ReadyWhen::kLine && !one.ready && has_output(one)) one.ready = true;
    const double asked_for = 1e-9 * static_cast<double>(now_ns - one.asked_ns);
    if (one.asked_anew && asked_for > one.process.grace && one.child.front().running())
      one.child.front().kill_group();
    if (!one.child.front().take_end() && !(one.asked_anew && !one.child.front().running()))
      continue;
    if (one.asked_anew) {
      if (waits(one)) continue;
      one.asked_anew = false;
      start(one, now_ns);
      continue;
    }
    report_end(one, one.child.front());
    if (one.process.restart && one.restarts < kMostRestarts) {
      ++one.restarts;
      say_(one.process.name + " is started again (" + std::to_string(one.restarts) +
           " of at most " + std::to_string(kMostRestarts) + " times)");
      start(one, now_ns);
      continue;
    }
    one.died = true;
    one.child.clear();
    if (one.process.required) broken_ = true;
  }
}

bool Supervisor::stop_all() {
  bool well = true;
  for (auto one = processes_.rbegin(); one != processes_.rend(); ++one) {
    if (one->child.empty()) continue;
    Child& child = one->child.front();
    if (child.take_end() && !child.ended_well()) {
      report_end(*one, child);
      well = false;
    }
    if (child.running()) {
      // One that still starts may not listen yet, and has nothing to bring to an end.
      const bool starts = !one->ready && !one->process.hardware;
      child.ask_to_stop();
      if (!child.wait_for_end(one->process.grace)) {
        if (!starts) say_(one->process.name + " did not end within its grace period and is killed");
        child.kill_group();
        well = well && starts;
      } else if (!child.ended_well() && !starts) {
        report_end(*one, child);
        well = false;
      }
    }
    one->child.clear();
  }
  return well;
}

}  // namespace twinbus::launcher
