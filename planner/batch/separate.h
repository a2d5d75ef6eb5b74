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
  int body;
  const BlockPiece& piece;
  const Lanes* middle;  // of the piece, in the world
  TWINBUS_INLINE void first(const Lanes* from, Lanes* n) const {
    const Lanes d[3] = {from[0] - middle[0], from[1] - middle[1], from[2] - middle[2]};
    const Lanes unit = all(1.0F) / most(root(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), all(1e-6F));
    for (int i = 0; i < 3; ++i) n[i] = d[i] * unit;
  }
  TWINBUS_INLINE void highest(const Lanes* n, Lanes* to) const {
    const Lanes down[3] = {-n[0], -n[1], -n[2]};
    lowest_point(robot, w, body, piece, down, to);
  }
};

// How a group and the other side move over an interval, from its middle to either end: a point x by drift + spin x x, to
// first order and in the frame of the last body that moves both, and by no more than `bend` beside that.
struct Sweep {
  Lanes bend;
  Lanes3 drift, spin, side_drift, side_spin;
  bool side_moves;
};

TWINBUS_INLINE void turned(const Lanes* n, const Lanes3& spin, float end, Lanes3& d) {
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    d[i] = n[i] + all(end) * (n[k] * spin[l] - n[l] * spin[k]);
  }
}

// From the highest point of the other side along n, `high` when it does not move, up to the lowest of the piece, where the
// two are nearest on their ways.  Between the ends they are no nearer: it is least of what is linear there.
template <class Side>
inline Lanes gap_on_way(const BlockRobot& robot, const BlockWork& w, int body, const BlockPiece& piece, const Side& side,
                        const Lanes& high, const Sweep& sweep, const Lanes3& n) {
  Lanes worst = all(1e30F);
  for (const float end : {1.0F, -1.0F}) {
    Lanes3 d, point;
    turned(n, sweep.spin, end, d);
    lowest_point(robot, w, body, piece, d, point);
    Lanes gap = dot(d, point) + all(end) * dot(n, sweep.drift) - high;
    if (sweep.side_moves) {
      turned(n, sweep.side_spin, end, d);
      side.highest(d, point);
      gap += high - dot(d, point) - all(end) * dot(n, sweep.side_drift);
    }
    worst = least(worst, gap);
  }
  return worst;
}

// Are a piece of a body and the other side on two sides of a plane?  far: by more than a margin of `fixed` and, along the
// plane's normal, of `moves`, or on all of the sweep; separate: at all.  Looks for it as Gilbert,
// Johnson and Keerthi (1988) do: across the way from zero to the nearest point of what is known of
// the difference of the two.  Stops when the lanes that are asked are far or cannot be, and with
// `one` as soon as one of them is seen to touch.
template <class Side>
inline void separate_piece(const BlockRobot& robot, const BlockWork& w, int body,
                           const BlockPiece& piece, const Lanes* middle, const Side& side,
                           const Lanes& fixed, const Lanes* moves, const Sweep* sweep, const Flags& asked, bool one,
                           Flags& far, Flags& separate) {
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
    lowest_point(robot, w, body, piece, n, e);
    side.highest(n, b);
    for (int i = 0; i < 3; ++i) e[i] -= b[i];
    const Lanes gap = dot(e, n), high = dot(b, n);
    Lanes margin = fixed;
    if (moves != nullptr) margin += size_of(n[0] * moves[0] + n[1] * moves[1] + n[2] * moves[2]);
    far |= gap > margin;
    separate |= gap > least_gap;
    open &= ~far;
    if (sweep != nullptr && any(open & (gap > sweep->bend + least_gap))) {
      far |= gap_on_way(robot, w, body, piece, side, high, *sweep, n) > sweep->bend + least_gap;
      open &= ~far;
    }
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

// Calls use(piece) for every piece of the group beside its hull; bunches of them are asked first: meets_ball(ball).
template <class Meets, class Use>
TWINBUS_INLINE void each_piece(const BlockRobot& robot, const BlockGroup& group, const Meets& meets_ball, const Use& use) {
  const BlockPiece* pieces = robot.pieces.data() + group.first_piece;
  const BlockBall* bunches = robot.bunches.data() + group.first_bunch;
  for (int first = 1; first < group.piece_count; first += kBunch, ++bunches) {
    if (!meets_ball(*bunches)) continue;
    for (int i = first; i < first + kBunch && i < group.piece_count; ++i) use(pieces[i]);
  }
}

// The same of the whole group: its hull, or, where that touches, each of its pieces.
inline void separate(const BlockRobot& robot, const BlockWork& w, int g, const BlockShape& shape,
                     const Lanes& fixed, const Lanes* moves, const Sweep* sweep, const Flags& asked, Flags& far,
                     Flags& separate) {
  const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
  far = separate = Flags{};
  if (group.piece_count == 0) return;
  const BlockPiece& hull = robot.pieces[static_cast<std::size_t>(group.first_piece)];
  const bool whole = !w.by_pieces || !w.fine[g] || group.piece_count == 1;
  const ObstacleSide side{shape};
  separate_piece(robot, w, group.body, hull, w.around[g], side, fixed, moves, sweep, asked, whole, far,
                 separate);
  const Flags rest = asked & ~separate;
  if (whole || !any(rest)) return;
  Lanes margin = fixed;
  if (moves != nullptr)
    margin += root(moves[0] * moves[0] + moves[1] * moves[1] + moves[2] * moves[2]);
  Flags all_far = ~Flags{}, all_separate = ~Flags{};
  Lanes middle[3];
  const auto meets_ball = [&](const BlockBall& ball) {
    place(w, group.body, ball, middle);
    return any(meets(shape, middle, all(ball.radius) + margin) & rest);
  };
  each_piece(robot, group, meets_ball, [&](const BlockPiece& piece) {
    place(w, group.body, piece.around, middle);
    const Flags near = meets(shape, middle, all(piece.around.radius) + margin) & rest;
    if (!any(near)) return;
    Flags piece_far, piece_separate;
    separate_piece(robot, w, group.body, piece, middle, side, fixed, moves, sweep, near, true, piece_far,
                   piece_separate);
    all_far &= piece_far | ~near;
    all_separate &= piece_separate | ~near;
  });
  far |= rest & all_far;
  separate |= rest & all_separate;
}

// The hulls of two groups, or, where they touch, their pieces; without hulls nothing is.
inline void separate_pair(const BlockRobot& robot, const BlockWork& w, int pair, const Lanes& fixed, const Lanes* moves,
                          const Sweep* sweep, const Flags& asked, Flags& far, Flags& separate) {
  const auto [a, b] = robot.pairs[static_cast<std::size_t>(pair)];
  const BlockGroup& ga = robot.groups[static_cast<std::size_t>(a)];
  const BlockGroup& gb = robot.groups[static_cast<std::size_t>(b)];
  far = separate = Flags{};
  if (!w.pairs_by_hulls || ga.piece_count == 0 || gb.piece_count == 0) return;
  const BlockPiece &hull_a = robot.pieces[static_cast<std::size_t>(ga.first_piece)],
                   &hull_b = robot.pieces[static_cast<std::size_t>(gb.first_piece)];
  const bool whole = !w.by_pieces || !w.fine_pair[pair] || (ga.piece_count == 1 && gb.piece_count == 1);
  const GroupSide side_b{robot, w, gb.body, hull_b, w.around[b]};
  separate_piece(robot, w, ga.body, hull_a, w.around[a], side_b, fixed, moves, sweep, asked, whole, far, separate);
  Flags rest = asked & ~separate;
  if (whole || !any(rest)) return;
  Lanes margin = fixed;
  if (moves != nullptr) margin += root(moves[0] * moves[0] + moves[1] * moves[1] + moves[2] * moves[2]);
  Flags all_far = ~Flags{}, all_separate = ~Flags{};
  Lanes middle_a[3], middle_b[3];
  const auto near_of = [&](const Lanes* p, float rp, const Lanes* q, float rq) {
    const Lanes sum = margin + all(rp + rq);
    return (apart(p, q) < sum * sum) & rest;
  };
  const auto asked_of_a = [&](const BlockBall& ball) {
    place(w, ga.body, ball, middle_a);
    return any(near_of(middle_a, ball.radius, w.around[b], gb.around.radius));
  };
  const auto each_of_b = [&](const BlockPiece& piece_a, const Flags& left) {
    const auto asked_of_b = [&](const BlockBall& ball) {
      place(w, gb.body, ball, middle_b);
      return any(near_of(middle_a, piece_a.around.radius, middle_b, ball.radius) & left);
    };
    each_piece(robot, gb, asked_of_b, [&](const BlockPiece& piece_b) {
      place(w, gb.body, piece_b.around, middle_b);
      const Flags near = near_of(middle_a, piece_a.around.radius, middle_b, piece_b.around.radius) & left;
      if (!any(near)) return;
      Flags piece_far, piece_separate;
      const GroupSide side{robot, w, gb.body, piece_b, middle_b};
      separate_piece(robot, w, ga.body, piece_a, middle_a, side, fixed, moves, sweep, near, true, piece_far, piece_separate);
      all_far &= piece_far | ~near;
      all_separate &= piece_separate | ~near;
      rest &= all_far | all_separate;
    });
  };
  const Flags wanted = rest;
  const auto use_of_a = [&](const BlockPiece& piece_a) {
    place(w, ga.body, piece_a.around, middle_a);
    const Flags near = near_of(middle_a, piece_a.around.radius, w.around[b], gb.around.radius);
    if (!any(near)) return;
    Flags piece_far, piece_separate;
    separate_piece(robot, w, ga.body, piece_a, middle_a, side_b, fixed, moves, sweep, near, false, piece_far, piece_separate);
    const Flags deep = near & ~piece_separate;
    all_far &= piece_far | ~near | deep;
    all_separate &= piece_separate | ~near | deep;
    if (any(deep)) each_of_b(piece_a, deep);
  };
  if (ga.piece_count == 1) {
    use_of_a(hull_a);
  } else {
    each_piece(robot, ga, asked_of_a, use_of_a);
  }
  far |= wanted & all_far;
  separate |= wanted & all_separate;
}
