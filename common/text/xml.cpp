#include "common/text/xml.h"

#include <expat.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <utility>

#include "common/text/printable.h"

namespace twinbus::inline common {

const std::string* XmlElement::attribute(const std::string& key) const {
  for (const auto& [name_of, value] : attributes) {
    if (name_of == key) return &value;
  }
  return nullptr;
}

std::string attribute_of(const XmlElement& element, const std::string& child, const std::string& key) {
  const XmlElement* found = element.child(child);
  const std::string* value = found == nullptr ? nullptr : found->attribute(key);
  return value == nullptr ? std::string() : *value;
}

const XmlElement* XmlElement::child(const std::string& key) const {
  for (const XmlElement& element : children) {
    if (element.name == key) return &element;
  }
  return nullptr;
}

void fail_at(const std::string& file, int line, const std::string& message) {
  // Parts of a hostile file are quoted in messages: they stay on one line, short, and cannot drive a terminal.
  throw std::runtime_error(printable(file + ":" + std::to_string(line) + ": ", 1000) +
                           printable(message, 1000));
}

namespace {

std::string read_up_to(const std::string& path, std::size_t limit) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw std::runtime_error(path + ": no such file");
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw std::runtime_error(path + ": cannot be read");
  if (size > limit) {
    throw std::runtime_error(path + ": " + std::to_string(size) + " bytes; at most " +
                             std::to_string(limit >> 20) + " MiB are read");
  }
  std::string text(size, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream || stream.gcount() != static_cast<std::streamsize>(size)) {
    throw std::runtime_error(path + ": cannot be read");
  }
  return text;
}

}  // namespace

std::string read_file(const std::string& path) { return read_up_to(path, kMaxBinaryFile); }

std::string read_text_file(const std::string& path) {
  std::string text = read_up_to(path, kMaxTextFile);
  if (text.empty()) throw std::runtime_error(path + ": empty file; write the description into it");
  if (text.find('\0') != std::string::npos) {
    throw std::runtime_error(path + ": has a NUL byte, so it is not a text file");
  }
  return text;
}

namespace {

// From 1.  Expat 2.9 calls the older function deprecated.
int current_line(XML_Parser parser) {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
  return static_cast<int>(XML_GetCurrentLineNumber64(parser));
#else
  return static_cast<int>(XML_GetCurrentLineNumber(parser));
#endif
}

// Builds the tree while expat reads.  What this reader refuses itself is kept and stops expat, since nothing may be thrown
// through a library in C.
class TreeBuilder {
 public:
  explicit TreeBuilder(const std::string& file) : file_(file), parser_(XML_ParserCreate(nullptr)) {
    if (parser_ == nullptr) throw std::bad_alloc();
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(parser_, &TreeBuilder::on_start, &TreeBuilder::on_end);
    XML_SetCharacterDataHandler(parser_, &TreeBuilder::on_text);
    XML_SetStartDoctypeDeclHandler(parser_, &TreeBuilder::on_doctype);
  }
  ~TreeBuilder() { XML_ParserFree(parser_); }
  TreeBuilder(const TreeBuilder&) = delete;
  TreeBuilder& operator=(const TreeBuilder&) = delete;

  XmlElement parse(const std::string& text) {
    if (XML_Parse(parser_, text.data(), static_cast<int>(text.size()), XML_TRUE) == XML_STATUS_OK)
      return std::move(root_);
    const int line = current_line(parser_);
    if (!refusal_.empty()) fail_at(file_, line, refusal_);
    const XML_Error error = XML_GetErrorCode(parser_);
    if (error == XML_ERROR_NO_ELEMENTS && !started_) {
      fail_at(file_, line, "not XML: there is no element; write <robot name=...> ... </robot>");
    }
    fail_at(
        file_, line,
        std::string("not well-formed XML: ") + XML_ErrorString(error) + "; repair it in an editor");
  }

 private:
  void refuse(const char* why) {
    if (refusal_.empty()) refusal_ = why;
    XML_StopParser(parser_, XML_FALSE);
  }

  static void XMLCALL on_start(void* user, const XML_Char* name, const XML_Char** attributes) {
    TreeBuilder& self = *static_cast<TreeBuilder*>(user);
    if (!self.refusal_.empty()) return;
    self.started_ = true;
    if (self.open_.size() >= kMaxXmlDepth) {
      self.refuse("tags nested deeper than 64; flatten them");
      return;
    }
    static_assert(kMaxXmlDepth == 64);
    XmlElement element;
    element.name = name;
    element.line = current_line(self.parser_);
    for (; *attributes != nullptr; attributes += 2)
      element.attributes.emplace_back(attributes[0], attributes[1]);
    self.open_.push_back(std::move(element));
  }

  static void XMLCALL on_end(void* user, const XML_Char*) {
    TreeBuilder& self = *static_cast<TreeBuilder*>(user);
    if (!self.refusal_.empty()) return;
    XmlElement element = std::move(self.open_.back());
    self.open_.pop_back();
    constexpr const char* kBlanks = " \t\r\n";
    const std::size_t first = element.text.find_first_not_of(kBlanks);
    if (first == std::string::npos) {
      element.text.clear();
    } else {
      element.text.erase(element.text.find_last_not_of(kBlanks) + 1);
      element.text.erase(0, first);
    }
    if (self.open_.empty()) {
      self.root_ = std::move(element);
    } else {
      self.open_.back().children.push_back(std::move(element));
    }
  }

  static void XMLCALL on_text(void* user, const XML_Char* text, int size) {
    TreeBuilder& self = *static_cast<TreeBuilder*>(user);
    if (self.refusal_.empty() && self.open_.back().children.empty())
      self.open_.back().text.append(text, static_cast<std::size_t>(size));
  }

  // Declarations could give attributes values that the file does not show, or multiply its text.
  static void XMLCALL on_doctype(void* user, const XML_Char*, const XML_Char* system_id,
                                 const XML_Char*, int has_subset) {
    if (system_id != nullptr || has_subset != 0)
      static_cast<TreeBuilder*>(user)->refuse(
          "a document type with declarations is not read; remove <!DOCTYPE ...>");
  }

  const std::string& file_;
  XML_Parser parser_;
  std::vector<XmlElement> open_;  // from the root down
  XmlElement root_;
  std::string refusal_;
  bool started_ = false;
};

}  // namespace

XmlElement parse_xml(const std::string& text, const std::string& file) {
  if (text.empty()) throw std::runtime_error(file + ": empty file");
  if (text.size() > kMaxBinaryFile)
    throw std::runtime_error(file + ": too large to be read as XML");
  return TreeBuilder(file).parse(text);
}

std::string xml_escaped(const std::string& text) {
  static constexpr std::pair<char, const char*> kNames[] = {{'&', "&amp;"},  {'<', "&lt;"},   {'>', "&gt;"},  {'"', "&quot;"},
                                                            {'\t', "&#9;"}, {'\n', "&#10;"}, {'\r', "&#13;"}};
  std::string out;
  for (const char c : text) {
    const auto* name = std::find_if(std::begin(kNames), std::end(kNames), [&](const auto& one) { return one.first == c; });
    if (name == std::end(kNames)) out += c;
    else out += name->second;
  }
  return out;
}

void append_xml(const XmlElement& element, std::string& text) {
  text += '<' + element.name;
  for (const auto& [name, value] : element.attributes) {
    text += ' ' + name + "=\"" + xml_escaped(value) + '"';
  }
  text += '>' + xml_escaped(element.text);
  for (const XmlElement& child : element.children) append_xml(child, text);
  text += "</" + element.name + '>';
}

bool parse_numbers(const std::string& text, double* values, int count) {
  const char* at = text.data();
  const char* end = at + text.size();
  const auto skip_blanks = [&] {
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r')) ++at;
  };
  for (int i = 0; i < count; ++i) {
    skip_blanks();
    if (at + 1 < end && *at == '+' && at[1] != '-') ++at;
    const auto [next, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc() || !std::isfinite(values[i])) return false;
    if (next < end && std::strchr(" \t\r\n", *next) == nullptr) return false;
    at = next;
  }
  skip_blanks();
  return at == end;
}

}  // namespace twinbus::common
