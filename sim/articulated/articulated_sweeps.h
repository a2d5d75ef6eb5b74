// The sweeps of the articulated-body algorithm over links that are placed.  No include guard:
// articulated_kernels.h includes this once for each instruction set, in a namespace of its own.

// Number by number: g++ makes a loop over bytes of = {}.
template <class L>
TWINBUS_INLINE void clear(Folded<L>& folded) {
  const L none = {};
  folded.inertia.ww = folded.inertia.vv = {none, none, none, none, none, none};
  folded.inertia.wv.x = folded.inertia.wv.y = folded.inertia.wv.z = {none, none, none};
  folded.bias.w = folded.bias.v = {none, none, none};
}

// What a rank adds to its parents, unless they take over its place.
template <class L>
TWINBUS_INLINE void fold_into_parents(BodyLanes<L>& d, const Rank& rank, const Folded<L>& folded) {
  constexpr int kLanes = BodyLanes<L>::kLanes;
  if (rank.parents >= 0) {
    if (rank.first[0]) return;
    const Rank& on = d.ranks[static_cast<std::size_t>(rank.parents)];
    add(folded, d.folded[static_cast<std::size_t>(on.folded)].value);
    return;
  }
  constexpr std::size_t kCount = sizeof folded / sizeof(L);
  const double* from = reinterpret_cast<const double*>(&folded);
  for (int lane = 0; lane < kLanes; ++lane) {
    if (rank.link[lane] < 0) continue;
    const auto parent = static_cast<std::size_t>(rank.parent[lane] / kLanes);
    Folded<L>& into = d.folded[static_cast<std::size_t>(d.ranks[parent].folded)].value;
    if (rank.first[lane]) clear(into);
    double* to = reinterpret_cast<double*>(&into) + rank.parent[lane] % kLanes;
    const double* own = from + lane;
    for (std::size_t k = 0; k < kCount; ++k) to[k * kLanes] += own[k * kLanes];
  }
}

// Articulated inertia and bias of a rank, of which all children are folded in: in its place.
template <class L>
TWINBUS_INLINE Folded<L>& articulated(BodyLanes<L>& d, std::size_t r) {
  const Rank& rank = d.ranks[r];
  const LinkLanes<L>& link = d.links[r];
  Folded<L>& own = d.folded[static_cast<std::size_t>(rank.folded)].value;
  const Three<L> mc = link.center * link.mass;
  if (rank.leaf) {
    const L none = {};
    own.inertia.ww = link.turning;
    own.inertia.wv = {{none, mc.z, -mc.y}, {-mc.z, none, mc.x}, {mc.y, -mc.x, none}};
    own.inertia.vv = {link.mass, none, none, link.mass, none, link.mass};
    own.bias = link.bias;
  } else {
    add_rigid(link.turning, mc, link.mass, own.inertia);
    add(link.bias, own.bias);
  }
  if (rank.touched) add(d.stiff[r].value, own.inertia);
  return own;
}

template <class L, class N>
inline bool fold_inward(BodyLanes<L>& d, RootFactors<N>& state, double h) noexcept {
  const L none = {}, one = broadcast<L>(1.0);
  L wrong = {};
  for (std::size_t r = d.ranks.size() - 1; r > 0; --r) {
    LinkLanes<L>& link = d.links[r];
    Folded<L>& own = articulated(d, r);
    const L gain = lanes_of<L>(d.gain, r);
    const Six<L> S = link.axis;
    const Six<L> U = times(own.inertia, S), Ic = times(own.inertia, link.coriolis);
    const L D = dot(S, U) + link.rotor + gain * h;
    wrong += D > 0.0 ? none : one;
    const L inverse_d = one / D;
    const L u = lanes_of<L>(d.force, r) - gain * lanes_of<L>(d.rate, r) - dot(S, own.bias);
    link.inverse_d = inverse_d;
    link.inertia_axis = U;
    link.u = u;
    const Six<L> Ud = U * inverse_d;
    subtract(own.inertia, Ud, U);
    // K c + U u / D with K = I - U U' / D: I c need not wait for the division.
    add(Ic + Ud * (u - dot(U, link.coriolis)), own.bias);
    fold_into_parents(d, d.ranks[r], own);
  }
  const Folded<L>& own = articulated(d, 0);
  const L* bias = reinterpret_cast<const L*>(&own.bias);
  for (int k = 0; k < 6; ++k) state.root_bias[k] = of_robots<N>(bias[k]);
  state.wrong = N{};
  const bool sound = !state.floating || factor_root(state, own.inertia);
  state.wrong += of_robots<N>(wrong);
  return sound && !(sum_of_lanes(wrong) > 0.0);
}

template <class L, class N>
inline void accelerate(BodyLanes<L>& d, const RootFactors<N>& state) noexcept {
  d.links[0].acceleration = Six<L>{};
  if (state.floating) {
    N x[6];
    for (int r = 0; r < 6; ++r) x[r] = -state.root_bias[r];
    solve_root(state, x);
    L in_lanes[6];
    for (int r = 0; r < 6; ++r) in_lanes[r] = L{} + x[r];
    d.links[0].acceleration = {{in_lanes[0], in_lanes[1], in_lanes[2]},
                               {in_lanes[3], in_lanes[4], in_lanes[5]}};
  }
  for (std::size_t r = 1; r < d.ranks.size(); ++r) {
    const Rank& rank = d.ranks[r];
    LinkLanes<L>& link = d.links[r];
    Six<L> base;
    if (rank.parents >= 0) {
      base = d.links[static_cast<std::size_t>(rank.parents)].acceleration;
    } else {
      int from[kMostLanes];
      parents_at<L>(rank, TWINBUS_LANE_FIELD(acceleration), from);
      base = gathered<L>(numbers_of(d), from, base);
    }
    base = base + link.coriolis;
    link.qdd = link.inverse_d * (link.u - dot(link.inertia_axis, base));
    link.acceleration = base + link.axis * link.qdd;
  }
}

inline void fold_wrench(LinkNumbers& d, BodyState& state, int link, const Screw& wrench) noexcept {
  Screw e = wrench;
  for (int i = link; i > 0; i = d.parent[static_cast<std::size_t>(i)]) {
    const double s = dot(d.screw(i, TWINBUS_LANE_FIELD(axis)), e);
    *d.of(i, TWINBUS_LANE_FIELD(u)) += s;
    e -= d.screw(i, TWINBUS_LANE_FIELD(inertia_axis)) *
         (s * *d.of(i, TWINBUS_LANE_FIELD(inverse_d)));
  }
  for (int k = 0; k < 6; ++k) state.root_bias[k] -= e[k];
}

inline int respond(const LinkNumbers& d, const BodyState& state, int index,
                   ResponseRow* rows) noexcept {
  Screw E[6];
  for (int r = 0; r < 6; ++r) {
    E[r] = Screw{};
    if (r < 3)
      E[r].w[r] = 1.0;
    else
      E[r].v[r - 3] = 1.0;
  }
  int count = 0;
  for (int i = index; i > 0; i = d.parent[static_cast<std::size_t>(i)]) {
    const Screw s = times(E, d.screw(i, TWINBUS_LANE_FIELD(axis)));
    const Screw U = d.screw(i, TWINBUS_LANE_FIELD(inertia_axis));
    const double inverse_d = *d.of(i, TWINBUS_LANE_FIELD(inverse_d));
    rows[count++] = {s * std::sqrt(inverse_d), i};
    for (int r = 0; r < 6; ++r) E[r] -= s * (U[r] * inverse_d);
  }
  if (!state.floating) return count;
  for (int r = 0; r < 6; ++r) {
    for (int k = 0; k < r; ++k) E[r] -= E[k] * state.root[r][k];
    rows[count++] = {E[r] * std::sqrt(state.root_inverse[r]), -r};
  }
  return count;
}
