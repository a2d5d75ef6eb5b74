// The sweeps of the articulated-body algorithm over a BodyData that is placed.  No include guard:
// articulated_body.cpp includes this once for each instruction set, in a namespace of its own.

// rigid += J(r)' weight J(r); column k is J' weight (J e_k).
inline void fold_compliance(BodyData& d, int link, const Eigen::Vector3d& at,
                            const Eigen::Matrix3d& weight) noexcept {
  Screw(&rigid)[6] = d.links[static_cast<std::size_t>(link)].rigid;
  const Vec4 r = vec4(at);
  const Vec4 x = vec4(weight.col(0)), y = vec4(weight.col(1)), z = vec4(weight.col(2));
  rigid[0] += force_at(r, z * r[1] - y * r[2]);
  rigid[1] += force_at(r, x * r[2] - z * r[0]);
  rigid[2] += force_at(r, y * r[0] - x * r[1]);
  rigid[3] += force_at(r, x);
  rigid[4] += force_at(r, y);
  rigid[5] += force_at(r, z);
}

inline bool fold_inward(BodyData& d, const std::vector<JointRow>& rows, double h) noexcept {
  bool sound = true;
  Screw inertia[6], bias;
  for (std::size_t i = d.links.size() - 1;; --i) {
    LinkWork& link = d.links[i];
    const BodyData::Fixed& f = d.fixed[i];
    bias = link.rigid_bias;
    for (int k = 0; k < 6; ++k) inertia[k] = link.rigid[k];
    if (!f.leaf) {
      bias += d.folded[i].bias;
      for (int k = 0; k < 6; ++k) inertia[k] += d.folded[i].inertia[k];
    }
    if (i == 0) break;
    const JointRow& row = rows[i - 1];
    const Screw S = link.axis;
    const Screw U = times(inertia, S);
    const double D = dot(S, U) + f.rotor + h * row.gain;
    sound = sound && D > 0.0;
    link.inverse_d = 1.0 / D;
    link.inertia_axis = U;
    link.u = row.force - row.gain * d.qd[i - 1] - dot(S, bias);

    BodyData::Folded& to = d.folded[static_cast<std::size_t>(f.parent)];
    const Screw Ud = U * link.inverse_d;
    const Screw c = link.coriolis;
    bias += Ud * link.u;
    for (int k = 0; k < 6; ++k) {
      inertia[k] -= Ud * (k < 3 ? U.w[k] : U.v[k - 3]);
      bias += inertia[k] * (k < 3 ? c.w[k] : c.v[k - 3]);
    }
    if (f.first) {
      for (int k = 0; k < 6; ++k) to.inertia[k] = inertia[k];
      to.bias = bias;
    } else {
      for (int k = 0; k < 6; ++k) to.inertia[k] += inertia[k];
      to.bias += bias;
    }
  }
  d.root_bias = bias;
  return (!d.floating || factor_root(d, inertia)) && sound;
}

inline void accelerate(BodyData& d) noexcept {
  d.links[0].acceleration = Screw{};
  if (d.floating) {
    double x[6];
    for (int r = 0; r < 6; ++r) x[r] = -d.root_bias[r];
    solve_root(d, x);
    d.links[0].acceleration = {Vec4{x[0], x[1], x[2], 0.0}, Vec4{x[3], x[4], x[5], 0.0}};
  }
  for (std::size_t i = 1; i < d.links.size(); ++i) {
    LinkWork& link = d.links[i];
    const Screw base =
        d.links[static_cast<std::size_t>(d.fixed[i].parent)].acceleration + link.coriolis;
    link.qdd = link.inverse_d * (link.u - dot(link.inertia_axis, base));
    link.acceleration = base + link.axis * link.qdd;
  }
}

inline void fold_wrench(BodyData& d, int index, const Screw& wrench) noexcept {
  Screw e = wrench;
  for (auto i = static_cast<std::size_t>(index); i > 0;
       i = static_cast<std::size_t>(d.fixed[i].parent)) {
    LinkWork& link = d.links[i];
    const double s = dot(link.axis, e);
    link.u += s;
    e -= link.inertia_axis * (s * link.inverse_d);
  }
  d.root_bias -= e;
}

inline int respond(const BodyData& d, int index, ResponseRow* rows) noexcept {
  Screw E[6];
  for (int r = 0; r < 6; ++r) {
    E[r] = Screw{};
    (r < 3 ? E[r].w[r] : E[r].v[r - 3]) = 1.0;
  }
  int count = 0;
  for (auto i = static_cast<std::size_t>(index); i > 0;
       i = static_cast<std::size_t>(d.fixed[i].parent)) {
    const LinkWork& link = d.links[i];
    const Screw s = times(E, link.axis);
    rows[count++] = {s * std::sqrt(link.inverse_d), static_cast<int>(i)};
    for (int r = 0; r < 6; ++r) E[r] -= s * (link.inertia_axis[r] * link.inverse_d);
  }
  if (!d.floating) return count;
  for (int r = 0; r < 6; ++r) {
    for (int k = 0; k < r; ++k) E[r] -= E[k] * d.root[r][k];
    E[r] = E[r] * d.root_inverse[r];
    rows[count++] = {E[r], -r};
  }
  return count;
}
