#include "common/process/arguments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "common/process/command_word.h"
#include "common/text/closest_name.h"
#include "common/text/formatted.h"

namespace twinbus::inline common {

namespace {

bool looks_like_option(const std::string& word) {
  if (word.size() < 2 || word[0] != '-') return false;
  return !(word[1] == '.' || (word[1] >= '0' && word[1] <= '9'));  // -0.3 is a number
}

double number_of(const std::string& command, const std::string& name, const std::string& text,
                 double least, double most) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool whole = !text.empty() && *end == '\0' && std::isfinite(value);
  if (!(whole && value >= least && value <= most)) {
    const std::string range = formatted("a number from %g to %g", least, most);
    throw UsageError(command + ": " + name + " must be " + range + ", got '" + text + "'");
  }
  return value;
}

const OptionSpec& shared_option(const std::string& name) {
  static const Syntax shared("", 0, 0, R"(
  --robot NAME  of config/robots, or a folder
  --prefix P  put before every channel, as in R1_ (second robot)
  --url URL  of the bus; default $LCM_DEFAULT_URL, else the port of twinbus
  --allow IP  another machine that may send to this bus; may be repeated
  --from S  seconds from the first event
  --to S  seconds from the first event
  --force  writes over a file that is there, with its parts)");
  for (const OptionSpec& option : shared.options) {
    if (option.name == name) return option;
  }
  throw std::logic_error(name + ": no option that commands share; say what it is for");
}

}  // namespace

Syntax::Syntax(std::string name, std::size_t least, std::size_t most, std::string_view help)
    : command(std::move(name)), least_words(least), most_words(most) {
  std::istringstream stream{std::string(help)};
  std::getline(stream, positional);
  for (std::string line, next; std::getline(stream, line);) {
    while (line.ends_with('\\') && std::getline(stream, next))
      line.replace(line.size() - 1, 1, next, next.find_first_not_of(' '), std::string::npos);
    if (!line.starts_with("  --")) {
      about += (about.empty() ? "" : "\n") + line;
    } else if (const std::size_t gap = line.find("  ", 2); gap != std::string::npos) {
      const std::string left = line.substr(2, gap - 2);
      const std::string option = left.substr(0, left.find(' '));
      options.push_back({option, left.substr(std::min(option.size() + 1, left.size())), line.substr(gap + 2)});
    } else {
      std::istringstream names(line);
      for (std::string shared; names >> shared;) options.push_back(shared_option(shared));
    }
  }
}

std::string help_text(const Syntax& syntax) {
  std::string text = "usage: ./twinbus " + syntax.command;
  if (!syntax.positional.empty()) text += " " + syntax.positional;
  if (!syntax.options.empty()) text += " [OPTION...]";
  text += "\n" + syntax.about + "\n";
  for (const OptionSpec& option : syntax.options) {
    std::string left = "  " + option.name + (option.value.empty() ? "" : " " + option.value);
    left.resize(std::max<std::size_t>(left.size() + 2, 24), ' ');
    text += left + option.about + "\n";
  }
  return as_typed(text + "Exit status: 0 done, 1 failed, 2 wrong arguments.\n");
}

Arguments::Arguments(const Syntax& syntax, const std::vector<std::string>& given)
    : command_(syntax.command) {
  std::vector<std::string> names = {"--help"};
  for (const OptionSpec& option : syntax.options) names.push_back(option.name);
  bool only_words = false;
  std::string last;  // the option that took the last word as its value
  for (std::size_t i = 0; i < given.size(); ++i) {
    std::string word = given[i];
    if (only_words || !looks_like_option(word)) {
      words_.push_back(word);
      continue;
    }
    if (word == "--") {
      only_words = true;
      continue;
    }
    if (word == "--help" || word == "-h") {
      std::fputs(help_text(syntax).c_str(), stdout);
      std::exit(0);
    }
    std::string value;
    bool has_value = false;
    if (const std::size_t equals = word.find('='); equals != std::string::npos) {
      value = word.substr(equals + 1);
      word.resize(equals);
      has_value = true;
    }
    const OptionSpec* option = nullptr;
    for (const OptionSpec& candidate : syntax.options) {
      if (candidate.name == word) option = &candidate;
    }
    if (option == nullptr) {
      throw UsageError(command_ + ": unknown option '" + word + "'" + suggestion(word, names) +
                       " (see --help)");
    }
    if (option->value.empty() && has_value)
      throw UsageError(command_ + ": " + word + " takes no value");
    if (!option->value.empty() && !has_value) {
      // Another option is no value: who means it writes --option=--value.
      if (i + 1 >= given.size() || given[i + 1].starts_with("--"))
        throw UsageError(command_ + ": " + word + " needs a value, " + word + " " + option->value + ": " + option->about);
      value = given[++i];
      if (i + 1 == given.size()) last = word + " has taken '" + value + "' as its " + option->value + "; ";
    }
    values_[word].push_back(value);
  }
  if (words_.size() < syntax.least_words) {
    throw UsageError(command_ + ": " + last + "needs " + syntax.positional + " (see --help)");
  }
  if (words_.size() > syntax.most_words) {
    throw UsageError(command_ + ": does not understand '" + words_[syntax.most_words] +
                     "' (see --help)");
  }
}

bool Arguments::has(const std::string& option) const { return values_.contains(option); }

std::string Arguments::text(const std::string& option, const std::string& otherwise) const {
  const auto found = values_.find(option);
  return found == values_.end() ? otherwise : found->second.back();
}

std::vector<std::string> Arguments::all(const std::string& option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::vector<std::string>() : found->second;
}

double Arguments::number(const std::string& option, double otherwise, double least,
                         double most) const {
  return has(option) ? number_of(command_, option, text(option, ""), least, most) : otherwise;
}

std::string Arguments::word(std::size_t index, const std::string& otherwise) const {
  return index < words_.size() ? words_[index] : otherwise;
}

double Arguments::word_number(std::size_t index, const std::string& name, double least,
                              double most) const {
  return number_of(command_, name, word(index), least, most);
}

}  // namespace twinbus::common
