// Command lines: typed options bound to variables, and the --help text written from them.
//
//   Options options("twinbus_bridge", "Runs a robot as a source of STATE.");
//   CommonOptions common;
//   add_common(options, common);
//   options.text("--adaptor", "PATH_OR_NAME", adaptor, "what moves the robot");
//   options.parse(argc, argv);        // --help: prints and exits 0; anything wrong: one line and
//   exit 2

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace twinbus::inline common {

class Options {
 public:
  Options(std::string program, std::string summary);

  // Variables keep their value when the option is not given; that value is shown as the default.
  // They must outlive the parse.  `--name value` and `--name=value` are the same.
  void text(const std::string& name, const std::string& value_name, std::string& variable,
            const std::string& help);
  void number(const std::string& name, const std::string& value_name, double& variable, double low,
              double high, const std::string& help);
  void integer(const std::string& name, const std::string& value_name, std::int64_t& variable,
               std::int64_t low, std::int64_t high, const std::string& help);
  void flag(const std::string& name, bool& variable, const std::string& help);
  // May be given again and again: key=value.
  void settings(const std::string& name, std::vector<std::pair<std::string, std::string>>& variable,
                const std::string& help);
  void choice(const std::string& name, const std::vector<std::string>& choices,
              std::string& variable, const std::string& help);
  // Another name for the option added last, not shown.
  void alias(const std::string& name);

  // Arguments without a name, in the order of these calls.
  void positional(const std::string& value_name, std::string& variable, bool required,
                  const std::string& help);
  void rest(const std::string& value_name, std::vector<std::string>& variable,
            const std::string& help);

  // Exits 0 after --help, 2 after a mistake.
  void parse(int argc, char** argv);

  // The same without exit: false and one sentence in error when something is wrong.  --help sets
  // help_asked.
  bool try_parse(const std::vector<std::string>& arguments, std::string& error);
  bool help_asked() const { return help_asked_; }
  bool given(const std::string& name) const;  // was this option on the command line?
  std::string help() const;

 private:
  // Takes a value into a variable; answers with what is wrong with it, or nothing.
  using Take = std::function<std::string(const std::string& value)>;
  struct Entry {
    std::string name, value_name, help, fallback;
    Take take;
    std::vector<std::string> aliases = {};
    bool required = false, many = false, given = false;
    std::string assign(const std::string& value);  // what is wrong, or nothing
  };
  Entry* find(const std::string& name);

  std::string program_, summary_;
  std::vector<Entry> options_, positionals_;
  bool help_asked_ = false;
};

// Of the bus: $LCM_DEFAULT_URL, or this project's own port, this machine only.
std::string default_url();

// What every process of the stack takes.
struct CommonOptions {
  std::string robot = "hrp1s";  // name or folder
  std::string prefix;           // before every channel
  std::string url = default_url();
  std::string allow;            // IPv4 addresses of other machines that may send to us, by commas
  std::int64_t id = 0;          // 0: draw a random one
};

void add_common(Options& options, CommonOptions& common);

}  // namespace twinbus::common
