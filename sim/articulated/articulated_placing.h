// Where all links of a body are, how fast and how heavy.  No include guard: articulated_kernels.h
// includes this once for each instruction set, in a namespace of its own.

// Where links are and how fast.
template <class L>
struct Frame {
  Columns3<L> rotation;
  Three<L> origin;
  Six<L> velocity;
};

template <class L>
TWINBUS_INLINE L lanes_of(const std::vector<double>& numbers, std::size_t rank) {
  L value;
  std::memcpy(&value, numbers.data() + rank * BodyLanes<L>::kLanes, sizeof value);
  return value;
}

template <class L>
TWINBUS_INLINE const double* numbers_of(const BodyLanes<L>& d) {
  return reinterpret_cast<const double*>(d.links.data());
}

// Where the numbers of the parents of a rank begin that are member field of theirs.
template <class L>
TWINBUS_INLINE void parents_at(const Rank& rank, std::size_t field, int (&from)[kMostLanes]) {
  constexpr int kLanes = BodyLanes<L>::kLanes;
  constexpr int kSize = static_cast<int>(sizeof(LinkLanes<L>) / sizeof(double));
  for (int k = 0; k < kLanes; ++k) {
    const int parent = rank.parent[k];
    from[k] = parent / kLanes * kSize + static_cast<int>(field) * kLanes + parent % kLanes;
  }
}

template <class L>
TWINBUS_INLINE Six<L> velocity_of_parents(const BodyLanes<L>& d, const Rank& rank) {
  if (rank.parents >= 0) return d.links[static_cast<std::size_t>(rank.parents)].velocity;
  int from[kMostLanes];
  parents_at<L>(rank, TWINBUS_LANE_FIELD(velocity), from);
  return gathered<L>(numbers_of(d), from, Six<L>{});
}

template <class L>
TWINBUS_INLINE Frame<L> parents_of(const BodyLanes<L>& d, const Rank& rank) {
  if (rank.parents >= 0) {
    const LinkLanes<L>& on = d.links[static_cast<std::size_t>(rank.parents)];
    return {on.rotation, on.origin, on.velocity};
  }
  Frame<L> frame;
  int from[kMostLanes];
  parents_at<L>(rank, TWINBUS_LANE_FIELD(rotation), from);
  frame.rotation = gathered<L>(numbers_of(d), from, frame.rotation);
  parents_at<L>(rank, TWINBUS_LANE_FIELD(origin), from);
  frame.origin = gathered<L>(numbers_of(d), from, frame.origin);
  frame.velocity = velocity_of_parents(d, rank);
  return frame;
}

// Turn about an axis by the angle of that sine and cosine.
template <class L>
TWINBUS_INLINE Columns3<L> turn(const Three<L>& a, const L& s, const L& c) {
  const Three<L> k = a * (1.0 - c), sa = a * s;
  const L xy = k.x * a.y, xz = k.x * a.z, yz = k.y * a.z;
  return {{c + k.x * a.x, xy + sa.z, xz - sa.y},
          {xy - sa.z, c + k.y * a.y, yz + sa.x},
          {xz + sa.y, yz - sa.x, c + k.z * a.z}};
}

template <class L>
TWINBUS_INLINE void move_rank(BodyLanes<L>& d, std::size_t r) {
  const Rank& rank = d.ranks[r];
  LinkLanes<L>& link = d.links[r];
  const Frame<L> on = parents_of(d, rank);
  L s = lanes_of<L>(d.sine, r), c = lanes_of<L>(d.cosine, r);
  if (rank.slides) {
    s = s - s * link.slides;
    c = c + link.slides * (1.0 - c);
  }
  Three<L> origin = on.origin + times(on.rotation, link.offset);
  Columns3<L> R = on.rotation;
  if (rank.turned) R = times(R, link.placed);
  R = times(R, turn(link.joint_axis, s, c));
  const Three<L> axis = times(R, link.joint_axis);
  if (rank.slides) {
    origin = origin + axis * (lanes_of<L>(d.angle, r) * link.slides);
    link.axis = {axis * (1.0 - link.slides),
                 cross(origin, axis) * (1.0 - link.slides) + axis * link.slides};
  } else {
    link.axis = {axis, cross(origin, axis)};
  }
  link.rotation = R;
  link.origin = origin;
  link.velocity = on.velocity + link.axis * lanes_of<L>(d.rate, r);
}

template <class L>
TWINBUS_INLINE void move_inertia(LinkLanes<L>& link) {
  const Columns3<L> R = link.rotation;
  const L m = link.mass;
  const Three<L> C = link.origin + times(R, link.com);
  link.center = C;
  // R I R': the columns of (R I) weighted by the rows of R.
  const Symmetric3<L>& I = link.inertia;
  const Columns3<L> half = {times(R, Three<L>{I.xx, I.xy, I.xz}),
                            times(R, Three<L>{I.xy, I.yy, I.yz}),
                            times(R, Three<L>{I.xz, I.yz, I.zz})};
  const L x = m * C.x, y = m * C.y, z = m * C.z;
  link.turning = {half.x.x * R.x.x + half.y.x * R.y.x + half.z.x * R.z.x + y * C.y + z * C.z,
                  half.x.x * R.x.y + half.y.x * R.y.y + half.z.x * R.z.y - x * C.y,
                  half.x.x * R.x.z + half.y.x * R.y.z + half.z.x * R.z.z - x * C.z,
                  half.x.y * R.x.y + half.y.y * R.y.y + half.z.y * R.z.y + x * C.x + z * C.z,
                  half.x.y * R.x.z + half.y.y * R.y.z + half.z.y * R.z.z - y * C.z,
                  half.x.z * R.x.z + half.y.z * R.y.z + half.z.z * R.z.z + x * C.x + y * C.y};
}

// inertia += that of what turns so about O, of that mass and mass times centre.
template <class L>
TWINBUS_INLINE void add_rigid(const Symmetric3<L>& turning, const Three<L>& mc, const L& mass,
                              Inertia<L>& inertia) {
  add(turning, inertia.ww);
  Columns3<L>& wv = inertia.wv;
  wv.x.y += mc.z;
  wv.x.z -= mc.y;
  wv.y.x -= mc.z;
  wv.y.z += mc.x;
  wv.z.x += mc.y;
  wv.z.y -= mc.x;
  inertia.vv.xx += mass;
  inertia.vv.yy += mass;
  inertia.vv.zz += mass;
}

template <class L>
TWINBUS_INLINE Six<L> momentum_of(const LinkLanes<L>& link) {
  const Three<L> mc = link.center * link.mass, w = link.velocity.w, v = link.velocity.v;
  return {times(link.turning, w) + cross(mc, v), v * link.mass - cross(mc, w)};
}

// With (n, l) = rigid (w, v):
//     bias = ( w x n + v x l - C x m g ,  w x l - m g ),     c = V x S qd
// V of the link or of its parent: they differ by S qd.
template <class L>
TWINBUS_INLINE void weigh_rank(BodyLanes<L>& d, std::size_t r) {
  LinkLanes<L>& link = d.links[r];
  const Three<L> w = link.velocity.w, v = link.velocity.v;
  const Six<L> momentum = momentum_of(link);
  d.momentum = d.momentum + momentum;
  d.moment = d.moment + link.center * link.mass;
  const L weight = link.mass * kGravity;
  const Three<L> n = cross(w, momentum.w) + cross(v, momentum.v);
  const Three<L> l = cross(w, momentum.v);
  link.bias = {{n.x + link.center.y * weight, n.y - link.center.x * weight, n.z},
               {l.x, l.y, l.z + weight}};
  if (r == 0) return;
  const Six<L> rate = link.axis * lanes_of<L>(d.rate, r);
  link.coriolis = {cross(w, rate.w), cross(w, rate.v) + cross(v, rate.w)};
}

template <class L>
inline void begin_at(BodyLanes<L>& d, const BodyState& state, const Configuration& to) noexcept {
  LinkLanes<L>& root = d.links[0];
  const auto spread = [](const auto& v) { return broadcast<L>(v[0], v[1], v[2]); };
  const Eigen::Matrix3d& R = to.base.linear();
  root.rotation = {spread(R.col(0)), spread(R.col(1)), spread(R.col(2))};
  root.origin = Three<L>{};
  root.velocity = Six<L>{};
  if (state.floating) root.velocity = {spread(to.base_angular_velocity), spread(to.base_velocity)};
  root.axis = root.coriolis = Six<L>{};
  for (std::size_t j = 0; j < d.of_joint.size(); ++j) {
    d.angle[d.of_joint[j]] = to.q[static_cast<Eigen::Index>(j)];
    d.rate[d.of_joint[j]] = to.qd[static_cast<Eigen::Index>(j)];
  }
  for (Rank& rank : d.ranks) rank.touched = false;
  if (d.ranks.size() > 1) find_sines(d.angle, d.sine, d.cosine);
}

// Link 0 is placed, sines are known.
template <class L>
inline void place_links(BodyLanes<L>& d) noexcept {
  d.momentum = Six<L>{};
  d.moment = Three<L>{};
  for (std::size_t r = 0; r < d.ranks.size(); ++r) {
    if (r > 0) move_rank(d, r);
    move_inertia(d.links[r]);
    weigh_rank(d, r);
  }
}

// What pushes and contacts have folded into placed links is taken out of them again.
template <class L>
inline void weigh_links(BodyLanes<L>& d) noexcept {
  d.momentum = Six<L>{};
  d.moment = Three<L>{};
  for (std::size_t r = 0; r < d.ranks.size(); ++r) {
    d.ranks[r].touched = false;
    weigh_rank(d, r);
  }
}

template <class L>
inline void place(BodyLanes<L>& d, BodyState& state, const Configuration& to) noexcept {
  state.origin = to.base.translation();
  begin_at(d, state, to);
  place_links(d);
}
