// The rake along a line.  Included once per instruction set, inside a namespace,
// by check.cpp: no #pragma once.

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
TWINBUS_INLINE bool settled(const BlockRobot& robot, const BlockWork& w, int g, const BlockShape& shape, const Flags& touched) {
  const auto touch = [&](const Lanes* p, float radius) { return meets(shape, p, all(radius)); };
  if (touches_inside(robot, w, robot.groups[static_cast<std::size_t>(g)], touched, touch)) return false;
  Flags far, apart_at_all;
  separate(robot, w, g, shape, all(kRounding + robot.grow), nullptr, nullptr, touched, far, apart_at_all);
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
        w.fine[g] = w.fine[g] || (any(touched) && !settled(robot, w, g, shape, touched));
      } else if (any(touched) && !settled(robot, w, g, shape, touched)) {
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

// Are the joints between the two of a pair in clear cells all along the line, ends included?
inline bool clear_on_line(const BlockRobot& robot, int pair, const float* from, const float* step) {
  if (robot.clear.empty()) return false;
  const ClearCells& cells = robot.clear[static_cast<std::size_t>(pair)];
  if (cells.joints == 0) return false;
  int first[2] = {}, end[2] = {1, 1};
  for (int k = 0; k < cells.joints; ++k) {
    const float a = (from[cells.joint[k]] - cells.low[k]) * cells.per_unit[k], b = a + step[cells.joint[k]] * cells.per_unit[k];
    const float low = a < b ? a : b, high = a < b ? b : a;
    if (!(low >= 0.0F && high < static_cast<float>(cells.count[k]))) return false;
    first[k] = static_cast<int>(low);
    end[k] = static_cast<int>(high) + 1;
  }
  const auto before = [&](int i, int k) { return cells.open[static_cast<std::size_t>(i * (cells.count[1] + 1) + k)]; };
  return before(end[0], end[1]) - before(first[0], end[1]) - before(end[0], first[1]) + before(first[0], first[1]) == 0;
}

inline bool pair_free(const BlockRobot& robot, BlockWork& w, int pair) {
  const auto [a, b] = robot.pairs[static_cast<std::size_t>(pair)];
  const BlockGroup& ga = robot.groups[static_cast<std::size_t>(a)];
  const BlockGroup& gb = robot.groups[static_cast<std::size_t>(b)];
  const BlockBall* balls = robot.balls.data();
  const float sum = ga.around.radius + gb.around.radius;
  if (!any(apart(w.around[a], w.around[b]) < all(sum * sum))) return true;
  place_balls(robot, w, a);
  Flags touch = {};
  for (int i = ga.first; i < ga.first + ga.count; ++i) {
    const float reach = balls[i].radius + gb.around.radius;
    if (!any(apart(w.ball[i], w.around[b]) < all(reach * reach))) continue;
    place_balls(robot, w, b);
    for (int j = gb.first; j < gb.first + gb.count; ++j) {
      const float both = balls[i].radius + balls[j].radius;
      touch |= apart(w.ball[i], w.ball[j]) < all(both * both);
    }
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
  separate_pair(robot, w, pair, all(kRounding + robot.grow), nullptr, nullptr, touch, far, apart_at_all);
  if (!w.notes) return !any(touch & ~far);
  w.fine_pair[pair] = w.fine_pair[pair] || any(touch & ~far);
  return w.settles_pair[pair] = true;
}

inline bool world_free(const BlockRobot& robot, const BlockScene& scene, BlockWork& w) {
  for (int g = 0; g < robot.fixed_groups; ++g) {
    if (!group_free(robot, scene, w, g, false)) return false;
  }
  return true;
}

// Stride 5/8 of the blocks or a little more, that has no factor in common with them: it visits every
// offset once and far ones early.
inline int stride_of(int blocks) {
  int stride = (blocks * 5 + 4) / 8;
  while (std::gcd(stride, blocks) != 1) ++stride;
  return stride % blocks;
}

// The first look, at postures over the whole line; what is near is listed when the line goes on.
inline bool first_block_free(const BlockRobot& robot, const BlockScene& scene, BlockWork& w,
                             const float* from, const float* step, bool goes_on) {
  w.near_count = w.near_ball_count = w.near_pair_count = w.near_group_count = w.last_body = 0;
  float steps = 0.0F;
  if (goes_on) {
    find_swings(robot, w, step);
    for (int j = 0; j < robot.joints; ++j) steps += __builtin_fabsf(step[j]);
  }
  for (int g = static_cast<int>(robot.groups.size()) - 1; g >= robot.fixed_groups; --g) {
    place_group(robot, w, g);
    w.reach[g] = all(robot.groups[static_cast<std::size_t>(g)].around.radius);
    if (goes_on) w.reach[g] += gap_of(w, g, steps, w.turn[g]);
    if (!group_free(robot, scene, w, g, goes_on)) return false;
  }
  bool listed[kBlockGroups] = {};
  const int pairs = static_cast<int>(robot.pairs.size());
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = robot.pairs[static_cast<std::size_t>(i)];
    const Lanes sum = w.reach[a] + w.reach[b];
    if (!any(apart(w.around[a], w.around[b]) < sum * sum)) continue;
    if (clear_on_line(robot, i, from, step)) continue;
    if (!pair_free(robot, w, i)) return false;
    if (!goes_on) continue;
    w.near_pair[w.near_pair_count++] = i;
    for (const int g : {a, b}) {
      const int body = robot.groups[static_cast<std::size_t>(g)].body;
      if (body == 0 || listed[g]) continue;
      listed[g] = true;
      w.near_group[w.near_group_count++] = g;
      w.last_body = std::max(w.last_body, body);
    }
  }
  return true;
}

// A later look, at what is near alone.
inline bool next_block_free(const BlockRobot& robot, const BlockScene& scene, BlockWork& w) {
  for (int i = 0; i < w.near_count; ++i) {
    const BlockWork::Near near = w.near[i];
    const BlockGroup& group = robot.groups[static_cast<std::size_t>(near.group)];
    const BlockShape& shape = scene.shapes[static_cast<std::size_t>(near.obstacle)];
    if (i == 0 || w.near[i - 1].group != near.group) place_group(robot, w, near.group);
    if (!any(meets(shape, w.around[near.group], all(group.around.radius)))) continue;
    Flags touched = {};
    for (int k = near.first; k < near.first + near.count; ++k) {
      const BlockBall& ball = robot.balls[static_cast<std::size_t>(w.near_ball[k])];
      Lanes p[3];
      place(w, group.body, ball, p);
      touched |= meets(shape, p, all(ball.radius));
      if ((group.piece_count == 0 || !w.settles[near.group]) && any(touched)) return false;
    }
    if (any(touched) && !settled(robot, w, near.group, shape, touched)) return false;
  }
  for (int i = 0; i < w.near_group_count; ++i) place_group(robot, w, w.near_group[i]);
  for (int i = 0; i < w.near_pair_count; ++i) {
    if (!pair_free(robot, w, w.near_pair[i])) return false;
  }
  return true;
}

// Returns how many blocks were looked at, negative when the line is not free.
inline int line_free(const BlockRobot& robot, const BlockScene& scene, BlockWork& w,
                     const float* from, const float* step, int blocks) {
  const Lanes spread = {0.125F, 0.25F, 0.375F, 0.5F, 0.625F, 0.75F, 0.875F, 1.0F};
  const int last = static_cast<int>(robot.bodies.size()) - 1;
  place_bodies(robot, w, from, step, spread, last);
  if (!first_block_free(robot, scene, w, from, step, blocks > 1)) return -1;
  if (blocks == 1 || (w.near_count == 0 && w.near_pair_count == 0)) return 1;
  const float fine = 0.125F / static_cast<float>(blocks);
  const int stride = stride_of(blocks);
  for (int n = 1, offset = stride; n < blocks; ++n) {
    place_bodies(robot, w, from, step, spread - all(fine * static_cast<float>(offset)),
                 w.last_body);
    if (!next_block_free(robot, scene, w)) return -n - 1;
    offset += stride;
    if (offset >= blocks) offset -= blocks;
  }
  return blocks;
}
