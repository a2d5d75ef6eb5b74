// What hands hold: as far from everything as the same thing standing where the hand has it, kept clear by the guard, and put
// together from HELD.

#include <gtest/gtest.h>

#include <random>

#include "common/math/index.h"
#include "control/guard/guard.h"
#include "robot/collision/collision.h"
#include "robot/collision/collision_pairs.h"
#include "robot/collision/obstacle_collector.h"
#include "robot/collision/thing_name.h"
#include "robot/description/named_hands.h"
#include "test/carried_arms.h"
#include "test/collision/guard_rig.h"
#include "test/collision/post_and_arm.h"
#include "test/collision/postures.h"
#include "test/obstacles.h"
#include "test/oracles/fcl_oracle.h"

namespace twinbus {
namespace {

Obstacle rod(int hand) {
  Obstacle held;
  held.shape = ObstacleShape::kCylinder;
  held.size = {0.02, 0.4, 0.0};
  held.pose.translation() = Eigen::Vector3d(0.05, 0.0, -0.1);
  held.hand = hand;
  return held;
}

// A user finds his own again: they are counted from 1, whatever stands before them; the guard says what it is about.
TEST(Held, EverythingAroundHasAName) {
  const Model& model = hrp1s();
  Obstacle floor = test::box_at({3.0, 0.0, -0.05}, {4.0, 10.0, 0.1}), flat;
  const Obstacle wall = test::box_at({0.3, 0.0, 0.5}, {0.02, 1.2, 1.0});
  flat.shape = ObstacleShape::kSphere;  // of no size: it takes no part and has no number
  const std::vector<Obstacle> around = {floor, flat, wall, wall, rod(0), rod(1)};
  const int links = model.link_count();
  const auto name = [&](int index) { return std::string(thing_name(model, around, index).data()); };
  EXPECT_EQ(name(3), model.links[3].name);
  EXPECT_EQ(name(links), "the floor");
  EXPECT_EQ(name(links + 1), "obstacle 1");
  EXPECT_EQ(name(links + 2), "obstacle 2");
  EXPECT_EQ(name(links + 3), "what the left hand holds");
  EXPECT_EQ(name(links + 4), "what the right hand holds");
  EXPECT_EQ(name(links + 5), "an obstacle");
  EXPECT_EQ(name(-1), "?");
  floor.pose.translation().z() += 0.01;  // a platform is no floor
  EXPECT_FALSE(is_floor(floor));
  std::array<char, 200> text{};
  GuardCause cause;
  cause.link_a = 3;
  cause.link_b = links + 4;
  describe(model, around, cause, text);
  EXPECT_NE(std::string(text.data()).find(" and what the right hand holds, "), std::string::npos) << text.data();
}

// Further arms have numbers from 2 on; left and right are said as ever, so that who knows no others goes on hearing them.
TEST(Held, AFurtherArmHoldsByItsNumber) {
  const Model model = test::three_arms();
  ObstacleCollector collector;
  const auto holds = [&](int hand, int pieces, std::int64_t scene) {
    ObstaclesPiece piece;
    piece.scene_id = scene;
    piece.piece = static_cast<std::int16_t>(hand);
    piece.pieces = static_cast<std::int16_t>(pieces);
    piece.count = 1;
    piece.shape[0] = ObstacleShape::kSphere;
    piece.size[0] = {0.03F, 0.0F, 0.0F};
    piece.attitude.fill({1.0F, 0.0F, 0.0F, 0.0F});
    return collector.hold(piece);
  };
  EXPECT_EQ(held_pieces(0), 2);
  EXPECT_EQ(held_pieces(1), 2);
  EXPECT_FALSE(holds(3, 2, 5));
  EXPECT_FALSE(holds(1, kMostHands, 5));
  EXPECT_FALSE(holds(kMostHands, kMostHands, 5));
  EXPECT_FALSE(holds(-1, 2, 5));
  EXPECT_TRUE(collector.obstacles().empty());
  EXPECT_TRUE(holds(3, held_pieces(3), 5));
  EXPECT_FALSE(holds(3, held_pieces(3), 5)) << "the same once more";
  ASSERT_EQ(collector.obstacles().size(), 1U);
  EXPECT_EQ(collector.obstacles().front().hand, 3);
  EXPECT_EQ(std::string(thing_name(model, collector.obstacles(), model.link_count()).data()), "what north holds");
  Collision collision(model);
  const int alone = collision.pair_count();
  collision.set_obstacles(collector.obstacles());
  EXPECT_GT(collision.pair_count(), alone) << "it is kept clear of what does not carry it";
  EXPECT_EQ(collision.carrier(model.link_count()), hand_called(model, "north")->link);
}

// A fixed base beside the floor or a wall: no joint can mend or worsen that, and nothing is said of it.
TEST(Held, WhatStandsIsNoPairOfABaseThatNothingMoves) {
  Model model = post_and_arm();
  const std::vector<Obstacle> around = {test::box_at({0.06, 0.0, 0.0}, {0.01, 0.1, 0.1})};
  for (const bool floating : {true, false}) {
    model.floating_base = floating;
    Collision collision(model);
    const int alone = collision.pair_count();
    collision.set_obstacles(around);
    EXPECT_EQ(collision.pair_count(), alone + (floating ? 2 : 1));
    Kinematics k(model);
    k.update(Configuration(model));
    std::array<PairDistance, 4> near;
    const int count = collision.near_pairs(k, 0.02, near.data(), 4);
    EXPECT_EQ(count, floating ? 1 : 0);
  }
}

TEST(Held, IsAsFarFromEverythingAsTheSameThingThere) {
  const Model& model = hrp1s();
  Collision carrying(model), standing(model);
  FclOracle oracle(model);
  const Obstacle table = test::box_at({0.3, 0.0, 0.2}, {0.3, 1.2, 0.1});
  carrying.set_obstacles({table, rod(0)});
  oracle.set_obstacles({table, rod(0)});
  Kinematics kinematics(model);
  std::mt19937_64 random(7);
  const int held = model.link_count() + 1;
  EXPECT_EQ(carrying.carrier(held), model.hands[0].link);
  EXPECT_EQ(carrying.carrier(model.link_count()), -1);
  int with_links = 0, with_table = 0;
  for (int i = 0; i < 300; ++i) {
    kinematics.update(random_posture(model, named_posture(model, "half_sitting"), 0.8, random));
    Obstacle there = rod(0);
    there.hand = -1;
    there.pose = kinematics.link_in_world(model.hands[0].link) * model.hands[0].frame * there.pose;
    standing.set_obstacles({table, there});
    for (int link = 0; link < model.link_count(); ++link) {
      PairDistance a, b;
      const bool near = standing.pair_nearer_than(kinematics, link, held, 0.1, a);
      ASSERT_EQ(carrying.pair_nearer_than(kinematics, link, held, 0.1, b), near);
      if (near) {
        EXPECT_NEAR(a.distance, b.distance, 1e-5);
      }
    }
    std::array<PairDistance, 256> pairs;
    const int count = carrying.near_pairs(kinematics, 0.1, pairs.data(), 256);
    for (int p = 0; p < count; ++p) {
      const PairDistance& pair = pairs[at(p)];
      if (pair.link_a != held && pair.link_b != held) continue;
      const int other = pair.link_a == held ? pair.link_b : pair.link_a;
      EXPECT_FALSE(other < model.link_count() && hangs_on(model, other, model.hands[0].link));
      const bool table_too = pair.link_a == model.link_count() || pair.link_b == model.link_count();
      ++(table_too ? with_table : with_links);
      if (!table_too) continue;
      // FCL's word on the rod and the table.
      EXPECT_EQ(oracle.touches(kinematics, {pair.link_a, pair.link_b}), pair.distance <= 0.0);
    }
  }
  EXPECT_GT(with_links, 50);
  EXPECT_GT(with_table, 20);
  carrying.set_obstacles({table});
  EXPECT_TRUE(carrying.held_pairs().empty());
}

TEST(Held, TwoHandsKeepWhatTheyHoldApart) {
  const Model& model = hrp1s();
  Collision collision(model);
  collision.set_obstacles({rod(0), rod(1)});
  const int first = model.link_count();
  EXPECT_TRUE(std::any_of(collision.held_pairs().begin(), collision.held_pairs().end(),
                          [&](const CollisionPair& pair) { return pair.link_a == first && pair.link_b == first + 1; }));
}

// An arm goes down towards a shelf that only what it holds would meet.
TEST(Held, TheGuardBrakesTheArmForIt) {
  const Model& model = hrp1s();
  const std::size_t pitch = at(static_cast<int>(std::find(model.bus_joints.begin(), model.bus_joints.end(), model.find_joint("LARM_SHOULDER_P")) - model.bus_joints.begin()));
  double nearest[2] = {1.0, 1.0};
  for (const bool told : {false, true}) {
    Guard guard(model, {});
    Collision watch(model);
    Obstacle stick = rod(0);
    stick.size.y() = 0.6;
    const Obstacle shelf = test::box_at({0.75, 0.0, 0.35}, {0.2, 1.0, 0.04});
    watch.set_obstacles({shelf, stick});
    guard.set_obstacles(told ? std::vector<Obstacle>{shelf, stick} : std::vector<Obstacle>{shelf});
    GuardRig rig(model, named_posture(model, "half_sitting"));
    Kinematics kinematics(model);
    Configuration posture = named_posture(model, "half_sitting");
    for (int i = 0; i < 1000; ++i) {
      rig.command.q[pitch] = std::max(-2.5, rig.command.q[pitch] - 0.004);
      rig.tick(guard);
      for (std::size_t k = 0; k < model.bus_joints.size(); ++k) posture.q[model.bus_joints[k]] = rig.state.q[k];
      kinematics.update(posture);
      PairDistance pair;
      if (watch.pair_nearer_than(kinematics, model.link_count(), model.link_count() + 1, 1.0, pair))
        nearest[told ? 1 : 0] = std::min(nearest[told ? 1 : 0], pair.distance);
    }
  }
  EXPECT_LT(nearest[0], 0.0);  // it would have hit it
  EXPECT_GT(nearest[1], 0.0);
}

// What is gripped stands on something: it may leave it, though it is nearer than anything else may be, and not come back.
TEST(Held, WhatStoodOnAShelfMayLeaveItAndNotReturn) {
  const Model& model = hrp1s();
  const Configuration start = named_posture(model, "half_sitting");
  Obstacle stick = rod(0);
  Obstacle shelf = test::box_at({0.0, 0.0, 0.0}, {0.3, 0.3, 0.04});
  Collision watch(model);
  Kinematics kinematics(model);
  Configuration posture = start;
  const auto apart = [&] {
    watch.set_obstacles({shelf, stick});
    kinematics.update(posture);
    PairDistance pair;
    return watch.pair_nearer_than(kinematics, model.link_count(), model.link_count() + 1, 3.0, pair) ? pair.distance : 3.0;
  };
  kinematics.update(start);
  const Hand& hand = model.hands[0];
  shelf.pose.translation() = (kinematics.link_in_world(hand.link) * hand.frame * stick.pose).translation();
  shelf.pose.translation().z() -= 0.8;
  shelf.pose.translation().z() += apart() - 0.0005;
  ASSERT_NEAR(apart(), 0.0005, 2e-4);
  const auto elbow = static_cast<std::size_t>(std::find(model.bus_joints.begin(), model.bus_joints.end(), model.find_joint("LARM_ELBOW")) - model.bus_joints.begin());
  posture.q[model.bus_joints[elbow]] -= 0.1;
  const double up = apart() > 0.001 ? -1.0 : 1.0;
  Guard guard(model, {});
  guard.set_obstacles({shelf, stick});
  GuardRig rig(model, start);
  double highest = 0.0, nearest = 1.0;
  for (int i = 0; i < 1200; ++i) {
    rig.command.q[elbow] = rig.state.q[elbow] + (i < 10 ? -0.0005 : i < 100 ? 0.02 : -0.02) * up;  // it sags first
    rig.tick(guard);
    if (i < 100) {
      EXPECT_EQ(guard.report().hold_mask, 0) << i;
    }
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) posture.q[model.bus_joints[k]] = rig.state.q[k];
    highest = std::max(highest, apart());
    if (i >= 100) nearest = std::min(nearest, apart());
  }
  EXPECT_GT(highest, 0.05);
  EXPECT_GT(nearest, 0.001);
  EXPECT_LT(nearest, 0.02);
}

TEST(Held, MessagesOfEachHandReplaceTheLastOfThatHand) {
  ObstacleCollector collector;
  ObstaclesPiece scene;
  scene.scene_id = 5;
  scene.pieces = 1;
  scene.count = 1;
  scene.shape[0] = ObstacleShape::kBox;
  scene.attitude.fill({1.0F, 0.0F, 0.0F, 0.0F});
  ObstaclesPiece held = scene;
  held.scene_id = 8;
  held.pieces = 2;
  held.piece = 1;
  EXPECT_TRUE(collector.hold(held));
  EXPECT_FALSE(collector.hold(held));  // said again
  EXPECT_TRUE(collector.add(scene));
  ASSERT_EQ(collector.obstacles().size(), 2U);
  EXPECT_EQ(collector.obstacles()[0].hand, -1);
  EXPECT_EQ(collector.obstacles()[1].hand, 1);
  held.piece = 0;
  EXPECT_TRUE(collector.hold(held));
  EXPECT_EQ(collector.obstacles().size(), 3U);
  held.scene_id = 9;
  held.count = 0;
  EXPECT_TRUE(collector.hold(held));
  EXPECT_EQ(collector.obstacles().size(), 2U);
  held.piece = 2;
  EXPECT_FALSE(collector.hold(held));  // no third hand
}

}  // namespace
}  // namespace twinbus
