#include "common/text/strict_yaml.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "common/text/closest_name.h"
#include "common/text/printable.h"
#include "common/text/xml.h"

namespace twinbus::inline common {

namespace {

constexpr std::size_t kLongestText = 4096;  // [bytes]

// Names and texts are printed, sent and shown: control characters and broken UTF-8 do not get in.  Null if it is good.
const char* why_no_text(const std::string& text) {
  if (text.size() > kLongestText) return "is longer than 4096 bytes; shorten it";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t letter = printable_letter(std::string_view(text).substr(at));
    if (letter == 0 && text[at] != '\n' && text[at] != '\t')
      return "has a control character or broken UTF-8; write plain text";
    at += letter == 0 ? 1 : letter;
  }
  return nullptr;
}

}  // namespace

struct ConfigNode::Impl {
  Impl(std::string file_name, YAML::Node map, std::string place)
      : file(std::move(file_name)), node(std::move(map)), path(std::move(place)) {
    if (!node.IsMap())
      fail_at(file, node.Mark().line + 1,
              (path.empty() ? "the file" : path) + " must be a map (key: value)");
    std::set<std::string> seen;
    for (const auto& entry : node) {
      const int at = entry.first.Mark().line + 1;
      if (!entry.first.IsScalar()) fail_at(file, at, "a key must be plain text");
      if (const char* why = why_no_text(entry.first.Scalar()))
        fail_at(file, at, std::string("a key ") + why);
      if (!seen.insert(entry.first.Scalar()).second)
        fail_at(file, at, "key " + entry.first.Scalar() + " is there twice");
    }
  }

  // Undefined node if absent.
  YAML::Node find(const std::string& key) {
    asked.insert(key);
    const YAML::Node& fixed = node;
    return fixed[key];
  }

  std::string file;
  YAML::Node node;
  std::string path;  // of the map inside the file, for messages
  std::set<std::string> asked;
};

ConfigNode ConfigNode::load(const std::string& path) { return parse(read_text_file(path), path); }

ConfigNode ConfigNode::parse(const std::string& text, const std::string& file) {
  YAML::Node node;
  try {
    node = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    fail_at(file, error.mark.line + 1, "not valid YAML: " + error.msg);
  }
  return ConfigNode(std::make_shared<Impl>(file, node, ""));
}

bool ConfigNode::has(const std::string& key) const { return static_cast<bool>(impl_->find(key)); }

bool ConfigNode::is_map(const std::string& key) const {
  const YAML::Node node = impl_->find(key);
  return node && node.IsMap();
}

std::vector<std::string> ConfigNode::keys() const {
  std::vector<std::string> result;
  for (const auto& entry : impl_->node) {
    result.push_back(entry.first.Scalar());
    impl_->asked.insert(result.back());
  }
  return result;
}

double ConfigNode::number(const std::string& key, double low, double high) const {
  const YAML::Node node = impl_->find(key);
  if (!node) fail(key, "is missing; it is a number");
  double value = 0.0;
  if (!node.IsScalar() || !parse_numbers(node.Scalar(), &value, 1))
    fail(key, "must be a finite number");
  if (!(value >= low && value <= high)) {
    std::ostringstream message;
    message << node.Scalar() << " is out of range, " << low << " to " << high;
    fail(key, message.str());
  }
  return value;
}

double ConfigNode::number(const std::string& key, double low, double high, double fallback) const {
  return has(key) ? number(key, low, high) : fallback;
}

long long ConfigNode::integer(const std::string& key, long long low, long long high) const {
  const double value = number(key, static_cast<double>(low), static_cast<double>(high));
  const auto whole = static_cast<long long>(value);
  if (static_cast<double>(whole) != value) fail(key, "must be a whole number");
  return whole;
}

long long ConfigNode::integer(const std::string& key, long long low, long long high,
                              long long fallback) const {
  return has(key) ? integer(key, low, high) : fallback;
}

bool ConfigNode::flag(const std::string& key, bool fallback) const {
  const YAML::Node node = impl_->find(key);
  if (!node) return fallback;
  const std::string value = node.IsScalar() ? node.Scalar() : "";
  if (value == "true" || value == "yes" || value == "on") return true;
  if (value == "false" || value == "no" || value == "off") return false;
  fail(key, "must be true or false");
}

std::string ConfigNode::text(const std::string& key) const {
  const YAML::Node node = impl_->find(key);
  if (!node) fail(key, "is missing; it is a text");
  if (!node.IsScalar()) fail(key, "must be plain text");
  if (const char* why = why_no_text(node.Scalar())) fail(key, why);
  return node.Scalar();
}

std::string ConfigNode::text(const std::string& key, const std::string& fallback) const {
  return has(key) ? text(key) : fallback;
}

int ConfigNode::choice(const std::string& key, const std::vector<std::string>& choices,
                       int fallback) const {
  if (!has(key)) return fallback;
  const std::string value = text(key);
  const auto found = std::find(choices.begin(), choices.end(), value);
  if (found == choices.end()) fail(key, value + " is not known" + suggestion(value, choices));
  return static_cast<int>(found - choices.begin());
}

std::vector<double> ConfigNode::numbers(const std::string& key, std::size_t count) const {
  const YAML::Node node = impl_->find(key);
  if (!node) fail(key, "is missing; it is a list of " + std::to_string(count) + " numbers");
  if (!node.IsSequence() || node.size() != count)
    fail(key, "must be a list of " + std::to_string(count) + " numbers");
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!node[i].IsScalar() || !parse_numbers(node[i].Scalar(), &result[i], 1)) {
      fail(key, "number " + std::to_string(i + 1) + " must be a finite number");
    }
  }
  return result;
}

std::vector<double> ConfigNode::numbers(const std::string& key, std::size_t count,
                                        const std::vector<double>& fallback) const {
  return has(key) ? numbers(key, count) : fallback;
}

std::vector<std::string> ConfigNode::texts(const std::string& key) const {
  const YAML::Node node = impl_->find(key);
  if (!node) return {};
  if (!node.IsSequence()) fail(key, "must be a list, as in [a, b]");
  std::vector<std::string> result;
  for (const auto& entry : node) {
    if (!entry.IsScalar()) fail(key, "must be a list of plain texts");
    if (const char* why = why_no_text(entry.Scalar())) fail(key, why);
    result.push_back(entry.Scalar());
  }
  return result;
}

ConfigNode ConfigNode::map(const std::string& key) const {
  const YAML::Node node = impl_->find(key);
  if (!node) fail(key, "is missing; it is a map");
  return ConfigNode(std::make_shared<Impl>(impl_->file, node, key));
}

std::vector<ConfigNode> ConfigNode::list(const std::string& key) const {
  const YAML::Node node = impl_->find(key);
  if (!node) return {};
  if (!node.IsSequence()) fail(key, "must be a list (- ...)");
  std::vector<ConfigNode> result;
  for (const auto& entry : node) {
    result.push_back(ConfigNode(std::make_shared<Impl>(impl_->file, entry, "an entry of " + key)));
  }
  return result;
}

void ConfigNode::finish() const {
  const std::vector<std::string> known(impl_->asked.begin(), impl_->asked.end());
  for (const auto& entry : impl_->node) {
    const std::string& key = entry.first.Scalar();
    if (impl_->asked.count(key) == 0) {
      fail_at(impl_->file, entry.first.Mark().line + 1,
              "key " + key + (impl_->path.empty() ? "" : " of " + impl_->path) + " is not known" +
                  suggestion(key, known));
    }
  }
}

const std::string& ConfigNode::file() const { return impl_->file; }

int ConfigNode::line() const { return impl_->node.Mark().line + 1; }

int ConfigNode::line(const std::string& key) const {
  for (const auto& entry : impl_->node) {
    if (entry.first.Scalar() == key) return entry.first.Mark().line + 1;
  }
  return line();
}

std::string ConfigNode::where(const std::string& key) const {
  return impl_->file + ":" + std::to_string(line(key)) + ": " + printable(key, 100);
}

void ConfigNode::fail(const std::string& key, const std::string& message) const {
  fail_at(impl_->file, line(key),
          printable(key, 100) + (impl_->path.empty() ? "" : " of " + impl_->path) + " " + message);
}

}  // namespace twinbus::common
