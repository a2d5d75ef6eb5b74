#include "robot/dynamics/inverse_dynamics.h"

#include "fixtures.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

double energy(const Model& model, const Kinematics& k, const Configuration& c) {
  double sum = 0.0;
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[static_cast<std::size_t>(i)];
    const Eigen::Vector3d omega = k.link_in_world(i).linear().transpose() * k.angular_velocity(i);
    sum += 0.5 * link.mass * k.point_velocity(i, k.com_of_link(i)).squaredNorm();
    sum += 0.5 * omega.dot(link.inertia * omega) + link.mass * kGravity * k.com_of_link(i).z();
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    sum += 0.5 * model.joints[static_cast<std::size_t>(j)].rotor_inertia * c.qd[j] * c.qd[j];
  }
  return sum;
}

struct Solved {
  Eigen::VectorXd tau;
  Eigen::Matrix<double, 6, 1> base;
};

Solved solve(const Model& model, const Motion& motion, double t,
             const std::vector<ExternalWrench>& external) {
  const Configuration c = motion.configuration(t);
  Kinematics k(model);
  k.update(c);
  InverseDynamics dynamics(model);
  Solved solved;
  solved.tau.resize(model.joint_count());
  solved.base = dynamics.solve(k, c, motion.qdd(t), motion.base_acceleration(t),
                               motion.base_angular_acceleration(t), external, solved.tau);
  return solved;
}

// dE/dt = tau . qd + base wrench . base twist + external power.
TEST(InverseDynamics, PowerEqualsTheChangeOfEnergy) {
  const Model model = robot_with_every_joint();
  const Motion motion(model);
  constexpr double h = 1e-5;
  for (const double t : {0.2, 0.9, 2.3}) {
    const Configuration c = motion.configuration(t);
    Kinematics k(model);
    const auto energy_at = [&](double when) {
      const Configuration other = motion.configuration(when);
      k.update(other);
      return energy(model, k, other);
    };
    const double change = (energy_at(t + h) - energy_at(t - h)) / (2 * h);
    k.update(c);
    const ExternalWrench push{
        .link = model.hands[0].link,
        .point = k.link_in_world(model.hands[0].link) * Eigen::Vector3d(0, 0, -0.1),
        .force = {10, -20, 30},
        .torque = {1, 2, -3}};
    const Solved solved = solve(model, motion, t, {push});
    const double power = solved.tau.dot(c.qd) + solved.base.head<3>().dot(c.base_velocity) +
                         solved.base.tail<3>().dot(c.base_angular_velocity) +
                         push.force.dot(k.point_velocity(push.link, push.point)) +
                         push.torque.dot(k.angular_velocity(push.link));
    EXPECT_NEAR(power, change, 1e-6 * (1.0 + std::abs(change)));
  }
}

TEST(InverseDynamics, BaseWrenchAndWeightChangeTheMomentum) {
  const Model model = robot_with_every_joint();
  const Motion motion(model, 23);
  constexpr double h = 1e-5;
  const double t = 0.8;
  Kinematics k(model);
  const auto momenta = [&](double when) {
    k.update(motion.configuration(when));
    Eigen::Matrix<double, 6, 1> both;
    both << k.mass() * k.com_velocity(), k.angular_momentum();
    return both;
  };
  const Eigen::Matrix<double, 6, 1> change = (momenta(t + h) - momenta(t - h)) / (2 * h);
  const Configuration c = motion.configuration(t);
  k.update(c);
  const Solved solved = solve(model, motion, t, {});
  const Eigen::Vector3d force =
      solved.base.head<3>() - k.mass() * kGravity * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d arm = c.base.translation() - k.com();
  const Eigen::Vector3d moment =
      solved.base.tail<3>() + arm.cross(Eigen::Vector3d(solved.base.head<3>()));
  EXPECT_LT((force - change.head<3>()).norm(), 1e-5 * (1 + change.norm()));
  EXPECT_LT((moment - change.tail<3>()).norm(), 1e-5 * (1 + change.norm()));
}

TEST(InverseDynamics, ExternalWrenchActsThroughTheJacobian) {
  const Model model = robot_with_every_joint();
  const Motion motion(model, 4);
  const double t = 0.3;
  Kinematics k(model);
  k.update(motion.configuration(t));
  const int link = model.soles[1].link;
  const Eigen::Vector3d point = k.link_in_world(link) * Eigen::Vector3d(0.1, 0.02, -0.07);
  const ExternalWrench wrench{
      .link = link, .point = point, .force = {100, 50, 600}, .torque = {5, -7, 3}};
  const Solved free = solve(model, motion, t, {});
  const Solved pushed = solve(model, motion, t, {wrench});
  Eigen::MatrixXd jacobian(6, 6 + model.joint_count());
  k.point_jacobian(link, point, jacobian);
  Eigen::Matrix<double, 6, 1> w;
  w << wrench.force, wrench.torque;
  const Eigen::VectorXd expected = jacobian.transpose() * w;
  EXPECT_LT((free.tau - pushed.tau - expected.tail(model.joint_count())).norm(), 1e-9);
  EXPECT_LT((free.base - pushed.base - expected.head<6>()).norm(), 1e-9);
}

TEST(InverseDynamics, StandingNeedsTheWeight) {
  const Model& model = hrp1s();
  Configuration c(model);
  Kinematics k(model);
  k.update(c);
  InverseDynamics dynamics(model);
  Eigen::VectorXd tau(model.joint_count());
  const auto base = dynamics.solve(k, c, Eigen::VectorXd::Zero(model.joint_count()),
                                   Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {}, tau);
  EXPECT_NEAR(base[2], 130.8 * kGravity, 1e-9);
}

TEST(InverseDynamics, DoesNotAllocate) {
  const Model& model = hrp1s();
  const Configuration c = Motion(model).configuration(0.5);
  Kinematics k(model);
  k.update(c);
  InverseDynamics dynamics(model);
  Eigen::VectorXd tau(model.joint_count());
  const Eigen::VectorXd qdd = Eigen::VectorXd::Ones(model.joint_count());
  const std::vector<ExternalWrench> external(2);
  NoAlloc no_alloc;
  dynamics.solve(k, c, qdd, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), external, tau);
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus::test
