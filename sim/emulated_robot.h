// The stand-in robot's own electronics: servos that are switched on by command, a watchdog, and a
// body that is simulated with other masses, friction, backlash, sensors and ground than the nominal
// robot.  Where robot.yaml says that two motors turn two joints and that the driver speaks of the motors
// (`parallel_joints`), its electronics do: the packets have the motors' angles, speeds, torques and gains.
//
// Knows neither socket nor clock: the program (emulated_robot_main.cpp) calls cycle() once per
// period of its own.

#pragma once

#include <memory>

#include "bridge/adaptor/motor_space.h"
#include "bridge/adaptors/emulated_robot/protocol.h"
#include "robot/description/model.h"
#include "sim/scene/scene.h"
#include "sim/sim_adaptor.h"

namespace twinbus::inline sim {

struct EmulatedRobotOptions {
  double watchdog = 0.050;  // without a command for this long: hold the last set-point [s]
  double hold = 10.0;       // and after so long of that: damp [s]
  std::vector<std::pair<std::string, std::string>> settings;  // on top of those of differences()
};

class EmulatedRobot {
 public:
  // How the stand-in differs from the nominal robot: +3 % mass, friction, backlash, encoder noise
  // and counts, 2 ms delay, softer soles.
  static std::vector<std::pair<std::string, std::string>> differences();

  // Throws std::runtime_error when the scene and the robot do not fit.  The model must outlive
  // this.
  EmulatedRobot(const Model& model, Scene scene, const EmulatedRobotOptions& options);

  // A command that came over the wire, whole and undamaged; numbers are checked here.  now_ns: the
  // robot's clock. False: dropped (another robot, old, not finite).
  bool accept(const emulated::CommandPacket& packet, std::int64_t now_ns) noexcept;
  // One period: the watchdog, the motors, the body.  Fills what goes out.
  void cycle(std::int64_t now_ns, emulated::StatePacket& packet) noexcept;

  emulated::DeviceMode mode() const noexcept { return mode_; }
  const SimTruth* truth() const noexcept { return body_->truth(); }

 private:
  void watch(std::int64_t now_ns) noexcept;
  void damp_motors() noexcept;

  const Model* model_;
  EmulatedRobotOptions options_;
  std::unique_ptr<SimAdaptor> body_;
  emulated::DeviceMode mode_ = emulated::DeviceMode::kBraked;
  emulated::CommandPacket newest_;
  JointCommand command_;  // as the driver says it: of the motors where two of them turn two joints
  RobotState state_;
  MotorSpace motors_;
  std::vector<ParallelJoints> pairs_;
  JointCommand driven_;  // of the joints: what the body was given last
  std::int64_t commanded_ns_ = 0;
  std::uint64_t cycles_ = 0, dropped_ = 0;
};

}  // namespace twinbus::sim
