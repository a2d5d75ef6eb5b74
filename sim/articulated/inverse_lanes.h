// Forward dynamics of copies of a robot, each in a lane of its own, from a guess of how its joints
// accelerate: what they would have to give for that, and from that a better guess.  No include
// guard: articulated_kernels.h includes this once for each instruction set, in a namespace of its own.
//
// What the guess needs is found by the recursive Newton-Euler algorithm in the links' own axes
// (Featherstone 2008, section 5.3), where rigid inertias are constant and hinges turn about axes
// that do not move.  With r what is missing,
//
//     a  <-  a + M^-1 r
//
// M^-1 by the articulated inertias as factor() has left them (section 7.3), perhaps at a posture nearby: then r
// falls all the same, by the share by which M has changed.

template <class L>
TWINBUS_INLINE Three<L> three_of(const double* numbers, std::size_t column) {
  return {lane_of<L>(numbers, column), lane_of<L>(numbers, column + 1),
          lane_of<L>(numbers, column + 2)};
}
template <class L>
TWINBUS_INLINE void to_lane(const L& value, double* numbers, std::size_t column) {
  std::memcpy(numbers + column * (sizeof(L) / sizeof(double)), &value, sizeof value);
}

// turning^ + w^ w^
template <class L>
TWINBUS_INLINE Columns3<L> differing(const Three<L>& w, const Three<L>& t) {
  const L xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const L xy = w.x * w.y, xz = w.x * w.z, yz = w.y * w.z;
  return {{-yy - zz, xy + t.z, xz - t.y},
          {xy - t.z, -xx - zz, yz + t.x},
          {xz + t.y, yz - t.x, -xx - yy}};
}

// What the link's own mass needs, its motion being known.  K r is what a point r of the link feels
// beside its origin:
//
//     force = m felt + K m c,     torque = m c x felt + sum of m r x K r
template <class L>
TWINBUS_INLINE void weigh_link(const RigidLink& rigid, LinkMotion<L>& link) {
  const Three<L>& a = link.felt;
  const Columns3<L> K = differing(link.w, link.turning);
  const Three<L> swing = times(K, rigid.moment);
  link.needed.v = {rigid.mass * a.x + swing.x, rigid.mass * a.y + swing.y,
                   rigid.mass * a.z + swing.z};
  const Symmetric3<double>& J = rigid.spread;
  const Three<L> lever = cross(rigid.moment, a);
  link.needed.w = {lever.x + K.x.z * J.xy + K.y.z * J.yy + K.z.z * J.yz - K.x.y * J.xz -
                       K.y.y * J.yz - K.z.y * J.zz,
                   lever.y + K.x.x * J.xz + K.y.x * J.yz + K.z.x * J.zz - K.x.z * J.xx -
                       K.y.z * J.xy - K.z.z * J.xz,
                   lever.z + K.x.y * J.xx + K.y.y * J.xy + K.z.y * J.xz - K.x.x * J.xy -
                       K.y.x * J.yy - K.z.x * J.yz};
}

// The same of one that has handed on what is along its axis A; B and C follow it in turn.
template <int A, class L>
TWINBUS_INLINE void weigh_about(const RigidLink& rigid, LinkMotion<L>& link) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  const Three<L>& a = link.felt;
  const Columns3<L> K = differing(link.w, link.turning);
  const Three<L>&ka = part<A>(K), &kb = part<B>(K), &kc = part<C>(K);
  const double mb = part<B>(rigid.moment), mc = part<C>(rigid.moment);
  const Symmetric3<double>& J = rigid.spread;
  const double ab = entry<A, B>(J), ac = entry<A, C>(J), bb = entry<B, B>(J), bc = entry<B, C>(J),
               cc = entry<C, C>(J);
  Six<L>& needed = link.needed;
  part<A>(needed.v) = part<A>(kb) * mb + part<A>(kc) * mc;
  part<B>(needed.v) = part<B>(kb) * mb + part<B>(kc) * mc;
  part<C>(needed.v) = part<C>(kb) * mb + part<C>(kc) * mc;
  part<A>(needed.w) = mb * part<C>(a) - mc * part<B>(a) + part<C>(ka) * ab - part<B>(ka) * ac +
                      part<C>(kb) * bb - part<B>(kc) * cc + (part<C>(kc) - part<B>(kb)) * bc;
  part<B>(needed.w) = mc * part<A>(a) + part<A>(kb) * bc + part<A>(kc) * cc - part<C>(kb) * ab +
                      (part<A>(ka) - part<C>(kc)) * ac;
  part<C>(needed.w) = part<B>(kc) * ac - mb * part<A>(a) - part<A>(kb) * bb - part<A>(kc) * bc +
                      (part<B>(kb) - part<A>(ka)) * ab;
}

template <class L, class Hinge>
TWINBUS_INLINE void move_link(const Hinge& hinge, const RigidLink& rigid, const LinkMotion<L>& on,
                              const L& rate, const L& guess, LinkMotion<L>& link) {
  link.w = hinge.into(on.w);
  link.turning = hinge.into(on.turning);
  link.felt = hinge.into(hinge.origin.felt(on));
  hinge.move(rate, guess, link);
  if constexpr (Hinge::kAxis == 3) {
    weigh_link(rigid, link);
  } else {
    weigh_about<Hinge::kAxis>(rigid, link);
  }
}

// What link and all behind it need is its parent's to give; of the joint's part, what is missing.
template <class L, class Hinge>
TWINBUS_INLINE void lean_link(const Hinge& hinge, const L& given, LinkMotion<L>& link,
                              LinkMotion<L>& on) {
  const L missing = given - hinge.along(link.needed);
  link.missing = missing;
  const Six<L> needed = link.needed + link.inertia_axis * (missing * link.inverse_d);
  hinge.origin.give(Six<L>{hinge.out(needed.w), hinge.out(needed.v)}, on.needed);
}

template <class L, class Hinge>
TWINBUS_INLINE L yield_link(const Hinge& hinge, const LinkMotion<L>& on, LinkMotion<L>& link) {
  const Six<L>& a = on.change;
  Six<L> change = {hinge.into(a.w), hinge.into(hinge.origin.linear(a))};
  const L more = link.inverse_d * (link.missing - dot(link.inertia_axis, change));
  hinge.add(more, change);
  link.change = change;
  return more;
}

template <class L>
TWINBUS_INLINE L square(const Three<L>& v) {
  return dot(v, v);
}

// From accelerations to better ones: of the root as felt, of its turning, of the joints.  The sum of
// squares of how they change.
template <class L>
inline double improve(RigidBody<L>& d, const double* from, double* to) noexcept {
  LinkMotion<L>& base = d.links[0].value;
  base.felt = d.held;
  base.turning = Three<L>{};
  if (d.root.floating) base.felt = three_of<L>(from, 0), base.turning = three_of<L>(from, 3);
  weigh_link(d.rigid[0], base);
  const std::size_t count = d.links.size();
  for (std::size_t i = 1; i < count; ++i) {
    const L rate = lane_of<L>(d.rate.data(), i), guess = lane_of<L>(from, 5 + i);
    const RigidLink& rigid = d.rigid[i];
    with_hinge(
        d, i, [&](const auto& hinge) __attribute__((always_inline)) {
          move_link(hinge, rigid, d.links[rigid.parent].value, rate, guess, d.links[i].value);
        });
  }
  for (std::size_t i = count - 1; i > 0; --i) {
    const RigidLink& rigid = d.rigid[i];
    const L given = lane_of<L>(d.force.data(), i) - lane_of<L>(from, 5 + i) * rigid.rotor;
    with_hinge(
        d, i, [&](const auto& hinge) __attribute__((always_inline)) {
          lean_link(hinge, given, d.links[i].value, d.links[rigid.parent].value);
        });
  }
  L x[6] = {};
  if (d.root.floating) {
    const Six<L>& all = base.needed;
    x[0] = -all.w.x, x[1] = -all.w.y, x[2] = -all.w.z;
    x[3] = -all.v.x, x[4] = -all.v.y, x[5] = -all.v.z;
    solve_root(d.root, x);
  }
  base.change = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  const Three<L> felt = base.felt + base.change.v, turning = base.turning + base.change.w;
  to_lane(felt.x, to, 0), to_lane(felt.y, to, 1), to_lane(felt.z, to, 2);
  to_lane(turning.x, to, 3), to_lane(turning.y, to, 4), to_lane(turning.z, to, 5);
  L changed = square(base.change.v) + square(base.change.w);
  for (std::size_t i = 1; i < count; ++i) {
    with_hinge(
        d, i, [&](const auto& hinge) __attribute__((always_inline)) {
          LinkMotion<L>& link = d.links[i].value;
          const L more = yield_link(hinge, d.links[d.rigid[i].parent].value, link);
          to_lane(lane_of<L>(from, 5 + i) + more, to, 5 + i);
          changed += more * more;
        });
  }
  return sum_of_lanes(changed);
}
