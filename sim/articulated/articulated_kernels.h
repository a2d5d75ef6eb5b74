// The sweeps over links in lanes, once for each instruction set: TWINBUS_KERNEL(place(lanes, ...))
// calls the best that this machine has.  For .cpp files that are compiled with -ffp-contract=fast.

#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/simd/vec4.h"
#include "sim/articulated/aba.h"
#include "sim/articulated/rigid_links.h"

namespace twinbus::inline sim {

#define TWINBUS_KERNEL_FILE "sim/articulated/articulated_parts.h"
#include "common/simd/fused_kernels.h"

#ifdef __x86_64__
#define TWINBUS_KERNEL(call) \
  (simd() == Simd::kAvx512 ? avx512::call : simd() == Simd::kAvx2 ? avx2::call : baseline::call)
#else
#define TWINBUS_KERNEL(call) (baseline::call)
#endif

}  // namespace twinbus::sim
