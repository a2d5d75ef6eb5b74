// Is one link inside another?  Part of the kernels of SelfCollision, included after float8.h.

// How many triangles of the body a ray from the point crosses, odd or even.
static bool odd_crossings(const CollisionBody& body, const float* point,
                          const float* ray) noexcept {
  unsigned odd = 0;
  unsigned met = 0;  // of eight clusters, those whose ball the line meets
  for (int c = 0; c < body.clusters; ++c) {
    if (c % 8 == 0) {
      F8 away[3], along = all(0.0F), away2 = all(0.0F);
      for (int d = 0; d < 3; ++d) {
        away[d] = load8(body.center[d] + c) - all(point[d]);
        along += away[d] * ray[d];
        away2 += away[d] * away[d];
      }
      const F8 reach = load8(body.radius + c) + all(1e-4F);  // wide: the next line loses digits
      const F8 line2 = all(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
      met = bits(away2 * line2 - along * along <= reach * reach * line2);
    }
    if ((met >> (c % 8) & 1U) == 0) continue;
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
