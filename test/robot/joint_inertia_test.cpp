#include "robot/dynamics/joint_inertia.h"

#include <numeric>
#include <span>

#include "fixtures.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

// tau of inverse dynamics that one joint's acceleration alone causes.
Eigen::MatrixXd by_inverse_dynamics(const Model& model, const Kinematics& kinematics, const Configuration& c) {
  InverseDynamics dynamics(model);
  const Eigen::Index n = model.joint_count();
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  Eigen::VectorXd none = Eigen::VectorXd::Zero(n), bias(n), tau(n);
  dynamics.solve(kinematics, c, none, still, still, {}, bias);
  Eigen::MatrixXd h(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    Eigen::VectorXd one = none;
    one[j] = 1.0;
    dynamics.solve(kinematics, c, one, still, still, {}, tau);
    h.col(j) = tau - bias;
  }
  return h;
}

Eigen::VectorXd product(const JointInertia& inertia, const Eigen::VectorXd& x) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
  for (int i = 0; i < x.size(); ++i) {
    for (int j = 0; j < x.size(); ++j) y[i] += inertia(i, j) * x[j];
  }
  return y;
}

struct Fixture {
  Model model = robot_with_every_joint();
  Configuration c = Motion(model).configuration(0.7);
  Kinematics kinematics{model};
  JointInertia inertia{model};
  Fixture() { kinematics.update(c); }
};

TEST(JointInertia, IsWhatInverseDynamicsNeedsForAUnitAcceleration) {
  Fixture f;
  const Eigen::MatrixXd expected = by_inverse_dynamics(f.model, f.kinematics, f.c);
  std::vector<int> all(f.model.joints.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<int> some{1, 3, 8, 9, 12, 17, 20};
  for (const std::vector<int>& joints : {all, some}) {
    f.inertia = JointInertia(f.model);
    f.inertia.update(f.kinematics, joints);
    const int n = f.inertia.size();
    ASSERT_EQ(n, static_cast<int>(joints.size()));
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j)
        wanted[i] += expected(joints[static_cast<std::size_t>(i)], joints[static_cast<std::size_t>(j)]) * x[j];
    }
    EXPECT_LT((product(f.inertia, x) - wanted).norm(), 1e-9 * wanted.norm());
    EXPECT_NEAR(f.inertia(0, 0), expected(joints[0], joints[0]), 1e-9);
  }
}

TEST(JointInertia, SolvesWithWhatIsAddedToItsDiagonal) {
  Fixture f;
  const std::vector<int> joints{0, 1, 2, 6, 7, 11, 15, 18};
  f.inertia.update(f.kinematics, joints);
  const int n = f.inertia.size();
  Eigen::VectorXd added = Eigen::VectorXd::LinSpaced(n, 0.0, 0.7), x = Eigen::VectorXd::LinSpaced(n, 3.0, -1.0);
  Eigen::VectorXd y = product(f.inertia, x) + added.cwiseProduct(x);
  std::vector<double> factor(static_cast<std::size_t>(JointInertia::kFactor));
  NoAlloc no_alloc;
  f.inertia.factor(added.data(), factor.data());
  f.inertia.solve(factor.data(), y.data());
  EXPECT_EQ(no_alloc.count(), 0);
  EXPECT_LT((y - x).norm(), 1e-9);
}

}  // namespace
}  // namespace twinbus::test
