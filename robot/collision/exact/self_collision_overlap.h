// Do balls inside of two links overlap?  Part of the kernels of SelfCollision, included after float8.h.

// True only if the links touch; false says nothing.
static bool inner_overlap(const CollisionBody& a, const CollisionBody& b,
                          const CollisionPose& a_to_b) noexcept {
  for (int from = 0; from < a.inner_balls; from += 8) {
    const F8 x = load8(a.inner[0] + from), y = load8(a.inner[1] + from),
             z = load8(a.inner[2] + from), r = load8(a.inner[3] + from);
    F8 center[3];
    I8 apart{};
    for (int d = 0; d < 3; ++d) {
      center[d] = x * a_to_b.column[0][d] + y * a_to_b.column[1][d] + z * a_to_b.column[2][d] +
                  a_to_b.origin[d];
      apart |= (center[d] + r < all(b.low[d])) | (all(b.high[d]) < center[d] - r);
    }
    for (unsigned m = ~bits(apart) & 0xFFU; m != 0; m &= m - 1) {
      const int lane = lowest(m);
      I8 meets{};
      for (int k = 0; k < b.inner_balls; k += 8) {
        const F8 dx = load8(b.inner[0] + k) - center[0][lane],
                 dy = load8(b.inner[1] + k) - center[1][lane],
                 dz = load8(b.inner[2] + k) - center[2][lane];
        const F8 reach = load8(b.inner[3] + k) + r[lane] - all(kInnerSlack);
        meets |= (reach > all(0.0F)) & (dx * dx + dy * dy + dz * dz < reach * reach);
      }
      if (bits(meets) != 0) return true;
    }
  }
  return false;
}
