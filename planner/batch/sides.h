// What planes are looked for between: corners of pieces, the two sides, and how they move.  Included once per instruction set,
// inside a namespace, by check.cpp: no #pragma once.

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
