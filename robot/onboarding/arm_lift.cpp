// A posture for arms on a fixed base that lie in the ground when their joints are at zero, are too heavy for them, or boxed in by the
// robot itself.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "robot/collision/collision.h"
#include "robot/collision/collision_pairs.h"
#include "robot/description/link_points.h"
#include "robot/dynamics/gravity_load.h"
#include "robot/kinematics/arm_span.h"
#include "robot/kinematics/kinematics.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus::inline robot {

namespace {

constexpr double kAbove = 0.02;      // the ground [m]
constexpr double kHolds = 0.8;       // of its effort limit that a joint may need to hold the arm
constexpr double kClear = GuardDefaults::kAtGoal;  // of itself [m]
constexpr int kFarApart = 4;         // joints between links that no design keeps near each other
constexpr int kNearPairs = 64;
constexpr double kTurnStep = 0.1;    // [rad]
constexpr double kMostTurned = 1.6;  // [rad]

// How high the links of one arm are.
class ArmHeight {
 public:
  ArmHeight(const Model& model, const Hand& hand) : c_(model), k_(model) {
    const int first = hand.joints.front() + 1;
    k_.update(c_);
    for (int link = first + (turns_in_place(k_, hand) ? 1 : 0); link < model.link_count(); ++link) {
      if (hangs_on(model, link, first)) links_.emplace_back(link, link_points(model.links[at(link)]));
    }
  }
  // The lowest point [m].
  double of(const Eigen::VectorXd& q) {
    c_.q = q;
    k_.update(c_);
    double low = 1e9;
    for (const auto& [link, points] : links_) {
      for (const Eigen::Vector3d& point : points) low = std::min(low, (k_.link_in_world(link) * point).z());
    }
    return low;
  }

 private:
  Configuration c_;
  Kinematics k_;
  std::vector<std::pair<int, std::vector<Eigen::Vector3d>>> links_;
};

// Whether links of the arm and of the robot that many joints lie between are near each other.
class BoxedIn {
 public:
  BoxedIn(const Model& model, const Hand& hand) : model_(model), collision_(model), c_(model), k_(model) {
    collision_.check_only_moved_by(hand.joints);
  }
  bool at_posture(const Eigen::VectorXd& q) {
    c_.q = q;
    k_.update(c_);
    std::array<PairDistance, kNearPairs> near;
    const int count = collision_.near_pairs(k_, kClear, near.data(), kNearPairs);
    return std::any_of(near.begin(), near.begin() + count, [&](const PairDistance& pair) {
      int between = 0;
      for (int joint = 0; joint < model_.joint_count(); ++joint)
        between += joint_moves_pair(model_, joint, pair.link_a, pair.link_b) ? 1 : 0;
      return between >= kFarApart;
    });
  }

 private:
  const Model& model_;
  Collision collision_;
  Configuration c_;
  Kinematics k_;
};

// False when a limit is in the way.
bool turn(const Model& model, int joint, double angle, Eigen::VectorXd& q) {
  q[joint] += angle;
  return q[joint] >= model.joints[at(joint)].lower && q[joint] <= model.joints[at(joint)].upper;
}

}  // namespace

std::string lift_arms(const Model& model, const Anatomy& anatomy, Eigen::VectorXd& q) {
  std::string said;
  for (const Hand& hand : anatomy.hands) {
    if (hand.link < 0 || hand.joints.empty()) continue;
    ArmHeight height(model, hand);
    GravityLoad load(model);
    Configuration c(model);
    BoxedIn boxed(model, hand);
    const auto good = [&](const Eigen::VectorXd& posture) {
      c.q = posture;
      return height.of(posture) >= kAbove && load.of(c, hand.joints).share <= kHolds && !boxed.at_posture(posture);
    };
    if (good(q)) continue;
    const auto lifts = [&](double angle, int joint, int other, double sign) {
      Eigen::VectorXd tried = q;
      if (!turn(model, joint, angle, tried) || (other >= 0 && !turn(model, other, sign * angle, tried))) return false;
      if (!good(tried)) return false;
      q = tried;
      said += (said.empty() ? "" : ", ") + model.joints[at(joint)].name +
              (other >= 0 ? " and " + model.joints[at(other)].name : "") + formatted(" by %.1f rad", std::abs(angle));
      return true;
    };
    bool done = false;
    for (const bool two : {false, true}) {
      for (int step = 1; !done && step * kTurnStep <= kMostTurned; ++step) {
        for (const int joint : hand.joints) {
          for (const double sign : {1.0, -1.0}) {
            if (!two) done = done || lifts(sign * step * kTurnStep, joint, -1, 0.0);
            for (const int other : hand.joints) {
              if (!two || other <= joint) continue;
              for (const double same : {1.0, -1.0}) done = done || lifts(sign * step * kTurnStep, joint, other, same);
            }
          }
        }
      }
    }
  }
  return said;
}

}  // namespace twinbus::robot
