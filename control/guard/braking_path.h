// The way on which all joints come to rest (control/set_point_track), by a share from 0, here, to 1, at
// rest: evenly along what a joint moves that is as fast as the fastest until its brake comes and then is
// braked evenly.

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "control/guard/set_point_predictor.h"
#include "robot/collision/continuous.h"

namespace twinbus::inline control {

// Gives mimic joints the courses of the joints they follow.
void spread_to_mimics(const Model& model, std::vector<Course>& courses) noexcept;

// The most that joints are apart at the same place of these two ways, and of the way from staying here
// if `other` is null [joint_count].
void apart(const std::vector<Course>& courses, const std::vector<Course>* other,
           Eigen::VectorXd& most) noexcept;

class CourseWay {
 public:
  // courses: of all joints; they must outlive this, and `delay` [s] passes until their brakes come.
  CourseWay(const std::vector<Course>& courses, double delay) noexcept;

  // Places as shares of the way.
  using Shares = std::array<double, SweptShapes::kPlaces>;
  Shares shares() const noexcept;  // here, where the brakes come, then evenly to rest
  static Shares between(double from, double to) noexcept;  // evenly

  // q: of here going in, of the place out [joint_count].
  void go_on(double share, Eigen::VectorXd& q) const noexcept;
  // Where the brakes come.
  double brakes_at() const noexcept;
  // The places from here, of the joints that way.asked says; no two next to each other on both sides of brakes_at().
  void go(const Eigen::VectorXd& here, const Shares& shares, SweptShapes::Way& way) const noexcept;

 private:
  struct Instant {
    double of_delay, braked;  // shares of the delay; since the brake came [s]
  };
  Instant instant(double share) const noexcept;

  const std::vector<Course>& courses_;
  double delay_;          // [s]
  double longest_ = 0.0;  // brake [s]
};

}  // namespace twinbus::control
