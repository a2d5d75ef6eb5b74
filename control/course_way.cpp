#include "control/course_way.h"

#include <algorithm>
#include <cmath>

#include "robot/index.h"

namespace twinbus {

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

// Before the brakes come joints go straight; braked they are off the straight way by b h^2 / 8 at most.
void CourseWay::go(const Eigen::VectorXd& here, const Shares& shares,
                   SweptShapes::Way& way) const noexcept {
  std::array<Instant, SweptShapes::kPlaces> instants;
  for (std::size_t k = 0; k < shares.size(); ++k) instants[k] = instant(shares[k]);
  for (std::size_t j = 0; j < courses_.size(); ++j) {
    if (way.asked[j] == 0) continue;
    const Course& c = courses_[j];
    auto& q = way.q[j];
    auto& bend = way.bend[j];
    q.fill(here[static_cast<Eigen::Index>(j)]);
    bend.fill(0.0F);
    if (c.first == 0.0 && c.speed == 0.0) continue;
    const double stops = std::abs(c.speed) / c.brake, brake = std::copysign(0.5 * c.brake, c.speed);
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const double s = std::min(instants[k].braked, stops);
      q[k] += c.first * instants[k].of_delay + (c.speed - brake * s) * s;
    }
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
      const double h = instants[k + 1].braked - instants[k].braked;
      bend[k] = static_cast<float>(std::min(std::abs(q[k + 1] - q[k]), 0.125 * c.brake * h * h));
    }
  }
}

}  // namespace twinbus
