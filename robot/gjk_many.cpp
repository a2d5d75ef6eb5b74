#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "robot/gjk.h"
#include "robot/gjk_support.h"
#include "robot/self_collision.h"
#include "robot/vec4.h"

namespace twinbus {

namespace {

constexpr double kTouching = 1e-12;  // [m]
constexpr double kMostSteps = 64.0;
constexpr std::size_t kAtOnce = 64;  // queries that are prepared

// A search before it has a lane, in the axes of its a.
struct alignas(32) Prepared {
  double turn[3][4], shift[4];  // of b
  double v[4], on_a[4];         // the first corner of the difference; where it is on a
  double above, below;          // the distance is no larger, no smaller [m]
};

// Four searches, each in the axes of its a: of every number those of all lanes.
struct alignas(32) Searches {
  double turn[3][3][4] = {}, shift[3][4] = {};
  double v[3][4] = {}, above[4] = {}, below[4] = {}, far[4] = {}, steps[4] = {};
  double corner[3][3][4] = {}, on_a[3][3][4] = {}, part[3][4] = {};
  GjkQuery* query[4] = {};
};

double skin(const GjkShape& s) noexcept { return s.kind == ShapeKind::kSphere ? s.half.x() : 0.0; }

}  // namespace

// clang-format off
#define TWINBUS_WIDE 0
namespace baseline_gjk {
#include "robot/gjk_lanes.h"
#include "robot/gjk_searches.h"
}  // namespace baseline_gjk
#undef TWINBUS_WIDE
#if defined(__x86_64__) && !defined(__clang__)
#define TWINBUS_WIDE 1
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2_gjk {
#include "robot/gjk_lanes.h"
#include "robot/gjk_searches.h"
}  // namespace avx2_gjk
#pragma GCC pop_options
#undef TWINBUS_WIDE
#endif
// clang-format on

void gjk_distances(std::span<GjkQuery> queries, double close) noexcept {
#if defined(__x86_64__) && !defined(__clang__)
  static const bool wide = best_instruction_set() != InstructionSet::kBaseline;
  if (wide) return avx2_gjk::search(queries, close);
#endif
  baseline_gjk::search(queries, close);
}

}  // namespace twinbus
