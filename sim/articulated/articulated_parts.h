// The sweeps over links, for articulated_kernels.h.  The order of these files matters.
// clang-format off
#include "sim/articulated/spatial_functions.h"
#include "sim/articulated/lane_functions.h"
#include "sim/articulated/articulated_root.h"
#include "sim/articulated/articulated_placing.h"
#include "sim/articulated/articulated_momentum.h"
#include "sim/articulated/articulated_sweeps.h"
#include "sim/articulated/link_hinges.h"
#include "sim/articulated/inertia_lanes.h"
#include "sim/articulated/inverse_lanes.h"
// clang-format on
