// Arithmetic of vectors, screws and inertias of which each number is one lane wide or four
// (sim/articulated/articulated_lanes.h).  No include guard: g++ splits vectors into the registers of the
// instruction set a function is declared for before it inlines it, so each set has these functions
// once, in a namespace of its own.

template <class L>
TWINBUS_INLINE L broadcast(double x) {
  return L{} + x;
}

template <class L>
TWINBUS_INLINE double sum_of_lanes(const L& x) {
  if constexpr (sizeof(L) == sizeof(double)) {
    return x;
  } else {
    return (x[0] + x[1]) + (x[2] + x[3]);
  }
}

template <class L>
TWINBUS_INLINE Three<L> broadcast(double x, double y, double z) {
  return {broadcast<L>(x), broadcast<L>(y), broadcast<L>(z)};
}

template <class L>
TWINBUS_INLINE Three<L> operator+(const Three<L>& a, const Three<L>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class L>
TWINBUS_INLINE Three<L> operator-(const Three<L>& a, const Three<L>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class L>
TWINBUS_INLINE Three<L> operator*(const Three<L>& a, const L& f) {
  return {a.x * f, a.y * f, a.z * f};
}
template <class L>
TWINBUS_INLINE L dot(const Three<L>& a, const Three<L>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
// A, M and V: of lanes too, or of numbers that are the same in all of them.
template <class A, class L>
TWINBUS_INLINE Three<L> cross(const Three<A>& a, const Three<L>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class L>
TWINBUS_INLINE Six<L> operator+(const Six<L>& a, const Six<L>& b) {
  return {a.w + b.w, a.v + b.v};
}
template <class L>
TWINBUS_INLINE Six<L> operator*(const Six<L>& a, const L& f) {
  return {a.w * f, a.v * f};
}
template <class L>
TWINBUS_INLINE L dot(const Six<L>& a, const Six<L>& b) {
  return dot(a.w, b.w) + dot(a.v, b.v);
}

template <class L, class V>
TWINBUS_INLINE Three<L> times(const Columns3<L>& m, const Three<V>& v) {
  return {m.x.x * v.x + m.y.x * v.y + m.z.x * v.z, m.x.y * v.x + m.y.y * v.y + m.z.y * v.z,
          m.x.z * v.x + m.y.z * v.y + m.z.z * v.z};
}
template <class L>
TWINBUS_INLINE Columns3<L> times(const Columns3<L>& m, const Columns3<L>& n) {
  return {times(m, n.x), times(m, n.y), times(m, n.z)};
}
template <class L>
TWINBUS_INLINE Three<L> times_transposed(const Columns3<L>& m, const Three<L>& v) {
  return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
template <class M, class L>
TWINBUS_INLINE Three<L> times(const Symmetric3<M>& m, const Three<L>& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
template <class L>
TWINBUS_INLINE Six<L> times(const Inertia<L>& m, const Six<L>& s) {
  return {times(m.ww, s.w) + times(m.wv, s.v), times_transposed(m.wv, s.w) + times(m.vv, s.v)};
}

template <class L>
TWINBUS_INLINE Symmetric3<L> operator+(const Symmetric3<L>& a, const Symmetric3<L>& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}
// to += what.
template <class L>
TWINBUS_INLINE void add(const Three<L>& what, Three<L>& to) {
  to.x += what.x;
  to.y += what.y;
  to.z += what.z;
}
template <class L>
TWINBUS_INLINE void add(const Six<L>& what, Six<L>& to) {
  add(what.w, to.w);
  add(what.v, to.v);
}
template <class L>
TWINBUS_INLINE void add(const Symmetric3<L>& what, Symmetric3<L>& to) {
  to = to + what;
}
template <class L>
TWINBUS_INLINE void add(const Inertia<L>& what, Inertia<L>& to) {
  add(what.ww, to.ww);
  add(what.wv.x, to.wv.x);
  add(what.wv.y, to.wv.y);
  add(what.wv.z, to.wv.z);
  add(what.vv, to.vv);
}
template <class L>
TWINBUS_INLINE void add(const Folded<L>& what, Folded<L>& to) {
  add(what.inertia, to.inertia);
  add(what.bias, to.bias);
}

// m -= f a', of which the result is known to be symmetric.
template <class L>
TWINBUS_INLINE void subtract(Symmetric3<L>& m, const Three<L>& f, const Three<L>& a) {
  m.xx -= f.x * a.x;
  m.xy -= f.x * a.y;
  m.xz -= f.x * a.z;
  m.yy -= f.y * a.y;
  m.yz -= f.y * a.z;
  m.zz -= f.z * a.z;
}
template <class L>
TWINBUS_INLINE void subtract(Three<L>& m, const Three<L>& f, const L& a) {
  m.x -= f.x * a;
  m.y -= f.y * a;
  m.z -= f.z * a;
}
template <class L>
TWINBUS_INLINE void subtract(Inertia<L>& m, const Six<L>& f, const Six<L>& a) {
  subtract(m.ww, f.w, a.w);
  subtract(m.wv.x, f.w, a.v.x);
  subtract(m.wv.y, f.w, a.v.y);
  subtract(m.wv.z, f.w, a.v.z);
  subtract(m.vv, f.v, a.v);
}

// T, numbers of links, of which those in lane k begin at numbers[from[k]].
template <class L, class T>
TWINBUS_INLINE T gathered(const double* numbers, const int (&from)[kMostLanes], T value) {
  constexpr std::size_t kLanes = sizeof(L) / sizeof(double);
  double lanes[sizeof(T) / sizeof(double)];
  for (std::size_t k = 0; k < sizeof(T) / sizeof(L); ++k) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      lanes[k * kLanes + lane] = numbers[static_cast<std::size_t>(from[lane]) + k * kLanes];
    }
  }
  std::memcpy(static_cast<void*>(&value), lanes, sizeof value);
  return value;
}
