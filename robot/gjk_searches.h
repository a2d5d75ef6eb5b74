// The kernel of gjk_many.cpp: four searches at once, one a lane.  Included after gjk_lanes.h.
//
// A search has three corners of the difference of the shapes, the first one three times to begin with.  To them
// comes the support point w along -v, and of what has w for a corner (w itself, three edges, three faces) that is
// kept which is nearest to zero.  Corners that are not needed become w, so there are always three.

// The first look, along towards_b.
TWINBUS_INLINE void prepare(const GjkQuery& q, Prepared& to) noexcept {
  const double *a = q.pose_a->data(), *b = q.pose_b->data();
  const Vec4 axes[4] = {load4(a), load4(a + 4), load4(a + 8), Vec4{}};
  Vec4 into_a[4], rows[4];
  transpose(axes, into_a);
  const auto in_a = [&](const Vec4& x) __attribute__((always_inline)) {
    return into_a[0] * x[0] + into_a[1] * x[1] + into_a[2] * x[2];
  };
  const Vec4 turn[4] = {in_a(load4(b)), in_a(load4(b + 4)), in_a(load4(b + 8)), Vec4{}};
  transpose(turn, rows);
  const Vec4 shift = in_a(load4(b + 12) - load4(a + 12));
  const Vec4 given = vec4(q.towards_b), known = dot3(given, given) > 0.0 ? given : shift;
  const Vec4 towards = dot3(known, known) > 0.0 ? known : Vec4{1.0, 0.0, 0.0, 0.0};
  const Vec4 on_a = support(*q.a, towards);
  const Vec4 in_b = support(*q.b, -(rows[0] * towards[0] + rows[1] * towards[1] + rows[2] * towards[2]));
  const Vec4 v = on_a - (turn[0] * in_b[0] + turn[1] * in_b[1] + turn[2] * in_b[2] + shift);
  for (int k = 0; k < 3; ++k) store4(to.turn[k], turn[k]);
  store4(to.shift, shift);
  store4(to.v, v);
  store4(to.on_a, on_a);
  to.above = std::sqrt(dot3(v, v));
  to.below = -dot3(towards, v) / std::sqrt(dot3(towards, towards));
}

TWINBUS_INLINE void put(double (&lanes)[4], const Int4& lane, double number) noexcept {
  store4(lanes, lane ? all4(number) : load4(lanes));
}

// A search is given this lane.
static void begin(GjkQuery& q, const Prepared& from, Searches& s, int lane) noexcept {
  const Int4 here = Int4{0, 1, 2, 3} == Int4{} + lane;
  for (int d = 0; d < 3; ++d) {
    for (int k = 0; k < 3; ++k) {
      put(s.turn[d][k], here, from.turn[k][d]);
      put(s.corner[k][d], here, from.v[d]);
      put(s.on_a[k][d], here, from.on_a[d]);
    }
    put(s.shift[d], here, from.shift[d]);
    put(s.v[d], here, from.v[d]);
    put(s.part[d], here, 0.0);
  }
  put(s.above, here, from.above);
  put(s.below, here, from.below);
  put(s.far, here, q.far + skin(*q.a) + skin(*q.b));
  put(s.steps, here, 0.0);
  s.query[lane] = &q;
}

// It has ended at a distance from `below` to `above`, v from b to a; on_a: where on a.  In a's axes.
TWINBUS_INLINE void answer(GjkQuery& q, double below, double above, const Vec4& v, const Vec4& on_a) noexcept {
  GjkResult& result = q.result;
  result = {};
  const double skin_a = skin(*q.a), skins = skin_a + skin(*q.b);
  if (below > q.far + skins) {
    result.below = below - skins;
    result.distance = result.below > 0.0 ? result.below : 0.0;
    return;
  }
  // They overlap; or a pose is no number, and nothing is known of them.
  if (!(above > kTouching && above > skins)) return;
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
  double part[3], rest = 1.0;
  int others = 0;
  for (int i = 0; i < 3; ++i) {
    part[i] = s.part[i][lane];
    rest -= part[i];
    others += part[i] > 0.0 ? 0 : 1;
  }
  Vec4 on_a{}, v{};
  for (int i = 0; i < 3; ++i) {
    const double weight = part[i] > 0.0 ? part[i] : rest / others;
    on_a += weight * Vec4{s.on_a[i][0][lane], s.on_a[i][1][lane], s.on_a[i][2][lane], 0.0};
  }
  for (int d = 0; d < 3; ++d) v[d] = s.v[d][lane];
  answer(*s.query[lane], s.below[lane], s.above[lane], v, on_a);
}

// Of the lanes that are open the next corners: w, and where they are on a.
TWINBUS_INLINE void look(const Searches& s, unsigned open, Vec4x3& w, Vec4x3& on_a) noexcept {
  Vec4 v[4] = {-load4(s.v[0]), -load4(s.v[1]), -load4(s.v[2]), Vec4{}}, back[4], to_a[4], to_b[4];
  back[3] = Vec4{};
  for (int k = 0; k < 3; ++k)
    back[k] = -(load4(s.turn[0][k]) * v[0] + load4(s.turn[1][k]) * v[1] + load4(s.turn[2][k]) * v[2]);
  transpose(v, to_a);
  transpose(back, to_b);
  Vec4 a[4], b[4], p[4], q[4];
#pragma GCC unroll 4
  for (int lane = 0; lane < 4; ++lane) {
    const bool asked = (open >> lane & 1U) != 0;
    a[lane] = asked ? support(*s.query[lane]->a, to_a[lane]) : Vec4{};
    b[lane] = asked ? support(*s.query[lane]->b, to_b[lane]) : Vec4{};
  }
  transpose(a, p);
  transpose(b, q);
  for (int d = 0; d < 3; ++d) {
    on_a[d] = p[d];
    w[d] = p[d] - (load4(s.turn[d][0]) * q[0] + load4(s.turn[d][1]) * q[1] + load4(s.turn[d][2]) * q[2] +
                   load4(s.shift[d]));
  }
}

// A step of all; bits of those that end.
TWINBUS_INLINE unsigned step(Searches& s, unsigned open, double close) noexcept {
  Vec4x3 w, on_a;
  look(s, open, w, on_a);
  const Vec4x3 v = {load4(s.v[0]), load4(s.v[1]), load4(s.v[2])};
  const Vec4 none{}, length = load4(s.above), before = load4(s.below), steps = load4(s.steps) + 1.0;
  const Vec4 said = dot(v, w) / length, below = said > before ? said : before;
  store4(s.below, below);
  store4(s.steps, steps);
  NearestOfFour nearest;
  nearest_of_four(w, s.corner, nearest);
  const Vec4 root = root4(dot(nearest.v, nearest.v)), now = nearest.inside ? none : root;
  // If not, rounding: what was found is as good as it gets.
  const Int4 nearer = now < length;
  for (int i = 0; i < 3; ++i) {
    const Int4 replaced = nearer & ~(nearest.part[i] > none);
    for (int d = 0; d < 3; ++d) {
      store4(s.corner[i][d], replaced ? w[d] : load4(s.corner[i][d]));
      store4(s.on_a[i][d], replaced ? on_a[d] : load4(s.on_a[i][d]));
    }
    store4(s.part[i], nearer ? nearest.part[i] : load4(s.part[i]));
  }
  for (int d = 0; d < 3; ++d) store4(s.v[d], nearer ? nearest.v[d] : v[d]);
  store4(s.above, nearer ? now : length);
  return lanes_of((below > load4(s.far)) | (length - below <= all4(close)) | ~nearer | (now <= all4(kTouching)) |
               (steps > all4(kMostSteps))) &
         open;
}

static void search(std::span<GjkQuery> queries, double close) noexcept {
  Prepared prepared[kAtOnce];
  Searches s;
  for (std::size_t first = 0; first < queries.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, queries.size() - first);
    std::size_t wanted[kAtOnce], waiting = 0, next = 0;
    for (std::size_t k = 0; k < count; ++k) {
      GjkQuery& q = queries[first + k];
      if (q.a->kind != ShapeKind::kMesh && q.b->kind != ShapeKind::kMesh) {
        q.result = gjk_distance(*q.a, *q.pose_a, *q.b, *q.pose_b, q.far, q.towards_b, close);
        continue;
      }
      prepare(q, prepared[k]);
      wanted[waiting++] = k;
    }
    const auto fill = [&](int lane) {
      for (; next < waiting; ++next) {
        GjkQuery& q = queries[first + wanted[next]];
        const Prepared& from = prepared[wanted[next]];
        if (from.below > q.far + skin(*q.a) + skin(*q.b) || !(from.above > kTouching)) {
          answer(q, from.below, from.above, load4(from.v), load4(from.on_a));
          continue;
        }
        begin(q, from, s, lane);
        ++next;
        return true;
      }
      return false;
    };
    unsigned open = 0;
    for (int lane = 0; lane < 4; ++lane) open |= fill(lane) ? 1U << lane : 0U;
    while (open != 0) {
      for (unsigned ended = step(s, open, close); ended != 0; ended &= ended - 1) {
        const int lane = __builtin_ctz(ended);
        end(s, lane);
        if (!fill(lane)) open &= ~(1U << lane);
      }
    }
  }
}
