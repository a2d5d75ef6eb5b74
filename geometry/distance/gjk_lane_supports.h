// Several searches at once: of the shapes of every lane the points farthest along its direction.  Included by
// gjk_many.cpp after gjk_lanes.h.

// Cells of directions, as in support_cells.h.
TWINBUS_INLINE Whole cells_of(const Lanes3& d) noexcept {
  Lanes3 size;
  for (int k = 0; k < 3; ++k)
    size[k] = reinterpret_cast<Lanes>(reinterpret_cast<Whole>(d[k]) & INT64_MAX);
  const Mask by_y = at_least(size[0], size[1]), by_z = at_least(size[1], size[2]),
             by_x = at_least(size[2], size[0]);
  const Mask y = ~by_y & by_z, z = ~by_z & by_x, x = ~(y | z);  // is the largest
  const Lanes largest = pick(z, size[2], pick(y, size[1], size[0]));
  Mask half[3];
  for (int k = 0; k < 3; ++k) half[k] = at_least(size[k] + size[k], largest);
  const Mask after = (x & half[1]) | (y & half[2]) | (z & half[0]);
  const Mask before = (x & half[2]) | (y & half[0]) | (z & half[1]);
  return where(negative(d[0]), 1) + where(negative(d[1]), 2) + where(negative(d[2]), 4) +
         where(y, 8) + where(z, 16) + where(after, 24) + where(before, 48);
}

// Of the shapes of every lane.
struct Shapes {
  const double* points[kLanes] = {};  // of the cells; null: of something else
  std::size_t row[kLanes] = {};

  void set(int lane, const GjkShape& shape) noexcept {
    row[lane] = shape.cells.row;
    points[lane] = shape.cells.row > 0 ? shape.cells.points(0) : nullptr;
  }
};

// Kept out of the way of what is asked far more often.
[[gnu::noinline]] static void support_without_cells(const GjkShape& shape, const double* d,
                                                    Vec4& found) noexcept {
  found = support(shape, load4(d));
}

// Of the lanes that are open the points farthest along d.
TWINBUS_INLINE void supports(const Shapes& shapes, GjkQuery* const (&query)[kLanes],
                             const GjkShape* GjkQuery::*which, unsigned open, const Lanes3& d,
                             Lanes3& to) noexcept {
  alignas(64) Numbers towards[3];
  for (int k = 0; k < 3; ++k) store(towards[k], d[k]);
  alignas(64) std::int64_t cell[kLanes];
  const Whole cells = cells_of(d);
  std::memcpy(cell, &cells, sizeof cell);
  Vec4 found[kLanes];
#pragma GCC unroll 1
  for (int lane = 0; lane < kLanes; ++lane) {
    found[lane] = Vec4{};
    if ((open >> lane & 1U) == 0) continue;
    const double x = towards[0][lane], y = towards[1][lane], z = towards[2][lane];
    if (shapes.points[lane] == nullptr) {
      const double d4[4] = {x, y, z, 0.0};
      support_without_cells(*(query[lane]->*which), d4, found[lane]);
      continue;
    }
    const std::size_t n = shapes.row[lane];
    const double* const p = farthest_in_row<Lanes, Whole>(
        shapes.points[lane] + 3 * n * static_cast<std::size_t>(cell[lane]), n, x, y, z);
    found[lane] = Vec4{p[0], p[n], p[2 * n], 0.0};
  }
  coordinates(found, to);
}
