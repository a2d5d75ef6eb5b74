// Certificates: free over an interval, not only at a posture.  Included once per instruction set, inside a namespace,
// by check.cpp: no #pragma once.

// Is everything free not only at t (a lane each) but from t - half to t + half?  certain: yes, by
// how fast the parts move and turn; touches: not even at t.
//
// A point x of a group with middle c moves from x(t) by at most
//     half (|c'| + |omega| |x - c|) + half^2 / 2 max |x''|,
// and along a direction n by half |n . c'| in place of the first term.
inline void certain(const BlockRobot& robot, const BlockScene& scene, BlockWork& w,
                    const float* from, const float* step, const Lanes& t, float half,
                    unsigned& certain_lanes, unsigned& touching_lanes) {
  const int groups = static_cast<int>(robot.groups.size());
  const int last = static_cast<int>(robot.bodies.size()) - 1;
  place_bodies(robot, w, from, step, t, last);
  for (int g = robot.fixed_groups; g < groups; ++g) place_group(robot, w, g);
  find_swings(robot, w, step);
  float steps = 0.0F;
  for (int j = 0; j < robot.joints; ++j) steps += __builtin_fabsf(step[j]);
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
    w.bend[g] = 0.5F * half * half * steps * w.swing[g / 8][g % 8] + kRounding;
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
        const BlockShape& shape = scene.shapes[static_cast<std::size_t>(first + __builtin_ctz(m))];
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
        separate(robot, w, g, shape,
                 all(w.bend[g] + robot.grow) + w.turn[g] * all(group.around.radius), w.moves[g],
                 open & ~near, far, clear);
        near |= open & ~far;
        touching |= touched & ~clear & ~far;
      }
    }
  }
  for (const auto& [a, b] : robot.pairs) {
    const BlockGroup& ga = robot.groups[static_cast<std::size_t>(a)];
    const BlockGroup& gb = robot.groups[static_cast<std::size_t>(b)];
    const Lanes relative[3] = {w.moves[a][0] - w.moves[b][0], w.moves[a][1] - w.moves[b][1],
                               w.moves[a][2] - w.moves[b][2]};
    const Lanes gap =
        root(relative[0] * relative[0] + relative[1] * relative[1] + relative[2] * relative[2]) +
        all(w.bend[a] + w.bend[b]);
    const Lanes sum = gap + all(ga.around.radius + gb.around.radius);
    if (!any((apart(w.around[a], w.around[b]) < sum * sum) & ~near)) continue;
    place_balls(robot, w, a);
    place_balls(robot, w, b);
    Flags open = {}, touched = {};
    for (int i = ga.first; i < ga.first + ga.count; ++i) {
      const float ra = robot.balls[static_cast<std::size_t>(i)].radius;
      const Lanes reach = gap + w.turn[a] * all(ga.around.radius - ra) + all(ra);
      const Lanes whole = reach + all(gb.around.radius);
      if (!any((apart(w.ball[i], w.around[b]) < whole * whole) & ~near)) continue;
      for (int k = gb.first; k < gb.first + gb.count; ++k) {
        const float rb = robot.balls[static_cast<std::size_t>(k)].radius;
        const Lanes square = apart(w.ball[i], w.ball[k]);
        const Lanes both = reach + w.turn[b] * all(gb.around.radius - rb) + all(rb);
        open |= square < both * both;
        touched |= square < all((ra + rb) * (ra + rb));
      }
    }
    const Flags asked = (open & ~near) | touched;
    if (!any(asked)) continue;
    Flags far, clear;
    separate_pair(robot, w, a, b,
                  all(w.bend[a] + w.bend[b] + robot.grow) + w.turn[a] * all(ga.around.radius) + w.turn[b] * all(gb.around.radius),
                  relative, asked, far, clear);
    near |= open & ~far;
    touching |= touched & ~clear & ~far;
  }
  certain_lanes = ~mask(near) & 0xFFU;
  touching_lanes = mask(touching);
}
