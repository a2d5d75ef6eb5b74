#include "control/guard/braking_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/math/index.h"
#include "common/simd/vec4.h"

namespace twinbus::inline control {

void spread_to_mimics(const Model& model, std::vector<Course>& courses) noexcept {
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[at(j)];
    if (joint.mimic < 0 || joint.mimic_multiplier == 0.0) continue;
    const Course& of = courses[at(joint.mimic)];
    const double m = joint.mimic_multiplier;
    courses[at(j)] = {m * of.first, m * of.speed, std::abs(m) * of.brake};
  }
}

// Where both brake alike, the faster one is ever farther ahead until both rest.
void apart(const std::vector<Course>& courses, const std::vector<Course>* other,
           Eigen::VectorXd& most) noexcept {
  for (std::size_t j = 0; j < courses.size(); ++j) {
    const Course& a = courses[j];
    const Course b = other != nullptr ? (*other)[j] : Course{0.0, 0.0, a.brake};
    const double by_a = a.rest() - a.first, by_b = b.rest() - b.first;
    most[static_cast<Eigen::Index>(j)] =
        std::abs(a.first - b.first) +
        (a.brake == b.brake ? std::abs(by_a - by_b) : std::abs(by_a) + std::abs(by_b));
  }
}

CourseWay::CourseWay(const std::vector<Course>& courses, double delay) noexcept
    : courses_(courses), delay_(delay) {
  for (const Course& c : courses) longest_ = std::max(longest_, std::abs(c.speed) / c.brake);
}

CourseWay::Instant CourseWay::instant(double share) const noexcept {
  const double braking = 0.5 * longest_;  // lasts as long at full speed
  const double gone = std::clamp(share, 0.0, 1.0) * (delay_ + braking);
  if (gone < delay_) return {gone / delay_, 0.0};
  const double of_braking = braking > 0.0 ? std::min(1.0, (gone - delay_) / braking) : 1.0;
  return {1.0, longest_ * (1.0 - std::sqrt(1.0 - of_braking))};
}

void CourseWay::go_on(double share, Eigen::VectorXd& q) const noexcept {
  const Instant now = instant(share);
  for (std::size_t j = 0; j < courses_.size(); ++j)
    q[static_cast<Eigen::Index>(j)] += courses_[j].at(now.of_delay, now.braked);
}

double CourseWay::brakes_at() const noexcept { return delay_ / (delay_ + 0.5 * longest_); }

CourseWay::Shares CourseWay::shares() const noexcept {
  Shares result{};
  for (std::size_t k = 1; k < result.size(); ++k)
    result[k] = std::lerp(brakes_at(), 1.0,
                          static_cast<double>(k - 1) / static_cast<double>(result.size() - 2));
  return result;
}

CourseWay::Shares CourseWay::between(double from, double to) noexcept {
  Shares result;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] =
        std::lerp(from, to, static_cast<double>(k) / static_cast<double>(result.size() - 1));
  return result;
}

namespace {

constexpr std::size_t kPlacesOnWay = SweptShapes::kPlaces;

struct Instants {  // of all places
  alignas(32) double of_delay[kPlacesOnWay], braked[kPlacesOnWay];
  alignas(32) double to_next[kPlacesOnWay];  // braked until the next one [s]
};

TWINBUS_INLINE Vec4 smaller(const Vec4& a, const Vec4& b) noexcept { return a < b ? a : b; }

// Before the brakes come a joint goes straight; braked it is off the straight way by b h^2 / 8 at most.
TWINBUS_AVX2_CLONES
void go_along(const Course& c, double here, const Instants& instants, double* q,
              float* bend) noexcept {
  const double stops = std::abs(c.speed) / c.brake, brake = std::copysign(0.5 * c.brake, c.speed);
  const Vec4 stop = Vec4{} + stops;
  Vec4 at[2], next[2];
  for (std::size_t half = 0; half < 2; ++half) {
    const Vec4 s = smaller(load4(instants.braked + 4 * half), stop);
    at[half] = here + (c.first * load4(instants.of_delay + 4 * half) + (c.speed - brake * s) * s);
    store4(q + 4 * half, at[half]);
  }
  next[0] = __builtin_shufflevector(at[0], at[1], 1, 2, 3, 4);
  next[1] = __builtin_shufflevector(at[1], at[1], 1, 2, 3, 3);
  for (std::size_t half = 0; half < 2; ++half) {
    const Vec4 h = load4(instants.to_next + 4 * half), step = next[half] - at[half];
    const Vec4 most = smaller(step < 0.0 ? -step : step, 0.125 * c.brake * h * h);
    for (std::size_t i = 0; i < 4; ++i) bend[4 * half + i] = static_cast<float>(most[i]);
  }
}

}  // namespace

void CourseWay::go(const Eigen::VectorXd& here, const Shares& shares,
                   SweptShapes::Way& way) const noexcept {
  Instants instants;
  for (std::size_t k = 0; k < kPlacesOnWay; ++k) {
    const Instant now = instant(shares[k]);
    instants.of_delay[k] = now.of_delay;
    instants.braked[k] = now.braked;
    instants.to_next[k] = 0.0;
    if (k > 0) instants.to_next[k - 1] = now.braked - instants.braked[k - 1];
  }
  for (std::size_t j = 0; j < courses_.size(); ++j) {
    if (way.asked[j] == 0) continue;
    const Course& c = courses_[j];
    const double from = here[static_cast<Eigen::Index>(j)];
    if (c.first == 0.0 && c.speed == 0.0) {
      way.q[j].fill(from);
      way.bend[j].fill(0.0F);
    } else {
      go_along(c, from, instants, way.q[j].data(), way.bend[j].data());
    }
  }
}

}  // namespace twinbus::control
