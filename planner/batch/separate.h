// Planes between groups and obstacles, and between two groups: what settles the matter where balls touch.  Included once per
// instruction set, inside a namespace, by check.cpp: no #pragma once.

// What hulls and pieces of a pair, or of a group and an obstacle, keep [m].
TWINBUS_INLINE float kept_of_pair(const BlockRobot& robot, int pair) {
  return robot.kept_of_pairs.empty() ? robot.grow : robot.kept_of_pairs[static_cast<std::size_t>(pair)];
}
TWINBUS_INLINE float kept_of_shape(const BlockRobot& robot, int g, int shape) {
  for (const BlockMargin& margin : robot.kept_of_shapes) {
    if (margin.group == g && margin.shape == shape) return margin.kept;
  }
  return robot.grow;
}

// Are a piece of a body and the other side on two sides of a plane?  far: by more than a margin of `fixed` and, along the
// plane's normal, of `moves`, or on all of the sweep; separate: at all.  Looks for it as Gilbert,
// Johnson and Keerthi (1988) do: across the way from zero to the nearest point of what is known of
// the difference of the two.  Stops when the lanes that are asked are far or cannot be, and with
// `one` as soon as one of them is seen to touch.
template <class Side>
inline void separate_piece(const BlockRobot& robot, const BlockWork& w, int body,
                           const BlockPiece& piece, const Lanes* middle, const Side& side,
                           float kept, const Lanes& fixed, const Lanes* moves, const Sweep* sweep, const Flags& asked, bool one,
                           Flags& far, Flags& separate) {
  far = separate = Flags{};
  const Lanes least_gap = all(kRounding + kept);
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
                     float kept, const Lanes& fixed, const Lanes* moves, const Sweep* sweep, const Flags& asked, Flags& far,
                     Flags& separate) {
  const BlockGroup& group = robot.groups[static_cast<std::size_t>(g)];
  far = separate = Flags{};
  if (group.piece_count == 0) return;
  const BlockPiece& hull = robot.pieces[static_cast<std::size_t>(group.first_piece)];
  const bool whole = !w.by_pieces || !w.fine[g] || group.piece_count == 1;
  const ObstacleSide side{shape};
  separate_piece(robot, w, group.body, hull, w.around[g], side, kept, fixed, moves, sweep, asked, whole, far,
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
    separate_piece(robot, w, group.body, piece, middle, side, kept, fixed, moves, sweep, near, true, piece_far,
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
  const float kept = kept_of_pair(robot, pair);
  if (!w.pairs_by_hulls || ga.piece_count == 0 || gb.piece_count == 0) return;
  const BlockPiece &hull_a = robot.pieces[static_cast<std::size_t>(ga.first_piece)],
                   &hull_b = robot.pieces[static_cast<std::size_t>(gb.first_piece)];
  const bool whole = !w.by_pieces || !w.fine_pair[pair] || (ga.piece_count == 1 && gb.piece_count == 1);
  const auto& around_b = w.around[b];
  const GroupSide side_b{robot, w, gb.body, hull_b, around_b};
  separate_piece(robot, w, ga.body, hull_a, w.around[a], side_b, kept, fixed, moves, sweep, asked, whole, far, separate);
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
    return any(near_of(middle_a, ball.radius, around_b, gb.around.radius));
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
      separate_piece(robot, w, ga.body, piece_a, middle_a, side, kept, fixed, moves, sweep, near, true, piece_far,
                     piece_separate);
      all_far &= piece_far | ~near;
      all_separate &= piece_separate | ~near;
      rest &= all_far | all_separate;
    });
  };
  const Flags wanted = rest;
  const auto use_of_a = [&](const BlockPiece& piece_a) {
    place(w, ga.body, piece_a.around, middle_a);
    const Flags near = near_of(middle_a, piece_a.around.radius, around_b, gb.around.radius);
    if (!any(near)) return;
    Flags piece_far, piece_separate;
    separate_piece(robot, w, ga.body, piece_a, middle_a, side_b, kept, fixed, moves, sweep, near, false, piece_far,
                   piece_separate);
    const Flags deep = gb.piece_count > 1 ? near & ~piece_separate : Flags{};  // a hull alone has the last word
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
