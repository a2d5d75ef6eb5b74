// The kernels of SelfCollision.  Included once per instruction set, inside a namespace and after
// TWINBUS_WIDE says whether a comparison of eight lanes becomes a mask in one instruction.

typedef float F4 __attribute__((vector_size(16), aligned(16)));
typedef float F8 __attribute__((vector_size(32), aligned(32)));
typedef int I4 __attribute__((vector_size(16), aligned(16)));
typedef int I8 __attribute__((vector_size(32), aligned(32)));

constexpr float kAxisSlack = 1e-7F;     // per length of a separating axis [m]
constexpr float kCapsuleSlack = 1e-5F;  // what single precision may lose [m]

TWINBUS_INLINE F8 load8(const float* from) noexcept {
  F8 v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
TWINBUS_INLINE F4 load4f(const float* from) noexcept {
  F4 v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
TWINBUS_INLINE F8 all(float x) noexcept { return F8{x, x, x, x, x, x, x, x}; }
TWINBUS_INLINE F8 least(F8 a, F8 b) noexcept { return a < b ? a : b; }
TWINBUS_INLINE F8 most(F8 a, F8 b) noexcept { return a > b ? a : b; }
TWINBUS_INLINE F8 size(F8 a) noexcept { return most(a, -a); }
TWINBUS_INLINE F8 unit_clamp(F8 a) noexcept { return least(most(a, all(0.0F)), all(1.0F)); }
TWINBUS_INLINE unsigned bits(I8 mask) noexcept {
#if TWINBUS_WIDE
  return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<F8>(mask)));
#elif defined(__SSE__)
  F4 half[2];
  __builtin_memcpy(half, &mask, sizeof half);
  return static_cast<unsigned>(__builtin_ia32_movmskps(half[0])) |
         static_cast<unsigned>(__builtin_ia32_movmskps(half[1])) << 4;
#else
  unsigned result = 0;
  for (int i = 0; i < 8; ++i) result |= mask[i] != 0 ? 1U << i : 0U;
  return result;
#endif
}
// Of three coordinates: is any lane set?
TWINBUS_INLINE bool any3(I4 mask) noexcept {
#if defined(__SSE__)
  return (__builtin_ia32_movmskps(reinterpret_cast<F4>(mask)) & 7) != 0;
#else
  return (mask[0] | mask[1] | mask[2]) != 0;
#endif
}
TWINBUS_INLINE F8 root(F8 a) noexcept {
#if TWINBUS_WIDE
  return __builtin_ia32_sqrtps256(a);
#else
  for (int i = 0; i < 8; ++i) a[i] = __builtin_sqrtf(a[i]);
  return a;
#endif
}
TWINBUS_INLINE int lowest(unsigned mask) noexcept { return __builtin_ctz(mask); }
TWINBUS_INLINE F4 turned(const CollisionPose& pose, const float* p) noexcept {
  return load4f(pose.column[0]) * p[0] + load4f(pose.column[1]) * p[1] +
         load4f(pose.column[2]) * p[2];
}
TWINBUS_INLINE F4 moved(const CollisionPose& pose, const float* p) noexcept {
  return turned(pose, p) + load4f(pose.origin);
}
TWINBUS_INLINE F4 cross(F4 a, F4 b) noexcept {
  const F4 p = __builtin_shufflevector(a, a, 1, 2, 0, 3);
  const F4 q = __builtin_shufflevector(b, b, 1, 2, 0, 3);
  const F4 c = a * q - p * b;
  return __builtin_shufflevector(c, c, 1, 2, 0, 3);
}

static void kinematics(const CollisionTables& t) noexcept {
  for (int j = 0; j < t.joints; ++j) {
    const CollisionJoint& joint = t.joint[j];
    const CollisionPose& parent = t.pose[joint.parent];
    CollisionPose& child = t.pose[j + 1];
    F4 offset = load4f(joint.offset);
    F4 local[3] = {load4f(joint.still[0]), load4f(joint.still[1]), load4f(joint.still[2])};
    if (joint.turns) {
      const float s = static_cast<float>(t.sine[j]), c = static_cast<float>(t.cosine[j]);
      for (int k = 0; k < 3; ++k)
        local[k] = local[k] + load4f(joint.with_cosine[k]) * c + load4f(joint.with_sine[k]) * s;
    } else {
      offset = offset + load4f(joint.slide) * static_cast<float>(t.q[j]);
    }
    const F4 x = load4f(parent.column[0]), y = load4f(parent.column[1]),
             z = load4f(parent.column[2]);
    for (int k = 0; k < 3; ++k) {
      const F4 column = x * local[k][0] + y * local[k][1] + z * local[k][2];
      __builtin_memcpy(child.column[k], &column, sizeof column);
    }
    const F4 origin = load4f(parent.origin) + x * offset[0] + y * offset[1] + z * offset[2];
    __builtin_memcpy(child.origin, &origin, sizeof origin);
  }
  for (int i = 0; i < t.bodies; ++i) {
    const CollisionBody& body = t.body[i];
    const CollisionPose& pose = t.pose[body.link];
    const F4 s = moved(pose, body.sphere), a = moved(pose, body.from), b = moved(pose, body.to);
    for (int k = 0; k < 3; ++k) {
      t.sphere[k][i] = s[k];
      t.from[k][i] = a[k];
      t.to[k][i] = b[k];
    }
  }
}

// Pairs whose spheres meet; how many.
static int spheres(const CollisionTables& t) noexcept {
  int n = 0;
  for (int a = 0; a < t.bodies; ++a) {
    const F8 x = all(t.sphere[0][a]), y = all(t.sphere[1][a]), z = all(t.sphere[2][a]);
    const F8 r = all(t.sphere[3][a]);
    for (int block = (a + 1) / 8; block < t.blocks; ++block) {
      const unsigned wanted = t.wanted[a * t.blocks + block];
      if (wanted == 0) continue;
      const F8 dx = load8(t.sphere[0] + 8 * block) - x;
      const F8 dy = load8(t.sphere[1] + 8 * block) - y;
      const F8 dz = load8(t.sphere[2] + 8 * block) - z;
      const F8 reach = load8(t.sphere[3] + 8 * block) + r;
      for (unsigned m = bits(dx * dx + dy * dy + dz * dz <= reach * reach) & wanted; m != 0;
           m &= m - 1) {
        t.near[n].a = a;
        t.near[n++].b = 8 * block + lowest(m);
      }
    }
  }
  return n;
}

// Lower bounds of the distances of the capsules of n candidates.  Points are found that are nearly
// the nearest; the bound is the gap of the two segments along the direction between these points,
// which no error of theirs can make too large.
static void capsule_bounds(const CollisionTables& t, int n) noexcept {
  for (int first = 0; first < n; first += 8) {
    alignas(32) float in[14][8];
    for (int lane = 0; lane < 8; ++lane) {
      const CollisionCandidate pair = t.near[first + lane < n ? first + lane : n - 1];
      for (int k = 0; k < 3; ++k) {
        in[k][lane] = t.from[k][pair.a];
        in[3 + k][lane] = t.to[k][pair.a];
        in[6 + k][lane] = t.from[k][pair.b];
        in[9 + k][lane] = t.to[k][pair.b];
      }
      in[12][lane] = t.capsule_radius[pair.a] + t.capsule_radius[pair.b];
    }
    F8 p[3], q[3], u[3], v[3], w[3];
    for (int k = 0; k < 3; ++k) {
      p[k] = load8(in[k]);
      q[k] = load8(in[6 + k]);
      u[k] = load8(in[3 + k]) - p[k];
      v[k] = load8(in[9 + k]) - q[k];
      w[k] = q[k] - p[k];
    }
    const auto dot = [](const F8(&x)[3], const F8(&y)[3]) __attribute__((always_inline)) {
      return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    };
    const F8 tiny = all(1e-12F);
    const F8 uu = dot(u, u) + tiny, vv = dot(v, v) + tiny, uv = dot(u, v), uw = dot(u, w),
             vw = dot(v, w);
    const F8 det = most(uu * vv - uv * uv, all(1e-12F) * uu * vv + tiny);
    // Points p + s u and q + r v: nearest on the lines, then each clamped for the other.
    F8 s = unit_clamp((uw * vv - vw * uv) / det);
    F8 r = unit_clamp((s * uv - vw) / vv);
    s = unit_clamp((r * uv + uw) / uu);
    r = unit_clamp((s * uv - vw) / vv);
    F8 d[3];
    for (int k = 0; k < 3; ++k) d[k] = w[k] + r * v[k] - s * u[k];
    const F8 safe = most(root(dot(d, d)), all(1e-9F));
    // Along d: the farthest end of the first, the nearest end of the second.
    const F8 zero = all(0.0F);
    const F8 gap = (dot(d, w) + least(dot(d, v), zero) - most(dot(d, u), zero)) / safe;
    const F8 bound = gap - load8(in[12]) - all(kCapsuleSlack);
    __builtin_memcpy(t.bound + first, &bound, sizeof bound);
  }
}

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
  for (int d = 0; d < 3; ++d) {
    const float a1 = second[d], a2 = third[d];
    const float low = (a1 < a2 ? a1 : a2) < 0.0F ? (a1 < a2 ? a1 : a2) : 0.0F;
    const float high = (a1 > a2 ? a1 : a2) > 0.0F ? (a1 > a2 ? a1 : a2) : 0.0F;
    const F8 low_b = least(u[0][d], least(u[1][d], u[2][d]));
    const F8 high_b = most(u[0][d], most(u[1][d], u[2][d]));
    alive &= ~bits((all(high + kAxisSlack) < low_b) | (high_b < all(low - kAxisSlack)));
  }
  if (alive == 0) return false;
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
  separate(n[0], n[1], n[2]);
  for (int p = 0; p < 3; ++p) {
    const F8 ex = all(e[p][0]), ey = all(e[p][1]), ez = all(e[p][2]);
    for (int k = 0; k < 3; ++k) {
      if (alive == 0) return false;
      separate(ey * f[k][2] - ez * f[k][1], ez * f[k][0] - ex * f[k][2],
               ex * f[k][1] - ey * f[k][0]);
    }
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

// Triangles of the cluster whose plane meets the ball.
TWINBUS_INLINE unsigned near_planes(const TriangleCluster& c, const float* center, float radius,
                                    int first) noexcept {
  const F8 side = load8(c.normal[0] + first) * center[0] + load8(c.normal[1] + first) * center[1] +
                  load8(c.normal[2] + first) * center[2] - load8(c.offset + first);
  return bits(size(side) <= all(radius)) << first;
}

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

// Do triangles of the two clusters cross?  a_in_b, b_in_a: centres of their spheres in the other's
// axes.  moved: of a, filled when it is needed first.
static bool clusters_cross(const TriangleCluster& a, const TriangleCluster& b,
                           const CollisionPose& a_to_b, const float* a_in_b, const float* b_in_a,
                           MovedCluster& moved_a, bool& ready, long* work) noexcept {
  const unsigned of_b = near_planes(b, a_in_b, a.radius, 0) | near_planes(b, a_in_b, a.radius, 8);
  if (of_b == 0) return false;
  unsigned of_a = near_planes(a, b_in_a, b.radius, 0) | near_planes(a, b_in_a, b.radius, 8);
  of_a &= (1U << a.count) - 1U;
  if (of_a == 0) return false;
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
    if ((of_b & 0xFFU) != 0 && row(v, b, 0, of_b & 0xFFU)) return true;
    if ((of_b >> 8) != 0 && row(v, b, 8, of_b >> 8)) return true;
  }
  return false;
}

// How many triangles of the body a ray from the point crosses, odd or even.
static bool odd_crossings(const CollisionBody& body, const float* point,
                          const float* ray) noexcept {
  unsigned odd = 0;
  for (int c = 0; c < body.clusters; ++c) {
    const TriangleCluster& cluster = body.cluster[c];
    for (int first = 0; first < cluster.count; first += 8) {
      F8 p[3][3];
      for (int k = 0; k < 3; ++k) {
        for (int d = 0; d < 3; ++d) p[k][d] = load8(cluster.corner[k][d] + first) - all(point[d]);
      }
      // The volumes of ray and edges say on which side of each edge the ray passes.
      const auto volume = [&](int i, int j) __attribute__((always_inline)) {
        const F8 x = p[i][1] * p[j][2] - p[i][2] * p[j][1];
        const F8 y = p[i][2] * p[j][0] - p[i][0] * p[j][2];
        const F8 z = p[i][0] * p[j][1] - p[i][1] * p[j][0];
        return x * ray[0] + y * ray[1] + z * ray[2];
      };
      const F8 a = volume(0, 1), b = volume(1, 2), c2 = volume(2, 0);
      const F8 zero = all(0.0F);
      const I8 in =
          ((a >= zero) & (b >= zero) & (c2 >= zero)) | ((a < zero) & (b < zero) & (c2 < zero));
      const F8 normal[3] = {load8(cluster.normal[0] + first), load8(cluster.normal[1] + first),
                            load8(cluster.normal[2] + first)};
      const F8 slope = normal[0] * ray[0] + normal[1] * ray[1] + normal[2] * ray[2];
      const F8 height = normal[0] * p[0][0] + normal[1] * p[0][1] + normal[2] * p[0][2];
      const I8 ahead = ((slope > zero) & (height > zero)) | ((slope < zero) & (height < zero));
      const int real = cluster.count - first;
      const unsigned lanes = real >= 8 ? 0xFFU : (1U << real) - 1U;
      odd ^= static_cast<unsigned>(__builtin_parity(bits(in & ahead) & lanes));
    }
  }
  return odd != 0;
}

// Is a point of every shape of the inner link inside the outer one?  Three rays must agree, so that
// an open mesh or a ray along an edge does not decide.
static bool some_inside(const CollisionBody& inner, const CollisionBody& outer,
                        const CollisionPose& to_outer) noexcept {
  constexpr float kRays[3][3] = {
      {0.287F, 0.611F, 0.738F}, {-0.824F, 0.313F, -0.472F}, {0.391F, -0.902F, 0.183F}};
  for (int w = 0; w < inner.witnesses; ++w) {
    const F4 point = moved(to_outer, inner.witness[w]);
    bool in = true;
    for (int d = 0; d < 3; ++d) in = in && point[d] >= outer.low[d] && point[d] <= outer.high[d];
    if (!in) continue;
    const float p[3] = {point[0], point[1], point[2]};
    if (odd_crossings(outer, p, kRays[0]) && odd_crossings(outer, p, kRays[1]) &&
        odd_crossings(outer, p, kRays[2]))
      return true;
  }
  return false;
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
  const int stride = t.most_clusters;
  float* of_a = t.kept;
  float* of_b = t.kept + 8 * stride;
  const int count_a = keep(a, a_to_b, b, of_a, stride);
  const int count_b = count_a == 0 ? 0 : keep(b, b_to_a, a, of_b, stride);
  MovedCluster moved_a;
  for (int i = 0; i < count_a && count_b != 0; ++i) {
    const float in_b[3] = {of_a[i], of_a[stride + i], of_a[2 * stride + i]};
    const float r = of_a[3 * stride + i];
    const int ca = static_cast<int>(of_a[7 * stride + i]);
    F4 middle{}, half{};
    bool placed = false, ready = false;
    for (int j = 0; j < count_b; j += 8) {
      const F8 dx = load8(of_b + 4 * stride + j) - all(in_b[0]);
      const F8 dy = load8(of_b + 5 * stride + j) - all(in_b[1]);
      const F8 dz = load8(of_b + 6 * stride + j) - all(in_b[2]);
      const F8 reach = load8(of_b + 3 * stride + j) + all(r);
      for (unsigned m = bits(dx * dx + dy * dy + dz * dz <= reach * reach); m != 0; m &= m - 1) {
        const int k = j + lowest(m);
        const int cb = static_cast<int>(of_b[7 * stride + k]);
        if (!placed) {
          placed = true;
          const float* h = a.half[ca];
          middle = moved(a_to_b, a.middle[ca]);
          F4 x = load4f(a_to_b.column[0]) * h[0], y = load4f(a_to_b.column[1]) * h[1],
             z = load4f(a_to_b.column[2]) * h[2];
          half = (x > -x ? x : -x) + (y > -y ? y : -y) + (z > -z ? z : -z);
        }
        const F4 gap = middle - load4f(b.middle[cb]);
        const F4 room = half + load4f(b.half[cb]);
        const F4 far = gap > -gap ? gap : -gap;
        if (any3(far > room)) continue;
        ++t.work[2];
        const float in_a[3] = {of_b[k], of_b[stride + k], of_b[2 * stride + k]};
        if (clusters_cross(a.cluster[ca], b.cluster[cb], a_to_b, in_b, in_a, moved_a, ready,
                           t.work))
          return true;
      }
    }
  }
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
