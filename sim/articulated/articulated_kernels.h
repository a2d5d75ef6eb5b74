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

namespace twinbus {

// The order of these files matters.
// clang-format off
namespace baseline {
#include "sim/articulated/spatial_functions.h"
#include "sim/articulated/lane_functions.h"
#include "sim/articulated/articulated_root.h"
#include "sim/articulated/articulated_placing.h"
#include "sim/articulated/articulated_momentum.h"
#include "sim/articulated/articulated_sweeps.h"
#include "sim/articulated/link_hinges.h"
#include "sim/articulated/inertia_lanes.h"
#include "sim/articulated/inverse_lanes.h"
}  // namespace baseline
#if defined(__x86_64__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace avx2 {
#include "sim/articulated/spatial_functions.h"
#include "sim/articulated/lane_functions.h"
#include "sim/articulated/articulated_root.h"
#include "sim/articulated/articulated_placing.h"
#include "sim/articulated/articulated_momentum.h"
#include "sim/articulated/articulated_sweeps.h"
#include "sim/articulated/link_hinges.h"
#include "sim/articulated/inertia_lanes.h"
#include "sim/articulated/inverse_lanes.h"
}  // namespace avx2
#pragma GCC target("avx512f,avx512vl,avx512dq,fma")
namespace avx512 {
#include "sim/articulated/spatial_functions.h"
#include "sim/articulated/lane_functions.h"
#include "sim/articulated/articulated_root.h"
#include "sim/articulated/articulated_placing.h"
#include "sim/articulated/articulated_momentum.h"
#include "sim/articulated/articulated_sweeps.h"
#include "sim/articulated/link_hinges.h"
#include "sim/articulated/inertia_lanes.h"
#include "sim/articulated/inverse_lanes.h"
}  // namespace avx512
#pragma GCC pop_options
#define TWINBUS_KERNEL(call) \
  (simd() == Simd::kAvx512 ? avx512::call : simd() == Simd::kAvx2 ? avx2::call : baseline::call)
#else
#define TWINBUS_KERNEL(call) (baseline::call)
#endif
// clang-format on

}  // namespace twinbus
