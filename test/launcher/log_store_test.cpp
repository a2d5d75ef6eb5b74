#include "launcher/log/log_store.h"

#include <gtest/gtest.h>

#include "lcmtypes/bus/wire.h"
#include "lcmtypes/msg/journal.h"
#include "viewer_log/log/message_schema.h"

namespace twinbus {
namespace {

RobotState state(std::int64_t tick) {
  RobotState s;
  s.tick = tick;
  s.joint_count = 29;
  s.period_ns = 2'000'000;
  s.source = SourceKind::kSimulator;
  s.role = Role::kActive;
  for (std::size_t k = 0; k < 29; ++k) s.q[k] = 0.01 * static_cast<double>(k + 1);
  return s;
}

// The tables made of the .lcm texts and the encoders made by lcm-gen must mean the same bytes.
TEST(MessageSchema, HasTheSizeOfEveryTypeOnTheBus) {
  for (const ChannelInfo& info : channel_table()) {
    const MessageSchema* schema = find_schema(info.type);
    ASSERT_NE(schema, nullptr) << info.type;
    EXPECT_EQ(static_cast<int>(schema->bytes), info.bytes) << info.type;
  }
}

TEST(MessageSchema, ReadsTheFieldsThatWereWritten) {
  const std::vector<std::uint8_t> bytes = encoded(state(1234));
  const MessageSchema* schema = find_schema("robot_state_t");
  const auto number = [&](const char* name) {
    return field_number(schema->fields[static_cast<std::size_t>(schema->find(name))], bytes);
  };
  EXPECT_EQ(number("tick"), 1234.0);
  EXPECT_EQ(number("joint_count"), 29.0);
  EXPECT_EQ(number("q[28]"), 0.29);
  EXPECT_EQ(number("attitude[0]"), 1.0);
  EXPECT_EQ(schema->find("q[48]"), -1);
  EXPECT_EQ(schema->fields.back().name, "wrench[7][5]");
  EXPECT_THROW(parse_schemas("struct x_t { string y; }"), std::runtime_error);
}

TEST(LogStore, FindsMessagesByWhatIsInThemAndForgetsOldOnes) {
  LogStore store;
  for (std::int64_t tick = 0; tick < 5000; ++tick)
    store.add("STATE", 2000 * tick, encoded(state(tick)));
  EXPECT_NE(store.find(content_hash(encoded(state(4999)))), nullptr);
  EXPECT_EQ(store.find(content_hash(encoded(state(100)))), nullptr);  // ten seconds ago
  GuardReport report;
  report.tick = 7;
  const std::int64_t plain = content_hash(encoded(report));
  report.compute_ns = 12345;
  store.add("GUARD", 10'000'000, encoded(report));
  ASSERT_NE(store.find(plain), nullptr);  // compute_ns does not count
  EXPECT_NE(store.find(content_hash(encoded(report))), nullptr);
}

TEST(LogStore, AFlippedBitIsMendedAndItsFieldNamed) {
  const std::vector<std::uint8_t> sent = encoded(state(77));
  const MessageSchema* schema = find_schema("robot_state_t");
  const std::size_t offset = schema->fields[static_cast<std::size_t>(schema->find("q[3]"))].offset;
  std::vector<std::uint8_t> damaged = sent;
  damaged[offset + 2] = static_cast<std::uint8_t>(damaged[offset + 2] ^ 0x20);
  std::size_t byte = 0;
  EXPECT_EQ(with_one_bit_mended(damaged, content_hash(sent), byte), sent);
  EXPECT_EQ(byte, offset + 2);
  EXPECT_EQ(first_difference("STATE", damaged, sent, "then").substr(0, 6), "q[3]: ");
  damaged[offset + 9] = static_cast<std::uint8_t>(damaged[offset + 9] ^ 1);
  EXPECT_TRUE(
      with_one_bit_mended(damaged, content_hash(sent), byte).empty());  // two bits are beyond it
}

}  // namespace
}  // namespace twinbus
