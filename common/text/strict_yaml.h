// A YAML file read strictly: whatever is not asked for is an error that names file, line and the
// nearest valid key.
//
//   ConfigNode robot = ConfigNode::load(path);
//   const double period = robot.number("period", 0.0005, 0.1, 0.002);   // between, default
//   robot.finish();                                                     // complains about every
//   other key
//
// Used by robot.yaml, scenes, stacks and gamepads alike.  All functions throw std::runtime_error.

#pragma once

#include <memory>
#include <string>
#include <vector>

namespace twinbus::inline common {

class ConfigNode {
 public:
  // Reads a file of at most 4 MiB whose top is a map.
  static ConfigNode load(const std::string& path);
  static ConfigNode parse(const std::string& text, const std::string& file);

  bool has(const std::string& key) const;  // counts as asked for
  std::vector<std::string> keys()
      const;  // of this map, for maps whose keys are names; counts as asked for

  // Values.  The form without a default demands the key.
  double number(const std::string& key, double low, double high) const;
  double number(const std::string& key, double low, double high, double fallback) const;
  long long integer(const std::string& key, long long low, long long high) const;
  long long integer(const std::string& key, long long low, long long high,
                    long long fallback) const;
  bool flag(const std::string& key, bool fallback) const;
  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& fallback) const;
  // One of the names in choices; returns its index.
  int choice(const std::string& key, const std::vector<std::string>& choices, int fallback) const;
  std::vector<double> numbers(const std::string& key, std::size_t count) const;  // exactly count
  std::vector<double> numbers(const std::string& key, std::size_t count,
                              const std::vector<double>& fallback) const;
  std::vector<std::string> texts(const std::string& key) const;  // a list; empty if absent

  bool is_map(const std::string& key) const;                   // false if absent
  ConfigNode map(const std::string& key) const;                // a map that must be there
  std::vector<ConfigNode> list(const std::string& key) const;  // a list of maps; empty if absent

  // Throws if the map has a key that none of the calls above asked for.
  void finish() const;

  const std::string& file() const;
  int line() const;  // of the map
  int line(const std::string& key) const;
  std::string where(const std::string& key) const;  // "file:line: key"
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

 private:
  struct Impl;
  explicit ConfigNode(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<Impl> impl_;
};

}  // namespace twinbus::common
