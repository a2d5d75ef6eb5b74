// The kernel of NearShapes, included after capsule_lanes.h.

// Of a bound: what single precision may lose, more where coordinates are large [m].
constexpr float kFarSlack = 2e-6F;

// Which of these lanes are within reach, into the list of candidates behind n; how many there are then.
// What the gaps say is kept.
TWINBUS_INLINE int measure(const ShapeTables& t, int a, int first, unsigned open, F8 within, float* until,
                           int n) noexcept {
  F8 u[3], v[3], w[3], towards[3];
  for (int d = 0; d < 3; ++d) {
    u[d] = all(t.along[d][a]);
    v[d] = load8(t.along[d] + first);
    w[d] = load8(t.from[d] + first) - all(t.from[d][a]);
  }
  const F8 gap = segments_gap(u, v, w, towards);
  F8 bound = gap - kFarSlack * size(gap) - load8(t.radius + first) - all(t.radius[a] + kCapsuleSlack);
  if (until != nullptr) {
    const F8 walked = load8(t.walked + first) + all(t.walked[a]);
    const I8 keeps = I8{0, 1, 2, 3, 4, 5, 6, 7} + first < t.keeping;
    const F8 old = load8(until);
    const F8 now = keeps ? most(old, bound + walked - kKeptSlack) : old;
    __builtin_memcpy(until, &now, sizeof now);
    bound = most(bound, old - walked);
  }
  for (open &= bits(bound <= within); open != 0; open &= open - 1) {
    const int lane = lowest(open);
    auto& found = t.found[n++];
    found.a = a;
    found.b = first + lane;
    found.bound = bound[lane];
    for (int d = 0; d < 3; ++d) found.towards[d] = towards[d][lane];
  }
  return n;
}

// Of eight pairs those whose balls are within reach.
TWINBUS_INLINE unsigned near_balls(const ShapeTables& t, int a, int first, F8 within) noexcept {
  F8 far2 = all(0.0F);
  for (int d = 0; d < 3; ++d) {
    const F8 far = load8(t.middle[d] + first) - all(t.middle[d][a]);
    far2 += far * far;
  }
  const F8 sum = load8(t.round + first) + all(t.round[a]) + within;
  return bits((far2 <= sum * sum * 1.00001F) & (sum >= all(0.0F)));
}

// Pairs whose bound is at most reach, or at most ahead after their travel; how many.
static int near_shapes(const ShapeTables& t, float reach, float ahead) noexcept {
  int n = 0;
  for (int a = 0; a < t.shapes; ++a) {
    const F8 then = all(t.travel[a] + ahead);
    for (int block = (a + 1) / 8; block < t.blocks; ++block) {
      unsigned open = t.wanted[a * t.blocks + block];
      if (open == 0) continue;
      const int first = 8 * block;
      const F8 within = most(all(reach), load8(t.travel + first) + then);
      open &= near_balls(t, a, first, within);
      if (open != 0) n = measure(t, a, first, open, within, nullptr, n);
    }
  }
  return n;
}

// The same by what is kept, which says more than balls around shapes that both keep something.
static int near_kept_shapes(const ShapeTables& t, float reach, float ahead) noexcept {
  for (int first = 0; first < 8 * t.blocks; first += 8) {
    const F8 end = load8(t.walked + first) + load8(t.travel + first);
    __builtin_memcpy(t.end + first, &end, sizeof end);
  }
  const int balls_from = t.keeping < t.shapes ? t.keeping - 7 : 8 * t.blocks;
  int n = 0;
  for (int a = 0; a < t.shapes; ++a) {
    const F8 now = all(t.walked[a] + reach), then = all(t.end[a] + ahead);
    for (int block = (a + 1) / 8; block < t.blocks; ++block) {
      const int first = 8 * block;
      float* until = t.until + 8 * (a * t.blocks + block);
      const F8 used_up = most(load8(t.walked + first) + now, load8(t.end + first) + then);
      unsigned open = bits(load8(until) <= used_up);
      if (open == 0) continue;
      const F8 within = most(all(reach), load8(t.travel + first) + all(t.travel[a] + ahead));
      open &= t.wanted[a * t.blocks + block];
      if (first >= balls_from) open &= near_balls(t, a, first, within);
      if (open != 0) n = measure(t, a, first, open, within, until, n);
    }
  }
  return n;
}
