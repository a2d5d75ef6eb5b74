#include "robot/kinematics/joint_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "common/math/index.h"
#include "test/collision/postures.h"

namespace twinbus {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.1;  // of every link [m]

// Seen from their common ancestor, points of the one link and of the other move by no more than is said.
TEST(JointReach, NoPointMovesFartherThanIsSaidInAnyDirection) {
  const Model& model = hrp1s();
  const JointReach reach(model, std::vector<double>(model.links.size(), kRadius));
  Kinematics now(model), then(model);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::uniform_int_distribution<int> any_link(0, model.link_count() - 1);
  double nearest = 0.0, nearest_along = 0.0, tightened = 0.0;
  for (int k = 0; k < 20000; ++k) {
    Configuration c(model), moved(model);
    Eigen::VectorXd moves(model.joint_count());
    const double scale = k % 2 == 0 ? 0.05 : 1.0;
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[at(j)];
      c.q[j] = 0.5 * (joint.lower + joint.upper + unit(random) * (joint.upper - joint.lower));
      moves[j] = k % 3 == 0 && j % 4 != 0 ? 0.0 : scale * std::abs(unit(random));
      moved.q[j] = c.q[j] + std::copysign(moves[j], unit(random));
    }
    now.update(c);
    then.update(moved);
    const int a = any_link(random), b = any_link(random);
    int common_a = a, common_b = b;
    while (common_a != common_b) {
      int& later = common_a > common_b ? common_a : common_b;
      later = model.links[at(later)].parent;
    }
    const Vector3d n = Vector3d(unit(random), unit(random), unit(random)).normalized();
    const auto moves_along_n = [&](int link) {
      const Vector3d point =
          kRadius * Vector3d(unit(random), unit(random), unit(random)).normalized();
      const Eigen::Isometry3d still =
          now.link_in_world(common_a) * then.link_in_world(common_a).inverse();
      return Vector3d(still * (then.link_in_world(link) * point) - now.link_in_world(link) * point);
    };
    const Vector3d by_a = moves_along_n(a), by_b = moves_along_n(b);
    const double said = reach.between(a, b, moves), said_along = reach.along(n, now, a, b, moves);
    ASSERT_LE((by_a - by_b).norm(), said + 1e-12) << a << " " << b;
    ASSERT_LE(std::abs(n.dot(by_a - by_b)), said_along + 1e-12) << a << " " << b;
    ASSERT_LE(said_along, said + 1e-12);
    if (!(said > 0.0)) continue;
    nearest = std::max(nearest, (by_a - by_b).norm() / said);
    nearest_along = std::max(nearest_along, std::abs(n.dot(by_a - by_b)) / said_along);
    tightened += said_along < 0.9 * said ? 1.0 : 0.0;
  }
  EXPECT_GT(nearest, 0.7);  // nor is it much more
  EXPECT_GT(nearest_along, 0.7);
  EXPECT_GT(tightened, 1000.0);
}

// Of all links that a joint moves, about its axis: what bounds every pair.
TEST(JointReach, TheFarthestIsTheMostOfAllLinks) {
  const Model& model = hrp1s();
  const JointReach reach(model, std::vector<double>(model.links.size(), kRadius));
  for (int j = 0; j < model.joint_count(); ++j) {
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(model.joint_count());
    moves[j] = 1.0;
    double most = 0.0;
    for (int link = 0; link < model.link_count(); ++link)
      most = std::max(most, reach.between(0, link, moves));
    EXPECT_DOUBLE_EQ(reach.farthest(j), most) << model.joints[at(j)].name;
    EXPECT_GT(most, 0.0);
  }
}

TEST(JointReach, WhatMovesBothOrNeitherDoesNotCount) {
  const Model& model = hrp1s();
  const JointReach reach(model, std::vector<double>(model.links.size(), kRadius));
  const Eigen::VectorXd moves = Eigen::VectorXd::Ones(model.joint_count());
  for (int link = 1; link < model.link_count(); ++link) {
    const int parent = model.links[at(link)].parent;
    Eigen::VectorXd others = moves;
    others[link - 1] = 0.0;
    EXPECT_EQ(reach.between(link, parent, others), 0.0);
    EXPECT_GT(reach.between(link, parent, moves), 0.0);
    EXPECT_EQ(reach.between(link, link, moves), 0.0);
    EXPECT_EQ(reach.between(link, -1, moves), reach.between(0, link, moves));
  }
}

// Some joints turn, some slide.
TEST(JointReach, WhatIsSaidOfAllLinksAtOnceIsWhatIsSaidOfEach) {
  Model model = hrp1s();
  for (std::size_t j = 0; j < model.joints.size(); j += 3)
    model.joints[j].kind = JointKind::kPrismatic;
  JointReach reach(model, std::vector<double>(model.links.size(), kRadius));
  std::vector<double> of_links(model.links.size(), 0.0);
  const Eigen::VectorXd moves = Eigen::VectorXd::LinSpaced(model.joint_count(), 0.1, 1.0);
  reach.from_base(moves, of_links);
  for (int link = 0; link < model.link_count(); ++link)
    EXPECT_NEAR(of_links[at(link)], reach.between(0, link, moves), 1e-12) << link;
}

}  // namespace
}  // namespace twinbus
