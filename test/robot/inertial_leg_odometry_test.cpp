#include "robot/estimation/inertial_leg_odometry.h"

#include "fixtures.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

constexpr double kStateTick = 0.002;

std::size_t side_of(int foot) { return static_cast<std::size_t>(foot); }

// hrp1s in half_sitting as one rigid body that is moved by hand.
class Body {
 public:
  Body() : model(hrp1s()), truth(model), kinematics(model), dynamics(model) {
    const auto& q = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
    truth.q = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
    kinematics.update(truth);
    weight = kGravity * model.total_mass();
  }

  // What is measured while the base's origin accelerates by a (world); feet say the force (world) and the centre of pressure in
  // the sole's frame, nothing where share is 0.
  RobotState state(const Eigen::Vector3d& a, double left, double right, double pressure_x = 0.0, double imu_yaw = 0.3) {
    kinematics.update(truth);
    RobotState s;
    s.tick = tick;
    s.time_ns = 2'000'000 * tick++;
    s.run_id = 5;
    s.joint_count = static_cast<std::int16_t>(model.bus_count());
    s.sensor_flags = kEncodersValid | kImuValid | wrench_valid(kLeftFoot) | wrench_valid(kRightFoot);
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      s.q[k] = truth.q[model.bus_joints[k]];
      s.qd[k] = static_cast<float>(truth.qd[model.bus_joints[k]]);
    }
    const Eigen::Isometry3d imu = kinematics.link_in_world(model.imu_link) * model.imu;
    const Eigen::Vector3d w = kinematics.angular_velocity(model.imu_link);
    const Eigen::Vector3d arm = imu.translation() - truth.base.translation();
    s.attitude = array_from_rotation<float>(rotation_z(imu_yaw) * imu.linear());
    s.gyro = array_from_vector<float>(imu.linear().transpose() * w);
    const Eigen::Vector3d felt = a + w.cross(w.cross(arm)) + kGravity * Eigen::Vector3d::UnitZ();
    s.accel = array_from_vector<float>(imu.linear().transpose() * felt);
    const double shares[2] = {left, right};
    for (int foot = 0; foot < 2; ++foot) {
      s.wrench_kind[side_of(foot)] = WrenchKind::kMeasured;
      const Sole& sole = model.soles[side_of(foot)];
      const Eigen::Isometry3d sensor = kinematics.link_in_world(sole.link) * sole.sensor;
      const Eigen::Vector3d force(0.0, 0.0, shares[foot] * weight);
      const Eigen::Vector3d point = kinematics.link_in_world(sole.link) * sole.frame * Eigen::Vector3d(pressure_x, 0.0, 0.0);
      const Eigen::Vector3d f = sensor.linear().transpose() * force;
      const Eigen::Vector3d m = sensor.linear().transpose() * (point - sensor.translation()).cross(force);
      for (Eigen::Index i = 0; i < 3; ++i) {
        s.wrench[side_of(foot)][static_cast<std::size_t>(i)] = static_cast<float>(f[i]);
        s.wrench[side_of(foot)][static_cast<std::size_t>(i) + 3] = static_cast<float>(m[i]);
      }
    }
    return s;
  }

  const Model& model;
  Configuration truth;
  Kinematics kinematics;
  InverseDynamics dynamics;
  double weight = 0.0;
  std::int64_t tick = 0;
};

Eigen::Vector3d velocity_of(const InertialLegOdometry& odometry) { return vector_from_array(odometry.estimate().base_velocity); }

TEST(InertialLegOdometry, ARobotThatStandsIsAtRestOnBothFeet) {
  Body body;
  InertialLegOdometry odometry(body.model);
  for (int i = 0; i < 500; ++i) odometry.update(body.state(Eigen::Vector3d::Zero(), 0.5, 0.5));
  const Estimate& e = odometry.estimate();
  EXPECT_LT(velocity_of(odometry).norm(), 1e-6);
  EXPECT_EQ(e.foot_count, 2);
  EXPECT_TRUE(e.foot_stands[0] && e.foot_stands[1]);
  EXPECT_NEAR(static_cast<double>(e.foot_load[0]), 0.5, 1e-6);
  EXPECT_EQ(e.load_from, LoadFrom::kForces);
  EXPECT_EQ(e.velocity_from, VelocityFrom::kFeetAndAccelerometer);
  EXPECT_NEAR(static_cast<double>(e.foot_position[1][2]), 0.0, 1e-4);
  EXPECT_LT(e.velocity_deviation[0], 0.04F);
  EXPECT_EQ(e.foot_joint[0], body.model.bus_index[side_of(body.model.soles[0].link - 1)]);
}

// Nothing but the accelerometer: v = a t, and the variance grows by q t.
TEST(InertialLegOdometry, InTheAirTheAccelerometerAloneIsIntegrated) {
  Body body;
  InertialLegOdometry odometry(body.model);
  for (int i = 0; i < 500; ++i) odometry.update(body.state(Eigen::Vector3d::Zero(), 0.5, 0.5));
  const double before = static_cast<double>(odometry.estimate().velocity_deviation[0]);
  const Eigen::Vector3d a(1.5, -0.7, -kGravity);
  for (int i = 0; i < 100; ++i) odometry.update(body.state(a, 0.0, 0.0));
  const Estimate& e = odometry.estimate();
  EXPECT_LT((velocity_of(odometry) - 0.2 * a).norm(), 1e-3);
  const double q = 0.08 * 0.08 * 0.02 / 0.01;
  EXPECT_NEAR(static_cast<double>(e.velocity_deviation[0]), std::sqrt(before * before + 0.2 * q), 1e-4);
  EXPECT_EQ(e.velocity_from, VelocityFrom::kAccelerometer);
  EXPECT_FALSE(e.foot_stands[0] || e.foot_stands[1]);
}

// A body that tips over the front edge of its soles: v = w x r about that edge, though the middle of the soles moves.
TEST(InertialLegOdometry, ARobotThatTipsTurnsAboutTheCentreOfPressure) {
  Body body;
  InertialLegOdometry odometry(body.model);
  const Sole& sole = body.model.soles[0];
  const Eigen::Vector3d edge = body.kinematics.link_in_world(sole.link) * sole.frame * Eigen::Vector3d(sole.front, 0.0, 0.0);
  const Eigen::Vector3d w(0.0, 0.2, 0.0);
  for (int i = 0; i < 400; ++i) {
    const Eigen::Matrix3d turn = rotation_of(kStateTick * i * w);
    const Eigen::Vector3d arm = turn * (Eigen::Vector3d(0.0, edge.y(), 0.0) - edge);
    body.truth.base.linear() = turn;
    body.truth.base.translation() = arm;
    body.truth.base_angular_velocity = w;
    body.truth.base_velocity = w.cross(arm);
    odometry.update(body.state(w.cross(w.cross(arm)), 0.5, 0.5, sole.front));
    if (i < 200) continue;
    ASSERT_LT((rotation_z(yaw_of(turn)) * velocity_of(odometry) - w.cross(arm)).norm(), 2e-3) << i;
  }
  // In the axes of the base the velocity is the same vector; at the IMU it is w x r of the IMU.
  const Estimate& e = odometry.estimate();
  const Eigen::Vector3d at_base = quaternion_from_array(e.base_attitude) * vector_from_array(e.velocity_in_base);
  EXPECT_LT((at_base - velocity_of(odometry)).norm(), 1e-6);
  const Eigen::Isometry3d imu = body.kinematics.link_in_world(body.model.imu_link) * body.model.imu;
  const Eigen::Vector3d arm = imu.translation() - body.truth.base.translation();
  const Eigen::Vector3d expected = imu.linear().transpose() * (body.truth.base_velocity + w.cross(arm));
  EXPECT_LT((vector_from_array(e.imu_velocity) - expected).norm(), 2e-3);
}

// The joints of the one leg that stands move the base: J_base v + J_joints qd = 0.
TEST(InertialLegOdometry, TheStandingLegMovesTheBase) {
  Body body;
  InertialLegOdometry odometry(body.model);
  for (int link = body.model.soles[1].link; link > 0; link = body.model.links[side_of(link)].parent) {
    body.truth.qd[link - 1] = 0.1 * static_cast<double>(link % 3 - 1);
  }
  body.truth.qd[body.model.soles[0].link - 1] = 2.0;  // of the leg in the air
  const Sole& sole = body.model.soles[1];
  const Eigen::Vector3d point = body.kinematics.link_in_world(sole.link) * sole.frame.translation();
  Eigen::MatrixXd jacobian(6, 6 + body.model.joint_count());
  body.kinematics.point_jacobian(sole.link, point, jacobian);
  const Eigen::Vector3d expected = -jacobian.topRightCorner(3, body.model.joint_count()) * body.truth.qd;
  ASSERT_GT(expected.norm(), 0.01);
  for (int i = 0; i < 500; ++i) odometry.update(body.state(Eigen::Vector3d::Zero(), 0.0, 1.0));
  EXPECT_LT((velocity_of(odometry) - expected).norm(), 1e-3);
  EXPECT_FALSE(odometry.estimate().foot_stands[0]);
  EXPECT_TRUE(odometry.estimate().foot_stands[1]);
}

// On soft ground a foot that has landed digs in and comes up again while it carries the robot: five times a second the foot that
// stands rises by 0.3 m/s, which falls by a factor of e in 40 ms.  Its mean is 0.06 m/s, which the base is not moved by.
TEST(InertialLegOdometry, AFootThatComesUpOutOfSoftGroundHardlyMovesTheBase) {
  Body body;
  InertialLegOdometry odometry(body.model);
  const Sole& sole = body.model.soles[1];
  const Eigen::Vector3d point = body.kinematics.link_in_world(sole.link) * sole.frame.translation();
  Eigen::MatrixXd jacobian(6, 6 + body.model.joint_count());
  body.kinematics.point_jacobian(sole.link, point, jacobian);
  Eigen::Index joint = 0;
  const double lever = jacobian.topRightCorner(3, body.model.joint_count()).colwise().norm().maxCoeff(&joint);
  ASSERT_GT(lever, 0.1);
  double sum = 0.0;
  for (int i = 0; i < 1000; ++i) {
    body.truth.qd[joint] = 0.3 / lever * std::exp(-kStateTick * (i % 100) / 0.04);
    odometry.update(body.state(Eigen::Vector3d::Zero(), 0.0, 1.0));
    if (i >= 500) sum += velocity_of(odometry).norm() / 500.0;
  }
  EXPECT_LT(sum, 0.045);
}

// Without force sensors the torques of the legs say what each foot carries: those of a robot in balance on given feet.
TEST(InertialLegOdometry, TorquesTellWhichFootCarries) {
  for (const double left : {1.0, 0.5, 0.0}) {
    Body body;
    InertialLegOdometry odometry(body.model);
    std::vector<ExternalWrench> ground;
    for (int foot = 0; foot < 2; ++foot) {
      const Sole& sole = body.model.soles[side_of(foot)];
      const double share = foot == 0 ? left : 1.0 - left;
      ground.push_back({.link = sole.link,
                        .point = body.kinematics.link_in_world(sole.link) * sole.frame * Eigen::Vector3d(0.03, 0.01, 0.0),
                        .force = share * body.weight * Eigen::Vector3d(0.05, 0.0, 1.0)});
    }
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(body.model.joint_count());
    Eigen::VectorXd tau = still;
    body.dynamics.solve(body.kinematics, body.truth, still, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), ground, tau);
    for (int i = 0; i < 100; ++i) {
      RobotState s = body.state(Eigen::Vector3d::Zero(), 0.0, 0.0);
      s.wrench_kind.fill(WrenchKind::kAbsent);
      for (std::size_t k = 0; k < body.model.bus_joints.size(); ++k) s.tau[k] = static_cast<float>(tau[body.model.bus_joints[k]]);
      odometry.update(s);
    }
    const Estimate& e = odometry.estimate();
    EXPECT_EQ(e.load_from, LoadFrom::kTorques);
    EXPECT_NEAR(static_cast<double>(e.foot_load[0]), left, 0.03);
    EXPECT_NEAR(static_cast<double>(e.foot_load[1]), 1.0 - left, 0.03);
    EXPECT_EQ(e.foot_stands[0], left > 0.3);
    EXPECT_EQ(e.foot_stands[1], left < 0.7);
  }
}

// Nothing measures forces or torques: the lowest feet stand.
TEST(InertialLegOdometry, WithoutForcesAndTorquesTheLowestFootStands) {
  Body body;
  body.truth.q[body.model.leg_joints[3]] += 0.3;
  InertialLegOdometry odometry(body.model);
  for (int i = 0; i < 50; ++i) {
    RobotState s = body.state(Eigen::Vector3d::Zero(), 0.0, 0.0);
    s.wrench_kind.fill(WrenchKind::kAbsent);
    odometry.update(s);
  }
  EXPECT_EQ(odometry.estimate().load_from, LoadFrom::kHeights);
  EXPECT_NE(odometry.estimate().foot_stands[0], odometry.estimate().foot_stands[1]);
}

TEST(InertialLegOdometry, GoesOnWhenTheSourceChangesAndItsHeadingIsAnother) {
  Body body;
  InertialLegOdometry odometry(body.model);
  for (int i = 0; i < 500; ++i) odometry.update(body.state(Eigen::Vector3d::Zero(), 0.5, 0.5));
  for (int i = 0; i < 50; ++i) odometry.update(body.state({2.0, 0.0, 0.0}, 0.0, 0.0));
  const Estimate before = odometry.estimate();
  InertialLegOdometry other(body.model);
  other.resume(before);
  RobotState s = body.state(Eigen::Vector3d::Zero(), 0.0, 0.0, 0.0, 2.0);  // the same robot; its IMU has another heading
  s.run_id = 6;
  odometry.update(s);
  other.update(s);
  for (const InertialLegOdometry* one : {&odometry, &other}) {
    const Estimate& e = one->estimate();
    EXPECT_EQ(e.run_id, 6);
    EXPECT_NEAR(e.base_position[0], before.base_position[0] + kStateTick * 0.2, 5e-4);
    EXPECT_NEAR(yaw_of(quaternion_from_array(e.base_attitude).toRotationMatrix()), 0.0, 1e-5);
    EXPECT_LT((vector_from_array(e.base_velocity) - vector_from_array(before.base_velocity)).norm(), 1e-3);
    EXPECT_GT(e.velocity_deviation[0], before.velocity_deviation[0]);
  }
}

TEST(InertialLegOdometry, ATickThatWasSeenChangesNothingAndNothingAllocates) {
  Body body;
  InertialLegOdometry odometry(body.model);
  RobotState s = body.state({1.0, 0.0, 0.0}, 0.5, 0.5);
  odometry.update(s);
  s = body.state({1.0, 0.0, 0.0}, 0.0, 0.0);
  NoAlloc no_alloc;
  odometry.update(s);
  const Estimate once = odometry.estimate();
  odometry.update(s);
  EXPECT_EQ(no_alloc.count(), 0);
  EXPECT_EQ(odometry.estimate().base_velocity, once.base_velocity);
  EXPECT_EQ(odometry.estimate().base_position, once.base_position);
}

// A trunk with legs of one hinge each and a ball at its end.
Model with_legs(int legs) {
  Model model;
  model.links.resize(1);
  model.links[0].mass = 10.0;
  for (int i = 0; i < legs; ++i) {
    Joint joint;
    joint.child = i + 1;
    joint.placement.translation() << 0.2 * i, i % 2 == 0 ? 0.1 : -0.1, 0.0;
    joint.axis = Eigen::Vector3d::UnitY();
    joint.lower = -1.0;
    joint.upper = 1.0;
    model.joints.push_back(joint);
    Link link;
    link.parent = 0;
    link.mass = 0.5;
    Shape ball;
    ball.kind = ShapeKind::kSphere;
    ball.size.x() = 0.02;
    ball.pose.translation().z() = -0.4;
    link.collision.push_back(ball);
    model.links.push_back(link);
    model.bus_joints.push_back(i);
    model.bus_index.push_back(i);
  }
  return model;
}

TEST(InertialLegOdometry, KnowsAnyNumberOfFeetUpToSix) {
  for (const int legs : {0, 1, 4, 6, 8}) {
    const Model model = with_legs(legs);
    InertialLegOdometry odometry(model);
    for (int i = 0; i < 20; ++i) {
      RobotState s;
      s.tick = i;
      s.time_ns = 2'000'000 * i;
      s.run_id = 1;
      s.joint_count = static_cast<std::int16_t>(legs);
      s.sensor_flags = kEncodersValid | kImuValid;
      s.accel = {0.0F, 0.0F, 9.81F};
      odometry.update(s);
    }
    const Estimate& e = odometry.estimate();
    EXPECT_EQ(e.foot_count, std::min(legs, 6));
    EXPECT_NEAR(e.base_position[2], legs > 0 ? 0.42 : 0.0, 1e-6) << legs;  // a leg and the radius of its ball
    EXPECT_EQ(e.velocity_from, legs > 0 ? VelocityFrom::kFeetAndAccelerometer : VelocityFrom::kUnknown);
    if (legs > 0) {
      EXPECT_EQ(e.foot_joint[0], 0);
      EXPECT_NEAR(static_cast<double>(e.foot_load[0]), 1.0 / std::min(legs, 6), 1e-6);
    }
  }
}

TEST(InertialLegOdometry, AFixedBaseIsAtRestForSure) {
  Model model = hrp1s();
  model.floating_base = false;
  Body body;
  InertialLegOdometry odometry(model);
  odometry.update(body.state({1.0, 0.0, 0.0}, 0.0, 0.0));
  EXPECT_EQ(odometry.estimate().velocity_from, VelocityFrom::kFixed);
  EXPECT_EQ(velocity_of(odometry).norm(), 0.0);
  EXPECT_EQ(odometry.estimate().velocity_deviation[0], 0.0F);
}

}  // namespace
}  // namespace twinbus::test
