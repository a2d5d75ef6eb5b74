// Momentum of a body, and its motion changed so that it has a wanted one.  No include guard:
// articulated_kernels.h includes this once for each instruction set, in a namespace of its own.

template <class L>
inline Momentum momentum_in(const BodyState& state, const Six<L>& sum, const Three<L>& moment) {
  const auto total = [](const Three<L>& v) {
    return Eigen::Vector3d(sum_of_lanes(v.x), sum_of_lanes(v.y), sum_of_lanes(v.z));
  };
  const Eigen::Vector3d com = total(moment) / state.mass;
  const Eigen::Vector3d linear = total(sum.v);
  return {state.origin + com, linear, total(sum.w) - com.cross(linear)};
}

// Kinetic: half of each link's velocity times its momentum; the velocities of centres of mass by the way, as ArticulatedBody says.
template <class L>
inline BodyEnergy energy_in(const BodyLanes<L>& d, const BodyState& state, Eigen::Vector3d* world,
                            Eigen::Vector3d* own) noexcept {
  constexpr std::size_t kLanes = sizeof(L) / sizeof(double);
  const auto spread = [](const Rank& rank, const Three<L>& v, Eigen::Vector3d* to) {
    double lanes[3 * kLanes];
    std::memcpy(lanes, &v, sizeof lanes);
    for (std::size_t k = 0; k < kLanes; ++k) {
      if (rank.link[k] < 0) continue;
      double* at = to[rank.link[k]].data();
      at[0] = lanes[k], at[1] = lanes[kLanes + k], at[2] = lanes[2 * kLanes + k];
    }
  };
  L twice = {};
  for (std::size_t r = 0; r < d.ranks.size(); ++r) {
    const LinkLanes<L>& link = d.links[r];
    twice = twice + dot(link.velocity, momentum_of(link));
    const Three<L> v = link.velocity.v + cross(link.velocity.w, link.center);
    spread(d.ranks[r], v, world);
    if (own != nullptr) spread(d.ranks[r], times_transposed(link.rotation, v), own);
  }
  return {0.5 * sum_of_lanes(twice), kGravity * (state.mass * state.origin.z() + sum_of_lanes(d.moment.z))};
}

// The change is a rigid motion of all links: state.root is free for its inertia until inward().
template <class L>
inline void correct(BodyLanes<L>& d, BodyState& state, const Momentum& wanted,
                    Configuration& to) noexcept {
  state.origin = to.base.translation();
  begin_at(d, state, to);
  Six<L> sum = {};
  Three<L> moment = {};
  Symmetric3<L> turning = {};
  for (std::size_t r = 0; r < d.ranks.size(); ++r) {
    if (r > 0) move_rank(d, r);
    LinkLanes<L>& link = d.links[r];
    move_inertia(link);
    sum = sum + momentum_of(link);
    moment = moment + link.center * link.mass;
    turning = turning + link.turning;
  }
  Inertia<L> all = {};                                      // of all links as if welded, about O
  const L once = broadcast<L>(1.0 / BodyLanes<L>::kLanes);  // in each lane
  add_rigid(turning, moment, once * state.mass, all);
  const Momentum now = momentum_in(state, sum, moment);
  const Eigen::Vector3d com = now.com - state.origin;
  const Eigen::Vector3d missing = wanted.linear - now.linear;
  const Eigen::Vector3d turn = wanted.angular - now.angular + com.cross(missing);
  double x[6] = {turn[0], turn[1], turn[2], missing[0], missing[1], missing[2]};
  if (factor_root(state, all)) {
    solve_root(state, x);
    to.base_angular_velocity += Eigen::Vector3d(x[0], x[1], x[2]);
    to.base_velocity += Eigen::Vector3d(x[3], x[4], x[5]);
    to.base.translation() += wanted.com - now.com;
    state.origin = to.base.translation();
    // To the bit what place() makes of it.
    const auto spread = [](const auto& v) { return broadcast<L>(v[0], v[1], v[2]); };
    d.links[0].velocity = {spread(to.base_angular_velocity), spread(to.base_velocity)};
  }
  d.momentum = Six<L>{};
  d.moment = Three<L>{};
  for (std::size_t r = 0; r < d.ranks.size(); ++r) {
    LinkLanes<L>& link = d.links[r];
    if (r > 0)
      link.velocity = velocity_of_parents(d, d.ranks[r]) + link.axis * lanes_of<L>(d.rate, r);
    weigh_rank(d, r);
  }
}
