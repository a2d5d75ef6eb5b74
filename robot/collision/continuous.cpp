#include "robot/collision/continuous.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "common/math/index.h"
#include "common/simd/instruction_set.h"
#include "geometry/distance/body_data.h"
#include "common/simd/vec4.h"

namespace twinbus::inline robot {

namespace {

constexpr float kInsideSlack = 2e-5F;  // of a ball in a hull, whose faces rounding moves [m]

struct SweptHinge {  // rotation: still + cosine with_cosine + sine with_sine, by columns
  float still[3][3], with_cosine[3][3], with_sine[3][3], offset[3], slide[3];
  int parent = 0;
  bool turns = true;
};

struct SweptPart {
  enum Kind { kBall, kCylinder, kBox } kind = kBall;
  int link = -1;
  float half[3] = {}, radius = 0.0F;  // of the shape; of the ball around it
  float column[3][3] = {}, origin[3] = {};
  bool turned = true;             // against the link
  const float* corner = nullptr;  // x of all, y of all, z of all
  int corners = 0;
  // Which of them can be the farthest along the directions of a cell (support_cells.h): where the row of each begins, and ends,
  // counted from here; then the rows, of a multiple of four.  Null: not known.
  const std::uint16_t* cell = nullptr;
  float inside[3] = {}, inside_radius = 0.0F;  // a ball inside of it, as far as rounding can say
  float beyond_middle = 0.0F;  // no surface is farther from a point outside than its middle and this [m]
};

struct SweptPair {
  int a = 0, b = 0;
  int link_a = 0, link_b = 0, common = 0;  // the last link that both hang on
  float n[3] = {1.0F, 0.0F, 0.0F};         // that parted them, in its axes
};

// Rows of eight numbers, one for every place.
struct SweptTables {
  int links = 0, joints = 0, parts = 0;
  const SweptHinge* hinge = nullptr;
  const SweptPart* part = nullptr;
  SweptPair* pair = nullptr;
  const int* pair_of = nullptr;                      // [parts x parts], a < b
  const float* reach = nullptr;                      // [links x joints]
  const float *radius = nullptr, *length = nullptr;  // of links; of the stretched chain to them
  unsigned char *stale = nullptr,  // a link is not where its joints say, nor what it leaves out
      *fresh = nullptr, *asked = nullptr;  // it has just been put there; it is to be
  float *sine = nullptr, *cosine = nullptr, *slide = nullptr, *moves = nullptr, *bend = nullptr,
        *left = nullptr;                             // [joints]
  float *link_pose = nullptr, *part_pose = nullptr;  // [x 12: columns, then origin]
  float *turn = nullptr, *link_left_out = nullptr;   // [links]
  float* sums = nullptr;                             // [links x 4]
  float* half_travel = nullptr;                      // of a link, one number
};

}  // namespace

// clang-format off
#define TWINBUS_WIDE 0
namespace baseline_swept {
#include "common/simd/float8.h"
#include "robot/collision/continuous_extent.h"
#include "robot/collision/continuous_lanes.h"
#include "robot/collision/continuous_open.h"
}  // namespace baseline_swept
#undef TWINBUS_WIDE
#ifdef __x86_64__
#define TWINBUS_WIDE 1
#include "common/simd/begin_avx2.h"
namespace avx2_swept {
#include "common/simd/float8.h"
#include "robot/collision/continuous_extent.h"
#include "robot/collision/continuous_lanes.h"
#include "robot/collision/continuous_open.h"
}  // namespace avx2_swept
#include "common/simd/end_target.h"
// No wider: of more registers, and of bits that say which lanes.
#include "common/simd/begin_avx512.h"
namespace avx512_swept {
#include "common/simd/float8.h"
#include "robot/collision/continuous_extent.h"
#include "robot/collision/continuous_lanes.h"
#include "robot/collision/continuous_open.h"
}  // namespace avx512_swept
#include "common/simd/end_target.h"
#undef TWINBUS_WIDE
#define TWINBUS_SWEPT(call)                                \
  (set == InstructionSet::kAvx512 ? avx512_swept::call     \
   : set == InstructionSet::kAvx2 ? avx2_swept::call : baseline_swept::call)
#else
#define TWINBUS_SWEPT(call) (static_cast<void>(set), baseline_swept::call)
#endif
// clang-format on

namespace {

TWINBUS_INLINE void store_single(float* to, const Vec4& v) noexcept {
  for (std::size_t i = 0; i < 4; ++i) to[i] = static_cast<float>(v[i]);
}

// Of a joint what it is at all places, its sines and by how much it moves to the next; are the angles
// small enough for these sines?
TWINBUS_AVX2_CLONES
bool turn(const double* q, float* slide, float* moves, float* sine, float* cosine) noexcept {
  const Vec4 angles[2] = {load4(q), load4(q + 4)};
  const Vec4 next[2] = {__builtin_shufflevector(angles[0], angles[1], 1, 2, 3, 4),
                        __builtin_shufflevector(angles[1], angles[1], 1, 2, 3, 3)};
  bool small = true;
  for (std::size_t half = 0; half < 2; ++half) {
    const Vec4 &angle = angles[half], step = next[half] - angle;
    Vec4 s, c;
    sine_cosine(angle, s, c);
    store_single(sine + 4 * half, s);
    store_single(cosine + 4 * half, c);
    store_single(slide + 4 * half, angle);
    store_single(moves + 4 * half, step < 0.0 ? -step : step);
    for (int i = 0; i < 4; ++i) small = small && std::abs(angle[i]) <= kMostAngle;
  }
  return small;
}

void take(const Eigen::Matrix3d& from, float (&to)[3][3]) {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) to[c][r] = static_cast<float>(from(r, c));
}
void take(const Eigen::Vector3d& from, float (&to)[3]) {
  for (int r = 0; r < 3; ++r) to[r] = static_cast<float>(from[r]);
}
// The same pose at all places.
void spread(const Eigen::Isometry3d& pose, float* to) noexcept {
  for (int k = 0; k < 12; ++k)
    std::fill_n(
        to + 8 * k, 8,
        static_cast<float>(k < 9 ? pose.linear()(k % 3, k / 3) : pose.translation()[k - 9]));
}

// As SweptPart::cell.
std::vector<std::uint16_t> corners_of_cells(const GjkShape& hull) {
  if (hull.cells.empty()) return {};
  const std::size_t n = hull.points.size() / 3;
  const auto point = [&](std::size_t k) { return std::array{hull.points[k], hull.points[n + k], hull.points[2 * n + k]}; };
  std::vector<std::uint16_t> order(n), result(at(kSupportCells) + 1);
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint16_t a, std::uint16_t b) { return point(a) < point(b); });
  for (int cell = 0; cell < kSupportCells; ++cell) {
    result[at(cell)] = static_cast<std::uint16_t>(result.size());
    const double* p = hull.cells.points(at(cell));
    const std::size_t row = hull.cells.size(at(cell));
    std::size_t last = row;  // the last one is there again and again
    const auto same = [&](std::size_t i, std::size_t k) {
      return p[i] == p[k] && p[row + i] == p[row + k] && p[2 * row + i] == p[2 * row + k];
    };
    while (last > 1 && same(last - 2, row - 1)) --last;
    for (std::size_t i = 0; i < (last + 3) / 4 * 4; ++i) {
      const std::array corner{p[i], p[row + i], p[2 * row + i]};
      result.push_back(*std::lower_bound(order.begin(), order.end(), corner,
                                         [&](std::uint16_t a, const std::array<double, 3>& c) { return point(a) < c; }));
    }
  }
  result[at(kSupportCells)] = static_cast<std::uint16_t>(result.size());
  return result;
}

}  // namespace

struct SweptShapes::Impl {
  const Model* model;
  std::vector<SweptHinge> hinges;
  std::vector<SweptPart> parts;
  std::vector<Eigen::Isometry3d> still;  // poses of parts in the world
  std::vector<SweptPair> pairs;
  std::vector<int> pair_of;
  std::vector<float> reach, radius, length, numbers, corners;
  std::vector<std::vector<std::uint16_t>> cells;  // of the parts; empty: of no hull, or of one that has none
  std::vector<unsigned char> stale, fresh, asked;
  std::vector<std::array<double, kPlaces>> angles;  // that sines are of
  SweptTables tables;
  Eigen::Matrix3d base = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  bool never = true;  // gone anywhere
  InstructionSet set = best_instruction_set();

  int common_link(int a, int b) const {
    a = std::max(a, 0);
    b = std::max(b, 0);
    while (a != b) {
      int& later = a > b ? a : b;
      later = model->links[at(later)].parent;
    }
    return a;
  }
  Eigen::Matrix3d turn_of(int link, int place) const noexcept {
    Eigen::Matrix3d m;
    for (int k = 0; k < 9; ++k)
      m(k % 3, k / 3) = static_cast<double>(tables.link_pose[96 * link + 8 * k + place]);
    return m;
  }
  void direction(const SweptPair& pair, const Eigen::Vector3d& world, int place,
                 float (&n)[3]) const noexcept {
    const Eigen::Vector3d in = turn_of(pair.common, place).transpose() * world;
    for (int d = 0; d < 3; ++d) n[d] = static_cast<float>(in[d]);
  }
  void lay_out();
  void set_base(const Eigen::Isometry3d& to) noexcept;
};

// All rows one after the other.
void SweptShapes::Impl::lay_out() {
  SweptTables& t = tables;
  t.links = model->link_count();
  t.joints = model->joint_count();
  t.parts = static_cast<int>(parts.size());
  numbers.assign(8 * (at(t.joints) * 6 + at(t.links) * 18 + parts.size() * 12) + at(t.links), 0.0F);
  float* next = numbers.data();
  const auto rows = [&](float*& row, std::size_t count) {
    row = next;
    next += 8 * count;
  };
  for (float** row : {&t.sine, &t.cosine, &t.slide, &t.moves, &t.bend, &t.left})
    rows(*row, at(t.joints));
  rows(t.link_pose, 12 * at(t.links));
  for (float** row : {&t.turn, &t.link_left_out}) rows(*row, at(t.links));
  rows(t.sums, 4 * at(t.links));
  rows(t.part_pose, 12 * parts.size());
  t.half_travel = next;
  t.hinge = hinges.data();
  t.part = parts.data();
  t.reach = reach.data();
  t.radius = radius.data();
  t.length = length.data();
  stale.assign(at(t.links), 1);
  t.stale = stale.data();
  fresh.assign(at(t.links), 0);
  t.fresh = fresh.data();
  asked.assign(at(t.links), 1);
  t.asked = asked.data();
  angles.assign(at(t.joints), {});
  never = true;
  std::fill_n(t.cosine, 8 * t.joints, 1.0F);
}

SweptShapes::SweptShapes(const Model& model, const JointReach& reach)
    : impl_(std::make_unique<Impl>()) {
  Impl& i = *impl_;
  i.model = &model;
  for (const Joint& joint : model.joints) {
    SweptHinge hinge{};
    hinge.parent = joint.parent;
    hinge.turns = joint.kind != JointKind::kPrismatic;
    const Eigen::Matrix3d placed = joint.placement.linear();
    const Eigen::Vector3d& a = joint.axis;
    const Eigen::Matrix3d along = a * a.transpose();
    Eigen::Matrix3d across;
    across << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    take(hinge.turns ? placed * along : placed, hinge.still);
    if (hinge.turns) {
      take(placed * (Eigen::Matrix3d::Identity() - along), hinge.with_cosine);
      take(placed * across, hinge.with_sine);
    } else {
      take(Eigen::Vector3d(placed * a), hinge.slide);
    }
    take(Eigen::Vector3d(joint.placement.translation()), hinge.offset);
    i.hinges.push_back(hinge);
  }
  for (int link = 0; link < model.link_count(); ++link) {
    for (int joint = 0; joint < model.joint_count(); ++joint)
      i.reach.push_back(static_cast<float>(reach.of(link, joint)) * 1.0001F);
    i.radius.push_back(static_cast<float>(reach.radius(link)));
    i.length.push_back(static_cast<float>(reach.length(link)));
  }
}
SweptShapes::~SweptShapes() = default;

void SweptShapes::set(const std::vector<Part>& parts) {
  Impl& i = *impl_;
  i.parts.clear();
  i.still.clear();
  i.pairs.clear();
  i.corners.clear();
  i.cells.assign(parts.size(), {});
  for (const Part& from : parts) {
    SweptPart part;
    part.link = from.link;
    part.kind = from.shape->kind == ShapeKind::kSphere     ? SweptPart::kBall
                : from.shape->kind == ShapeKind::kCylinder ? SweptPart::kCylinder
                                                           : SweptPart::kBox;
    take(from.shape->half, part.half);
    part.radius = static_cast<float>(from.shape->radius()) * 1.0001F;
    take(Eigen::Matrix3d(from.local.linear()), part.column);
    part.turned = from.local.linear() != Eigen::Matrix3d::Identity();
    take(Eigen::Vector3d(from.local.translation()), part.origin);
    if (from.hull != nullptr) {
      i.cells[i.parts.size()] = corners_of_cells(*from.hull);
      const std::size_t n = from.hull->points.size() / 3;
      part.corners = static_cast<int>((n + 7) / 8 * 8);  // the last one again and again
      for (std::size_t k = 0; k < 3 * at(part.corners); ++k) {
        const std::size_t row = k / at(part.corners), corner = std::min(k % at(part.corners), n - 1);
        i.corners.push_back(static_cast<float>(from.hull->points[row * n + corner]));
      }
      take(from.inside.center, part.inside);
      part.inside_radius = static_cast<float>(from.inside.radius) - kInsideSlack;
    } else {
      const auto sizes = from.shape->kind == ShapeKind::kBox ? 3 : from.shape->kind == ShapeKind::kCylinder ? 2 : 1;
      part.inside_radius = static_cast<float>(from.shape->half.head(sizes).minCoeff()) - kInsideSlack;
    }
    part.beyond_middle = static_cast<float>(from.inside.center.norm()) * 1.0001F - part.inside_radius;
    i.parts.push_back(part);
    i.still.push_back(from.local);
  }
  const float* corner = i.corners.data();
  for (SweptPart& part : i.parts) {
    part.corner = corner;
    const auto& cells = i.cells[at(static_cast<int>(&part - i.parts.data()))];
    part.cell = cells.empty() ? nullptr : cells.data();
    corner += 3 * part.corners;
  }
  i.pair_of.assign(parts.size() * parts.size(), -1);
  i.tables.pair_of = i.pair_of.data();
  i.lay_out();
}

void SweptShapes::want(int a, int b) {
  Impl& i = *impl_;
  SweptPair pair;
  pair.a = a;
  pair.b = b;
  pair.common = i.common_link(i.parts[at(a)].link, i.parts[at(b)].link);
  pair.link_a = std::max(i.parts[at(a)].link, 0);
  pair.link_b = std::max(i.parts[at(b)].link, 0);
  i.pair_of[at(a) * i.parts.size() + at(b)] = static_cast<int>(i.pairs.size());
  i.pairs.push_back(pair);
  i.tables.pair = i.pairs.data();
}

void SweptShapes::Impl::set_base(const Eigen::Isometry3d& to) noexcept {
  const bool turns = never || to.linear() != base;
  tables.fresh[0] = turns ? 1 : 0;
  if (!turns && to.translation() == origin) return;
  never = false;
  base = to.linear();
  origin = to.translation();
  Eigen::Isometry3d turned = to;
  turned.translation().setZero();
  spread(turned, tables.link_pose);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].link >= 0) continue;
    Eigen::Isometry3d pose = still[p];
    pose.translation() -= origin;
    spread(pose, tables.part_pose + 96 * p);
  }
}

void SweptShapes::go(const Eigen::Isometry3d& base, const Way& way) noexcept {
  Impl& i = *impl_;
  SweptTables& t = i.tables;
  const InstructionSet set = i.set;
  for (std::size_t j = 0; j < way.q.size(); ++j) {
    t.asked[j + 1] = way.asked[j];
    if (way.asked[j] == 0) continue;
    const auto& q = way.q[j];
    float* bend = t.bend + 8 * j;
    if (!std::equal(way.bend[j].begin(), way.bend[j].end(), bend)) {
      std::copy(way.bend[j].begin(), way.bend[j].end(), bend);
      t.stale[j + 1] = 1;
    }
    if (q == i.angles[j]) continue;
    t.stale[j + 1] = 1;
    i.angles[j] = q;
    if (turn(q.data(), t.slide + 8 * j, t.moves + 8 * j, t.sine + 8 * j, t.cosine + 8 * j))
      continue;
    for (std::size_t k = 0; k < at(kPlaces); ++k) {
      t.sine[8 * j + k] = static_cast<float>(std::sin(q[k]));
      t.cosine[8 * j + k] = static_cast<float>(std::cos(q[k]));
    }
  }
  i.set_base(base);
  TWINBUS_SWEPT(go(t));
  TWINBUS_SWEPT(leave_out(t));
}

int SweptShapes::open(std::span<const NearShapes::Candidate> shapes, double margin, double clear,
                      int* pairs, int capacity) noexcept {
  const InstructionSet set = impl_->set;
  return TWINBUS_SWEPT(open_pairs(impl_->tables, shapes.data(), static_cast<int>(shapes.size()),
                                  static_cast<float>(margin), static_cast<float>(clear), pairs,
                                  capacity));
}

SweptShapes::Shapes SweptShapes::shapes(int pair) const noexcept {
  return {impl_->pairs[at(pair)].a, impl_->pairs[at(pair)].b};
}

Eigen::Isometry3d SweptShapes::pose(int shape, int place) const noexcept {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const float* from = impl_->tables.part_pose + 96 * shape + place;
  for (int k = 0; k < 12; ++k) {
    (k < 9 ? pose.linear()(k % 3, k / 3) : pose.translation()[k - 9]) =
        static_cast<double>(from[8 * k]);
  }
  pose.translation() += impl_->origin;
  return pose;
}

Eigen::Vector3d SweptShapes::remembered(int pair, int place) const noexcept {
  const SweptPair& p = impl_->pairs[at(pair)];
  return impl_->turn_of(p.common, place) * Eigen::Vector3d(static_cast<double>(p.n[0]),
                                                           static_cast<double>(p.n[1]),
                                                           static_cast<double>(p.n[2]));
}

void SweptShapes::remember(int pair, const Eigen::Vector3d& direction, int place) noexcept {
  SweptPair& p = impl_->pairs[at(pair)];
  impl_->direction(p, direction, place, p.n);
}

SweptShapes::AtPlaces SweptShapes::gaps(int pair, const Eigen::Vector3d& direction,
                                        int place) const noexcept {
  const SweptPair& p = impl_->pairs[at(pair)];
  const InstructionSet set = impl_->set;
  float n[3];
  impl_->direction(p, direction, place, n);
  AtPlaces result;
  TWINBUS_SWEPT(pair_gaps(impl_->tables, p, n, result.data()));
  return result;
}

SweptShapes::Bounds SweptShapes::bounds(int pair) const noexcept {
  const InstructionSet set = impl_->set;
  Bounds b;
  TWINBUS_SWEPT(pair_bounds(impl_->tables, impl_->pairs[at(pair)], b.gaps.data(), b.left_out.data(), b.most_apart.data(),
                            b.travel.data()));
  return b;
}

}  // namespace twinbus::robot
