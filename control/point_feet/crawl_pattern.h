// Where the weight of a crawling robot is: reference of zero-moment point and centre of mass, and where feet come down.
//
// A point c goes at the asked velocity, and every foot comes down where it stands best about that point half a stance later.  While a
// foot is in the air the zero-moment point p is within the triangle of the other three: at the point nearest to c that is a share of
// the radius of the circle in the triangle away from its sides.  In a shift it goes straight to the next triangle.  The centre of mass
// follows the pendulum without ever running away (capture point xi, Takenaka et al., IROS 2009):
//
//     xi = integral over s >= 0 of omega exp(-omega s) p(t + s) ds,     x' = omega (xi - x),     x'' = omega^2 (x - p)
//
// p is planned four steps ahead anew every tick; farther ahead it stays, which is exp(-10) of it.  World, seen from above.

#pragma once

#include <Eigen/Core>
#include <array>

#include "control/point_feet/point_feet_body.h"
#include "control/point_feet/step_gait.h"

namespace twinbus::inline control {

using FourPoints = std::array<Eigen::Vector2d, 4>;

class CrawlPattern {
 public:
  explicit CrawlPattern(const PointFeetBody& body) noexcept;

  // Begins with the weight where it is; middle: home of the centre of mass above its feet.
  void start(const Eigen::Vector2d& com, const Eigen::Vector2d& middle) noexcept;
  // feet: where they stand, or left the ground; velocity: asked for, world; yaw and its rate; the gait has been advanced.
  void update(const StepGait& gait, const FourPoints& feet, const Eigen::Vector2d& velocity, double yaw, double yaw_rate,
              double dt) noexcept;
  // The robot is elsewhere by that much.
  void move(const Eigen::Vector2d& way) noexcept;

  const Eigen::Vector2d& foothold(int leg) const noexcept { return foothold_[static_cast<std::size_t>(leg)]; }
  const Eigen::Vector2d& position() const noexcept { return position_; }  // of the centre of mass
  const Eigen::Vector2d& velocity() const noexcept { return velocity_; }
  const Eigen::Vector2d& acceleration() const noexcept { return acceleration_; }
  const Eigen::Vector2d& middle() const noexcept { return middle_; }  // c

  // Whether the foot whose turn it is may leave the ground: centre of mass and capture point are above the others.
  bool may_lift(const StepGait& gait, const FourPoints& feet, const Eigen::Vector2d& com,
                const Eigen::Vector2d& capture) const noexcept;

 private:
  FourPoints stance_;
  double keep_;  // distance from a side that the zero-moment point keeps [m]
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero(), zmp_ = Eigen::Vector2d::Zero(), position_ = Eigen::Vector2d::Zero(),
                  velocity_ = Eigen::Vector2d::Zero(), acceleration_ = Eigen::Vector2d::Zero();
  FourPoints foothold_;
};

// How far a point is inside the triangle of the other three of four feet, < 0 outside [m].
double inside_others(const FourPoints& feet, int lifted, const Eigen::Vector2d& point) noexcept;
// Near a point, and so far inside, or as far as the triangle has room.
Eigen::Vector2d nearest_inside(const FourPoints& feet, int lifted, const Eigen::Vector2d& point, double keep) noexcept;

}  // namespace twinbus::control
