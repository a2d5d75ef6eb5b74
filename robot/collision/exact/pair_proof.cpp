#include "robot/collision/exact/pair_proof.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "robot/collision/collision_pairs.h"
#include "geometry/distance/gjk.h"
#include "common/math/index.h"
#include "common/text/name_of.h"
#include "robot/kinematics/kinematics.h"
#include "robot/collision/exact/self_collision.h"

namespace twinbus::inline robot {

namespace {

constexpr double kSmallest = 1e-3;  // a cell that moves links by less is not cut further [m]
constexpr double kProofRounding = 1e-6;  // of distances and poses [m]

struct Range {
  double low = 0.0, high = 0.0;
};

Range range_of(const Model& model, int j, double beyond) {
  const Joint& joint = model.joints[at(j)];
  if (joint.mimic >= 0) {  // as wide as its driver moves it
    const Range driver = range_of(model, joint.mimic, beyond);
    const double a = joint.mimic_multiplier * driver.low + joint.mimic_offset;
    const double b = joint.mimic_multiplier * driver.high + joint.mimic_offset;
    return {std::min(a, b), std::max(a, b)};
  }
  const bool turns = joint.kind != JointKind::kPrismatic;
  if (joint.kind == JointKind::kContinuous ||
      (turns && !(joint.upper - joint.lower + 2.0 * beyond < 2.0 * std::numbers::pi)))
    return {-std::numbers::pi, std::numbers::pi};
  return {joint.lower - beyond, joint.upper + beyond};
}

struct Cell {
  std::vector<Range> ranges;  // of the joints between
};

class Prover {
 public:
  Prover(const Model& model, const RobotGeometry& geometry, const PairProofOptions& options)
      : model_(model), geometry_(geometry), options_(options), kinematics_(model), now_(model) {
    for (const LinkGeometry& g : geometry.links) hulls_.push_back(gjk_hull(g.hull.points));
    for (int j = 0; j < model.joint_count(); ++j)
      ranges_.push_back(range_of(model, j, options.beyond_limits));
  }

  const Range& range(int joint) const { return ranges_[at(joint)]; }

  bool never(const CollisionPair& pair, int& cells) {
    joints_.clear();
    reach_.clear();
    add_joints(pair, pair.link_a);
    add_joints(pair, pair.link_b);
    Cell whole;
    for (const int j : joints_) {
      whole.ranges.push_back(ranges_[at(j)]);
      if (!std::isfinite(whole.ranges.back().high - whole.ranges.back().low)) return false;
    }
    std::vector<Cell> open{whole};
    for (cells = 0; !open.empty(); ++cells) {
      if (cells == options_.cells) return false;
      const Cell cell = std::move(open.back());
      open.pop_back();
      double moves = 0.0, most = -1.0;
      std::size_t widest = 0;
      for (std::size_t k = 0; k < joints_.size(); ++k) {
        const Range& r = cell.ranges[k];
        now_.q[joints_[k]] = 0.5 * (r.low + r.high);
        const double move = motion(k, 0.5 * (r.high - r.low));
        moves += move;
        if (move > most) {
          most = move;
          widest = k;
        }
      }
      if (distance(pair, moves) > moves + kProofRounding) continue;
      if (!(moves > kSmallest)) return false;
      Cell left = cell, right = cell;
      const Range& r = cell.ranges[widest];
      left.ranges[widest].high = right.ranges[widest].low = 0.5 * (r.low + r.high);
      open.push_back(std::move(left));
      open.push_back(std::move(right));
    }
    return true;
  }

 private:
  // The joints between the two links that move `link`, and how far its points are from their axes.
  void add_joints(const CollisionPair& pair, int link) {
    const LinkGeometry& g = geometry_.links[at(geometry_.of_link[at(link)])];
    double length = 0.0;
    for (const Eigen::Vector3d& p : g.mesh.points) length = std::max(length, p.norm());
    for (int child = link; child > 0; child = model_.links[at(child)].parent) {
      const int j = child - 1;
      const Joint& joint = model_.joints[at(j)];
      const bool slides = joint.kind == JointKind::kPrismatic;
      double reach = length;
      if (child == link && !slides) {
        reach = 0.0;
        for (const Eigen::Vector3d& p : g.mesh.points)
          reach = std::max(reach, joint.axis.cross(p).norm());
      }
      if (joint_moves_pair(model_, j, pair.link_a, pair.link_b)) {
        joints_.push_back(j);
        reach_.push_back(slides ? 1.0 : reach);
      }
      length += joint.placement.translation().norm();
      if (slides) length += std::max(std::abs(ranges_[at(j)].low), std::abs(ranges_[at(j)].high));
    }
  }

  double motion(std::size_t k, double half) const {
    if (model_.joints[at(joints_[k])].kind == JointKind::kPrismatic) return half;
    return 2.0 * reach_[k] * std::sin(0.5 * std::min(half, std::numbers::pi));
  }

  double distance(const CollisionPair& pair, double far) {
    kinematics_.update(now_);
    return gjk_distance(hulls_[at(geometry_.of_link[at(pair.link_a)])],
                        kinematics_.link_in_world(pair.link_a),
                        hulls_[at(geometry_.of_link[at(pair.link_b)])],
                        kinematics_.link_in_world(pair.link_b), far + 2.0 * kProofRounding)
        .below;
  }

  const Model& model_;
  const RobotGeometry& geometry_;
  PairProofOptions options_;
  Kinematics kinematics_;
  Configuration now_;
  std::vector<GjkShape> hulls_;
  std::vector<Range> ranges_;
  std::vector<int> joints_;    // of the pair in hand
  std::vector<double> reach_;  // [m/rad or m/m]
};

}  // namespace

const char* name(PairKind kind) noexcept {
  static constexpr const char* kNames[] = {"neighbours", "never (proved)", "touches", "touches in every sample"};
  return name_of(kind, kNames, "not seen touching, not proved");
}

std::vector<PairVerdict> judge_pairs(const Model& model, const RobotGeometry& geometry,
                                     const PairProofOptions& options) {
  Model all = model;
  all.disabled_pairs.clear();
  const std::vector<CollisionPair> candidates = pairs_to_check(all);
  SelfCollision check(model, geometry, candidates);
  Prover prover(model, geometry, options);
  std::vector<int> hits(candidates.size(), 0);
  std::vector<Eigen::VectorXd> posture(candidates.size());
  std::mt19937_64 random(1);
  Eigen::VectorXd q(model.joint_count());
  for (int i = 0; i < options.samples; ++i) {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Range& r = prover.range(j);
      const Joint& joint = model.joints[at(j)];
      q[j] = joint.mimic >= 0 ? joint.mimic_multiplier * q[joint.mimic] + joint.mimic_offset
                              : std::uniform_real_distribution<double>(r.low, r.high)(random);
    }
    check.place(q);
    const int n = check.touching();
    for (int k = 0; k < n; ++k) {
      const auto p = at(check.hit()[k]);
      if (++hits[p] == 1) posture[p] = q;
    }
  }
  std::vector<PairVerdict> verdicts;
  for (std::size_t p = 0; p < candidates.size(); ++p) {
    PairVerdict v;
    v.pair = candidates[p];
    v.posture = posture[p];
    if (hits[p] == 0) {
      v.kind = prover.never(v.pair, v.cells) ? PairKind::kNever : PairKind::kUnproved;
    } else {
      v.kind = hits[p] == options.samples ? PairKind::kAlwaysSeen : PairKind::kTouches;
    }
    verdicts.push_back(v);
  }
  // The rest are neighbours.
  std::size_t next = 0;
  std::vector<PairVerdict> result;
  for (const LinkGeometry& b : geometry.links) {
    for (const LinkGeometry& a : geometry.links) {
      if (a.link >= b.link) break;
      if (next < verdicts.size() && verdicts[next].pair.link_a == a.link &&
          verdicts[next].pair.link_b == b.link) {
        result.push_back(verdicts[next++]);
      } else {
        PairVerdict v;
        v.pair = {a.link, b.link};
        v.kind = PairKind::kNeighbours;
        result.push_back(v);
      }
    }
  }
  return result;
}

std::string srdf_with_pairs(const Model& model, const std::vector<PairVerdict>& verdicts) {
  std::string lines;
  for (const PairVerdict& v : verdicts) {
    if (v.kind != PairKind::kNeighbours && v.kind != PairKind::kNever) continue;
    const bool known = std::any_of(
        model.disabled_pairs.begin(), model.disabled_pairs.end(), [&](const auto& pair) {
          return (pair[0] == v.pair.link_a && pair[1] == v.pair.link_b) ||
                 (pair[0] == v.pair.link_b && pair[1] == v.pair.link_a);
        });
    if (known) continue;
    lines += "  <disable_collisions link1=\"" + model.links[at(v.pair.link_a)].name +
             "\" link2=\"" + model.links[at(v.pair.link_b)].name + "\" reason=\"" +
             (v.kind == PairKind::kNever ? "Never, proved" : "Adjacent") + "\"/>\n";
  }
  std::string text = model.srdf_text;
  const std::size_t end = text.rfind("</robot>");
  if (end == std::string::npos)
    return "<?xml version=\"1.0\"?>\n<robot name=\"" + model.name + "\">\n" + lines + "</robot>\n";
  return text.insert(end, lines);
}

}  // namespace twinbus::robot
