#include "robot/collision/exact/self_collision.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "common/simd/vec4.h"
#include "robot/collision/collision_pairs.h"
#include "robot/collision/exact/self_collision_body.h"
#include "robot/collision/exact/self_collision_data.h"

namespace twinbus::inline robot {

// clang-format off
#define TWINBUS_WIDE 0
namespace baseline_lanes {
#include "common/simd/float8.h"
#include "geometry/distance/capsule_lanes.h"
#include "robot/collision/exact/self_collision_far.h"
#include "geometry/distance/triangle_sat.h"
#include "robot/collision/exact/self_collision_hulls.h"
#include "robot/collision/exact/self_collision_overlap.h"
#include "robot/collision/exact/self_collision_inside.h"
#include "robot/collision/exact/self_collision_boxes.h"
#include "robot/collision/exact/self_collision_cells.h"
#include "robot/collision/exact/self_collision_near.h"
}  // namespace baseline_lanes
#undef TWINBUS_WIDE
#ifdef __x86_64__
#define TWINBUS_WIDE 1
#include "common/simd/begin_avx2.h"
namespace avx2_lanes {
#include "common/simd/float8.h"
#include "geometry/distance/capsule_lanes.h"
#include "robot/collision/exact/self_collision_far.h"
#include "geometry/distance/triangle_sat.h"
#include "robot/collision/exact/self_collision_hulls.h"
#include "robot/collision/exact/self_collision_overlap.h"
#include "robot/collision/exact/self_collision_inside.h"
#include "robot/collision/exact/self_collision_boxes.h"
#include "robot/collision/exact/self_collision_cells.h"
#include "robot/collision/exact/self_collision_near.h"
}  // namespace avx2_lanes
#include "common/simd/end_target.h"
#include "common/simd/begin_avx512.h"
namespace avx512_lanes {
#include "common/simd/float8.h"
#include "geometry/distance/capsule_lanes.h"
#include "robot/collision/exact/self_collision_far.h"
#include "geometry/distance/triangle_sat.h"
#include "robot/collision/exact/self_collision_hulls.h"
#include "robot/collision/exact/self_collision_overlap.h"
#include "robot/collision/exact/self_collision_inside.h"
#include "robot/collision/exact/self_collision_boxes.h"
#include "robot/collision/exact/self_collision_cells.h"
#include "robot/collision/exact/self_collision_near.h"
}  // namespace avx512_lanes
#include "common/simd/end_target.h"
#undef TWINBUS_WIDE
#define TWINBUS_LANES(call)                                        \
  (i.set == InstructionSet::kAvx512 ? avx512_lanes::call           \
   : i.set == InstructionSet::kAvx2 ? avx2_lanes::call : baseline_lanes::call)
#else
#define TWINBUS_LANES(call) (baseline_lanes::call)
#endif
// clang-format on

struct SelfCollision::Impl {
  std::vector<CollisionPair> pairs;
  std::vector<CollisionJoint> joints;
  std::vector<CollisionBody> bodies;
  std::vector<CollisionBodyStore> stores;
  std::vector<unsigned char> wanted;
  std::vector<int> pair_of, body_of;
  std::vector<CollisionPose> poses;
  std::vector<double> angle, sine, cosine;
  AlignedNumbers placed;
  std::vector<CollisionCandidate> near;
  std::vector<int> hits;
  std::vector<CollisionMemory> memory;
  std::vector<JointCells> joint_cells;
  std::vector<CollisionCells> cells;
  AlignedNumbers bound, kept;
  std::vector<int> open;
  Work counters;
  long work[4] = {};
  CollisionTables tables;
  InstructionSet set = best_instruction_set();

  Impl(const Model& model, const RobotGeometry& geometry,
       const std::vector<CollisionPair>& wanted_pairs)
      : pairs(wanted_pairs) {
    add_joints(model, geometry);
    add_bodies(geometry);
    add_pairs(model, geometry);
    connect();
  }

  void add_joints(const Model& model, const RobotGeometry& geometry);
  void add_bodies(const RobotGeometry& geometry);
  void add_pairs(const Model& model, const RobotGeometry& geometry);
  void connect();
  void want(const CollisionPair& pair, bool on) noexcept;
  void take(std::vector<JointCells>&& found);
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

void SelfCollision::Impl::add_bodies(const RobotGeometry& geometry) {
  body_of = geometry.of_link;
  for (const LinkGeometry& link : geometry.links) {
    const bool asked = std::any_of(pairs.begin(), pairs.end(), [&](const CollisionPair& pair) {
      return pair.link_a == link.link || pair.link_b == link.link;
    });
    stores.emplace_back(link, asked);
    bodies.push_back(stores.back().view());
    tables.most_clusters =
        std::max(tables.most_clusters, static_cast<int>(padded_lanes(link.clusters.size())));
  }
}

void SelfCollision::Impl::want(const CollisionPair& pair, bool on) noexcept {
  int a = body_of[at(pair.link_a)], b = body_of[at(pair.link_b)];
  if (a > b) std::swap(a, b);
  unsigned char& byte = wanted[at(a * tables.blocks + b / kCollisionLanes)];
  const auto mask = static_cast<unsigned char>(1U << (b % kCollisionLanes));
  byte = static_cast<unsigned char>(on ? byte | mask : byte & ~mask);
}

void SelfCollision::Impl::add_pairs(const Model& model, const RobotGeometry& geometry) {
  const int n = static_cast<int>(bodies.size());
  tables.bodies = n;
  tables.blocks = static_cast<int>(padded_lanes(bodies.size())) / kCollisionLanes;
  wanted.assign(at(n * tables.blocks), 0);
  pair_of.assign(at(n * n), -1);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const int links = static_cast<int>(geometry.of_link.size());
    const CollisionPair& pair = pairs[p];
    if (pair.link_a < 0 || pair.link_b < 0 || pair.link_a >= links || pair.link_b >= links ||
        pair.link_a == pair.link_b)
      throw std::invalid_argument("a pair of links to be checked does not exist");
    for (const int link : {pair.link_a, pair.link_b}) {
      if (body_of[at(link)] >= 0) continue;
      throw std::runtime_error(
          "robot " + model.name + ": link " + model.links[at(link)].name +
          ": no triangle of its collision shapes is large enough to be touched; "
          "give its <collision> another shape or remove it");
    }
    const int a = body_of[at(pair.link_a)], b = body_of[at(pair.link_b)];
    pair_of[at(a * n + b)] = pair_of[at(b * n + a)] = static_cast<int>(p);
    want(pair, true);
  }
}

// bodies_touch looks at the clusters of the body that has fewer, one after the other.
void SelfCollision::Impl::take(std::vector<JointCells>&& found) {
  if (found.size() != pairs.size())
    throw std::invalid_argument("SelfCollision: joint cells of other pairs");
  joint_cells = std::move(found);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    JointCells& from = joint_cells[p];
    CollisionCells& to = cells[p];
    to = {};
    for (int k = 0; k < from.joints; ++k) {
      const auto joint = std::find_if(joints.begin(), joints.end(), [&](const CollisionJoint& j) {
        return j.index == from.joint[k];
      });
      to.slot[k] = static_cast<int>(joint - joints.begin());
      to.count[k] = from.count[k];
      to.low[k] = from.low[k];
      to.per_unit[k] = from.per_unit[k];
    }
    const int a = body_of[at(pairs[p].link_a)], b = body_of[at(pairs[p].link_b)];
    const auto [first, second] = std::minmax(a, b);
    const bool swapped = bodies[at(first)].clusters > bodies[at(second)].clusters;
    const bool turn = (swapped ? second : first) != a;
    for (std::size_t i = 2; i < from.lists.size();) {
      const std::size_t end = i + 1 + from.lists[i];
      const auto begin = from.lists.begin() + static_cast<std::ptrdiff_t>(i);
      const auto last = from.lists.begin() + static_cast<std::ptrdiff_t>(end);
      for (std::size_t k = i + 1; turn && k < end; ++k)
        from.lists[k] = from.lists[k] << 16 | from.lists[k] >> 16;
      std::sort(begin + 1, last,
                [](std::uint32_t x, std::uint32_t y) { return (x & 0xFFFFU) < (y & 0xFFFFU); });
      i = end;
    }
    to.cell = from.cell.data();
    to.lists = from.lists.data();
    to.joints = from.joints;
  }
}

void SelfCollision::Impl::connect() {
  const std::size_t count = padded_lanes(bodies.size());
  placed.resize(11 * count);
  for (int k = 0; k < 4; ++k) tables.sphere[k] = placed.data + at(k) * count;
  for (int k = 0; k < 3; ++k) {
    tables.from[k] = placed.data + at(4 + k) * count;
    tables.to[k] = placed.data + at(7 + k) * count;
  }
  tables.capsule_radius = placed.data + 10 * count;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    tables.sphere[3][i] = bodies[i].sphere[3];
    tables.capsule_radius[i] = bodies[i].from[3];
  }
  near.resize(pairs.size() + kCollisionLanes);
  hits.assign(pairs.size() + 1, 0);
  memory.assign(pairs.size(), {});
  cells.assign(pairs.size(), {});
  bound.resize(padded_lanes(pairs.size()) + kCollisionLanes);
  kept.resize(14 * at(tables.most_clusters) + kCollisionLanes);
  open.assign(at(tables.most_clusters) / kCollisionLanes + 1, 0);
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
  tables.cells = cells.data();
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
  return TWINBUS_LANES(bodies_touch(i.tables, i.body_of[at(links.link_a)],
                                    i.body_of[at(links.link_b)], true, nullptr));
}

bool SelfCollision::surfaces_cross(int pair) noexcept {
  Impl& i = *impl_;
  const CollisionPair& links = i.pairs[at(pair)];
  return TWINBUS_LANES(bodies_touch(i.tables, i.body_of[at(links.link_a)],
                                    i.body_of[at(links.link_b)], false, nullptr));
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

void SelfCollision::use(std::vector<JointCells> cells) { impl_->take(std::move(cells)); }

void SelfCollision::use(InstructionSet set) noexcept {
  impl_->set = std::min(set, best_instruction_set());
}

const SelfCollision::Work& SelfCollision::work() const noexcept {
  Impl& i = *impl_;
  i.counters = {i.work[0], i.work[1], i.work[2], i.work[3]};
  return i.counters;
}

}  // namespace twinbus::robot
