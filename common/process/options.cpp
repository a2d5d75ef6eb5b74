#include "common/process/options.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "common/process/command_word.h"
#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "common/text/xml.h"

namespace twinbus::inline common {

Options::Options(std::string program, std::string summary)
    : program_(std::move(program)), summary_(std::move(summary)) {}

void Options::text(const std::string& name, const std::string& value_name, std::string& variable,
                   const std::string& help) {
  options_.push_back({name, value_name, help, variable, [&variable](const std::string& value) {
                        variable = value;
                        return std::string();
                      }});
}

void Options::number(const std::string& name, const std::string& value_name, double& variable,
                     double low, double high, const std::string& help) {
  options_.push_back({name, value_name, help, formatted("%g", variable), [&variable, low, high](const std::string& value) {
                        double number = 0.0;
                        if (!parse_numbers(value, &number, 1)) return value + " is not a finite number";
                        if (!(number >= low && number <= high))
                          return value + formatted(" is out of range, %g to %g", low, high);
                        variable = number;
                        return std::string();
                      }});
}

void Options::integer(const std::string& name, const std::string& value_name,
                      std::int64_t& variable, std::int64_t low, std::int64_t high,
                      const std::string& help) {
  options_.push_back({name, value_name, help, std::to_string(variable), [&variable, low, high](const std::string& value) {
                        std::int64_t number = 0;
                        const char* end = value.data() + value.size();
                        const auto [at, fault] = std::from_chars(value.data(), end, number);
                        if (fault != std::errc() || at != end) return value + " is not a whole number";
                        if (number < low || number > high)
                          return value + " is out of range, " + std::to_string(low) + " to " + std::to_string(high);
                        variable = number;
                        return std::string();
                      }});
}

void Options::flag(const std::string& name, bool& variable, const std::string& help) {
  options_.push_back({name, "", help, "", [&variable](const std::string&) {
                        variable = true;
                        return std::string();
                      }});
}

void Options::settings(const std::string& name,
                       std::vector<std::pair<std::string, std::string>>& variable,
                       const std::string& help) {
  options_.push_back({name, "KEY=VALUE", help, "", [&variable](const std::string& value) {
                        const std::size_t equals = value.find('=');
                        if (equals == std::string::npos || equals == 0) return value + " must be KEY=VALUE";
                        variable.emplace_back(value.substr(0, equals), value.substr(equals + 1));
                        return std::string();
                      }});
}

void Options::choice(const std::string& name, const std::vector<std::string>& choices,
                     std::string& variable, const std::string& help) {
  std::string list;
  for (const std::string& known : choices) list += (list.empty() ? "" : "|") + known;
  options_.push_back({name, list, help, variable, [&variable, choices](const std::string& value) {
                        if (std::find(choices.begin(), choices.end(), value) == choices.end())
                          return value + " is not known" + suggestion(value, choices);
                        variable = value;
                        return std::string();
                      }});
}

void Options::alias(const std::string& name) { options_.back().aliases.push_back(name); }

void Options::positional(const std::string& value_name, std::string& variable, bool required,
                         const std::string& help) {
  positionals_.push_back({"", value_name, help, variable, [&variable](const std::string& value) {
                            variable = value;
                            return std::string();
                          }});
  positionals_.back().required = required;
}

void Options::rest(const std::string& value_name, std::vector<std::string>& variable,
                   const std::string& help) {
  positionals_.push_back({"", value_name, help, "", [&variable](const std::string& value) {
                            variable.push_back(value);
                            return std::string();
                          }});
  positionals_.back().many = true;
}

Options::Entry* Options::find(const std::string& name) {
  for (Entry& entry : options_) {
    if (entry.name == name ||
        std::find(entry.aliases.begin(), entry.aliases.end(), name) != entry.aliases.end()) {
      return &entry;
    }
  }
  return nullptr;
}

bool Options::given(const std::string& name) const {
  for (const Entry& entry : options_) {
    if (entry.name == name) return entry.given;
  }
  return false;
}

std::string Options::Entry::assign(const std::string& value) {
  given = true;
  const std::string why = take(value);
  return why.empty() ? why : (name.empty() ? value_name : name) + " " + why;
}

bool Options::try_parse(const std::vector<std::string>& arguments, std::string& error) {
  error.clear();
  std::size_t next_positional = 0;
  bool only_positionals = false;
  for (std::size_t i = 0; i < arguments.size() && error.empty(); ++i) {
    const std::string& argument = arguments[i];
    if (!only_positionals && argument == "--") {
      only_positionals = true;
      continue;
    }
    if (!only_positionals && (argument == "--help" || argument == "-h")) {
      help_asked_ = true;
      return true;
    }
    if (only_positionals || argument.size() < 2 || argument.compare(0, 2, "--") != 0) {
      if (next_positional >= positionals_.size()) {
        error = "argument " + argument + " is not expected";
        return false;
      }
      Entry& entry = positionals_[next_positional];
      if (!entry.many) ++next_positional;
      error = entry.assign(argument);
      continue;
    }
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    Entry* entry = find(name);
    if (entry == nullptr) {
      std::vector<std::string> known = {"--help"};
      for (const Entry& option : options_) known.push_back(option.name);
      error = "option " + name + " is not known" + suggestion(name, known);
      return false;
    }
    const bool flag = entry->value_name.empty();
    std::string value;
    if (equals != std::string::npos) {
      if (flag) {
        error = "option " + name + " takes no value";
        return false;
      }
      value = argument.substr(equals + 1);
    } else if (!flag) {
      if (i + 1 >= arguments.size() || arguments[i + 1].starts_with("--")) {  // another option is no value
        error = "option " + name + " needs a value, " + entry->value_name;
        return false;
      }
      value = arguments[++i];
    }
    error = entry->assign(value);
  }
  for (; error.empty() && next_positional < positionals_.size(); ++next_positional) {
    const Entry& entry = positionals_[next_positional];
    if (entry.required) error = entry.value_name + " is missing: " + entry.help;
  }
  return error.empty();
}

void Options::parse(int argc, char** argv) {
  std::string error;
  if (!try_parse(std::vector<std::string>(argv + std::min(argc, 1), argv + argc), error)) {
    std::fprintf(stderr, "%s: %s (--help lists all)\n", program_.c_str(), error.c_str());
    std::exit(2);
  }
  if (help_asked_) {
    std::fputs(help().c_str(), stdout);
    std::exit(0);
  }
}

std::string Options::help() const {
  // ./twinbus gamepad runs twinbus_gamepad: what was typed is what is explained.
  const char* command = std::getenv("TWINBUS_COMMAND");
  std::string text = "usage: " + (command != nullptr ? std::string(command) : program_);
  for (const Entry& entry : positionals_) {
    const std::string name = entry.value_name + (entry.many ? "..." : "");
    text += entry.required ? " " + name : " [" + name + "]";
  }
  text += " [OPTION...]\n" + summary_ + "\n";
  const auto line = [&](const Entry& entry, const std::string& head) {
    std::string row = "  " + head;
    row += row.size() < 24 ? std::string(24 - row.size(), ' ') : "  ";
    text += row + entry.help;
    if (!entry.fallback.empty()) text += " (default: " + entry.fallback + ")";
    text += "\n";
  };
  for (const Entry& entry : positionals_) line(entry, entry.value_name);
  for (const Entry& entry : options_) {
    line(entry, entry.name + (entry.value_name.empty() ? "" : " " + entry.value_name));
  }
  return as_typed(text + "Exit status: 0 done, 1 failed, 2 wrong arguments.\n");
}

std::string default_url() {
  const char* url = std::getenv("LCM_DEFAULT_URL");
  return url != nullptr && *url != '\0' ? url : "udpm://239.255.76.67:17667?ttl=0&recv_buf_size=4194304";
}

void add_common(Options& options, CommonOptions& common) {
  options.text("--robot", "NAME_OR_DIR", common.robot,
               "a name under config/robots, or a robot's folder");
  options.text("--prefix", "P", common.prefix,
               "goes before every channel, for several robots on one bus");
  options.text("--url", "URL", common.url, "of the bus");
  options.text("--allow", "A,B", common.allow,
               "IPv4 addresses of other machines that may send to this process");
  options.integer("--id", "N", common.id, 0, (std::int64_t{1} << 53) - 1,
                  "fixed id of this process instead of a random one");
  options.alias("--run-id");
}

}  // namespace twinbus::common
