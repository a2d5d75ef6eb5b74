#include "control/walk/listed_steps.h"

#include <cmath>

#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
// As a foothold in the frame of the foot that stands.
Foothold step_at(const StepList& list, int i) noexcept {
  const auto k = static_cast<std::size_t>(i);
  Foothold step;
  step.position << static_cast<double>(list.x[k]), static_cast<double>(list.y[k]);
  step.set_yaw(static_cast<double>(list.yaw[k]));
  return step;
}

// Whether all of the other sole lies beyond the inner edge of `from`, with the least gap between two soles.
// out: to which side of it the other foot belongs.
bool lies_beside(const Gait& gait, const Foothold& from, const Foothold& other,
                 double out) noexcept {
  const double inner = gait.inner;
  for (const double x : {-gait.heel, gait.toe}) {
    const Eigen::Vector2d corner = other.position + other.turn({x, -out * inner});
    if (!(out * from.unturn(corner - from.position).y() >= gait.min_width - inner - 1e-6))
      return false;
  }
  return true;
}
}  // namespace

StepRefusal check_steps(const Gait& gait, const StepList& list) noexcept {
  if (!(list.count > 0 && list.count <= kMostSteps) || list.first_foot == FootSide::kNone)
    return {0, "the list of footsteps is empty; the robot stays where it is"};
  const Foothold standing;
  for (int i = 0; i < list.count; ++i) {
    const int moves = i % 2 == 0 ? first_foot(list) : 1 - first_foot(list);
    const double out = side_of(moves);
    const Foothold step = step_at(list, i);
    if (!(std::abs(step.yaw()) <= gait.max_turn))
      return {i, "a listed footstep turns farther than the hips do; the robot stays where it is"};
    if (!(lies_beside(gait, standing, step, out) || lies_beside(gait, step, standing, -out)))
      return {i,
              "a listed footstep puts one sole on the other or too near it; the robot stays where "
              "it is"};
    if (!gait.reaches(standing, 1 - moves, step))
      return {i, "a listed footstep is farther than the legs reach; the robot stays where it is"};
  }
  return {};
}

int place_steps(const StepList& list, const std::array<Foothold, 2>& feet,
                std::array<Foothold, kMostSteps>& places) noexcept {
  Foothold from = feet[static_cast<std::size_t>(1 - first_foot(list))];
  for (int i = 0; i < list.count; ++i) {
    const Foothold step = step_at(list, i);
    from.position += from.turn(step.position);
    from.set_yaw(wrap_angle(from.yaw() + step.yaw()));
    places[static_cast<std::size_t>(i)] = from;
  }
  return list.count;
}

}  // namespace twinbus::control
