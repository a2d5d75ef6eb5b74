#include "test/oracles/prioritized_ik.h"

#include "test/robot/fixtures.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

// Feet where they are, centre of mass over them, a hand somewhere, posture last.
struct Standing {
  Standing() : model(hrp1s()), c(model), rest(model.joint_count()) {
    const auto& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
    for (int j = 0; j < model.joint_count(); ++j) rest[j] = pose[static_cast<std::size_t>(j)];
    c.q = rest;
    c.base.translation().z() = 0.7;
    Kinematics k(model);
    k.update(c);
    for (std::size_t side = 0; side < 2; ++side) {
      const Sole& sole = model.soles[side];
      tasks.push_back({.level = 0,
                       .link = sole.link,
                       .frame = sole.frame,
                       .target = k.link_in_world(sole.link) * sole.frame});
    }
    IkTask com{.kind = IkTaskKind::kCom, .level = 1, .axes = {1.0, 1.0, 0.0}};
    com.target.translation() = k.com();
    tasks.push_back(com);
    const Hand& hand = model.hands[1];
    tasks.push_back({.kind = IkTaskKind::kPosition,
                     .level = 2,
                     .link = hand.link,
                     .frame = hand.frame,
                     .target = k.link_in_world(hand.link) * hand.frame});
    tasks.push_back({.kind = IkTaskKind::kPosture, .level = 3, .posture = &rest});
  }
  IkTask& hand() { return tasks[3]; }
  double off(const IkTask& task) const {
    Kinematics k(model);
    k.update(c);
    if (task.kind == IkTaskKind::kCom) {
      return (k.com() - task.target.translation()).head<2>().norm();
    }
    return ((k.link_in_world(task.link) * task.frame).translation() - task.target.translation())
        .norm();
  }
  void expect_limits() const {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[static_cast<std::size_t>(j)];
      EXPECT_GE(c.q[j], joint.lower) << joint.name;
      EXPECT_LE(c.q[j], joint.upper) << joint.name;
    }
  }

  const Model& model;
  Configuration c;
  Eigen::VectorXd rest;
  std::vector<IkTask> tasks;
};

TEST(PrioritizedIk, ReachesAllThatCanBeReachedAtOnce) {
  for (const Eigen::Vector3d& way :
       {Eigen::Vector3d(0.25, 0.0, 0.2), Eigen::Vector3d(0.35, 0.1, 0.35),
        Eigen::Vector3d(0.2, -0.2, -0.25)}) {
    Standing s;
    s.hand().target.translation() += way;
    PrioritizedIk ik(s.model);
    const PrioritizedIkResult result = ik.solve(s.tasks, {}, s.c);
    EXPECT_TRUE(result.reached) << way.transpose() << ": level " << result.first_missed << " by "
                                << result.error[0] << " " << result.error[1] << " "
                                << result.error[2];
    for (int i = 0; i < 4; ++i) EXPECT_LT(s.off(s.tasks[static_cast<std::size_t>(i)]), 1.5e-6) << i;
    s.expect_limits();
  }
}

TEST(PrioritizedIk, WhatCannotBeReachedLeavesHigherLevelsAlone) {
  Standing s;
  s.hand().target.translation() += Eigen::Vector3d(2.0, 0.0, 0.5);
  const double before = s.off(s.hand());
  PrioritizedIk ik(s.model);
  const PrioritizedIkResult result = ik.solve(s.tasks, {.iterations = 300}, s.c);
  EXPECT_FALSE(result.reached);
  EXPECT_EQ(result.first_missed, 2);
  EXPECT_NEAR(result.error[2], s.off(s.hand()), 1e-9);  // it says by how much
  EXPECT_LT(s.off(s.hand()), before - 0.4);             // and came as near as it could
  EXPECT_LT(s.off(s.tasks[0]), 1e-4);
  EXPECT_LT(s.off(s.tasks[1]), 1e-4);
  EXPECT_LT(s.off(s.tasks[2]), 1e-3);
  s.expect_limits();
}

TEST(PrioritizedIk, TheHigherOfTwoThatContradictWins) {
  for (const bool hand_first : {true, false}) {
    Standing s;
    // The centre of mass half a metre off, and a hand near the body.
    s.tasks[2].target.translation().x() += 0.5;
    s.hand().target.translation() += Eigen::Vector3d(-0.1, 0.0, 0.1);
    s.tasks[2].level = hand_first ? 2 : 1;
    s.hand().level = hand_first ? 1 : 2;
    PrioritizedIk ik(s.model);
    (void)ik.solve(s.tasks, {.iterations = 300}, s.c);
    if (hand_first) {
      EXPECT_LT(s.off(s.hand()), 1e-3);
    }
    EXPECT_LT(s.off(s.tasks[0]), 1e-4);
  }
}

TEST(PrioritizedIk, HeldJointsAndAFixedBaseStay) {
  Standing s;
  s.tasks.erase(s.tasks.begin(), s.tasks.begin() + 3);
  s.tasks[0].target.translation() += Eigen::Vector3d(0.1, 0.0, 0.1);
  const Configuration before = s.c;
  PrioritizedIk ik(s.model);
  ik.free_base(false);
  const int chest = s.model.find_joint("CHEST");
  ik.hold(chest, true);
  EXPECT_TRUE(ik.solve(s.tasks, {}, s.c).reached);
  EXPECT_EQ(s.c.q[chest], before.q[chest]);
  EXPECT_EQ(s.c.base.matrix(), before.base.matrix());
}

TEST(PrioritizedIk, ThePostureTakesWhatIsLeft) {
  Standing s;
  Configuration far = s.c;
  s.c.q[s.model.find_joint("LARM_ELBOW")] -= 0.5;  // of no task but the posture
  PrioritizedIk ik(s.model);
  (void)ik.solve(s.tasks, {}, s.c);
  EXPECT_NEAR(s.c.q[s.model.find_joint("LARM_ELBOW")], far.q[s.model.find_joint("LARM_ELBOW")],
              1e-3);
}

TEST(PrioritizedIk, NonsenseMovesNothing) {
  Standing s;
  const Configuration before = s.c;
  s.hand().target.translation().x() = std::nan("");
  PrioritizedIk ik(s.model);
  EXPECT_FALSE(ik.solve(s.tasks, {}, s.c).reached);
  EXPECT_EQ(s.c.q, before.q);
  s.hand().target.translation().x() = 0.0;
  s.hand().link = 1000;
  EXPECT_FALSE(ik.solve(s.tasks, {}, s.c).reached);
}

TEST(PrioritizedIk, DoesNotAllocate) {
  Standing s;
  s.hand().target.translation() += Eigen::Vector3d(0.25, 0.0, 0.2);
  PrioritizedIk ik(s.model);
  NoAlloc no_alloc;
  (void)ik.solve(s.tasks, {}, s.c);
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus::test
