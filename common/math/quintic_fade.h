// How a difference of position and velocity fades to nothing in a time T without a jump: the quintic
//
//     o(t) = e_q h0(s) + e_qd T h1(s),   s = t / T,   h0 = 1 - 10 s^3 + 15 s^4 - 6 s^5,   h1 = s - 6 s^3 + 8 s^4 - 3 s^5
//
// with o(0) = e_q, o'(0) = e_qd, and o, o', o'' zero at T.  The gate fades set-points so, and the guard foretells it.

#pragma once

namespace twinbus::inline common {

// h0, of any s >= 0.
inline double fade_left(double s) noexcept {
  const double s2 = s * s;
  const double s3 = s2 * s;
  return s < 1.0 ? 1.0 - s3 * (10.0 - 15.0 * s + 6.0 * s2) : 0.0;
}

struct QuinticFade {  // at an s from 0 to 1
  double h0 = 0.0, h1 = 0.0, h0_rate = 0.0, h1_rate = 0.0;  // rates: per unit of s
};

inline QuinticFade quintic_fade(double s) noexcept {
  const double s2 = s * s;
  const double s3 = s2 * s;
  const double s4 = s3 * s;
  return {fade_left(s), s - s3 * (6.0 - 8.0 * s + 3.0 * s2), -30.0 * s2 + 60.0 * s3 - 30.0 * s4,
          1.0 - 18.0 * s2 + 32.0 * s3 - 15.0 * s4};
}

}  // namespace twinbus::common
