// Where all links of a BodyData are, how fast, how heavy, and what its momentum is.  No include
// guard: articulated_body.cpp includes this once for each instruction set, in a namespace of its own.

inline bool factor_root(BodyData& d, const Screw (&inertia)[6]) noexcept {
  bool sound = true;
  for (int c = 0; c < 6; ++c) {
    for (int r = c; r < 6; ++r) {
      double sum = inertia[c][r];
      for (int k = 0; k < c; ++k) sum -= d.root[r][k] * d.root[c][k];
      if (r == c) {
        sound = sound && sum > 0.0;
        d.root[c][c] = std::sqrt(sum);
        d.root_inverse[c] = 1.0 / d.root[c][c];
      } else {
        d.root[r][c] = sum * d.root_inverse[c];
      }
    }
  }
  return sound;
}

inline void solve_root(const BodyData& d, double (&x)[6]) noexcept {
  for (int r = 0; r < 6; ++r) {
    for (int k = 0; k < r; ++k) x[r] -= d.root[r][k] * x[k];
    x[r] *= d.root_inverse[r];
  }
  for (int r = 5; r >= 0; --r) {
    for (int k = r + 1; k < 6; ++k) x[r] -= d.root[k][r] * x[k];
    x[r] *= d.root_inverse[r];
  }
}

inline void move_link(BodyData& d, std::size_t i, double q, double qd) noexcept {
  const BodyData::Fixed& f = d.fixed[i];
  LinkWork& link = d.links[i];
  const LinkWork& parent = d.links[static_cast<std::size_t>(f.parent)];
  Vec4 origin = vec4(parent.origin) + times(parent.axes, f.offset);
  if (f.prismatic) {
    for (int k = 0; k < 3; ++k) link.axes[k] = times(parent.axes, f.still[k]);
    const Vec4 axis = times(link.axes, f.axis);
    origin += axis * q;
    link.axis = {Vec4{}, axis};
  } else {
    const double c = std::cos(q), s = std::sin(q);
    for (int k = 0; k < 3; ++k) {
      link.axes[k] = times(parent.axes, f.still[k] + f.swing[k] * c + f.turn[k] * s);
    }
    const Vec4 axis = times(link.axes, f.axis);
    link.axis = {axis, cross(origin, axis)};
  }
  for (int k = 0; k < 3; ++k) link.rotation.col(k) = vec3(link.axes[k]);
  link.origin = vec3(origin);
  link.velocity = parent.velocity + link.axis * qd;
}

inline void move_inertia(BodyData& d, std::size_t i) noexcept {
  const BodyData::Fixed& f = d.fixed[i];
  LinkWork& link = d.links[i];
  const double m = f.mass;
  const Vec4 C = vec4(link.origin) + times(link.axes, f.com);
  link.center = C;
  link.com = vec3(C);
  // R I R': the columns of (R I) weighted by the rows of R.
  Vec4 half[3], inertia[3];
  for (int k = 0; k < 3; ++k) half[k] = times(link.axes, f.inertia[k]);
  for (int k = 0; k < 3; ++k) {
    inertia[k] = half[0] * link.axes[0][k] + half[1] * link.axes[1][k] + half[2] * link.axes[2][k];
  }
  const double x = m * C[0], y = m * C[1], z = m * C[2];
  const double xx = inertia[0][0] + y * C[1] + z * C[2];
  const double yy = inertia[1][1] + x * C[0] + z * C[2];
  const double zz = inertia[2][2] + x * C[0] + y * C[1];
  const double xy = inertia[0][1] - x * C[1];
  const double xz = inertia[0][2] - x * C[2];
  const double yz = inertia[1][2] - y * C[2];
  link.rigid[0] = {Vec4{xx, xy, xz, 0}, Vec4{0, -z, y, 0}};
  link.rigid[1] = {Vec4{xy, yy, yz, 0}, Vec4{z, 0, -x, 0}};
  link.rigid[2] = {Vec4{xz, yz, zz, 0}, Vec4{-y, x, 0, 0}};
  link.rigid[3] = {Vec4{0, z, -y, 0}, Vec4{m, 0, 0, 0}};
  link.rigid[4] = {Vec4{-z, 0, x, 0}, Vec4{0, m, 0, 0}};
  link.rigid[5] = {Vec4{y, -x, 0, 0}, Vec4{0, 0, m, 0}};
}

inline void move(BodyData& d, const Configuration& configuration) noexcept {
  d.origin = configuration.base.translation();
  LinkWork& root = d.links[0];
  root.rotation = configuration.base.linear();
  for (int k = 0; k < 3; ++k) root.axes[k] = vec4(root.rotation.col(k));
  root.origin.setZero();
  root.velocity = d.floating ? Screw{vec4(configuration.base_angular_velocity),
                                     vec4(configuration.base_velocity)}
                             : Screw{};
  root.axis = Screw{};
  move_inertia(d, 0);
  for (std::size_t i = 1; i < d.links.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i) - 1;
    d.qd[i - 1] = configuration.qd[joint];
    move_link(d, i, configuration.q[joint], configuration.qd[joint]);
    move_inertia(d, i);
  }
}

// With (n, l) = rigid (w, v):
//     bias = ( w x n + v x l - C x m g ,  w x l - m g ),     c = ( w x a , w x s + v x a ) qd
// w and v of the parent in c, axis (a, s).
inline void weigh(BodyData& d) noexcept {
  d.links[0].coriolis = Screw{};
  d.momentum = Screw{};
  d.moment = Vec4{};
  for (std::size_t i = 0; i < d.links.size(); ++i) {
    const BodyData::Fixed& f = d.fixed[i];
    LinkWork& link = d.links[i];
    const Vec4 w = link.velocity.w, v = link.velocity.v;
    const Screw momentum = times(link.rigid, link.velocity);
    d.momentum += momentum;
    d.moment += link.center * f.mass;
    const Vec4 n = momentum.w, l = momentum.v;
    const Vec4 weight = {0.0, 0.0, -f.mass * kGravity, 0.0};
    link.rigid_bias = {cross(w, n) + cross(v, l) - cross(link.center, weight),
                       cross(w, l) - weight};
    if (i == 0) continue;
    const LinkWork& parent = d.links[static_cast<std::size_t>(f.parent)];
    const Vec4 wp = parent.velocity.w, vp = parent.velocity.v;
    const Vec4 a = link.axis.w, s = link.axis.v;
    link.coriolis = {cross(wp, a) * d.qd[i - 1], (cross(wp, s) + cross(vp, a)) * d.qd[i - 1]};
  }
}

inline Momentum momentum_of(const BodyData& d, const Screw& sum, const Vec4& moment) noexcept {
  const Eigen::Vector3d com = vec3(moment) / d.mass;
  return {d.origin + com, vec3(sum.v), vec3(sum.w) - com.cross(vec3(sum.v))};
}

// The change is a rigid motion of all links: d.root is free for its inertia until inward().
inline void correct(BodyData& d, const Momentum& wanted, Configuration& to) noexcept {
  move(d, to);
  Screw sum = {}, columns[6] = {};  // momentum; inertia of all links as if welded; about O
  Vec4 moment = {};
  for (std::size_t i = 0; i < d.links.size(); ++i) {
    const LinkWork& link = d.links[i];
    sum += times(link.rigid, link.velocity);
    moment += link.center * d.fixed[i].mass;
    for (int k = 0; k < 6; ++k) columns[k] += link.rigid[k];
  }
  const Momentum now = momentum_of(d, sum, moment);
  const Eigen::Vector3d com = now.com - d.origin;
  const Eigen::Vector3d missing = wanted.linear - now.linear;
  const Eigen::Vector3d turn = wanted.angular - now.angular + com.cross(missing);
  double x[6] = {turn[0], turn[1], turn[2], missing[0], missing[1], missing[2]};
  if (factor_root(d, columns)) {
    solve_root(d, x);
    to.base_angular_velocity += Eigen::Vector3d(x[0], x[1], x[2]);
    to.base_velocity += Eigen::Vector3d(x[3], x[4], x[5]);
    to.base.translation() += wanted.com - now.com;
    d.origin = to.base.translation();
    // To the bit what move() makes of it.
    d.links[0].velocity = Screw{vec4(to.base_angular_velocity), vec4(to.base_velocity)};
    for (std::size_t i = 1; i < d.links.size(); ++i) {
      LinkWork& link = d.links[i];
      const LinkWork& parent = d.links[static_cast<std::size_t>(d.fixed[i].parent)];
      link.velocity = parent.velocity + link.axis * d.qd[i - 1];
    }
  }
  weigh(d);
}

inline void place(BodyData& d, const Configuration& configuration) noexcept {
  move(d, configuration);
  weigh(d);
}
