#include "planner/lift.h"

#include <algorithm>
#include <array>

#include "common/math/index.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "planner/search/edge_check.h"
#include "planner/timing/rounded_path.h"
#include "robot/kinematics/inverse_kinematics.h"

namespace twinbus::inline planner {

namespace {

constexpr double kNear = 0.002;     // other pairs stay farther apart [m]
constexpr double kLets = 0.0005;    // what rests may come nearer by this: it gives way under the weight [m]
constexpr double kHigh = 0.04;      // taken off, or a share of it where the arm cannot, or comes near itself [m]
constexpr double kRoom = GuardDefaults::kAtGoal;  // of all, where it was taken off, if there is such a place [m]
constexpr int kSteps = 8;
constexpr double kTolerance = 2e-4;  // [m], [rad]
constexpr double kEvery = 0.004;     // of a motion [s]
constexpr int kPairs = 32;
constexpr int kMostLiftKnots = 60;
constexpr double kRound = 0.1;  // [rad]

// The motion is looked at as a whole.
class Open : public FreeSpace {
 public:
  bool point_free(const JointPoint&) override { return true; }
  bool line_free(const JointPoint&, const JointPoint&) override { return true; }
};

}  // namespace

Lift::Lift(const Model& model, Collision& collision, EdgeCheck& space)
    : model_(model), collision_(collision), space_(space) {}

bool Lift::rests(const PairDistance& pair) const {
  const int links = model_.link_count();
  const auto held = [&](int index) { return index >= links && collision_.carrier(index) == holder_; };
  const auto standing = [&](int index) { return index >= links && collision_.carrier(index) < 0; };
  return (held(pair.link_a) && standing(pair.link_b)) || (held(pair.link_b) && standing(pair.link_a));
}

bool Lift::find(const Hand& hand, const JointPoint& start, JointPath& way) {
  way.clear();
  holder_ = hand.link;
  std::array<PairDistance, kPairs> pairs;
  const Kinematics& kinematics = space_.kinematics_at(start);
  const int count = collision_.near_pairs(kinematics, kNear, pairs.data(), kPairs);
  Eigen::Vector3d away = Eigen::Vector3d::Zero();
  nearest_ = kNear;
  for (int i = 0; i < count; ++i) {
    const PairDistance& pair = pairs[at(i)];
    if (!rests(pair)) return false;
    away += collision_.carrier(pair.link_b) == holder_ ? pair.normal : Eigen::Vector3d(-pair.normal);
    nearest_ = std::min(nearest_, pair.distance);
  }
  if (!(away.norm() > 0.1)) return false;
  const int base = model_.joints[at(space_.joints().front())].parent;
  const Eigen::Vector3d in_base = kinematics.link_in_world(base).linear().transpose() * away.normalized();
  InverseKinematics arm(model_, base, hand.link, hand.frame);
  IkOptions options;
  options.position_tolerance = options.rotation_tolerance = kTolerance;
  const auto taken_off = [&](double high) {
    Eigen::VectorXd q = space_.posture().q;
    Eigen::Isometry3d target = arm.pose(q);
    way.assign(1, start);
    for (int step = 1; step <= kSteps; ++step) {
      target.pretranslate(high / kSteps * in_base);
      if (!arm.solve(target, options, q).reached) return false;
      JointPoint next = start;
      for (int k = 0; k < next.size(); ++k) next[k] = q[space_.joints()[at(k)]];
      way.push_back(next);
    }
    return true;
  };
  JointPath first;
  for (const double high : {kHigh, 0.75 * kHigh, 0.5 * kHigh, 0.25 * kHigh}) {
    if (!taken_off(high)) continue;
    if (first.empty()) first = way;
    if (space_.nearest(way.back(), kRoom) >= kRoom) return true;
  }
  way = first;
  return !way.empty();
}

TimedPath Lift::timed(const JointPath& way, const TimingLimits& limits, double knot_spacing) {
  Open open;
  TimedPath path = time_path(RoundedPath::parts(open, way, kRound), limits, knot_spacing, kMostLiftKnots);
  std::array<PairDistance, kPairs> pairs;
  JointPoint q, qd, qdd;
  for (double t = 0.0; !path.empty() && t <= path.back().time + kEvery; t += kEvery) {
    sample(path, t, q, qd, qdd);
    const int count = collision_.near_pairs(space_.kinematics_at(q), kNear, pairs.data(), kPairs);
    for (int i = 0; i < count; ++i) {
      if (!rests(pairs[at(i)]) || pairs[at(i)].distance < nearest_ - kLets) return {};
    }
  }
  return path;
}

}  // namespace twinbus::planner
