// The articulated inertia of link 0, which nothing holds: factored, and solved with.  No include guard:
// articulated_kernels.h includes this once for each instruction set, in a namespace of its own.

// What lanes have together, or each, if each is a robot of its own.
template <class N, class L>
TWINBUS_INLINE N of_robots(const L& lanes) {
  if constexpr (std::is_same_v<N, L>) {
    return lanes;
  } else {
    return sum_of_lanes(lanes);
  }
}

// L D L' of link 0's articulated inertia.
template <class N, class L>
inline bool factor_root(RootFactors<N>& state, const Inertia<L>& of_lanes) noexcept {
  N inertia[21];
  const L* lanes = reinterpret_cast<const L*>(&of_lanes);
#pragma GCC unroll 21
  for (int k = 0; k < 21; ++k) inertia[k] = of_robots<N>(lanes[k]);
  // Of the lower triangle, by row: where it is among the members of Inertia.
  static constexpr int kAt[6][6] = {
      {0}, {1, 3}, {2, 4, 5}, {6, 7, 8, 15}, {9, 10, 11, 16, 18}, {12, 13, 14, 17, 19, 20}};
  const N none = {}, one = broadcast<N>(1.0);
  N& wrong = state.wrong = none;
#pragma GCC unroll 6
  for (int c = 0; c < 6; ++c) {
    N scaled[6];  // of row c, times D
    N d = inertia[kAt[c][c]];
#pragma GCC unroll 6
    for (int k = 0; k < c; ++k) {
      scaled[k] = state.root[c][k] * state.root_d[k];
      d -= state.root[c][k] * scaled[k];
    }
    wrong += d > 0.0 ? none : one;
    state.root_d[c] = d;
    state.root_inverse[c] = one / d;
#pragma GCC unroll 6
    for (int r = c + 1; r < 6; ++r) {
      N sum = inertia[kAt[r][c]];
#pragma GCC unroll 6
      for (int k = 0; k < c; ++k) sum -= state.root[r][k] * scaled[k];
      state.root[r][c] = sum * state.root_inverse[c];
    }
  }
  return !(sum_of_lanes(wrong) > 0.0);
}

template <class N>
inline void solve_root(const RootFactors<N>& state, N (&x)[6]) noexcept {
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
