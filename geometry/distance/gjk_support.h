// The point of a shape that is farthest along a direction, for the kernels of gjk.cpp: what
// they spend half of their time on.

#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "geometry/distance/gjk.h"
#include "common/simd/vec4.h"

namespace twinbus::inline geometry {

inline constexpr double kGjkTouching = 1e-12;  // no distance [m]
inline constexpr int kGjkMostSteps = 64;       // of a search

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

typedef double Vec8 __attribute__((vector_size(64), aligned(64)));
typedef std::int64_t Int8 __attribute__((vector_size(64), aligned(64)));

template <class Wide>
TWINBUS_INLINE Wide largest_of(const Wide& a, const Wide& b) noexcept {
  return a > b ? a : b;
}
TWINBUS_INLINE Vec4 largest_of_halves(const Vec8& a) noexcept {
  return largest_of(__builtin_shufflevector(a, a, 0, 1, 2, 3),
                    __builtin_shufflevector(a, a, 4, 5, 6, 7));
}
TWINBUS_INLINE Vec4 largest_of_halves(const Vec4& a) noexcept { return a; }
TWINBUS_INLINE Int4 counted(const Int4&) noexcept { return Int4{0, 1, 2, 3}; }
TWINBUS_INLINE Int8 counted(const Int8&) noexcept { return Int8{0, 1, 2, 3, 4, 5, 6, 7}; }

// As in support_cells.h.
TWINBUS_INLINE std::size_t cell_of(const Vec4& d) noexcept {
  // By |x| >= |y|, |y| >= |z|, |z| >= |x| as 1, 2, 4: the largest coordinate.
  constexpr std::uint8_t kLargest[8] = {0, 0, 1, 0, 2, 2, 1, 0};
  const Vec4 size = reinterpret_cast<Vec4>(reinterpret_cast<Int4>(d) & INT64_MAX),
             next = rolled(size);
  const unsigned axis = kLargest[signs_of(reinterpret_cast<Vec4>(size >= next)) & 7U];
  const Vec4 largest = largest_of(largest_of(size, next), rolled(next));
  const unsigned halves =
      (signs_of(reinterpret_cast<Vec4>(size + size >= largest)) & 7U) * 9U;  // twice in a row
  return (signs_of(d) & 7U) + 8U * axis + 24U * (halves >> (axis + 1U) & 3U);
}

constexpr std::int64_t kWhose = 255;  // bits of a number that say whose it is
constexpr std::size_t kMostInARow = 256;

// Of very many points.
inline const double* farthest_of_many(const double* points, std::size_t n, const Vec4& d) noexcept {
  const auto along = [&](const double* p) { return p[0] * d[0] + p[n] * d[1] + p[2 * n] * d[2]; };
  const double* found = points;
  for (const double* p = points; p != points + n; ++p) {
    if (along(p) > along(found)) found = p;
  }
  return found;
}

// Of n points, x of all, then y, then z, the farthest along (x, y, z), or one that is so to 6e-14 of its distance; n at
// most kMostInARow and a multiple of as many as Wide, a vector of double, has; Whole one of whole numbers.
template <class Wide, class Whole>
TWINBUS_INLINE const double* farthest_in_row(const double* points, std::size_t n, double x,
                                             double y, double z) noexcept {
  constexpr std::size_t kWide = sizeof(Wide) / sizeof(double);
  const auto load = [](const double* from) __attribute__((always_inline)) {
    Wide v;
    std::memcpy(&v, from, sizeof v);
    return v;
  };
  const auto block = [&](std::size_t i, const Whole& whose) __attribute__((always_inline)) {
    const double* const p = points + i;
    const Wide value = load(p) * x + load(p + n) * y + load(p + 2 * n) * z;
    return reinterpret_cast<Wide>((reinterpret_cast<Whole>(value) & ~kWhose) | whose);
  };
  Whole whose = counted(Whole{});
  Wide all = block(0, whose);
  for (std::size_t i = kWide; i < n; i += kWide)
    all = largest_of(all, block(i, whose += static_cast<std::int64_t>(kWide)));
  Vec4 best = largest_of_halves(all);
  best = largest_of(best, __builtin_shufflevector(best, best, 2, 3, 0, 1));
  best = largest_of(best, __builtin_shufflevector(best, best, 1, 0, 3, 2));
  return points + (reinterpret_cast<Int4>(best)[0] & kWhose);
}

// The same of any multiple of four points.
TWINBUS_INLINE const double* farthest(const double* points, std::size_t n, const Vec4& d) noexcept {
  if (n <= kMostInARow) return farthest_in_row<Vec4, Int4>(points, n, d[0], d[1], d[2]);
  return farthest_of_many(points, n, d);
}

// The point of a shape farthest along d, without the radius of a sphere.
TWINBUS_INLINE Vec4 support(const GjkShape& s, const Vec4& d) noexcept {
  if (s.kind == ShapeKind::kMesh) {
    const bool all = s.cells.empty();
    const std::size_t cell = all ? 0 : cell_of(d), n = all ? s.points.size() / 3 : s.cells.size(cell);
    const double* p = farthest(all ? s.points.data() : s.cells.points(cell), n, d);
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

}  // namespace twinbus::geometry
