// Command line of one command: options that take a value, flags, and the words that are left.
//
// Everything a user can get wrong here is a UsageError: one line, exit status 2.

#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace twinbus {

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct OptionSpec {
  std::string name;   // with its dashes
  std::string value;  // what the value is called; empty for a flag
  std::string about;
};

struct Syntax {
  std::string command;
  std::string positional;  // as shown in the usage line
  std::string about;       // sentences
  std::vector<OptionSpec> options;
  std::size_t least_words = 0;
  std::size_t most_words = 0;
};

// Options that every command on the bus has.
OptionSpec prefix_option();
OptionSpec url_option();
OptionSpec allow_option();
OptionSpec robot_option();

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

}  // namespace twinbus
