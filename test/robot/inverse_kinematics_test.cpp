#include "robot/kinematics/inverse_kinematics.h"

#include "fixtures.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

Eigen::VectorXd half_sitting(const Model& model) {
  const auto& q = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
  return Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
}

struct Case {
  const char* name;
  int base, link;
  Eigen::Isometry3d frame;
};

std::vector<Case> chains(const Model& model) {
  return {{"left leg", 0, model.soles[0].link, model.soles[0].frame},
          {"right leg", 0, model.soles[1].link, model.soles[1].frame},
          {"left arm", model.find_link("CHEST"), model.hands[0].link, model.hands[0].frame},
          {"right arm and waist", 0, model.hands[1].link, model.hands[1].frame}};
}

// Within the limits, away from them by a share.
void randomise(const Model& model, const std::vector<int>& joints, std::mt19937& random,
               Eigen::VectorXd& q) {
  std::uniform_real_distribution<double> place(0.05, 0.95);
  for (const int j : joints) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    q[j] = joint.lower + place(random) * (joint.upper - joint.lower);
  }
}

TEST(InverseKinematics, PoseAgreesWithKinematics) {
  const Model model = robot_with_every_joint();
  const Configuration c = Motion(model).configuration(0.4);
  Kinematics k(model);
  k.update(c);
  for (const Case& chain : chains(model)) {
    const InverseKinematics ik(model, chain.base, chain.link, chain.frame);
    const Eigen::Isometry3d expected =
        k.link_in_world(chain.base).inverse() * k.link_in_world(chain.link) * chain.frame;
    EXPECT_TRUE(ik.pose(c.q).isApprox(expected, 1e-12)) << chain.name;
  }
}

TEST(InverseKinematics, ReachesEveryPoseTheChainCanTakeWithRestarts) {
  const Model& model = hrp1s();
  std::mt19937 random(1);
  for (const Case& chain : chains(model)) {
    InverseKinematics ik(model, chain.base, chain.link, chain.frame);
    int missed = 0;
    for (int i = 0; i < 200; ++i) {
      Eigen::VectorXd q = half_sitting(model);
      randomise(model, ik.joints(), random, q);
      const Eigen::Isometry3d target = ik.pose(q);
      Eigen::VectorXd found = half_sitting(model);
      const IkResult result = ik.solve(target, {.restarts = 20}, found);
      missed += result.reached ? 0 : 1;
      if (result.reached) {
        EXPECT_LT((ik.pose(found).translation() - target.translation()).norm(), 2e-6);
        EXPECT_LT(rotation_vector(ik.pose(found).linear() * target.linear().transpose()).norm(),
                  2e-6);
      }
      for (const int j : ik.joints()) {
        EXPECT_GE(found[j], model.joints[static_cast<std::size_t>(j)].lower);
        EXPECT_LE(found[j], model.joints[static_cast<std::size_t>(j)].upper);
      }
    }
    EXPECT_LE(missed, 4) << chain.name;
  }
}

TEST(InverseKinematics, NearbyTargetsTakeFewSteps) {
  const Model& model = hrp1s();
  InverseKinematics ik(model, 0, model.soles[0].link, model.soles[0].frame);
  Eigen::VectorXd q = half_sitting(model);
  Eigen::Isometry3d target = ik.pose(q);
  target.translation() += Eigen::Vector3d(0.002, -0.001, 0.001);
  const IkResult result = ik.solve(target, {}, q);
  EXPECT_TRUE(result.reached);
  EXPECT_LE(result.iterations, 5);
}

TEST(InverseKinematics, OutOfReachEndsAtTheNearestPosture) {
  const Model& model = hrp1s();
  InverseKinematics ik(model, model.find_link("CHEST"), model.hands[0].link, model.hands[0].frame);
  Eigen::VectorXd q = half_sitting(model);
  Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
  target.translation() << 0.3, 2.0, -0.2;
  const IkResult result = ik.solve(target, {.rotation_weight = 0.0}, q);
  EXPECT_FALSE(result.reached);
  // Nearest: the arm points at the target.  Shoulder at (0, 0.21, 0), length 0.263 + 0.247 + 0.09.
  const double distance = (target.translation() - Eigen::Vector3d(0, 0.21, 0)).norm();
  EXPECT_NEAR(result.position_error, distance - 0.600, 2e-3);
}

TEST(InverseKinematics, AHeldJointStaysWhereItIs) {
  const Model& model = hrp1s();
  const Hand& hand = model.hands[0];
  Eigen::VectorXd there = half_sitting(model);
  for (const int j : hand.joints) there[j] += 0.2;
  InverseKinematics ik(model, 0, hand.link, hand.frame);  // with the waist
  const int waist = ik.joints().front();
  const Eigen::Isometry3d target = ik.pose(there);
  for (const int restarts : {0, 5}) {
    for (const double place : {there[waist], 0.1}) {
      ik.hold(waist, place);
      Eigen::VectorXd q = half_sitting(model);
      EXPECT_TRUE(ik.solve(target, {.rotation_weight = 0.0, .restarts = restarts}, q).reached);
      EXPECT_EQ(q[waist], place);
    }
  }
}

TEST(InverseKinematics, NonsenseChangesNothing) {
  const Model& model = hrp1s();
  InverseKinematics ik(model, 0, model.soles[0].link, model.soles[0].frame);
  Eigen::VectorXd q = half_sitting(model);
  Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
  target.translation().x() = std::nan("");
  EXPECT_FALSE(ik.solve(target, {}, q).reached);
  EXPECT_EQ(q, half_sitting(model));
  EXPECT_THROW(InverseKinematics(model, model.soles[0].link, 0, Eigen::Isometry3d::Identity()),
               std::runtime_error);
}

TEST(InverseKinematics, DoesNotAllocate) {
  const Model& model = hrp1s();
  InverseKinematics ik(model, 0, model.hands[0].link, model.hands[0].frame);
  Eigen::VectorXd q = half_sitting(model);
  Eigen::Isometry3d target = ik.pose(q);
  target.translation().x() += 0.1;
  NoAlloc no_alloc;
  const IkResult result = ik.solve(target, {.restarts = 3}, q);
  EXPECT_EQ(no_alloc.count(), 0);
  EXPECT_TRUE(result.reached);
}

}  // namespace
}  // namespace twinbus::test
