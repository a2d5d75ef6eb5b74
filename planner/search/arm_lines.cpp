#include "planner/search/arm_lines.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "robot/description/hand_of.h"

namespace twinbus {

namespace {

constexpr int kMostBalls = 8;  // along a link

std::vector<std::pair<int, int>> pairs_of(const Model& model, const Collision& collision,
                                          const std::vector<BallGroup>& groups) {
  std::vector<int> group_of(at(model.link_count()), -1);
  int links = 0;
  for (; links < static_cast<int>(groups.size()) && !groups[at(links)].held; ++links)
    group_of[at(groups[at(links)].link)] = links;
  const auto group = [&](int index) {
    return index < model.link_count() ? group_of[at(index)] : links + index - model.link_count();
  };
  std::vector<std::pair<int, int>> pairs;
  for (const auto* listed : {&collision.pairs(), &collision.held_pairs()}) {
    for (const CollisionPair& pair : *listed) pairs.emplace_back(group(pair.link_a), group(pair.link_b));
  }
  return pairs;
}

BallGroup balls_along(const LinkGeometry& link) {
  const Capsule& capsule = link.capsule;
  const Eigen::Vector3d along = capsule.b - capsule.a;
  const int count = std::clamp(static_cast<int>(std::ceil(along.norm() / (0.7 * capsule.radius))),
                               1, kMostBalls);
  // A ball holds its share of the capsule: half a share along, the radius across.
  const double half = 0.5 * along.norm() / count;
  BallGroup group = group_from(link);
  group.pieces.resize(1);  // the hull
  for (int i = 0; i < count; ++i) {
    group.balls.push_back(
        {capsule.a + (i + 0.5) / count * along, std::hypot(capsule.radius, half)});
  }
  // The round ends stick out of the last balls.
  group.balls.push_back({capsule.a, capsule.radius});
  group.balls.push_back({capsule.b, capsule.radius});
  return group;
}

}  // namespace

SearchPoint to_search(const JointPoint& q) {
  SearchPoint point{};
  for (int j = 0; j < q.size(); ++j) point[at(j)] = static_cast<float>(q[j]);
  return point;
}

JointPoint from_search(const SearchPoint& q, int joints) {
  JointPoint point(joints);
  for (int j = 0; j < joints; ++j) point[j] = static_cast<double>(q[at(j)]);
  return point;
}

// Balls are larger by the clearance, so two of them keep more than that.
ArmLines::ArmLines(const Model& model, EdgeCheck& exact, const Collision& collision,
                   const std::vector<BallGroup>& groups, const std::vector<Obstacle>& obstacles)
    : exact_(&exact),
      scene_(obstacles),
      robot_(compile_robot(model, exact.posture(), exact.joints(), groups,
                           pairs_of(model, collision, groups), exact.clearance())),
      check_(robot_, scene_) {
  check_.settle_pairs(true);
}

bool ArmLines::free(const SearchPoint& from, const SearchPoint& step, float) {
  if (check_.line_certain(from.data(), step.data())) {
    ++proved_;
    return true;
  }
  ++settled_;
  SearchPoint to = from;
  for (std::size_t j = 0; j < to.size(); ++j) to[j] += step[j];
  return exact_->line_free(from_search(from, robot_.joints), from_search(to, robot_.joints));
}

bool ArmLines::proves(const std::array<JointPoint, 4>& curve, int halvings) {
  const auto& [a, b, c, d] = curve;
  // At most 3 t (1 - t) <= 3/4 of how far the middle points are from thirds of the chord.
  const JointPoint strays = 0.75 * (b - a - (d - a) / 3.0).cwiseAbs().cwiseMax((c - d - (a - d) / 3.0).cwiseAbs());
  const double room = static_cast<double>(robot_.grow) - exact_->clearance();
  if (exact_->motion_bound(JointPoint::Zero(a.size()), strays) < room) {
    const SearchPoint from = to_search(a), step = to_search(d - a);
    return check_.line_certain(from.data(), step.data());
  }
  if (halvings == 0) return false;
  const auto [first, second] = halves(curve);
  return proves(first, halvings - 1) && proves(second, halvings - 1);
}

bool ArmLines::curve_free(const std::array<JointPoint, 4>& curve) {
  constexpr int kHalvings = 6;
  return proves(curve, kHalvings) || exact_->curve_free(curve);
}

std::vector<BallGroup> balls_along_links(const Model& model) {
  std::vector<BallGroup> groups;
  for (const LinkGeometry& link : build_geometry(model).links)
    groups.push_back(balls_along(link));
  return groups;
}

std::vector<BallGroup> balls_along_held(const Model& model, const std::vector<Obstacle>& obstacles) {
  std::vector<BallGroup> groups;
  for (const Obstacle& obstacle : obstacles) {
    if (!takes_part(obstacle, model)) continue;
    BallGroup group;
    if (obstacle.hand >= 0) {
      LinkGeometry geometry = link_geometry({shape_of(obstacle, model)});
      geometry.link = hand_of(model, obstacle.hand)->link;
      group = balls_along(geometry);
    }
    group.held = true;
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace twinbus
