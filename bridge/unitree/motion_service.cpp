#include "bridge/unitree/motion_service.h"

namespace twinbus::inline bridge {

ServiceAnswer motion_service(std::int64_t api_id, std::string_view) noexcept {
  constexpr std::int32_t kNotImplemented = 3203;  // of the vendor's server: it has no such call
  constexpr std::int32_t kRefused = 7004;         // of the motion service: it cannot change to that mode
  struct Call {
    std::int64_t api_id;
    std::int32_t code;
    const char* data;
  };
  constexpr Call kCalls[] = {{1, 0, "1.0.0.1"},                         // version
                             {1001, 0, R"({"form":"0","name":""})"},    // which mode: none, it is released
                             {1002, kRefused, ""},                      // select a mode
                             {1003, 0, ""},                             // release the mode
                             {1004, 0, ""},                             // silent or not
                             {1005, 0, R"({"silent":false})"}};         // is it silent
  for (const Call& call : kCalls) {
    if (call.api_id == api_id) return {call.code, call.data};
  }
  return {kNotImplemented, ""};
}

}  // namespace twinbus::bridge
