// Where the robots of four worlds may be in the next step, and whether a shell of theirs comes near the ground.  No include guard: lane_kernels.cpp
// includes this once for each instruction set, in a namespace of its own.

// Nothing of a robot goes further in a step.
TWINBUS_INLINE Vec4 farthest(const LaneBlock& block) {
  Vec4 rates = {};
  for (std::size_t r = 1; r < block.body.links.size(); ++r) rates += size_of(lanes_of<Vec4>(block.body.rate, r));
  const Vec4 turning = sum_of_sizes(block.spin) * block.reach + larger(all(1.0), 2.0 * block.reach) * rates;
  return reach_in(sum_of_sizes(block.velocity) + turning, block.h);
}

inline void bound_worlds(LaneBlock& block) noexcept {
  const Vec4 far = farthest(block);
  for (std::size_t r = 0; r < block.extents.size(); ++r) {
    const Three<Vec4> origin = block.origin + block.body.links[r].origin;
    const Vec4 extent = block.extents[r] + far;
    const Three<Vec4> around = {extent, extent, extent};
    const Three<Vec4> low = origin - around, high = origin + around;
    if (r == 0) {
      block.low = low;
      block.high = high;
    }
    block.low = {smaller(block.low.x, low.x), smaller(block.low.y, low.y), smaller(block.low.z, low.z)};
    block.high = {larger(block.high.x, high.x), larger(block.high.y, high.y), larger(block.high.z, high.z)};
  }
}

// Worlds in which something else than a sole may touch the ground.
TWINBUS_INLINE Lanes near_ground(const LaneBlock& block) {
  const BodyLanes<Vec4>& d = block.body;
  const Vec4 far = farthest(block);
  Lanes near = {};
  for (const ShellLanes& shell : block.shells) {
    const LinkLanes<Vec4>& link = d.links[shell.rank];
    const Vec4 height = block.origin.z + link.origin.z;
    Lanes low = height < shell.extent + far;
    if (!any(low)) continue;
    const Three<Vec4> middle = link.origin + times(link.rotation, shell.center);
    const Three<Vec4> there = link.velocity.v + cross(link.velocity.w, middle);
    const Vec4 reach = reach_in(sum_of_sizes(there) + sum_of_sizes(link.velocity.w) * shell.radius, block.h);
    low = low & (block.origin.z + middle.z < shell.radius + reach);
    if (!any(low)) continue;
    const Three<Vec4> up = {link.rotation.x.z, link.rotation.y.z, link.rotation.z.z};
    for (const ShellLanes::Probe& probe : shell.probes)
      near = near | (low & (height + dot(up, probe.center) < probe.radius + reach));
  }
  return near;
}
