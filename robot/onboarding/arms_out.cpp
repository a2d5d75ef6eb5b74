// Holds the arms of a proposed posture away from the legs: what hangs beside the thighs brushes past them in a walk.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/math/index.h"
#include "robot/collision/collision.h"
#include "robot/collision/collision_pairs.h"
#include "robot/kinematics/kinematics.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus::inline robot {

namespace {

constexpr double kLegClearance = 0.08;      // of the arms from the legs at rest [m]
constexpr double kMostOut = 0.5;     // [rad]
constexpr double kOutwardStep = 0.05;   // [rad]
constexpr double kAbout = 0.7;       // cosine: an axis so nearly forward turns an arm outwards
constexpr int kMostPosturePairs = 1024;

// The joint that turns an arm to its side, and which way: the first of it about the forward axis.
struct Shoulder {
  int joint = -1;
  double out = 1.0;  // sign of the joint that takes the hand outwards
};

Shoulder shoulder_of(const Model& model, const Kinematics& k, const Hand& hand, double side) {
  for (const int j : hand.joints) {
    const Eigen::Vector3d& axis = k.axis_in_world(j);
    if (model.joints[at(j)].kind == JointKind::kPrismatic || !(std::abs(axis.x()) > kAbout)) continue;
    const Eigen::Vector3d arm =
        k.link_in_world(hand.link) * hand.frame.translation() - k.link_in_world(j + 1).translation();
    const double moves = side * axis.cross(arm).y();  // [m/rad]
    if (std::abs(moves) < 0.05) continue;             // it does not hang from this joint
    return {j, moves > 0.0 ? 1.0 : -1.0};
  }
  return {};
}

// Of the robot in that posture, nearest first.
std::vector<PairDistance> near_pairs(const Model& model, const Eigen::VectorXd& q) {
  Collision collision(model);
  Configuration c(model);
  c.q = q;
  Kinematics k(model);
  k.update(c);
  std::vector<PairDistance> near(at(kMostPosturePairs));
  near.resize(at(collision.near_pairs(k, kLegClearance, near.data(), kMostPosturePairs)));
  return near;
}

}  // namespace

double arms_to_legs(const Model& model, const Anatomy& anatomy, const Eigen::VectorXd& q) {
  const auto is_arm = [&](int link) {
    return std::any_of(anatomy.hands.begin(), anatomy.hands.end(), [&](const Hand& hand) {
      return !hand.joints.empty() && hangs_on(model, link, hand.joints.front() + 1);
    });
  };
  const auto is_leg = [&](int link) {
    return std::any_of(anatomy.leg_joints.begin(), anatomy.leg_joints.end(),
                       [&](int j) { return hangs_on(model, link, j + 1); });
  };
  for (const PairDistance& pair : near_pairs(model, q)) {
    const int a = pair.link_a, b = pair.link_b;
    if ((is_arm(a) && is_leg(b)) || (is_arm(b) && is_leg(a))) return pair.distance;
  }
  return kLegClearance;
}

double leg_to_leg(const Model& model, const std::array<Sole, 2>& soles, const Eigen::VectorXd& q) {
  std::array<int, 2> root{};
  for (std::size_t side = 0; side < 2; ++side) {
    root[side] = soles[side].link;
    while (root[side] > 0 && model.links[at(root[side])].parent > 0) root[side] = model.links[at(root[side])].parent;
  }
  if (root[0] <= 0 || root[1] <= 0 || root[0] == root[1]) return kLegClearance;
  for (const PairDistance& pair : near_pairs(model, q)) {
    const int a = pair.link_a, b = pair.link_b;
    const bool left_and_right = hangs_on(model, a, root[0]) && hangs_on(model, b, root[1]);
    if (left_and_right || (hangs_on(model, b, root[0]) && hangs_on(model, a, root[1])))
      return pair.distance;
  }
  return kLegClearance;
}

double hold_arms_out(const Model& model, const Anatomy& anatomy, Eigen::VectorXd& q) {
  if (anatomy.leg_joints.empty()) return 0.0;
  Configuration c(model);
  c.q = q;
  Kinematics k(model);
  k.update(c);
  std::vector<Shoulder> shoulders;
  for (std::size_t side = 0; side < 2; ++side) {
    const Hand& hand = anatomy.hands[side];
    if (hand.link < 0) continue;
    const Shoulder shoulder = shoulder_of(model, k, hand, side == 0 ? 1.0 : -1.0);
    if (shoulder.joint >= 0) shoulders.push_back(shoulder);
  }
  if (shoulders.empty()) return 0.0;
  Eigen::VectorXd best = q;
  double turned = 0.0, widest = arms_to_legs(model, anatomy, q);
  for (double angle = kOutwardStep; widest < kLegClearance && angle < kMostOut + 0.5 * kOutwardStep; angle += kOutwardStep) {
    Eigen::VectorXd tried = q;
    for (const Shoulder& shoulder : shoulders) {
      const Joint& joint = model.joints[at(shoulder.joint)];
      tried[shoulder.joint] = std::clamp(q[shoulder.joint] + shoulder.out * angle, joint.lower, joint.upper);
    }
    const double apart = arms_to_legs(model, anatomy, tried);
    if (!(apart > widest + 1e-4)) continue;
    widest = apart;
    best = tried;
    turned = angle;
  }
  q = best;
  return turned;
}

}  // namespace twinbus::robot
