#include "viewer_log/log/message_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <deque>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "viewer_log/log/log_event.h"

namespace twinbus {
namespace {

std::vector<std::uint8_t> zeros(const MessageSchema& schema) {
  return std::vector<std::uint8_t>(schema.bytes);
}

const MessageField& field_of(const MessageSchema& schema, const char* name) {
  return schema.fields.at(static_cast<std::size_t>(schema.find(name)));
}

TEST(MessageJson, KeepsNumbersToTheLastBitAndEndsWithTheLastJoint) {
  const MessageSchema& schema = *find_schema("robot_state_t");
  std::vector<std::uint8_t> message = zeros(schema);
  message[field_of(schema, "joint_count").offset + 1] = 2;
  const double angle = 0.1 + 1e-16, large = -1.7976931348623157e308;
  write_i64(message.data() + field_of(schema, "q[0]").offset, std::bit_cast<std::int64_t>(angle));
  write_i64(message.data() + field_of(schema, "q[1]").offset, std::bit_cast<std::int64_t>(large));
  write_u32(message.data() + field_of(schema, "wrench[1][2]").offset,
            std::bit_cast<std::uint32_t>(0.1F));
  write_u32(message.data() + field_of(schema, "gyro[1]").offset,
            std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN()));
  JsonRoom room;
  const std::string text(MessageJson(schema).json_of(message, room));
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["q"], nlohmann::json({angle, large}));
  EXPECT_EQ(json["tau"].size(), 2U);
  EXPECT_EQ(json["wrench_1"].size(), 6U);
  EXPECT_EQ(static_cast<float>(json["wrench_1"][2].get<double>()), 0.1F);
  EXPECT_TRUE(json["gyro"][1].is_null()) << "JSON has no word for what is not finite";
}

TEST(MessageJson, TextIsTextAndNoSchemaHasArraysOfArrays) {
  const MessageSchema& schema = *find_schema("event_t");
  std::vector<std::uint8_t> message = zeros(schema);
  const std::string said = "it \"fell\" \x01\xff";
  std::copy(said.begin(), said.end(),
            message.begin() + static_cast<std::ptrdiff_t>(field_of(schema, "text[0]").offset));
  JsonRoom room;
  const std::string text(MessageJson(schema).json_of(message, room));
  EXPECT_EQ(nlohmann::json::parse(text)["text"].get<std::string>().substr(0, 9), "it \"fell\"");
  for (const MessageSchema& type : parse_schemas(schema_texts())) {
    const auto properties = nlohmann::json::parse(MessageJson(type).json_schema())["properties"];
    JsonRoom other_room;
    const auto json = nlohmann::json::parse(MessageJson(type).json_of(zeros(type), other_room));
    EXPECT_EQ(json.size(), properties.size()) << type.type;
    for (const auto& [key, about] : properties.items()) {
      EXPECT_EQ(json[key].is_array(), about["type"] == "array") << type.type << "." << key;
      if (about["type"] == "array") {
        EXPECT_NE(about["items"]["type"], "array");
      }
    }
  }
}

// What did not change since the last message is taken over from it: nobody may see that.
TEST(MessageJson, RemembersTheLastMessageWithoutATrace) {
  std::mt19937 random(3);
  for (const char* type : {"robot_state_t", "joint_command_t", "event_t", "journal_t"}) {
    const MessageSchema& schema = *find_schema(type);
    const MessageJson writer(schema);
    JsonRoom one;
    std::deque<std::vector<std::uint8_t>> messages = {zeros(schema)};  // each stays in its place
    for (int turn = 0; turn < 300; ++turn) {
      std::vector<std::uint8_t>& message = messages.emplace_back(messages.back());
      for (int k = 0; k < 5; ++k) {
        const auto at = 8 + random() % (schema.bytes - 8);
        message[at] = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
      }
      if (const int count = schema.find("joint_count"); count >= 0) {
        const std::size_t offset = schema.fields[static_cast<std::size_t>(count)].offset;
        message[offset] = 0;
        message[offset + 1] = static_cast<std::uint8_t>(turn / 100 * 10);
      }
      JsonRoom fresh;
      ASSERT_EQ(writer.json_of(message, one), writer.json_of(message, fresh)) << type << turn;
    }
  }
}

}  // namespace
}  // namespace twinbus
