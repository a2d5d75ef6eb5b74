#include "robot/self_collision.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "robot/collision_pairs.h"
#include "robot/index.h"
#include "robot/pose_math.h"
#include "robot/self_collision_data.h"
#include "robot/vec4.h"

namespace twinbus {

// clang-format off
#define TWINBUS_WIDE 0
namespace baseline_lanes {
#include "robot/self_collision_lanes.h"
#include "robot/capsule_lanes.h"
#include "robot/self_collision_far.h"
#include "robot/self_collision_triangles.h"
#include "robot/self_collision_hulls.h"
#include "robot/self_collision_inside.h"
#include "robot/self_collision_boxes.h"
#include "robot/self_collision_near.h"
}  // namespace baseline_lanes
#undef TWINBUS_WIDE
#if defined(__x86_64__) && !defined(__clang__)
#define TWINBUS_WIDE 1
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2_lanes {
#include "robot/self_collision_lanes.h"
#include "robot/capsule_lanes.h"
#include "robot/self_collision_far.h"
#include "robot/self_collision_triangles.h"
#include "robot/self_collision_hulls.h"
#include "robot/self_collision_inside.h"
#include "robot/self_collision_boxes.h"
#include "robot/self_collision_near.h"
}  // namespace avx2_lanes
#pragma GCC target("avx512f,avx512vl,avx512dq")
namespace avx512_lanes {
#include "robot/self_collision_lanes.h"
#include "robot/capsule_lanes.h"
#include "robot/self_collision_far.h"
#include "robot/self_collision_triangles.h"
#include "robot/self_collision_hulls.h"
#include "robot/self_collision_inside.h"
#include "robot/self_collision_boxes.h"
#include "robot/self_collision_near.h"
}  // namespace avx512_lanes
#pragma GCC pop_options
#undef TWINBUS_WIDE
#define TWINBUS_LANES(call)                                        \
  (i.set == InstructionSet::kAvx512 ? avx512_lanes::call           \
   : i.set == InstructionSet::kAvx2 ? avx2_lanes::call : baseline_lanes::call)
#else
#define TWINBUS_LANES(call) (baseline_lanes::call)
#endif
// clang-format on

namespace {

constexpr int kLanes = 8;

std::size_t padded(std::size_t n) { return (n + kLanes - 1) / kLanes * kLanes; }

void set4(const Eigen::Vector3d& v, double last, float (&to)[4]) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(v[k]);
  to[3] = static_cast<float>(last);
}

struct Aligned {  // numbers that lanes read
  std::vector<float> store;
  float* data = nullptr;
  void resize(std::size_t n, float value = 0.0F) {
    store.assign(n + 16, value);
    void* raw = store.data();
    std::size_t room = store.size() * sizeof(float);
    data = static_cast<float*>(std::align(64, n * sizeof(float), raw, room));
  }
};

CollisionTriangleBoxes boxes_of(const TriangleCluster& cluster) {
  constexpr float kGrow = 1e-6F;  // [m]
  CollisionTriangleBoxes boxes;
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t lane = 0; lane < TriangleCluster::kLanes; ++lane) {
      const auto [low, high] = std::minmax(
          {cluster.corner[0][d][lane], cluster.corner[1][d][lane], cluster.corner[2][d][lane]});
      boxes.low[d][lane] = low - kGrow;
      boxes.high[d][lane] = high + kGrow;
    }
  }
  return boxes;
}

}  // namespace

InstructionSet best_instruction_set() noexcept {
#if defined(__x86_64__) && !defined(__clang__)
  static const InstructionSet best =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
              __builtin_cpu_supports("avx512dq")
          ? InstructionSet::kAvx512
          : (__builtin_cpu_supports("avx2") ? InstructionSet::kAvx2 : InstructionSet::kBaseline);
  return best;
#else
  return InstructionSet::kBaseline;
#endif
}

struct SelfCollision::Impl {
  struct Body {
    std::vector<TriangleCluster> clusters;
    Aligned center[3], radius, block_center[3], block_radius, hull[3];
    Aligned box_middle[3], box_half[3], box_low[3], box_high[3];
    std::vector<CollisionTriangleBoxes> triangle_boxes;
    std::vector<std::array<float, 4>> middle, half, witness;
  };

  std::vector<CollisionPair> pairs;
  std::vector<CollisionJoint> joints;
  std::vector<CollisionBody> bodies;
  std::vector<Body> stores;
  std::vector<unsigned char> wanted;
  std::vector<int> pair_of, body_of;
  std::vector<CollisionPose> poses;
  std::vector<double> angle, sine, cosine;
  Aligned placed;
  std::vector<CollisionCandidate> near;
  std::vector<int> hits;
  std::vector<CollisionMemory> memory;
  Aligned bound, kept;
  std::vector<unsigned char> open;
  Work counters;
  long work[4] = {};
  CollisionTables tables;
  InstructionSet set = best_instruction_set();

  Impl(const Model& model, const RobotGeometry& geometry,
       const std::vector<CollisionPair>& wanted_pairs)
      : pairs(wanted_pairs) {
    add_joints(model, geometry);
    add_bodies(geometry);
    add_pairs(geometry);
    connect();
  }

  void add_joints(const Model& model, const RobotGeometry& geometry);
  static void group(Body& store, const std::vector<TriangleCluster>& clusters);
  void add_bodies(const RobotGeometry& geometry);
  void add_pairs(const RobotGeometry& geometry);
  void connect();
  void want(const CollisionPair& pair, bool on) noexcept;
};

void SelfCollision::Impl::add_joints(const Model& model, const RobotGeometry& geometry) {
  std::vector<char> bears(model.links.size(), 0);  // geometry, itself or farther out
  for (const LinkGeometry& g : geometry.links) {
    for (int link = g.link; link > 0; link = model.links[at(link)].parent) bears[at(link)] = 1;
  }
  for (std::size_t index = 0; index < model.joints.size(); ++index) {
    if (bears[index + 1] == 0) continue;
    const Joint& joint = model.joints[index];
    CollisionJoint j{};
    j.parent = joint.parent;
    j.child = static_cast<int>(index) + 1;
    j.index = static_cast<int>(index);
    j.turns = joint.kind != JointKind::kPrismatic;
    const Eigen::Matrix3d x = joint.placement.linear();
    const Eigen::Matrix3d along = joint.axis * joint.axis.transpose();
    Eigen::Matrix3d still = x, with_cosine = Eigen::Matrix3d::Zero(), with_sine = with_cosine;
    if (j.turns) {  // R(q) = x (a a^T + cos q (1 - a a^T) + sin q [a])
      still = x * along;
      with_cosine = x * (Eigen::Matrix3d::Identity() - along);
      with_sine = x * skew(joint.axis);
    }
    for (int k = 0; k < 3; ++k) {
      set4(still.col(k), 0.0, j.still[k]);
      set4(with_cosine.col(k), 0.0, j.with_cosine[k]);
      set4(with_sine.col(k), 0.0, j.with_sine[k]);
    }
    set4(joint.placement.translation(), 0.0, j.offset);
    set4(x * joint.axis, 0.0, j.slide);
    joints.push_back(j);
  }
  poses.resize(model.links.size());
  for (int k = 0; k < 3; ++k) set4(Eigen::Vector3d::Unit(k), 0.0, poses[0].column[k]);
  set4(Eigen::Vector3d::Zero(), 0.0, poses[0].origin);
  const std::size_t angles = (joints.size() + 3) / 4 * 4;
  angle.assign(angles, 0.0);
  sine.assign(angles, 0.0);
  cosine.assign(angles, 1.0);
}

// Clusters come in the order of their tree, so eight in a row lie together.
void SelfCollision::Impl::group(Body& store, const std::vector<TriangleCluster>& clusters) {
  const std::size_t blocks = padded(clusters.size()) / kLanes;
  for (Aligned& c : store.block_center) c.resize(padded(blocks), 1e9F);
  store.block_radius.resize(padded(blocks));
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t end = std::min(clusters.size(), kLanes * (b + 1));
    const auto center = [&](std::size_t i) {
      return Eigen::Vector3d(static_cast<double>(clusters[i].center[0]),
                             static_cast<double>(clusters[i].center[1]),
                             static_cast<double>(clusters[i].center[2]));
    };
    Eigen::Vector3d low = center(kLanes * b), high = low;
    for (std::size_t i = kLanes * b; i < end; ++i) {
      const Eigen::Vector3d reach =
          Eigen::Vector3d::Constant(static_cast<double>(clusters[i].radius));
      low = low.cwiseMin(center(i) - reach);
      high = high.cwiseMax(center(i) + reach);
    }
    const Eigen::Vector3d middle = 0.5 * (low + high);
    double radius = 0.0;
    for (std::size_t i = kLanes * b; i < end; ++i) {
      radius =
          std::max(radius, (center(i) - middle).norm() + static_cast<double>(clusters[i].radius));
    }
    for (std::size_t d = 0; d < 3; ++d)
      store.block_center[d].data[b] = static_cast<float>(middle[static_cast<int>(d)]);
    store.block_radius.data[b] = static_cast<float>(radius + 2e-6);
  }
}

void SelfCollision::Impl::add_bodies(const RobotGeometry& geometry) {
  body_of = geometry.of_link;
  stores.resize(geometry.links.size());
  std::size_t most = 0;
  for (std::size_t i = 0; i < geometry.links.size(); ++i) {
    const LinkGeometry& g = geometry.links[i];
    Body& store = stores[i];
    store.clusters = g.clusters;
    const std::size_t count = padded(g.clusters.size());
    most = std::max(most, count);
    for (Aligned& c : store.center) c.resize(count, 1e9F);
    for (auto* row : {&store.box_middle, &store.box_low, &store.box_high}) {
      for (Aligned& c : *row) c.resize(count, 1e9F);
    }
    for (Aligned& c : store.box_half) c.resize(count);
    store.radius.resize(count);
    for (std::size_t c = 0; c < g.clusters.size(); ++c) {
      const TriangleCluster& cluster = g.clusters[c];
      std::array<float, 4> middle{}, half{};
      for (std::size_t d = 0; d < 3; ++d) {
        store.center[d].data[c] = cluster.center[d];
        middle[d] = 0.5F * (cluster.low[d] + cluster.high[d]);
        half[d] = 0.5F * (cluster.high[d] - cluster.low[d]) + 1e-6F;
        store.box_middle[d].data[c] = middle[d];
        store.box_half[d].data[c] = half[d];
        store.box_low[d].data[c] = middle[d] - half[d];
        store.box_high[d].data[c] = middle[d] + half[d];
      }
      store.radius.data[c] = cluster.radius;
      store.middle.push_back(middle);
      store.half.push_back(half);
    }
    for (const TriangleCluster& c : g.clusters) store.triangle_boxes.push_back(boxes_of(c));
    group(store, g.clusters);
    const std::vector<Eigen::Vector3d>& corners = g.hull.points;
    for (int d = 0; d < 3; ++d) {
      store.hull[d].resize(padded(corners.size()));
      for (std::size_t c = 0; c < padded(corners.size()); ++c)
        store.hull[d].data[c] = static_cast<float>(corners[std::min(c, corners.size() - 1)][d]);
    }
    for (const Eigen::Vector3d& p : g.witnesses) {
      store.witness.push_back(
          {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), 0.0F});
    }
    CollisionBody body{};
    set4(g.sphere.center, g.sphere.radius, body.sphere);
    set4(g.capsule.a, g.capsule.radius, body.from);
    set4(g.capsule.b, g.capsule.radius, body.to);
    set4(g.low, 0.0, body.low);
    set4(g.high, 0.0, body.high);
    body.link = g.link;
    body.clusters = static_cast<int>(g.clusters.size());
    body.hull_corners = static_cast<int>(padded(corners.size()));
    bodies.push_back(body);
  }
  tables.most_clusters = static_cast<int>(most);
}

void SelfCollision::Impl::want(const CollisionPair& pair, bool on) noexcept {
  int a = body_of[at(pair.link_a)], b = body_of[at(pair.link_b)];
  if (a > b) std::swap(a, b);
  unsigned char& byte = wanted[at(a * tables.blocks + b / kLanes)];
  const auto mask = static_cast<unsigned char>(1U << (b % kLanes));
  byte = static_cast<unsigned char>(on ? byte | mask : byte & ~mask);
}

void SelfCollision::Impl::add_pairs(const RobotGeometry& geometry) {
  const int n = static_cast<int>(bodies.size());
  tables.bodies = n;
  tables.blocks = static_cast<int>(padded(bodies.size())) / kLanes;
  wanted.assign(at(n * tables.blocks), 0);
  pair_of.assign(at(n * n), -1);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const int links = static_cast<int>(geometry.of_link.size());
    const CollisionPair& pair = pairs[p];
    if (pair.link_a < 0 || pair.link_b < 0 || pair.link_a >= links || pair.link_b >= links ||
        pair.link_a == pair.link_b || body_of[at(pair.link_a)] < 0 || body_of[at(pair.link_b)] < 0)
      throw std::invalid_argument("SelfCollision: a pair names a link without geometry");
    const int a = body_of[at(pair.link_a)], b = body_of[at(pair.link_b)];
    pair_of[at(a * n + b)] = pair_of[at(b * n + a)] = static_cast<int>(p);
    want(pair, true);
  }
}

void SelfCollision::Impl::connect() {
  const std::size_t count = padded(bodies.size());
  placed.resize(11 * count);
  for (int k = 0; k < 4; ++k) tables.sphere[k] = placed.data + at(k) * count;
  for (int k = 0; k < 3; ++k) {
    tables.from[k] = placed.data + at(4 + k) * count;
    tables.to[k] = placed.data + at(7 + k) * count;
  }
  tables.capsule_radius = placed.data + 10 * count;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    CollisionBody& body = bodies[i];
    Body& store = stores[i];
    for (int d = 0; d < 3; ++d) body.center[d] = store.center[d].data;
    body.radius = store.radius.data;
    for (int d = 0; d < 3; ++d) body.block_center[d] = store.block_center[d].data;
    body.block_radius = store.block_radius.data;
    for (int d = 0; d < 3; ++d) {
      body.hull[d] = store.hull[d].data;
      body.box_middle[d] = store.box_middle[d].data;
      body.box_half[d] = store.box_half[d].data;
      body.box_low[d] = store.box_low[d].data;
      body.box_high[d] = store.box_high[d].data;
    }
    body.triangle_boxes = store.triangle_boxes.data();
    body.cluster = store.clusters.data();
    body.middle = reinterpret_cast<const float(*)[4]>(store.middle.data());
    body.half = reinterpret_cast<const float(*)[4]>(store.half.data());
    body.witness = reinterpret_cast<const float(*)[4]>(store.witness.data());
    body.witnesses = static_cast<int>(store.witness.size());
    tables.sphere[3][i] = body.sphere[3];
    tables.capsule_radius[i] = body.from[3];
  }
  near.resize(pairs.size() + kLanes);
  hits.assign(pairs.size() + 1, 0);
  memory.assign(pairs.size(), {});
  bound.resize(padded(pairs.size()) + kLanes);
  kept.resize(14 * at(tables.most_clusters) + kLanes);
  open.assign(at(tables.most_clusters) / kLanes + 1, 0);
  tables.joint = joints.data();
  tables.joints = static_cast<int>(joints.size());
  tables.body = bodies.data();
  tables.wanted = wanted.data();
  tables.pair_of = pair_of.data();
  tables.q = angle.data();
  tables.sine = sine.data();
  tables.cosine = cosine.data();
  tables.pose = poses.data();
  tables.near = near.data();
  tables.hit = hits.data();
  tables.bound = bound.data;
  tables.kept = kept.data;
  tables.open = open.data();
  tables.memory = memory.data();
  tables.work = work;
}

SelfCollision::SelfCollision(const Model& model, const RobotGeometry& geometry)
    : SelfCollision(model, geometry, pairs_to_check(model)) {}
SelfCollision::SelfCollision(const Model& model, const RobotGeometry& geometry,
                             const std::vector<CollisionPair>& pairs)
    : impl_(std::make_unique<Impl>(model, geometry, pairs)) {
  place(Eigen::VectorXd::Zero(model.joint_count()));
}
SelfCollision::~SelfCollision() = default;

const std::vector<CollisionPair>& SelfCollision::pairs() const noexcept { return impl_->pairs; }

TWINBUS_AVX2_CLONES
static void sines(const double* angle, std::size_t count, double* sine, double* cosine) noexcept {
  for (std::size_t k = 0; k < count; k += 4) {
    Vec4 s, c;
    sine_cosine(load4(angle + k), s, c);
    store4(sine + k, s);
    store4(cosine + k, c);
  }
}

void SelfCollision::place(const Eigen::VectorXd& q) noexcept {
  Impl& i = *impl_;
  const double* from = q.data();
  bool large = false;
  for (std::size_t j = 0; j < i.joints.size(); ++j) {
    i.angle[j] = from[i.joints[j].index];
    large = large || !(std::abs(i.angle[j]) <= kMostAngle);
  }
  sines(i.angle.data(), i.angle.size(), i.sine.data(), i.cosine.data());
  for (std::size_t j = 0; large && j < i.joints.size(); ++j) {
    i.sine[j] = std::sin(i.angle[j]);
    i.cosine[j] = std::cos(i.angle[j]);
  }
  TWINBUS_LANES(kinematics(i.tables));
}

int SelfCollision::touching() noexcept {
  Impl& i = *impl_;
  return TWINBUS_LANES(collide(i.tables, false));
}

const int* SelfCollision::hit() const noexcept { return impl_->hits.data(); }

bool SelfCollision::any_touching() noexcept {
  Impl& i = *impl_;
  return TWINBUS_LANES(collide(i.tables, true)) > 0;
}

bool SelfCollision::touches(int pair) noexcept {
  Impl& i = *impl_;
  const CollisionPair& links = i.pairs[at(pair)];
  return TWINBUS_LANES(
      bodies_touch(i.tables, i.body_of[at(links.link_a)], i.body_of[at(links.link_b)], true));
}

bool SelfCollision::surfaces_cross(int pair) noexcept {
  Impl& i = *impl_;
  const CollisionPair& links = i.pairs[at(pair)];
  return TWINBUS_LANES(
      bodies_touch(i.tables, i.body_of[at(links.link_a)], i.body_of[at(links.link_b)], false));
}

double SelfCollision::lower_bound(int pair) noexcept {
  Impl& i = *impl_;
  const CollisionPair& links = i.pairs[at(pair)];
  i.near[0] = {i.body_of[at(links.link_a)], i.body_of[at(links.link_b)]};
  TWINBUS_LANES(capsule_bounds(i.tables, 1));
  return static_cast<double>(i.tables.bound[0]);
}

void SelfCollision::lower_bounds(float* bounds) noexcept {
  Impl& i = *impl_;
  const int n = static_cast<int>(i.pairs.size());
  for (int p = 0; p < n; ++p)
    i.near[at(p)] = {i.body_of[at(i.pairs[at(p)].link_a)], i.body_of[at(i.pairs[at(p)].link_b)]};
  TWINBUS_LANES(capsule_bounds(i.tables, n));
  std::copy_n(i.tables.bound, n, bounds);
}

void SelfCollision::enable(int pair, bool on) noexcept { impl_->want(impl_->pairs[at(pair)], on); }

void SelfCollision::use(InstructionSet set) noexcept {
  impl_->set = std::min(set, best_instruction_set());
}

const SelfCollision::Work& SelfCollision::work() const noexcept {
  Impl& i = *impl_;
  i.counters = {i.work[0], i.work[1], i.work[2], i.work[3]};
  return i.counters;
}

}  // namespace twinbus
