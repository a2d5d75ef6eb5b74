#include "robot/kinematics/kinematics.h"

#include <algorithm>

#include "fixtures.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

constexpr double kStep = 1e-6;  // [s]

Kinematics updated(const Model& model, const Configuration& configuration) {
  Kinematics kinematics(model);
  kinematics.update(configuration);
  return kinematics;
}

TEST(Kinematics, VelocitiesAreDerivativesOfPoses) {
  const Model model = robot_with_every_joint();
  const Motion motion(model);
  Kinematics now(model), before(model), after(model);
  for (const double t : {0.1, 0.7, 1.9}) {
    now.update(motion.configuration(t));
    before.update(motion.configuration(t - kStep));
    after.update(motion.configuration(t + kStep));
    for (int i = 0; i < model.link_count(); ++i) {
      const Eigen::Isometry3d& a = before.link_in_world(i);
      const Eigen::Isometry3d& b = after.link_in_world(i);
      const Eigen::Vector3d velocity = (b.translation() - a.translation()) / (2 * kStep);
      const Eigen::Vector3d omega =
          rotation_vector(b.linear() * a.linear().transpose()) / (2 * kStep);
      EXPECT_LT((now.origin_velocity(i) - velocity).norm(), 1e-7)
          << model.links[static_cast<std::size_t>(i)].name;
      EXPECT_LT((now.angular_velocity(i) - omega).norm(), 1e-7)
          << model.links[static_cast<std::size_t>(i)].name;
    }
    EXPECT_LT((now.com_velocity() - (after.com() - before.com()) / (2 * kStep)).norm(), 1e-7);
  }
}

TEST(Kinematics, SomeJointsMoveTheirLinksAlone) {
  const Model model = robot_with_every_joint();
  const Motion motion(model, 5);
  Kinematics all(model), some(model), before(model);
  before.update(motion.configuration(0.3));
  some.update(motion.configuration(0.3));
  all.update(motion.configuration(0.9));
  std::vector<int> joints;  // up to the last link
  for (int link = model.link_count() - 1; link > 0;
       link = model.links[static_cast<std::size_t>(link)].parent)
    joints.insert(joints.begin(), link - 1);
  ASSERT_LT(static_cast<int>(joints.size()), model.joint_count());
  some.update(motion.configuration(0.9), joints);
  EXPECT_EQ(some.com(), before.com());
  EXPECT_TRUE(some.link_in_world(0).isApprox(all.link_in_world(0), 0.0));
  for (int j = 0; j < model.joint_count(); ++j) {
    const bool moved = std::find(joints.begin(), joints.end(), j) != joints.end();
    const Kinematics& same = moved ? all : before;
    EXPECT_TRUE(some.link_in_world(j + 1).isApprox(same.link_in_world(j + 1), 0.0)) << j;
    EXPECT_EQ(some.origin_velocity(j + 1), same.origin_velocity(j + 1)) << j;
  }
}

TEST(Kinematics, JacobiansTimesSpeedsAreVelocities) {
  const Model model = robot_with_every_joint();
  const Configuration c = Motion(model, 11).configuration(0.4);
  const Kinematics kinematics = updated(model, c);
  Eigen::VectorXd speeds(6 + model.joint_count());
  speeds << c.base_velocity, c.base_angular_velocity, c.qd;
  Eigen::MatrixXd jacobian(6, 6 + model.joint_count());
  for (int i = 0; i < model.link_count(); ++i) {
    const Eigen::Vector3d point = kinematics.link_in_world(i) * Eigen::Vector3d(0.1, -0.2, 0.3);
    kinematics.point_jacobian(i, point, jacobian);
    const Eigen::VectorXd twist = jacobian * speeds;
    EXPECT_LT((twist.head<3>() - kinematics.point_velocity(i, point)).norm(), 1e-12);
    EXPECT_LT((twist.tail<3>() - kinematics.angular_velocity(i)).norm(), 1e-12);
  }
  Eigen::MatrixXd com_jacobian(3, 6 + model.joint_count());
  kinematics.com_jacobian(com_jacobian);
  EXPECT_LT((com_jacobian * speeds - kinematics.com_velocity()).norm(), 1e-12);
}

TEST(Kinematics, JacobianColumnsAreFiniteDifferences) {
  const Model model = robot_with_every_joint();
  const Configuration c = Motion(model, 3).configuration(1.2);
  const Kinematics kinematics = updated(model, c);
  const int link = model.hands[0].link;
  const Eigen::Vector3d local(0.02, 0.03, -0.09);
  Eigen::MatrixXd jacobian(6, 6 + model.joint_count()), com_jacobian(3, 6 + model.joint_count());
  kinematics.point_jacobian(link, kinematics.link_in_world(link) * local, jacobian);
  kinematics.com_jacobian(com_jacobian);
  Kinematics other(model);
  for (int j = 0; j < model.joint_count(); ++j) {
    Configuration plus = c, minus = c;
    plus.q[j] += 1e-6;
    minus.q[j] -= 1e-6;
    other.update(plus);
    const Eigen::Vector3d p = other.link_in_world(link) * local, com = other.com();
    other.update(minus);
    const Eigen::Vector3d slope = (p - other.link_in_world(link) * local) / 2e-6;
    EXPECT_LT((jacobian.block<3, 1>(0, 6 + j) - slope).norm(), 1e-8);
    EXPECT_LT((com_jacobian.col(6 + j) - (com - other.com()) / 2e-6).norm(), 1e-8);
  }
}

// Without forces momentum is kept; here: angular momentum does not depend on how fast the whole
// robot translates, and a rigid robot spinning about a principal direction has I omega.
TEST(Kinematics, AngularMomentumIsAboutTheCentreOfMass) {
  const Model& model = hrp1s();
  const Motion motion(model, 5);
  Configuration c = motion.configuration(0.3);
  Kinematics kinematics(model);
  kinematics.update(c);
  const Eigen::Vector3d slow = kinematics.angular_momentum();
  c.base_velocity += Eigen::Vector3d(3, -2, 1);
  kinematics.update(c);
  EXPECT_LT((kinematics.angular_momentum() - slow).norm(), 1e-9);

  c.qd.setZero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[static_cast<std::size_t>(i)];
    const Eigen::Matrix3d r = kinematics.link_in_world(i).linear();
    const Eigen::Matrix3d offset = skew(kinematics.com_of_link(i) - kinematics.com());
    inertia += r * link.inertia * r.transpose() - link.mass * offset * offset;
  }
  kinematics.update(c);
  EXPECT_LT((kinematics.angular_momentum() - inertia * c.base_angular_velocity).norm(), 1e-9);
}

TEST(Kinematics, MimicJointsFollow) {
  Model model = hrp1s();
  Joint& follower = model.joints[static_cast<std::size_t>(model.find_joint("LARM_WRIST_R"))];
  follower.mimic = model.find_joint("LARM_WRIST_P");
  follower.mimic_multiplier = -2.0;
  follower.mimic_offset = 0.25;
  RobotState state;
  state.q[static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(follower.mimic)])] =
      0.1;
  state.qd[static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(follower.mimic)])] =
      3.0f;
  Configuration c(model);
  set_joints(model, state, c);
  EXPECT_NEAR(c.q[model.find_joint("LARM_WRIST_R")], 0.05, 1e-12);
  EXPECT_NEAR(c.qd[model.find_joint("LARM_WRIST_R")], -6.0, 1e-6);
}

TEST(Kinematics, UpdateAndJacobiansDoNotAllocate) {
  const Model& model = hrp1s();
  Kinematics kinematics(model);
  const Configuration c = Motion(model).configuration(0.5);
  Eigen::MatrixXd jacobian(6, 6 + model.joint_count()), com_jacobian(3, 6 + model.joint_count());
  NoAlloc no_alloc;
  kinematics.update(c);
  kinematics.point_jacobian(model.hands[1].link, Eigen::Vector3d(1, 2, 3), jacobian);
  kinematics.com_jacobian(com_jacobian);
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus::test
