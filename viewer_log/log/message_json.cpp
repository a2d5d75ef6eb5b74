#include "viewer_log/log/message_json.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

#include "viewer_log/log/log_event.h"
#include "viewer_log/log/shortest_number.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr std::size_t kJoints = 48;  // entries of per-joint arrays

// "wrench[1][2]" -> "wrench_1", "q[3]" -> "q", "tick" -> "tick".
std::string key_of(const std::string& name) {
  const std::size_t open = name.find('[');
  if (open == std::string::npos) return name;
  std::string key = name.substr(0, open);
  const std::size_t last = name.rfind('[');
  if (last == open) return key;
  const std::size_t close = name.find(']', open);
  key += '_';
  key += name.substr(open + 1, close - open - 1);
  return key;
}

// A number as JSON has it: no minus of a zero, null for what is not finite.
template <class Bits, class Number>
char* write_real(char* out, Bits bits, Bits most) {
  if (bits << 1 == 0) {
    *out = '0';
    return out + 1;
  }
  if ((bits & most) == most) {
    std::memcpy(out, "null", 4);
    return out + 4;
  }
  return write_shortest(out, std::bit_cast<Number>(bits));
}

char* write_value(char* out, FieldType type, const std::uint8_t* p) {
  constexpr std::uint64_t kDouble = std::uint64_t{0x7ff} << 52;  // exponents of what is not finite
  constexpr std::uint32_t kFloat = std::uint32_t{0xff} << 23;
  if (type == FieldType::kFloat) return write_real<std::uint32_t, float>(out, read_u32(p), kFloat);
  if (type == FieldType::kDouble)
    return write_real<std::uint64_t, double>(out, static_cast<std::uint64_t>(read_i64(p)), kDouble);
  return write_field(out, type, p);
}

char* write_text(char* out, std::string_view text) {
  std::memcpy(out, text.data(), text.size());
  return out + text.size();
}

}  // namespace

MessageJson::MessageJson(const MessageSchema& schema)
    : schema_(&schema), joint_count_(schema.find("joint_count")) {
  nlohmann::json properties = nlohmann::json::object();
  longest_ = kLongestNumber;
  for (std::size_t i = 0; i < schema.fields.size();) {
    Member member;
    const std::string key = key_of(schema.fields[i].name);
    const std::size_t first = i;
    member.array = schema.fields[i].name.find('[') != std::string::npos;
    while (i < schema.fields.size() && key_of(schema.fields[i].name) == key) ++i;
    member.count = i - first;
    const FieldType type = member.type = schema.fields[first].type;
    member.offset = schema.fields[first].offset;
    member.size = size_of(type);
    member.text = member.array && type == FieldType::kI8 && (key == "text" || key == "name");
    member.per_joint = member.array && joint_count_ >= 0 && member.count == kJoints;
    member.key = '"';
    member.key += key;
    member.key += "\":";
    const char* kind =
        type == FieldType::kFloat || type == FieldType::kDouble ? "number" : "integer";
    if (member.text) {
      properties[key] = {{"type", "string"}};
    } else if (member.array) {
      properties[key] = {{"type", "array"}, {"items", {{"type", kind}}}};
    } else {
      properties[key] = {{"type", kind}};
    }
    constexpr std::size_t kSigns = 8, kLongestLetter = 6;  // "\\u0001"
    longest_ += kSigns + member.key.size() +
                member.count * (member.text ? kLongestLetter : kLongestNumber + 1);
    members_.push_back(std::move(member));
  }
  json_schema_ =
      nlohmann::json({{"type", "object"}, {"title", schema.type}, {"properties", properties}})
          .dump();
}

char* MessageJson::write_member(char* out, const Member& member, std::size_t count,
                                const std::uint8_t* from) {
  if (member.text) {
    const auto* begin = reinterpret_cast<const char*>(from);
    const std::string_view text(
        begin, static_cast<std::size_t>(std::find(begin, begin + count, '\0') - begin));
    return write_text(
        out, nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  if (member.array) *out++ = '[';
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) *out++ = ',';
    out = write_value(out, member.type, from + i * member.size);
  }
  if (member.array) *out++ = ']';
  return out;
}

std::string_view MessageJson::json_of(std::span<const std::uint8_t> message, JsonRoom& room) const {
  std::size_t joints = kJoints;
  const auto joints_of = [&](std::span<const std::uint8_t> one) {
    const double count = field_number(schema_->fields[static_cast<std::size_t>(joint_count_)], one);
    return static_cast<std::size_t>(std::clamp(count, 0.0, static_cast<double>(kJoints)));
  };
  if (joint_count_ >= 0) {
    joints = joints_of(message);
    if (!room.last_.empty() && joints_of(room.last_) != joints) room.last_ = {};
  }
  if (room.json_.empty()) {
    room.json_.resize(longest_);
    room.last_json_.resize(longest_);
    room.ends_.resize(members_.size());
  }
  room.json_.swap(room.last_json_);
  const char* last = room.last_json_.data();
  char* out = room.json_.data();
  char sign = '{';
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Member& member = members_[i];
    *out++ = sign;
    sign = ',';
    out = write_text(out, member.key);
    const std::uint8_t* from = message.data() + member.offset;
    const std::size_t count = member.per_joint ? std::min(joints, member.count) : member.count;
    const char* const last_end = room.last_json_.data() + room.ends_[i];
    last += 1 + member.key.size();
    if (!room.last_.empty() &&
        std::memcmp(from, room.last_.data() + member.offset, count * member.size) == 0) {
      out = write_text(out, {last, static_cast<std::size_t>(last_end - last)});
    } else {
      out = write_member(out, member, count, from);
    }
    last = last_end;
    room.ends_[i] = static_cast<std::size_t>(out - room.json_.data());
  }
  *out++ = '}';
  room.last_ = message;
  return {room.json_.data(), static_cast<std::size_t>(out - room.json_.data())};
}

}  // namespace twinbus::viewer_log
