// Kinematics, spheres and capsules: the pairs of links that can touch.  Part of the kernels of SelfCollision, included after capsule_lanes.h.

static void kinematics(const CollisionTables& t) noexcept {
  for (int j = 0; j < t.joints; ++j) {
    const CollisionJoint& joint = t.joint[j];
    const CollisionPose& parent = t.pose[joint.parent];
    CollisionPose& child = t.pose[joint.child];
    F4 offset = load4f(joint.offset);
    F4 local[3] = {load4f(joint.still[0]), load4f(joint.still[1]), load4f(joint.still[2])};
    if (joint.turns) {
      const float s = static_cast<float>(t.sine[j]), c = static_cast<float>(t.cosine[j]);
      for (int k = 0; k < 3; ++k)
        local[k] = local[k] + load4f(joint.with_cosine[k]) * c + load4f(joint.with_sine[k]) * s;
    } else {
      offset = offset + load4f(joint.slide) * static_cast<float>(t.q[j]);
    }
    const F4 x = load4f(parent.column[0]), y = load4f(parent.column[1]),
             z = load4f(parent.column[2]);
    for (int k = 0; k < 3; ++k) {
      const F4 column = x * local[k][0] + y * local[k][1] + z * local[k][2];
      __builtin_memcpy(child.column[k], &column, sizeof column);
    }
    const F4 origin = load4f(parent.origin) + x * offset[0] + y * offset[1] + z * offset[2];
    __builtin_memcpy(child.origin, &origin, sizeof origin);
  }
  for (int i = 0; i < t.bodies; ++i) {
    const CollisionBody& body = t.body[i];
    const CollisionPose& pose = t.pose[body.link];
    const F4 s = moved(pose, body.sphere), a = moved(pose, body.from), b = moved(pose, body.to);
    for (int k = 0; k < 3; ++k) {
      t.sphere[k][i] = s[k];
      t.from[k][i] = a[k];
      t.to[k][i] = b[k];
    }
  }
}

// Pairs whose spheres meet; how many.
static int spheres(const CollisionTables& t) noexcept {
  int n = 0;
  for (int a = 0; a < t.bodies; ++a) {
    const F8 x = all(t.sphere[0][a]), y = all(t.sphere[1][a]), z = all(t.sphere[2][a]);
    const F8 r = all(t.sphere[3][a]);
    for (int block = (a + 1) / 8; block < t.blocks; ++block) {
      const unsigned wanted = t.wanted[a * t.blocks + block];
      if (wanted == 0) continue;
      const F8 dx = load8(t.sphere[0] + 8 * block) - x;
      const F8 dy = load8(t.sphere[1] + 8 * block) - y;
      const F8 dz = load8(t.sphere[2] + 8 * block) - z;
      const F8 reach = load8(t.sphere[3] + 8 * block) + r;
      for (unsigned m = bits(dx * dx + dy * dy + dz * dz <= reach * reach) & wanted; m != 0;
           m &= m - 1) {
        t.near[n].a = a;
        t.near[n++].b = 8 * block + lowest(m);
      }
    }
  }
  return n;
}

// Lower bounds of the distances of the capsules of n candidates.
static void capsule_bounds(const CollisionTables& t, int n) noexcept {
  for (int first = 0; first < n; first += 8) {
    alignas(32) float in[14][8];
    for (int lane = 0; lane < 8; ++lane) {
      const CollisionCandidate pair = t.near[first + lane < n ? first + lane : n - 1];
      for (int k = 0; k < 3; ++k) {
        in[k][lane] = t.from[k][pair.a];
        in[3 + k][lane] = t.to[k][pair.a];
        in[6 + k][lane] = t.from[k][pair.b];
        in[9 + k][lane] = t.to[k][pair.b];
      }
      in[12][lane] = t.capsule_radius[pair.a] + t.capsule_radius[pair.b];
    }
    F8 p[3], q[3], u[3], v[3], w[3];
    for (int k = 0; k < 3; ++k) {
      p[k] = load8(in[k]);
      q[k] = load8(in[6 + k]);
      u[k] = load8(in[3 + k]) - p[k];
      v[k] = load8(in[9 + k]) - q[k];
      w[k] = q[k] - p[k];
    }
    F8 between[3];
    const F8 gap = segments_gap(u, v, w, between);
    const F8 bound = gap - load8(in[12]) - all(kCapsuleSlack);
    __builtin_memcpy(t.bound + first, &bound, sizeof bound);
  }
}
