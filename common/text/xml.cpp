#include "common/text/xml.h"

#include <tinyxml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace twinbus {

const std::string* XmlElement::attribute(const std::string& key) const {
  for (const auto& [name_of, value] : attributes) {
    if (name_of == key) return &value;
  }
  return nullptr;
}

const XmlElement* XmlElement::child(const std::string& key) const {
  for (const XmlElement& element : children) {
    if (element.name == key) return &element;
  }
  return nullptr;
}

void fail_at(const std::string& file, int line, const std::string& message) {
  std::string text = file + ":" + std::to_string(line) + ": " + message;
  // Parts of a hostile file are quoted in messages: they stay on one line and cannot drive a terminal.
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  }
  throw std::runtime_error(text);
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

// Stops counting at the first thing that is not XML.
void refuse_deep_nesting(const std::string& text, const std::string& file) {
  int depth = 0;
  int line = 1;
  std::size_t counted = 0;
  std::size_t at = 0;
  const auto skip_past = [&](const char* end) {
    const std::size_t found = text.find(end, at);
    at = found == std::string::npos ? text.size() : found + std::strlen(end);
  };
  while ((at = text.find('<', at)) != std::string::npos) {
    for (; counted < at; ++counted) line += text[counted] == '\n' ? 1 : 0;
    if (text.compare(at, 4, "<!--") == 0) {
      skip_past("-->");
    } else if (text.compare(at, 9, "<![CDATA[") == 0) {
      skip_past("]]>");
    } else if (text.compare(at, 2, "<?") == 0) {
      skip_past("?>");
    } else if (text.compare(at, 2, "<!") == 0) {
      skip_past(">");
    } else if (text.compare(at, 2, "</") == 0) {
      --depth;
      skip_past(">");
    } else {
      char quote = 0;
      std::size_t end = at + 1;
      for (; end < text.size() && (quote != 0 || text[end] != '>'); ++end) {
        if (quote != 0) {
          if (text[end] == quote) quote = 0;
        } else if (text[end] == '"' || text[end] == '\'') {
          quote = text[end];
        }
      }
      if (text[end - 1] != '/') ++depth;
      if (depth > kMaxXmlDepth) {
        fail_at(file, line,
                "tags nested deeper than " + std::to_string(kMaxXmlDepth) + "; flatten them");
      }
      at = end;
    }
  }
}

namespace {

constexpr std::size_t kLongText = 64;  // [bytes]
constexpr char kLifted = '\x01';  // in place of a long list: this, its number, and its line ends

bool is_of_a_number(char c) {
  return (c >= '0' && c <= '9') || c == ' ' || c == '\n' || c == '.' || c == '-' || c == 'e' ||
         c == 'E' || c == '+' || c == '\r' || c == '\t';
}

// Mesh files are long lists of numbers, over which TinyXML takes a hundred instructions per byte:
// it is given the file without them.
std::string without_lists(const std::string& text, std::vector<std::string_view>& lists) {
  // Where the mark may come from elsewhere, written or as a number, nothing is left out.
  for (const char* other : {"\x01", "&#", "<![CDATA["}) {
    if (text.find(other) != std::string::npos) return text;
  }
  std::string rest;
  std::size_t kept = 0;  // up to here
  for (std::size_t tag = text.find('>'); tag != std::string::npos; tag = text.find('>', tag)) {
    const std::size_t begin = ++tag;
    while (tag < text.size() && is_of_a_number(text[tag])) ++tag;
    if (tag - begin < kLongText || tag == text.size() || text[tag] != '<') continue;
    const std::string_view list = std::string_view(text).substr(begin, tag - begin);
    rest.append(text, kept, begin - kept);
    rest += kLifted + std::to_string(lists.size());
    rest.append(static_cast<std::size_t>(std::count(list.begin(), list.end(), '\n')), '\n');
    lists.push_back(list);
    kept = tag;
  }
  return rest.append(text, kept);
}

XmlElement convert(const TiXmlElement& from, const std::vector<std::string_view>& lists) {
  XmlElement element;
  element.name = from.ValueStr();
  element.line = from.Row();
  if (const char* text = from.GetText()) {
    element.text = text;
    if (text[0] == kLifted && !lists.empty()) element.text = lists[std::stoul(text + 1)];
  }
  for (const TiXmlAttribute* a = from.FirstAttribute(); a != nullptr; a = a->Next()) {
    element.attributes.emplace_back(a->Name(), a->ValueStr());
  }
  for (const TiXmlElement* c = from.FirstChildElement(); c != nullptr;
       c = c->NextSiblingElement()) {
    element.children.push_back(convert(*c, lists));
  }
  return element;
}

}  // namespace

XmlElement parse_xml(const std::string& text, const std::string& file) {
  if (text.empty()) throw std::runtime_error(file + ": empty file");
  refuse_deep_nesting(text, file);
  TiXmlDocument document;
  // TinyXML steps over the end by up to three bytes where a letter of several is cut short.
  std::vector<std::string_view> lists;
  const std::string padded = without_lists(text, lists) + std::string(8, '\0');
  document.Parse(padded.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) {
    std::string why = document.ErrorDesc();
    if (!why.empty() && why.back() == '.') why.pop_back();
    fail_at(file, std::max(document.ErrorRow(), 1),
            "not well-formed XML: " + why + "; repair it in an editor");
  }
  const TiXmlElement* root = document.RootElement();
  if (root == nullptr)
    throw std::runtime_error(file +
                             ": not XML: there is no element; write <robot name=...> ... </robot>");
  return convert(*root, lists);
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

}  // namespace twinbus
