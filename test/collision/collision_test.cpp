#include "robot/collision/collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "robot/collision/collision_pairs.h"
#include "common/math/index.h"
#include "test/collision/postures.h"
#include "common/allocation/no_alloc.h"
#include "test/obstacles.h"
#include "test/oracles/fcl_oracle.h"

namespace twinbus {
namespace {

constexpr std::uint64_t kSeed = 20261121;
constexpr double kBand = 1e-5;  // distances this near to zero may be called either way [m]

std::vector<PairDistance> all_near(Collision& collision, const Kinematics& kinematics,
                                   double near) {
  std::vector<PairDistance> pairs(2000);
  pairs.resize(
      static_cast<std::size_t>(collision.near_pairs(kinematics, near, pairs.data(), 2000)));
  return pairs;
}

TEST(Collision, NeighboursAreLeftOutAndTheRestIsChecked) {
  const Model& model = hrp1s();
  const Collision collision(model);
  EXPECT_GT(collision.pairs().size(), 100U);
  for (const CollisionPair& pair : collision.pairs()) {
    EXPECT_FALSE(model.links[static_cast<std::size_t>(pair.link_a)].collision.empty());
    EXPECT_FALSE(model.links[static_cast<std::size_t>(pair.link_b)].collision.empty());
    EXPECT_NE(model.links[static_cast<std::size_t>(pair.link_b)].parent, pair.link_a);
    EXPECT_NE(model.links[static_cast<std::size_t>(pair.link_a)].parent, pair.link_b);
  }
}

TEST(Collision, NamedPosturesTouchNothing) {
  const Model& model = hrp1s();
  Collision collision(model);
  Kinematics kinematics(model);
  for (const NamedPose& pose : model.poses) {
    kinematics.update(named_posture(model, pose.name));
    CollisionPair hit;
    EXPECT_FALSE(collision.in_collision(kinematics, &hit))
        << pose.name << ": " << model.links[static_cast<std::size_t>(hit.link_a)].name << " and "
        << model.links[static_cast<std::size_t>(hit.link_b)].name;
  }
}

TEST(Collision, EveryVerdictIsThatOfBruteForceFcl) {
  const Model& model = hrp1s();
  Collision collision(model);
  const FclOracle oracle(model);
  Kinematics kinematics(model);
  std::mt19937_64 random(kSeed);
  const Configuration home = named_posture(model, "half_sitting");
  int touching = 0;
  int wrong = 0;
  for (int i = 0; i < 1500; ++i) {
    kinematics.update(random_posture(model, home, i % 2 == 0 ? 1.0 : 0.4, random));
    std::map<std::pair<int, int>, double> ours;
    for (const PairDistance& pair : all_near(collision, kinematics, 0.02)) {
      ours[{pair.link_a, pair.link_b}] = pair.distance;
    }
    bool any = false;
    for (const CollisionPair& pair : collision.pairs()) {
      const bool fcl = oracle.touches(kinematics, pair);
      const auto found = ours.find({pair.link_a, pair.link_b});
      const double distance = found == ours.end() ? 1.0 : found->second;
      if (fcl != (distance <= 0.0) && std::abs(distance) > kBand) {
        ++wrong;
        ADD_FAILURE() << "posture " << i << " links " << pair.link_a << " " << pair.link_b
                      << " fcl " << fcl << " ours " << distance;
      }
      touching += fcl ? 1 : 0;
      any = any || fcl;
    }
    EXPECT_EQ(any, collision.in_collision(kinematics)) << "posture " << i;
    if (wrong > 5) break;
  }
  EXPECT_GT(touching, 500);
}

TEST(Collision, FclFindsTheSamePairsAtTheSameDistances) {
  const Model& model = hrp1s();
  Collision own(model);
  const FclOracle oracle(model);
  Kinematics kinematics(model);
  std::mt19937_64 random(kSeed + 7);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    kinematics.update(random_posture(model, named_posture(model, "half_sitting"), 0.4, random));
    std::map<std::pair<int, int>, double> ours;
    for (const PairDistance& p : all_near(own, kinematics, 0.05))
      ours[{p.link_a, p.link_b}] = p.distance;
    for (const CollisionPair& pair : own.pairs()) {
      const FclGap gap = oracle.gap(kinematics, pair);
      if (!(gap.distance <= 0.049)) continue;
      const auto found = ours.find({pair.link_a, pair.link_b});
      ASSERT_NE(found, ours.end()) << i;
      if (gap.distance > kBand) {
        EXPECT_NEAR(gap.distance, found->second, 1e-4);
        EXPECT_NEAR((gap.point_b - gap.point_a).norm(), gap.distance, 1e-4);
      } else {
        EXPECT_LT(found->second, 1e-4);
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(Collision, TheNormalTakesThePairApart) {
  const Model& model = hrp1s();
  Collision collision(model);
  Kinematics kinematics(model);
  std::mt19937_64 random(kSeed + 1);
  int checked = 0;
  int deep = 0;
  for (int i = 0; i < 200; ++i) {
    // An obstacle that can be pushed along the normal.
    std::uniform_real_distribution<double> spread(-0.5, 0.5);
    Obstacle obstacle;
    obstacle.shape = static_cast<ObstacleShape>(1 + i % 3);
    obstacle.size = Eigen::Vector3d(0.1, 0.2, 0.15);
    obstacle.pose =
        Eigen::Translation3d(spread(random), spread(random), 0.3 + spread(random)) *
        Eigen::Quaterniond(1.0, spread(random), spread(random), spread(random)).normalized();
    collision.set_obstacles({obstacle});
    kinematics.update(random_posture(model, named_posture(model, "half_sitting"), 0.5, random));
    for (const PairDistance& pair : all_near(collision, kinematics, 0.05)) {
      if (pair.link_b != model.link_count()) continue;
      EXPECT_NEAR(pair.normal.norm(), 1.0, 1e-9);
      if (pair.distance > 0.0) {
        EXPECT_NEAR((pair.point_b - pair.point_a).norm(), pair.distance, 1e-4);
      }
      for (const double step : {0.004, 0.008}) {
        Obstacle moved = obstacle;
        moved.pose = Eigen::Translation3d(step * pair.normal) * obstacle.pose;
        collision.set_obstacles({moved});
        PairDistance after;
        ASSERT_TRUE(collision.pair_nearer_than(kinematics, pair.link_a, pair.link_b, 1.0, after));
        // Several shapes of one link may change places, so at most `step`; never nearer.  The depth
        // of round shapes is an estimate.
        const double slack = pair.distance > 0.0 ? 1e-5 : 4e-3;
        EXPECT_LE(after.distance, pair.distance + step + slack);
        EXPECT_GT(after.distance,
                  pair.distance + (pair.distance > 0.0 ? -slack : 0.5 * step - slack));
      }
      collision.set_obstacles({obstacle});
      ++checked;
      deep += pair.distance < -0.005 ? 1 : 0;
    }
  }
  EXPECT_GT(checked, 50);
  EXPECT_GT(deep, 10);
}

TEST(Collision, AnswersDoNotDependOnThePast) {
  const Model& model = hrp1s();
  Collision fresh(model);
  Collision used(model);
  Kinematics kinematics(model);
  std::mt19937_64 random(kSeed + 2);
  const Configuration home = named_posture(model, "half_sitting");
  for (int i = 0; i < 300; ++i) {
    kinematics.update(random_posture(model, home, 0.7, random));
    used.in_collision(kinematics);
  }
  kinematics.update(random_posture(model, home, 0.3, random));
  const auto a = all_near(fresh, kinematics, 0.1);
  const auto b = all_near(used, kinematics, 0.1);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].distance, b[i].distance);
    EXPECT_EQ(a[i].point_a, b[i].point_a);
  }
}

// What no way names is proved to stay apart on it, and so is what no place and no stretch names of
// what it does.
TEST(Collision, NothingThatComesNearOnAWayIsLeftOut) {
  constexpr double kMargin = 0.01, kClear = 0.005;
  constexpr int kPlaces = SweptShapes::kPlaces;
  const Model& model = hrp1s();
  Collision collision(model), fresh(model);
  const Obstacle box = test::box_at({0.35, 0.2, 0.2}, Eigen::Vector3d::Constant(0.3));
  collision.set_obstacles({box});
  fresh.set_obstacles({box});
  Kinematics now(model), then(model);
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<PairDistance> all(2000);
  std::vector<Collision::PathPair> open(2000);
  SweptShapes::Way way;
  way.q.resize(model.joints.size());
  way.bend.resize(model.joints.size());
  way.asked.resize(model.joints.size());
  long near_places = 0, near_between = 0, proved = 0, named = 0;
  for (int k = 0; k < 240; ++k) {
    Configuration c(model);
    Collision::Ahead ahead{Eigen::VectorXd::Zero(model.joint_count()), kMargin, {}};
    const double step = k % 3 == 0 ? 0.06 : k % 3 == 1 ? 0.015 : 0.002;
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[at(j)];
      c.q[j] = 0.5 * (joint.lower + joint.upper + 0.6 * unit(random) * (joint.upper - joint.lower));
      const double along = step * unit(random);
      for (int place = 0; place < kPlaces; ++place) {
        way.q[at(j)][at(place)] = c.q[j] + along * place;
        way.bend[at(j)][at(place)] =
            place + 1 < kPlaces && k % 2 == 0 ? static_cast<float>(0.03 * step) : 0.0F;
      }
      ahead.moves[j] = std::abs(along) * (kPlaces - 1) + 0.03 * step;
    }
    now.update(c);
    int found_now = 0;
    const auto paths = collision.near_pairs(now, 0.05, all.data(), 2000, ahead, found_now);
    const Collision::PathSearch search = paths.search(ahead.moves, kMargin, way.asked);
    const Collision::PathPlaces path = search.along(c.base, way);
    const int count = path.open_pairs(kMargin, kClear, open.data(), 2000);
    EXPECT_TRUE(search || count == 0);
    ASSERT_LE(count, 2000);
    named += count;
    std::map<std::pair<int, int>, unsigned> near, may_be_near;  // places; stretches
    for (int p = 0; p < count; ++p) {
      Collision::PathPair& pair = open[at(p)];
      path.begin(pair, kMargin, kClear);
      int looks = 1000;
      PairDistance found;
      const std::pair<int, int> links{pair.link_a, pair.link_b};
      for (int place; (place = path.next_nearer(pair, false, looks, found)) >= 0;) {
        EXPECT_LT(found.distance, kMargin);
        near[links] |= 1U << static_cast<unsigned>(place);
      }
      may_be_near[links] |= pair.open;
      proved += pair.open == 0 ? 1 : 0;
    }
    for (int part = 0; part <= 4 * (kPlaces - 1); ++part) {
      const int place = part / 4;
      const bool between = part % 4 != 0;
      Configuration on_way = c;
      for (int j = 0; j < model.joint_count(); ++j) {
        on_way.q[j] += (way.q[at(j)][1] - way.q[at(j)][0]) * part / 4.0;
        if (between)
          on_way.q[j] +=
              std::copysign(static_cast<double>(way.bend[at(j)][at(place)]), unit(random));
      }
      then.update(on_way);
      const double reach = between ? kClear : kMargin - 1e-4;
      const int expected = fresh.near_pairs(then, reach, all.data(), 2000);
      for (int p = 0; p < expected; ++p) {
        const auto& where = between ? may_be_near : near;
        const auto said = where.find({all[at(p)].link_a, all[at(p)].link_b});
        ASSERT_NE(said, where.end()) << "way " << k << " at " << part;
        EXPECT_NE(said->second >> static_cast<unsigned>(place) & 1U, 0U)
            << "way " << k << " at " << part;
        ++(between ? near_between : near_places);
      }
    }
  }
  EXPECT_GT(near_places, 1000);
  EXPECT_GT(near_between, 1000);
  EXPECT_GT(proved, 100);
  EXPECT_LT(named, 240 * 60) << "hardly anything is proved at once";
}

// What one posture has proved serves the next ones, and no longer than it is true: a robot that walks on in
// small steps, jumps, and whose obstacle and base move, is never said to stay apart where it does not; and
// the nearest pairs are those that one finds who knows nothing.
TEST(Collision, WhatStaysApartIsNotBelievedTooLong) {
  constexpr double kMargin = 0.01, kNear = 0.05;
  constexpr int kEnough = 6;
  const Model& model = hrp1s();
  Collision collision(model), fresh(model);
  Obstacle box;
  box.shape = ObstacleShape::kBox;
  box.size = Eigen::Vector3d::Constant(0.2);
  Kinematics now(model), then(model);
  std::mt19937_64 random(15);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<PairDistance> all(2000), nearest(2000);
  std::vector<std::uint8_t> joints(at(model.joint_count()));
  const Configuration home = named_posture(model, "half_sitting");
  Configuration c = home;
  Eigen::VectorXd speed = Eigen::VectorXd::Zero(model.joint_count());
  Collision::Ahead ahead{Eigen::VectorXd::Zero(model.joint_count()), kMargin, c.q, kEnough};
  long cleared = 0, nearly = 0, near = 0, named = 0;
  for (int k = 0; k < 6000; ++k) {
    if (k % 500 == 0) {
      box.pose.translation() = Eigen::Vector3d(0.5, 0.3 * unit(random), 0.3 * unit(random));
      collision.set_obstacles({box});
      fresh.set_obstacles({box});
    }
    if (k % 40 == 0) {
      for (double& v : speed) v = (k % 80 == 0 ? 0.01 : 0.001) * unit(random);
    }
    if (k % 250 == 0) c = home;
    if (k % 10 == 0) c.base.translation().x() = 0.1 * unit(random);
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[at(j)];
      c.q[j] = std::clamp(c.q[j] + speed[j], joint.lower, joint.upper);
      ahead.moves[j] = 2.0 * std::abs(speed[j]);
    }
    ahead.q = c.q;
    now.update(c);
    int found = 0;
    const Collision::PathsAhead paths = collision.near_pairs(now, kNear, nearest.data(), 2000, ahead, found);
    const int wanted = fresh.near_pairs(now, kNear, all.data(), 2000);
    for (int p = 0; p < wanted && (p < kEnough || all[at(p)].distance < kMargin); ++p) {
      ASSERT_LT(p, found) << k;
      EXPECT_NEAR(std::max(nearest[at(p)].distance, 0.0), std::max(all[at(p)].distance, 0.0), 3e-6)
          << k << " " << p;
      ++named;
    }
    const bool left = static_cast<bool>(paths.search(ahead.moves, kMargin, joints));
    cleared += left ? 0 : 1;
    Configuration on_way = c;
    for (int j = 0; j < model.joint_count(); ++j) on_way.q[j] += unit(random) * ahead.moves[j];
    if (k % 2 == 0) on_way.q = c.q + 2.0 * speed;
    then.update(on_way);
    const int count = fresh.near_pairs(then, 1.5 * kMargin, all.data(), 2000);
    for (int p = 0; p < count; ++p) {
      nearly += left ? 0 : 1;
      if (all[at(p)].distance >= kMargin) continue;
      ++near;
      ASSERT_TRUE(left) << k;
      for (const int link : {all[at(p)].link_a, all[at(p)].link_b}) {
        for (int l = link < model.link_count() ? link : 0; l > 0; l = model.links[at(l)].parent)
          ASSERT_NE(joints[at(l - 1)], 0) << k << " " << model.links[at(l)].name;
      }
    }
  }
  EXPECT_GT(cleared, 300);
  EXPECT_GT(near, 300);
  EXPECT_GT(nearly, 0);
  EXPECT_GT(named, 10000);
}

TEST(Collision, QueriesOnPrimitivesAllocateNothing) {
  const Model& model = hrp1s();
  Collision collision(model);
  const Obstacle shelf = test::box_at({0.4, 0.0, 0.2}, {0.3, 0.8, 0.04});
  collision.set_obstacles({shelf});
  Kinematics kinematics(model);
  std::mt19937_64 random(kSeed + 3);
  std::vector<PairDistance> pairs(64);
  const Configuration home = named_posture(model, "half_sitting");
  std::vector<Configuration> postures;
  for (int i = 0; i < 300; ++i) postures.push_back(random_posture(model, home, 0.8, random));
  NoAlloc no_alloc;
  int hits = 0;
  for (const Configuration& posture : postures) {
    kinematics.update(posture);
    hits += collision.in_collision(kinematics) ? 1 : 0;
    hits += collision.near_pairs(kinematics, 0.05, pairs.data(), 64);
  }
  EXPECT_EQ(no_alloc.count(), 0);
  EXPECT_GT(hits, 100);
}

TEST(Collision, ObstaclesThatAreNoShapeAreLeftOut) {
  const Model& model = hrp1s();
  Collision collision(model);
  const int before = collision.pair_count();
  Obstacle good;
  good.shape = ObstacleShape::kSphere;
  good.size = Eigen::Vector3d(0.1, 0.0, 0.0);
  Obstacle flat = good;
  flat.size.x() = 0.0;
  Obstacle lost = good;
  lost.pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
  Obstacle none;
  collision.set_obstacles({flat, lost, none});
  EXPECT_EQ(collision.pair_count(), before);
  collision.set_obstacles(std::vector<Obstacle>(1000, good));
  EXPECT_LE(collision.pair_count(), before + Collision::kMaxObstacles * model.link_count());
}

TEST(Collision, OnlyPairsThatTheJointsMoveAreCheckedOnRequest) {
  const Model& model = hrp1s();
  Collision collision(model);
  Kinematics kinematics(model);
  // Legs crossed deeply, arms alone are asked about.
  Configuration crossed = named_posture(model, "half_sitting");
  crossed.q[model.find_joint("RLEG_HIP_R")] = 0.5;
  crossed.q[model.find_joint("LLEG_HIP_R")] = -0.5;
  kinematics.update(crossed);
  EXPECT_TRUE(collision.in_collision(kinematics));
  collision.check_only_moved_by(model.hands[0].joints);
  EXPECT_FALSE(collision.in_collision(kinematics));
  collision.check_only_moved_by({});
  EXPECT_TRUE(collision.in_collision(kinematics));
}

}  // namespace
}  // namespace twinbus
