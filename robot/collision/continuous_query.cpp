// What Collision says of the ways that may come after a posture: where on them shapes come near, and what
// is proved to stay apart.

#include <algorithm>
#include <cassert>
#include <limits>

#include "robot/collision/collision_impl.h"
#include "geometry/distance/convex_shape.h"
#include "common/math/index.h"

namespace twinbus::inline robot {

namespace {

using Eigen::Vector3d;

constexpr int kPlaces = SweptShapes::kPlaces;
constexpr unsigned kAllPlaces = (1U << kPlaces) - 1U, kAllWays = kAllPlaces >> 1U;
// Distances on a way are measured up to here; what is farther apart needs no more [m].
constexpr double kFar = 0.5;
constexpr double kFine = 1e-9;       // in double precision [m]
constexpr int kFew = 3, kMany = 10;  // pairs left; of so many the way is cheaper than directions
constexpr int kDirections = 6;       // asked for after a posture
constexpr double kQuick = 0.25;      // of what travels as far a direction hardly parts any [m]
constexpr std::uint8_t kWait = 15;   // ways until a pair is asked for a direction again
constexpr double kClose = 1e-5;      // how exactly [m]
constexpr double kRounding = 5e-6;   // of where shapes are in single precision [m]

bool has(unsigned bits, int k) { return (bits >> static_cast<unsigned>(k) & 1U) != 0; }
unsigned only(int k) { return 1U << static_cast<unsigned>(k); }
unsigned if_so(bool is, int k) { return static_cast<unsigned>(is) << static_cast<unsigned>(k); }
double number(float x) { return static_cast<double>(x); }

// The place to measure next: where they may be nearest of those that may still say something, or -1.
int next_place(const Collision::PathPair& pair) noexcept {
  const unsigned useful = pair.open & ~pair.hopeless;
  const unsigned worth = (~pair.far | useful | useful << 1U) & ~pair.asked & kAllPlaces;
  int best = -1;
  float nearest = std::numeric_limits<float>::infinity();
  for (int k = 0; k < kPlaces; ++k) {
    const float here = has(worth, k) ? pair.least[at(k)] : std::numeric_limits<float>::infinity();
    best = here < nearest ? k : best;
    nearest = std::min(nearest, here);
  }
  return best;
}

}  // namespace

// Seen from link 0.
void Collision::Impl::let_joints_move(const Eigen::VectorXd& moves) noexcept {
  reach->from_base(moves, travel_to);
  for (std::size_t s = 0; s < link_shapes; ++s)
    travel_of[s] = travel_to[at(link_of_shape[s])] + kFine;
}

void Collision::Impl::let_shapes_move(const Ahead& moved) noexcept {
  let_joints_move(moved.moves);
  for (std::size_t s = 0; s < link_shapes; ++s)
    near_shapes.let_move(static_cast<int>(s), travel_of[s]);
}

// Obstacles stand in the world, in which link 0 may move: of them nothing is kept.
void Collision::Impl::walk_on(const Ahead& to) noexcept {
  const bool from_before = walks;
  walks = to.q.size() == walked_to.size();
  if (from_before && walks) {
    step = (to.q - walked_to).cwiseAbs();
    let_joints_move(step);
    for (std::size_t s = 0; s < link_shapes; ++s)
      near_shapes.walk(static_cast<int>(s), travel_of[s]);
  } else if (walks) {
    near_shapes.keep(static_cast<int>(link_shapes));
  }
  if (walks) walked_to = to.q;
  directions_left = kDirections;
}

// The better of two directions: that of the last distance, and between the axes of the capsules.
const Collision::Impl::Apart& Collision::Impl::apart_at(std::size_t candidate) noexcept {
  Apart& known = apart[candidate];
  if (known.known) return known;
  known.known = true;
  known.n.setZero();
  known.gap = -kFar;
  const ShapePair pair = shape_pair(ahead[candidate]);
  const auto pose = [&](const CollisionOwner& owner, const CollisionShape& body) {
    return owner.link >= 0 ? ahead_from->link_in_world(owner.link) * body.local : body.local;
  };
  const Eigen::Isometry3d a = pose(*pair.a, *pair.body_a), b = pose(*pair.b, *pair.body_b);
  const double length = pair.towards.norm();
  const Vector3d directions[] = {
      a.linear() * pair.memory->apart,
      length > kFine ? Vector3d(pair.towards / length) : Vector3d(Vector3d::Zero())};
  for (const Vector3d& n : directions) {
    if (n.isZero(0.0)) continue;
    const double along =
        separation({&pair.body_a->convex, &a}, {&pair.body_b->convex, &b}, n) - kFine;
    if (along > known.gap) known.n = n, known.gap = along;
  }
  return known;
}

bool Collision::Impl::stays_parted(std::size_t candidate, const Eigen::VectorXd& moves,
                                   double margin) noexcept {
  const Apart& known = apart_at(candidate);
  const NearShapes::Candidate& c = ahead[candidate];
  if (!(known.gap >= margin)) return false;
  if (known.gap - travel_of[at(c.a)] - travel_of[at(c.b)] >= margin) return true;
  return known.gap - reach->along(known.n, *ahead_from, link_of(c.a), link_of(c.b), moves) >=
         margin;
}

// What a direction did not part is not asked for one again at once, nor are directions looked for when
// so much is left that the way is looked along anyway, nor on the next ways.
Collision::PathSearch Collision::PathsAhead::search(const Eigen::VectorXd& moves, double margin,
                                                    std::vector<std::uint8_t>& joints, bool legs_alone) const noexcept {
  Impl& i = *impl_;
  const bool many = i.many_left > 0;
  if (many) --i.many_left;
  i.let_joints_move(moves);
  int left = 0;
  std::fill(joints.begin(), joints.end(), std::uint8_t{0});
  for (std::size_t c = 0; c < i.ahead.size(); ++c) {
    NearShapes::Candidate& candidate = i.ahead[c];
    const double travel = i.travel_of[at(candidate.a)] + i.travel_of[at(candidate.b)];
    if (number(candidate.bound) - travel >= margin) continue;
    const std::size_t pair = at(candidate.a) * i.shapes.size() + at(candidate.b);
    if (legs_alone && i.by_legs[at(i.pair_of[pair])] == 0) continue;
    std::uint8_t& wait = i.not_parted[pair];
    if (wait > 0) {
      --wait;
    } else if (!many && left < kFew && travel < kQuick && i.directions_left > 0) {
      --i.directions_left;
      const bool parted = i.stays_parted(c, moves, margin);
      i.know(candidate, i.apart[c].gap);
      if (parted) continue;
      wait = kWait;
    }
    i.left[at(left++)] = candidate;
    for (const int shape : {candidate.a, candidate.b}) {
      for (int link = i.link_of(shape); link > 0 && joints[at(link - 1)] == 0;
           link = i.model->links[at(link)].parent)
        joints[at(link - 1)] = 1;
    }
  }
  if (!many && left > kMany) i.many_left = kWait;
  i.looked_at = {i.left.data(), at(left)};
  return {&i, left > 0};
}

Collision::PathPlaces Collision::PathSearch::along(const Eigen::Isometry3d& base,
                                                   const SweptShapes::Way& way) const noexcept {
  impl_->swept->go(base, way);
  return {impl_, ++impl_->path};
}

Collision::Impl& Collision::PathPlaces::impl() const noexcept {
  static_cast<void>(path_);  // of what is built without asserts, too
  assert(impl_->path == path_);
  return *impl_;
}

int Collision::PathPlaces::open_pairs(double margin, double clear, PathPair* pairs, int capacity) const noexcept {
  Impl& i = impl();
  const int count = i.swept->open(i.looked_at, margin, clear, i.open_pairs.data(),
                                  std::min(capacity, static_cast<int>(i.open_pairs.size())));
  for (int p = 0; p < std::min(count, capacity); ++p) {
    PathPair& pair = pairs[p];
    pair.pair = i.open_pairs[at(p)];
    const auto [a, b] = i.swept->shapes(pair.pair);
    const OwnerPair& links = i.pairs[at(i.pair_of[at(a) * i.shapes.size() + at(b)])];
    pair.link_a = i.owner(links.a).index;
    pair.link_b = i.owner(links.b).index;
  }
  return count;
}

// What the gaps along one direction prove.  Without branches, which nothing foretells.
void Collision::Impl::note(PathPair& pair, const SweptShapes::AtPlaces& gaps) noexcept {
  unsigned far = 0, proved = 0;
  for (int k = 0; k < kPlaces; ++k) {
    pair.least[at(k)] = std::max(pair.least[at(k)], gaps[at(k)]);
    far |= if_so(number(gaps[at(k)]) >= pair.margin, k);
  }
  for (int k = 0; k + 1 < kPlaces; ++k)
    proved |= if_so(number(std::min(gaps[at(k)], gaps[at(k + 1)]) - pair.left_out[at(k)]) >= pair.clear, k);
  pair.far |= far;
  pair.open &= ~proved;
}

// Ways so long, or shapes so near together, that no distance at their ends can prove them.  most: that they are apart.
void Collision::Impl::note_hopeless(PathPair& pair, const SweptShapes::AtPlaces& most) noexcept {
  for (int k = 0; k + 1 < kPlaces; ++k) {
    const float here = most[at(k)], next = most[at(k + 1)];
    const bool by_gaps = number(std::min(here, next) - pair.left_out[at(k)]) < pair.clear,
               by_travel = number(0.5F * (here + next - pair.travel[at(k)])) < pair.clear;
    pair.hopeless |= if_so(by_gaps & by_travel, k);
  }
}

void Collision::PathPlaces::begin(PathPair& pair, double margin, double clear) const noexcept {
  const SweptShapes::Bounds known = impl().swept->bounds(pair.pair);
  pair.margin = margin;
  pair.clear = clear;
  pair.open = kAllWays;
  pair.asked = pair.far = pair.hopeless = 0;
  pair.left_out = known.left_out;
  pair.travel = known.travel;
  pair.least = known.gaps;
  pair.best = number(*std::min_element(pair.least.begin(), pair.least.end()));
  Impl::note(pair, pair.least);
  Impl::note_hopeless(pair, known.most_apart);
}

int Collision::PathPlaces::next_nearer(PathPair& pair, bool depths, int& looks, PairDistance& result) const noexcept {
  Impl& i = impl();
  const auto [a, b] = i.swept->shapes(pair.pair);
  NearShapes::Candidate candidate;
  candidate.a = a;
  candidate.b = b;
  const ShapePair shapes = i.shape_pair(candidate);
  const bool same_way =
      shapes.body_a == &i.owner(i.shapes[at(a)].owner).shapes[at(i.shapes[at(a)].shape)];
  i.gap.depths = depths;
  i.gap.close = kClose;
  for (int place = next_place(pair); place >= 0 && looks > 0; place = next_place(pair)) {
    --looks;
    pair.asked |= only(place);
    ++i.query;
    shapes.body_a->world = i.swept->pose(same_way ? a : b, place);
    shapes.body_b->world = i.swept->pose(same_way ? b : a, place);
    shapes.body_a->stamp = shapes.body_b->stamp = i.query;
    const Vector3d seen = (same_way ? 1.0 : -1.0) * i.swept->remembered(pair.pair, place);
    result = PairDistance{};
    result.link_a = pair.link_a;
    result.link_b = pair.link_b;
    result.distance = kFar + 1.0;
    const bool found =
        i.gap.nearer(*shapes.body_a, *shapes.body_b, *shapes.memory, seen, kFar, result);
    const double distance = found ? result.distance : kFar;
    pair.least[at(place)] =
        std::max(pair.least[at(place)], static_cast<float>(distance - kRounding - kClose));
    if (found && distance > 0.0) {
      const Vector3d direction = (same_way ? 1.0 : -1.0) * result.normal;
      const SweptShapes::AtPlaces gaps = i.swept->gaps(pair.pair, direction, place);
      Impl::note(pair, gaps);
      const double least = number(*std::min_element(gaps.begin(), gaps.end()));
      if (least > pair.best) {
        pair.best = least;
        i.swept->remember(pair.pair, direction, place);
      }
    }
    for (const int way : {place - 1, place}) {
      if (way >= 0 && way + 1 < kPlaces && distance - number(pair.left_out[at(way)]) < pair.clear)
        pair.hopeless |= only(way);
    }
    if (distance < pair.margin) return place;
    pair.far |= only(place);
  }
  if (next_place(pair) >= 0) {
    pair.open = kAllWays;
  } else if (pair.open != 0) {  // they may be too near together to be proved by any other means
    for (int k = 0; k + 1 < kPlaces; ++k) {
      if (0.5F * (pair.least[at(k)] + pair.least[at(k + 1)] - pair.travel[at(k)]) >=
          static_cast<float>(pair.clear))
        pair.open &= ~only(k);
    }
  }
  return -1;
}

}  // namespace twinbus::robot
