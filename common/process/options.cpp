#include "common/process/options.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "common/process/command_word.h"
#include "common/text/closest_name.h"
#include "common/text/xml.h"

namespace twinbus {

namespace {

std::string to_text(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

}  // namespace

Options::Options(std::string program, std::string summary)
    : program_(std::move(program)), summary_(std::move(summary)) {}

Options::Entry& Options::add(Kind kind, const std::string& name, const std::string& value_name,
                             void* variable, const std::string& help) {
  return options_.emplace_back(kind, name, value_name, help, variable);
}

void Options::text(const std::string& name, const std::string& value_name, std::string& variable,
                   const std::string& help) {
  add(Kind::kText, name, value_name, &variable, help).fallback = variable;
}

void Options::number(const std::string& name, const std::string& value_name, double& variable,
                     double low, double high, const std::string& help) {
  Entry& entry = add(Kind::kNumber, name, value_name, &variable, help);
  entry.low = low;
  entry.high = high;
  entry.fallback = to_text(variable);
}

void Options::integer(const std::string& name, const std::string& value_name,
                      std::int64_t& variable, std::int64_t low, std::int64_t high,
                      const std::string& help) {
  Entry& entry = add(Kind::kInteger, name, value_name, &variable, help);
  entry.integer_low = low;
  entry.integer_high = high;
  entry.fallback = std::to_string(variable);
}

void Options::flag(const std::string& name, bool& variable, const std::string& help) {
  add(Kind::kFlag, name, "", &variable, help);
}

void Options::settings(const std::string& name,
                       std::vector<std::pair<std::string, std::string>>& variable,
                       const std::string& help) {
  add(Kind::kSettings, name, "KEY=VALUE", &variable, help);
}

void Options::choice(const std::string& name, const std::vector<std::string>& choices,
                     std::string& variable, const std::string& help) {
  std::string list;
  for (const std::string& known : choices) list += (list.empty() ? "" : "|") + known;
  Entry& entry = add(Kind::kChoice, name, list, &variable, help);
  entry.choices = choices;
  entry.fallback = variable;
}

void Options::alias(const std::string& name) { options_.back().aliases.push_back(name); }

Options::Entry& Options::add_positional(Kind kind, const std::string& value_name, void* variable, const std::string& help) {
  return positionals_.emplace_back(kind, "", value_name, help, variable);
}

void Options::positional(const std::string& value_name, std::string& variable, bool required,
                         const std::string& help) {
  Entry& entry = add_positional(Kind::kText, value_name, &variable, help);
  entry.fallback = variable;
  entry.required = required;
}

void Options::rest(const std::string& value_name, std::vector<std::string>& variable,
                   const std::string& help) {
  add_positional(Kind::kRest, value_name, &variable, help);
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

bool Options::assign(Entry& entry, const std::string& value, std::string& error) {
  const std::string who = entry.name.empty() ? entry.value_name : entry.name;
  entry.given = true;
  switch (entry.kind) {
    case Kind::kText:
      *static_cast<std::string*>(entry.variable) = value;
      return true;
    case Kind::kRest:
      static_cast<std::vector<std::string>*>(entry.variable)->push_back(value);
      return true;
    case Kind::kFlag:
      *static_cast<bool*>(entry.variable) = true;
      return true;
    case Kind::kNumber: {
      double number = 0.0;
      if (!parse_numbers(value, &number, 1)) {
        error = who + " " + value + " is not a finite number";
        return false;
      }
      if (!(number >= entry.low && number <= entry.high)) {
        error = who + " " + value + " is out of range, " + to_text(entry.low) + " to " +
                to_text(entry.high);
        return false;
      }
      *static_cast<double*>(entry.variable) = number;
      return true;
    }
    case Kind::kInteger: {
      std::int64_t number = 0;
      const char* end = value.data() + value.size();
      const auto [at, fault] = std::from_chars(value.data(), end, number);
      if (fault != std::errc() || at != end) {
        error = who + " " + value + " is not a whole number";
        return false;
      }
      if (number < entry.integer_low || number > entry.integer_high) {
        error = who + " " + value + " is out of range, " + std::to_string(entry.integer_low) +
                " to " + std::to_string(entry.integer_high);
        return false;
      }
      *static_cast<std::int64_t*>(entry.variable) = number;
      return true;
    }
    case Kind::kSettings: {
      const std::size_t equals = value.find('=');
      if (equals == std::string::npos || equals == 0) {
        error = who + " " + value + " must be KEY=VALUE";
        return false;
      }
      static_cast<std::vector<std::pair<std::string, std::string>>*>(entry.variable)
          ->emplace_back(value.substr(0, equals), value.substr(equals + 1));
      return true;
    }
    case Kind::kChoice:
      if (std::find(entry.choices.begin(), entry.choices.end(), value) == entry.choices.end()) {
        error = who + " " + value + " is not known" + suggestion(value, entry.choices);
        return false;
      }
      *static_cast<std::string*>(entry.variable) = value;
      return true;
  }
  return false;
}

bool Options::try_parse(const std::vector<std::string>& arguments, std::string& error) {
  std::size_t next_positional = 0;
  bool only_positionals = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
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
      if (entry.kind != Kind::kRest) ++next_positional;
      if (!assign(entry, argument, error)) return false;
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
    std::string value;
    if (equals != std::string::npos) {
      if (entry->kind == Kind::kFlag) {
        error = "option " + name + " takes no value";
        return false;
      }
      value = argument.substr(equals + 1);
    } else if (entry->kind != Kind::kFlag) {
      if (i + 1 >= arguments.size() || arguments[i + 1].starts_with("--")) {  // another option is no value
        error = "option " + name + " needs a value, " + entry->value_name;
        return false;
      }
      value = arguments[++i];
    }
    if (!assign(*entry, value, error)) return false;
  }
  for (; next_positional < positionals_.size(); ++next_positional) {
    const Entry& entry = positionals_[next_positional];
    if (entry.required) {
      error = entry.value_name + " is missing: " + entry.help;
      return false;
    }
  }
  return true;
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
    const std::string name = entry.value_name + (entry.kind == Kind::kRest ? "..." : "");
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

namespace {
const char* project_url() { return "udpm://239.255.76.67:17667?ttl=0&recv_buf_size=4194304"; }
}  // namespace

CommonOptions::CommonOptions() : url(project_url()) {
  if (const char* set = std::getenv("LCM_DEFAULT_URL"); set != nullptr && *set != '\0') url = set;
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

}  // namespace twinbus
