// What can two links with few joints between them touch with, at this posture?  Part of the kernels of
// SelfCollision, included after self_collision_boxes.h.

// The cell of JointCells that the posture is in; unknown beyond the ranges.
TWINBUS_INLINE unsigned cell_at(const CollisionCells& cells, const double* q) noexcept {
  int index = 0;
  for (int k = 0; k < cells.joints; ++k) {
    const double x = (q[cells.slot[k]] - cells.low[k]) * cells.per_unit[k];
    if (!(x >= 0.0 && x <= cells.count[k])) return JointCells::kUnknown;
    const int i = static_cast<int>(x);
    index = index * cells.count[k] + (i < cells.count[k] ? i : i - 1);
  }
  return cells.cell[index];
}

// Do triangles of the couples of clusters in the list cross?  Which: into memory.
static bool list_crosses(const CollisionTables& t, const unsigned* list, const CollisionBody& a,
                         const CollisionBody& b, const CollisionPose& a_to_b,
                         const CollisionPose& b_to_a, CollisionMemory& memory) noexcept {
  MovedCluster moved_a;
  bool ready = false;
  int before = -1;
  for (unsigned k = 1; k <= list[0]; ++k) {
    const int ca = static_cast<int>(list[k] & 0xFFFFU), cb = static_cast<int>(list[k] >> 16);
    ready = ready && ca == before;
    before = ca;
    F4 boxes[4];  // of b's cluster in a's axes, of a's in b's
    if (box_apart(a, ca, b_to_a, b, cb, boxes[2], boxes[3]) ||
        box_apart(b, cb, a_to_b, a, ca, boxes[0], boxes[1]))
      continue;
    float box[4][4];
    __builtin_memcpy(box, boxes, sizeof box);
    ++t.work[2];
    if (clusters_cross(a, ca, b, cb, a_to_b, box[0], box[1], box[2], box[3], moved_a, ready,
                       t.work)) {
      memory.cluster[0] = ca;
      memory.cluster[1] = cb;
      return true;
    }
  }
  return false;
}
