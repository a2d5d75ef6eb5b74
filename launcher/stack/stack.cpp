#include "launcher/stack/stack.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "robot/description/load.h"
#include "common/text/closest_name.h"

namespace twinbus {

namespace {

constexpr std::uintmax_t kLargestFile = 1 << 20;  // [bytes]

const std::vector<std::string> kStackKeys = {"about", "activate", "shadow", "processes"};
const std::vector<std::string> kProcessKeys = {"program",       "arguments", "after",   "ready",
                                               "ready_timeout", "required",  "restart", "hardware",
                                               "viewer",        "recorder",  "grace"};

[[noreturn]] void complain(const std::string& file, const YAML::Mark& mark,
                           const std::string& what) {
  throw std::runtime_error(file + ":" + std::to_string(mark.line + 1) + ": " + what);
}

void check_keys(const std::string& file, const YAML::Node& map,
                const std::vector<std::string>& known, const std::string& where) {
  if (!map.IsMap()) complain(file, map.Mark(), where + " must be a map of keys");
  for (const auto& entry : map) {
    const std::string key = entry.first.Scalar();
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      complain(file, entry.first.Mark(),
               "unknown key '" + key + "' in " + where + suggestion(key, known));
    }
  }
}

template <class T>
T value_of(const std::string& file, const YAML::Node& map, const char* key, T otherwise) {
  const YAML::Node node = map[key];
  if (!node) return otherwise;
  try {
    return node.as<T>();
  } catch (const YAML::Exception&) {
    complain(file, node.Mark(), std::string("'") + key + "' has a value of the wrong type");
  }
}

double seconds_of(const std::string& file, const YAML::Node& map, const char* key,
                  double otherwise) {
  const double value = value_of(file, map, key, otherwise);
  if (!(value > 0.0 && value <= 600.0)) {
    complain(file, map[key].Mark(),
             std::string("'") + key + "' must be more than 0 and at most 600 seconds");
  }
  return value;
}

StackProcess read_process(const std::string& file, const std::string& name,
                          const YAML::Node& node) {
  check_keys(file, node, kProcessKeys, "process '" + name + "'");
  StackProcess process;
  process.name = name;
  process.program = value_of<std::string>(file, node, "program", "");
  if (process.program.empty())
    complain(file, node.Mark(), "process '" + name + "' names no program");
  if (process.program.find('/') != std::string::npos) {
    complain(file, node["program"].Mark(),
             "'program' is the name of a program of twinbus, not a path");
  }
  process.arguments = value_of(file, node, "arguments", process.arguments);
  process.after = value_of(file, node, "after", process.after);
  const std::string ready = value_of<std::string>(file, node, "ready", "HEARTBEAT");
  process.ready_when = ready == "line" ? ReadyWhen::kLine : ReadyWhen::kMessage;
  process.ready_channel = ready;
  process.ready_timeout = seconds_of(file, node, "ready_timeout", process.ready_timeout);
  process.required = value_of(file, node, "required", process.required);
  process.restart = value_of(file, node, "restart", process.restart);
  process.hardware = value_of(file, node, "hardware", process.hardware);
  process.viewer = value_of(file, node, "viewer", process.viewer);
  process.recorder = value_of(file, node, "recorder", process.recorder);
  process.grace = seconds_of(file, node, "grace", process.grace);
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
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::ParserException& error) {
    complain(file, error.mark, "not valid YAML: " + error.msg);
  }
  check_keys(file, root, kStackKeys, "a stack");
  Stack stack;
  stack.text = text;
  stack.about = value_of<std::string>(file, root, "about", "");
  stack.activate = value_of<std::string>(file, root, "activate", "");
  stack.shadow = value_of<std::string>(file, root, "shadow", "");
  const YAML::Node processes = root["processes"];
  if (!processes || !processes.IsMap() || processes.size() == 0) {
    complain(file, root.Mark(), "a stack needs 'processes', a map of at least one process");
  }
  std::vector<std::string> names;
  for (const auto& entry : processes) {
    const std::string name = entry.first.Scalar();
    const bool simple = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
    if (!simple)
      complain(file, entry.first.Mark(), "a process name has letters, digits, '-' and '_' only");
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      complain(file, entry.first.Mark(), "process '" + name + "' is there twice");
    }
    stack.processes.push_back(read_process(file, name, entry.second));
    names.push_back(name);
  }
  for (const StackProcess& process : stack.processes) {
    for (const std::string& name : process.after) {
      if (stack.find(name) == nullptr) {
        complain(file, processes[process.name]["after"].Mark(),
                 "'" + process.name + "' waits for '" + name + "', which is not in this stack" +
                     suggestion(name, names));
      }
    }
  }
  if (!stack.activate.empty() && stack.find(stack.activate) == nullptr) {
    complain(file, root["activate"].Mark(),
             "'activate' names '" + stack.activate + "', which is not in this stack" +
                 suggestion(stack.activate, names));
  }
  if (!stack.shadow.empty() && stack.find(stack.shadow) == nullptr) {
    complain(file, root["shadow"].Mark(),
             "'shadow' names '" + stack.shadow + "', which is not in this stack" +
                 suggestion(stack.shadow, names));
  }
  stack.processes = sorted(file, std::move(stack.processes));
  return stack;
}

bool moves_hardware(const Stack& stack) {
  return std::any_of(stack.processes.begin(), stack.processes.end(),
                     [](const StackProcess& p) { return p.hardware || p.program == "twinbus_bridge"; });
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
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) {
    const std::vector<std::string> names = stack_names();
    std::string all;
    for (const std::string& name : names) all += " " + name;
    throw std::runtime_error("no stack '" + name_or_file + "' (" + file.string() + ")" +
                             suggestion(name_or_file, names));
  }
  if (size > kLargestFile)
    throw std::runtime_error(file.string() + ": larger than 1 MiB, this is no stack");
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  Stack stack = parse_stack(text.str(), file.string());
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

}  // namespace twinbus
