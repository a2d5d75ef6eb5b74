#include "control/walk/step_adjust.h"

#include <algorithm>
#include <cmath>

#include "control/walk/swing_foot.h"

namespace twinbus::inline control {

namespace {
constexpr int kLonger = 1, kShorter = 13;  // durations tried beside the present one
constexpr double kApart = 0.02;            // between them [s]
constexpr double kMissed = 100.0;          // cost of what is beyond reach [1/m^2]
constexpr double kHaste = 0.02;            // of another duration [1/s^2]
constexpr double kInward = 8.0;            // acceleration with which a foot comes nearer to the one that stands [m/s^2]
constexpr double kEarly = SwingGains{}.early;  // before touchdown, when it is over its place [s]
constexpr double kRestToRest = 5.77;       // of a minimum-jerk way: its largest acceleration times the time squared
constexpr double kRunsOn = 0.4;            // of its speed times the time a foot still moves when it comes to rest
}  // namespace

StepAdjusted adjust_step(const Gait& gait, const StepNow& now, double omega) noexcept {
  const Foothold& support = now.support;
  const Eigen::Vector2d xi = support.unturn(now.dcm - support.position);
  const Eigen::Vector2d offset = support.unturn(now.offset);
  const Eigen::Vector2d planned = support.unturn(now.planned.position - support.position);
  const double side = side_of(1 - now.foot);
  const Eigen::Vector2d at = support.unturn(now.moves.position - support.position), rate = support.unturn(now.velocity);
  Eigen::Vector2d reach_low(-gait.max_back, side > 0.0 ? gait.min_width : -gait.max_width);
  Eigen::Vector2d reach_high(gait.max_forward, side > 0.0 ? gait.max_width : -gait.min_width);
  const Eigen::Vector2d middle = 0.5 * (gait.sole_low + gait.sole_high);
  Eigen::Vector2d low = middle + gait.ankle_share * (gait.sole_low - middle);
  Eigen::Vector2d high = middle + gait.ankle_share * (gait.sole_high - middle);
  if (gait.leans) low.y() = high.y() = -side_of(now.foot) * gait.zmp_inward;

  double best = 1e300, best_left = now.left_now;
  Eigen::Vector2d best_place = planned, best_regular = planned;
  for (int k = -kLonger; k <= kShorter; ++k) {
    const double left = std::min(now.left_planned, now.left_now - kApart * k);
    if (k != 0 && left < now.shortest) continue;
    const double late = left - now.left_planned, haste = kHaste * late * late;
    if (!(haste < best)) continue;  // whatever place it would reach
    // A foot that is thrown inward cannot be braked before it meets the other one.
    const double moves = std::max(0.0, left - kEarly);
    const double inner = side * at.y() + kRunsOn * std::min(0.0, side * rate.y()) * left - kInward / kRestToRest * moves * moves;
    (side > 0.0 ? reach_low : reach_high).y() = side * std::clamp(inner, gait.min_width, gait.max_width);
    const double grown = std::exp(omega * left);
    // Farther than the hips throw a foot in that time it does not come; the step as it is now remains.
    const Eigen::Vector2d rests = at + kRunsOn * left * rate, room = gait.swing_acceleration * (moves * moves / kRestToRest);
    Eigen::Vector2d thrown_low = rests - room, thrown_high = rests + room;
    if (k <= 0) {
      thrown_low = thrown_low.cwiseMin(planned);
      thrown_high = thrown_high.cwiseMax(planned);
    }
    Eigen::Vector2d place, missed;
    Eigen::Vector2d regular = planned;
    if (gait.leans) regular.x() *= std::min(1.0, (now.elapsed + left) / gait.period());  // other times, the same speed
    for (Eigen::Index d = 0; d < 2; ++d) {
      const double from = high[d] + (xi[d] - high[d]) * grown - offset[d];
      const double to = low[d] + (xi[d] - low[d]) * grown - offset[d];
      const double wanted = std::min(std::max(regular[d], from), to);
      place[d] = std::min(std::max(wanted, std::max(reach_low[d], thrown_low[d])), std::min(reach_high[d], thrown_high[d]));
      missed[d] = wanted - place[d];
    }
    const double cost = kMissed * missed.squaredNorm() + (place - regular).squaredNorm() + haste;
    if (cost < best) {
      best = cost;
      best_place = place;
      best_regular = regular;
      best_left = left;
    }
  }
  StepAdjusted result;
  result.foothold = now.planned;
  result.foothold.position = support.position + support.turn(best_place);
  if (best_place != planned) result.foothold = kept_apart(gait, support, now.foot, result.foothold);
  result.left = best_left;
  result.moved = (best_place - best_regular).norm();
  result.cost = best;
  return result;
}

}  // namespace twinbus::control
