#include "bridge/source/fall_watch.h"

#include <cmath>
#include <cstdio>

#include "lcmtypes/msg/labels.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus {

namespace {
constexpr double kUpright = 0.9394;    // cosine of 0.35 rad: from there on it is not as it stands
constexpr double kFallen = 0.7648;     // of 0.7 rad, as for the controller
constexpr double kStill = 0.2;         // [rad/s]
constexpr double kQuiet = 0.4;         // [s]; the controller, which braces the robot, is to see it first
constexpr double kLongest = 3.5;       // [s]
constexpr double kRecent = 3.0;        // a change of mode led to a fall so long after it [s]
constexpr double kLongSilence = 0.04;  // [s]
}  // namespace

FallWatch::FallWatch(const Model& model)
    : watches_(model.floating_base), period_(model.period()), up_(Eigen::Vector3d::UnitZ()) {
  if (!watches_) return;
  Kinematics kinematics(model);
  kinematics.update(Configuration(model));
  const Eigen::Matrix3d imu = kinematics.link_in_world(model.imu_link).linear() * model.imu.linear();
  up_ = imu.row(2).transpose();
}

bool FallWatch::look(const RobotState& state, const FallContext& context) noexcept {
  if (!watches_ || (state.sensor_flags & kImuValid) == 0) return false;
  const auto& a = state.attitude;
  const double w = static_cast<double>(a[0]), x = static_cast<double>(a[1]), y = static_cast<double>(a[2]),
               z = static_cast<double>(a[3]);
  const double cosine =
      up_.dot(Eigen::Vector3d(2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)));
  if (cosine > kUpright) {
    upright_ = true;
    tilts_ = false;
    lies_ = quiet_ = 0.0;
    return false;
  }
  if (!upright_) return false;
  if (!tilts_) context_ = context;
  tilts_ = true;
  if (!(cosine < kFallen)) return false;
  lies_ += period_;
  double rate = 0.0;
  for (const float g : state.gyro) rate += static_cast<double>(g) * static_cast<double>(g);
  quiet_ = rate < kStill * kStill ? quiet_ + period_ : 0.0;
  if (quiet_ < kQuiet && lies_ < kLongest) return false;
  upright_ = tilts_ = false;
  lies_ = quiet_ = 0.0;
  return true;
}

std::array<char, 200> FallWatch::cause() const noexcept {
  std::array<char, 200> text{};
  const FallContext& c = context_;
  const auto say = [&](const char* format, auto... values) {
    std::snprintf(text.data(), text.size(), format, values...);
  };
  if (c.slept > kLongSilence) {
    say("the robot has fallen: the source had no time on its processor for %.0f ms", 1e3 * c.slept);
  } else if (c.plan_runs || (c.silent > kLongSilence && c.stop == StopKind::kNone)) {
    say("the robot has fallen: no command came for %.0f ms%s", 1e3 * c.silent,
        c.plan_runs ? ", it followed its stop plan" : "");
  } else if (c.stop != StopKind::kNone) {
    say("the robot has fallen: after stop '%s' by %s", label(c.stop), label(c.reason));
  } else if (c.mode == Mode::kNone) {
    say("%s", "the robot has fallen: its controller does not say what it does");
  } else if (c.mode_age < kRecent) {
    say("the robot has fallen: %.1f s after it went into mode %s", c.mode_age, label(c.mode));
  } else {
    say("the robot has fallen: in mode %s, by a push or by what it stands on", label(c.mode));
  }
  return text;
}

}  // namespace twinbus
