#include "planner/search/rrt_connect.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planner/batch/nearest_point.h"
#include "common/math/splitmix64.h"
#include "common/math/index.h"

namespace twinbus::inline planner {

namespace {

constexpr float kFirstRadius = 4.0F, kLeastRadius = 1.0F, kRadiusChange = 1e-4F;
constexpr float kLongest = 1.0F;  // step of one arm [rad]
constexpr float kOneArm = 7.0F;   // joints
constexpr float kFarAway = 1e6F;
constexpr int kAskEvery = 64;  // rounds between questions whether to go on
constexpr float kInfinite = std::numeric_limits<float>::infinity();

// The index-th number of the van der Corput sequence of a base: its digits mirrored at the point.
float mirrored(std::uint64_t index, unsigned base) {
  double digit = 1.0, value = 0.0;
  for (; index > 0; index /= base) {
    digit /= base;
    value += digit * static_cast<double>(index % base);
  }
  return static_cast<float>(value);
}

constexpr std::array<unsigned, kMostPlanned> kBases{3,  5,  7,  11, 13, 17, 19, 23, 29, 31, 37, 41,
                                                    43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97};

}  // namespace

float distance(const SearchPoint& a, const SearchPoint& b, int joints) noexcept {
  float sum = 0.0F;
  for (std::size_t j = 0; j < at(joints); ++j) sum += (a[j] - b[j]) * (a[j] - b[j]);
  return std::sqrt(sum);
}

float length_of(const SearchPath& path, int joints) noexcept {
  float sum = 0.0F;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) sum += distance(path[i], path[i + 1], joints);
  return sum;
}

bool LineTest::between(const SearchPoint& a, const SearchPoint& b, int joints) {
  SearchPoint step{};
  for (std::size_t j = 0; j < at(joints); ++j) step[j] = b[j] - a[j];
  return free(a, step, distance(a, b, joints));
}

void JointSearch::Tree::clear() {
  points.clear();
  parents.clear();
  radii.clear();
}

int JointSearch::Tree::add(const SearchPoint& q, int parent, int joints) {
  const int index = static_cast<int>(points.size());
  if (index >= stride) {  // grow: columns move apart
    const int wider = std::max(256, 2 * stride);
    std::vector<float> moved(at(joints * wider), kFarAway);
    for (int j = 0; j < joints; ++j) {
      std::copy_n(columns.begin() + j * stride, stride, moved.begin() + j * wider);
    }
    columns = std::move(moved);
    stride = wider;
  }
  for (int j = 0; j < joints; ++j) {
    float* column = columns.data() + j * stride;
    column[index] = q[at(j)];
    if (index % 8 == 0) std::fill(column + index + 1, column + index + 8, kFarAway);
  }
  points.push_back(q);
  parents.push_back(parent);
  radii.push_back(kInfinite);
  return index;
}

int JointSearch::Tree::nearest(const SearchPoint& q, int joints, float& gap) const {
  const int index =
      nearest_point(columns.data(), stride, static_cast<int>(points.size()), joints, q.data(), gap);
  gap = std::sqrt(gap);
  return index;
}

// Node first, root last.
void JointSearch::Tree::branch(int node, SearchPath& path) const {
  for (; node >= 0; node = parents[at(node)]) path.push_back(points[at(node)]);
}

JointSearch::JointSearch(SearchLimits limits)
    : limits_(std::move(limits)), joints_(static_cast<int>(limits_.lower.size())) {
  const float arms = std::max(1.0F, static_cast<float>(joints_) / kOneArm);
  first_radius_ = kFirstRadius * std::sqrt(arms);
  least_radius_ = kLeastRadius * std::sqrt(arms);
  if (!(limits_.range > 0.0F)) limits_.range = kLongest / arms;
}

const SearchPoint& JointSearch::sample() {
  if (next_ == table_.size()) {
    SearchPoint q{};
    // Seeds start far apart in the sequence.
    const std::uint64_t offset = limits_.seed == 0 ? 0 : SplitMix64(limits_.seed).next() % 1000000;
    for (int j = 0; j < joints_; ++j) {
      const float low = limits_.lower[at(j)], high = limits_.upper[at(j)];
      q[at(j)] = low + (high - low) * mirrored(offset + next_ + 1, kBases[at(j)]);
    }
    table_.push_back(q);
  }
  return table_[next_++];
}

int JointSearch::extend(LineTest& test, Tree& tree, const SearchPoint& to) {
  float gap = 0.0F;
  const int near = tree.nearest(to, joints_, gap);
  float& radius = tree.radii[at(near)];
  if (radius < gap || !(gap > 0.0F)) return -1;
  const SearchPoint& from = tree.points[at(near)];
  const float share = gap < limits_.range ? 1.0F : limits_.range / gap;
  SearchPoint step{}, tip{};
  for (std::size_t j = 0; j < at(joints_); ++j) {
    step[j] = (to[j] - from[j]) * share;
    tip[j] = from[j] + step[j];
  }
  if (!test.free(from, step, gap * share)) {
    radius = std::isinf(radius) ? first_radius_ : std::max(radius * (1.0F - kRadiusChange), least_radius_);
    return -1;
  }
  if (!std::isinf(radius)) radius *= 1.0F + kRadiusChange;
  return tree.add(tip, near, joints_);
}

// In equal steps; the last node reached is `to`, or -1.
int JointSearch::connect(LineTest& test, Tree& tree, const SearchPoint& to) {
  float gap = 0.0F;
  int node = tree.nearest(to, joints_, gap);
  const int steps = std::max(1, static_cast<int>(std::ceil(gap / limits_.range)));
  SearchPoint tip = tree.points[at(node)], step{};
  for (std::size_t j = 0; j < at(joints_); ++j)
    step[j] = (to[j] - tip[j]) / static_cast<float>(steps);
  for (int i = 0; i < steps; ++i) {
    if (!test.free(tip, step, gap / static_cast<float>(steps))) return -1;
    for (std::size_t j = 0; j < at(joints_); ++j) tip[j] += step[j];
    if (i + 1 == steps) tip = to;
    node = tree.add(tip, node, joints_);
  }
  return node;
}

SearchPath JointSearch::find(LineTest& test, const SearchPoint& start, const SearchPath& goals,
                             bool (*keep_on)(void*), void* user) {
  rounds_ = 0;
  next_ = 0;
  for (const SearchPoint& goal : goals) {
    if (test.between(start, goal, joints_)) return {start, goal};
  }
  from_start_.clear();
  from_goals_.clear();
  from_start_.add(start, -1, joints_);
  for (const SearchPoint& goal : goals) from_goals_.add(goal, -1, joints_);
  Tree* grow = &from_goals_;
  Tree* meet = &from_start_;
  while (rounds_ < limits_.most_rounds) {
    if (keep_on != nullptr && rounds_ % kAskEvery == 0 && !keep_on(user)) break;
    ++rounds_;
    // The smaller tree grows next.
    const float mine = static_cast<float>(grow->points.size());
    const float theirs = static_cast<float>(meet->points.size());
    if (std::fabs(mine - theirs) < mine) std::swap(grow, meet);
    const int node = extend(test, *grow, sample());
    if (node < 0) continue;
    const int met = connect(test, *meet, grow->points[at(node)]);
    if (met < 0) continue;
    SearchPath path;
    grow->branch(node, path);
    std::reverse(path.begin(), path.end());
    meet->branch(meet->parents[at(met)], path);  // met repeats node
    if (grow == &from_goals_) std::reverse(path.begin(), path.end());
    return path;
  }
  return {};
}

}  // namespace twinbus::planner
