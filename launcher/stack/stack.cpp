#include "launcher/stack/stack.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "common/text/closest_name.h"
#include "common/text/strict_yaml.h"
#include "common/text/xml.h"
#include "robot/description/load.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kLongest = 600.0;  // that a process may take to be ready, or to end [s]

StackProcess read_process(const std::string& name, const ConfigNode& node) {
  StackProcess process;
  process.name = name;
  process.program = node.text("program");
  if (process.program.empty() || process.program.find('/') != std::string::npos)
    node.fail("program", "is the name of a program of twinbus, not a path");
  process.arguments = node.texts("arguments");
  process.after = node.texts("after");
  process.ready_channel = node.text("ready", "HEARTBEAT");
  process.ready_when = process.ready_channel == "line" ? ReadyWhen::kLine : ReadyWhen::kMessage;
  process.ready_timeout = node.number("ready_timeout", 1e-3, kLongest, process.ready_timeout);
  process.required = node.flag("required", process.required);
  process.restart = node.flag("restart", process.restart);
  process.hardware = node.flag("hardware", process.hardware);
  process.viewer = node.flag("viewer", process.viewer);
  process.recorder = node.flag("recorder", process.recorder);
  process.grace = node.number("grace", 1e-3, kLongest, process.grace);
  node.finish();
  return process;
}

// Each process after those it waits for, otherwise in the order of the file.
std::vector<StackProcess> sorted(const std::string& file, std::vector<StackProcess> waiting) {
  std::vector<StackProcess> order;
  std::set<std::string> placed;
  while (!waiting.empty()) {
    const auto next =
        std::find_if(waiting.begin(), waiting.end(), [&](const StackProcess& process) {
          return std::all_of(process.after.begin(), process.after.end(),
                             [&](const std::string& name) { return placed.contains(name); });
        });
    if (next == waiting.end()) {
      throw std::runtime_error(file + ": '" + waiting.front().name +
                               "' waits for a process that waits for it; remove one 'after'");
    }
    placed.insert(next->name);
    order.push_back(*next);
    waiting.erase(next);
  }
  return order;
}

}  // namespace

const StackProcess* Stack::find(const std::string& wanted) const {
  for (const StackProcess& process : processes) {
    if (process.name == wanted) return &process;
  }
  return nullptr;
}

bool Stack::wants(const std::string& placeholder) const {
  for (const StackProcess& process : processes) {
    for (const std::string& word : process.arguments) {
      if (word.find(placeholder) != std::string::npos) return true;
    }
  }
  return false;
}

void Stack::leave_out(bool (*unwanted)(const StackProcess&)) {
  for (const StackProcess& gone : processes) {
    if (!unwanted(gone)) continue;
    for (StackProcess& process : processes) std::erase(process.after, gone.name);
  }
  std::erase_if(processes, unwanted);
}

Stack parse_stack(const std::string& text, const std::string& file) {
  const ConfigNode top = ConfigNode::parse(text, file);
  Stack stack;
  stack.text = text;
  stack.about = top.text("about", "");
  stack.activate = top.text("activate", "");
  stack.shadow = top.text("shadow", "");
  const ConfigNode processes = top.map("processes");
  const std::vector<std::string> names = processes.keys();
  if (names.empty()) top.fail("processes", "must be a map of at least one process");
  for (const std::string& name : names) {
    const bool simple = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
    if (!simple) processes.fail(name, "is no name of a process: letters, digits, '-' and '_' only");
    stack.processes.push_back(read_process(name, processes.map(name)));
  }
  const auto require = [&](const ConfigNode& node, const char* key, const std::string& name) {
    if (stack.find(name) == nullptr)
      node.fail(key, "names '" + name + "', which is not in this stack" + suggestion(name, names));
  };
  for (const StackProcess& process : stack.processes) {
    for (const std::string& name : process.after) require(processes.map(process.name), "after", name);
  }
  if (!stack.activate.empty()) require(top, "activate", stack.activate);
  if (!stack.shadow.empty()) require(top, "shadow", stack.shadow);
  top.finish();
  stack.processes = sorted(file, std::move(stack.processes));
  return stack;
}

bool moves_hardware(const Stack& stack) {
  return std::any_of(stack.processes.begin(), stack.processes.end(),
                     [](const StackProcess& p) { return p.hardware || p.program == "twinbus_bridge"; });
}

bool is_stand_in(const StackProcess& process) {
  constexpr const char* kStandIn = "emulated_robot";  // the program and its adaptor, which speaks to nothing else
  if (process.hardware || process.program != "twinbus_bridge") return !process.hardware && process.program == kStandIn;
  const auto at = std::find(process.arguments.begin(), process.arguments.end(), "--adaptor");
  return at != process.arguments.end() && at + 1 != process.arguments.end() && *(at + 1) == kStandIn;
}

std::vector<std::string> stack_names() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(config_folder() + "/stacks", ignored)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Stack load_stack(const std::string& name_or_file) {
  namespace fs = std::filesystem;
  const bool is_file =
      name_or_file.find('/') != std::string::npos || name_or_file.ends_with(".yaml");
  const fs::path file = is_file ? fs::path(name_or_file)
                                : fs::path(config_folder()) / "stacks" / (name_or_file + ".yaml");
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    const std::vector<std::string> names = stack_names();
    std::string all;
    for (const std::string& name : names) all += " " + name;
    throw std::runtime_error("no stack '" + name_or_file + "' (" + file.string() + ")" +
                             suggestion(name_or_file, names));
  }
  Stack stack = parse_stack(read_text_file(file.string()), file.string());
  stack.name = is_file ? file.stem().string() : name_or_file;
  return stack;
}

std::vector<std::string> fill_in(const StackProcess& process, const Placeholders& values) {
  std::vector<std::string> filled;
  for (const std::string& argument : process.arguments) {
    const std::size_t open = argument.find('{');
    const std::size_t close = argument.find('}', open == std::string::npos ? 0 : open);
    if (open == std::string::npos || close == std::string::npos) {
      filled.push_back(argument);
      continue;
    }
    const std::string key = argument.substr(open + 1, close - open - 1);
    const auto value = values.find(key);
    if (value == values.end()) {
      std::vector<std::string> known;
      for (const auto& [name, unused] : values) known.push_back(name);
      throw std::runtime_error("process '" + process.name + "': unknown placeholder {" + key + "}" +
                               suggestion(key, known));
    }
    if (open == 0 && close + 1 == argument.size()) {
      filled.insert(filled.end(), value->second.begin(), value->second.end());
    } else {
      const std::string joined = value->second.empty() ? "" : value->second.front();
      filled.push_back(argument.substr(0, open) + joined + argument.substr(close + 1));
    }
  }
  return filled;
}

}  // namespace twinbus::launcher
