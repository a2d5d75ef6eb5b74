// Four searches at once, one a lane: the geometry.  Included by gjk_many.cpp once per instruction set, inside a
// namespace and after TWINBUS_WIDE says whether there are instructions for four lanes.

typedef Vec4 Vec4x3[3];  // x, y, z

TWINBUS_INLINE Vec4 all4(double x) noexcept { return Vec4{x, x, x, x}; }
TWINBUS_INLINE Vec4 root4(const Vec4& a) noexcept {
#if TWINBUS_WIDE
  return __builtin_ia32_sqrtpd256(a);
#else
  return Vec4{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
#endif
}
// The signs, as bits.
TWINBUS_INLINE unsigned bits4(const Vec4& a) noexcept {
#if TWINBUS_WIDE
  return static_cast<unsigned>(__builtin_ia32_movmskpd256(a));
#else
  return signs_of(a);
#endif
}
TWINBUS_INLINE unsigned lanes_of(const Int4& mask) noexcept { return bits4(reinterpret_cast<Vec4>(mask)); }
TWINBUS_INLINE Vec4 dot(const Vec4x3& a, const Vec4x3& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
TWINBUS_INLINE void cross(const Vec4x3& a, const Vec4x3& b, Vec4x3& c) noexcept {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

// Four vectors as their coordinates, and back.
TWINBUS_INLINE void transpose(const Vec4 (&v)[4], Vec4 (&lanes)[4]) noexcept {
  const Vec4 a = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6), b = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7),
             c = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6), d = __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
  lanes[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
  lanes[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  lanes[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
  lanes[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

// What is nearest to zero: v = w + sum of part[k] (corner[k] - w), parts above zero for those that are needed.
struct NearestOfFour {
  Vec4x3 part, v;
  Int4 inside;  // zero is inside
};

TWINBUS_INLINE void nearest_of_four(const Vec4x3& w, const double (&corner)[3][3][4], NearestOfFour& result) noexcept {
  const Vec4 none{};
  Vec4x3 e[3], q[3], normal = {};
  Vec4(&part)[3] = result.part;
  // Squares of distances, and parts, are fractions: one division at the end.
  Vec4 best = dot(w, w), per = all4(1.0), height_best = none;
  const auto take = [&](const Int4& valid, const Vec4& square, const Vec4& of)
      __attribute__((always_inline)) {
    const Int4 nearer = valid & (square * per < best * of);
    best = nearer ? square : best;
    per = nearer ? of : per;
    return nearer;
  };
  for (int i = 0; i < 3; ++i) {
    for (int d = 0; d < 3; ++d) e[i][d] = load4(corner[i][d]) - w[d];
    cross(e[i], w, q[i]);
    const Vec4 along = -dot(w, e[i]), length2 = dot(e[i], e[i]);
    const Int4 nearer = take((along > none) & (along < length2), dot(q[i], q[i]), length2);
    for (int k = 0; k < i; ++k) part[k] = nearer ? none : part[k];
    part[i] = nearer ? along : none;
  }
  Vec4 sum = none, volume = none;
  Int4 of_face{}, same = Int4{} - 1;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Vec4x3 n;
    cross(e[i], e[j], n);
    const Vec4 of_i = dot(n, q[j]), of_j = -dot(n, q[i]), area2 = dot(n, n), height = dot(w, n);
    if (i == 0) volume = -dot(e[k], n);
    sum += height;
    same &= height * volume > none;
    const Int4 nearer =
        take((of_i > none) & (of_j > none) & (of_i + of_j < area2), height * height, area2);
    of_face |= nearer;
    part[i] = nearer ? of_i : part[i];
    part[j] = nearer ? of_j : part[j];
    part[k] = nearer ? none : part[k];
    height_best = nearer ? height : height_best;
    for (int d = 0; d < 3; ++d) normal[d] = nearer ? n[d] : normal[d];
  }
  result.inside = same & (sum * volume <= volume * volume);
  const Vec4 share = 1.0 / per;
  for (int i = 0; i < 3; ++i) part[i] *= share;
  height_best *= share;
  for (int d = 0; d < 3; ++d) {
    // Of a face along its normal, which rounding harms less than the sum of the corners.
    const Vec4 v = w[d] + part[0] * e[0][d] + part[1] * e[1][d] + part[2] * e[2][d];
    result.v[d] = of_face ? height_best * normal[d] : v;
  }
}
