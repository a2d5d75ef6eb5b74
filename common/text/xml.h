// A small XML file as a tree that knows its line numbers.
//
// What is too large, too deeply nested or not text is refused before the parser sees it: the
// parsers below us recurse.

#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace twinbus {

struct XmlElement {
  std::string name;
  int line = 0;
  std::string text;  // directly inside, the first piece
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;

  const std::string* attribute(const std::string& key) const;  // null if absent
  const XmlElement* child(const std::string& key) const;       // the first one, null if absent
};

inline constexpr std::size_t kMaxTextFile = 4u << 20;  // [bytes]
inline constexpr std::size_t kMaxBinaryFile = 64u << 20;
inline constexpr int kMaxXmlDepth = 64;

// Throws std::runtime_error: "file:line: message", one line without control characters.
[[noreturn]] void fail_at(const std::string& file, int line, const std::string& message);

// The whole file.  Throws if it is missing, not a plain file, empty, larger than kMaxTextFile or
// has a NUL byte.
std::string read_text_file(const std::string& path);
// Any file of at most kMaxBinaryFile bytes, as it is.
std::string read_file(const std::string& path);

// Throws if tags are nested deeper than kMaxXmlDepth.  Looks at every tag, without recursion.
void refuse_deep_nesting(const std::string& text, const std::string& file);

// The root element.  Throws, naming file and line.
XmlElement parse_xml(const std::string& text, const std::string& file);

// Finite numbers, separated by blanks, nothing else; decimal point, whatever the locale.  False if
// text is anything else or has another count.
bool parse_numbers(const std::string& text, double* values, int count);

}  // namespace twinbus
