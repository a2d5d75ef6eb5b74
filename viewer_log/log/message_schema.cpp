#include "viewer_log/log/message_schema.h"

#include <array>
#include <bit>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "viewer_log/log/log_event.h"
#include "viewer_log/log/shortest_number.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr std::string_view kTexts =
#include "message_schemas.inc"
    ;
constexpr std::size_t kMostFields = 100000;

constexpr std::pair<std::string_view, FieldType> kTypes[] = {
    {"int8_t", FieldType::kI8},   {"byte", FieldType::kI8},      {"boolean", FieldType::kI8},
    {"int16_t", FieldType::kI16}, {"int32_t", FieldType::kI32},  {"int64_t", FieldType::kI64},
    {"float", FieldType::kFloat}, {"double", FieldType::kDouble}};

// Words and single signs; comments and spaces left out.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else if (is_word(text[at])) {
      std::size_t end = at;
      while (end < text.size() && is_word(text[end])) ++end;
      words.push_back(text.substr(at, end - at));
      at = end;
    } else {
      if (text[at] > ' ') words.push_back(text.substr(at, 1));
      ++at;
    }
  }
  return words;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : words_(words_of(text)) {}

  std::vector<MessageSchema> parse() {
    std::vector<MessageSchema> all;
    while (at_ < words_.size()) {
      const std::string_view word = take();
      if (word == "package") {
        take();
        expect(";");
      } else if (word == "struct") {
        all.push_back(message());
      } else {
        fail(word);
      }
    }
    return all;
  }

 private:
  [[noreturn]] static void fail(std::string_view word) {
    throw std::runtime_error("message types: '" + std::string(word) + "' is not understood");
  }
  std::string_view take() { return at_ < words_.size() ? words_[at_++] : std::string_view(); }
  void expect(std::string_view word) {
    if (const std::string_view found = take(); found != word) fail(found);
  }

  MessageSchema message() {
    MessageSchema schema;
    schema.type = take();
    expect("{");
    for (std::string_view word = take(); word != "}"; word = take()) member(schema, word);
    return schema;
  }

  void member(MessageSchema& schema, std::string_view type_name) {
    FieldType type{};
    bool known = false;
    for (const auto& [name, value] : kTypes) {
      if (name == type_name) {
        type = value;
        known = true;
      }
    }
    if (!known) fail(type_name);
    std::string_view sign;
    do {
      std::vector<std::string> names = {std::string(take())};
      for (sign = take(); sign == "["; sign = take()) {
        const std::string_view word = take();
        std::size_t count = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
        if (error != std::errc() || end != word.data() + word.size()) fail(word);
        if (count * names.size() > kMostFields) fail(word);
        expect("]");
        std::vector<std::string> longer;
        for (const std::string& name : names) {
          for (std::size_t i = 0; i < count; ++i)
            longer.push_back(name + "[" + std::to_string(i) + "]");
        }
        names = std::move(longer);
      }
      for (std::string& name : names) {
        schema.fields.push_back({std::move(name), type, schema.bytes});
        schema.bytes += size_of(type);
      }
    } while (sign == ",");
    if (sign != ";") fail(sign);
  }

  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
};

std::int64_t integer(FieldType type, const std::uint8_t* p) {
  switch (type) {
    case FieldType::kI8:
      return static_cast<std::int8_t>(*p);
    case FieldType::kI16:
      return static_cast<std::int16_t>(p[0] << 8 | p[1]);
    case FieldType::kI32:
      return static_cast<std::int32_t>(read_u32(p));
    default:
      return read_i64(p);
  }
}

}  // namespace

int MessageSchema::find(std::string_view name) const {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

std::string_view schema_texts() { return kTexts; }

std::vector<MessageSchema> parse_schemas(std::string_view text) { return Parser(text).parse(); }

const MessageSchema* find_schema(std::string_view type) {
  static const std::vector<MessageSchema> all = parse_schemas(kTexts);
  for (const MessageSchema& schema : all) {
    if (schema.type == type) return &schema;
  }
  return nullptr;
}

std::size_t size_of(FieldType type) {
  constexpr std::array<std::size_t, 6> kSizes = {1, 2, 4, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

double field_number(const MessageField& field, std::span<const std::uint8_t> message) {
  const std::uint8_t* p = message.data() + field.offset;
  if (field.type == FieldType::kFloat)
    return static_cast<double>(std::bit_cast<float>(read_u32(p)));
  if (field.type == FieldType::kDouble) return std::bit_cast<double>(read_i64(p));
  return static_cast<double>(integer(field.type, p));
}

std::int64_t field_integer(const MessageField& field, std::span<const std::uint8_t> message) {
  if (field.type == FieldType::kFloat || field.type == FieldType::kDouble) return 0;
  return integer(field.type, message.data() + field.offset);
}

char* write_field(char* out, FieldType type, const std::uint8_t* p) noexcept {
  if (type == FieldType::kFloat) return write_shortest(out, std::bit_cast<float>(read_u32(p)));
  if (type == FieldType::kDouble) return write_shortest(out, std::bit_cast<double>(read_i64(p)));
  return std::to_chars(out, out + kLongestNumber, integer(type, p)).ptr;
}

void append_field(std::string& text, const MessageField& field,
                  std::span<const std::uint8_t> message) {
  const std::uint8_t* p = message.data() + field.offset;
  char digits[kLongestNumber];
  text.append(digits, write_field(digits, field.type, p));
}

}  // namespace twinbus::viewer_log
