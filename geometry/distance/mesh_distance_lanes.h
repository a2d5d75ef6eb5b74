// The kernels of MeshDistance, included after triangle_sat.h and mesh_distance_triangles.h.

// Triangles of the cluster whose plane meets the ball.
TWINBUS_INLINE unsigned near_planes(const TriangleCluster& c, const float* center, float radius,
                                    int first) noexcept {
  const F8 side = load8(c.normal[0] + first) * center[0] + load8(c.normal[1] + first) * center[1] +
                  load8(c.normal[2] + first) * center[2] - load8(c.offset + first);
  return bits(size(side) <= all(radius)) << first;
}

// Measures two clusters; what is nearer than t.below replaces it.
static void measure(const MeshTables& t, MeshNearest& nearest, int ca, int cb, const float* a_in_b,
                    const float* b_in_a, MovedCluster& moved_a, int& ready) noexcept {
  const TriangleCluster& a = t.a->cluster[ca];
  const TriangleCluster& b = t.b->cluster[cb];
  const float below = nearest.below;
  unsigned of_b =
      near_planes(b, a_in_b, a.radius + below, 0) | near_planes(b, a_in_b, a.radius + below, 8);
  of_b &= (1U << b.count) - 1U;
  if (of_b == 0) return;
  unsigned of_a =
      near_planes(a, b_in_a, b.radius + below, 0) | near_planes(a, b_in_a, b.radius + below, 8);
  of_a &= (1U << a.count) - 1U;
  if (of_a == 0) return;
  if (ready != ca) move_cluster(a, t.a_to_b, moved_a);
  ready = ca;
  const auto box_gap2 =
      [](const F8& low, const F8& high, float from, float to) __attribute__((always_inline)) {
    const F8 gap = most(most(low - all(to), all(from) - high), all(0.0F));
    return gap * gap;
  };
  for (int first = 0; first < a.count; first += 8) {
    F8 gap2 = all(0.0F);
    for (int d = 0; d < 3; ++d)
      gap2 += box_gap2(load8(moved_a.low[d] + first), load8(moved_a.high[d] + first), b.low[d],
                       b.high[d]);
    of_a &= bits(gap2 < all(below * below)) << first | (first == 0 ? 0xFF00U : 0x00FFU);
  }
  if (of_a == 0) return;
  // Boxes around b's triangles.
  F8 low[2][3], high[2][3];
  for (int half = 0; half < 2; ++half) {
    for (int d = 0; d < 3; ++d) {
      const F8 x = load8(b.corner[0][d] + 8 * half), y = load8(b.corner[1][d] + 8 * half),
               z = load8(b.corner[2][d] + 8 * half);
      low[half][d] = least(x, least(y, z));
      high[half][d] = most(x, most(y, z));
    }
  }
  for (; of_a != 0; of_a &= of_a - 1) {
    const int i = lowest(of_a);
    F4 v[3];
    for (int k = 0; k < 3; ++k)
      v[k] = F4{moved_a.corner[k][0][i], moved_a.corner[k][1][i], moved_a.corner[k][2][i], 0.0F};
    for (int half = 0; half < 2; ++half) {
      unsigned lanes = of_b >> (8 * half) & 0xFFU;
      if (lanes == 0) continue;
      F8 gap2 = all(0.0F);
      for (int d = 0; d < 3; ++d)
        gap2 += box_gap2(low[half][d], high[half][d], moved_a.low[d][i], moved_a.high[d][i]);
      lanes &= bits(gap2 < all(nearest.below * nearest.below));
      if (lanes == 0) continue;
      int lane = 0;
      const float found = row_distance2(v, b, 8 * half, lanes, lane);
      if (!(found < nearest.below * nearest.below)) continue;
      nearest.below = __builtin_sqrtf(found);
      nearest.cluster_a = ca;
      nearest.cluster_b = cb;
      nearest.triangle_a = i;
      nearest.triangle_b = 8 * half + lane;
      if (!(nearest.below > 0.0F)) return;
    }
  }
}

// Clusters of `mesh` nearer than `below` to the box of the other mesh.
static int keep_near(const MeshView& mesh, const CollisionPose& to_other, const MeshView& other,
                     float below, float* kept, int stride) noexcept {
  int n = 0;
  for (int first = 0; first < mesh.clusters; first += 8) {
    const F8 x = load8(mesh.center[0] + first), y = load8(mesh.center[1] + first),
             z = load8(mesh.center[2] + first), r = load8(mesh.radius + first);
    const F8 reach = r + all(below);
    F8 c[3], gap2 = all(0.0F);
    for (int d = 0; d < 3; ++d) {
      c[d] = x * to_other.column[0][d] + y * to_other.column[1][d] + z * to_other.column[2][d] +
             to_other.origin[d];
      const F8 gap = most(most(c[d] - all(other.high[d]), all(other.low[d]) - c[d]), all(0.0F));
      gap2 += gap * gap;
    }
    for (unsigned m = bits(gap2 <= reach * reach); m != 0; m &= m - 1) {
      const int lane = lowest(m);
      if (first + lane >= mesh.clusters) break;
      for (int d = 0; d < 3; ++d) {
        kept[d * stride + n] = c[d][lane];
        kept[(4 + d) * stride + n] = mesh.center[d][first + lane];
      }
      kept[3 * stride + n] = mesh.radius[first + lane];
      kept[7 * stride + n++] = static_cast<float>(first + lane);
    }
  }
  for (int pad = n; pad % 8 != 0; ++pad) {
    for (int d = 0; d < 7; ++d) kept[d * stride + pad] = d == 3 ? 0.0F : 1e9F;
  }
  return n;
}

// Lower bound of the squared distance of two clusters, from their boxes in b's axes.
TWINBUS_INLINE float boxes_gap2(const MeshView& a, int ca, const CollisionPose& a_to_b,
                                const MeshView& b, int cb) noexcept {
  const float* h = a.half[ca];
  const F4 x = load4f(a_to_b.column[0]) * h[0], y = load4f(a_to_b.column[1]) * h[1],
           z = load4f(a_to_b.column[2]) * h[2];
  const F4 half = (x > -x ? x : -x) + (y > -y ? y : -y) + (z > -z ? z : -z);
  const F4 far = moved(a_to_b, a.middle[ca]) - load4f(b.middle[cb]);
  F4 gap = (far > -far ? far : -far) - half - load4f(b.half[cb]);
  gap = gap > F4{} ? gap : F4{};
  return gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2];
}

static void search(const MeshTables& t, MeshNearest& nearest) noexcept {
  const MeshView& a = *t.a;
  const MeshView& b = *t.b;
  MovedCluster moved_a;
  int ready = -1;
  const auto centres = [&](int ca, int cb, float(&a_in_b)[3], float(&b_in_a)[3]) {
    const F4 x = moved(t.a_to_b, a.cluster[ca].center), y = moved(t.b_to_a, b.cluster[cb].center);
    for (int d = 0; d < 3; ++d) {
      a_in_b[d] = x[d];
      b_in_a[d] = y[d];
    }
  };
  float a_in_b[3], b_in_a[3];
  int done_a = nearest.cluster_a, done_b = nearest.cluster_b;
  nearest.cluster_a = nearest.cluster_b = -1;
  if (done_a >= 0) {
    centres(done_a, done_b, a_in_b, b_in_a);
    measure(t, nearest, done_a, done_b, a_in_b, b_in_a, moved_a, ready);
    if (!(nearest.below > t.enough)) return;
  }
  const int stride = t.stride;
  float* of_a = t.kept;
  float* of_b = t.kept + 8 * stride;
  const int count_a = keep_near(a, t.a_to_b, b, nearest.below, of_a, stride);
  const int count_b = count_a == 0 ? 0 : keep_near(b, t.b_to_a, a, nearest.below, of_b, stride);
  if (count_a == 0 || count_b == 0) return;
  const auto pair_of = [&](int i, int k) {
    for (int d = 0; d < 3; ++d) {
      a_in_b[d] = of_a[d * stride + i];
      b_in_a[d] = of_b[d * stride + k];
    }
  };
  if (nearest.cluster_a < 0) {  // nothing is known: begin with those whose balls are nearest
    float least_gap = 1e20F;
    int i_best = 0, k_best = 0;
    for (int i = 0; i < count_a; ++i) {
      for (int j = 0; j < count_b; j += 8) {
        F8 far2 = all(0.0F);
        for (int d = 0; d < 3; ++d) {
          const F8 far = load8(of_b + (4 + d) * stride + j) - all(of_a[d * stride + i]);
          far2 += far * far;
        }
        const F8 gap = root(far2) - load8(of_b + 3 * stride + j) - all(of_a[3 * stride + i]);
        for (unsigned m = bits(gap < all(least_gap)); m != 0; m &= m - 1) {
          const int lane = lowest(m);
          if (!(gap[lane] < least_gap)) continue;
          least_gap = gap[lane];
          i_best = i;
          k_best = j + lane;
        }
      }
    }
    if (k_best < count_b) {
      done_a = static_cast<int>(of_a[7 * stride + i_best]);
      done_b = static_cast<int>(of_b[7 * stride + k_best]);
      pair_of(i_best, k_best);
      measure(t, nearest, done_a, done_b, a_in_b, b_in_a, moved_a, ready);
    }
  }
  for (int i = 0; i < count_a && nearest.below > t.enough; ++i) {
    const int ca = static_cast<int>(of_a[7 * stride + i]);
    for (int j = 0; j < count_b; j += 8) {
      F8 far2 = all(0.0F);
      for (int d = 0; d < 3; ++d) {
        const F8 far = load8(of_b + (4 + d) * stride + j) - all(of_a[d * stride + i]);
        far2 += far * far;
      }
      const F8 reach = load8(of_b + 3 * stride + j) + all(of_a[3 * stride + i] + nearest.below);
      for (unsigned m = bits(far2 <= reach * reach); m != 0; m &= m - 1) {
        const int k = j + lowest(m);
        if (k >= count_b) break;
        const int cb = static_cast<int>(of_b[7 * stride + k]);
        if (ca == done_a && cb == done_b) continue;
        const float below2 = nearest.below * nearest.below;
        if (boxes_gap2(a, ca, t.a_to_b, b, cb) >= below2 ||
            boxes_gap2(b, cb, t.b_to_a, a, ca) >= below2)
          continue;
        pair_of(i, k);
        measure(t, nearest, ca, cb, a_in_b, b_in_a, moved_a, ready);
        if (!(nearest.below > t.enough)) return;
      }
    }
  }
}
