// The .lcm files, read as tables: which number lies where in an encoded message.
//
// All our messages have fixed size, so a field is a name, a type and an offset; that is enough for CSV, for plots and
// for saying which field differs.  The texts are compiled in, and recorders write them into their logs.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twinbus::inline viewer_log {

enum class FieldType : std::int8_t { kI8, kI16, kI32, kI64, kFloat, kDouble };

struct MessageField {
  std::string name;  // q[3], wrench[1][2]
  FieldType type = FieldType::kI8;
  std::size_t offset = 0;  // in the encoded message, which begins with 8 bytes of type hash
};

struct MessageSchema {
  std::string type;  // robot_state_t
  std::vector<MessageField> fields;
  std::size_t bytes = 8;  // encoded

  // Index of a field, or -1.
  int find(std::string_view name) const;
};

// All .lcm files of the project, one after another.
std::string_view schema_texts();

// Throws std::runtime_error naming what is not understood.
std::vector<MessageSchema> parse_schemas(std::string_view text);

// Of the compiled-in texts; null for another type.
const MessageSchema* find_schema(std::string_view type);

std::size_t size_of(FieldType type);
double field_number(const MessageField& field, std::span<const std::uint8_t> message);
// Of a field of integers, every bit of it; 0 of a float or a double.
std::int64_t field_integer(const MessageField& field, std::span<const std::uint8_t> message);
// What lies at p, written to out, which has room for kLongestNumber (shortest_number.h); gives the end.
char* write_field(char* out, FieldType type, const std::uint8_t* p) noexcept;
// As a decimal that reads back to the same number.
void append_field(std::string& text, const MessageField& field,
                  std::span<const std::uint8_t> message);

}  // namespace twinbus::viewer_log
