#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "geometry/distance/gjk.h"
#include "geometry/distance/gjk_support.h"
#include "common/simd/instruction_set.h"
#include "common/simd/vec4.h"

namespace twinbus {

namespace {

constexpr int kKeptLooks = 80;      // more than a search takes
constexpr double kNothing = 1e300;  // is known [m]

double skin(const GjkShape& s) noexcept { return s.kind == ShapeKind::kSphere ? s.half.x() : 0.0; }

}  // namespace

// clang-format off
#define TWINBUS_WIDE 0
namespace baseline_gjk {
#include "geometry/distance/gjk_lanes.h"
#include "geometry/distance/simplex_lanes.h"
#include "geometry/distance/gjk_lane_supports.h"
#include "geometry/distance/gjk_searches.h"
}  // namespace baseline_gjk
#undef TWINBUS_WIDE
#if defined(__x86_64__) && !defined(__clang__)
#define TWINBUS_WIDE 1
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2_gjk {
#include "geometry/distance/gjk_lanes.h"
#include "geometry/distance/simplex_lanes.h"
#include "geometry/distance/gjk_lane_supports.h"
#include "geometry/distance/gjk_searches.h"
}  // namespace avx2_gjk
#undef TWINBUS_WIDE
#define TWINBUS_WIDE 2
#pragma GCC target("avx512f,avx512vl,avx512dq")
namespace avx512_gjk {
#include "geometry/distance/gjk_lanes.h"
#include "geometry/distance/simplex_lanes.h"
#include "geometry/distance/gjk_lane_supports.h"
#include "geometry/distance/gjk_searches.h"
}  // namespace avx512_gjk
#pragma GCC pop_options
#undef TWINBUS_WIDE
#endif
// clang-format on

void gjk_distances(std::span<GjkQuery> queries, double close, InstructionSet set) noexcept {
#if defined(__x86_64__) && !defined(__clang__)
  if (set == InstructionSet::kAvx512) return avx512_gjk::search(queries, close);
  if (set == InstructionSet::kAvx2) return avx2_gjk::search(queries, close);
#endif
  (void)set;
  baseline_gjk::search(queries, close);
}

void gjk_distances(std::span<GjkQuery> queries, double close) noexcept {
  gjk_distances(queries, close, best_instruction_set());
}

}  // namespace twinbus
