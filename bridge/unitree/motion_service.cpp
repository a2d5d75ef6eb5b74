#include "bridge/unitree/motion_service.h"

namespace twinbus {

namespace {

enum Api : std::int64_t {
  kVersion = 1,
  kCheckMode = 1001,
  kSelectMode = 1002,
  kReleaseMode = 1003,
  kSetSilent = 1004,
  kGetSilent = 1005,
};
constexpr std::int32_t kNotImplemented = 3203;  // of the vendor's server: it has no such call
constexpr std::int32_t kRefused = 7004;         // of the motion service: it cannot change to that mode

}  // namespace

ServiceAnswer motion_service(std::int64_t api_id, std::string_view) noexcept {
  switch (api_id) {
    case kVersion:
      return {0, "1.0.0.1"};
    case kCheckMode:
      return {0, R"({"form":"0","name":""})"};
    case kSelectMode:
      return {kRefused, ""};
    case kReleaseMode:
    case kSetSilent:
      return {0, ""};
    case kGetSilent:
      return {0, R"({"silent":false})"};
    default:
      return {kNotImplemented, ""};
  }
}

}  // namespace twinbus
