#include "viewer_log/message_json.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "viewer_log/log_event.h"

namespace twinbus {

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

void append_value(std::string& out, const MessageField& field,
                  std::span<const std::uint8_t> message) {
  const std::uint8_t* p = message.data() + field.offset;
  double value = 0.0;
  if (field.type == FieldType::kFloat) {
    const float exact = std::bit_cast<float>(read_u32(p));
    value = static_cast<double>(exact);
  } else if (field.type == FieldType::kDouble) {
    value = std::bit_cast<double>(read_i64(p));
  } else {
    append_field(out, field, message);
    return;
  }
  if (value == 0.0) {
    out += '0';
  } else if (!std::isfinite(value)) {
    out += "null";
  } else {
    append_field(out, field, message);
  }
}

}  // namespace

MessageJson::MessageJson(const MessageSchema& schema)
    : schema_(&schema), joint_count_(schema.find("joint_count")) {
  nlohmann::json properties = nlohmann::json::object();
  for (std::size_t i = 0; i < schema.fields.size();) {
    Member member;
    const std::string key = key_of(schema.fields[i].name);
    member.first = i;
    member.array = schema.fields[i].name.find('[') != std::string::npos;
    while (i < schema.fields.size() && key_of(schema.fields[i].name) == key) ++i;
    member.count = i - member.first;
    const FieldType type = schema.fields[member.first].type;
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
    members_.push_back(std::move(member));
  }
  json_schema_ =
      nlohmann::json({{"type", "object"}, {"title", schema.type}, {"properties", properties}})
          .dump();
}

void MessageJson::append(std::string& out, std::span<const std::uint8_t> message) const {
  std::size_t joints = kJoints;
  if (joint_count_ >= 0) {
    const double count =
        field_number(schema_->fields[static_cast<std::size_t>(joint_count_)], message);
    joints = static_cast<std::size_t>(std::clamp(count, 0.0, static_cast<double>(kJoints)));
  }
  char sign = '{';
  for (const Member& member : members_) {
    out += sign;
    sign = ',';
    out += member.key;
    const MessageField* fields = schema_->fields.data() + member.first;
    if (member.text) {
      const auto* begin = reinterpret_cast<const char*>(message.data() + fields->offset);
      const std::string_view text(
          begin, static_cast<std::size_t>(std::find(begin, begin + member.count, '\0') - begin));
      out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    } else if (!member.array) {
      append_value(out, *fields, message);
    } else {
      const std::size_t count = member.per_joint ? std::min(joints, member.count) : member.count;
      out += '[';
      for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) out += ',';
        append_value(out, fields[i], message);
      }
      out += ']';
    }
  }
  out += '}';
}

}  // namespace twinbus
