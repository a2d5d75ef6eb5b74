// What one block of postures has near it: groups with obstacles, and pairs of groups.  Included once per instruction set, inside a
// namespace, by check.cpp: no #pragma once.

// How far the middle of the group is, on the way between two postures, from where it is in the
// nearer one, at most.  Its way c(t) stays within h^2 max |c''| / 8 of the chord over a step h in t,
// and |c''| is at most (sum |step|) (sum |step| travel).  turn: the angle that the group turns.
TWINBUS_INLINE Lanes gap_of(const BlockWork& w, int g, float steps, Lanes& turn) {
  const float angle = w.angle[g / 8][g % 8];
  const float bend = steps * w.swing[g / 8][g % 8] * (1.0F / 64.0F);
  const Lanes* p = w.around[g];
  const Lanes b[3] = {before(p[0]), before(p[1]), before(p[2])};
  Lanes half = all(0.5F) * root(apart(p, b));
  half[0] = 2.0F * half[1] + bend;  // the posture before the first is not looked at
  turn = all(angle * 0.0625F);
  turn[0] = angle * 0.125F;
  return most(half, behind(half)) + all(bend * 0.125F + 1e-5F);
}

// Is a ball inside of the group seen to touch, in a lane that is asked?  touch(p, radius): where a ball at p does.
template <class Touch>
TWINBUS_INLINE bool touches_inside(const BlockRobot& robot, const BlockWork& w, const BlockGroup& group, const Flags& asked,
                                   const Touch& touch) {
  for (int i = group.first_inner; i < group.first_inner + group.inner_count; ++i) {
    const BlockBall& ball = robot.inner[static_cast<std::size_t>(i)];
    Lanes p[3];
    place(w, group.body, ball, p);
    if (any(touch(p, ball.radius) & asked)) return true;
  }
  return false;
}

// Is the convex body of group g clear of the shape in all lanes where balls touch?
TWINBUS_INLINE bool settled(const BlockRobot& robot, const BlockScene& scene, const BlockWork& w, int g, int obstacle,
                            const Flags& touched) {
  const BlockShape& shape = scene.shapes[static_cast<std::size_t>(obstacle)];
  const float kept = kept_of_shape(robot, g, obstacle);
  const auto touch = [&](const Lanes* p, float radius) { return meets(shape, p, all(radius)); };
  if (touches_inside(robot, w, robot.groups[static_cast<std::size_t>(g)], touched, touch)) return false;
  Flags far, apart_at_all;
  separate(robot, w, g, shape, kept, all(kRounding + kept), nullptr, nullptr, touched, far, apart_at_all);
  return !any(touched & ~far);
}

// The obstacles near group g; false when one is touched.  Fills the list when the line goes on.
inline bool group_free(const BlockRobot& robot, const BlockScene& scene, BlockWork& w, int g,
                       bool goes_on) {
  const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
  const Lanes* p = w.around[g];
  const Lanes reach = w.reach[g];
  Lanes low[3], high[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = all(lowest(p[i] - reach));
    high[i] = all(highest(p[i] + reach));
  }
  const int count = static_cast<int>(scene.shapes.size());
  for (int first = 0; first < count; first += 8) {
    for (unsigned m = boxes_that_meet(scene, first, low, high); m != 0; m &= m - 1) {
      const int o = first + __builtin_ctz(m);
      if (kept_of_shape(robot, g, o) < 0.0F) continue;
      const BlockShape& shape = scene.shapes[static_cast<std::size_t>(o)];
      if (!any(meets(shape, p, reach))) continue;
      place_balls(robot, w, g);
      BlockWork::Near found{g, o, w.near_ball_count, 0};
      Flags touched = {};
      const float rind = rind_of(shape);
      for (int k = group.first; k < group.first + group.count; ++k) {
        const float radius = robot.balls[static_cast<std::size_t>(k)].radius;
        const float sum = radius + rind;
        const Lanes square = square_to_core(shape, w.ball[k]);
        Lanes far = all(sum);
        if (goes_on) {
          const float inside = group.around.radius - radius;
          far += reach - all(group.around.radius) + w.turn[g] * all(inside);
        }
        if (!any(square < far * far)) continue;
        touched |= square < all(sum * sum);
        if ((group.piece_count == 0 || !w.settles[g]) && !w.notes && any(touched)) return false;
        if (!goes_on) continue;
        w.near_ball[w.near_ball_count++] = k;
        ++found.count;
      }
      if (w.notes) {
        w.settles[g] = w.settles[g] || any(touched);
        w.fine[g] = w.fine[g] || (any(touched) && !settled(robot, scene, w, g, o, touched));
      } else if (any(touched) && !settled(robot, scene, w, g, o, touched)) {
        return false;
      }
      if (found.count == 0) continue;
      w.near[w.near_count++] = found;
      if (w.last_body < group.body) w.last_body = group.body;
      // What does not fit on the list is said to be in the way.
      if (w.near_count == BlockWork::kMostNear ||
          w.near_ball_count > BlockWork::kMostNearBalls - kBlockBalls) {
        return false;
      }
    }
  }
  return true;
}

// Are the joints between the two of a pair in clear cells from t = begin to end of the line, ends included?
inline bool clear_between(const ClearCells& cells, const float* from, const float* step, float begin, float end) {
  int first[2] = {}, last[2] = {1, 1};
  for (int k = 0; k < cells.joints; ++k) {
    const float start = from[cells.joint[k]] - cells.low[k], way = step[cells.joint[k]];
    const float a = (start + begin * way) * cells.per_unit[k], b = (start + end * way) * cells.per_unit[k];
    const float low = a < b ? a : b, high = a < b ? b : a;
    if (!(low >= 0.0F && high < static_cast<float>(cells.count[k]))) return false;
    first[k] = static_cast<int>(low);
    last[k] = static_cast<int>(high) + 1;
  }
  const auto before = [&](int i, int k) { return cells.open[static_cast<std::size_t>(i * (cells.count[1] + 1) + k)]; };
  return before(last[0], last[1]) - before(first[0], last[1]) - before(last[0], first[1]) + before(first[0], first[1]) == 0;
}

// On all of the line?  Boxes around eighths of it hold less beside it than one around it all.
inline bool clear_on_line(const BlockRobot& robot, int pair, const float* from, const float* step) {
  if (robot.clear.empty()) return false;
  const ClearCells& cells = robot.clear[static_cast<std::size_t>(pair)];
  if (cells.joints == 0) return false;
  if (clear_between(cells, from, step, 0.0F, 1.0F)) return true;
  for (int i = 0; i < 8; ++i) {
    if (!clear_between(cells, from, step, 0.125F * static_cast<float>(i), 0.125F * static_cast<float>(i + 1))) return false;
  }
  return true;
}

// In which lanes, from t - half to t + half?
inline Flags clear_lanes(const BlockRobot& robot, int pair, const float* from, const float* step, const Lanes& t, float half) {
  Flags clear = {};
  if (robot.clear.empty()) return clear;
  const ClearCells& cells = robot.clear[static_cast<std::size_t>(pair)];
  if (cells.joints == 0) return clear;
  for (int i = 0; i < 8; ++i) clear[i] = clear_between(cells, from, step, t[i] - half, t[i] + half) ? -1 : 0;
  return clear;
}

inline bool pair_free(const BlockRobot& robot, BlockWork& w, int pair) {
  const auto [a, b] = robot.pairs[static_cast<std::size_t>(pair)];
  const BlockGroup& ga = robot.groups[static_cast<std::size_t>(a)];
  const BlockGroup& gb = robot.groups[static_cast<std::size_t>(b)];
  const BlockBall* balls = robot.balls.data();
  const float sum = ga.around.radius + gb.around.radius;
  if (!any(apart(w.around[a], w.around[b]) < all(sum * sum))) return true;
  place_balls(robot, w, a);
  Flags touch = {}, open = ~Flags{};
  bool asked = w.notes;  // of cells
  for (int i = ga.first; i < ga.first + ga.count; ++i) {
    const float reach = balls[i].radius + gb.around.radius;
    if (!any(apart(w.ball[i], w.around[b]) < all(reach * reach))) continue;
    place_balls(robot, w, b);
    for (int j = gb.first; j < gb.first + gb.count; ++j) {
      const float both = balls[i].radius + balls[j].radius;
      touch |= apart(w.ball[i], w.ball[j]) < all(both * both);
    }
    if (!any(touch)) continue;
    if (!asked) open = ~clear_lanes(robot, pair, w.from, w.step, w.t, 0.0F);
    asked = true;
    touch &= open;
    if (!(w.pairs_by_hulls && w.settles_pair[pair]) && !w.notes && any(touch)) return false;
  }
  if (!any(touch)) return true;
  const auto touches = [&](const Lanes* p, float radius) {
    return Flags{} - touches_inside(robot, w, gb, touch, [&](const Lanes* q, float other) {
      return apart(p, q) < all((radius + other) * (radius + other));
    });
  };
  if (!w.notes && touches_inside(robot, w, ga, touch, touches)) return false;
  Flags far, apart_at_all;
  separate_pair(robot, w, pair, all(kRounding + kept_of_pair(robot, pair)), nullptr, nullptr, touch, far, apart_at_all);
  if (!w.notes) return !any(touch & ~far);
  w.fine_pair[pair] = w.fine_pair[pair] || any(touch & ~far);
  return w.settles_pair[pair] = true;
}
