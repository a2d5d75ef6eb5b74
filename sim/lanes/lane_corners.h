// The corners of soles on level ground in four worlds: sim/contact/ground_contacts.h and the first stage of
// sim/contact/contact_solve.h.  No include guard: lane_kernels.cpp includes this once for each instruction set, in a namespace of its own.

// The law of sim/contact/contact_law.h at c.v into c.force.
template <bool kTangent>
TWINBUS_INLINE void find_force(CornerLanes& c, double h) {
  const Vec4 none = {}, one = all(1.0), vn = c.v.z;
  const Vec4 end = c.depth - h * vn, by_depth = c.c / c.ramp, factor = c.k - by_depth * vn;
  const Lanes ramped = end < c.ramp;
  Vec4 fn = ramped ? end * factor : c.k * end - c.c * vn;
  const Lanes pressed = (end > 0.0) & (fn > 0.0);
  fn = pressed ? fn : none;
  const Vec4 beta = c.ct + h * c.kt;
  const Vec4 tx = -c.kt * c.stretch_x - beta * c.v.x, ty = -c.kt * c.stretch_y - beta * c.v.y;
  const Vec4 square = tx * tx + ty * ty, limit = c.mu * fn;
  const Lanes slips = square > limit * limit;
  Vec4 size = one, share = one;
  if (any(slips)) {
    size = slips ? root_of(square) : one;
    share = slips ? limit / size : one;
  }
  c.open = pressed ? none : one;
  c.slip = slips ? one : none;
  c.force = {pressed ? share * tx : none, pressed ? share * ty : none, fn};
  if constexpr (kTangent) {
    const Vec4 slope = ramped ? h * factor + end * by_depth : h * c.k + c.c;
    const Vec4 alpha = pressed ? beta * share : none;
    const Vec4 ux = slips ? tx / size : none, uy = slips ? ty / size : none;
    c.xx = alpha - alpha * ux * ux;
    c.xy = -alpha * ux * uy;
    c.yy = alpha - alpha * uy * uy;
    c.zz = pressed ? slope : none;
  }
}

// Where the corners are and what they press, folded into their links.  Worlds that nothing touches are returned.
TWINBUS_INLINE Lanes fold_corners(LaneBlock& block) {
  BodyLanes<Vec4>& d = block.body;
  const Vec4 none = {};
  const double h = block.h;
  for (const CornerLanes& c : block.corners) {
    d.ranks[c.rank].touched = true;
    Inertia<Vec4>& stiff = d.stiff[c.rank].value;
    stiff.ww = stiff.vv = {none, none, none, none, none, none};
    stiff.wv.x = stiff.wv.y = stiff.wv.z = {none, none, none};
  }
  Lanes touched = {};
  block.doubt_depth = none;
  for (CornerLanes& c : block.corners) {
    LinkLanes<Vec4>& link = d.links[c.rank];
    c.r = link.origin + times(link.rotation, c.local);
    c.v0 = c.v = link.velocity.v + cross(link.velocity.w, c.r);
    c.depth = c.height - (block.origin.z + c.r.z);
    touched = touched | (c.depth > 0.0);
    const Vec4 expected = kFirstDepth + 2.0 * h * size_of(c.v0.z) + 2.0 * block.deep[static_cast<std::size_t>(c.sole)];
    const Lanes doubted = (c.depth > kFirstDepth) & (c.depth > expected) & (block.fresh == 0.0);
    block.doubt_depth = doubted ? larger(block.doubt_depth, c.depth) : block.doubt_depth;
    // A new bristle is planted where the point will come down.
    const Lanes lands = (c.depth < 0.0) & (c.v0.z < 0.0);
    const Vec4 ahead = lands ? smaller(all(h), c.depth / c.v0.z) : none;
    c.stretch_x = c.known > 0.0 ? block.origin.x + c.r.x - c.anchor_x : -ahead * c.v0.x;
    c.stretch_y = c.known > 0.0 ? block.origin.y + c.r.y - c.anchor_y : -ahead * c.v0.y;
    find_force<true>(c, h);
    c.f0 = c.force;
    link.bias.w = link.bias.w - cross(c.r, c.f0);
    link.bias.v = link.bias.v - c.f0;
    // J(r)' W J(r) = [ r^ W r^' , r^ W ; .. , W ].
    const Vec4 x = c.r.x, y = c.r.y, z = c.r.z, a = h * c.xx, b = h * c.xy, e = h * c.yy, f = h * c.zz;
    const Three<Vec4> first = {-z * b, -z * e, y * f}, second = {z * a, z * b, -x * f};
    const Vec4 third_x = x * b - y * a, third_y = x * e - y * b;
    Inertia<Vec4>& stiff = d.stiff[c.rank].value;
    const Three<Vec4> ww = {y * first.z - z * first.y, z * first.x - x * first.z, x * first.y - y * first.x};
    const Vec4 ww_yy = z * second.x - x * second.z, ww_yz = x * second.y - y * second.x, ww_zz = x * third_y - y * third_x;
    add(Symmetric3<Vec4>{ww.x, ww.y, ww.z, ww_yy, ww_yz, ww_zz}, stiff.ww);
    add(Three<Vec4>{first.x, second.x, third_x}, stiff.wv.x);
    add(Three<Vec4>{first.y, second.y, third_y}, stiff.wv.y);
    stiff.wv.z.x += first.z;
    stiff.wv.z.y += second.z;
    add(Symmetric3<Vec4>{a, b, none, e, none, f}, stiff.vv);
  }
  return ~touched;
}

// Worlds in which the forces of the corners are those that were folded in.
TWINBUS_INLINE Lanes corners_hold(LaneBlock& block) {
  constexpr double kStageOne = 1e-9;  // of 1 N and all forces
  Vec4 total = all(1.0), most = {};
  for (CornerLanes& c : block.corners) {
    const Six<Vec4> a = block.body.links[c.rank].acceleration;
    const Three<Vec4> change = (a.v + cross(a.w, c.r)) * all(block.h);
    c.v = c.v0 + change;
    find_force<false>(c, block.h);
    total += c.force.z;
    const Vec4 x = c.force.x - c.f0.x + c.xx * change.x + c.xy * change.y;
    const Vec4 y = c.force.y - c.f0.y + c.xy * change.x + c.yy * change.y, z = c.force.z - c.f0.z + c.zz * change.z;
    const Vec4 off = x * x + y * y + z * z;
    most = off > most ? off : most;
    total += 0.0 * off;  // no number: nothing holds
  }
  return most <= (kStageOne * kStageOne) * total * total;
}

// What the corners remember.
TWINBUS_INLINE void remember_corners(LaneBlock& block, const Lanes& mask) {
  const Vec4 none = {}, one = all(1.0);
  const double h = block.h;
  std::array<Vec4, 2> deep = {none, none};
  for (CornerLanes& c : block.corners) {
    const Vec4 end = c.depth - h * c.v.z;
    Vec4& most = deep[static_cast<std::size_t>(c.sole)];
    most = end > 0.25 * kFirstDepth ? larger(most, end) : most;
    choose(mask, one - c.open, c.known);
    const Vec4 beta = c.ct + h * c.kt;
    const Vec4 x = c.stretch_x - (h / beta) * (c.force.x + c.kt * c.stretch_x);
    const Vec4 y = c.stretch_y - (h / beta) * (c.force.y + c.kt * c.stretch_y);
    const Vec4 at_x = block.before.x + c.r.x, at_y = block.before.y + c.r.y;
    choose(mask, c.slip != 0.0 ? at_x + h * c.v.x - x : at_x - c.stretch_x, c.anchor_x);
    choose(mask, c.slip != 0.0 ? at_y + h * c.v.y - y : at_y - c.stretch_y, c.anchor_y);
  }
  choose(mask, deep[0], block.deep[0]);
  choose(mask, deep[1], block.deep[1]);
  choose(mask, none, block.fresh);
}
