#include "sim/lanes/lane_block.h"

#include "sim/articulated/articulated_kernels.h"
#include "sim/articulated/joint_law.h"
#include "sim/contact/bristle.h"
#include "sim/world/step_trust.h"
#include "sim/world/world.h"

namespace twinbus {

// clang-format off
namespace baseline {
#include "sim/lanes/lane_step.h"
}  // namespace baseline
#if defined(__x86_64__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace avx2 {
#include "sim/lanes/lane_step.h"
}  // namespace avx2
#pragma GCC target("avx512f,avx512vl,avx512dq,fma")
namespace avx512 {
#include "sim/lanes/lane_step.h"
}  // namespace avx512
#pragma GCC pop_options
#endif
// clang-format on

void place_lanes(LaneBlock& block) noexcept { TWINBUS_KERNEL(place_worlds(block)); }

void bound_lanes(LaneBlock& block) noexcept { TWINBUS_KERNEL(bound_worlds(block)); }

int step_lanes(LaneBlock& block, int asked) noexcept { return TWINBUS_KERNEL(step_worlds(block, asked)); }

}  // namespace twinbus
