// The kernels of SweptShapes, a lane for every place; included after continuous_extent.h.

constexpr float kSweptSlack = 5e-6F;  // what single precision may lose of a gap [m]
TWINBUS_INLINE void store8(float* to, const F8& v) noexcept { __builtin_memcpy(to, &v, sizeof v); }

struct Pose8 {
  F8 column[3][3], origin[3];
};
TWINBUS_INLINE Pose8 pose8(const float* from) noexcept {
  Pose8 p;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) p.column[c][r] = load8(from + 8 * (3 * c + r));
  for (int r = 0; r < 3; ++r) p.origin[r] = load8(from + 8 * (9 + r));
  return p;
}
TWINBUS_INLINE void store_pose8(float* to, const Pose8& p) noexcept {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) store8(to + 8 * (3 * c + r), p.column[c][r]);
  for (int r = 0; r < 3; ++r) store8(to + 8 * (9 + r), p.origin[r]);
}
// Of the axis d: what the pose makes of v.
TWINBUS_INLINE F8 turned8(const Pose8& p, int d, F8 x, F8 y, F8 z) noexcept {
  return p.column[0][d] * x + p.column[1][d] * y + p.column[2][d] * z;
}

// Of links that are asked for and stale, which those behind them are too, until they are asked for.
static void go(const SweptTables& t) noexcept {
  for (int link = 1; link < t.links; ++link) {
    const SweptHinge& hinge = t.hinge[link - 1];
    t.stale[link] |= t.fresh[hinge.parent];
    t.fresh[link] = t.stale[link] & t.asked[link];
    if (t.fresh[link] == 0) continue;
    t.stale[link] = 0;
    const Pose8 parent = pose8(t.link_pose + 96 * hinge.parent);
    const F8 s = load8(t.sine + 8 * (link - 1)), c = load8(t.cosine + 8 * (link - 1)),
             slide = load8(t.slide + 8 * (link - 1));
    Pose8 child;
    for (int k = 0; k < 3; ++k) {
      F8 v[3];
      for (int r = 0; r < 3; ++r)
        v[r] = hinge.still[k][r] + c * hinge.with_cosine[k][r] + s * hinge.with_sine[k][r];
      for (int d = 0; d < 3; ++d) child.column[k][d] = turned8(parent, d, v[0], v[1], v[2]);
    }
    F8 o[3];
    for (int r = 0; r < 3; ++r) o[r] = hinge.offset[r] + slide * hinge.slide[r];
    for (int d = 0; d < 3; ++d)
      child.origin[d] = parent.origin[d] + turned8(parent, d, o[0], o[1], o[2]);
    store_pose8(t.link_pose + 96 * link, child);
  }
  for (int i = 0; i < t.parts; ++i) {
    const SweptPart& part = t.part[i];
    if (part.link < 0 || t.fresh[part.link] == 0) continue;
    const Pose8 link = pose8(t.link_pose + 96 * part.link);
    Pose8 p = link;
    if (part.turned) {
      for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d)
          p.column[k][d] = turned8(link, d, all(part.column[k][0]), all(part.column[k][1]),
                                   all(part.column[k][2]));
    }
    for (int d = 0; d < 3; ++d)
      p.origin[d] = link.origin[d] +
                    turned8(link, d, all(part.origin[0]), all(part.origin[1]), all(part.origin[2]));
    store_pose8(t.part_pose + 96 * i, p);
  }
}

// What joints leave out by themselves, then what links do and how far they go, seen from link 0: the
// reach of a joint is the radius of the link and the length of the stretched chain between, so that the
// sum over the joints is (radius + length) times one sum, less another.
static void leave_out(const SweptTables& t) noexcept {
  for (int link = 1; link < t.links; ++link) {
    if (t.fresh[link] == 0) continue;
    const SweptHinge& hinge = t.hinge[link - 1];
    const F8 step = load8(t.moves + 8 * (link - 1)), bend = load8(t.bend + 8 * (link - 1));
    const F8 move = step * 0.5F, way = step + 2.0F * bend;
    const F8 before = load8(t.turn + 8 * hinge.parent);
    const F8 own = hinge.turns ? move : all(0.0F);
    const F8 left = bend + move * (0.5F * own + before);
    store8(t.turn + 8 * link, before + own);
    store8(t.left + 8 * (link - 1), left);
    const float turns = hinge.turns ? 1.0F : 0.0F, slides = 1.0F - turns, length = t.length[link];
    const F8 add[4] = {left * turns, left * (turns * length - slides), way * turns,
                       way * (turns * length - slides)};
    F8 sum[4];
    for (int k = 0; k < 4; ++k) {
      sum[k] = load8(t.sums + 8 * (4 * hinge.parent + k)) + add[k];
      store8(t.sums + 8 * (4 * link + k), sum[k]);
    }
    const float end = t.radius[link] + length;
    store8(t.link_left_out + 8 * link, (end * sum[0] - sum[1]) * 1.0001F + 1e-7F);
    t.half_travel[link] = 0.50005F * largest(end * sum[2] - sum[3]) + 1e-7F;
  }
}

// Calls with every joint between the links of a pair, its reach and how far the joints above both turn.
template <class Visit>
TWINBUS_INLINE void between_links(const SweptTables& t, const SweptPair& pair,
                                  Visit visit) noexcept {
  for (const int link : {pair.link_a, pair.link_b}) {
    for (int k = link; k > pair.common; k = t.hinge[k - 1].parent)
      visit(k - 1, t.reach[link * t.joints + k - 1]);
  }
}
TWINBUS_INLINE F8 pair_left_out(const SweptTables& t, const SweptPair& pair) noexcept {
  F8 sum = all(0.0F);
  const F8 above = load8(t.turn + 8 * pair.common);
  between_links(t, pair, [&](int j, float reach) {
    sum += reach * (load8(t.left + 8 * j) - 0.5F * load8(t.moves + 8 * j) * above);
  });
  return sum * 1.0001F;
}
TWINBUS_INLINE F8 pair_travel(const SweptTables& t, const SweptPair& pair) noexcept {
  F8 sum = all(0.0F);
  between_links(t, pair, [&](int j, float reach) {
    sum += reach * (load8(t.moves + 8 * j) + 2.0F * load8(t.bend + 8 * j));
  });
  return sum * 1.0001F;
}

// A direction, n, in the axes of both shapes, and how far their middles are apart along it, less what may be lost.
struct Along8 {
  F8 in_a[3], in_b[3], apart;
};
// n0: in the axes of the link that both hang on.
TWINBUS_INLINE Along8 along8(const SweptTables& t, const SweptPair& pair, const float* n0) noexcept {
  const Pose8 a = pose8(t.part_pose + 96 * pair.a), b = pose8(t.part_pose + 96 * pair.b);
  const float* frame = t.link_pose + 96 * pair.common;
  F8 n[3];
  for (int d = 0; d < 3; ++d)
    n[d] = load8(frame + 8 * d) * n0[0] + load8(frame + 8 * (3 + d)) * n0[1] +
           load8(frame + 8 * (6 + d)) * n0[2];
  Along8 along{{}, {}, all(-kSweptSlack)};
  for (int d = 0; d < 3; ++d) {
    along.apart += n[d] * (b.origin[d] - a.origin[d]);
    along.in_a[d] = a.column[d][0] * n[0] + a.column[d][1] * n[1] + a.column[d][2] * n[2];
    along.in_b[d] = b.column[d][0] * n[0] + b.column[d][1] * n[1] + b.column[d][2] * n[2];
  }
  return along;
}

TWINBUS_INLINE F8 gaps8(const SweptTables& t, const SweptPair& pair, const Along8& along, HullBy hulls) noexcept {
  return along.apart - extent8(t.part[pair.a], along.in_a, 1.0F, hulls) -
         extent8(t.part[pair.b], along.in_b, -1.0F, hulls);
}

// The same by corners, of these lanes and those that were asked for before; at others no less than it is.
struct CornerGaps8 {
  CornerReach8 a, b;
};
TWINBUS_INLINE CornerGaps8 corner_gaps8(const SweptTables& t, const SweptPair& pair, const Along8& along) noexcept {
  return {corner_reach8(t.part[pair.a], along.in_a, 1.0F), corner_reach8(t.part[pair.b], along.in_b, -1.0F)};
}
TWINBUS_INLINE F8 gaps_of(const SweptTables& t, const SweptPair& pair, const Along8& along, unsigned lanes,
                          CornerGaps8& by) noexcept {
  return along.apart - extent_by_corners8(t.part[pair.a], along.in_a, lanes, by.a) -
         extent_by_corners8(t.part[pair.b], along.in_b, lanes, by.b);
}

static void pair_gaps(const SweptTables& t, const SweptPair& pair, const float* n0,
                      float* gaps) noexcept {
  const Along8 along = along8(t, pair, n0);
  CornerGaps8 by = corner_gaps8(t, pair, along);
  store8(gaps, gaps_of(t, pair, along, kAllLanes, by));
}
// All that is known of a pair before anything is measured: rows of eight.
static void pair_bounds(const SweptTables& t, const SweptPair& pair, float* gaps, float* left_out, float* most_apart,
                        float* travel) noexcept {
  pair_gaps(t, pair, pair.n, gaps);
  store8(left_out, pair_left_out(t, pair));
  store8(travel, pair_travel(t, pair));
  // Farther apart than the balls inside of them shapes are not.
  F8 way[3] = {}, far2 = all(0.0F);
  for (const int part : {pair.a, pair.b}) {
    const Pose8 p = pose8(t.part_pose + 96 * part);
    const float *c = t.part[part].inside, sign = part == pair.a ? -1.0F : 1.0F;
    for (int d = 0; d < 3; ++d)
      way[d] += (p.origin[d] + turned8(p, d, all(c[0]), all(c[1]), all(c[2]))) * sign;
  }
  for (const F8& w : way) far2 += w * w;
  store8(most_apart, root(far2) * 1.0001F - t.part[pair.a].inside_radius - t.part[pair.b].inside_radius + kSweptSlack);
}
