// Do triangles of two clusters cross?  Part of the kernels of SelfCollision, included after float8.h.

// One triangle (corners v) against eight: can some of `lanes` not be separated from it?
static bool row(const F4 (&v)[3], const TriangleCluster& other, int first,
                unsigned lanes) noexcept {
  // About the first corner, so that what is computed is as small as the triangles.
  F8 u[3][3];
  for (int k = 0; k < 3; ++k) {
    for (int d = 0; d < 3; ++d) u[k][d] = load8(other.corner[k][d] + first) - all(v[0][d]);
  }
  const F4 e[3] = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
  const F4 second = e[0], third = -e[2];  // corners; the first is zero
  unsigned alive = lanes;
  const auto separate = [&](const F8& x, const F8& y, const F8& z) __attribute__((always_inline)) {
    const F8 slack = all(kAxisSlack) * most(size(x), most(size(y), size(z)));
    const F8 a1 = all(second[0]) * x + all(second[1]) * y + all(second[2]) * z;
    const F8 a2 = all(third[0]) * x + all(third[1]) * y + all(third[2]) * z;
    const F8 zero = all(0.0F);
    const F8 low_a = least(zero, least(a1, a2)), high_a = most(zero, most(a1, a2));
    F8 b[3];
    for (int k = 0; k < 3; ++k) b[k] = u[k][0] * x + u[k][1] * y + u[k][2] * z;
    const F8 low_b = least(b[0], least(b[1], b[2])), high_b = most(b[0], most(b[1], b[2]));
    alive &= ~bits((high_a + slack < low_b) | (high_b + slack < low_a));
  };
  const F4 normal = cross(e[0], e[1]);
  separate(all(normal[0]), all(normal[1]), all(normal[2]));
  if (alive == 0) return false;
  F8 f[3][3];
  for (int d = 0; d < 3; ++d) {
    f[0][d] = u[1][d] - u[0][d];
    f[1][d] = u[2][d] - u[1][d];
    f[2][d] = u[0][d] - u[2][d];
  }
  const F8 n[3] = {f[0][1] * f[1][2] - f[0][2] * f[1][1], f[0][2] * f[1][0] - f[0][0] * f[1][2],
                   f[0][0] * f[1][1] - f[0][1] * f[1][0]};
  for (int p = 0; p < 3; ++p) {
    const F8 ex = all(e[p][0]), ey = all(e[p][1]), ez = all(e[p][2]);
    for (int k = 0; k < 3; ++k) {
      if (alive == 0) return false;
      separate(ey * f[k][2] - ez * f[k][1], ez * f[k][0] - ex * f[k][2],
               ex * f[k][1] - ey * f[k][0]);
    }
  }
  // What boxes and planes have said already, now without their slack.
  separate(n[0], n[1], n[2]);
  for (int d = 0; d < 3; ++d) {
    const float a1 = second[d], a2 = third[d];
    const float low = (a1 < a2 ? a1 : a2) < 0.0F ? (a1 < a2 ? a1 : a2) : 0.0F;
    const float high = (a1 > a2 ? a1 : a2) > 0.0F ? (a1 > a2 ? a1 : a2) : 0.0F;
    const F8 low_b = least(u[0][d], least(u[1][d], u[2][d]));
    const F8 high_b = most(u[0][d], most(u[1][d], u[2][d]));
    alive &= ~bits((all(high + kAxisSlack) < low_b) | (high_b < all(low - kAxisSlack)));
  }
  // Triangles in one plane: normals of their edges in it.
  for (int p = 0; p < 3 && alive != 0; ++p) {
    const F4 axis = cross(normal, e[p]);
    separate(all(axis[0]), all(axis[1]), all(axis[2]));
    separate(n[1] * f[p][2] - n[2] * f[p][1], n[2] * f[p][0] - n[0] * f[p][2],
             n[0] * f[p][1] - n[1] * f[p][0]);
  }
  return alive != 0;
}

// Triangles of the cluster that the box may meet: their boxes do, and their planes.
TWINBUS_INLINE unsigned near_box(const CollisionBody& body, int cluster, const float* middle,
                                 const float* half, int first) noexcept {
  const TriangleCluster& c = body.cluster[cluster];
  const CollisionTriangleBoxes& box = body.triangle_boxes[cluster];
  I8 apart{};
  F8 side = -load8(c.offset + first), reach = all(0.0F);
  for (int d = 0; d < 3; ++d) {
    const F8 normal = load8(c.normal[d] + first);
    side += normal * middle[d];
    reach += size(normal) * half[d];
    apart |= (load8(box.high[d] + first) < all(middle[d] - half[d])) |
             (all(middle[d] + half[d]) < load8(box.low[d] + first));
  }
  return ~bits(apart | (size(side) > reach)) & 0xFFU;
}
TWINBUS_INLINE unsigned near_box(const CollisionBody& body, int cluster, const float* middle,
                                 const float* half) noexcept {
  const int count = body.cluster[cluster].count;
  unsigned near = near_box(body, cluster, middle, half, 0);
  if (count > 8) near |= near_box(body, cluster, middle, half, 8) << 8;
  return near & ((1U << count) - 1U);
}

// Of eight triangles: those that this one (corners v, box low to high) may cross by their boxes and planes.
TWINBUS_INLINE unsigned near_triangle(const F4 (&v)[3], const float (&low)[3],
                                      const float (&high)[3], const TriangleCluster& c,
                                      const CollisionTriangleBoxes& box, int first) noexcept {
  I8 apart{};
  for (int d = 0; d < 3; ++d)
    apart |=
        (load8(box.high[d] + first) < all(low[d])) | (all(high[d]) < load8(box.low[d] + first));
  const F8 nx = load8(c.normal[0] + first), ny = load8(c.normal[1] + first),
           nz = load8(c.normal[2] + first), offset = load8(c.offset + first);
  F8 side[3];
  for (int k = 0; k < 3; ++k) side[k] = nx * v[k][0] + ny * v[k][1] + nz * v[k][2] - offset;
  const F8 nearest = least(side[0], least(side[1], side[2]));
  const F8 farthest = most(side[0], most(side[1], side[2]));
  return ~bits(apart | (nearest > all(kPlaneSlack)) | (farthest < all(-kPlaneSlack))) & 0xFFU;
}

// A cluster's triangles in the axes of another link, and the box around each.
struct MovedCluster {
  alignas(32) float corner[3][3][TriangleCluster::kLanes];
  alignas(32) float low[3][TriangleCluster::kLanes], high[3][TriangleCluster::kLanes];
};

static void move_cluster(const TriangleCluster& c, const CollisionPose& to,
                         MovedCluster& m) noexcept {
  for (int first = 0; first < c.count; first += 8) {
    for (int k = 0; k < 3; ++k) {
      const F8 x = load8(c.corner[k][0] + first), y = load8(c.corner[k][1] + first),
               z = load8(c.corner[k][2] + first);
      for (int d = 0; d < 3; ++d) {
        const F8 p = x * to.column[0][d] + y * to.column[1][d] + z * to.column[2][d] + to.origin[d];
        __builtin_memcpy(m.corner[k][d] + first, &p, sizeof p);
      }
    }
    for (int d = 0; d < 3; ++d) {
      const F8 a = load8(m.corner[0][d] + first), b = load8(m.corner[1][d] + first),
               c2 = load8(m.corner[2][d] + first);
      const F8 low = least(a, least(b, c2)), high = most(a, most(b, c2));
      __builtin_memcpy(m.low[d] + first, &low, sizeof low);
      __builtin_memcpy(m.high[d] + first, &high, sizeof high);
    }
  }
}

// Do triangles of the two clusters cross?  a_in_b, b_in_a: middle and half edges of their boxes in the
// other's axes.  moved: of a, filled when it is needed first.
[[maybe_unused]] static bool clusters_cross(const CollisionBody& body_a, int ca,
                                            const CollisionBody& body_b, int cb,
                                            const CollisionPose& a_to_b, const float* a_in_b,
                                            const float* a_half, const float* b_in_a,
                                            const float* b_half, MovedCluster& moved_a, bool& ready,
                                            long* work) noexcept {
  unsigned of_a = near_box(body_a, ca, b_in_a, b_half);
  if (of_a == 0) return false;
  const unsigned of_b = near_box(body_b, cb, a_in_b, a_half);
  if (of_b == 0) return false;
  const TriangleCluster& a = body_a.cluster[ca];
  const TriangleCluster& b = body_b.cluster[cb];
  const CollisionTriangleBoxes& boxes_b = body_b.triangle_boxes[cb];
  if (!ready) move_cluster(a, a_to_b, moved_a);
  ready = true;
  for (int first = 0; first < a.count; first += 8) {
    I8 apart{};
    for (int d = 0; d < 3; ++d) {
      apart |= (load8(moved_a.high[d] + first) < all(b.low[d])) |
               (all(b.high[d]) < load8(moved_a.low[d] + first));
    }
    of_a &= ~(bits(apart) << first);
  }
  for (; of_a != 0; of_a &= of_a - 1) {
    const int i = lowest(of_a);
    ++work[3];
    F4 v[3];
    for (int k = 0; k < 3; ++k)
      v[k] = F4{moved_a.corner[k][0][i], moved_a.corner[k][1][i], moved_a.corner[k][2][i], 0.0F};
    const float low[3] = {moved_a.low[0][i], moved_a.low[1][i], moved_a.low[2][i]};
    const float high[3] = {moved_a.high[0][i], moved_a.high[1][i], moved_a.high[2][i]};
    for (unsigned first = 0; first < 16; first += 8) {
      unsigned lanes = of_b >> first & 0xFFU;
      if (lanes == 0) continue;
      lanes &= near_triangle(v, low, high, b, boxes_b, static_cast<int>(first));
      if (lanes != 0 && row(v, b, static_cast<int>(first), lanes)) return true;
    }
  }
  return false;
}
