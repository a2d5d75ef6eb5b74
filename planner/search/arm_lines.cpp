#include "planner/search/arm_lines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "geometry/bounds/coarse_mesh.h"
#include "robot/collision/collision_pairs.h"
#include "robot/collision/links/inscribed_spheres.h"
#include "robot/description/model.h"

namespace twinbus::inline planner {

namespace {

constexpr int kMostBalls = 8;    // along a link
constexpr int kInnerBalls = 12;  // of a link
constexpr double kMostSlack = 0.004;  // of a curve from its chord; those that stray farther are halved first [m]

// The groups of links and obstacles by their indices in pairs.
class GroupOf {
 public:
  GroupOf(const Model& model, const std::vector<BallGroup>& groups)
      : link_count_(model.link_count()), of_link_(at(link_count_), -1) {
    for (; links_ < static_cast<int>(groups.size()) && !groups[at(links_)].held; ++links_)
      of_link_[at(groups[at(links_)].link)] = links_;
  }
  int count() const { return links_; }  // of links
  int operator()(int index) const { return index < link_count_ ? of_link_[at(index)] : links_ + index - link_count_; }

 private:
  int link_count_, links_ = 0;
  std::vector<int> of_link_;
};

std::vector<std::pair<int, int>> pairs_of(const Model& model, const Collision& collision,
                                          const std::vector<BallGroup>& groups) {
  const GroupOf group(model, groups);
  std::vector<std::pair<int, int>> pairs;
  for (const auto* listed : {&collision.pairs(), &collision.held_pairs()}) {
    for (const CollisionPair& pair : *listed) pairs.emplace_back(group(pair.link_a), group(pair.link_b));
  }
  return pairs;
}

// As Collision takes a link: a mesh of many triangles as its hull, what lies in a hollow counts as inside; others as they are.
BallGroup group_as_collided(const LinkGeometry& link, const std::vector<Shape>& shapes) {
  const auto fine = [](const Shape& shape, const LinkGeometry& of) {
    return shape.kind == ShapeKind::kMesh && static_cast<int>(of.mesh.triangles.size()) <= kFineTriangles;
  };
  BallGroup group = group_from(link);
  if (shapes.size() == 1 && fine(shapes[0], link)) return group;
  group.pieces.resize(1);  // the hull
  if (shapes.size() == 1) return group;
  for (const Shape& shape : shapes) {
    const LinkGeometry geometry = link_geometry({shape});
    const BallGroup part = group_from(geometry);
    const auto hull = part.pieces.begin();
    if (fine(shape, geometry)) group.pieces.insert(group.pieces.end(), hull + 1, part.pieces.end());
    else group.pieces.push_back(*hull);
  }
  return group;
}

BallGroup balls_along(const LinkGeometry& link, const std::vector<Shape>& shapes) {
  const Capsule& capsule = link.capsule;
  const Eigen::Vector3d along = capsule.b - capsule.a;
  const int count = std::clamp(static_cast<int>(std::ceil(along.norm() / (0.7 * capsule.radius))),
                               1, kMostBalls);
  // A ball holds its share of the capsule: half a share along, the radius across.
  const double half = 0.5 * along.norm() / count;
  BallGroup group = group_as_collided(link, shapes);
  for (int i = 0; i < count; ++i) {
    group.balls.push_back(
        {capsule.a + (i + 0.5) / count * along, std::hypot(capsule.radius, half)});
  }
  // The round ends stick out of the last balls.
  group.balls.push_back({capsule.a, capsule.radius});
  group.balls.push_back({capsule.b, capsule.radius});
  group.inner = inner_balls(link, kInnerBalls, 0);
  group.bounds = bounds_of(group);
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
  keep_less_at_ends(model, groups, obstacles);
  check_.settle_pairs(true);
  check_.settle_by_pieces(true);
}

// What is near where the motion begins or ends, as the exact check takes it.
void ArmLines::keep_less_at_ends(const Model& model, const std::vector<BallGroup>& groups,
                                 const std::vector<Obstacle>& obstacles) {
  ends_ = exact_->ends();
  std::vector<int> shape_of;  // of those that take part, in the scene; -1 of what is held
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (takes_part(obstacles[i], model)) shape_of.push_back(scene_.shape_of[i]);
  }
  const GroupOf group(model, groups);
  if (groups.size() != at(group.count()) + shape_of.size()) throw std::invalid_argument("ArmLines: a group of each obstacle is wanted");
  for (const BallGroup& riding : groups) {  // what a base on the plane carries, and the ground
    if (riding.held || !stays_above_ground(model, riding.link)) continue;
    for (std::size_t i = 0, part = 0; i < obstacles.size(); ++i) {
      if (!takes_part(obstacles[i], model)) continue;
      const int shape = shape_of[part++];
      if (shape < 0 || !is_ground(obstacles[i])) continue;
      robot_.kept_of_shapes.push_back({robot_.group_of[at(group(riding.link))], shape, -1.0F});
    }
  }
  if (ends_.empty()) return;
  robot_.kept_of_pairs.assign(robot_.pairs.size(), robot_.grow);
  for (EndPair& end : ends_) {
    end.margin = exact_->margin(end.link_a, end.link_b);
    const auto kept = static_cast<float>(end.margin);
    const int of[2] = {end.link_a, end.link_b};
    bool stands = false;  // one of them, in the world
    for (const int k : {0, 1}) {
      const int shape = of[k] < model.link_count() ? -1 : shape_of[at(of[k] - model.link_count())];
      if (shape < 0) continue;
      stands = true;
      robot_.kept_of_shapes.push_back({robot_.group_of[at(group(of[1 - k]))], shape, kept});
    }
    if (stands) continue;
    const std::pair<int, int> ab{robot_.group_of[at(group(of[0]))], robot_.group_of[at(group(of[1]))]};
    for (std::size_t i = 0; i < robot_.pairs.size(); ++i) {
      const auto& [a, b] = robot_.pairs[i];
      if (std::pair(a, b) == ab || std::pair(b, a) == ab) robot_.kept_of_pairs[i] = kept;
    }
  }
}

CertainPath ArmLines::find_proved(JointSearch& search, const SearchPoint& start, const SearchPath& goals, bool (*keep_on)(void*),
                                  void* user) {
  constexpr float kDensity = 32.0F;  // postures per radian of a first look
  return find_certain(search, check_, kDensity, start, goals, keep_on, user);
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

bool ArmLines::proves(const std::array<JointPoint, 4>& curve, double room, int halvings) {
  const auto& [a, b, c, d] = curve;
  // At most 3 t (1 - t) <= 3/4 of how far the middle points are from thirds of the chord.
  const JointPoint strays = 0.75 * (b - a - (d - a) / 3.0).cwiseAbs().cwiseMax((c - d - (a - d) / 3.0).cwiseAbs());
  const double slack = exact_->motion_bound(JointPoint::Zero(a.size()), strays) - room;
  const SearchPoint from = to_search(a), step = to_search(d - a);
  if (slack < kMostSlack && check_.line_certain(from.data(), step.data(), static_cast<float>(std::max(0.0, slack)))) return true;
  if (halvings == 0 || slack <= 0.0) return false;
  const auto [first, second] = halves(curve);
  return proves(first, room, halvings - 1) && proves(second, room, halvings - 1);
}

bool ArmLines::curve_free(const std::array<JointPoint, 4>& curve) {
  constexpr int kHalvings = 6;
  double room = static_cast<double>(robot_.grow) - exact_->clearance();
  for (const EndPair& end : ends_) room = std::min(room, end.margin - exact_->margin(end.link_a, end.link_b));
  return proves(curve, room, kHalvings) || exact_->curve_free(curve);
}

std::vector<BallGroup> balls_along_links(const Model& model) {
  std::vector<BallGroup> groups;
  for (const LinkGeometry& link : build_geometry(model).links)
    groups.push_back(balls_along(link, model.links[at(link.link)].collision));
  return groups;
}

std::vector<BallGroup> balls_along_held(const Model& model, const std::vector<Obstacle>& obstacles) {
  std::vector<BallGroup> groups;
  for (const Obstacle& obstacle : obstacles) {
    if (!takes_part(obstacle, model)) continue;
    BallGroup group;
    if (obstacle.hand >= 0) {
      const std::vector<Shape> shapes{shape_of(obstacle, model)};
      LinkGeometry geometry = link_geometry(shapes);
      geometry.link = hand_of(model, obstacle.hand)->link;
      group = balls_along(geometry, shapes);
    }
    group.held = true;
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace twinbus::planner
