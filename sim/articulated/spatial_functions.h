// Arithmetic of spatial vectors (sim/articulated/spatial.h).  No include guard: g++ splits vectors into the
// registers of the instruction set a function is declared for before it inlines it, so each set has
// these functions once, in a namespace of its own.

TWINBUS_INLINE Vec4 vec4(const Eigen::Vector3d& v) { return Vec4{v[0], v[1], v[2], 0.0}; }
TWINBUS_INLINE Eigen::Vector3d vec3(const Vec4& v) { return {v[0], v[1], v[2]}; }

// Matrix of three columns times a vector.
TWINBUS_INLINE Vec4 times(const Vec4 (&columns)[3], const Vec4& v) {
  return columns[0] * v[0] + columns[1] * v[1] + columns[2] * v[2];
}

TWINBUS_INLINE Vec4 cross(const Vec4& a, const Vec4& b) {
  return __builtin_shufflevector(a, a, 1, 2, 0, 3) * __builtin_shufflevector(b, b, 2, 0, 1, 3) -
         __builtin_shufflevector(a, a, 2, 0, 1, 3) * __builtin_shufflevector(b, b, 1, 2, 0, 3);
}

TWINBUS_INLINE Screw operator+(const Screw& a, const Screw& b) { return {a.w + b.w, a.v + b.v}; }
TWINBUS_INLINE Screw operator-(const Screw& a, const Screw& b) { return {a.w - b.w, a.v - b.v}; }
TWINBUS_INLINE Screw operator*(const Screw& a, double f) { return {a.w * f, a.v * f}; }
TWINBUS_INLINE void operator+=(Screw& a, const Screw& b) {
  a.w += b.w;
  a.v += b.v;
}
TWINBUS_INLINE void operator-=(Screw& a, const Screw& b) {
  a.w -= b.w;
  a.v -= b.v;
}

TWINBUS_INLINE double dot(const Screw& a, const Screw& b) {
  const Vec4 m = a.w * b.w + a.v * b.v;
  return (m[0] + m[1]) + m[2];
}

// Matrix of six columns times a vector.
TWINBUS_INLINE Screw times(const Screw (&columns)[6], const Screw& s) {
  return ((columns[0] * s.w[0] + columns[1] * s.w[1]) +
          (columns[2] * s.w[2] + columns[3] * s.v[0])) +
         (columns[4] * s.v[1] + columns[5] * s.v[2]);
}

// Force f at the point r: J(r)' f.
TWINBUS_INLINE Screw force_at(const Vec4& r, const Vec4& f) { return {cross(r, f), f}; }
