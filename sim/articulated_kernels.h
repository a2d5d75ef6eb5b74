// The sweeps over links in lanes, once for each instruction set: TWINBUS_KERNEL(place(lanes, ...))
// calls the best that this machine has.  For .cpp files that are compiled with -ffp-contract=fast.

#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

#include "robot/dynamics.h"
#include "robot/vec4.h"
#include "sim/articulated_body.h"
#include "sim/rigid_links.h"

namespace twinbus {

// The order of these files matters.
// clang-format off
namespace baseline {
#include "sim/spatial_functions.h"
#include "sim/lane_functions.h"
#include "sim/articulated_root.h"
#include "sim/articulated_placing.h"
#include "sim/articulated_momentum.h"
#include "sim/articulated_sweeps.h"
#include "sim/link_hinges.h"
#include "sim/inertia_lanes.h"
#include "sim/inverse_lanes.h"
}  // namespace baseline
#if defined(__x86_64__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace avx2 {
#include "sim/spatial_functions.h"
#include "sim/lane_functions.h"
#include "sim/articulated_root.h"
#include "sim/articulated_placing.h"
#include "sim/articulated_momentum.h"
#include "sim/articulated_sweeps.h"
#include "sim/link_hinges.h"
#include "sim/inertia_lanes.h"
#include "sim/inverse_lanes.h"
}  // namespace avx2
#pragma GCC target("avx512f,avx512vl,avx512dq,fma")
namespace avx512 {
#include "sim/spatial_functions.h"
#include "sim/lane_functions.h"
#include "sim/articulated_root.h"
#include "sim/articulated_placing.h"
#include "sim/articulated_momentum.h"
#include "sim/articulated_sweeps.h"
#include "sim/link_hinges.h"
#include "sim/inertia_lanes.h"
#include "sim/inverse_lanes.h"
}  // namespace avx512
#pragma GCC pop_options
#define TWINBUS_KERNEL(call) \
  (simd() == Simd::kAvx512 ? avx512::call : simd() == Simd::kAvx2 ? avx2::call : baseline::call)
#else
#define TWINBUS_KERNEL(call) (baseline::call)
#endif
// clang-format on

}  // namespace twinbus
