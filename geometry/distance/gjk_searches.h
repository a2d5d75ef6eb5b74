// The kernel of gjk_many.cpp: several searches at once, one a lane.  Included after gjk_lane_supports.h.
//
// A search has three corners of the difference of the shapes, all of them the support point of its first direction to
// begin with.  To them comes the support point w along -v, and of what has w for a corner (w itself, three edges,
// three faces) that is kept which is nearest to zero.  Corners that are not needed become w, so there are always three.

// Searches, each in the axes of its a: of every number those of all lanes.
struct alignas(64) Searches {
  Numbers turn[3][3] = {}, shift[3] = {};  // of b
  Numbers v[3] = {}, above = {}, below = {}, far = {}, steps = {};
  Numbers corner[3][3] = {}, part[3] = {};
  Numbers look[3] = {};         // in which the corners were found
  Numbers on_a[kKeptLooks][3];  // of the last looks: where on a
  int looks = 0;
  GjkQuery* query[kLanes] = {};
  Shapes a, b;
};

// A search is given this lane.
static void begin(GjkQuery& q, Searches& s, int lane) noexcept {
  const double *a = q.pose_a->data(), *b = q.pose_b->data();
  const Vec4 axes[4] = {load4(a), load4(a + 4), load4(a + 8), Vec4{}};
  Vec4 into_a[4];
  transpose(axes, into_a);
  const auto in_a = [&](const Vec4& x) __attribute__((always_inline)) {
    return into_a[0] * x[0] + into_a[1] * x[1] + into_a[2] * x[2];
  };
  const Vec4 turn[3] = {in_a(load4(b)), in_a(load4(b + 4)), in_a(load4(b + 8))};
  const Vec4 shift = in_a(load4(b + 12) - load4(a + 12));
  const Vec4 given = vec4(q.towards_b), known = dot3(given, given) > 0.0 ? given : shift;
  const Vec4 towards = dot3(known, known) > 0.0 ? known : Vec4{1.0, 0.0, 0.0, 0.0};
  const Mask here = mask_of(1U << lane);
  const auto put = [&](Numbers & numbers, double number) __attribute__((always_inline)) {
    store(numbers, pick(here, all(number), load(numbers)));
  };
  for (int d = 0; d < 3; ++d) {
    for (int k = 0; k < 3; ++k) put(s.turn[d][k], turn[k][d]);
    put(s.shift[d], shift[d]);
    put(s.v[d], -towards[d]);
  }
  put(s.above, std::sqrt(dot3(towards, towards)));
  put(s.below, -kNothing);
  put(s.far, q.far + skin(*q.a) + skin(*q.b));
  put(s.steps, 0.0);
  s.query[lane] = &q;
  s.a.set(lane, *q.a);
  s.b.set(lane, *q.b);
}

// It has ended at a distance from `below` to `above`, v from b to a; on_a: where on a.  In a's axes.
TWINBUS_INLINE void answer(GjkQuery& q, double below, double above, const Vec4& v,
                           const Vec4& on_a) noexcept {
  GjkResult& result = q.result;
  result = {};
  const double skin_a = skin(*q.a), skins = skin_a + skin(*q.b);
  if (below > q.far + skins) {
    result.below = below - skins;
    result.distance = result.below > 0.0 ? result.below : 0.0;
    return;
  }
  // They overlap; or a pose is no number, and nothing is known of them.
  if (!(above > kGjkTouching && above > skins)) return;
  result.below = (below > 0.0 ? below : 0.0) - skins;
  result.distance = above - skins;
  const Columns turn = columns(q.pose_a->data(), 4);
  const Vec4 normal = turn.times(v * (-1.0 / above));
  const Vec4 point = turn.times(on_a) + load4(q.pose_a->data() + 12) + skin_a * normal;
  result.point_a = vector3(point);
  result.point_b = vector3(point + result.distance * normal);
  result.normal = vector3(normal);
}

static void end(const Searches& s, int lane) noexcept {
  // What the parts leave of one is shared by the corners that became w.
  constexpr double kShare[4] = {0.0, 1.0, 1.0 / 2.0, 1.0 / 3.0};
  double part[3], rest = 1.0;
  int others = 0;
  for (int i = 0; i < 3; ++i) {
    part[i] = s.part[i][lane];
    rest -= part[i];
    others += part[i] > 0.0 ? 0 : 1;
  }
  rest *= kShare[others];
  Vec4 on_a{}, v{};
  for (int i = 0; i < 3; ++i) {
    const double weight = part[i] > 0.0 ? part[i] : rest;
    const Numbers(&look)[3] = s.on_a[static_cast<int>(s.look[i][lane])];
    on_a += weight * Vec4{look[0][lane], look[1][lane], look[2][lane], 0.0};
  }
  for (int d = 0; d < 3; ++d) v[d] = s.v[d][lane];
  answer(*s.query[lane], s.below[lane], s.above[lane], v, on_a);
}

// Of the lanes that are open the next corners: w, and where they are on a.
TWINBUS_INLINE void look(const Searches& s, unsigned open, Lanes3& w, Lanes3& on_a) noexcept {
  const Lanes3 v = {-load(s.v[0]), -load(s.v[1]), -load(s.v[2])};
  Lanes3 back, on_b;
  for (int k = 0; k < 3; ++k)
    back[k] = -(load(s.turn[0][k]) * v[0] + load(s.turn[1][k]) * v[1] + load(s.turn[2][k]) * v[2]);
  supports(s.a, s.query, &GjkQuery::a, open, v, on_a);
  supports(s.b, s.query, &GjkQuery::b, open, back, on_b);
  for (int d = 0; d < 3; ++d) {
    w[d] = on_a[d] - (load(s.turn[d][0]) * on_b[0] + load(s.turn[d][1]) * on_b[1] +
                      load(s.turn[d][2]) * on_b[2] + load(s.shift[d]));
  }
}

// A step of all; bits of those that end.  In the first one of a search v is only a direction, and `above` its length.
TWINBUS_INLINE unsigned step(Searches& s, unsigned open, double close) noexcept {
  Lanes3 w, on_a;
  look(s, open, w, on_a);
  const int number = s.looks++ % kKeptLooks;
  for (int d = 0; d < 3; ++d) store(s.on_a[number][d], on_a[d]);
  const Lanes3 v = {load(s.v[0]), load(s.v[1]), load(s.v[2])};
  const Lanes none{}, length = load(s.above), before = load(s.below), steps = load(s.steps);
  const Mask first = at_least(none, steps);
  const Lanes said = dot(v, w) / length, below = pick(above(said, before), said, before);
  store(s.below, below);
  store(s.steps, steps + 1.0);
  Lanes3 corner[3];
  for (int i = 0; i < 3; ++i)
    for (int d = 0; d < 3; ++d) corner[i][d] = pick(first, w[d], load(s.corner[i][d]));
  NearestOfFour nearest;
  nearest_of_four(w, corner, nearest);
  const Lanes now = pick(nearest.inside, none, root(dot(nearest.v, nearest.v)));
  // If not, rounding: what was found is as good as it gets.
  const Mask nearer = above(length, now) | first;
  for (int i = 0; i < 3; ++i) {
    const Mask replaced = nearer & ~above(nearest.part[i], none);
    for (int d = 0; d < 3; ++d) store(s.corner[i][d], pick(replaced, w[d], corner[i][d]));
    store(s.look[i], pick(replaced, all(number), load(s.look[i])));
    store(s.part[i], pick(nearer, nearest.part[i], load(s.part[i])));
  }
  for (int d = 0; d < 3; ++d) store(s.v[d], pick(nearer, nearest.v[d], v[d]));
  store(s.above, pick(nearer, now, length));
  // That v parts them so far proves its normal too, so the search ends only where v stays as it was.
  return lanes_of(above(below, load(s.far)) | (at_least(all(close), length - below) & ~first) |
                  ~nearer | at_least(all(kGjkTouching), now) |
                  at_least(steps, all(kGjkMostSteps))) &
         open;
}

static void search(std::span<GjkQuery> queries, double close) noexcept {
  Searches s;
  std::size_t next = 0;
  const auto fill = [&](int lane) {
    for (; next < queries.size(); ++next) {
      GjkQuery& q = queries[next];
      if (q.a->kind == ShapeKind::kMesh || q.b->kind == ShapeKind::kMesh) {
        begin(q, s, lane);
        ++next;
        return true;
      }
      q.result = gjk_distance(*q.a, *q.pose_a, *q.b, *q.pose_b, q.far, q.towards_b, close);
    }
    return false;
  };
  unsigned open = 0;
  for (int lane = 0; lane < kLanes; ++lane) open |= fill(lane) ? 1U << lane : 0U;
  while (open != 0) {
    for (unsigned ended = step(s, open, close); ended != 0; ended &= ended - 1) {
      const int lane = __builtin_ctz(ended);
      end(s, lane);
      if (!fill(lane)) open &= ~(1U << lane);
    }
  }
}
