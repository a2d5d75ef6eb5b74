// Command line of one command: options that take a value, flags, and the words that are left.
//
// Everything a user can get wrong here is a UsageError: one line, exit status 2.

#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace twinbus::inline common {

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct OptionSpec {
  std::string name;   // with its dashes
  std::string value;  // what the value is called; empty for a flag
  std::string about;
};

// What a command takes, written nearly as its --help prints it:
//
//   {"walk", 0, 3, R"(VX VY WZ | --steps FILE
//   Walks at VX m/s forward ...
//     --for S  seconds; default 2
//     --robot --url)"}
//
// First the words as the usage line shows them (none: an empty line), then sentences, then an option a line: its name, what
// its value is called (a flag has none), two blanks, what it is for.  Names alone are options that many commands have.  A \ at
// the end of a line joins the next to it.
struct Syntax {
  Syntax(std::string command, std::size_t least_words, std::size_t most_words, std::string_view help);

  std::string command;
  std::size_t least_words, most_words;
  std::string positional;  // as shown in the usage line
  std::string about;       // sentences
  std::vector<OptionSpec> options;
};

class Arguments {
 public:
  // Prints the help and exits 0 when --help is there.  A word like -0.3 is a word, not an option.
  Arguments(const Syntax& syntax, const std::vector<std::string>& words);

  bool has(const std::string& option) const;
  std::string text(const std::string& option, const std::string& otherwise) const;
  std::vector<std::string> all(const std::string& option) const;
  // Throws UsageError unless the value is a number within [least, most].
  double number(const std::string& option, double otherwise, double least, double most) const;

  const std::vector<std::string>& words() const { return words_; }
  std::string word(std::size_t index, const std::string& otherwise = "") const;
  double word_number(std::size_t index, const std::string& name, double least, double most) const;

 private:
  std::string command_;
  std::map<std::string, std::vector<std::string>> values_;
  std::vector<std::string> words_;
};

std::string help_text(const Syntax& syntax);

}  // namespace twinbus::common
