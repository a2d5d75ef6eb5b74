// An element of an MJCF model after its includes are put in: every attribute knows the file and line it comes from.
//
// The readers below are the only way from text to numbers here.  Each throws std::runtime_error, one line "file:line: what",
// for anything else than what it says.

#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace twinbus::inline robot {

struct MjcfPlace {
  std::shared_ptr<const std::string> file;
  int line = 0;
};

struct MjcfAttribute {
  std::string name, value;
  MjcfPlace place;
};

struct MjcfElement {
  std::string name;
  MjcfPlace place;
  std::vector<MjcfAttribute> attributes;
  std::vector<MjcfElement> children;

  const MjcfAttribute* attribute(const std::string& key) const;  // null if absent
  bool has(const std::string& key) const { return attribute(key) != nullptr; }
  std::string text(const std::string& key, const std::string& otherwise = "") const;

  // least to most finite numbers, each of size `largest` at most; empty if the attribute is absent.
  std::vector<double> numbers(const std::string& key, std::size_t least, std::size_t most,
                              double largest) const;
  double number(const std::string& key, double otherwise, double low, double high) const;
  Eigen::Vector3d vector(const std::string& key, const Eigen::Vector3d& otherwise,
                         double largest) const;
  int whole(const std::string& key, int otherwise) const;  // an integer
  bool flag(const std::string& key, bool otherwise) const;  // "true" or "false"
  // Which of the words it is.
  std::size_t choice(const std::string& key, const std::vector<std::string>& words,
                     std::size_t otherwise) const;

  // "joint knee", for messages.
  std::string title() const;
  [[noreturn]] void fail(const std::string& what) const;
  // Names the place of the attribute, which may be a default class.
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;
};

inline constexpr double kMjcfFarthest = 1e3;  // of a position [m]
inline constexpr double kMjcfLargest = 1e15;  // of anything else, in SI units

}  // namespace twinbus::robot
