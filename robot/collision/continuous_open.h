// The kernel of SweptShapes::open, a lane for every place; included after continuous_lanes.h.

TWINBUS_INLINE F8 with_next(F8 gap) noexcept {
  return least(gap, __builtin_shufflevector(gap, gap, 1, 2, 3, 4, 5, 6, 7, 7));
}

// What the ways leave out, seen from link 0, or the less of that and of what the link that both hang on sees.
struct LeftOut8 {
  F8 from_base, either;
  bool found = false;
};
TWINBUS_INLINE F8 less_left_out(const SweptTables& t, const SweptPair& pair, LeftOut8& left) noexcept {
  if (!left.found) {
    left.found = true;
    left.either = pair.common != 0 ? least(left.from_base, pair_left_out(t, pair)) : left.from_base;
  }
  return left.either;
}

// Is so much left of these gaps all along?
TWINBUS_INLINE bool outlasts(const SweptTables& t, const SweptPair& pair, F8 gap, float margin, float clear,
                             LeftOut8& left) noexcept {
  if (bits(gap >= margin) != kAllLanes) return false;
  const F8 between = with_next(gap) - clear;
  return bits(between >= left.from_base) == kAllLanes || bits(between >= less_left_out(t, pair, left)) == kAllLanes;
}

// Do corners leave enough where boxes do not?  First those that matter where boxes leave least: what they rule out more corners
// cannot mend.
TWINBUS_INLINE bool corners_part(const SweptTables& t, const SweptPair& pair, const Along8& along, F8 box, float margin,
                                 float clear, F8 left_out) noexcept {
  const F8 before = __builtin_shufflevector(left_out, left_out, 0, 0, 1, 2, 3, 4, 5, 6);
  const auto lacks = [&](F8 gap) {
    return kAllLanes & ~bits((gap >= margin) & (gap - clear >= left_out) & (gap - clear >= before));
  };
  const F8 next = with_next(box), room = least(box - margin, next - (left_out + clear));
  int place = lowest(bits(room <= -largest(-room)));
  if ((bits(next < box) >> place & 1U) != 0) ++place;
  CornerGaps8 by = corner_gaps8(t, pair, along);
  const unsigned needed = lacks(box);
  for (const unsigned lanes : {1U << place, needed}) {
    if ((lacks(gaps_of(t, pair, along, lanes, by)) & needed) != 0) return false;
  }
  return true;
}

// Boxes first, which part most; then balls inside of hulls: what they rule out no corner can mend; then corners.
TWINBUS_INLINE bool parts_all_along(const SweptTables& t, const SweptPair& pair, const float* n0,
                                    float margin, float clear, LeftOut8& left) noexcept {
  const Along8 along = along8(t, pair, n0);
  const bool hulls = t.part[pair.a].corners + t.part[pair.b].corners > 0;
  const auto parts = [&](F8 gap) { return outlasts(t, pair, gap, margin, clear, left); };
  const F8 box = gaps8(t, pair, along, HullBy::kBox);
  if (parts(box)) return true;
  if (!hulls || !parts(gaps8(t, pair, along, HullBy::kInside))) return false;
  return corners_part(t, pair, along, box, margin, clear, less_left_out(t, pair, left));
}

// Does the direction that is remembered, or the one that is seen, part them?  That one is remembered then.
TWINBUS_INLINE bool stays_apart(const SweptTables& t, SweptPair& pair, const float* towards, float margin,
                                float clear) noexcept {
  const SweptPart &one = t.part[pair.a], &other = t.part[pair.b];
  const float *a = t.part_pose + 96 * pair.a + 72, *b = t.part_pose + 96 * pair.b + 72;
  const float sum = one.radius + other.radius + margin + t.half_travel[pair.link_a] + t.half_travel[pair.link_b] +
                    kSweptSlack;
  F8 far2 = all(0.0F);
  for (int d = 0; d < 3; ++d) {
    const F8 far = load8(b + 8 * d) - load8(a + 8 * d);
    far2 += far * far;
  }
  if (bits(far2 >= all(1.0001F * sum * sum)) == kAllLanes) return true;
  LeftOut8 left{load8(t.link_left_out + 8 * pair.link_a) + load8(t.link_left_out + 8 * pair.link_b), {}};
  const F8 along_any = root(far2) * 1.0001F + (one.beyond_middle + other.beyond_middle + kSweptSlack);
  if (!outlasts(t, pair, along_any, margin, clear, left)) return false;
  if (parts_all_along(t, pair, pair.n, margin, clear, left)) return true;
  const float* frame = t.link_pose + 96 * pair.common;  // at the first place
  float seen[3], length2 = 0.0F;
  for (int k = 0; k < 3; ++k) {
    seen[k] = frame[8 * 3 * k] * towards[0] + frame[8 * (3 * k + 1)] * towards[1] + frame[8 * (3 * k + 2)] * towards[2];
    length2 += seen[k] * seen[k];
  }
  if (!(length2 > 1e-8F)) return false;
  const float length = __builtin_sqrtf(length2);
  for (float& x : seen) x /= length;
  if (!parts_all_along(t, pair, seen, margin, clear, left)) return false;
  for (int k = 0; k < 3; ++k) pair.n[k] = seen[k];
  return true;
}

static int open_pairs(const SweptTables& t, const NearShapes::Candidate* shapes, int count,
                      float margin, float clear, int* open, int capacity) noexcept {
  int found = 0;
  for (int i = 0; i < count && found <= capacity; ++i) {
    const int number = t.pair_of[shapes[i].a * t.parts + shapes[i].b];
    if (stays_apart(t, t.pair[number], shapes[i].towards, margin, clear)) continue;
    if (found < capacity) open[found] = number;
    ++found;
  }
  return found;
}
