// Where bodies, groups and balls are.  Included once per instruction set, inside a namespace,
// by block_check.cpp: no #pragma once.

constexpr float kRounding = 2e-5F;  // what single precision may lose of a distance [m]

TWINBUS_INLINE Lanes row_times(const Lanes* r, float x, float y, float z, Lanes sum) {
  if (x != 0.0F) sum += r[0] * all(x);
  if (y != 0.0F) sum += r[1] * all(y);
  if (z != 0.0F) sum += r[2] * all(z);
  return sum;
}

// Poses of bodies 1..last at from + t step.
inline void place_bodies(const BlockRobot& robot, BlockWork& w, const float* from,
                         const float* step, const Lanes& t, int last) {
  const BlockBody* bodies = robot.bodies.data();
  for (int i = 1; i <= last; ++i) {
    const BlockBody& b = bodies[i];
    const Lanes q = (all(from[b.joint]) + t * all(step[b.joint])) * all(b.scale) + all(b.shift);
    Lanes* out = w.rotation[i];
    Lanes sine = all(0.0F), cosine = all(1.0F);
    if (!b.slides) sine_cosine(q, sine, cosine);
    if (b.parent == 0) {
      for (int r = 0; r < 3; ++r) {
        const float m0 = b.rotation[3 * r], m1 = b.rotation[3 * r + 1], m2 = b.rotation[3 * r + 2];
        out[3 * r] = cosine * all(m0) + sine * all(m1);
        out[3 * r + 1] = cosine * all(m1) - sine * all(m0);
        out[3 * r + 2] = all(m2);
        w.origin[i][r] = all(b.offset[r]);
      }
    } else {
      const Lanes* parent = w.rotation[b.parent];
      for (int r = 0; r < 3; ++r) {
        const Lanes* p = parent + 3 * r;
        Lanes m[3];
        for (int k = 0; k < 3; ++k) {
          if (b.axis[k] >= 0) {
            m[k] = p[b.axis[k]] * all(b.sign[k]);
          } else {
            m[k] = p[0] * all(b.rotation[k]) + p[1] * all(b.rotation[3 + k]) +
                   p[2] * all(b.rotation[6 + k]);
          }
        }
        out[3 * r] = cosine * m[0] + sine * m[1];
        out[3 * r + 1] = cosine * m[1] - sine * m[0];
        out[3 * r + 2] = m[2];
        w.origin[i][r] = row_times(p, b.offset[0], b.offset[1], b.offset[2], w.origin[b.parent][r]);
      }
    }
    if (b.slides) {
      for (int r = 0; r < 3; ++r) w.origin[i][r] += out[3 * r + 2] * q;
    }
  }
}

TWINBUS_INLINE void place(const BlockWork& w, int body, const BlockBall& b, Lanes* to) {
  if (body == 0) {
    to[0] = all(b.x);
    to[1] = all(b.y);
    to[2] = all(b.z);
    return;
  }
  const Lanes* r = w.rotation[body];
  for (int i = 0; i < 3; ++i) to[i] = row_times(r + 3 * i, b.x, b.y, b.z, w.origin[body][i]);
}

inline void place_balls(const BlockRobot& robot, BlockWork& w, int g) {
  if (w.placed[g]) return;
  w.placed[g] = true;
  const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
  const BlockBall* balls = robot.balls.data();
  for (int k = group.first; k < group.first + group.count; ++k)
    place(w, group.body, balls[k], w.ball[k]);
}

inline void place_groups(const BlockRobot& robot, BlockWork& w, int last_body) {
  for (std::size_t g = static_cast<std::size_t>(robot.fixed_groups); g < robot.groups.size(); ++g) {
    if (robot.groups[g].body > last_body) continue;
    w.placed[g] = false;
    place(w, robot.groups[g].body, robot.groups[g].around, w.around[g]);
  }
}

// Once per robot: what stands still is placed for good.
inline void prepare(const BlockRobot& robot, BlockWork& w) {
  for (int g = 0; g < robot.fixed_groups; ++g) {
    w.placed[g] = false;
    place(w, 0, robot.groups[static_cast<std::size_t>(g)].around, w.around[g]);
    w.reach[g] = all(robot.groups[static_cast<std::size_t>(g)].around.radius);
    place_balls(robot, w, g);
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
  int lane = 0;
  for (int i = 1; i < 8; ++i) {
    if (best[i] < best[lane] || (best[i] == best[lane] && best_index[i] < best_index[lane]))
      lane = i;
  }
  found = best[lane];
  return best_index[lane];
}
