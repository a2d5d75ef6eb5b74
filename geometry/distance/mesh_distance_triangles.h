// Distance of triangles, eight at a time.  Part of the kernels of MeshDistance, included after float8.h.

// One triangle (corners v) against eight: the smallest squared distance among `lanes`, and its lane.
// Zero where they cross.
static float row_distance2(const F4 (&v)[3], const TriangleCluster& other, int first,
                           unsigned lanes, int& lane) noexcept {
  // About the first corner, so that what is computed is as small as the triangles.
  F8 u[3][3], f[3][3];
  for (int k = 0; k < 3; ++k) {
    for (int d = 0; d < 3; ++d) u[k][d] = load8(other.corner[k][d] + first) - all(v[0][d]);
  }
  for (int k = 0; k < 3; ++k) {
    for (int d = 0; d < 3; ++d) f[k][d] = u[(k + 1) % 3][d] - u[k][d];
  }
  const F4 p[3] = {v[0] - v[0], v[1] - v[0], v[2] - v[0]};
  const F4 e[3] = {p[1], p[2] - p[1], -p[2]};
  const auto dot = [](const F8(&x)[3], const F8(&y)[3]) __attribute__((always_inline)) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  const auto with = [](const F4& x, const F8(&y)[3]) __attribute__((always_inline)) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  const auto dot4 = [](const F4& x, const F4& y) __attribute__((always_inline)) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  const F8 zero = all(0.0F), tiny = all(1e-20F);
  F8 best = all(1e20F);

  // Edges against edges: points p + s e and u + r f.
  F8 ff[3], per_ff[3], fu[3];
  for (int j = 0; j < 3; ++j) {
    ff[j] = dot(f[j], f[j]) + tiny;
    per_ff[j] = all(1.0F) / ff[j];
    fu[j] = dot(f[j], u[j]);
  }
  for (int i = 0; i < 3; ++i) {
    const float ee = dot4(e[i], e[i]) + 1e-20F, per_ee = 1.0F / ee, ep = dot4(e[i], p[i]);
    F8 eu[3];
    for (int j = 0; j < 3; ++j) eu[j] = with(e[i], u[j]);
    for (int j = 0; j < 3; ++j) {
      const F8 ef = eu[(j + 1) % 3] - eu[j], ew = eu[j] - ep;
      const F8 fw = fu[j] - with(p[i], f[j]);
      const F8 det = most(ee * ff[j] - ef * ef, 1e-7F * ee * ff[j]);
      F8 s = unit_clamp((ew * ff[j] - fw * ef) / det);
      F8 r = unit_clamp((s * ef - fw) * per_ff[j]);
      s = unit_clamp((r * ef + ew) * per_ee);
      r = unit_clamp((s * ef - fw) * per_ff[j]);
      F8 d[3];
      for (int k = 0; k < 3; ++k) d[k] = u[j][k] - p[i][k] + r * f[j][k] - s * e[i][k];
      best = least(best, dot(d, d));
    }
  }
  // Corners against faces, and edges through faces; `in` is how far inside of each edge a corner lies.
  const auto through = [&](const F8(&height)[3], const F8(&in)[3][3])
      __attribute__((always_inline)) {
    for (int i = 0; i < 3; ++i) {
      const int n = (i + 1) % 3;
      const I8 sides =
          ((height[i] > zero) & (height[n] < zero)) | ((height[i] < zero) & (height[n] > zero));
      const F8 a = size(height[n]), b = size(height[i]);
      const I8 hit = sides & (in[i][0] * a + in[n][0] * b >= zero) &
                     (in[i][1] * a + in[n][1] * b >= zero) & (in[i][2] * a + in[n][2] * b >= zero);
      best = hit ? zero : best;
    }
  };
  const auto over = [&](const F8& height, const F8(&in)[3], const F8& per_nn)
      __attribute__((always_inline)) {
    const I8 inside = (in[0] >= zero) & (in[1] >= zero) & (in[2] >= zero);
    best = inside ? least(best, height * height * per_nn) : best;
  };
  F8 height[3], in[3][3];
  const F8 n[3] = {f[0][1] * f[1][2] - f[0][2] * f[1][1], f[0][2] * f[1][0] - f[0][0] * f[1][2],
                   f[0][0] * f[1][1] - f[0][1] * f[1][0]};
  const F8 nn = dot(n, n), per_nn = all(1.0F) / most(nn, all(1e-30F));
  const F8 base = dot(n, u[0]);
  for (int i = 0; i < 3; ++i) height[i] = with(p[i], n) - base;
  for (int j = 0; j < 3; ++j) {
    const F8 m[3] = {n[1] * f[j][2] - n[2] * f[j][1], n[2] * f[j][0] - n[0] * f[j][2],
                     n[0] * f[j][1] - n[1] * f[j][0]};
    const F8 edge = dot(m, u[j]);
    for (int i = 0; i < 3; ++i) in[i][j] = with(p[i], m) - edge;
  }
  for (int i = 0; i < 3; ++i) over(height[i], in[i], per_nn);
  through(height, in);
  const F4 na = cross(e[0], e[1]);
  const F8 per_nna = all(1.0F / (dot4(na, na) + 1e-30F));
  for (int j = 0; j < 3; ++j) height[j] = with(na, u[j]);
  for (int i = 0; i < 3; ++i) {
    const F4 m = cross(na, e[i]);
    const float edge = dot4(m, p[i]);
    for (int j = 0; j < 3; ++j) in[j][i] = with(m, u[j]) - edge;
  }
  for (int j = 0; j < 3; ++j) over(height[j], in[j], per_nna);
  through(height, in);

  float smallest = 1e20F;
  for (unsigned m = lanes; m != 0; m &= m - 1) {
    const int k = lowest(m);
    if (!(best[k] < smallest)) continue;
    smallest = best[k];
    lane = k;
  }
  return smallest;
}
