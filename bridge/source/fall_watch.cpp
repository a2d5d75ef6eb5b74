#include "bridge/source/fall_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lcmtypes/msg/labels.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline bridge {

namespace {
constexpr double kUpright = 0.9394;    // cosine of 0.35 rad: from there on it is not as it stands
constexpr double kFallen = 0.7648;     // of 0.7 rad, as for the controller
constexpr double kStill = 0.2;         // [rad/s]
constexpr double kQuiet = 0.4;         // [s]; the controller, which braces the robot, is to see it first
constexpr double kLongest = 3.5;       // [s]
constexpr double kRecent = 3.0;        // a change of mode led to a fall so long after it [s]
constexpr double kLongSleep = 0.04;    // [s]
constexpr double kLongSilence = 0.21;  // of a controller, which goes on after a shorter one: kResumesWithin of the gate [s]
constexpr double kShortSilence = 0.04;  // [s]
constexpr double kFelt = 0.05;         // a push that moves the capture point by 15 mm, 0.8 m above the ground [m/s]
}  // namespace

FallWatch::FallWatch(const Model& model)
    : watches_(model.floating_base), period_(model.period()), up_(Eigen::Vector3d::UnitZ()), mass_(model.total_mass()) {
  if (!watches_) return;
  Kinematics kinematics(model);
  kinematics.update(Configuration(model));
  const Eigen::Matrix3d imu = kinematics.link_in_world(model.imu_link).linear() * model.imu.linear();
  up_ = imu.row(2).transpose();
}

void FallWatch::see_push(const SimTruth* truth) noexcept {
  push_.age += period_;
  if (truth == nullptr) return;
  const auto& f = truth->push_force;
  const double force = std::hypot(static_cast<double>(f[0]), static_cast<double>(f[1]), static_cast<double>(f[2]));
  if (!(force > 0.0)) return;
  if (push_.age > 1.5 * period_) push_ = {};  // another one
  push_.force = std::max(push_.force, force);
  push_.impulse += force * period_;
  push_.age = 0.0;
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
  if (!tilts_) {
    context_ = context;
    led_ = push_;
  }
  tilts_ = true;
  if (!(cosine < kFallen)) return false;
  lies_ += period_;
  double rate = 0.0;
  for (const float g : state.gyro) rate += static_cast<double>(g) * static_cast<double>(g);
  quiet_ = rate < kStill * kStill ? quiet_ + period_ : 0.0;
  // Nobody catches it or braces it: a stiff robot would only hit harder.
  const bool alone = context.stop == StopKind::kHold || context.plan_runs;
  if (!alone && quiet_ < kQuiet && lies_ < kLongest) return false;
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
  // A push comes first: that commands are late or a stop follows may be its consequence.
  const bool pushed = led_.age < kRecent && led_.impulse > kFelt * mass_;
  if (pushed && c.stop != StopKind::kOff) {
    std::array<char, 80> more{};
    if (c.stop != StopKind::kNone) {
      std::snprintf(more.data(), more.size(), ", in stop '%s' by %s", label(c.stop), label(c.reason));
    } else if (c.plan_runs || c.silent > kShortSilence) {
      std::snprintf(more.data(), more.size(), "; no command came for %.0f ms%s", 1e3 * c.silent,
                    c.plan_runs ? ", it followed its stop plan" : "");
    } else if (c.slept > kLongSleep) {
      std::snprintf(more.data(), more.size(), "; the source had no time on its processor for %.0f ms", 1e3 * c.slept);
    }
    say("the robot has fallen: it was pushed with %.0f N, until %.1f s before it tilted%s", led_.force, led_.age, more.data());
  } else if (c.slept > kLongSleep) {
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
    std::array<char, 60> more{};
    if (c.silent > kShortSilence)
      std::snprintf(more.data(), more.size(), "; no command came for %.0f ms", 1e3 * c.silent);
    say("the robot has fallen: in mode %s, by a push or by what it stands on%s", label(c.mode), more.data());
  }
  return text;
}

}  // namespace twinbus::bridge
