#include "robot/collision/exact/self_collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "common/math/index.h"
#include "test/collision/postures.h"
#include "common/allocation/no_alloc.h"
#include "test/oracles/fcl_oracle.h"

namespace twinbus {
namespace {

constexpr std::uint64_t kSelfSeed = 20261122;

const RobotGeometry& shapes() {
  static const RobotGeometry geometry = build_geometry(hrp1s());
  return geometry;
}

std::set<int> touching(SelfCollision& check, const Configuration& c) {
  check.place(c.q);
  const int n = check.touching();
  return {check.hit(), check.hit() + n};
}

// A floor, and a box on three slides over it.
struct TwoBoxes {
  Model model;
  TwoBoxes(const Eigen::Vector3d& floor, const Eigen::Vector3d& box) {
    Shape shape;
    shape.size = floor;
    model.links.resize(4);
    model.links[0].collision.push_back(shape);
    shape.size = box;
    model.links[3].collision.push_back(shape);
    for (int k = 0; k < 3; ++k) {
      Joint joint;
      joint.kind = JointKind::kPrismatic;
      joint.axis = Eigen::Vector3d::Unit(k);
      joint.parent = k;
      joint.child = k + 1;
      model.links[at(k + 1)].parent = k;
      model.joints.push_back(joint);
    }
  }
  bool touch(double x, double y, double z, bool surfaces_alone = false) {
    SelfCollision check(model, build_geometry(model), {{0, 3}});
    check.place(Eigen::Vector3d(x, y, z));
    return surfaces_alone ? check.surfaces_cross(0) : check.touching() > 0;
  }
};

TEST(SelfCollision, MissesNothingThatFclFindsAndAddsOnlyWhatTheTrianglesStickOut) {
  const Model& model = hrp1s();
  SelfCollision check(model, shapes());
  Collision distances(model);
  const FclOracle oracle(model);
  Kinematics kinematics(model);
  std::mt19937_64 random(kSelfSeed);
  const Configuration home = named_posture(model, "half_sitting");
  int hits = 0;
  for (int i = 0; i < 600; ++i) {
    const Configuration c = random_posture(model, home, i % 2 == 0 ? 1.0 : 0.3, random);
    const std::set<int> ours = touching(check, c);
    kinematics.update(c);
    for (std::size_t p = 0; p < check.pairs().size(); ++p) {
      const CollisionPair pair = check.pairs()[p];
      const bool theirs = oracle.touches(kinematics, pair);
      hits += theirs ? 1 : 0;
      const bool mine = ours.count(static_cast<int>(p)) > 0;
      if (theirs == mine) continue;
      const auto outside = [&](int link) {
        return shapes().links[at(shapes().of_link[at(link)])].outside;
      };
      PairDistance found;
      const bool near = distances.pair_nearer_than(kinematics, pair.link_a, pair.link_b, 0.01, found);
      ASSERT_TRUE(near);
      if (theirs) {
        EXPECT_NEAR(found.distance, 0.0, 1e-6) << "posture " << i << " pair " << p;
      } else {
        EXPECT_LE(found.distance, outside(pair.link_a) + outside(pair.link_b) + 1e-6);
      }
    }
  }
  EXPECT_GT(hits, 300);
}

TEST(SelfCollision, EveryInstructionSetSaysTheSame) {
  const Model& model = hrp1s();
  SelfCollision narrow(model, shapes()), wide(model, shapes());
  narrow.use(InstructionSet::kBaseline);
  std::mt19937_64 random(kSelfSeed + 1);
  const Configuration home = named_posture(model, "half_sitting");
  std::vector<float> a(wide.pairs().size()), b = a;
  for (int i = 0; i < 2000; ++i) {
    const Configuration c = random_posture(model, home, 0.7, random);
    ASSERT_EQ(touching(narrow, c), touching(wide, c)) << i;
    narrow.lower_bounds(a.data());
    wide.lower_bounds(b.data());
    ASSERT_EQ(a, b);
  }
}

TEST(SelfCollision, LowerBoundsAreBelowTheDistance) {
  const Model& model = hrp1s();
  SelfCollision check(model, shapes());
  Collision collision(model);
  Kinematics kinematics(model);
  std::mt19937_64 random(kSelfSeed + 2);
  const Configuration home = named_posture(model, "half_sitting");
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    const Configuration c = random_posture(model, home, 0.5, random);
    check.place(c.q);
    kinematics.update(c);
    for (std::size_t p = 0; p < check.pairs().size(); ++p) {
      const CollisionPair pair = check.pairs()[p];
      PairDistance found;
      if (!collision.pair_nearer_than(kinematics, pair.link_a, pair.link_b, 0.1, found)) continue;
      if (!(found.distance > 0.0)) continue;
      EXPECT_LE(check.lower_bound(static_cast<int>(p)), found.distance);
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(SelfCollision, ABoxInsideAnotherTouchesItThoughNoSurfaceIsCrossed) {
  TwoBoxes boxes({1.0, 1.0, 1.0}, {0.1, 0.1, 0.1});
  EXPECT_TRUE(boxes.touch(0.1, 0.2, 0.3));
  EXPECT_FALSE(boxes.touch(0.1, 0.2, 0.3, true));
  EXPECT_TRUE(boxes.touch(0.1, 0.2, 0.5, true));
  EXPECT_FALSE(boxes.touch(0.1, 0.2, 0.56));
  EXPECT_FALSE(boxes.touch(0.56, 0.2, 0.0));
}

TEST(SelfCollision, TrianglesInOnePlaneTouchOnlyWhereTheyOverlap) {
  TwoBoxes boxes({0.2, 0.2, 0.1}, {0.2, 0.2, 0.1});
  EXPECT_FALSE(boxes.touch(0.2001, 0.1, 0.0));  // all faces up and down lie in two planes
  EXPECT_FALSE(boxes.touch(0.2001, 0.2001, 0.0));
  EXPECT_TRUE(boxes.touch(0.1999, 0.1, 0.0));
  EXPECT_TRUE(boxes.touch(0.1, 0.1, 0.0999));
  EXPECT_FALSE(boxes.touch(0.1, 0.1, 0.1001));
}

TEST(SelfCollision, APairCanBeLeftOutAndTakenInAgain) {
  const Model& model = hrp1s();
  SelfCollision check(model, shapes());
  Configuration crossed = named_posture(model, "half_sitting");
  crossed.q[model.find_joint("RLEG_HIP_R")] = 0.5;
  crossed.q[model.find_joint("LLEG_HIP_R")] = -0.5;
  const std::set<int> before = touching(check, crossed);
  ASSERT_FALSE(before.empty());
  for (const int pair : before) check.enable(pair, false);
  EXPECT_FALSE(check.any_touching());
  for (const int pair : before) check.enable(pair, true);
  EXPECT_EQ(touching(check, crossed), before);
}

TEST(SelfCollision, AllocatesNothingAndRefusesLinksWithoutGeometry) {
  const Model& model = hrp1s();
  SelfCollision check(model, shapes());
  std::mt19937_64 random(kSelfSeed + 3);
  const Configuration c = random_posture(model, named_posture(model, "half_sitting"), 1.0, random);
  const NoAlloc no_alloc;
  check.place(c.q);
  check.touching();
  check.any_touching();
  EXPECT_EQ(no_alloc.count(), 0);
  EXPECT_THROW(SelfCollision(model, shapes(), {{0, 0}}), std::invalid_argument);
  EXPECT_THROW(SelfCollision(model, shapes(), {{0, 1000}}), std::invalid_argument);
}

}  // namespace
}  // namespace twinbus
