// Do two links touch?  Part of the kernels of SelfCollision, included after float8.h.

constexpr unsigned kShortList = 4;  // couples that cost no more than to look for a plane first
constexpr int kStuck = 3;  // looks without a plane after which only every eighth look tries one

// Do triangles of a's clusters cross triangles of b's?  Which: into memory.
static bool surfaces_cross(const CollisionTables& t, const CollisionBody& a, const CollisionBody& b,
                           const CollisionPose& a_to_b, const CollisionPose& b_to_a,
                           CollisionMemory& memory) noexcept {
  auto* kept = reinterpret_cast<MovedBox*>(t.kept);
  float low[3], high[3];
  const int count = keep_boxes(a, a_to_b, b, kept, low, high);
  if (count == 0) return false;
  F8 low8[3], high8[3];
  for (int d = 0; d < 3; ++d) {
    low8[d] = all(low[d]);
    high8[d] = all(high[d]);
  }
  float* placed = t.kept + 8 * t.most_clusters;
  int blocks = 0;
  for (int block = 0; 8 * block < b.clusters; ++block) {
    if (meet_box(b, 8 * block, low8, high8) == 0) continue;
    t.open[blocks] = block;
    place_boxes(b, 8 * block, b_to_a, placed + 48 * blocks++);
  }
  MovedCluster moved_a;
  for (int i = 0; i < count; ++i) {
    const MovedBox& box = kept[i];
    const int ca = box.cluster;
    for (int d = 0; d < 3; ++d) {
      low8[d] = all(box.middle[d] - box.half[d]);
      high8[d] = all(box.middle[d] + box.half[d]);
    }
    bool ready = false;
    for (int k = 0; k < blocks; ++k) {
      const int first = 8 * t.open[k];
      unsigned m = meet_box(b, first, low8, high8);
      if (m == 0) continue;
      const float* boxes = placed + 48 * k;
      for (m &= meet_placed(a, ca, boxes); m != 0; m &= m - 1) {
        const int lane = lowest(m), cb = first + lane;
        const float middle[3] = {boxes[lane], boxes[8 + lane], boxes[16 + lane]};
        const float half[3] = {boxes[24 + lane], boxes[32 + lane], boxes[40 + lane]};
        ++t.work[2];
        if (clusters_cross(a, ca, b, cb, a_to_b, box.middle, box.half, middle, half, moved_a, ready,
                           t.work)) {
          memory.cluster[0] = ca;
          memory.cluster[1] = cb;
          return true;
        }
      }
    }
  }
  return false;
}

// What crossed when last looked at is likely to cross.
static bool memory_crosses(const CollisionTables& t, CollisionMemory& memory,
                           const CollisionBody& a, const CollisionBody& b,
                           const CollisionPose& a_to_b, const CollisionPose& b_to_a) noexcept {
  if (memory.cluster[0] < 0) return false;
  const unsigned list[2] = {1U, static_cast<unsigned>(memory.cluster[0]) |
                                    static_cast<unsigned>(memory.cluster[1]) << 16};
  return list_crosses(t, list, a, b, a_to_b, b_to_a, memory);
}

// Is there a plane between the hulls?  Where the last one was is tried first.
static bool hulls_parted(const CollisionBody& a, const CollisionBody& b,
                         const CollisionPose& a_to_b, CollisionMemory& memory) noexcept {
  float n[4] = {memory.apart[0], memory.apart[1], memory.apart[2], 0.0F};
  bool apart = memory.cluster[0] < 0 && (n[0] != 0.0F || n[1] != 0.0F || n[2] != 0.0F) &&
               hulls_apart(a, b, a_to_b, n, 1);
  if (!apart && (memory.stuck < kStuck || memory.stuck % 8 == 0)) {
    const F4 from = moved(a_to_b, a.sphere);
    const F4 way = load4f(b.sphere) - from;
    const float scale =
        1.0F / __builtin_sqrtf(way[0] * way[0] + way[1] * way[1] + way[2] * way[2] + 1e-12F);
    for (int k = 0; k < 3; ++k) n[k] = way[k] * scale;
    apart = hulls_apart(a, b, a_to_b, n, kMostProbes);
  }
  for (int k = 0; apart && k < 3; ++k) memory.apart[k] = n[k];
  return apart;
}

// inside: also when one is inside the other.  list: of the only clusters that can, where it is known.
static bool bodies_touch(const CollisionTables& t, int first, int second, bool inside,
                         const unsigned* list) noexcept {
  const bool swap = t.body[first].clusters > t.body[second].clusters;
  const CollisionBody& a = t.body[swap ? second : first];
  const CollisionBody& b = t.body[swap ? first : second];
  const CollisionPose& pose_a = t.pose[a.link];
  const CollisionPose& pose_b = t.pose[b.link];
  CollisionPose a_to_b{}, b_to_a{};
  F4 between = load4f(pose_a.origin) - load4f(pose_b.origin);
  for (int i = 0; i < 3; ++i) {
    const F4 row_b = load4f(pose_b.column[i]);
    for (int k = 0; k < 3; ++k) {
      const F4 m = row_b * load4f(pose_a.column[k]);
      a_to_b.column[k][i] = b_to_a.column[i][k] = m[0] + m[1] + m[2];
    }
    const F4 m = row_b * between;
    a_to_b.origin[i] = m[0] + m[1] + m[2];
  }
  for (int i = 0; i < 3; ++i) {
    b_to_a.origin[i] =
        -(a_to_b.column[i][0] * a_to_b.origin[0] + a_to_b.column[i][1] * a_to_b.origin[1] +
          a_to_b.column[i][2] * a_to_b.origin[2]);
  }
  CollisionMemory& memory = t.memory[t.pair_of[first * t.bodies + second]];
  if (list == nullptr || list[0] > kShortList) {
    if (memory_crosses(t, memory, a, b, a_to_b, b_to_a)) return true;
    const bool apart = hulls_parted(a, b, a_to_b, memory);
    memory.stuck = apart ? 0 : memory.stuck + 1;
    if (apart) {
      memory.cluster[0] = -1;
      return false;
    }
  }
  if (inside && inner_overlap(a, b, a_to_b)) return true;
  if (list != nullptr ? list_crosses(t, list, a, b, a_to_b, b_to_a, memory)
                      : surfaces_cross(t, a, b, a_to_b, b_to_a, memory))
    return true;
  memory.cluster[0] = -1;
  if (!inside) return false;
  const bool a_smaller = a.sphere[3] <= b.sphere[3];
  return a_smaller ? some_inside(a, b, a_to_b) : some_inside(b, a, b_to_a);
}

static int collide(const CollisionTables& t, bool first_only) noexcept {
  const int n = spheres(t);
  t.work[0] += n;
  capsule_bounds(t, n);
  int hits = 0;
  for (int i = 0; i < n; ++i) {
    if (t.bound[i] > 0.0F) continue;
    ++t.work[1];
    const CollisionCandidate pair = t.near[i];
    const int index = t.pair_of[pair.a * t.bodies + pair.b];
    const CollisionCells& cells = t.cells[index];
    const unsigned cell = cells.joints > 0 ? cell_at(cells, t.q) : JointCells::kUnknown;
    if (cell == JointCells::kFree) continue;
    const unsigned* list = cell == JointCells::kUnknown ? nullptr : cells.lists + cell;
    if (!bodies_touch(t, pair.a, pair.b, true, list)) continue;
    t.hit[hits++] = index;
    if (first_only) break;
  }
  return hits;
}
