#include "control/loop/control_report.h"

#include <Eigen/Geometry>
#include <array>

namespace twinbus::inline control {

namespace {
template <std::size_t N>
std::array<float, N> to_floats(const Eigen::Matrix<double, static_cast<int>(N), 1>& v) noexcept {
  std::array<float, N> out{};
  for (std::size_t i = 0; i < N; ++i) out[i] = static_cast<float>(v[static_cast<Eigen::Index>(i)]);
  return out;
}
}  // namespace

void report_tick(const Modes& modes, const Moment& now, ControllerStatus& s) noexcept {
  const RobotState& state = now.state;
  const Estimator& estimator = now.estimator;
  const Behavior* behavior = modes.behavior();
  s.tick = state.tick;
  s.run_id = state.run_id;
  s.arm_path_id = modes.arm().path_id();
  s.term = state.term;
  s.mode = modes.mode();
  s.motion = behavior != nullptr ? behavior->motion() : Motion::kNone;
  if (modes.plays()) s.motion = Motion::kPlayed;
  s.stopping = state.stop_kind;
  s.arm_state = static_cast<std::int8_t>(modes.arm().state());
  const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
  const Eigen::Vector3d zmp = world_in_ground * estimator.zmp();
  if (behavior != nullptr) {
    const BehaviorReport report = behavior->report(estimator);
    s.com = to_floats<3>(report.com);
    s.com_velocity = to_floats<3>(report.com_velocity);
    s.com_reference = to_floats<3>(report.com_reference);
    s.dcm = to_floats<2>(report.dcm);
    s.zmp_reference = to_floats<2>(report.zmp_reference);
  } else {
    s.com = to_floats<3>(world_in_ground * estimator.kinematics().com());
    s.com_velocity = to_floats<3>(world_in_ground.linear() * estimator.com_velocity());
    s.com_reference = s.com;
    s.dcm = {s.com[0], s.com[1]};
    s.zmp_reference = to_floats<2>(zmp.head<2>());
  }
  s.zmp = to_floats<2>(zmp.head<2>());
  s.zmp_margin = static_cast<float>(estimator.support_margin(estimator.zmp()));
  const Configuration& c = estimator.configuration();
  const Eigen::Quaterniond attitude(c.base.linear());
  s.base_position = to_floats<3>(c.base.translation());
  s.base_attitude = {static_cast<float>(attitude.w()), static_cast<float>(attitude.x()),
                     static_cast<float>(attitude.y()), static_cast<float>(attitude.z())};
  s.base_velocity = to_floats<3>(c.base_velocity);
}

}  // namespace twinbus::control
