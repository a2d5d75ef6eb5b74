// The articulated inertia of link 0, which nothing holds: factored, and solved with.  No include guard:
// articulated_body.cpp includes this once for each instruction set, in a namespace of its own.

// L D L' of link 0's articulated inertia.
template <class L>
inline bool factor_root(BodyState& state, const Inertia<L>& of_lanes) noexcept {
  double inertia[21];
  const L* lanes = reinterpret_cast<const L*>(&of_lanes);
#pragma GCC unroll 21
  for (int k = 0; k < 21; ++k) inertia[k] = sum_of_lanes(lanes[k]);
  // Of the lower triangle, by row: where it is among the members of Inertia.
  static constexpr int kAt[6][6] = {
      {0}, {1, 3}, {2, 4, 5}, {6, 7, 8, 15}, {9, 10, 11, 16, 18}, {12, 13, 14, 17, 19, 20}};
  bool sound = true;
#pragma GCC unroll 6
  for (int c = 0; c < 6; ++c) {
    double scaled[6];  // of row c, times D
    double d = inertia[kAt[c][c]];
#pragma GCC unroll 6
    for (int k = 0; k < c; ++k) {
      scaled[k] = state.root[c][k] * state.root_d[k];
      d -= state.root[c][k] * scaled[k];
    }
    sound = sound && d > 0.0;
    state.root_d[c] = d;
    state.root_inverse[c] = 1.0 / d;
#pragma GCC unroll 6
    for (int r = c + 1; r < 6; ++r) {
      double sum = inertia[kAt[r][c]];
#pragma GCC unroll 6
      for (int k = 0; k < c; ++k) sum -= state.root[r][k] * scaled[k];
      state.root[r][c] = sum * state.root_inverse[c];
    }
  }
  return sound;
}

inline void solve_root(const BodyState& state, double (&x)[6]) noexcept {
#pragma GCC unroll 6
  for (int r = 1; r < 6; ++r) {
#pragma GCC unroll 6
    for (int k = 0; k < r; ++k) x[r] -= state.root[r][k] * x[k];
  }
#pragma GCC unroll 6
  for (int r = 0; r < 6; ++r) x[r] *= state.root_inverse[r];
#pragma GCC unroll 6
  for (int r = 4; r >= 0; --r) {
#pragma GCC unroll 6
    for (int k = r + 1; k < 6; ++k) x[r] -= state.root[k][r] * x[k];
  }
}
