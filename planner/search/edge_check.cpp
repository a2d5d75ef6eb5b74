#include "planner/search/edge_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "robot/kinematics/joint_reach.h"

namespace twinbus {

EdgeCheck::EdgeCheck(const Model& model, Collision& collision, const Configuration& posture,
                     const std::vector<int>& joints, double clearance)
    : collision_(&collision),
      posture_(posture),
      kinematics_(model),
      joints_(joints),
      clearance_(clearance) {
  if (joints.empty() || joints.size() > at(kArmJoints)) {
    throw std::invalid_argument("EdgeCheck: 1 to " + std::to_string(kArmJoints) +
                                " joints can be planned, got " + std::to_string(joints.size()));
  }
  collision.check_only_moved_by(joints);
  reach_.resize(static_cast<int>(joints.size()));
  for (int k = 0; k < reach_.size(); ++k) reach_[k] = collision.reach().farthest(joints[at(k)]);
}

const Kinematics& EdgeCheck::kinematics_at(const JointPoint& q) {
  for (int k = 0; k < q.size(); ++k) posture_.q[joints_[at(k)]] = q[k];
  kinematics_.update(posture_);
  return kinematics_;
}

bool EdgeCheck::point_free(const JointPoint& q) {
  ++checks_;
  return !collision_->nearer_than(kinematics_at(q), clearance_);
}

bool EdgeCheck::who_is_near(const JointPoint& q, double clearance, CollisionPair& pair) {
  return collision_->nearer_than(kinematics_at(q), clearance, &pair);
}

double EdgeCheck::nearest(const JointPoint& q, double far) {
  PairDistance pair;
  return collision_->near_pairs(kinematics_at(q), far, &pair, 1) > 0 ? pair.distance : far;
}

double EdgeCheck::motion_bound(const JointPoint& from, const JointPoint& to) const {
  return (to - from).cwiseAbs().dot(reach_);
}

bool EdgeCheck::line_free(const JointPoint& from, const JointPoint& to) {
  if (!point_free(from) || !point_free(to)) return false;
  // Two samples are at most 2 clearances of motion apart, so each point is within one of a sample.
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(motion_bound(from, to) / (2.0 * clearance_))));
  // Coarse to fine: what is in the way is found early.  Visits every multiple of `stride` not
  // visited before.
  int stride = 1;
  while (stride < pieces) stride *= 2;
  for (; stride >= 1; stride /= 2) {
    for (int i = stride; i < pieces; i += 2 * stride) {
      const double share = static_cast<double>(i) / pieces;
      if (!point_free(from + share * (to - from))) return false;
    }
  }
  return true;
}

std::array<std::array<JointPoint, 4>, 2> halves(const std::array<JointPoint, 4>& curve) {
  const auto& [a, b, c, d] = curve;
  const JointPoint ab = 0.5 * (a + b), bc = 0.5 * (b + c), cd = 0.5 * (c + d);
  const JointPoint abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
  return {{{a, ab, abc, middle}, {middle, bcd, cd, d}}};
}

bool EdgeCheck::curve_free(const std::array<JointPoint, 4>& curve, int halvings) {
  const auto [first, second] = halves(curve);
  const JointPoint& middle = second[0];
  JointPoint farthest = JointPoint::Zero(middle.size());
  for (const JointPoint& p : curve) farthest = farthest.cwiseMax((p - middle).cwiseAbs());
  ++checks_;
  const double moves = farthest.dot(reach_);
  if (!collision_->nearer_than(kinematics_at(middle), clearance_ + moves)) return true;
  if (halvings == 0 || !point_free(middle)) return false;
  return curve_free(first, halvings - 1) && curve_free(second, halvings - 1);
}

}  // namespace twinbus
