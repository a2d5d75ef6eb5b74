// An encoded message as JSON, and the JSON schema of its type, for tools that read JSON.
//
// Arrays stay arrays; of the rows of a two-dimensional one each is an array of its own (wrench_0, wrench_1), because plot
// tools take no array of arrays.  Per-joint arrays end with the last joint; text is text; what is not finite is null.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "viewer_log/message_schema.h"

namespace twinbus {

class MessageJson {
 public:
  explicit MessageJson(const MessageSchema& schema);

  const std::string& json_schema() const { return json_schema_; }
  // message has the size of the schema.
  void append(std::string& out, std::span<const std::uint8_t> message) const;

 private:
  struct Member {
    std::string key;                   // "q":  with its quotes and colon
    std::size_t first = 0, count = 0;  // fields of the schema
    bool array = false, text = false, per_joint = false;
  };
  const MessageSchema* schema_;
  int joint_count_ = -1;  // the field that says how many joints there are
  std::vector<Member> members_;
  std::string json_schema_;
};

}  // namespace twinbus
