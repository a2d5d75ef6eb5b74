#include "robot/mjcf/mjcf_element.h"

#include <algorithm>
#include <cmath>

#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "common/text/xml.h"

namespace twinbus::inline robot {

namespace {

constexpr std::size_t kShown = 60;

std::string brief(double value) {
  return formatted("%.3g", value);
}

// Words between blanks.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  constexpr const char* kBlanks = " \t\r\n";
  for (std::size_t start = text.find_first_not_of(kBlanks); start != std::string::npos;) {
    const std::size_t end = text.find_first_of(kBlanks, start);
    words.push_back(text.substr(start, end - start));
    start = end == std::string::npos ? end : text.find_first_not_of(kBlanks, end);
  }
  return words;
}

}  // namespace

const MjcfAttribute* MjcfElement::attribute(const std::string& key) const {
  const auto found = std::ranges::find(attributes, key, &MjcfAttribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

std::string MjcfElement::text(const std::string& key, const std::string& otherwise) const {
  const MjcfAttribute* found = attribute(key);
  return found == nullptr ? otherwise : found->value;
}

std::vector<double> MjcfElement::numbers(const std::string& key, std::size_t least, std::size_t most,
                                         double largest) const {
  const MjcfAttribute* found = attribute(key);
  if (found == nullptr) return {};
  std::vector<double> values;
  const std::vector<std::string> words = words_of(found->value);
  if (words.size() < least || words.size() > most) {
    fail(key, "has " + std::to_string(words.size()) + " numbers; " + std::to_string(least) +
                  (most == least ? "" : " to " + std::to_string(most)) + " are wanted");
  }
  for (const std::string& word : words) {
    double value = 0.0;
    if (!parse_numbers(word, &value, 1)) {
      fail(key, "\"" + word.substr(0, kShown) + "\" is not a finite number; write numbers like 0.5 or -1e-3");
    }
    if (!(std::abs(value) <= largest))
      fail(key, "has " + brief(value) + "; numbers up to " + brief(largest) + " are read");
    values.push_back(value);
  }
  return values;
}

double MjcfElement::number(const std::string& key, double otherwise, double low, double high) const {
  const std::vector<double> values = numbers(key, 1, 1, kMjcfLargest);
  if (values.empty()) return otherwise;
  if (!(values[0] >= low && values[0] <= high))
    fail(key, "is " + brief(values[0]) + "; it must be " + brief(low) + " to " + brief(high));
  return values[0];
}

Eigen::Vector3d MjcfElement::vector(const std::string& key, const Eigen::Vector3d& otherwise,
                                    double largest) const {
  const std::vector<double> values = numbers(key, 3, 3, largest);
  return values.empty() ? otherwise : Eigen::Vector3d(values[0], values[1], values[2]);
}

int MjcfElement::whole(const std::string& key, int otherwise) const {
  const std::vector<double> values = numbers(key, 1, 1, 2147483647.0);
  if (values.empty()) return otherwise;
  if (values[0] != std::floor(values[0])) fail(key, "is not a whole number");
  return static_cast<int>(values[0]);
}

bool MjcfElement::flag(const std::string& key, bool otherwise) const {
  return choice(key, {"false", "true"}, otherwise ? 1 : 0) == 1;
}

std::size_t MjcfElement::choice(const std::string& key, const std::vector<std::string>& words,
                                std::size_t otherwise) const {
  const MjcfAttribute* found = attribute(key);
  if (found == nullptr) return otherwise;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (found->value == words[i]) return i;
  }
  fail(key, "\"" + found->value.substr(0, kShown) + "\" is not known" + suggestion(found->value, words));
}

std::string MjcfElement::title() const {
  const std::string given = text("name");
  return given.empty() ? "<" + name + ">" : name + " " + given.substr(0, kShown);
}

void MjcfElement::fail(const std::string& what) const { fail_at(*place.file, place.line, title() + ": " + what); }

void MjcfElement::fail(const std::string& key, const std::string& what) const {
  const MjcfAttribute* found = attribute(key);
  const MjcfPlace& where = found == nullptr ? place : found->place;
  fail_at(*where.file, where.line, title() + ": " + key + " " + what);
}

}  // namespace twinbus::robot
