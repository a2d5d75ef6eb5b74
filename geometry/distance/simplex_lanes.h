// The step of a search for the distance of two convex shapes, in several lanes.  Included once per instruction set inside
// a namespace that says what Lanes, Lanes3 and Mask are, with all, pick, above and at_least: no #pragma once.

TWINBUS_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
TWINBUS_INLINE void cross(const Lanes3& a, const Lanes3& b, Lanes3& c) noexcept {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

// What is nearest to zero: v = w + sum of part[k] (corner[k] - w), parts above zero for those that are needed.
struct NearestOfFour {
  Lanes3 part, v;
  Mask inside;  // zero is inside
};

TWINBUS_INLINE void nearest_of_four(const Lanes3& w, const Lanes3 (&corner)[3],
                                    NearestOfFour& result) noexcept {
  const Lanes none{};
  Lanes3 e[3], q[3], normal = {};
  Lanes(&part)[3] = result.part;
  // Squares of distances, and parts, are fractions: one division at the end.
  Lanes best = dot(w, w), per = all(1), height_best = none;
  const auto take = [&](const Mask& valid, const Lanes& square, const Lanes& of)
      __attribute__((always_inline)) {
    const Mask nearer = valid & above(best * of, square * per);
    best = pick(nearer, square, best);
    per = pick(nearer, of, per);
    return nearer;
  };
  for (int i = 0; i < 3; ++i) {
    for (int d = 0; d < 3; ++d) e[i][d] = corner[i][d] - w[d];
    cross(e[i], w, q[i]);
    const Lanes along = -dot(w, e[i]), length2 = dot(e[i], e[i]);
    const Mask nearer = take(above(along, none) & above(length2, along), dot(q[i], q[i]), length2);
    for (int k = 0; k < i; ++k) part[k] = pick(nearer, none, part[k]);
    part[i] = pick(nearer, along, none);
  }
  Lanes sum = none, volume = none;
  Mask of_face = above(none, none), same = ~of_face;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Lanes3 n;
    cross(e[i], e[j], n);
    const Lanes of_i = dot(n, q[j]), of_j = -dot(n, q[i]), area2 = dot(n, n), height = dot(w, n);
    if (i == 0) volume = -dot(e[k], n);
    sum += height;
    same = same & above(height * volume, none);
    const Mask nearer = take(above(of_i, none) & above(of_j, none) & above(area2, of_i + of_j),
                             height * height, area2);
    of_face = of_face | nearer;
    part[i] = pick(nearer, of_i, part[i]);
    part[j] = pick(nearer, of_j, part[j]);
    part[k] = pick(nearer, none, part[k]);
    height_best = pick(nearer, height, height_best);
    for (int d = 0; d < 3; ++d) normal[d] = pick(nearer, n[d], normal[d]);
  }
  result.inside = same & at_least(volume * volume, sum * volume);
  const Lanes share = all(1) / per;
  for (int i = 0; i < 3; ++i) part[i] *= share;
  height_best *= share;
  for (int d = 0; d < 3; ++d) {
    // Of a face along its normal, which rounding harms less than the sum of the corners.
    const Lanes v = w[d] + part[0] * e[0][d] + part[1] * e[1][d] + part[2] * e[2][d];
    result.v[d] = pick(of_face, height_best * normal[d], v);
  }
}
