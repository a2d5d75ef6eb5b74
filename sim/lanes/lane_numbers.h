// Arithmetic of one number of four worlds: a Vec4, and masks of lanes.  No include guard: lane_kernels.cpp
// includes this once for each instruction set, in a namespace of its own.

using Lanes = decltype(Vec4{} < Vec4{});

TWINBUS_INLINE Vec4 all(double x) { return Vec4{} + x; }
TWINBUS_INLINE Vec4 size_of(const Vec4& x) { return x < 0.0 ? -x : x; }
TWINBUS_INLINE Vec4 larger(const Vec4& a, const Vec4& b) { return a > b ? a : b; }
TWINBUS_INLINE Vec4 smaller(const Vec4& a, const Vec4& b) { return a < b ? a : b; }
TWINBUS_INLINE Vec4 root_of(Vec4 x) {
  for (int k = 0; k < kWorldLanes; ++k) x[k] = std::sqrt(x[k]);
  return x;
}
TWINBUS_INLINE bool any(const Lanes& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }
TWINBUS_INLINE int bits(const Lanes& mask) {
  return (mask[0] != 0 ? 1 : 0) | (mask[1] != 0 ? 2 : 0) | (mask[2] != 0 ? 4 : 0) | (mask[3] != 0 ? 8 : 0);
}
TWINBUS_INLINE void choose(const Lanes& mask, const Vec4& value, Vec4& to) { to = mask ? value : to; }
TWINBUS_INLINE void choose(const Lanes& mask, const Three<Vec4>& value, Three<Vec4>& to) {
  choose(mask, value.x, to.x);
  choose(mask, value.y, to.y);
  choose(mask, value.z, to.z);
}
TWINBUS_INLINE void write(std::vector<double>& numbers, std::size_t rank, const Vec4& value) {
  std::memcpy(numbers.data() + rank * kWorldLanes, &value, sizeof value);
}
TWINBUS_INLINE Vec4 reach_in(const Vec4& speed, double h) { return h * (2.0 * speed + kMostAcceleration * h) + kMargin; }
TWINBUS_INLINE Vec4 sum_of_sizes(const Three<Vec4>& v) { return size_of(v.x) + size_of(v.y) + size_of(v.z); }
