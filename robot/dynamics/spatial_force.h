// Spatial vectors and inertias in world axes about one common point O, the origin of link 0.
//
// About a common point inertias of links add up without being moved (Featherstone 2008, section
// 2.13), which is what makes the algorithms that include this file short.

#pragma once

#include "robot/kinematics/kinematics.h"
#include "common/simd/vec4.h"

namespace twinbus::inline robot {

// A motion (angular velocity, velocity of the point at O) or a force (moment about O, force).
struct Spatial {
  Vec4 angular, linear;
};

struct alignas(32) StoredSpatial {
  PaddedVector angular, linear;
};

TWINBUS_INLINE Spatial load(const StoredSpatial& from) noexcept {
  return {load(from.angular), load(from.linear)};
}
TWINBUS_INLINE void store(StoredSpatial& to, const Spatial& v) noexcept {
  store(to.angular, v.angular);
  store(to.linear, v.linear);
}
TWINBUS_INLINE double dot(const Spatial& a, const Spatial& b) noexcept {
  const Vec4 m = a.angular * b.angular + a.linear * b.linear;
  return m[0] + m[1] + m[2];
}
TWINBUS_INLINE Spatial operator+(const Spatial& a, const Spatial& b) noexcept {
  return {a.angular + b.angular, a.linear + b.linear};
}
TWINBUS_INLINE Spatial operator*(const Spatial& a, double s) noexcept {
  return {a.angular * s, a.linear * s};
}

// Origin of a link from O.
TWINBUS_INLINE Vec4 from_base(const Kinematics& k, int link) noexcept {
  return load4(k.state(link).pose.matrix().data() + 12) -
         load4(k.state(0).pose.matrix().data() + 12);
}

// Motion of link i > 0 at unit speed of the joint that moves it.
TWINBUS_INLINE Spatial joint_motion(const Kinematics& k, int link, bool slides) noexcept {
  const Vec4 axis = load(k.state(link).axis);
  if (slides) return {Vec4{}, axis};
  return {axis, cross4(from_base(k, link), axis)};
}

// Inertia of a link about its own centre of mass, world axes: R I R'.
TWINBUS_INLINE Columns turned_inertia(const Kinematics& k, int link) noexcept {
  const double* r = k.state(link).pose.matrix().data();
  const LinkMass& of = k.mass_of(link);
  const Columns turn = columns(r, 4);
  const Columns half = {turn.times(of.inertia[0].value.data()),
                        turn.times(of.inertia[1].value.data()),
                        turn.times(of.inertia[2].value.data())};
  return {half.times(r[0], r[4], r[8]), half.times(r[1], r[5], r[9]),
          half.times(r[2], r[6], r[10])};
}

// Of a link and what moves with it rigidly.
struct RigidInertia {
  Columns inertia;  // about O [kg m^2]
  Vec4 moment;      // mass times centre of mass from O [kg m]
  double mass;      // [kg]

  // Momentum of a motion.
  TWINBUS_INLINE Spatial times(const Spatial& motion) const noexcept {
    return {inertia.times(motion.angular) + cross4(moment, motion.linear),
            motion.linear * mass + cross4(motion.angular, moment)};
  }
};

// turned: about the centre of mass; com: from O.
TWINBUS_INLINE RigidInertia moved_inertia(const Columns& turned, const Vec4& com,
                                          double mass) noexcept {
  const Vec4 moment = com * mass;
  const double square = dot3(moment, com);
  return {{turned.x - moment * com[0] + Vec4{square, 0.0, 0.0, 0.0},
           turned.y - moment * com[1] + Vec4{0.0, square, 0.0, 0.0},
           turned.z - moment * com[2] + Vec4{0.0, 0.0, square, 0.0}},
          moment,
          mass};
}

TWINBUS_INLINE RigidInertia rigid_inertia(const Kinematics& k, int link) noexcept {
  const Vec4 com = load(k.state(link).com) - load4(k.state(0).pose.matrix().data() + 12);
  return moved_inertia(turned_inertia(k, link), com, k.mass_of(link).mass);
}

}  // namespace twinbus::robot
