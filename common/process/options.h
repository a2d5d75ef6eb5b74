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
#include <string>
#include <utility>
#include <vector>

namespace twinbus {

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
  enum class Kind { kText, kNumber, kInteger, kFlag, kSettings, kChoice, kRest };
  struct Entry {
    Entry(Kind what, const std::string& option, const std::string& value, const std::string& about, void* target)
        : kind(what), name(option), value_name(value), help(about), variable(target) {}
    Kind kind;
    std::string name, value_name, help, fallback;
    void* variable;
    double low = 0.0, high = 0.0;
    std::int64_t integer_low = 0, integer_high = 0;
    std::vector<std::string> choices, aliases;
    bool required = false, given = false;
  };
  Entry* find(const std::string& name);
  static bool assign(Entry& entry, const std::string& value, std::string& error);
  Entry& add(Kind kind, const std::string& name, const std::string& value_name, void* variable,
             const std::string& help);
  Entry& add_positional(Kind kind, const std::string& value_name, void* variable, const std::string& help);

  std::string program_, summary_;
  std::vector<Entry> options_, positionals_;
  bool help_asked_ = false;
};

// What every process of the stack takes.
struct CommonOptions {
  std::string robot = "hrp1s";  // name or folder
  std::string prefix;           // before every channel
  std::string url;              // $LCM_DEFAULT_URL, else the project's own port, this machine only
  std::string allow;            // IPv4 addresses of other machines that may send to us, by commas
  std::int64_t id = 0;          // 0: draw a random one
  CommonOptions();
};

void add_common(Options& options, CommonOptions& common);

}  // namespace twinbus
