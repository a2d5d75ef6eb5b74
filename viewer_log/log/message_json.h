// An encoded message as JSON, and the JSON schema of its type, for tools that read JSON.
//
// Arrays stay arrays; of the rows of a two-dimensional one each is an array of its own (wrench_0, wrench_1), because plot
// tools take no array of arrays.  Per-joint arrays end with the last joint; text is text; what is not finite is null.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer_log/log/message_schema.h"

namespace twinbus::inline viewer_log {

// Where the JSON of messages of one type is written.  Remembers the last message, which has to stay where it was: what
// did not change is not written as decimals again.
class JsonRoom {
 private:
  friend class MessageJson;
  std::vector<char> json_, last_json_;
  std::vector<std::size_t> ends_;       // of the members in json_
  std::span<const std::uint8_t> last_;  // message; empty at first
};

class MessageJson {
 public:
  explicit MessageJson(const MessageSchema& schema);

  const std::string& json_schema() const { return json_schema_; }
  // message has the size of the schema.  What is given back lies in the room, which is of this object alone.
  std::string_view json_of(std::span<const std::uint8_t> message, JsonRoom& room) const;

 private:
  struct Member {
    std::string key;  // "q":  with its quotes and colon
    FieldType type = FieldType::kI8;
    std::size_t offset = 0, size = 0, count = 0;  // of its values in the message [bytes]
    bool array = false, text = false, per_joint = false;
  };
  static char* write_member(char* out, const Member& member, std::size_t count,
                            const std::uint8_t* from);

  const MessageSchema* schema_;
  int joint_count_ = -1;  // the field that says how many joints there are
  std::vector<Member> members_;
  std::string json_schema_;
  std::size_t longest_ = 0;  // JSON [bytes]
};

}  // namespace twinbus::viewer_log
