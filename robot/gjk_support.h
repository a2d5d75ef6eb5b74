// The point of a shape that is farthest along a direction, for the kernels of gjk.cpp and gjk_many.cpp: what both
// spend half of their time on.

#pragma once

#include <cmath>
#include <cstdint>

#include "robot/gjk.h"
#include "robot/vec4.h"

namespace twinbus {

// The signs, as bits.
TWINBUS_INLINE unsigned signs_of(const Vec4& a) noexcept {
#if defined(__SSE2__)
  typedef double Vec2 __attribute__((vector_size(16)));
  Vec2 half[2];
  std::memcpy(half, &a, sizeof half);
  return static_cast<unsigned>(__builtin_ia32_movmskpd(half[0])) |
         static_cast<unsigned>(__builtin_ia32_movmskpd(half[1])) << 2;
#else
  unsigned result = 0;
  for (int k = 0; k < 4; ++k) result |= std::signbit(a[k]) ? 1U << k : 0U;
  return result;
#endif
}

TWINBUS_INLINE Vec4 largest_of(const Vec4& a, const Vec4& b) noexcept { return a > b ? a : b; }

// As in support_cells.h.
TWINBUS_INLINE std::size_t cell_of(const Vec4& d) noexcept {
  // By |x| >= |y|, |y| >= |z|, |z| >= |x| as 1, 2, 4.
  constexpr std::uint8_t kLargest[8] = {0, 0, 8, 0, 16, 16, 8, 0};
  const Vec4 size = reinterpret_cast<Vec4>(reinterpret_cast<Int4>(d) & INT64_MAX);
  return (signs_of(d) & 7U) | kLargest[signs_of(reinterpret_cast<Vec4>(size >= rolled(size))) & 7U];
}

// The same beyond the first of very many, one of which is the farthest of those.
inline const double* farthest_of_many(const double* x, std::size_t n, const Vec4& d,
                                      const double* found) noexcept {
  const auto along = [&](const double* p) { return p[0] * d[0] + p[n] * d[1] + p[2 * n] * d[2]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (along(x + i) > along(found)) found = x + i;
  }
  return found;
}

constexpr std::int64_t kWhose = 255;  // bits of a number that say whose it is
constexpr std::size_t kMostInARow = 256;

// Of n points, x of all, then y, then z, the farthest along d, or one that is so to 6e-14 of its distance.
TWINBUS_INLINE const double* farthest(const double* x, std::size_t n, const Vec4& d) noexcept {
  const double* y = x + n;
  const double* z = y + n;
  const auto block = [&](std::size_t i, const Int4& whose) __attribute__((always_inline)) {
    const Vec4 value = load4(x + i) * d[0] + load4(y + i) * d[1] + load4(z + i) * d[2];
    return reinterpret_cast<Vec4>((reinterpret_cast<Int4>(value) & ~kWhose) | whose);
  };
  Int4 whose{0, 1, 2, 3};
  Vec4 best = block(0, whose);
  const std::size_t first = n < kMostInARow ? n : kMostInARow;
  for (std::size_t i = 4; i < first; i += 4) best = largest_of(best, block(i, whose += 4));
  best = largest_of(best, __builtin_shufflevector(best, best, 2, 3, 0, 1));
  best = largest_of(best, __builtin_shufflevector(best, best, 1, 0, 3, 2));
  const double* const found = x + (reinterpret_cast<Int4>(best)[0] & kWhose);
  return n <= kMostInARow ? found : farthest_of_many(x, n, d, found);
}

// The point of a shape farthest along d, without the radius of a sphere.
TWINBUS_INLINE Vec4 support(const GjkShape& s, const Vec4& d) noexcept {
  if (s.kind == ShapeKind::kMesh) {
    const std::size_t n = s.cells.row > 0 ? s.cells.row : s.points.size() / 3;
    const double* from =
        s.cells.row > 0 ? s.cells.points.data() + 3 * n * cell_of(d) : s.points.data();
    const double* p = farthest(from, n, d);
    return Vec4{p[0], p[n], p[2 * n], 0.0};
  }
  if (s.kind == ShapeKind::kBox)
    return Vec4{std::copysign(s.half[0], d[0]), std::copysign(s.half[1], d[1]),
                std::copysign(s.half[2], d[2]), 0.0};
  if (s.kind == ShapeKind::kSphere) return Vec4{};
  const double across = std::sqrt(d[0] * d[0] + d[1] * d[1]);
  const double scale = across > 1e-150 ? s.half[0] / across : 0.0;
  return Vec4{scale * d[0], scale * d[1], std::copysign(s.half[1], d[2]), 0.0};
}

}  // namespace twinbus
