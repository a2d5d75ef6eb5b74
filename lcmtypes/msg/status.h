// What a call that may meet a misbehaving world returns instead of throwing.

#pragma once

#include <cstdint>

namespace twinbus::inline lcmtypes {

enum class [[nodiscard]] Status : std::int8_t{
    kOk = 0,
    kTimeout = 1,      // the device did not answer in time
    kDeviceError = 2,  // the device answered with an error
    kNotFinite = 3,    // a number is NaN or infinite
    kOutOfRange = 4,   // a number is outside what the robot can do
    kWrongSize = 5,    // joint count differs from the model's
    kWrongModel = 6,   // model hash differs
    kNotOpen = 7,
    kUnsupported = 8,  // this adaptor cannot do that
    kDiverged = 9,     // the simulation left the range of sane numbers
};

constexpr const char* to_text(Status status) {
  switch (status) {
    case Status::kOk:
      return "ok";
    case Status::kTimeout:
      return "timeout";
    case Status::kDeviceError:
      return "device error";
    case Status::kNotFinite:
      return "not finite";
    case Status::kOutOfRange:
      return "out of range";
    case Status::kWrongSize:
      return "wrong joint count";
    case Status::kWrongModel:
      return "wrong model";
    case Status::kNotOpen:
      return "not open";
    case Status::kUnsupported:
      return "unsupported";
    case Status::kDiverged:
      return "diverged";
  }
  return "unknown";
}

}  // namespace twinbus::lcmtypes
