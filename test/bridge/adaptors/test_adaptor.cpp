// Adaptors for adaptor_host_test: TWINBUS_TEST_KIND says what is wrong with this one.

#include <stdexcept>

#include "bridge/adaptor/adaptor_abi.h"
#include "test/bridge/small_robot.h"

namespace {

class Robot : public twinbus::test::PointRobot {
 public:
  Robot() {
    q = 0.25;
#if TWINBUS_TEST_KIND == 7
    throw std::runtime_error("no such device");
#endif
  }
};

}  // namespace

#if TWINBUS_TEST_KIND == 0 || TWINBUS_TEST_KIND == 7
TWINBUS_ADAPTOR(Robot)
#elif TWINBUS_TEST_KIND == 1
extern "C" int something_else() { return 1; }
#else
extern "C" const TwinbusAdaptorAbi* twinbus_adaptor_abi() {
  static TwinbusAdaptorAbi abi = {twinbus::kAdaptorMagic,
                                  twinbus::kAdaptorVersion,
                                  sizeof(twinbus::RobotState),
                                  sizeof(twinbus::JointCommand),
                                  sizeof(twinbus::Model),
                                  sizeof(twinbus::AdaptorConfig),
                                  sizeof(twinbus::ImposedState),
                                  []() -> twinbus::RobotAdaptor* { return nullptr; },
                                  [](twinbus::RobotAdaptor* robot) { delete robot; }};
#if TWINBUS_TEST_KIND == 2
  abi.magic += 1;
#elif TWINBUS_TEST_KIND == 3
  abi.version += 1;
#elif TWINBUS_TEST_KIND == 4
  abi.state_size += 8;
#elif TWINBUS_TEST_KIND == 5
  abi.model_size += 8;
#endif
  return &abi;
}
#endif
