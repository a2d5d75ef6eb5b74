// Which clusters of two links can touch, by the boxes around them?  Part of the kernels of SelfCollision, included
// after triangle_sat.h.

// A box of a cluster of one link as the other link sees it.
struct alignas(32) MovedBox {
  float middle[3];
  int cluster;
  float half[3];  // along the other's axes
  float none;
};

// Boxes of a's clusters that meet the box of b, into kept; low, high: the box around all of them, in b's axes.
static int keep_boxes(const CollisionBody& a, const CollisionPose& a_to_b, const CollisionBody& b,
                      MovedBox* kept, float (&low)[3], float (&high)[3]) noexcept {
  const float(*x)[4] = a_to_b.column;
  float span[3][3];
  for (int k = 0; k < 3; ++k) {
    for (int d = 0; d < 3; ++d) span[k][d] = x[k][d] < 0.0F ? -x[k][d] : x[k][d];
  }
  F8 low8[3], high8[3];
  for (int d = 0; d < 3; ++d) {
    low8[d] = all(1e9F);
    high8[d] = all(-1e9F);
  }
  int n = 0;
  const int blocks = (a.clusters + 7) / 8;
  for (int group = 0; group < blocks; group += 8) {
    unsigned groups = 0xFFU;
    if (blocks > 2) {  // balls around eight clusters first
      const F8 cx = load8(a.block_center[0] + group), cy = load8(a.block_center[1] + group),
               cz = load8(a.block_center[2] + group), r = load8(a.block_radius + group);
      I8 apart{};
      for (int d = 0; d < 3; ++d) {
        const F8 c = cx * x[0][d] + cy * x[1][d] + cz * x[2][d] + a_to_b.origin[d];
        apart |= (c + r < all(b.low[d])) | (all(b.high[d]) < c - r);
      }
      groups = ~bits(apart) & 0xFFU;
    }
    for (; groups != 0; groups &= groups - 1) {
      const int block = group + lowest(groups);
      if (block >= blocks) break;
      const int first = 8 * block;
      const F8 mx = load8(a.box_middle[0] + first), my = load8(a.box_middle[1] + first),
               mz = load8(a.box_middle[2] + first);
      const F8 hx = load8(a.box_half[0] + first), hy = load8(a.box_half[1] + first),
               hz = load8(a.box_half[2] + first);
      alignas(32) float m[3][8], h[3][8];
      F8 from[3], to[3];
      I8 apart{};
      for (int d = 0; d < 3; ++d) {
        const F8 middle = mx * x[0][d] + my * x[1][d] + mz * x[2][d] + a_to_b.origin[d];
        const F8 half = hx * span[0][d] + hy * span[1][d] + hz * span[2][d];
        from[d] = middle - half;
        to[d] = middle + half;
        apart |= (to[d] < all(b.low[d])) | (all(b.high[d]) < from[d]);
        __builtin_memcpy(m[d], &middle, sizeof middle);
        __builtin_memcpy(h[d], &half, sizeof half);
      }
      unsigned meets = ~bits(apart) & 0xFFU;
      if (meets == 0) continue;
      for (int d = 0; d < 3; ++d) {
        low8[d] = least(low8[d], apart != 0 ? all(1e9F) : from[d]);
        high8[d] = most(high8[d], apart != 0 ? all(-1e9F) : to[d]);
      }
      for (; meets != 0; meets &= meets - 1) {
        const int lane = lowest(meets);
        MovedBox& box = kept[n++];
        box.cluster = first + lane;
        for (int d = 0; d < 3; ++d) {
          box.middle[d] = m[d][lane];
          box.half[d] = h[d][lane];
        }
      }
    }
  }
  for (int d = 0; d < 3; ++d) {
    low[d] = -largest(-low8[d]);
    high[d] = largest(high8[d]);
  }
  return n;
}

// Of eight clusters of a link from `first` on: those whose boxes meet this one, in the link's axes.
TWINBUS_INLINE unsigned meet_box(const CollisionBody& body, int first, const F8 (&low)[3],
                                 const F8 (&high)[3]) noexcept {
  I8 apart{};
  for (int d = 0; d < 3; ++d)
    apart |=
        (load8(body.box_high[d] + first) < low[d]) | (high[d] < load8(body.box_low[d] + first));
  return ~bits(apart) & 0xFFU;
}

// The boxes of eight clusters in the other's axes: middle and half edges, eight numbers each.
TWINBUS_INLINE void place_boxes(const CollisionBody& body, int first, const CollisionPose& to,
                                float* placed) noexcept {
  const F8 mx = load8(body.box_middle[0] + first), my = load8(body.box_middle[1] + first),
           mz = load8(body.box_middle[2] + first);
  const F8 hx = load8(body.box_half[0] + first), hy = load8(body.box_half[1] + first),
           hz = load8(body.box_half[2] + first);
  for (int d = 0; d < 3; ++d) {
    const F8 x = all(to.column[0][d]), y = all(to.column[1][d]), z = all(to.column[2][d]);
    const F8 middle = mx * x + my * y + mz * z + to.origin[d];
    const F8 half = hx * size(x) + hy * size(y) + hz * size(z);
    __builtin_memcpy(placed + 8 * d, &middle, sizeof middle);
    __builtin_memcpy(placed + 24 + 8 * d, &half, sizeof half);
  }
}
// Which of them meet the box of a cluster, in the axes of that?
TWINBUS_INLINE unsigned meet_placed(const CollisionBody& a, int ca, const float* placed) noexcept {
  I8 apart{};
  for (int d = 0; d < 3; ++d)
    apart |=
        size(load8(placed + 8 * d) - a.middle[ca][d]) > load8(placed + 24 + 8 * d) + a.half[ca][d];
  return ~bits(apart) & 0xFFU;
}

// The box of cluster cb of b in a's axes; does it lie apart from that of cluster ca of a?
TWINBUS_INLINE bool box_apart(const CollisionBody& a, int ca, const CollisionPose& b_to_a,
                              const CollisionBody& b, int cb, F4& middle, F4& half) noexcept {
  const float* h = b.half[cb];
  const F4 x = load4f(b_to_a.column[0]) * h[0], y = load4f(b_to_a.column[1]) * h[1],
           z = load4f(b_to_a.column[2]) * h[2];
  half = size4(x) + size4(y) + size4(z);
  middle = moved(b_to_a, b.middle[cb]);
  const F4 gap = middle - load4f(a.middle[ca]);
  return any3(size4(gap) > half + load4f(a.half[ca]));
}
