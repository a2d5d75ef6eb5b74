// Boxes against boxes, eight at a time in single precision.

#pragma once

#include <cstring>

#include "common/simd/vec4.h"
#include "geometry/mesh_contact/contact_mesh.h"

namespace twinbus::inline geometry::box_lanes {

typedef float F8 __attribute__((vector_size(32), aligned(32)));
typedef int I8 __attribute__((vector_size(32), aligned(32)));

TWINBUS_INLINE F8 load8(const float* from) noexcept {
  F8 v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
TWINBUS_INLINE F8 all(float x) noexcept { return F8{x, x, x, x, x, x, x, x}; }

TWINBUS_INLINE unsigned bits(const I8& mask) noexcept {
  unsigned result = 0;
  for (unsigned k = 0; k < 8; ++k) result |= mask[k] != 0 ? 1U << k : 0U;
  return result;
}

// Lanes whose boxes meet the one box.
TWINBUS_INLINE unsigned meeting(const FaceBoxes& boxes, const float* low,
                                const float* high) noexcept {
  I8 apart{};
  for (std::size_t d = 0; d < 3; ++d) {
    apart |= (load8(boxes.low[d].data()) > all(high[d])) |
             (load8(boxes.high[d].data()) < all(low[d]));
  }
  return ~bits(apart) & 0xFFU;
}

}  // namespace twinbus::geometry::box_lanes
