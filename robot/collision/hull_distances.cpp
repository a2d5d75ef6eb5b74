#include "robot/collision/hull_distances.h"

#include <algorithm>
#include <utility>

#include "robot/collision/collision_body.h"
#include "robot/collision/collision_pairs.h"
#include "geometry/bounds/convex_hull.h"
#include "robot/collision/links/geometry_cache.h"
#include "geometry/distance/gjk.h"
#include "common/math/index.h"
#include "geometry/mesh/mesh_file.h"
#include "geometry/distance/broad_phase.h"

namespace twinbus {

namespace {

struct Hull {
  int link = 0;
  GjkShape shape;
  Eigen::Isometry3d local = Eigen::Isometry3d::Identity();  // in the link
  bool as_link = true;                                      // local is the identity
  Eigen::Isometry3d world = Eigen::Isometry3d::Identity();
  Capsule capsule;  // around it, in its frame
};

Hull hull_of(int link, const Shape& shape) {
  Hull hull;
  hull.link = link;
  if (shape.kind == ShapeKind::kMesh) {
    const auto corners = convex_hull(load_mesh(shape.mesh, shape.size).points).points;
    hull.shape = gjk_hull(corners);
    hull.local = shape.pose;
    hull.capsule = kept_capsule(corners);
  } else {
    const CollisionShape primitive = collision_shape(shape);
    hull.shape = primitive.core;
    hull.local = primitive.local;
    hull.capsule = primitive.capsule;
  }
  hull.as_link = hull.local.matrix().isIdentity(0.0);
  return hull;
}

}  // namespace

struct HullDistances::Impl {
  std::vector<CollisionPair> pairs;
  std::vector<Hull> hulls;
  NearShapes near_shapes;
  std::vector<unsigned char> several;         // of every pair: a link of it has several hulls
  std::vector<int> first;                     // hull of every link; one more
  std::vector<int> pair_of;                   // [hulls x hulls], a < b
  std::vector<GjkQuery> queries;              // room
  std::vector<int> pair_of_query;             // room
  std::vector<std::pair<double, int>> order;  // of queries by distance: room
};

HullDistances::HullDistances(const Model& model) : impl_(std::make_unique<Impl>()) {
  Impl& i = *impl_;
  i.pairs = pairs_to_check(model);
  std::vector<Capsule> capsules;
  for (int link = 0; link < model.link_count(); ++link) {
    i.first.push_back(static_cast<int>(i.hulls.size()));
    for (const Shape& shape : model.links[at(link)].collision) {
      const Hull& hull = i.hulls.emplace_back(hull_of(link, shape));
      capsules.push_back(hull.capsule);
    }
  }
  i.first.push_back(static_cast<int>(i.hulls.size()));
  i.near_shapes.set(capsules);
  i.pair_of.assign(i.hulls.size() * i.hulls.size(), -1);
  for (std::size_t p = 0; p < i.pairs.size(); ++p) {
    const auto [link_a, link_b] = i.pairs[p];
    const auto count = [&](int link) { return i.first[at(link + 1)] - i.first[at(link)]; };
    i.several.push_back(count(link_a) > 1 || count(link_b) > 1 ? 1 : 0);
    for (int a = i.first[at(link_a)]; a < i.first[at(link_a + 1)]; ++a) {
      for (int b = i.first[at(link_b)]; b < i.first[at(link_b + 1)]; ++b) {
        i.pair_of[at(std::min(a, b)) * i.hulls.size() + at(std::max(a, b))] = static_cast<int>(p);
        i.near_shapes.want(a, b, true);
        i.queries.emplace_back();
      }
    }
  }
  i.pair_of_query.resize(i.queries.size());
  i.order.resize(i.queries.size());
}
HullDistances::~HullDistances() = default;

const std::vector<CollisionPair>& HullDistances::pairs() const noexcept { return impl_->pairs; }

int HullDistances::near(const Kinematics& kinematics, double near, PairDistance* pairs,
                        int capacity) noexcept {
  Impl& i = *impl_;
  const Eigen::Vector3d& origin = kinematics.link_in_world(0).translation();
  for (std::size_t h = 0; h < i.hulls.size(); ++h) {
    Hull& hull = i.hulls[h];
    const Eigen::Isometry3d& link = kinematics.link_in_world(hull.link);
    if (hull.as_link) {
      hull.world = link;
    } else {
      hull.world = link * hull.local;
    }
    i.near_shapes.place(static_cast<int>(h), hull.world, origin);
  }
  std::size_t asked = 0;
  for (const NearShapes::Candidate& c : i.near_shapes.nearer_than(near)) {
    const int p = i.pair_of[at(c.a) * i.hulls.size() + at(c.b)];
    const bool same_way = i.hulls[at(c.a)].link == i.pairs[at(p)].link_a;
    const Hull& a = i.hulls[at(same_way ? c.a : c.b)];
    const Hull& b = i.hulls[at(same_way ? c.b : c.a)];
    Eigen::Vector3d towards(static_cast<double>(c.towards[0]), static_cast<double>(c.towards[1]),
                            static_cast<double>(c.towards[2]));
    if (!same_way) towards = -towards;
    i.pair_of_query[asked] = p;
    i.queries[asked++] = {
        &a.shape, &a.world, &b.shape, &b.world, near, a.world.linear().transpose() * towards, {}};
  }
  gjk_distances({i.queries.data(), asked});
  int found = 0;
  for (std::size_t q = 0; q < asked; ++q) {
    const GjkResult& result = i.queries[q].result;
    if (result.distance <= near && result.below <= near)
      i.order[at(found++)] = {result.distance, static_cast<int>(q)};
  }
  std::sort(i.order.begin(), i.order.begin() + found);
  int kept = 0;
  for (int k = 0; k < found && kept < capacity; ++k) {
    const int q = i.order[at(k)].second;
    const auto [link_a, link_b] = i.pairs[at(i.pair_of_query[at(q)])];
    // Of two links that have several shapes the nearest of these came first.
    if (i.several[at(i.pair_of_query[at(q)])] != 0 &&
        std::any_of(pairs, pairs + kept, [&, a = link_a, b = link_b](const PairDistance& before) {
          return before.link_a == a && before.link_b == b;
        }))
      continue;
    const GjkResult& result = i.queries[at(q)].result;
    pairs[kept++] = {link_a,         link_b,         result.distance,
                     result.point_a, result.point_b, result.normal};
  }
  return kept;
}

}  // namespace twinbus
