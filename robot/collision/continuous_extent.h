// How far shapes reach along directions, a lane for every place; included after float8.h.

constexpr unsigned kAllLanes = 0xFF;

// What stands for a hull: the ball inside of it, which reaches nowhere farther, or the box around it.
enum class HullBy { kInside, kBox };

// Of directions, as support_cells.h numbers them.
TWINBUS_INLINE I8 support_cells8(const F8 (&d)[3]) noexcept {
  const F8 x = size(d[0]), y = size(d[1]), z = size(d[2]), largest = most(x, most(y, z));
  const auto negative = [](F8 v) { return reinterpret_cast<I8>(v) >> 31; };
  const auto half = [&](F8 v) { return v + v >= largest; };
  const I8 is_x = x >= largest, is_y = ~is_x & (y >= largest), is_z = ~(is_x | is_y);
  const I8 after = (is_x & half(y)) | (is_y & half(z)) | (is_z & half(x));
  const I8 before = (is_x & half(z)) | (is_y & half(x)) | (is_z & half(y));
  const I8 signs = (negative(d[0]) & 1) + (negative(d[1]) & 2) + (negative(d[2]) & 4);
  return signs + (is_y & 8) + (is_z & 16) + (after & 24) + (before & 48);
}

// Of the corners that can be the farthest, four maxima at a time, as each waits for the one before: `row` of them, a
// multiple of four, `which` says which.
template <class Which>
TWINBUS_INLINE void reach_corners8(const SweptPart& part, const F8 (&d)[3], int row, Which which, F8 (&far)[4]) noexcept {
  const float *x = part.corner, *y = x + part.corners, *z = y + part.corners;
  for (int k = 0; k < row; k += 4) {
    for (int i = 0; i < 4; ++i) {
      const int c = which(k + i);
      far[i] = most(far[i], d[0] * x[c] + d[1] * y[c] + d[2] * z[c]);
    }
  }
}

// How far a shape reaches along a direction from its middle; sign: of the direction, which only hulls ask for.
TWINBUS_INLINE F8 extent8(const SweptPart& part, const F8 (&in)[3], float sign, HullBy hulls) noexcept {
  if (part.kind == SweptPart::kBall) return all(part.half[0]);
  if (part.kind == SweptPart::kCylinder)
    return root(in[0] * in[0] + in[1] * in[1]) * part.half[0] + size(in[2]) * part.half[1];
  if (hulls == HullBy::kBox || part.corners == 0)
    return size(in[0]) * part.half[0] + size(in[1]) * part.half[1] + size(in[2]) * part.half[2];
  const float* c = part.inside;
  return (in[0] * c[0] + in[1] * c[1] + in[2] * c[2]) * sign + part.inside_radius;
}

// How far a hull reaches along directions by its corners, found cell by cell.
struct CornerReach8 {
  F8 d[3];
  I8 cell;            // that a lane is in
  unsigned done = 0;  // lanes that all corners of their cells were looked at for
  F8 far[4] = {all(-1e9F), all(-1e9F), all(-1e9F), all(-1e9F)};
};
TWINBUS_INLINE CornerReach8 corner_reach8(const SweptPart& part, const F8 (&in)[3], float sign) noexcept {
  CornerReach8 reach{{in[0] * sign, in[1] * sign, in[2] * sign}, {}};
  if (part.cell != nullptr) reach.cell = support_cells8(reach.d);
  return reach;
}
// As extent8 at these lanes and all that were asked for before; no more than that at others.  Corners of a cell are looked at
// for all lanes, as others' corners do no harm.
TWINBUS_INLINE F8 extent_by_corners8(const SweptPart& part, const F8 (&in)[3], unsigned lanes,
                                     CornerReach8& reach) noexcept {
  if (part.corners == 0) return extent8(part, in, 1.0F, HullBy::kBox);
  if (part.cell == nullptr && reach.done == 0) {
    reach_corners8(part, reach.d, part.corners, [](int k) { return k; }, reach.far);
    reach.done = kAllLanes;
  }
  for (unsigned left = lanes & ~reach.done; left != 0; left &= ~reach.done) {
    const int cell = reach.cell[lowest(left)];
    reach.done |= bits(reach.cell == cell);
    const std::uint16_t* of_cell = part.cell + part.cell[cell];
    const auto which = [of_cell](int k) { return static_cast<int>(of_cell[k]); };
    reach_corners8(part, reach.d, part.cell[cell + 1] - part.cell[cell], which, reach.far);
  }
  return most(most(reach.far[0], reach.far[1]), most(reach.far[2], reach.far[3]));
}
