// Planes between groups and obstacles, and between two groups: what settles the matter where balls touch.  Included once per
// instruction set, inside a namespace, by check.cpp: no #pragma once.

// Of the corners of a piece the one that is lowest along d, a lane each; of several the first.
TWINBUS_INLINE void lowest_corner(const float* corners, const BlockPiece& piece, const Lanes* d,
                                  Lanes* to) {
  const float *x = corners, *y = x + piece.room, *z = y + piece.room;
#ifdef TWINBUS_BLOCK_AVX512
  // Two corners at once: the even ones in the lower half, the odd ones in the upper.
  const __m512 dx = twice(d[0]), dy = twice(d[1]), dz = twice(d[2]);
  __m512 low = _mm512_set1_ps(1e30F);
  __m512i lowest = _mm512_setzero_si512();
  const __m512i two = _mm512_set1_epi32(2);
  __m512i number = _mm512_setr_epi32(0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1);
  for (int first = 0; first < piece.count; first += 16) {
    const __m512 x16 = _mm512_loadu_ps(x + first), y16 = _mm512_loadu_ps(y + first),
                 z16 = _mm512_loadu_ps(z + first);
    for (int k = first; k < first + 16 && k < piece.count; k += 2) {
      // The lowest four bits of a number choose among sixteen.
      const __m512 height = dx * _mm512_maskz_permutexvar_ps(0xFFFF, number, x16) +
                            dy * _mm512_maskz_permutexvar_ps(0xFFFF, number, y16) +
                            dz * _mm512_maskz_permutexvar_ps(0xFFFF, number, z16);
      const __mmask16 lower = _mm512_cmp_ps_mask(height, low, _CMP_LT_OQ);
      low = _mm512_maskz_min_ps(0xFFFF, height, low);  // does not wait for the mask
      lowest = _mm512_mask_mov_epi32(lowest, lower, number);
      number = _mm512_add_epi32(number, two);
    }
  }
  const Lanes even = half_of<Lanes>(low, 0), odd = half_of<Lanes>(low, 1);
  const Flags of_even = half_of<Flags>(lowest, 0), of_odd = half_of<Flags>(lowest, 1);
  const Flags best = (odd < even) | ((odd == even) & (of_odd < of_even)) ? of_odd : of_even;
#else
  Lanes low = all(1e30F);
  Flags best{};
  for (int k = 0; k < piece.count; ++k) {
    const Lanes height = d[0] * all(x[k]) + d[1] * all(y[k]) + d[2] * all(z[k]);
    const Flags lower = height < low;
    low = least(height, low);
    best = lower ? Flags{} + k : best;
  }
#endif
  float found[3][8];
  for (int lane = 0; lane < 8; ++lane) {
    found[0][lane] = x[best[lane]];
    found[1][lane] = y[best[lane]];
    found[2][lane] = z[best[lane]];
  }
  for (int i = 0; i < 3; ++i) to[i] = load(found[i]);
}

// Of the corners of a piece the one that is lowest along n, in the world.
TWINBUS_INLINE void lowest_point(const BlockRobot& robot, const BlockWork& w, int body, const BlockPiece& piece, const Lanes* n,
                                 Lanes* to) {
  const Lanes* r = w.rotation[body];
  Lanes d[3], at[3];
  for (int i = 0; i < 3; ++i)
    d[i] = body == 0 ? n[i] : r[i] * n[0] + r[3 + i] * n[1] + r[6 + i] * n[2];
  lowest_corner(robot.corners.data() + piece.first, piece, d, at);
  for (int i = 0; i < 3; ++i) {
    to[i] = body == 0 ? at[i]
                      : r[3 * i] * at[0] + r[3 * i + 1] * at[1] + r[3 * i + 2] * at[2] + w.origin[body][i];
  }
}

// What a group is parted from: an obstacle, or the hull of another group.
struct ObstacleSide {
  const BlockShape& shape;
  TWINBUS_INLINE void first(const Lanes* from, Lanes* n) const { first_normal(shape, from, n); }
  TWINBUS_INLINE void highest(const Lanes* n, Lanes* to) const { highest_point(shape, n, to); }
};
struct GroupSide {
  const BlockRobot& robot;
  const BlockWork& w;
  int group;
  const BlockPiece& piece;
  TWINBUS_INLINE void first(const Lanes* from, Lanes* n) const {
    const Lanes* p = w.around[group];
    const Lanes d[3] = {from[0] - p[0], from[1] - p[1], from[2] - p[2]};
    const Lanes unit = all(1.0F) / most(root(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), all(1e-6F));
    for (int i = 0; i < 3; ++i) n[i] = d[i] * unit;
  }
  TWINBUS_INLINE void highest(const Lanes* n, Lanes* to) const {
    const Lanes down[3] = {-n[0], -n[1], -n[2]};
    lowest_point(robot, w, robot.groups[static_cast<std::size_t>(group)].body, piece, down, to);
  }
};

// Are some corners of group g and the other side on two sides of a plane?  far: by more than a margin of
// `fixed` and, along the plane's normal, of `moves`; separate: at all.  Looks for it as Gilbert,
// Johnson and Keerthi (1988) do: across the way from zero to the nearest point of what is known of
// the difference of the two.  Stops when the lanes that are asked are far or cannot be, and with
// `one` as soon as one of them is seen to touch.
template <class Side>
inline void separate_piece(const BlockRobot& robot, const BlockWork& w, int g,
                           const BlockPiece& piece, const Lanes* middle, const Side& side,
                           const Lanes& fixed, const Lanes* moves, const Flags& asked, bool one,
                           Flags& far, Flags& separate) {
  const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
  far = separate = Flags{};
  const Lanes least_gap = all(kRounding + robot.grow);
  Lanes3 n, known[3];
  Lanes length = all(1e30F);
  Flags meet = {}, open = asked;
  side.first(middle, n);
  constexpr int kTurns = 20;  // fewer than one in a hundred needs more than ten
  for (int turn = 0; turn < kTurns; ++turn) {
    // Of the group, the corner that is lowest along n; of the other side, the highest point.
    Lanes3 e, b;
    lowest_point(robot, w, group.body, piece, n, e);
    side.highest(n, b);
    for (int i = 0; i < 3; ++i) e[i] -= b[i];
    const Lanes gap = dot(e, n);
    Lanes margin = fixed;
    if (moves != nullptr) margin += size_of(n[0] * moves[0] + n[1] * moves[1] + n[2] * moves[2]);
    far |= gap > margin;
    separate |= gap > least_gap;
    open &= ~far;
    if (!any(open)) return;
    if (turn == 0) {
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) known[k][i] = e[i];
    }
    NearestOfFour nearest;
    nearest_of_four(e, known, nearest);
    const Lanes now = root(dot(nearest.v, nearest.v));
    // The two are no farther apart than what is nearest so far.
    meet |= nearest.inside | (now <= least_gap);
    open &= ~meet & (now < length) & ~((now <= fixed) & separate);
    if (!any(open) || (one && any(asked & meet))) return;
    length = now;
    const Lanes unit = all(1.0F) / now;
    for (int i = 0; i < 3; ++i) {
      n[i] = nearest.v[i] * unit;
      for (int k = 0; k < 3; ++k) known[k][i] = nearest.part[k] > all(0.0F) ? known[k][i] : e[i];
    }
  }
}

// The same of the whole group: its hull, or, where that touches, each of its pieces.
inline void separate(const BlockRobot& robot, const BlockWork& w, int g, const BlockShape& shape,
                     const Lanes& fixed, const Lanes* moves, const Flags& asked, Flags& far,
                     Flags& separate) {
  const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
  far = separate = Flags{};
  if (group.piece_count == 0) return;
  const BlockPiece* pieces = robot.pieces.data() + group.first_piece;
  const bool whole = !w.by_pieces || group.piece_count == 1;
  const ObstacleSide side{shape};
  separate_piece(robot, w, g, pieces[0], w.around[g], side, fixed, moves, asked, whole, far,
                 separate);
  const Flags rest = asked & ~separate;
  if (whole || !any(rest)) return;
  Lanes margin = fixed;
  if (moves != nullptr)
    margin += root(moves[0] * moves[0] + moves[1] * moves[1] + moves[2] * moves[2]);
  Flags all_far = ~Flags{}, all_separate = ~Flags{};
  for (int i = 1; i < group.piece_count; ++i) {
    Lanes middle[3];
    place(w, group.body, pieces[i].around, middle);
    const Flags near = meets(shape, middle, all(pieces[i].around.radius) + margin) & rest;
    if (!any(near)) continue;
    Flags piece_far, piece_separate;
    separate_piece(robot, w, g, pieces[i], middle, side, fixed, moves, near, true, piece_far,
                   piece_separate);
    all_far &= piece_far | ~near;
    all_separate &= piece_separate | ~near;
  }
  far |= rest & all_far;
  separate |= rest & all_separate;
}

// Is the convex body of group g clear of the shape in all lanes where balls touch?
TWINBUS_INLINE bool settled(const BlockRobot& robot, const BlockWork& w, int g,
                            const BlockShape& shape, Flags touched) {
  Flags far, apart_at_all;
  separate(robot, w, g, shape, all(kRounding + robot.grow), nullptr, touched, far, apart_at_all);
  return !any(touched & ~far);
}

// The hulls of two groups; without hulls nothing is.
inline void separate_pair(const BlockRobot& robot, const BlockWork& w, int a, int b, const Lanes& fixed, const Lanes* moves,
                          const Flags& asked, Flags& far, Flags& separate) {
  const BlockGroup& ga = robot.groups[static_cast<std::size_t>(a)];
  const BlockGroup& gb = robot.groups[static_cast<std::size_t>(b)];
  far = separate = Flags{};
  if (!w.pairs_by_hulls || ga.piece_count == 0 || gb.piece_count == 0) return;
  const GroupSide side{robot, w, b, robot.pieces[static_cast<std::size_t>(gb.first_piece)]};
  separate_piece(robot, w, a, robot.pieces[static_cast<std::size_t>(ga.first_piece)], w.around[a], side, fixed, moves, asked,
                 true, far, separate);
}
