// The kernel of NearShapes, included after capsule_lanes.h.

// Of a bound: what single precision may lose, more where coordinates are large [m].
constexpr float kFarSlack = 2e-6F;

// Pairs whose bound is at most reach, or at most ahead after their travel; how many.
static int near_shapes(const ShapeTables& t, float reach, float ahead) noexcept {
  int n = 0;
  for (int a = 0; a < t.shapes; ++a) {
    F8 p[3], u[3], c[3];
    for (int d = 0; d < 3; ++d) {
      p[d] = all(t.from[d][a]);
      u[d] = all(t.along[d][a]);
      c[d] = all(t.middle[d][a]);
    }
    const F8 round = all(t.round[a]), then = all(t.travel[a] + ahead), radius = all(t.radius[a] + kCapsuleSlack);
    for (int block = (a + 1) / 8; block < t.blocks; ++block) {
      unsigned open = t.wanted[a * t.blocks + block];
      if (open == 0) continue;
      const int first = 8 * block;
      F8 far2 = all(0.0F);
      for (int d = 0; d < 3; ++d) {
        const F8 far = load8(t.middle[d] + first) - c[d];
        far2 += far * far;
      }
      const F8 within = most(all(reach), load8(t.travel + first) + then);
      const F8 sum = load8(t.round + first) + round + within;
      open &= bits((far2 <= sum * sum * 1.00001F) & (sum >= all(0.0F)));
      if (open == 0) continue;
      F8 v[3], w[3];
      for (int d = 0; d < 3; ++d) {
        v[d] = load8(t.along[d] + first);
        w[d] = load8(t.from[d] + first) - p[d];
      }
      F8 towards[3];
      const F8 gap = segments_gap(u, v, w, towards);
      const F8 bound = gap - kFarSlack * size(gap) - load8(t.radius + first) - radius;
      for (open &= bits(bound <= within); open != 0; open &= open - 1) {
        const int lane = lowest(open);
        auto& found = t.found[n++];
        found.a = a;
        found.b = first + lane;
        found.bound = bound[lane];
        for (int d = 0; d < 3; ++d) found.towards[d] = towards[d][lane];
      }
    }
  }
  return n;
}
