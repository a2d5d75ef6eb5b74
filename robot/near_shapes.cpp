#include "robot/near_shapes.h"

#include <algorithm>
#include <cstddef>

#include "robot/index.h"
#include "robot/self_collision.h"
#include "robot/self_collision_data.h"
#include "robot/vec4.h"

namespace twinbus {

namespace {

struct ShapeTables {
  int shapes = 0, blocks = 0;
  const unsigned char* wanted = nullptr;    // [shapes x blocks], a bit per shape b > a
  float *from[3] = {}, *along[3] = {};      // of the segments, padded to 8
  float *middle[3] = {}, *round = nullptr;  // ball around the capsule
  const float* radius = nullptr;
  float* travel = nullptr;  // that a shape may move on
  NearShapes::Candidate* found = nullptr;
};

}  // namespace

// clang-format off
#define TWINBUS_WIDE 0
namespace baseline_shapes {
#include "robot/self_collision_lanes.h"
#include "robot/capsule_lanes.h"
#include "robot/near_shapes_lanes.h"
}  // namespace baseline_shapes
#undef TWINBUS_WIDE
#if defined(__x86_64__) && !defined(__clang__)
#define TWINBUS_WIDE 1
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2_shapes {
#include "robot/self_collision_lanes.h"
#include "robot/capsule_lanes.h"
#include "robot/near_shapes_lanes.h"
}  // namespace avx2_shapes
#pragma GCC pop_options
#undef TWINBUS_WIDE
#endif
// clang-format on

struct NearShapes::Impl {
  std::vector<Capsule> capsules;
  std::vector<float> numbers;
  std::vector<unsigned char> wanted;
  std::vector<Candidate> found;
  ShapeTables tables;
  bool wide = best_instruction_set() != InstructionSet::kBaseline;
};

NearShapes::NearShapes() : impl_(std::make_unique<Impl>()) {}
NearShapes::~NearShapes() = default;

void NearShapes::set(const std::vector<Capsule>& capsules) {
  Impl& i = *impl_;
  i.capsules = capsules;
  const std::size_t count = (capsules.size() + 7) / 8 * 8;
  i.numbers.assign(12 * count, 0.0F);
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
  for (std::size_t s = 0; s < capsules.size(); ++s) {
    radius[s] = static_cast<float>(capsules[s].radius);
    i.tables.round[s] = static_cast<float>(capsules[s].radius +
                                           0.5 * (capsules[s].b - capsules[s].a).norm() + 1e-6);
  }
  i.found.clear();
}

void NearShapes::want(int a, int b, bool on) {
  Impl& i = *impl_;
  if (a > b) std::swap(a, b);
  unsigned char& byte = i.wanted[at(a * i.tables.blocks + b / 8)];
  const auto mask = static_cast<unsigned char>(1U << (b % 8));
  if (on && (byte & mask) == 0) i.found.emplace_back();  // room for every wanted pair
  byte = static_cast<unsigned char>(on ? byte | mask : byte & ~mask);
}

void NearShapes::place(int shape, const Eigen::Isometry3d& pose,
                       const Eigen::Vector3d& origin) noexcept {
  Impl& i = *impl_;
  const std::size_t s = at(shape);
  const Capsule& c = i.capsules[s];
  const Eigen::Vector3d a = pose * c.a - origin, u = pose.linear() * (c.b - c.a);
  for (std::size_t d = 0; d < 3; ++d) {
    const auto k = static_cast<Eigen::Index>(d);
    i.tables.from[d][s] = static_cast<float>(a[k]);
    i.tables.along[d][s] = static_cast<float>(u[k]);
    i.tables.middle[d][s] = static_cast<float>(a[k] + 0.5 * u[k]);
  }
}

void NearShapes::let_move(int shape, double travel) noexcept {
  impl_->tables.travel[at(shape)] = static_cast<float>(travel) * 1.00001F;
}

std::span<const NearShapes::Candidate> NearShapes::nearer_than(double reach,
                                                               double ahead) noexcept {
  Impl& i = *impl_;
  i.tables.found = i.found.data();
  const auto far = static_cast<float>(reach), then = static_cast<float>(ahead);
#if defined(__x86_64__) && !defined(__clang__)
  const int n = i.wide ? avx2_shapes::near_shapes(i.tables, far, then)
                       : baseline_shapes::near_shapes(i.tables, far, then);
#else
  const int n = baseline_shapes::near_shapes(i.tables, far, then);
#endif
  return {i.found.data(), at(n)};
}

}  // namespace twinbus
