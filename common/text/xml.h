// A small XML file as a tree that knows its line numbers, read by expat.
//
// This is the only reader of XML here: other parsers take malformed files for others, `upper="0&45"` for 45.

#pragma once

#include <string>
#include <utility>
#include <vector>

namespace twinbus::inline common {

struct XmlElement {
  std::string name;
  int line = 0;
  std::string text;  // directly inside, before the first child, without blanks around it
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;

  const std::string* attribute(const std::string& key) const;  // null if absent
  const XmlElement* child(const std::string& key) const;       // the first one, null if absent
};

inline constexpr std::size_t kMaxTextFile = 4u << 20;  // [bytes]
inline constexpr std::size_t kMaxBinaryFile = 64u << 20;
inline constexpr std::size_t kMaxXmlDepth = 64;

// Throws std::runtime_error: "file:line: message", one line without control characters.
[[noreturn]] void fail_at(const std::string& file, int line, const std::string& message);

// An attribute of its first child of that name; empty: it has none.
std::string attribute_of(const XmlElement& element, const std::string& child, const std::string& key);

// The whole file.  Throws if it is missing, not a plain file, empty, larger than kMaxTextFile or
// has a NUL byte.
std::string read_text_file(const std::string& path);
// Any file of at most kMaxBinaryFile bytes, as it is.
std::string read_file(const std::string& path);

// The root element.  Throws, naming file and line, unless the text is well-formed XML without a document type that declares
// anything and without tags nested deeper than kMaxXmlDepth.
XmlElement parse_xml(const std::string& text, const std::string& file);

// As it stands in an attribute, or between tags.
std::string xml_escaped(const std::string& text);

// Appends the element as XML: what parse_xml reads from it is equal but for the lines.
void append_xml(const XmlElement& element, std::string& text);

// Finite numbers, separated by blanks, nothing else; decimal point, whatever the locale.  False if
// text is anything else or has another count.
bool parse_numbers(const std::string& text, double* values, int count);

}  // namespace twinbus::common
