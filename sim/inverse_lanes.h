// Inverse dynamics of copies of a robot, each in a lane of its own: what its joints would have to
// give for accelerations that are only a guess, and from that a better guess.  No include guard:
// articulated_kernels.h includes this once for each instruction set, in a namespace of its own.
//
// By the recursive Newton-Euler algorithm in the links' own axes (Featherstone 2008, section 5.3),
// where rigid inertias are constant.  With r what is missing,
//
//     a  <-  a + M^-1 r
//
// M^-1 as fold_inward() has left it, perhaps of a posture nearby: then r falls all the same, by the
// share by which M has changed.

// Turn of a link about axis A of its own, its axes parallel to its parent's at angle 0.
template <int A, class L>
struct StraightHinge {
  L s, c;

  TWINBUS_INLINE static const L& along(const Three<L>& v) {
    return A == 0 ? v.x : A == 1 ? v.y : v.z;
  }
  TWINBUS_INLINE static void add(const L& x, Three<L>& to) {
    (A == 0 ? to.x : A == 1 ? to.y : to.z) += x;
  }
  // v x axis, times x.
  TWINBUS_INLINE static void add_across(const Three<L>& v, const L& x, Three<L>& to) {
    if constexpr (A == 0) {
      to.y += v.z * x, to.z -= v.y * x;
    } else if constexpr (A == 1) {
      to.z += v.x * x, to.x -= v.z * x;
    } else {
      to.x += v.y * x, to.y -= v.x * x;
    }
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
  TWINBUS_INLINE Three<L> out(const Three<L>& v) const { return StraightHinge{-s, c}.into(v); }
};

// About any axis, after any turn.
template <class L>
struct AnyHinge {
  Columns3<L> axes;  // of the link, in its parent's
  Three<L> axis;     // in its own

  TWINBUS_INLINE L along(const Three<L>& v) const { return dot(axis, v); }
  TWINBUS_INLINE void add(const L& x, Three<L>& to) const { to = to + axis * x; }
  TWINBUS_INLINE void add_across(const Three<L>& v, const L& x, Three<L>& to) const {
    to = to + cross(v, axis) * x;
  }
  TWINBUS_INLINE Three<L> into(const Three<L>& v) const { return times_transposed(axes, v); }
  TWINBUS_INLINE Three<L> out(const Three<L>& v) const { return times(axes, v); }
};

template <class L>
TWINBUS_INLINE L lane_of(const double* numbers, std::size_t column) {
  L value;
  std::memcpy(&value, numbers + column * (sizeof(L) / sizeof(double)), sizeof value);
  return value;
}
template <class L>
TWINBUS_INLINE Three<L> three_of(const double* numbers, std::size_t column) {
  return {lane_of<L>(numbers, column), lane_of<L>(numbers, column + 1),
          lane_of<L>(numbers, column + 2)};
}
template <class L>
TWINBUS_INLINE void add_to(double* numbers, std::size_t column, const L& what) {
  const L sum = lane_of<L>(numbers, column) + what;
  std::memcpy(numbers + column * (sizeof(L) / sizeof(double)), &sum, sizeof sum);
}

// What the link's own mass needs, w, turning and felt being known:
//     force = m felt + K m c,     moment about its origin = I turning + w x I w + m c x felt
template <class L>
TWINBUS_INLINE void weigh_link(const RigidLink& rigid, LinkMotion<L>& link) {
  const Three<L>&w = link.w, &t = link.turning, &a = link.felt;
  const L xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const L xy = w.x * w.y, xz = w.x * w.z, yz = w.y * w.z;
  // K = turning^ + w^ w^: of a point r of the link, K r is its acceleration.
  link.around = {{-yy - zz, xy + t.z, xz - t.y},
                 {xy - t.z, -xx - zz, yz + t.x},
                 {xz + t.y, yz - t.x, -xx - yy}};
  const Three<L> swing = times(link.around, rigid.moment);
  link.force = {rigid.mass * a.x + swing.x, rigid.mass * a.y + swing.y, rigid.mass * a.z + swing.z};
  link.torque =
      times(rigid.inertia, t) + cross(w, times(rigid.inertia, w)) + cross(rigid.moment, a);
  const L none = {};
  link.bias.w = link.bias.v = {none, none, none};
}

template <class L, class Hinge>
TWINBUS_INLINE void move_link(const Hinge& hinge, const RigidLink& rigid, const LinkMotion<L>& on,
                              const L& rate, const L& guess, LinkMotion<L>& link) {
  link.w = hinge.into(on.w);
  link.turning = hinge.into(on.turning);
  hinge.add_across(link.w, rate, link.turning);
  hinge.add(rate, link.w);
  hinge.add(guess, link.turning);
  link.felt = hinge.into(on.felt + times(on.around, rigid.offset));
  weigh_link(rigid, link);
}

// What link and all behind it need is its parent's to give; of the joint's part, what is missing.
template <class L, class Hinge>
TWINBUS_INLINE void lean_link(const Hinge& hinge, const RigidLink& rigid,
                              const LinkLanes<L>& factored, const L& given, LinkMotion<L>& link,
                              LinkMotion<L>& on) {
  const Three<L> force = hinge.out(link.force), torque = hinge.out(link.torque);
  on.force = on.force + force;
  on.torque = on.torque + torque + cross(rigid.offset, force);
  link.missing = given - hinge.along(link.torque) - dot(factored.axis, link.bias);
  on.bias = on.bias + link.bias + factored.inertia_axis * (link.missing * factored.inverse_d);
}

template <class L, class Do>
TWINBUS_INLINE void with_hinge(const BodyLanes<L>& d, std::size_t r, const RigidLink& rigid,
                               Do&& act) {
  const L s = lanes_of<L>(d.sine, r), c = lanes_of<L>(d.cosine, r);
  if (rigid.axis == 0) return act(StraightHinge<0, L>{s, c});
  if (rigid.axis == 1) return act(StraightHinge<1, L>{s, c});
  if (rigid.axis == 2) return act(StraightHinge<2, L>{s, c});
  const LinkLanes<L>& link = d.links[r];
  act(AnyHinge<L>{times(link.placed, turn(link.joint_axis, s, c)), link.joint_axis});
}

// acceleration: of the root as felt, of its turning, of the joints; a guess, then a better one.
template <class L>
inline void improve(const BodyLanes<L>& d, const RootFactors<L>& root,
                    const std::vector<RigidLink>& rigid, std::vector<Aligned<LinkMotion<L>>>& links,
                    double* acceleration) noexcept {
  LinkMotion<L>& base = links[0].value;
  base.felt = three_of<L>(acceleration, 0);
  base.turning = three_of<L>(acceleration, 3);
  weigh_link(rigid[0], base);
  const std::size_t count = links.size();
  for (std::size_t r = 1; r < count; ++r) {
    const LinkMotion<L>& on = links[static_cast<std::size_t>(d.ranks[r].parents)].value;
    const L rate = lanes_of<L>(d.rate, r), guess = lane_of<L>(acceleration, 5 + r);
    with_hinge(
        d, r, rigid[r], [&](const auto& hinge) __attribute__((always_inline)) {
          move_link(hinge, rigid[r], on, rate, guess, links[r].value);
        });
  }
  for (std::size_t r = count - 1; r > 0; --r) {
    LinkMotion<L>& on = links[static_cast<std::size_t>(d.ranks[r].parents)].value;
    const L given = lanes_of<L>(d.force, r) - d.links[r].rotor * lane_of<L>(acceleration, 5 + r);
    with_hinge(
        d, r, rigid[r], [&](const auto& hinge) __attribute__((always_inline)) {
          lean_link(hinge, rigid[r], d.links[r], given, links[r].value, on);
        });
  }
  // From here on bias is the change of acceleration.
  if (root.floating) {
    const Six<L> all = {base.bias.w + base.torque, base.bias.v + base.force};
    L x[6] = {-all.w.x, -all.w.y, -all.w.z, -all.v.x, -all.v.y, -all.v.z};
    solve_root(root, x);
    base.bias = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
    for (std::size_t k = 0; k < 3; ++k) {
      add_to(acceleration, k, x[3 + k]);
      add_to(acceleration, 3 + k, x[k]);
    }
  } else {
    const L none = {};
    base.bias.w = base.bias.v = {none, none, none};
  }
  for (std::size_t r = 1; r < count; ++r) {
    const Six<L>& on = links[static_cast<std::size_t>(d.ranks[r].parents)].value.bias;
    LinkMotion<L>& link = links[r].value;
    const LinkLanes<L>& factored = d.links[r];
    const L more = factored.inverse_d * (link.missing - dot(factored.inertia_axis, on));
    link.bias = on + factored.axis * more;
    add_to(acceleration, 5 + r, more);
  }
}
