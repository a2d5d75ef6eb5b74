// What a shared object exports to be an adaptor: one C function that tells version and sizes, and
// makes the object.
//
//   class MyRobot final : public RobotAdaptor { ... };
//   TWINBUS_ADAPTOR(MyRobot)                        // once, in the adaptor's .cpp
//
// The class itself crosses the border, so host and adaptor must be built from the same headers;
// that is what the sizes are for: an adaptor built from other headers is refused with a sentence
// instead of crashing.

#pragma once

#include <cstdint>

#include "bridge/adaptor/adaptor.h"

namespace twinbus::inline bridge {

inline constexpr std::uint32_t kAdaptorMagic = 0x54574142;  // "TWAB"
inline constexpr std::uint32_t kAdaptorVersion = 1;         // of RobotAdaptor's virtual functions

}  // namespace twinbus::bridge

extern "C" {

struct TwinbusAdaptorAbi {
  std::uint32_t magic;
  std::uint32_t version;
  std::uint32_t state_size;  // sizeof each struct that is passed [bytes]
  std::uint32_t command_size;
  std::uint32_t model_size;
  std::uint32_t config_size;
  std::uint32_t imposed_size;
  twinbus::RobotAdaptor* (*create)();  // null when it fails; never throws
  void (*destroy)(twinbus::RobotAdaptor*);
};

using TwinbusAdaptorAbiFunction = const TwinbusAdaptorAbi* (*)();
}

#define TWINBUS_ADAPTOR(Class)                                               \
  extern "C" __attribute__((visibility("default"))) const TwinbusAdaptorAbi* \
  twinbus_adaptor_abi() {                                                    \
    static const TwinbusAdaptorAbi abi = {                                   \
        twinbus::kAdaptorMagic,                                              \
        twinbus::kAdaptorVersion,                                            \
        sizeof(twinbus::RobotState),                                         \
        sizeof(twinbus::JointCommand),                                       \
        sizeof(twinbus::Model),                                              \
        sizeof(twinbus::AdaptorConfig),                                      \
        sizeof(twinbus::ImposedState),                                       \
        []() -> twinbus::RobotAdaptor* {                                     \
          try {                                                              \
            return new Class();                                              \
          } catch (...) {                                                    \
            return nullptr;                                                  \
          }                                                                  \
        },                                                                   \
        [](twinbus::RobotAdaptor* adaptor) { delete adaptor; },              \
    };                                                                       \
    return &abi;                                                             \
  }
