// How far shapes reach along directions, a lane for every place; included after float8.h.

constexpr unsigned kAllLanes = 0xFF;

// What stands for a hull: the ball inside of it, which reaches nowhere farther; the box around it; its corners.
enum class HullBy { kInside, kBox, kCorners };

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
  if (hulls == HullBy::kInside) {
    const float* c = part.inside;
    return (in[0] * c[0] + in[1] * c[1] + in[2] * c[2]) * sign + part.inside_radius;
  }
  const F8 d[3] = {in[0] * sign, in[1] * sign, in[2] * sign};
  F8 far[4] = {all(-1e9F), all(-1e9F), all(-1e9F), all(-1e9F)};
  if (part.cell == nullptr) {
    reach_corners8(part, d, part.corners, [](int k) { return k; }, far);
  } else {  // every cell that a lane is in, for all lanes: others' corners do no harm
    const I8 cells = support_cells8(d);
    for (unsigned left = kAllLanes; left != 0;) {
      const int cell = cells[lowest(left)];
      left &= ~bits(cells == cell);
      const std::uint16_t* row = part.cell + part.cell[cell];
      reach_corners8(part, d, part.cell[cell + 1] - part.cell[cell], [row](int k) { return static_cast<int>(row[k]); }, far);
    }
  }
  return most(most(far[0], far[1]), most(far[2], far[3]));
}

// The same by corners at one place.
TWINBUS_INLINE float extent_at(const SweptPart& part, const F8 (&in)[3], float sign, int place) noexcept {
  if (part.corners == 0) return extent8(part, in, sign, HullBy::kBox)[place];
  const float *x = part.corner, *y = x + part.corners, *z = y + part.corners;
  if (part.cell != nullptr) {
    const F8 d[3] = {in[0] * sign, in[1] * sign, in[2] * sign};
    const int cell = support_cells8(d)[place];
    const float n[3] = {d[0][place], d[1][place], d[2][place]};
    float reach = -1e9F;
    for (const std::uint16_t* c = part.cell + part.cell[cell]; c != part.cell + part.cell[cell + 1]; ++c) {
      const float along = n[0] * x[*c] + n[1] * y[*c] + n[2] * z[*c];
      reach = along > reach ? along : reach;
    }
    return reach;
  }
  F8 far = all(-1e9F);
  for (int k = 0; k < part.corners; k += 8)
    far = most(far, (in[0][place] * load8(x + k) + in[1][place] * load8(y + k) + in[2][place] * load8(z + k)) * sign);
  return largest(far);
}
