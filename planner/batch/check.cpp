#include "planner/batch/check.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <numeric>
#include <vector>

#include "planner/batch/work.h"
#include "planner/batch/nearest_point.h"
#include "common/math/index.h"
#include "common/simd/vec4.h"  // TWINBUS_INLINE

namespace twinbus::inline planner {

// The order of these files matters.
// clang-format off
namespace block_baseline {
#include "common/simd/block_lanes.h"
#include "planner/batch/placing.h"
#include "planner/batch/shapes.h"
#include "geometry/distance/simplex_lanes.h"
#include "planner/batch/sides.h"
#include "planner/batch/separate.h"
#include "planner/batch/look.h"
#include "planner/batch/line.h"
#include "planner/batch/certain.h"
}  // namespace block_baseline
#ifdef __x86_64__
#include "common/simd/begin_avx2.h"
#define TWINBUS_BLOCK_AVX2
namespace block_avx2 {
#include "common/simd/block_lanes.h"
#include "planner/batch/placing.h"
#include "planner/batch/shapes.h"
#include "geometry/distance/simplex_lanes.h"
#include "planner/batch/sides.h"
#include "planner/batch/separate.h"
#include "planner/batch/look.h"
#include "planner/batch/line.h"
#include "planner/batch/certain.h"
}  // namespace block_avx2
#include "common/simd/end_target.h"
// Of many corners two at once; else no wider.
#include "common/simd/begin_avx512.h"
#define TWINBUS_BLOCK_AVX512
namespace block_avx512 {
#include "common/simd/block_lanes.h"
#include "planner/batch/placing.h"
#include "planner/batch/shapes.h"
#include "geometry/distance/simplex_lanes.h"
#include "planner/batch/sides.h"
#include "planner/batch/separate.h"
#include "planner/batch/look.h"
#include "planner/batch/line.h"
#include "planner/batch/certain.h"
}  // namespace block_avx512
#undef TWINBUS_BLOCK_AVX512
#undef TWINBUS_BLOCK_AVX2
#include "common/simd/end_target.h"
#define TWINBUS_BLOCK(set, call)                           \
  ((set) == InstructionSet::kAvx512 ? block_avx512::call   \
   : (set) == InstructionSet::kAvx2 ? block_avx2::call : block_baseline::call)
#else
#define TWINBUS_BLOCK(set, call) (static_cast<void>(set), block_baseline::call)
#endif
// clang-format on

BlockCheck::BlockCheck(const BlockRobot& robot, const BlockScene& scene, InstructionSet set)
    : robot_(&robot), scene_(&scene), work_(new BlockWork), set_(set) {
  TWINBUS_BLOCK(set_, prepare(robot, *work_));
  settle_as_at_first();
}

BlockCheck::~BlockCheck() = default;

bool BlockCheck::line_free(const float* from, const float* step, int blocks) noexcept {
  const int looked = TWINBUS_BLOCK(set_, line_free(*robot_, *scene_, *work_, from, step, blocks));
  blocks_ += looked < 0 ? -looked : looked;
  return looked > 0;
}

void BlockCheck::settle_all() noexcept {
  std::fill(std::begin(work_->settles), std::end(work_->settles), true);
  std::fill(std::begin(work_->settles_pair), std::end(work_->settles_pair), true);
}

void BlockCheck::settle_as_at_first() noexcept {
  settle_all();
  std::fill(std::begin(work_->fine), std::end(work_->fine), true);
  std::fill(std::begin(work_->fine_pair), std::end(work_->fine_pair), true);
}

void BlockCheck::settle_touching(const std::vector<const float*>& postures) noexcept {
  for (bool* flags : {work_->settles, work_->fine}) std::fill_n(flags, kBlockGroups, false);
  for (bool* flags : {work_->settles_pair, work_->fine_pair}) std::fill_n(flags, std::size(work_->fine_pair), false);
  work_->notes = true;
  for (const float* q : postures) point_free(q);
  work_->notes = false;
}

void BlockCheck::settle_by_pieces(bool yes) noexcept { work_->by_pieces = yes; }
void BlockCheck::settle_pairs(bool yes) noexcept { work_->pairs_by_hulls = yes; }

bool BlockCheck::point_free(const float* q) noexcept {
  static constexpr float kNowhere[kMostPlanned] = {};
  return line_free(q, kNowhere, 1);
}

// Eight pieces; those that are not certain are halved.
bool BlockCheck::line_certain(const float* from, const float* step, float slack) noexcept {
  constexpr int kDepth = 10, kMost = 512;
  std::array<std::array<float, kMost>, 2> middles;
  int count = 8;
  for (int i = 0; i < count; ++i) middles[0][at(i)] = (static_cast<float>(i) + 0.5F) / 8.0F;
  float half = 1.0F / 16.0F;
  for (int level = 0; level < kDepth; ++level, half *= 0.5F) {
    const auto& now = middles[at(level % 2)];
    auto& next = middles[at((level + 1) % 2)];
    int left = 0;
    for (int first = 0; first < count; first += 8) {
      Lanes t;
      for (int i = 0; i < 8; ++i) t[i] = now[at(std::min(first + i, count - 1))];
      unsigned certain = 0, touching = 0;
      TWINBUS_BLOCK(set_,
                    certain(*robot_, *scene_, *work_, from, step, t, half, slack, certain, touching));
      ++blocks_;
      if (touching != 0) return false;
      for (int i = 0; i < std::min(8, count - first); ++i) {
        if ((certain >> i & 1) != 0) continue;
        if (left + 2 > kMost) return false;
        next[at(left++)] = t[i] - 0.5F * half;
        next[at(left++)] = t[i] + 0.5F * half;
      }
    }
    count = left;
    if (count == 0) return true;
  }
  return false;
}

int nearest_point(const float* columns, int stride, int count, int joints, const float* q,
                  float& found) noexcept {
  return TWINBUS_BLOCK(best_instruction_set(), nearest(columns, stride, count, joints, q, found));
}

}  // namespace twinbus::planner
