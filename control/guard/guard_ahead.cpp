// What Guard says of the ways that may follow a tick: whether something comes too near on them, which
// joints bring it there, and what is free once these are held.

#include <algorithm>
#include <utility>

#include "control/guard/guard_parts.h"
#include "common/math/index.h"
#include "robot/kinematics/brake.h"

namespace twinbus::inline control {

namespace {

using Eigen::Vector3d;

constexpr double kProved = 0.5;  // of the margin or what is left of it: nothing comes nearer unseen
constexpr unsigned kDepths = 1U << 1U | 1U << 7U;  // places where those that touch are looked at
constexpr double kBarely = 1e-3;  // of pairs nearer than this nothing is proved on the way [m]
constexpr int kMostRounds = 8;  // of masking more joints because those masked first are not enough
// A pair at the margin may still come this much nearer before it rests, against flicker; inside of
// it the less the nearer it is, so that it never arrives [m].
constexpr double kNearer = 1e-4;
// Deeper than this a model says nothing about which way is out, and nothing is held [m].
constexpr double kLost = 0.03;
constexpr double kAnywhere = 100.0;  // [m]

}  // namespace

// No two links come nearer by more than this on these courses, or other than on others [m].
double Guard::Impl::travel(const Courses& courses, const Courses* other) noexcept {
  apart(courses, other, rests);
  return rests.dot(reaches);
}

// The same pair as it is now; null when it is farther apart than any that is kept.
const PairDistance* Guard::Impl::near_now(int link_a, int link_b) const noexcept {
  for (int p = 0; p < pair_count; ++p) {
    const PairDistance& pair = pairs[at(p)];
    if (pair.link_a == link_a && pair.link_b == link_b) return &pair;
  }
  return nullptr;
}

bool Guard::Impl::comes_too_near(const PairDistance& before,
                                 const PairDistance& after) const noexcept {
  const double margin = margin_of(after.link_a, after.link_b);
  const double inside = std::clamp(before.distance / margin, 0.0, 1.0);
  return after.distance < margin &&
         after.distance < before.distance - kNearer * inside * inside && before.distance > -kLost;
}

// Change of the distance of the pair when `joint` moves by `step`, to first order [m].
double Guard::Impl::approach(const Kinematics& kinematics, const PairDistance& pair, int joint,
                             double step) const noexcept {
  if (step == 0.0) return 0.0;
  const bool with_a = moves_link(joint, pair.link_a);
  const bool with_b = moves_link(joint, pair.link_b);
  if (with_a == with_b) return 0.0;
  const Vector3d& point = with_a ? pair.point_a : pair.point_b;
  const Vector3d& axis = kinematics.axis_in_world(joint);
  const Vector3d motion =
      model->joints[at(joint)].kind == JointKind::kPrismatic
          ? axis
          : Vector3d(axis.cross(point - kinematics.link_in_world(joint + 1).translation()));
  return (with_b ? step : -step) * pair.normal.dot(motion);
}

// Do the joints that are still held come nearer to anything inside its margin on the way back to their set-points?  A fade
// begins so slowly that no look along it sees that in time: each release would cost a little of the margin.
bool Guard::Impl::leads_nearer(const JointCommand& command) const noexcept {
  std::array<int, kMaxJoints> fading{};
  int fading_count = 0;
  for (int k = 0; k < std::min(model->bus_count(), kMaxJoints); ++k) {
    const Joint& joint = model->joints[at(model->bus_joints[at(k)])];
    if (keep[at(k)] > 0 && servos.is_soft(at(k)) && !is_soft(static_cast<double>(command.kp[at(k)]), joint))
      fading[at(fading_count++)] = k;
  }
  for (int p = 0; p < pair_count && fading_count > 0; ++p) {
    const PairDistance& pair = pairs[at(p)];
    if (!(pair.distance < margin_of(pair.link_a, pair.link_b)) || !(pair.distance > -kLost)) continue;
    double nearer = 0.0;
    for (int n = 0; n < fading_count; ++n) {
      const int k = fading[at(n)], j = model->bus_joints[at(k)];
      nearer -= approach(*now_kinematics, pair, j, command.q[at(k)] - now.q[j]);
    }
    if (nearer > kNearer) return true;
  }
  return false;
}

// Masks the joints that bring the pair together as seen from this posture; false if none does.
bool Guard::Impl::blame_at(const Kinematics& kinematics, const PairDistance& pair,
                           const Courses& courses) noexcept {
  double together = 0.0;
  double by_legs = 0.0;
  for (int j = 0; j < model->joint_count(); ++j) {
    const double change = approach(kinematics, pair, j, courses[at(j)].rest());
    changes[j] = change;
    if (!(change < 0.0)) continue;
    together -= change;
    if (leg[at(j)] != 0) by_legs -= change;
  }
  if (!(together > kNearer)) return false;
  if (cause.joint < 0) {
    for (int j = 0; j < model->joint_count(); ++j) {
      if (changes[j] < 0.0 && (cause.joint < 0 || changes[j] < changes[cause.joint])) cause.joint = j;
    }
    cause.speed = courses[at(cause.joint)].speed;
  }
  for (int j = 0; j < model->joint_count(); ++j) {
    if (leg[at(j)] == 0 && changes[j] < -least_share * together) mask |= bits_of[at(j)];
  }
  leg_hit = leg_hit || by_legs > 0.5 * together;
  return true;
}

void Guard::Impl::go_to(const CourseWay& way, double share) noexcept {
  then.base = now.base;
  then.q = now.q;
  way.go_on(share, then.q);
  then_kinematics.update(then);
}

void Guard::Impl::blame(const PairDistance& before, const PairDistance& after, const CourseWay& way,
                        double share, const Courses& courses) noexcept {
  if (blame_at(*now_kinematics, before, courses)) return;
  go_to(way, share);
  PairDistance then_pair = after;
  if (!(after.distance > 0.0) &&  // depth, points and normal, which a look leaves out
      !collision.pair_nearer_than(then_kinematics, after.link_a, after.link_b, config.margin,
                                  then_pair))
    then_pair = after;
  if (blame_at(then_kinematics, then_pair, courses)) return;
  // A curved way in: whatever moves either of them.
  for (int j = 0; j < model->joint_count(); ++j) {
    if (moves_link(j, before.link_a) == moves_link(j, before.link_b) ||
        courses[at(j)].rest() == 0.0)
      continue;
    if (leg[at(j)] != 0) {
      leg_hit = true;
    } else {
      mask |= bits_of[at(j)];
    }
  }
}

// What cannot be proved is answered by a brake of all, which was safe when it was looked at last.
bool Guard::Impl::hold_all() noexcept {
  ++unproved;
  if (!cause.found) cause = {.found = true};
  mask |= all_but_legs;
  return true;
}

// What a hand holds leaves what it stands on: until they were as far apart as others must be, they only must not touch again.
void Guard::Impl::look_what_parts() noexcept {
  for (auto& pair : parting) {
    if (pair == std::pair(0, 0)) continue;
    const PairDistance* is = near_now(pair.first, pair.second);
    if (is == nullptr || !(is->distance < margin_of(pair.first, pair.second))) pair = {};
  }
  for (int p = 0; p < pair_count; ++p) {
    const std::pair pair(pairs[at(p)].link_a, pairs[at(p)].link_b);
    if (!(pairs[at(p)].distance < kBarely) || !stands_on(pairs[at(p)])) continue;
    if (std::find(parting.begin(), parting.end(), pair) != parting.end()) continue;
    const auto free = std::find(parting.begin(), parting.end(), std::pair(0, 0));
    if (free != parting.end()) *free = pair;
  }
}

// Does the pair come too near at one of these places?  If not, pair.open says what is not proved.
bool Guard::Impl::judge(const CourseWay& way, const CourseWay::Shares& shares, const Courses& courses,
                        const Collision::PathPlaces& path, Collision::PathPair& pair) noexcept {
  const PairDistance* before = near_now(pair.link_a, pair.link_b);
  const bool parts = std::find(parting.begin(), parting.end(), std::pair(pair.link_a, pair.link_b)) != parting.end();
  const double margin = parts ? 0.0 : margin_of(pair.link_a, pair.link_b);
  const double distance = before != nullptr ? before->distance : margin;
  if (parts && distance < kBarely) return false;
  path.begin(pair, margin, kProved * std::min(distance, margin));
  if (distance < kBarely) pair.open = 0;
  if (!(distance > 0.0)) pair.asked = ~kDepths;
  PairDistance found, far;
  for (int place; (place = path.next_nearer(pair, !(distance > 0.0), looks_left, found)) >= 0;) {
    if (before == nullptr &&
        collision.pair_nearer_than(*now_kinematics, pair.link_a, pair.link_b, kAnywhere, far))
      before = &far;
    if (before == nullptr || !comes_too_near(*before, found)) continue;
    suspect = pair.pair;
    if (!cause.found || cause.link_a < 0)
      cause = {.found = true, .link_a = pair.link_a, .link_b = pair.link_b, .now = before->distance, .then = found.distance,
               .margin = margin};
    blame(*before, found, way, shares[at(place)], courses);
    return true;
  }
  return false;
}

// Only the joints that these pairs hang on.
void Guard::Impl::ask_joints(const Collision::PathPair* asked, int count) noexcept {
  for (int j = 0; j < model->joint_count(); ++j) {
    places.asked[at(j)] = std::any_of(asked, asked + count, [&](const Collision::PathPair& pair) {
      return moves_link(j, pair.link_a) || moves_link(j, pair.link_b);
    });
  }
}

// Looks at these pairs at these places, then between them at what is not proved to stay apart; true when
// one comes too near.
bool Guard::Impl::look(const CourseWay& way, const CourseWay::Shares& shares, const Courses& courses,
                       const Collision::PathSearch& search, const Collision::PathPlaces& path, int part, int count) noexcept {
  auto& pairs_open = open[at(part)];
  for (int p = 1; p < count; ++p) {
    if (pairs_open[at(p)].pair == suspect) std::swap(pairs_open[0], pairs_open[at(p)]);
  }
  const Collision::PathPair* found = nullptr;
  for (int p = 0; p < count; ++p) {
    Collision::PathPair& pair = pairs_open[at(p)];
    const bool again =
        found != nullptr && found->link_a == pair.link_a && found->link_b == pair.link_b;
    if (!again && judge(way, shares, courses, path, pair)) found = &pair;
    if (looks_left == 0 && found == nullptr && pair.open != 0) return hold_all();
    // Without looks no more is found, and nothing changes the answer once all is held and a stop is asked for.
    if (found != nullptr && (looks_left == 0 || (all_held() && leg_hit))) break;
  }
  if (found != nullptr) return true;
  for (int stretch = SweptShapes::kPlaces - 2; stretch >= 0; --stretch) {
    const auto is_open = [&](const Collision::PathPair& pair) {
      return (pair.open >> static_cast<unsigned>(stretch) & 1U) != 0;
    };
    if (std::none_of(pairs_open.begin(), pairs_open.begin() + count, is_open)) continue;
    if (part + 1 == kMostParts || stretches_left == 0 || looks_left == 0) return hold_all();
    --stretches_left;
    const auto next_end = std::copy_if(pairs_open.begin(), pairs_open.begin() + count,
                                       open[at(part + 1)].begin(), is_open);
    const auto parts = CourseWay::between(shares[at(stretch)], shares[at(stretch + 1)]);
    ask_joints(open[at(part + 1)].data(), static_cast<int>(next_end - open[at(part + 1)].begin()));
    way.go(now.q, parts, places);
    if (look(way, parts, courses, search, search.along(now.base, places), part + 1,
             static_cast<int>(next_end - open[at(part + 1)].begin())))
      return true;
  }
  return false;
}

// Masks more joints until nothing comes too near with this mask and what is kept of earlier ones, which
// is what the report will say: who holds that until the next tick may go on holding it to rest.  Those
// that are still held besides are let go with it, or stay where they are: both may come.
void Guard::Impl::prove_mask() noexcept {
  for (int round = 0; round < kMostRounds; ++round) {
    // What soft servos do to one another is not theirs to answer for: all are held.
    if ((mask & servos.soft()) != 0) mask |= all_but_legs;
    const std::int64_t before = mask, held = mask | kept(), stay = held | on_hold();
    bool near = false;
    if (mask != 0) least_share = 0.0;
    if (held != 0) {
      predict_masked(held, stay);
      near = look_along(masked);
    }
    if (stay != held && mask == before) {
      predict_masked(stay, stay);
      near = look_along(masked) || near;
    }
    if (mask == 0) {  // commands may change at once, and then all is braked
      predict_masked(all_but_legs, all_but_legs);
      if (travel(masked, &obeyed) > (1.0 - kProved) * margin_shares.least() * config.margin) look_along(masked);
    }
    if (mask != before) continue;
    if (near && servos.soft() != 0) break;
    return;
  }
  mask |= all_but_legs;  // a brake of all was safe when it was looked at last
}

// Looks along the way from here to rest; true when something comes too near.
bool Guard::Impl::look_along(const Courses& courses) noexcept {
  if (!(travel(courses, nullptr) > kNearer)) return false;
  if (all_held() && leg_hit) return true;
  const Collision::PathSearch search = ahead->search(rests, config.margin, places.asked, all_held());
  if (!search) return false;
  const CourseWay way(courses, track.delay());
  const CourseWay::Shares shares = way.shares();
  way.go(now.q, shares, places);
  const Collision::PathPlaces path = search.along(now.base, places);
  const int most = std::min(kMostOpen, looks_left);  // each of them takes a look at least
  const int count = path.open_pairs(config.margin, kProved * config.margin, open[0].data(), most);
  ++work.ways;
  work.open += count;
  const bool found = count > most ? hold_all() : look(way, shares, courses, search, path, 0, count);
  danger = danger || found;
  return found;
}

}  // namespace twinbus::control
