// Can a plane be put between the hulls of two links?  Part of the kernels of SelfCollision, included after float8.h.

constexpr int kMostProbes = 4;

// Which corner of the hull is the farthest along (x, y, z), and how far.
TWINBUS_INLINE int farthest_corner(const CollisionBody& body, float x, float y, float z,
                                   float& far) noexcept {
  const F8 dx = all(x), dy = all(y), dz = all(z);
  F8 best = load8(body.hull[0]) * dx + load8(body.hull[1]) * dy + load8(body.hull[2]) * dz;
  I8 where{0, 1, 2, 3, 4, 5, 6, 7}, now = where;
  for (int i = 8; i < body.hull_corners; i += 8) {
    now += 8;
    const F8 value =
        load8(body.hull[0] + i) * dx + load8(body.hull[1] + i) * dy + load8(body.hull[2] + i) * dz;
    const I8 better = value > best;
    best = better ? value : best;
    where = better ? now : where;
  }
  // Then the first lane that has the largest.
  const F8 top = largest8(best);
  far = top[0];
  const unsigned at_top = bits(best >= top);
  return at_top == 0 ? 0 : where[lowest(at_top)];
}

// From `n` (unit, in b's axes, from a to b) on to directions that part them better: each is the last
// one mirrored at the plane that is square to the gap of the corners it found (Chung and Wang).
static bool hulls_apart(const CollisionBody& a, const CollisionBody& b, const CollisionPose& a_to_b,
                        float (&n)[4], int probes) noexcept {
  for (int probe = 0; probe < probes; ++probe) {
    float in_a[3];
    for (int k = 0; k < 3; ++k)
      in_a[k] =
          a_to_b.column[k][0] * n[0] + a_to_b.column[k][1] * n[1] + a_to_b.column[k][2] * n[2];
    float far_a = 0.0F, far_b = 0.0F;
    const int i = farthest_corner(a, in_a[0], in_a[1], in_a[2], far_a);
    const int j = farthest_corner(b, -n[0], -n[1], -n[2], far_b);
    const float shift = a_to_b.origin[0] * n[0] + a_to_b.origin[1] * n[1] + a_to_b.origin[2] * n[2];
    const float gap = -far_b - far_a - shift;
    if (gap > kHullSlack) return true;
    const float p[3] = {a.hull[0][i], a.hull[1][i], a.hull[2][i]};
    const F4 on_a = moved(a_to_b, p);
    const F4 r = F4{b.hull[0][j], b.hull[1][j], b.hull[2][j], 0.0F} - on_a;
    const float length2 = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    if (!(length2 > 1e-12F)) return false;
    const float turn = -2.0F * gap / length2;
    for (int k = 0; k < 3; ++k) n[k] += turn * r[k];
    const float scale = 1.0F / __builtin_sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; ++k) n[k] *= scale;
  }
  return false;
}
