// Joints between links that are each in axes of their own.  No include guard: articulated_kernels.h
// includes this once for each instruction set, in a namespace of its own.
//
// A hinge takes vectors of the parent's axes into the link's and out again, tells what the link's
// origin has of the parent's motion and gives it of the link's, and knows S, what the joint moves: a unit
// vector of rotation, or of translation.

template <class L>
TWINBUS_INLINE L lane_of(const double* numbers, std::size_t column) {
  L value;
  std::memcpy(&value, numbers + column * (sizeof(L) / sizeof(double)), sizeof value);
  return value;
}

// Member number A, from 0, of x, y, z.
template <int A, class T>
TWINBUS_INLINE auto& part(T& v) {
  if constexpr (A == 0) {
    return v.x;
  } else if constexpr (A == 1) {
    return v.y;
  } else {
    return v.z;
  }
}

template <int R, int C, class L>
TWINBUS_INLINE const L& entry(const Symmetric3<L>& m) {
  if constexpr (R > C) {
    return entry<C, R>(m);
  } else if constexpr (R == 0) {
    return C == 0 ? m.xx : C == 1 ? m.xy : m.xz;
  } else if constexpr (R == 1) {
    return C == 1 ? m.yy : m.yz;
  } else {
    return m.zz;
  }
}

// Where a link's origin is that is not its parent's.
template <class N>
struct Apart {
  N offset;  // in the parent's axes

  template <class L>
  TWINBUS_INLINE Three<L> felt(const LinkMotion<L>& on) const {
    return on.felt - cross(offset, on.turning) - cross(on.w, cross(offset, on.w));
  }
  template <class L>
  TWINBUS_INLINE Three<L> linear(const Six<L>& on) const {
    return on.v - cross(offset, on.w);
  }
  // The link's forces, in the parent's axes, to what its parent needs.
  template <class L>
  TWINBUS_INLINE void give(const Six<L>& forces, Six<L>& to) const {
    add(forces, to);
    to.w = to.w + cross(offset, forces.v);
  }
};

struct Together {
  template <class L>
  TWINBUS_INLINE const Three<L>& felt(const LinkMotion<L>& on) const {
    return on.felt;
  }
  template <class L>
  TWINBUS_INLINE const Three<L>& linear(const Six<L>& on) const {
    return on.v;
  }
  template <class L>
  TWINBUS_INLINE void give(const Six<L>& forces, Six<L>& to) const {
    add(forces, to);
  }
};

// Turn about axis A of its own, the axes parallel to the parent's at angle 0.
template <int A, class Place, class L>
struct StraightHinge {
  static constexpr int kAxis = A;
  L s, c;
  Place origin;

  template <class T>
  TWINBUS_INLINE static T& of(Three<T>& v) {
    return part<A>(v);
  }
  TWINBUS_INLINE Three<L> into(const Three<L>& v) const {
    if constexpr (A == 0) {
      return {v.x, c * v.y + s * v.z, c * v.z - s * v.y};
    } else if constexpr (A == 1) {
      return {c * v.x - s * v.z, v.y, c * v.z + s * v.x};
    } else {
      return {c * v.x + s * v.y, c * v.y - s * v.x, v.z};
    }
  }
  TWINBUS_INLINE Three<L> out(const Three<L>& v) const {
    return StraightHinge{-s, c, origin}.into(v);
  }
  // S'v
  TWINBUS_INLINE L along(Six<L> v) const { return of(v.w); }
  // v += S x
  TWINBUS_INLINE void add(const L& x, Six<L>& v) const { of(v.w) += x; }
  TWINBUS_INLINE Six<L> times_axis(Inertia<L>& m) const {
    const Three<L> row = {of(m.wv.x), of(m.wv.y), of(m.wv.z)};
    if constexpr (A == 0) {
      return {{m.ww.xx, m.ww.xy, m.ww.xz}, row};
    } else if constexpr (A == 1) {
      return {{m.ww.xy, m.ww.yy, m.ww.yz}, row};
    } else {
      return {{m.ww.xz, m.ww.yz, m.ww.zz}, row};
    }
  }
  // The motion of a link that stood still in its parent gains the joint's rate and its change.
  TWINBUS_INLINE void move(const L& rate, const L& change, LinkMotion<L>& link) const {
    const Three<L>& w = link.w;
    Three<L>& t = link.turning;
    if constexpr (A == 0) {
      t.y += w.z * rate, t.z -= w.y * rate;
    } else if constexpr (A == 1) {
      t.z += w.x * rate, t.x -= w.z * rate;
    } else {
      t.x += w.y * rate, t.y -= w.x * rate;
    }
    of(link.w) += rate;
    of(link.turning) += change;
  }
};

// About or along any axis, after any turn.
template <class L>
struct AnyHinge {
  static constexpr int kAxis = 3;
  Columns3<L> axes;  // of the link, in its parent's
  Apart<Three<L>> origin;
  Six<L> axis;

  TWINBUS_INLINE Three<L> into(const Three<L>& v) const { return times_transposed(axes, v); }
  TWINBUS_INLINE Three<L> out(const Three<L>& v) const { return times(axes, v); }
  TWINBUS_INLINE L along(const Six<L>& v) const { return dot(axis, v); }
  TWINBUS_INLINE void add(const L& x, Six<L>& v) const { v = v + axis * x; }
  TWINBUS_INLINE Six<L> times_axis(const Inertia<L>& m) const { return times(m, axis); }
  TWINBUS_INLINE void move(const L& rate, const L& change, LinkMotion<L>& link) const {
    const Three<L> rates = axis.w * rate, speeds = axis.v * rate;
    link.felt = link.felt + cross(link.w, speeds) * broadcast<L>(2.0) + axis.v * change;
    link.turning = link.turning + cross(link.w, rates) + axis.w * change;
    link.w = link.w + rates;
  }
};

template <class L>
TWINBUS_INLINE AnyHinge<L> any_hinge(const RigidLink& rigid, const L& angle, const L& s,
                                     const L& c) {
  const L none = {}, one = broadcast<L>(1.0);
  const auto spread = [](const Three<double>& v) { return broadcast<L>(v.x, v.y, v.z); };
  const Three<L> a = spread(rigid.direction), o = spread(rigid.offset), still = {none, none, none};
  const Columns3<L> placed = {spread(rigid.placed.x), spread(rigid.placed.y),
                              spread(rigid.placed.z)};
  if (rigid.slides) return {placed, {o + times(placed, a) * angle}, {still, a}};
  const Three<L> k = a * (one - c), sa = a * s;
  const Columns3<L> turned = {{c + k.x * a.x, k.x * a.y + sa.z, k.x * a.z - sa.y},
                              {k.x * a.y - sa.z, c + k.y * a.y, k.y * a.z + sa.x},
                              {k.x * a.z + sa.y, k.y * a.z - sa.x, c + k.z * a.z}};
  return {times(placed, turned), {o}, {a, still}};
}

template <class L, class Do>
TWINBUS_INLINE void with_hinge(const RigidBody<L>& d, std::size_t i, Do&& act) {
  const RigidLink& rigid = d.rigid[i];
  const L s = lane_of<L>(d.sine.data(), i), c = lane_of<L>(d.cosine.data(), i);
  if (rigid.axis == 3) return act(any_hinge(rigid, lane_of<L>(d.angle.data(), i), s, c));
  if (rigid.apart) {
    const Apart<Three<double>> apart = {rigid.offset};
    if (rigid.axis == 0) return act(StraightHinge<0, Apart<Three<double>>, L>{s, c, apart});
    if (rigid.axis == 1) return act(StraightHinge<1, Apart<Three<double>>, L>{s, c, apart});
    return act(StraightHinge<2, Apart<Three<double>>, L>{s, c, apart});
  }
  if (rigid.axis == 0) return act(StraightHinge<0, Together, L>{s, c, {}});
  if (rigid.axis == 1) return act(StraightHinge<1, Together, L>{s, c, {}});
  act(StraightHinge<2, Together, L>{s, c, {}});
}

// Sines and cosines of angles near those of which they are known; false: some are not near.
template <class L>
inline bool find_near_sines(RigidBody<L>& d) noexcept {
  constexpr std::size_t kLanes = sizeof(L) / sizeof(double);
  const L limit = broadcast<L>(1.0 / 256.0), none = {}, one = broadcast<L>(1.0);  // of squares
  L far = {};
  for (std::size_t k = 0; k < d.angle.size(); k += kLanes) {
    const auto of = [k](const std::vector<double>& numbers) {
      L value;
      std::memcpy(&value, numbers.data() + k, sizeof value);
      return value;
    };
    const L x = of(d.angle) - of(d.known_angle), xx = x * x;
    far += xx <= limit ? none : one;
    // Taylor: 1e-17 at 1 / 16.
    const L sine = x - x * xx * (1.0 / 6 - xx * (1.0 / 120 - xx * (1.0 / 5040)));
    const L less = xx * (0.5 - xx * (1.0 / 24 - xx * (1.0 / 720 - xx * (1.0 / 40320))));
    const L s = of(d.known_sine), c = of(d.known_cosine);
    const L to_sine = s + (c * sine - s * less), to_cosine = c - (s * sine + c * less);
    std::memcpy(d.sine.data() + k, &to_sine, sizeof to_sine);
    std::memcpy(d.cosine.data() + k, &to_cosine, sizeof to_cosine);
  }
  return !(sum_of_lanes(far) > 0.0);
}
