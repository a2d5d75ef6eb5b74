// A step of backward Euler of four worlds side by side, as sim/engine/articulated_world.h takes it where soles stand on level ground: joint
// laws, contacts, the articulated-body sweeps and the motion of the base.  No include guard: lane_kernels.cpp includes this once for each
// instruction set.  All operations are those of single lanes: what a world does is the same to the bit whatever its neighbours do.

#include "sim/lanes/lane_numbers.h"
#include "sim/lanes/lane_bounds.h"
#include "sim/lanes/lane_corners.h"
#include "sim/lanes/lane_joints.h"

inline void place_worlds(LaneBlock& block) noexcept {
  BodyLanes<Vec4>& d = block.body;
  LinkLanes<Vec4>& root = d.links[0];
  root.rotation = block.rotation;
  root.origin = Three<Vec4>{Vec4{}, Vec4{}, Vec4{}};
  root.velocity = {block.spin, block.velocity};
  find_sines(d.angle, d.sine, d.cosine);
  place_links(d);
}

// The acceleration of the sweeps into velocities and places, of the lanes in mask; those that come to no sane result are taken out of it.
TWINBUS_INLINE void advance(LaneBlock& block, Lanes& mask) {
  BodyLanes<Vec4>& d = block.body;
  const double h = block.h;
  for (std::size_t r = 1; r < d.links.size(); ++r)
    mask = mask & (size_of(lanes_of<Vec4>(d.rate, r) + h * d.links[r].qdd) <= kMaxSpeed);
  const Six<Vec4> a = d.links[0].acceleration;
  const Vec4 step = all(h);
  const Three<Vec4> w = block.spin + a.w * step, v = block.velocity + a.v * step, origin = block.origin + v * step;
  for (const Three<Vec4>* each : {&w, &v}) {
    mask = mask & (size_of(each->x) <= kMaxSpeed) & (size_of(each->y) <= kMaxSpeed) & (size_of(each->z) <= kMaxSpeed);
  }
  mask = mask & (size_of(origin.x) <= kMaxDistance) & (size_of(origin.y) <= kMaxDistance) & (size_of(origin.z) <= kMaxDistance);
  for (std::size_t r = 1; r < d.links.size(); ++r) {
    JointLanes& j = block.joints[r - 1];
    const Vec4 qd = lanes_of<Vec4>(d.rate, r), end = qd + h * d.links[r].qdd, q = lanes_of<Vec4>(d.angle, r);
    write(d.rate, r, mask ? end : qd);
    write(d.angle, r, mask ? q + h * end : q);
    const Vec4 asked = j.force - j.gain * end;
    const Vec4 torque = j.servo != 0.0 ? j.servo * j.limit : smaller(larger(asked, -j.limit), j.limit);
    choose(mask, torque, j.torque);
    const Vec4 flank = 0.5 * j.backlash * smaller(larger(torque * (1.0 / kPlayTorque), all(-1.0)), all(1.0));
    choose(mask, j.play + kPlayRate * (flank - j.play), j.play);
  }
  if (!block.root.floating) return;
  choose(mask, origin, block.origin);
  const Vec4 speed = root_of(dot(w, w));
  Vec4 sine, cosine;
  sine_cosine(speed * step, sine, cosine);
  const Vec4 safe = larger(speed, all(1e-300));
  const Three<Vec4> axis = {w.x / safe, w.y / safe, w.z / safe};
  const Columns3<Vec4> rotation = turn(axis, sine, cosine);
  Columns3<Vec4> R = times(rotation, block.rotation);
  // Its columns are made orthogonal again: R (3 - R' R) / 2.
  const Vec4 xx = 1.5 - 0.5 * dot(R.x, R.x), yy = 1.5 - 0.5 * dot(R.y, R.y), zz = 1.5 - 0.5 * dot(R.z, R.z);
  const Vec4 xy = -0.5 * dot(R.x, R.y), xz = -0.5 * dot(R.x, R.z), yz = -0.5 * dot(R.y, R.z);
  R = {R.x * xx + R.y * xy + R.z * xz, R.x * xy + R.y * yy + R.z * yz, R.x * xz + R.y * yz + R.z * zz};
  choose(mask, R.x, block.rotation.x);
  choose(mask, R.y, block.rotation.y);
  choose(mask, R.z, block.rotation.z);
  choose(mask, times(rotation, v), block.velocity);
  choose(mask, w, block.spin);
}

inline int step_worlds(LaneBlock& block, int asked) noexcept {
  constexpr int kMostPasses = 3;
  BodyLanes<Vec4>& d = block.body;
  Lanes mask;
  for (int k = 0; k < kWorldLanes; ++k) mask[k] = (asked >> k & 1) != 0 ? -1 : 0;
  mask = mask & ~near_ground(block);
  const Lanes untouched = fold_corners(block);
  if (block.root.floating) mask = mask & ~untouched;
  if (!any(mask)) return 0;
  for (std::size_t r = 1; r < d.links.size(); ++r) {
    JointLanes& j = block.joints[r - 1];
    begin_joint(j, lanes_of<Vec4>(d.angle, r), lanes_of<Vec4>(d.rate, r), block.h);
    write_row(j, d, r);
  }
  Lanes wrong = mask;
  for (int pass = 0; pass < kMostPasses && any(wrong); ++pass) {
    (void)fold_inward(d, block.root, block.h);
    accelerate(d, block.root);
    wrong = mask & settle_joints(block);
  }
  mask = mask & ~wrong & corners_hold(block) & (block.root.wrong == 0.0);
  block.before = block.origin;
  advance(block, mask);
  remember_corners(block, mask);
  return bits(mask);
}
