#include "robot/collision/hull_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "robot/collision/collision_body.h"
#include "geometry/distance/convex_shape.h"
#include "geometry/distance/gjk.h"
#include "common/math/index.h"
#include "test/collision/postures.h"
#include "test/no_alloc.h"

namespace twinbus {
namespace {

constexpr double kNear = 0.05, kSame = 1e-6;  // [m]

class HullDistancesOfARobot : public testing::Test {
 protected:
  HullDistancesOfARobot() : model_(hrp1s()), hulls_(model_), kinematics_(model_), found_(2000) {
    for (int link = 0; link < model_.link_count(); ++link) {
      const auto& shapes = model_.links[at(link)].collision;
      if (shapes.size() == 1 && shapes[0].kind != ShapeKind::kMesh)
        alone_.emplace(link, collision_shape(shapes[0]));
    }
  }
  int look(double spread) {
    kinematics_.update(
        random_posture(model_, named_posture(model_, "half_sitting"), spread, random_));
    return hulls_.near(kinematics_, kNear, found_.data(), 2000);
  }
  bool both_alone(int link_a, int link_b) const {
    return alone_.contains(link_a) && alone_.contains(link_b);
  }
  Eigen::Isometry3d pose(int link) const {
    return kinematics_.link_in_world(link) * alone_.at(link).local;
  }

  const Model& model_;
  HullDistances hulls_;
  Kinematics kinematics_;
  std::vector<PairDistance> found_;
  std::map<int, CollisionShape> alone_;  // of links that have one shape
  std::mt19937_64 random_{31};
};

// Between links of one shape each: along the normal they are as far apart as the points that are named.
TEST_F(HullDistancesOfARobot, AreProvedFromBothSides) {
  int proved = 0, overlapping = 0;
  for (int i = 0; i < 1500; ++i) {
    const int count = look(0.7);
    for (int k = 0; k < count; ++k) {
      const PairDistance& p = found_[at(k)];
      EXPECT_LE(p.distance, kNear);
      EXPECT_LE(found_[at(std::max(k - 1, 0))].distance, p.distance);
      if (!(p.distance > 1e-7)) {
        ++overlapping;
        continue;
      }
      EXPECT_NEAR((p.point_b - p.point_a).norm(), p.distance, 1e-9);
      EXPECT_NEAR((p.point_b - p.point_a).normalized().dot(p.normal), 1.0, 1e-9);
      if (!both_alone(p.link_a, p.link_b)) continue;
      const Eigen::Isometry3d a = pose(p.link_a), b = pose(p.link_b);
      EXPECT_NEAR(separation({&alone_.at(p.link_a).convex, &a}, {&alone_.at(p.link_b).convex, &b},
                             p.normal),
                  p.distance, kSame);
      ++proved;
    }
  }
  EXPECT_GT(proved, 100);
  EXPECT_GT(overlapping, 10);
}

TEST_F(HullDistancesOfARobot, LeaveOutNoPairThatIsNear) {
  int far = 0;
  for (int i = 0; i < 40; ++i) {
    const int count = look(0.7);
    for (const CollisionPair& pair : hulls_.pairs()) {
      const bool named =
          std::any_of(found_.begin(), found_.begin() + count, [&](const PairDistance& p) {
            return p.link_a == pair.link_a && p.link_b == pair.link_b;
          });
      if (named || !both_alone(pair.link_a, pair.link_b)) continue;
      const GjkResult r = gjk_distance(alone_.at(pair.link_a).core, pose(pair.link_a),
                                       alone_.at(pair.link_b).core, pose(pair.link_b), kNear);
      EXPECT_GT(r.distance, kNear - 1e-7);
      ++far;
    }
  }
  EXPECT_GT(far, 1000);
}

TEST_F(HullDistancesOfARobot, AreTheNearestWhenThereIsNoRoomForAll) {
  PairDistance few[3];
  for (int i = 0; i < 50; ++i) {
    const int count = look(0.7);
    const NoAlloc no_alloc;
    ASSERT_EQ(hulls_.near(kinematics_, kNear, few, 3), std::min(count, 3));
    EXPECT_EQ(no_alloc.count(), 0);
    for (int k = 0; k < std::min(count, 3); ++k) EXPECT_EQ(few[k].distance, found_[at(k)].distance);
  }
}

// The gradient: a link that moves along the normal moves away by as much.
TEST_F(HullDistancesOfARobot, TheNormalIsTheGradient) {
  const int joints = model_.joint_count();
  int checked = 0;
  for (int i = 0; i < 30; ++i) {
    const Configuration from =
        random_posture(model_, named_posture(model_, "half_sitting"), 0.5, random_);
    const auto distance_of = [&](const CollisionPair& pair, const Configuration& c,
                                 PairDistance& p) {
      kinematics_.update(c);
      const int count = hulls_.near(kinematics_, kNear, found_.data(), 2000);
      for (int k = 0; k < count; ++k) {
        p = found_[at(k)];
        if (p.link_a == pair.link_a && p.link_b == pair.link_b && p.distance > 1e-3) return true;
      }
      return false;
    };
    kinematics_.update(from);
    if (hulls_.near(kinematics_, kNear, found_.data(), 2000) == 0) continue;
    const CollisionPair pair{found_[0].link_a, found_[0].link_b};
    PairDistance at_first, later;
    if (!distance_of(pair, from, at_first)) continue;
    const Eigen::Isometry3d a = kinematics_.link_in_world(pair.link_a),
                            b = kinematics_.link_in_world(pair.link_b);
    for (int j = 0; j < joints; ++j) {
      constexpr double kStep = 1e-4;
      Configuration to = from;
      to.q[j] += kStep;
      if (!distance_of(pair, to, later)) continue;
      const Eigen::Vector3d moved_a =
          kinematics_.link_in_world(pair.link_a) * (a.inverse() * at_first.point_a) -
          at_first.point_a;
      const Eigen::Vector3d moved_b =
          kinematics_.link_in_world(pair.link_b) * (b.inverse() * at_first.point_b) -
          at_first.point_b;
      EXPECT_NEAR(later.distance - at_first.distance, at_first.normal.dot(moved_b - moved_a), 2e-6);
      ++checked;
    }
  }
  EXPECT_GT(checked, 50);
}

}  // namespace
}  // namespace twinbus
