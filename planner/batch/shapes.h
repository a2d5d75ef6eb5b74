// Obstacles against balls and planes.  Included once per instruction set, inside a namespace,
// by check.cpp: no #pragma once.

// Squared distance of p to the core of a shape; the rest of the shape is `rind` around the core.
TWINBUS_INLINE Lanes square_to_core(const BlockShape& s, const Lanes* p) {
  const Lanes d[3] = {p[0] - all(s.center[0]), p[1] - all(s.center[1]), p[2] - all(s.center[2])};
  const Lanes zero = all(0.0F);
  if (s.kind == BlockShape::Kind::kBox) {
    Lanes square = zero;
    for (int k = 0; k < 3; ++k) {
      const Lanes along =
          s.upright
              ? (k == 2 ? d[2] : d[0] * all(s.axis[k][0]) + d[1] * all(s.axis[k][1]))
              : d[0] * all(s.axis[k][0]) + d[1] * all(s.axis[k][1]) + d[2] * all(s.axis[k][2]);
      const Lanes over = most(size_of(along) - all(s.half[k]), zero);
      square += over * over;
    }
    return square;
  }
  if (s.kind == BlockShape::Kind::kCylinder) {
    const Lanes along =
        d[0] * all(s.axis[2][0]) + d[1] * all(s.axis[2][1]) + d[2] * all(s.axis[2][2]);
    const Lanes across = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - along * along;
    const Lanes out = most(root(most(across, zero)) - all(s.half[0]), zero);
    const Lanes over = most(size_of(along) - all(s.half[2]), zero);
    return out * out + over * over;
  }
  if (s.kind == BlockShape::Kind::kSphere) return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  Lanes t = (d[0] * all(s.axis[0][0]) + d[1] * all(s.axis[0][1]) + d[2] * all(s.axis[0][2])) *
            all(s.inverse);
  t = least(most(t, zero), all(1.0F));
  Lanes square = zero;
  for (int i = 0; i < 3; ++i) {
    const Lanes e = d[i] - t * all(s.axis[0][i]);
    square += e * e;
  }
  return square;
}
TWINBUS_INLINE float rind_of(const BlockShape& s) {
  return s.kind == BlockShape::Kind::kSphere || s.kind == BlockShape::Kind::kCapsule ? s.half[0]
                                                                                     : 0.0F;
}

// Where is a ball of this radius at p nearer than touching?
TWINBUS_INLINE Flags meets(const BlockShape& s, const Lanes* p, Lanes radius) {
  const Lanes sum = radius + all(rind_of(s));
  return square_to_core(s, p) < sum * sum;
}

// From the point of the shape that is nearest to p, or its middle, to p; unit.
TWINBUS_INLINE void first_normal(const BlockShape& s, const Lanes* p, Lanes* n) {
  Lanes d[3] = {p[0] - all(s.center[0]), p[1] - all(s.center[1]), p[2] - all(s.center[2])};
  if (s.kind == BlockShape::Kind::kBox || s.kind == BlockShape::Kind::kCylinder) {
    Lanes nearest[3] = {};
    for (int k = s.kind == BlockShape::Kind::kBox ? 0 : 2; k < 3; ++k) {
      const Lanes along =
          d[0] * all(s.axis[k][0]) + d[1] * all(s.axis[k][1]) + d[2] * all(s.axis[k][2]);
      const Lanes inside = least(most(along, all(-s.half[k])), all(s.half[k]));
      for (int i = 0; i < 3; ++i) nearest[i] += inside * all(s.axis[k][i]);
    }
    const Lanes e[3] = {d[0] - nearest[0], d[1] - nearest[1], d[2] - nearest[2]};
    const Flags out = e[0] * e[0] + e[1] * e[1] + e[2] * e[2] > all(1e-12F);
    for (int i = 0; i < 3; ++i) d[i] = out ? e[i] : d[i];
  } else if (s.kind == BlockShape::Kind::kCapsule) {
    Lanes t = (d[0] * all(s.axis[0][0]) + d[1] * all(s.axis[0][1]) + d[2] * all(s.axis[0][2])) *
              all(s.inverse);
    t = least(most(t, all(0.0F)), all(1.0F));
    for (int i = 0; i < 3; ++i) d[i] -= t * all(s.axis[0][i]);
  }
  const Lanes unit =
      all(1.0F) / most(root(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), all(1e-6F));
  for (int i = 0; i < 3; ++i) n[i] = d[i] * unit;
}

// The point of the shape that is farthest along n.
TWINBUS_INLINE void highest_point(const BlockShape& s, const Lanes* n, Lanes* to) {
  const Lanes zero = all(0.0F);
  for (int i = 0; i < 3; ++i) to[i] = all(s.center[i]);
  if (s.kind == BlockShape::Kind::kBox || s.kind == BlockShape::Kind::kCylinder) {
    Lanes across[3] = {n[0], n[1], n[2]};
    for (int k = s.kind == BlockShape::Kind::kBox ? 0 : 2; k < 3; ++k) {
      const Lanes along =
          n[0] * all(s.axis[k][0]) + n[1] * all(s.axis[k][1]) + n[2] * all(s.axis[k][2]);
      const Lanes end = along > zero ? all(s.half[k]) : all(-s.half[k]);
      for (int i = 0; i < 3; ++i) {
        to[i] += end * all(s.axis[k][i]);
        across[i] -= along * all(s.axis[k][i]);
      }
    }
    if (s.kind == BlockShape::Kind::kBox) return;
    const Lanes out =
        all(s.half[0]) /
        most(root(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]),
             all(1e-6F));
    for (int i = 0; i < 3; ++i) to[i] += across[i] * out;
    return;
  }
  if (s.kind == BlockShape::Kind::kCapsule) {
    const Lanes along =
        n[0] * all(s.axis[0][0]) + n[1] * all(s.axis[0][1]) + n[2] * all(s.axis[0][2]);
    const Lanes end = along > zero ? all(1.0F) : zero;
    for (int i = 0; i < 3; ++i) to[i] += end * all(s.axis[0][i]);
  }
  for (int i = 0; i < 3; ++i) to[i] += all(s.half[0]) * n[i];
}

TWINBUS_INLINE Lanes apart(const Lanes* a, const Lanes* b) {  // squared
  const Lanes x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

// Of eight shapes from number first on, a bit for each whose box meets that from low to high.
TWINBUS_INLINE unsigned boxes_that_meet(const BlockScene& scene, int first, const Lanes* low, const Lanes* high) {
  Flags meet = (load(&scene.low[0][static_cast<std::size_t>(first)]) < high[0]) &
               (load(&scene.high[0][static_cast<std::size_t>(first)]) > low[0]);
  for (int i = 1; i < 3; ++i) {
    meet &= (load(&scene.low[i][static_cast<std::size_t>(first)]) < high[i]) &
            (load(&scene.high[i][static_cast<std::size_t>(first)]) > low[i]);
  }
  return mask(meet);
}
