// The step of four worlds in the lanes of a vector, each kernel once per instruction set.

#include "sim/lanes/lane_block.h"

#include "sim/articulated/articulated_kernels.h"
#include "sim/articulated/joint_law.h"
#include "sim/contact/bristle.h"
#include "sim/world/step_trust.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

#define TWINBUS_KERNEL_FILE "sim/lanes/lane_step.h"
#include "common/simd/fused_kernels.h"

void place_lanes(LaneBlock& block) noexcept { TWINBUS_KERNEL(place_worlds(block)); }

void bound_lanes(LaneBlock& block) noexcept { TWINBUS_KERNEL(bound_worlds(block)); }

int step_lanes(LaneBlock& block, int asked) noexcept { return TWINBUS_KERNEL(step_worlds(block, asked)); }

}  // namespace twinbus::sim
