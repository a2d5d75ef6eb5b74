#include "geometry/distance/broad_phase.h"

#include <algorithm>
#include <cstddef>

#include "common/math/index.h"
#include "common/simd/instruction_set.h"
#include "geometry/distance/body_data.h"
#include "common/simd/vec4.h"

namespace twinbus::inline geometry {

namespace {

constexpr float kFar = 1e9F;         // apart is what is not wanted [m]
constexpr float kNothing = -1e9F;    // is known [m]
constexpr double kLongWalk = 4.0;    // after so much single precision begins anew [m]
constexpr float kKeptSlack = 3e-6F;  // what it may lose until then [m]

struct ShapeTables {
  int shapes = 0, blocks = 0;
  const unsigned char* wanted = nullptr;    // [shapes x blocks], a bit per shape b > a
  float *from[3] = {}, *along[3] = {};      // of the segments, padded to 8
  float *middle[3] = {}, *round = nullptr;  // ball around the capsule
  const float* radius = nullptr;
  float* travel = nullptr;  // that a shape may move on
  int keeping = 0;          // shapes
  float* walked = nullptr;  // by a shape
  float* end = nullptr;     // it may come so far: room
  // A pair stays farther apart than this less what both have walked [shapes x 8 blocks].
  float* until = nullptr;
  NearShapes::Candidate* found = nullptr;
};

}  // namespace

// clang-format off
#define TWINBUS_WIDE 0
namespace baseline_shapes {
#include "common/simd/float8.h"
#include "geometry/distance/capsule_lanes.h"
#include "geometry/distance/broad_phase_lanes.h"
}  // namespace baseline_shapes
#undef TWINBUS_WIDE
#ifdef __x86_64__
#define TWINBUS_WIDE 1
#include "common/simd/begin_avx2.h"
namespace avx2_shapes {
#include "common/simd/float8.h"
#include "geometry/distance/capsule_lanes.h"
#include "geometry/distance/broad_phase_lanes.h"
}  // namespace avx2_shapes
#include "common/simd/end_target.h"
#undef TWINBUS_WIDE
#endif
// clang-format on

struct NearShapes::Impl {
  struct Axis {  // of a capsule, in the frame of its shape
    PaddedVector from, along;
  };
  std::vector<Axis> axes;
  std::vector<float> numbers;
  std::vector<unsigned char> wanted;
  std::vector<float> until;
  std::vector<double> walked;
  double longest = 0.0;  // walk
  std::vector<Candidate> found;
  ShapeTables tables;
  bool wide = best_instruction_set() != InstructionSet::kBaseline;

  void begin_anew() noexcept;
};

NearShapes::NearShapes() : impl_(std::make_unique<Impl>()) {}
NearShapes::~NearShapes() = default;

void NearShapes::set(const std::vector<Capsule>& capsules) {
  Impl& i = *impl_;
  i.axes.resize(capsules.size());
  const std::size_t count = (capsules.size() + 7) / 8 * 8;
  i.numbers.assign(14 * count, 0.0F);
  i.tables.shapes = static_cast<int>(capsules.size());
  i.tables.blocks = static_cast<int>(count / 8);
  i.wanted.assign(at(i.tables.shapes * i.tables.blocks), 0);
  i.tables.wanted = i.wanted.data();
  float* next = i.numbers.data();
  for (auto* row : {&i.tables.from, &i.tables.along, &i.tables.middle}) {
    for (float*& lane : *row) {
      lane = next;
      next += count;
    }
  }
  i.tables.round = next;
  float* radius = next + count;
  i.tables.radius = radius;
  i.tables.travel = radius + count;
  i.tables.walked = radius + 2 * count;
  i.tables.end = radius + 3 * count;
  i.until.resize(capsules.size() * count);
  i.walked.resize(capsules.size());
  for (std::size_t s = 0; s < capsules.size(); ++s) {
    i.axes[s].from.value = capsules[s].a;
    i.axes[s].along.value = capsules[s].b - capsules[s].a;
    radius[s] = static_cast<float>(capsules[s].radius);
    i.tables.round[s] = static_cast<float>(capsules[s].radius +
                                           0.5 * (capsules[s].b - capsules[s].a).norm() + 1e-6);
  }
  i.found.clear();
  keep(0);
}

void NearShapes::want(int a, int b, bool on) {
  Impl& i = *impl_;
  if (a > b) std::swap(a, b);
  unsigned char& byte = i.wanted[at(a * i.tables.blocks + b / 8)];
  const auto mask = static_cast<unsigned char>(1U << (b % 8));
  if (on && (byte & mask) == 0) i.found.emplace_back();  // room for every wanted pair
  byte = static_cast<unsigned char>(on ? byte | mask : byte & ~mask);
}

TWINBUS_AVX2_CLONES
void NearShapes::place(int shape, const Eigen::Isometry3d& pose,
                       const Eigen::Vector3d& origin) noexcept {
  Impl& i = *impl_;
  const std::size_t s = at(shape);
  const Impl::Axis& axis = i.axes[s];
  const Columns turn = columns(pose.data(), 4);
  const Vec4 u = turn.times(load(axis.along));
  const Vec4 a = turn.times(load(axis.from)) + (load4(pose.data() + 12) - vec4(origin));
  for (int d = 0; d < 3; ++d) {
    i.tables.from[d][s] = static_cast<float>(a[d]);
    i.tables.along[d][s] = static_cast<float>(u[d]);
    i.tables.middle[d][s] = static_cast<float>(a[d] + 0.5 * u[d]);
  }
}

void NearShapes::let_move(int shape, double travel) noexcept {
  impl_->tables.travel[at(shape)] = static_cast<float>(travel) * 1.00001F;
}

void NearShapes::keep(int shapes) noexcept {
  Impl& i = *impl_;
  i.tables.keeping = shapes;
  i.longest = 0.0;
  for (std::size_t k = 0; k < i.until.size(); ++k)
    i.until[k] = (i.wanted[k / 8] >> k % 8 & 1U) != 0 ? kNothing : kFar;
  std::fill(i.walked.begin(), i.walked.end(), 0.0);
  std::fill_n(i.tables.walked, 8 * i.tables.blocks, 0.0F);
}

void NearShapes::walk(int shape, double way) noexcept {
  Impl& i = *impl_;
  double& walked = i.walked[at(shape)];
  walked += way;
  i.tables.walked[at(shape)] = static_cast<float>(walked);
  i.longest = std::max(i.longest, walked);
}

void NearShapes::know(int a, int b, double apart) noexcept {
  Impl& i = *impl_;
  if (std::max(a, b) >= i.tables.keeping) return;
  float& until = i.until[at(std::min(a, b) * 8 * i.tables.blocks + std::max(a, b))];
  until =
      std::max(until, static_cast<float>(apart + i.walked[at(a)] + i.walked[at(b)]) - kKeptSlack);
}

// What is kept again counts from a walk of zero, before single precision is too coarse for the sums.
void NearShapes::Impl::begin_anew() noexcept {
  for (int a = 0; a < tables.keeping; ++a) {
    for (int b = a + 1; b < tables.keeping; ++b)
      until[at(a * 8 * tables.blocks + b)] -=
          static_cast<float>(walked[at(a)] + walked[at(b)]) + kKeptSlack;
  }
  std::fill(walked.begin(), walked.end(), 0.0);
  std::fill_n(tables.walked, 8 * tables.blocks, 0.0F);
  longest = 0.0;
}

std::span<NearShapes::Candidate> NearShapes::nearer_than(double reach, double ahead,
                                                         bool by_kept) noexcept {
  Impl& i = *impl_;
  if (i.longest > kLongWalk) i.begin_anew();
  i.tables.found = i.found.data();
  i.tables.until = i.until.data();
  const auto far = static_cast<float>(reach), then = static_cast<float>(ahead);
#ifdef __x86_64__
  auto* const look =
      by_kept ? (i.wide ? avx2_shapes::near_kept_shapes : baseline_shapes::near_kept_shapes)
              : (i.wide ? avx2_shapes::near_shapes : baseline_shapes::near_shapes);
#else
  auto* const look = by_kept ? baseline_shapes::near_kept_shapes : baseline_shapes::near_shapes;
#endif
  const int n = look(i.tables, far, then);
  return {i.found.data(), at(n)};
}

}  // namespace twinbus::geometry
