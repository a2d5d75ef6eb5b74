// Where bodies, groups and balls are.  Included once per instruction set, inside a namespace,
// by check.cpp: no #pragma once.

constexpr float kRounding = 2e-5F;  // what single precision may lose of a distance [m]

// Where a point of a body is: origin + R (x, y, z).
TWINBUS_INLINE void put_point(const Lanes* rotation, const Lanes* origin, const float* point,
                              Lanes* to) {
  const Lanes x = all(point[0]), y = all(point[1]), z = all(point[2]);
  for (int i = 0; i < 3; ++i)
    to[i] = origin[i] + rotation[3 * i] * x + rotation[3 * i + 1] * y + rotation[3 * i + 2] * z;
}

// Poses of bodies 1..last at from + t step.
inline void place_bodies(const BlockRobot& robot, BlockWork& w, const float* from,
                         const float* step, const Lanes& t, int last) {
  const BlockBody* bodies = robot.bodies.data();
  w.from = from;
  w.step = step;
  w.t = t;
  for (int i = 1; i <= last; ++i) {
    const BlockBody& b = bodies[i];
    const Lanes q = (all(from[b.joint]) + t * all(step[b.joint])) * all(b.scale) + all(b.shift);
    Lanes* out = w.rotation[i];
    const Lanes* parent = w.rotation[b.parent];
    put_point(parent, w.origin[b.parent], b.offset, w.origin[i]);
    // The columns of the constant rotation in the world; those of the result mix the first two.
    Lanes column[3][3];
    for (int k = 0; k < 3; ++k) {
      if (b.axis[k] >= 0) {
        const Lanes sign = all(b.sign[k]);
        for (int r = 0; r < 3; ++r) column[k][r] = parent[3 * r + b.axis[k]] * sign;
      } else {
        const Lanes x = all(b.rotation[k]), y = all(b.rotation[3 + k]), z = all(b.rotation[6 + k]);
        for (int r = 0; r < 3; ++r)
          column[k][r] = parent[3 * r] * x + parent[3 * r + 1] * y + parent[3 * r + 2] * z;
      }
    }
    if (b.slides) {
      for (int r = 0; r < 3; ++r) {
        for (int k = 0; k < 3; ++k) out[3 * r + k] = column[k][r];
        w.origin[i][r] += column[2][r] * q;
      }
      continue;
    }
    Lanes sine, cosine;
    sine_cosine(q, sine, cosine);
    for (int r = 0; r < 3; ++r) {
      out[3 * r] = cosine * column[0][r] + sine * column[1][r];
      out[3 * r + 1] = cosine * column[1][r] - sine * column[0][r];
      out[3 * r + 2] = column[2][r];
    }
  }
}

TWINBUS_INLINE void place(const BlockWork& w, int body, const BlockBall& b, Lanes* to) {
  put_point(w.rotation[body], w.origin[body], &b.x, to);
}

inline void place_balls(const BlockRobot& robot, BlockWork& w, int g) {
  if (w.placed[g]) return;
  w.placed[g] = true;
  const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
  const BlockBall* balls = robot.balls.data();
  for (int k = group.first; k < group.first + group.count; ++k)
    place(w, group.body, balls[k], w.ball[k]);
}

// The ball around a group; its own balls are placed when they are asked for.
TWINBUS_INLINE void place_group(const BlockRobot& robot, BlockWork& w, int g) {
  const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
  w.placed[g] = false;
  place(w, group.body, group.around, w.around[g]);
}

// Once per robot: what stands still is placed for good.
inline void prepare(const BlockRobot& robot, BlockWork& w) {
  for (int i = 0; i < 9; ++i) w.rotation[0][i] = all(i % 4 == 0 ? 1.0F : 0.0F);
  for (Lanes& o : w.origin[0]) o = all(0.0F);
  for (int g = 0; g < robot.fixed_groups; ++g) {
    w.placed[g] = false;
    place(w, 0, robot.groups[static_cast<std::size_t>(g)].around, w.around[g]);
    w.reach[g] = all(robot.groups[static_cast<std::size_t>(g)].around.radius);
    place_balls(robot, w, g);
  }
  const int groups = static_cast<int>(robot.groups.size());
  for (int g = 0; g < kBlockGroups; ++g) {
    for (int j = 0; j < kMostPlanned; ++j) {
      const bool there = g < groups;
      w.travel[j][g / 8][g % 8] =
          there ? robot.groups[static_cast<std::size_t>(g)].travel[j] : 0.0F;
      w.turning[j][g / 8][g % 8] = there ? robot.groups[static_cast<std::size_t>(g)].turn[j] : 0.0F;
    }
  }
}

// Sums over the joints of |step| travel and |step| turn, of all groups.
inline void find_swings(const BlockRobot& robot, BlockWork& w, const float* step) {
  const int octets = (static_cast<int>(robot.groups.size()) + 7) / 8;
  for (int o = 0; o < octets; ++o) w.swing[o] = w.angle[o] = all(0.0F);
  for (int j = 0; j < robot.joints; ++j) {
    const Lanes size = all(__builtin_fabsf(step[j]));
    for (int o = 0; o < octets; ++o) {
      w.swing[o] += size * w.travel[j][o];
      w.angle[o] += size * w.turning[j][o];
    }
  }
}

// The nearest of `count` columns to q, squared distance in `found`.  columns: [joints x stride],
// filled up to a multiple of 8 with what is far away.
inline int nearest(const float* columns, int stride, int count, int joints, const float* q,
                   float& found) {
  Lanes best = all(1e30F);
  Flags best_index = {};
  Flags index = {0, 1, 2, 3, 4, 5, 6, 7};
  for (int i = 0; i < count; i += 8) {
    Lanes sum = all(0.0F);
    for (int j = 0; j < joints; ++j) {
      const Lanes d = load(columns + j * stride + i) - all(q[j]);
      sum += d * d;
    }
    const Flags better = sum < best;
    best = better ? sum : best;
    best_index = better ? index : best_index;
    index += 8;
  }
  found = lowest(best);
  int least_index = count;
  for (unsigned m = mask(best == all(found)); m != 0; m &= m - 1)
    least_index = std::min(least_index, static_cast<int>(best_index[__builtin_ctz(m)]));
  return least_index;
}
