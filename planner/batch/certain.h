// Certificates: free over an interval, not only at a posture.  Included once per instruction set, inside a namespace,
// by check.cpp: no #pragma once.

// The way of a body over half the interval as another sees it, and where that brings a point p [m].
TWINBUS_INLINE void motion_seen(const BlockWork& w, int body, int from, const Lanes& h, Lanes3& drift, Lanes3& spin) {
  for (int i = 0; i < 3; ++i) {
    drift[i] = h * (w.rate[body][i] - w.rate[from][i]);
    spin[i] = h * (w.rate[body][3 + i] - w.rate[from][3 + i]);
  }
}
TWINBUS_INLINE void moved_by(const Lanes3& drift, const Lanes3& spin, const Lanes* p, Lanes* to) {
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    to[i] = drift[i] + spin[k] * p[l] - spin[l] * p[k];
  }
}

inline void sweep_of_pair(const BlockRobot& robot, const BlockWork& w, const BlockGroup& a, const BlockGroup& b,
                          const float* step, float half, float slack, Sweep& sweep) {
  int body[2] = {a.body, b.body};
  float steps[2] = {}, swing[2] = {};
  while (body[0] != body[1]) {
    const int k = body[0] > body[1] ? 0 : 1;
    const BlockBody& of = robot.bodies[static_cast<std::size_t>(body[k])];
    const float size = __builtin_fabsf(step[of.joint]);
    steps[k] += size * __builtin_fabsf(of.scale);
    swing[k] += size * (k == 0 ? a : b).travel[of.joint];
    body[k] = of.parent;
  }
  motion_seen(w, a.body, body[0], all(half), sweep.drift, sweep.spin);
  motion_seen(w, b.body, body[0], all(half), sweep.side_drift, sweep.side_spin);
  sweep.bend = all(0.5F * half * half * (steps[0] * swing[0] + steps[1] * swing[1]) + slack + 2.0F * kRounding);
  sweep.side_moves = b.body != body[0];
}

// Is everything free not only at t (a lane each) but from t - half to t + half?  certain: yes, by
// how fast the parts move and turn; touches: not even at t.  slack: how far anything may be from there besides [m].
//
// A point x of a group with middle c moves from x(t) by at most
//     half (|c'| + |omega| |x - c|) + half^2 / 2 max |x''|,
// and along a direction n by half |n . c'| in place of the first term.  Two groups move as seen from the last body that
// carries both: what moves them together does not bring them nearer.
inline void certain(const BlockRobot& robot, const BlockScene& scene, BlockWork& w,
                    const float* from, const float* step, const Lanes& t, float half, float slack,
                    unsigned& certain_lanes, unsigned& touching_lanes) {
  const int groups = static_cast<int>(robot.groups.size());
  const int last = static_cast<int>(robot.bodies.size()) - 1;
  place_bodies(robot, w, from, step, t, last);
  for (int g = robot.fixed_groups; g < groups; ++g) place_group(robot, w, g);
  find_swings(robot, w, step);
  float steps = 0.0F;
  for (int b = 1; b <= last; ++b) {
    const BlockBody& body = robot.bodies[static_cast<std::size_t>(b)];
    steps += __builtin_fabsf(step[body.joint] * body.scale);
  }
  Flags near = {}, touching = {};
  // Rates of the bodies: velocity of the point at the world's origin, and of turning.
  for (int i = 0; i < 3; ++i) w.rate[0][i] = w.rate[0][3 + i] = all(0.0F);
  for (int b = 1; b <= last; ++b) {
    const BlockBody& body = robot.bodies[static_cast<std::size_t>(b)];
    const Lanes rate = all(step[body.joint] * body.scale);
    const Lanes z[3] = {w.rotation[b][2], w.rotation[b][5], w.rotation[b][8]};
    const Lanes* o = w.origin[b];
    for (int i = 0; i < 3; ++i) {
      const int k = (i + 1) % 3, l = (i + 2) % 3;
      w.rate[b][i] =
          w.rate[body.parent][i] + rate * (body.slides ? z[i] : o[k] * z[l] - o[l] * z[k]);
      w.rate[b][3 + i] = w.rate[body.parent][3 + i];
      if (!body.slides) w.rate[b][3 + i] += rate * z[i];
    }
  }
  const Lanes h = all(half);
  for (int g = 0; g < groups; ++g) {
    const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
    w.bend[g] = 0.5F * half * half * steps * w.swing[g / 8][g % 8] + slack + kRounding;
    const Lanes* rate = w.rate[group.body];
    const Lanes* p = w.around[g];
    for (int i = 0; i < 3; ++i) {  // omega x p + v
      const int k = (i + 1) % 3, l = (i + 2) % 3;
      w.moves[g][i] = h * (rate[3 + k] * p[l] - rate[3 + l] * p[k] + rate[i]);
    }
    w.turn[g] = h * root(rate[3] * rate[3] + rate[4] * rate[4] + rate[5] * rate[5]);
    const Lanes* m = w.moves[g];
    w.reach[g] =
        all(group.around.radius + w.bend[g]) + root(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
  }
  const int count = static_cast<int>(scene.shapes.size());
  for (int g = groups - 1; g >= robot.fixed_groups; --g) {
    const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
    const Lanes* p = w.around[g];
    Lanes low[3], high[3];
    for (int i = 0; i < 3; ++i) {
      low[i] = all(lowest(p[i] - w.reach[g]));
      high[i] = all(highest(p[i] + w.reach[g]));
    }
    for (int first = 0; first < count; first += 8) {
      for (unsigned m = boxes_that_meet(scene, first, low, high); m != 0; m &= m - 1) {
        const int o = first + __builtin_ctz(m);
        if (kept_of_shape(robot, g, o) < 0.0F) continue;
        const BlockShape& shape = scene.shapes[static_cast<std::size_t>(o)];
        if (!any(meets(shape, p, w.reach[g]) & ~near)) continue;
        place_balls(robot, w, g);
        Flags open = {}, touched = {};
        for (int k = group.first; k < group.first + group.count; ++k) {
          const float radius = robot.balls[static_cast<std::size_t>(k)].radius;
          const Lanes reach = w.reach[g] - all(group.around.radius - radius) +
                              w.turn[g] * all(group.around.radius - radius);
          open |= meets(shape, w.ball[k], reach);
          touched |= meets(shape, w.ball[k], all(radius));
        }
        if (!any(open)) continue;
        Flags far = {}, clear = {};
        Sweep sweep{};
        motion_seen(w, group.body, 0, h, sweep.drift, sweep.spin);
        sweep.bend = all(w.bend[g]);
        const float kept = kept_of_shape(robot, g, o);
        separate(robot, w, g, shape, kept,
                 all(w.bend[g] + kept) + w.turn[g] * all(group.around.radius), w.moves[g], &sweep,
                 open & ~near, far, clear);
        near |= open & ~far;
        touching |= touched & ~clear & ~far;
      }
    }
  }
  const int pairs = static_cast<int>(robot.pairs.size());
  for (int pair = 0; pair < pairs; ++pair) {
    const auto [a, b] = robot.pairs[static_cast<std::size_t>(pair)];
    const BlockGroup& ga = robot.groups[static_cast<std::size_t>(a)];
    const BlockGroup& gb = robot.groups[static_cast<std::size_t>(b)];
    const Lanes rough = w.reach[a] + w.reach[b], square = apart(w.around[a], w.around[b]);
    if (!any((square < rough * rough) & ~near)) continue;
    if (clear_on_line(robot, pair, from, step)) continue;
    Sweep sweep;
    sweep_of_pair(robot, w, ga, gb, step, half, slack, sweep);
    Lanes relative[3], of_b[3];
    moved_by(sweep.drift, sweep.spin, w.around[a], relative);
    moved_by(sweep.side_drift, sweep.side_spin, w.around[b], of_b);
    for (int i = 0; i < 3; ++i) relative[i] -= of_b[i];
    const Lanes turn_a = root(dot(sweep.spin, sweep.spin)), turn_b = root(dot(sweep.side_spin, sweep.side_spin));
    const Lanes gap =
        root(relative[0] * relative[0] + relative[1] * relative[1] + relative[2] * relative[2]) + sweep.bend;
    const Lanes sum = gap + all(ga.around.radius + gb.around.radius);
    if (!any((square < sum * sum) & ~near)) continue;
    place_balls(robot, w, a);
    place_balls(robot, w, b);
    Flags open = {}, touched = {};
    for (int i = ga.first; i < ga.first + ga.count; ++i) {
      const float ra = robot.balls[static_cast<std::size_t>(i)].radius;
      const Lanes reach = gap + turn_a * all(ga.around.radius - ra) + all(ra);
      const Lanes whole = reach + all(gb.around.radius);
      if (!any((apart(w.ball[i], w.around[b]) < whole * whole) & ~near)) continue;
      for (int k = gb.first; k < gb.first + gb.count; ++k) {
        const float rb = robot.balls[static_cast<std::size_t>(k)].radius;
        const Lanes apart_now = apart(w.ball[i], w.ball[k]);
        const Lanes both = reach + turn_b * all(gb.around.radius - rb) + all(rb);
        open |= apart_now < both * both;
        touched |= apart_now < all((ra + rb) * (ra + rb));
      }
    }
    Flags asked = (open & ~near) | touched;
    if (!any(asked)) continue;
    const Flags clear_of_it = clear_lanes(robot, pair, from, step, t, half);
    open &= ~clear_of_it;
    touched &= ~clear_of_it;
    asked &= ~clear_of_it;
    if (!any(asked)) continue;
    Flags far, clear;
    separate_pair(robot, w, pair,
                  sweep.bend + all(kept_of_pair(robot, pair)) + turn_a * all(ga.around.radius) + turn_b * all(gb.around.radius),
                  relative, &sweep, asked, far, clear);
    near |= open & ~far;
    touching |= touched & ~clear & ~far;
  }
  certain_lanes = ~mask(near) & 0xFFU;
  touching_lanes = mask(touching);
}
