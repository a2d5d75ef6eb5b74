#include "planner/search/edge_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "robot/kinematics/joint_reach.h"

namespace twinbus::inline planner {

namespace {
constexpr int kHalvings = 16;  // of a line at whose ends something is near
}  // namespace

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
  std::vector<int> moving = joints;
  reach_.resize(static_cast<int>(joints.size()));
  for (int k = 0; k < reach_.size(); ++k) {
    reach_[k] = collision.reach().farthest(joints[at(k)]);
    for (int follower = 0; follower < model.joint_count(); ++follower) {
      const Joint& joint = model.joints[at(follower)];
      if (joint.mimic != joints[at(k)]) continue;
      reach_[k] += std::abs(joint.mimic_multiplier) * collision.reach().farthest(follower);
      moving.push_back(follower);
    }
  }
  collision.check_only_moved_by(moving);
}

const Kinematics& EdgeCheck::kinematics_at(const JointPoint& q) {
  for (int k = 0; k < q.size(); ++k) posture_.q[joints_[at(k)]] = q[k];
  set_mimics(kinematics_.model(), posture_);
  kinematics_.update(posture_);
  return kinematics_;
}

bool EdgeCheck::point_free(const JointPoint& q) {
  if (!ends_.empty()) return room(q) >= 0.0;
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

double EdgeCheck::nearest_beside(const JointPoint& q, double far, double close, std::vector<EndPair>& ends) {
  std::array<PairDistance, kNearPairs> near;
  const int count = collision_->near_pairs(kinematics_at(q), far, near.data(), kNearPairs);
  double least = far;
  for (int i = 0; i < count; ++i) {
    const PairDistance& pair = near[at(i)];
    if (!(pair.distance < close) || count == kNearPairs) {
      least = std::min(least, pair.distance);
      continue;
    }
    const auto known = std::find_if(ends.begin(), ends.end(), [&](const EndPair& end) {
      return end.link_a == pair.link_a && end.link_b == pair.link_b;
    });
    if (known == ends.end()) ends.push_back({pair.link_a, pair.link_b, pair.distance});
    else known->room = std::min(known->room, pair.distance);
  }
  return least;
}

double EdgeCheck::margin(int link_a, int link_b) const {
  for (const EndPair& end : ends_) {
    if (end.link_a == link_a && end.link_b == link_b) return std::min(clearance_, share_ * end.margin);
  }
  return clearance_;
}

double EdgeCheck::kept() const {
  double least = clearance_;
  for (const EndPair& end : ends_) least = std::min(least, margin(end.link_a, end.link_b));
  return least;
}

// Of the nearest pair, at most the clearance; below zero when one keeps less than it must there.
double EdgeCheck::room(const JointPoint& q) {
  ++checks_;
  std::array<PairDistance, kNearPairs> near;
  const int count = collision_->near_pairs(kinematics_at(q), clearance_, near.data(), kNearPairs);
  double least = count == kNearPairs ? -1.0 : clearance_;
  for (int i = 0; i < count; ++i) {
    const PairDistance& pair = near[at(i)];
    least = std::min(least, pair.distance > margin(pair.link_a, pair.link_b) ? pair.distance : -1.0);
  }
  return least;
}

// Does every pair keep what it must when nothing moves farther than `moves` from q?
bool EdgeCheck::clear_by(const JointPoint& q, double moves) {
  std::array<PairDistance, kNearPairs> near;
  const int count = collision_->near_pairs(kinematics_at(q), clearance_ + moves, near.data(), kNearPairs);
  return count < kNearPairs && std::all_of(near.begin(), near.begin() + count, [&](const PairDistance& pair) {
    return pair.distance > margin(pair.link_a, pair.link_b) + moves;
  });
}

// Of a line at whose ends every pair has at least that room.
bool EdgeCheck::between(const JointPoint& from, double room_from, const JointPoint& to, double room_to, int halvings) {
  if (motion_bound(from, to) <= room_from + room_to) return true;
  if (halvings == 0) return false;
  const JointPoint middle = 0.5 * (from + to);
  const double here = room(middle);
  return here >= 0.0 && between(from, room_from, middle, here, halvings - 1) && between(middle, here, to, room_to, halvings - 1);
}

double EdgeCheck::motion_bound(const JointPoint& from, const JointPoint& to) const {
  return (to - from).cwiseAbs().dot(reach_);
}

bool EdgeCheck::line_free(const JointPoint& from, const JointPoint& to) {
  if (!ends_.empty()) {
    const double room_from = room(from), room_to = room(to);
    return room_from >= 0.0 && room_to >= 0.0 && between(from, room_from, to, room_to, kHalvings);
  }
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
  if (!ends_.empty() && clear_by(middle, moves)) return true;
  if (halvings == 0 || !point_free(middle)) return false;
  return curve_free(first, halvings - 1) && curve_free(second, halvings - 1);
}

}  // namespace twinbus::planner
