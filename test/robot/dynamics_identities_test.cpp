// Mass matrix, forward and inverse dynamics, Jacobians and momentum must agree with each other on any robot: our own,
// foreign ones and a thousand trees that nobody designed.

#include "fixtures.h"
#include "test/oracles/forward_dynamics.h"
#include "test/oracles/mass_matrix.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

// A tree of joints of every kind, with links of random bodies, some without mass.
Model random_tree(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return Eigen::Vector3d(unit(random), unit(random), unit(random)); };
  Model model;
  const int joints = 1 + static_cast<int>(random() % 40);
  for (int i = 0; i <= joints; ++i) {
    Link link;
    link.name = std::to_string(i) + "l";  // g++ 12 warns of "l" + ... (GCC bug 105329)
    link.parent = i == 0 ? -1 : static_cast<int>(random() % static_cast<unsigned>(i));
    link.mass = 0.1 + 5.0 * std::abs(unit(random));
    link.com = 0.2 * vector();
    const Eigen::Vector3d half = 0.02 * Eigen::Vector3d::Ones() + 0.2 * vector().cwiseAbs();
    const Eigen::Vector3d square = half.cwiseProduct(half);
    const Eigen::Matrix3d turn = rotation_of(3.0 * vector());
    link.inertia =
        link.mass / 3.0 * turn *
        Eigen::Vector3d(square[1] + square[2], square[0] + square[2], square[0] + square[1])
            .asDiagonal() *
        turn.transpose();
    model.links.push_back(link);
    if (i == 0) continue;
    Joint joint;
    joint.name = std::to_string(i) + "j";
    const unsigned kind = static_cast<unsigned>(random() % 4);
    joint.kind = kind == 0   ? JointKind::kPrismatic
                 : kind == 1 ? JointKind::kContinuous
                             : JointKind::kRevolute;
    joint.parent = link.parent;
    joint.child = i;
    joint.placement.linear() = rotation_of(3.0 * vector());
    joint.placement.translation() = 0.4 * vector();
    joint.axis = vector().normalized();
    joint.rotor_inertia = random() % 2 == 0 ? 0.0 : 0.3 * std::abs(unit(random));
    model.joints.push_back(joint);
    model.bus_joints.push_back(i - 1);
    model.bus_index.push_back(i - 1);
  }
  model.floating_base = random() % 3 != 0;
  return model;
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).norm() / (1.0 + b.norm());
}

struct State {
  Configuration c;
  Eigen::VectorXd v, vd;  // base linear, base angular, joints
};

State random_state(const Model& model, unsigned seed) {
  const Motion motion(model, seed);
  State s;
  s.c = motion.configuration(0.7);
  if (!model.floating_base) s.c.base_velocity = s.c.base_angular_velocity = Eigen::Vector3d::Zero();
  s.v.resize(6 + model.joint_count());
  s.v << s.c.base_velocity, s.c.base_angular_velocity, s.c.qd;
  s.vd.resize(6 + model.joint_count());
  s.vd << motion.base_acceleration(0.7), motion.base_angular_acceleration(0.7), motion.qdd(0.7);
  if (!model.floating_base) s.vd.head<6>().setZero();
  return s;
}

void expect_identities(const Model& model, unsigned seed, double most) {
  const std::string about = model.name + " seed " + std::to_string(seed);
  const State s = random_state(model, seed);
  const Eigen::Index n = model.joint_count();
  Kinematics k(model);
  k.update(s.c);
  MassMatrix mass(model);
  mass.update(k);
  const Eigen::MatrixXd& h = mass.matrix();

  // H v' + bias is what inverse dynamics says.
  InverseDynamics inverse(model);
  const auto generalized = [&](const Eigen::VectorXd& vd) {
    Eigen::VectorXd tau(n), all(6 + n);
    const auto base = inverse.solve(k, s.c, vd.tail(n), vd.head<3>(), vd.segment<3>(3), {}, tau);
    all << base, tau;
    return all;
  };
  const Eigen::VectorXd bias = generalized(Eigen::VectorXd::Zero(6 + n));
  const Eigen::VectorXd wanted = generalized(s.vd);
  EXPECT_LT(difference(h * s.vd + bias, wanted), most) << about;

  // Energy and momentum.
  double energy = 0.0;
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[static_cast<std::size_t>(i)];
    const Eigen::Vector3d omega = k.link_in_world(i).linear().transpose() * k.angular_velocity(i);
    energy += 0.5 * link.mass * k.point_velocity(i, k.com_of_link(i)).squaredNorm() +
              0.5 * omega.dot(link.inertia * omega);
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    energy += 0.5 * model.joints[static_cast<std::size_t>(j)].rotor_inertia * s.c.qd[j] * s.c.qd[j];
  }
  EXPECT_NEAR(0.5 * s.v.dot(h * s.v), energy, most * (1.0 + energy)) << about;
  Eigen::MatrixXd map(6, 6 + n), com(3, 6 + n);
  mass.centroidal_map(map);
  Eigen::Matrix<double, 6, 1> momentum;
  momentum << k.mass() * k.com_velocity(), k.angular_momentum();
  EXPECT_LT(difference(map * s.v, momentum), most) << about;
  k.com_jacobian(com);
  EXPECT_LT(difference(com * k.mass(), map.topRows(3)), most) << about;

  // Forward dynamics is the inverse of inverse dynamics, pushed at the base as inverse dynamics asks, and elsewhere.
  const int last = model.link_count() - 1;
  const ExternalWrench push{.link = last,
                            .point = k.link_in_world(last) * Eigen::Vector3d(0.1, 0.2, -0.1),
                            .force = {5, -7, 9},
                            .torque = {1, 2, -1}};
  Eigen::VectorXd tau(n), qdd(n);
  const Eigen::Matrix<double, 6, 1> base =
      inverse.solve(k, s.c, s.vd.tail(n), s.vd.head<3>(), s.vd.segment<3>(3), {push}, tau);
  ForwardDynamics forward(model);
  forward.solve(k, s.c, tau,
                {push,
                 {.link = 0,
                  .point = s.c.base.translation(),
                  .force = base.head<3>(),
                  .torque = base.tail<3>()}},
                qdd);
  EXPECT_LT(difference(qdd, s.vd.tail(n)), 10.0 * most) << about;
  if (model.floating_base) {
    EXPECT_LT(difference(forward.base_acceleration(), s.vd.head<3>()), 10.0 * most) << about;
    EXPECT_LT(difference(forward.base_angular_acceleration(), s.vd.segment<3>(3)), 10.0 * most)
        << about;
  }

  // Contact mobility is J H^-1 J'.
  const ContactPoint contacts[2] = {{last, push.point}, {model.link_count() / 2, k.com()}};
  Eigen::MatrixXd mobility(6, 6), one(6, 6 + n), jacobian(6, 6 + n);
  forward.contact_mobility(contacts, 2, mobility);
  for (int i = 0; i < 2; ++i) {
    k.point_jacobian(contacts[i].link, contacts[i].point, one);
    jacobian.middleRows(3 * i, 3) = one.topRows(3);
  }
  const Eigen::Index first = model.floating_base ? 0 : 6;
  const Eigen::MatrixXd block = h.bottomRightCorner(6 + n - first, 6 + n - first);
  const Eigen::MatrixXd j = jacobian.rightCols(6 + n - first);
  EXPECT_LT(difference(mobility, j * block.llt().solve(j.transpose())), 10.0 * most) << about;
  // And contact inertia its inverse.
  constexpr double kDamping = 1e-3;
  Eigen::MatrixXd inertia(6, 6);
  ASSERT_TRUE(forward.contact_inertia(contacts, 2, kDamping, inertia)) << about;
  const Eigen::MatrixXd damped = mobility + kDamping * Eigen::MatrixXd::Identity(6, 6);
  EXPECT_LT(difference(inertia * damped, Eigen::MatrixXd::Identity(6, 6)), 1e-8) << about;
}

TEST(Dynamics, IdentitiesHoldOnOurRobotsAndForeignOnes) {
  std::vector<Model> models = {hrp1s(), robot_with_every_joint()};
  if (!data_folder().empty()) {
    models.push_back(load_urdf(data_folder() + "/robots/jvrc1/jvrc1.urdf", {}));
    models.push_back(load_urdf(data_folder() + "/robots/panda/panda.urdf", {}, false));
  }
  for (const Model& model : models) {
    for (unsigned seed = 1; seed <= 20; ++seed) expect_identities(model, seed, 1e-11);
  }
}

TEST(Dynamics, IdentitiesHoldOnAThousandRandomTrees) {
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    const Model model = random_tree(seed);
    expect_identities(model, seed, 1e-11);
    if (HasFailure()) break;
  }
}

// Nobody pushes and no torque acts: energy stays, to the order of the integrator.
TEST(Dynamics, FreeFlightKeepsEnergyAndMomentum) {
  const Model model = hrp1s();
  Configuration c = Motion(model, 9).configuration(0.2);
  Kinematics k(model);
  ForwardDynamics forward(model);
  MassMatrix mass(model);
  Eigen::VectorXd qdd(model.joint_count()), v(6 + model.joint_count());
  const Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.joint_count());
  const auto energy = [&] {
    k.update(c);
    mass.update(k);
    v << c.base_velocity, c.base_angular_velocity, c.qd;
    return 0.5 * v.dot(mass.matrix() * v) + k.mass() * kGravity * k.com().z();
  };
  const double before = energy();
  const Eigen::Vector3d spin = k.angular_momentum();
  constexpr double dt = 1e-5;
  for (int i = 0; i < 2000; ++i) {  // midpoint rule
    Configuration half = c;
    for (Configuration* to : {&half, &c}) {
      const Configuration& from = to == &half ? c : half;
      const double step = to == &half ? 0.5 * dt : dt;
      k.update(from);
      forward.solve(k, from, tau, {}, qdd);
      const Eigen::Vector3d velocity = from.base_velocity, turn = from.base_angular_velocity;
      const Eigen::VectorXd qd = from.qd;
      to->q += step * qd;
      to->base.translation() += step * velocity;
      to->base.linear() = rotation_of(step * turn) * to->base.linear();
      to->qd += step * qdd;
      to->base_velocity += step * forward.base_acceleration();
      to->base_angular_velocity += step * forward.base_angular_acceleration();
    }
  }
  EXPECT_NEAR(energy(), before, 1e-6 * std::abs(before));
  EXPECT_LT((k.angular_momentum() - spin).norm(), 1e-5 * (1.0 + spin.norm()));
}

TEST(Dynamics, NothingAllocates) {
  const Model& model = hrp1s();
  const State s = random_state(model, 1);
  Kinematics k(model);
  MassMatrix mass(model);
  ForwardDynamics forward(model);
  Eigen::VectorXd qdd(model.joint_count());
  const Eigen::VectorXd tau = Eigen::VectorXd::Ones(model.joint_count());
  const std::vector<ExternalWrench> external(2);
  const ContactPoint contacts[2] = {{model.soles[0].link, {0, 0, 0}},
                                    {model.soles[1].link, {0, 0, 0}}};
  Eigen::MatrixXd map(6, 6 + model.joint_count()), mobility(6, 6);
  NoAlloc no_alloc;
  k.update(s.c);
  mass.update(k);
  mass.centroidal_map(map);
  forward.solve(k, s.c, tau, external, qdd);
  forward.contact_mobility(contacts, 2, mobility);
  const bool sound = forward.contact_inertia(contacts, 2, 1e-6, mobility);
  EXPECT_TRUE(sound);
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus::test
