// What a robot's links and all that hangs on them weigh, of copies of it, each in a lane of its own: the
// articulated inertias of sim/articulated/inverse_lanes.h (Featherstone 2008, section 7.3), in the links' own axes.  No
// include guard: articulated_kernels.h includes this once for each instruction set, in a namespace of
// its own.

// The same tensor in the parent's axes.
template <class L, class Hinge>
TWINBUS_INLINE Columns3<L> turned_out(const Hinge& hinge, const Columns3<L>& m) {
  const Three<L> x = hinge.out(m.x), y = hinge.out(m.y), z = hinge.out(m.z);
  const Three<L> a = hinge.out({x.x, y.x, z.x}), b = hinge.out({x.y, y.y, z.y}),
                 c = hinge.out({x.z, y.z, z.z});
  return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}};
}
template <class L, class Hinge>
TWINBUS_INLINE Symmetric3<L> turned_out(const Hinge& hinge, const Symmetric3<L>& m) {
  const Columns3<L> t =
      turned_out(hinge, Columns3<L>{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}});
  return {t.x.x, t.y.x, t.z.x, t.y.y, t.z.y, t.z.z};
}

// About the parent's origin instead of the link's.  With p the offset and B = wv + p^ vv:
//     [ ww + p^ B' + (p^ wv')'   B ; B'  vv ]
template <class L>
TWINBUS_INLINE void shift(const Together&, Inertia<L>&) {}
template <class L, class N>
TWINBUS_INLINE void shift(const Apart<N>& origin, Inertia<L>& to) {
  const N& p = origin.offset;
  const Symmetric3<L>& vv = to.vv;
  const Columns3<L> wv = to.wv;
  to.wv = {wv.x + cross(p, Three<L>{vv.xx, vv.xy, vv.xz}),
           wv.y + cross(p, Three<L>{vv.xy, vv.yy, vv.yz}),
           wv.z + cross(p, Three<L>{vv.xz, vv.yz, vv.zz})};
  const Columns3<L>& B = to.wv;
  const Three<L> sx = {wv.x.x, wv.y.x, wv.z.x}, sy = {wv.x.y, wv.y.y, wv.z.y},
                 sz = {wv.x.z, wv.y.z, wv.z.z};
  const Three<L> rx = {B.x.x, B.y.x, B.z.x}, ry = {B.x.y, B.y.y, B.z.y}, rz = {B.x.z, B.y.z, B.z.z};
  const Three<L> gx = cross(p, rx + sx), gy = cross(p, ry + sy), gz = cross(p, rz + sz);
  const Three<L> y = cross(p, ry), z = cross(p, rz);
  const Three<L> hx = cross(p, sx), hy = cross(p, sy);
  to.ww.xx += gx.x;
  to.ww.yy += gy.y;
  to.ww.zz += gz.z;
  to.ww.xy += y.x + hx.y;
  to.ww.xz += z.x + hx.z;
  to.ww.yz += z.y + hy.z;
}

// In the parent's axes, about its origin.
template <class L, class Hinge>
TWINBUS_INLINE Inertia<L> carried_out(const Hinge& hinge, const Inertia<L>& m) {
  Inertia<L> to = {turned_out(hinge, m.ww), turned_out(hinge, m.wv), turned_out(hinge, m.vv)};
  shift(hinge.origin, to);
  return to;
}

template <class L>
TWINBUS_INLINE Inertia<L> weight_of(const RigidBody<L>& d, std::size_t i) {
  const RigidLink& rigid = d.rigid[i];
  const auto of = [](double x) { return broadcast<L>(x); };
  const Symmetric3<double>& I = rigid.inertia;
  const L x = of(rigid.moment.x), y = of(rigid.moment.y), z = of(rigid.moment.z), none = {};
  const L mass = of(rigid.mass);
  Inertia<L> own = {{of(I.xx), of(I.xy), of(I.xz), of(I.yy), of(I.yz), of(I.zz)},
                    {{none, z, -y}, {-z, none, x}, {y, -x, none}},
                    {mass, none, none, mass, none, mass}};
  if (!rigid.leaf) add(d.folded[i].value, own);
  return own;
}

// M^-1 at the posture whose sines are known; false: an inertia that is not positive.
template <class L>
inline bool factor(RigidBody<L>& d) noexcept {
  const L none = {}, one = broadcast<L>(1.0);
  L wrong = {};
  for (std::size_t i = d.links.size() - 1; i > 0; --i) {
    const RigidLink& rigid = d.rigid[i];
    LinkMotion<L>& link = d.links[i].value;
    Inertia<L> own = weight_of(d, i);
    with_hinge(
        d, i, [&](const auto& hinge) __attribute__((always_inline)) {
          const Six<L> U = hinge.times_axis(own);
          const L D = hinge.along(U) + rigid.rotor;
          wrong += D > 0.0 ? none : one;
          link.inertia_axis = U;
          link.inverse_d = one / D;
          subtract(own, U * link.inverse_d, U);
          const Inertia<L> more = carried_out(hinge, own);
          Inertia<L>& on = d.folded[rigid.parent].value;
          if (rigid.first) {
            on = more;
          } else {
            add(more, on);
          }
        });
  }
  return (!d.root.floating || factor_root(d.root, weight_of(d, 0))) && !(sum_of_lanes(wrong) > 0.0);
}
