#include "control/legs/whole_body_ik.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/math/pose_math.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

struct Bent : testing::Test {
  Bent() : ik(test::hrp1s()), start(test::hrp1s()) {
    const Model& m = test::hrp1s();
    const NamedPose& pose = m.poses[static_cast<std::size_t>(m.find_pose("half_sitting"))];
    for (int j = 0; j < m.joint_count(); ++j) start.q[j] = pose.q[static_cast<std::size_t>(j)];
    Kinematics k(m);
    k.update(start);
    for (std::size_t f = 0; f < 2; ++f)
      soles[f] = k.link_in_world(m.soles[f].link) * m.soles[f].frame;
    com = k.com();
    ik.start(start);
  }
  double miss() {
    const Model& m = test::hrp1s();
    Kinematics k(m);
    k.update(ik.configuration());
    double worst = (k.com() - com).norm();
    for (std::size_t f = 0; f < 2; ++f) {
      const Eigen::Isometry3d is = k.link_in_world(m.soles[f].link) * m.soles[f].frame;
      worst = std::max({worst, (is.translation() - soles[f].translation()).norm(),
                        rotation_vector(is.linear() * soles[f].linear().transpose()).norm()});
    }
    return worst;
  }
  WholeBodyIk ik;
  Configuration start;
  std::array<Eigen::Isometry3d, 2> soles;
  Eigen::Vector3d com;
};

TEST_F(Bent, FindsTheCentreOfMassAndBothSoles) {
  com += Eigen::Vector3d(0.03, -0.05, 0.02);
  soles[0].translation() += Eigen::Vector3d(0.15, 0.02, 0.03);
  soles[0].linear() = rotation_z(0.2) * soles[0].linear();
  ik.solve(com, rotation_z(0.1), soles, start.q, 12);
  EXPECT_LT(miss(), 1e-6);
}

TEST_F(Bent, OneRoundATickFollowsAMovingTarget) {
  const Eigen::Vector3d com0 = com;
  const Eigen::Vector3d foot0 = soles[1].translation();
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.002 * i;
    com = com0 + Eigen::Vector3d(0.02 * std::sin(3.0 * t), 0.03 * std::sin(5.0 * t), 0.0);
    soles[1].translation() =
        foot0 + Eigen::Vector3d(0.1 * std::sin(4.0 * t), 0.0, 0.04 * (1.0 - std::cos(6.0 * t)));
    ik.solve(com, Eigen::Matrix3d::Identity(), soles, start.q, 1);
    worst = std::max(worst, miss());
  }
  EXPECT_LT(worst, 1.5e-4);
}

TEST_F(Bent, ATargetOutOfReachStraightensTheLegsWithoutAJump) {
  const Eigen::Vector3d com0 = com;
  Eigen::VectorXd last = ik.configuration().q;
  double fastest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    com = com0 + Eigen::Vector3d(0.0, 0.0, 0.0003 * i);
    ik.solve(com, Eigen::Matrix3d::Identity(), soles, start.q, 2);
    ASSERT_TRUE(ik.configuration().q.allFinite());
    fastest = std::max(fastest, (ik.configuration().q - last).cwiseAbs().maxCoeff() / 0.002);
    last = ik.configuration().q;
  }
  EXPECT_LT(fastest, 10.0);
}

TEST_F(Bent, NoJointLeavesItsLimits) {
  const Model& m = test::hrp1s();
  soles[0].translation() += Eigen::Vector3d(1.0, 1.0, 1.0);
  ik.solve(com, Eigen::Matrix3d::Identity(), soles, start.q, 30);
  for (int j = 0; j < m.joint_count(); ++j) {
    EXPECT_GE(ik.configuration().q[j], m.joints[static_cast<std::size_t>(j)].lower);
    EXPECT_LE(ik.configuration().q[j], m.joints[static_cast<std::size_t>(j)].upper);
  }
}

}  // namespace
}  // namespace twinbus
