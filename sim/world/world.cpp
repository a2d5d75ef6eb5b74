#include "sim/world/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>


namespace twinbus::inline sim {

namespace {

constexpr double kMaxTarget = 1e9;  // of any number of a servo target

// 0 x is not 0 if x is infinite or no number; unlike allFinite() this takes several at a time.
bool all_finite(const Eigen::VectorXd& v) { return (0.0 * v).sum() == 0.0; }

bool within(const Eigen::Vector3d& v, double bound) { return v.cwiseAbs().maxCoeff() <= bound; }

template <typename Choice, std::size_t kCount>
bool named(const std::string& name, const char* const (&names)[kCount], Choice& choice) {
  for (std::size_t i = 0; i < kCount; ++i) {
    if (name != names[i]) continue;
    choice = static_cast<Choice>(i);
    return true;
  }
  return false;
}

}  // namespace

bool engine_of(const std::string& name, Engine& engine) {
  return named(name, kEngineNames, engine);
}

bool contact_of(const std::string& name, ContactModel& contact) {
  return named(name, kContactNames, contact);
}

Status check_target(const ServoTarget& t) noexcept {
  const std::array<double, 5> numbers{t.q, t.qd, t.tau, t.kp, t.kd};
  bool good = true;
  for (const double number : numbers) good &= std::abs(number) <= kMaxTarget;
  if (!good) {
    const bool finite = std::all_of(numbers.begin(), numbers.end(),
                                    [](double number) { return std::isfinite(number); });
    return finite ? Status::kOutOfRange : Status::kNotFinite;
  }
  return t.kp >= 0.0 && t.kd >= 0.0 ? Status::kOk : Status::kOutOfRange;
}

Status check_configuration(std::size_t count, const Configuration& to) noexcept {
  const auto joints = static_cast<Eigen::Index>(count);
  if (to.q.size() != joints || to.qd.size() != joints) return Status::kWrongSize;
  if (!all_finite(to.q) || !all_finite(to.qd) || !to.base.matrix().allFinite() ||
      !to.base_velocity.allFinite() || !to.base_angular_velocity.allFinite()) {
    return Status::kNotFinite;
  }
  if (!(joints == 0 || to.qd.cwiseAbs().maxCoeff() <= kMaxSpeed) ||
      !within(to.base_velocity, kMaxSpeed) || !within(to.base_angular_velocity, kMaxSpeed) ||
      !within(to.base.translation(), kMaxDistance)) {
    return Status::kOutOfRange;
  }
  return Status::kOk;
}

Status check_loose(const LooseState& to) noexcept {
  if (!to.pose.matrix().allFinite() || !to.velocity.allFinite() || !to.angular_velocity.allFinite())
    return Status::kNotFinite;
  if (!within(to.velocity, kMaxSpeed) || !within(to.angular_velocity, kMaxSpeed) ||
      !within(to.pose.translation(), kMaxDistance)) {
    return Status::kOutOfRange;
  }
  return Status::kOk;
}

Eigen::Vector3d sole_corner(const Sole& sole, int corner) noexcept {
  return {corner < 2 ? sole.front : -sole.back, corner % 2 == 0 ? sole.left : -sole.right, 0.0};
}

void check_links(const Model& model, bool fixed_base) {
  for (std::size_t i = fixed_base ? 1 : 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    if (link.mass > 0.0 && link.inertia.llt().info() == Eigen::Success) continue;
    throw std::runtime_error(
        "link '" + link.name +
        "' cannot be simulated: its mass and inertia must be positive; give it an <inertial>");
  }
}

}  // namespace twinbus::sim
