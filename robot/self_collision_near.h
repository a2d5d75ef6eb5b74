// Do two links touch?  Part of the kernels of SelfCollision, included after self_collision_lanes.h.

// Clusters of `body` whose sphere meets the box of the other link: index, centre in the other's
// axes, radius.  to_other: from body to the other link.
static int keep(const CollisionBody& body, const CollisionPose& to_other,
                const CollisionBody& other, float* kept, int stride) noexcept {
  // Which of eight balls in body's axes meet the other's box; c: their centres in the other's axes.
  const auto meet = [&](const float* const* center, const float* radius, int first, F8(&c)[3])
      __attribute__((always_inline)) {
    const F8 x = load8(center[0] + first), y = load8(center[1] + first),
             z = load8(center[2] + first), r = load8(radius + first);
    I8 apart{};
    for (int d = 0; d < 3; ++d) {
      c[d] = x * to_other.column[0][d] + y * to_other.column[1][d] + z * to_other.column[2][d] +
             to_other.origin[d];
      apart |= (c[d] + r < all(other.low[d])) | (all(other.high[d]) < c[d] - r);
    }
    return ~bits(apart) & 0xFFU;
  };
  int n = 0;
  const int blocks = (body.clusters + 7) / 8;
  for (int group = 0; group < blocks; group += 8) {
    F8 c[3];
    unsigned open = 0xFFU;
    if (blocks > 2) open = meet(body.block_center, body.block_radius, group, c);
    for (; open != 0; open &= open - 1) {
      const int block = group + lowest(open);
      if (block >= blocks) break;
      const int first = 8 * block;
      for (unsigned m = meet(body.center, body.radius, first, c); m != 0; m &= m - 1) {
        const int lane = lowest(m);
        if (first + lane >= body.clusters) break;
        for (int d = 0; d < 3; ++d) kept[d * stride + n] = c[d][lane];
        kept[3 * stride + n] = body.radius[first + lane];
        for (int d = 0; d < 3; ++d) kept[(4 + d) * stride + n] = body.center[d][first + lane];
        kept[7 * stride + n++] = static_cast<float>(first + lane);
      }
    }
  }
  for (int pad = n; pad % 8 != 0; ++pad) {
    for (int d = 0; d < 7; ++d) kept[d * stride + pad] = d == 3 ? 0.0F : 1e9F;
  }
  return n;
}

// Along which of b's axes do the boxes around two clusters lie apart?
TWINBUS_INLINE I4 boxes_apart(const CollisionBody& a, int ca, const CollisionPose& a_to_b,
                              const CollisionBody& b, int cb) noexcept {
  const float* h = a.half[ca];
  const F4 x = load4f(a_to_b.column[0]) * h[0], y = load4f(a_to_b.column[1]) * h[1],
           z = load4f(a_to_b.column[2]) * h[2];
  const F4 half = (x > -x ? x : -x) + (y > -y ? y : -y) + (z > -z ? z : -z);
  const F4 gap = moved(a_to_b, a.middle[ca]) - load4f(b.middle[cb]);
  return (gap > -gap ? gap : -gap) > half + load4f(b.half[cb]);
}

// inside: also when one is inside the other.
static bool bodies_touch(const CollisionTables& t, int first, int second, bool inside) noexcept {
  const bool swap = t.body[first].clusters > t.body[second].clusters;
  const CollisionBody& a = t.body[swap ? second : first];
  const CollisionBody& b = t.body[swap ? first : second];
  const CollisionPose& pose_a = t.pose[a.link];
  const CollisionPose& pose_b = t.pose[b.link];
  CollisionPose a_to_b{}, b_to_a{};
  F4 between = load4f(pose_a.origin) - load4f(pose_b.origin);
  for (int i = 0; i < 3; ++i) {
    const F4 row_b = load4f(pose_b.column[i]);
    for (int k = 0; k < 3; ++k) {
      const F4 m = row_b * load4f(pose_a.column[k]);
      a_to_b.column[k][i] = b_to_a.column[i][k] = m[0] + m[1] + m[2];
    }
    const F4 m = row_b * between;
    a_to_b.origin[i] = m[0] + m[1] + m[2];
  }
  for (int i = 0; i < 3; ++i) {
    b_to_a.origin[i] =
        -(a_to_b.column[i][0] * a_to_b.origin[0] + a_to_b.column[i][1] * a_to_b.origin[1] +
          a_to_b.column[i][2] * a_to_b.origin[2]);
  }
  CollisionMemory& memory = t.memory[t.pair_of[first * t.bodies + second]];
  MovedCluster moved_a;
  if (memory.cluster[0] >= 0) {  // what crossed when last looked at is likely to cross
    const TriangleCluster& ca = a.cluster[memory.cluster[0]];
    const TriangleCluster& cb = b.cluster[memory.cluster[1]];
    const F4 in_b = moved(a_to_b, ca.center), in_a = moved(b_to_a, cb.center);
    const float center_a[3] = {in_b[0], in_b[1], in_b[2]};
    const float center_b[3] = {in_a[0], in_a[1], in_a[2]};
    const F4 gap = in_b - load4f(cb.center);
    const float reach = ca.radius + cb.radius;
    bool ready = false;
    if (gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2] <= reach * reach) {
      ++t.work[2];
      if (clusters_cross(ca, cb, a_to_b, center_a, center_b, moved_a, ready, t.work)) return true;
    }
  }
  float n[4] = {memory.apart[0], memory.apart[1], memory.apart[2], 0.0F};
  bool apart = memory.cluster[0] < 0 && (n[0] != 0.0F || n[1] != 0.0F || n[2] != 0.0F) &&
               hulls_apart(a, b, a_to_b, n, 1);
  if (!apart) {
    const F4 from = moved(a_to_b, a.sphere);
    const F4 way = load4f(b.sphere) - from;
    const float scale =
        1.0F / __builtin_sqrtf(way[0] * way[0] + way[1] * way[1] + way[2] * way[2] + 1e-12F);
    for (int k = 0; k < 3; ++k) n[k] = way[k] * scale;
    apart = hulls_apart(a, b, a_to_b, n, kMostProbes);
  }
  if (apart) {
    for (int k = 0; k < 3; ++k) memory.apart[k] = n[k];
    memory.cluster[0] = -1;
    return false;
  }
  const int stride = t.most_clusters;
  float* of_a = t.kept;
  float* of_b = t.kept + 8 * stride;
  const int count_a = keep(a, a_to_b, b, of_a, stride);
  const int count_b = count_a == 0 ? 0 : keep(b, b_to_a, a, of_b, stride);
  for (int i = 0; i < count_a && count_b != 0; ++i) {
    const float in_b[3] = {of_a[i], of_a[stride + i], of_a[2 * stride + i]};
    const float r = of_a[3 * stride + i];
    const int ca = static_cast<int>(of_a[7 * stride + i]);
    bool ready = false;
    for (int j = 0; j < count_b; j += 8) {
      const F8 dx = load8(of_b + 4 * stride + j) - all(in_b[0]);
      const F8 dy = load8(of_b + 5 * stride + j) - all(in_b[1]);
      const F8 dz = load8(of_b + 6 * stride + j) - all(in_b[2]);
      const F8 reach = load8(of_b + 3 * stride + j) + all(r);
      for (unsigned m = bits(dx * dx + dy * dy + dz * dz <= reach * reach); m != 0; m &= m - 1) {
        const int k = j + lowest(m);
        const int cb = static_cast<int>(of_b[7 * stride + k]);
        if (any3(boxes_apart(a, ca, a_to_b, b, cb)) || any3(boxes_apart(b, cb, b_to_a, a, ca)))
          continue;
        ++t.work[2];
        const float in_a[3] = {of_b[k], of_b[stride + k], of_b[2 * stride + k]};
        if (clusters_cross(a.cluster[ca], b.cluster[cb], a_to_b, in_b, in_a, moved_a, ready,
                           t.work)) {
          memory.cluster[0] = ca;
          memory.cluster[1] = cb;
          return true;
        }
      }
    }
  }
  memory.cluster[0] = -1;
  if (!inside) return false;
  const bool a_smaller = a.sphere[3] <= b.sphere[3];
  return a_smaller ? some_inside(a, b, a_to_b) : some_inside(b, a, b_to_a);
}

static int collide(const CollisionTables& t, bool first_only) noexcept {
  const int n = spheres(t);
  t.work[0] += n;
  capsule_bounds(t, n);
  int hits = 0;
  for (int i = 0; i < n; ++i) {
    if (t.bound[i] > 0.0F) continue;
    ++t.work[1];
    const CollisionCandidate pair = t.near[i];
    if (!bodies_touch(t, pair.a, pair.b, true)) continue;
    t.hit[hits++] = t.pair_of[pair.a * t.bodies + pair.b];
    if (first_only) break;
  }
  return hits;
}
