// Distance of capsules, eight at a time: what the kernels of SelfCollision and NearShapes share, included
// after float8.h.

TWINBUS_INLINE F8 dot8(const F8 (&x)[3], const F8 (&y)[3]) noexcept {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

// Lower bound of the distance of the segments p + s u and q + r v, w = q - p.  Points are found that
// are nearly the nearest; the bound is the gap of the two segments along the direction between these
// points, which no error of theirs can make too large.  d: from the first point to the second.
TWINBUS_INLINE F8 segments_gap(const F8 (&u)[3], const F8 (&v)[3], const F8 (&w)[3],
                               F8 (&d)[3]) noexcept {
  const F8 tiny = all(1e-12F);
  const F8 uu = dot8(u, u) + tiny, vv = dot8(v, v) + tiny, uv = dot8(u, v), uw = dot8(u, w),
           vw = dot8(v, w);
  const F8 det = most(uu * vv - uv * uv, all(1e-12F) * uu * vv + tiny);
  // Nearest on the lines, then each clamped for the other.
  F8 s = unit_clamp((uw * vv - vw * uv) / det);
  F8 r = unit_clamp((s * uv - vw) / vv);
  s = unit_clamp((r * uv + uw) / uu);
  r = unit_clamp((s * uv - vw) / vv);
  for (int k = 0; k < 3; ++k) d[k] = w[k] + r * v[k] - s * u[k];
  const F8 safe = most(root(dot8(d, d)), all(1e-9F));
  // Along d: the farthest end of the first, the nearest end of the second.
  const F8 zero = all(0.0F);
  return (dot8(d, w) + least(dot8(d, v), zero) - most(dot8(d, u), zero)) / safe;
}
