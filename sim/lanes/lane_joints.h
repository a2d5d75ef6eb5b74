// The law of each joint in four worlds: sim/articulated/joint_law.h.  No include guard: lane_kernels.cpp
// includes this once for each instruction set, in a namespace of its own.

TWINBUS_INLINE Vec4 side(const Vec4& x, const Vec4& low, const Vec4& high) {
  const Vec4 none = {}, one = all(1.0);
  return (x > high ? one : none) - (x < low ? one : none);
}

// How fast a joint may come nearer to a stop that is so far away.
TWINBUS_INLINE Vec4 bound_of(const Vec4& room, double rate) {
  return room >= 0.0 ? room * rate : larger(kStopShare * room * rate, all(-kStopReturn));
}

TWINBUS_INLINE void begin_joint(JointLanes& j, const Vec4& q, const Vec4& qd, double h) {
  j.force = j.kp * (j.q - q - j.play) + j.kd * j.qd + j.tau;
  j.gain = h * j.kp + j.kd;
  const double rate = 1.0 / h;
  j.high_bound = bound_of(j.upper - q, rate);
  j.low_bound = -bound_of(q - j.lower, rate);
  j.servo = side(j.force - j.gain * qd, -j.limit, j.limit);
  j.slides = side(qd, -j.stick, j.stick);
  j.stop = side(qd, j.low_bound, j.high_bound);
  j.stop = ((j.upper - q <= kStopGuess) & (qd >= 0.0)) ? all(1.0) : j.stop;
  j.stop = ((q - j.lower <= kStopGuess) & (qd <= 0.0)) ? all(-1.0) : j.stop;
}

TWINBUS_INLINE void write_row(const JointLanes& j, BodyLanes<Vec4>& d, std::size_t rank) {
  const Vec4 none = {}, leans = j.stop * j.stop * kStopGain;
  const Vec4 bound = j.stop > 0.0 ? j.high_bound : j.stop < 0.0 ? j.low_bound : none;
  write(d.force, rank, (j.servo != 0.0 ? j.servo * j.limit : j.force) - j.slides * j.friction + leans * bound);
  write(d.gain, rank, (j.servo != 0.0 ? none : j.gain) + j.damping + (j.slides != 0.0 ? none : j.stick_gain) + leans);
}

TWINBUS_INLINE Vec4 towards(const Vec4& next, const Vec4& now) { return next * now < 0.0 ? Vec4{} : next; }

// Worlds in which a joint ends on other pieces than assumed; there those are assumed next.
TWINBUS_INLINE Lanes settle_joints(LaneBlock& block) {
  BodyLanes<Vec4>& d = block.body;
  Lanes wrong = {};
  for (std::size_t r = 1; r < d.links.size(); ++r) {
    JointLanes& j = block.joints[r - 1];
    const Vec4 end = lanes_of<Vec4>(d.rate, r) + block.h * d.links[r].qdd;
    const Vec4 servo = side(j.force - j.gain * end, -j.limit, j.limit), slides = side(end, -j.stick, j.stick),
               stop = side(end, j.low_bound, j.high_bound);
    const Lanes other = (servo != j.servo) | (slides != j.slides) | (stop != j.stop);
    wrong = wrong | other;
    if (!any(other)) continue;
    choose(other, towards(servo, j.servo), j.servo);
    choose(other, towards(slides, j.slides), j.slides);
    choose(other, towards(stop, j.stop), j.stop);
    write_row(j, d, r);
  }
  return wrong;
}
