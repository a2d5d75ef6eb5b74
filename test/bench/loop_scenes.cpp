#include "loop_scenes.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "common/math/index.h"
#include "robot/description/load.h"
#include "sim/world/static_equilibrium.h"
#include "test/sim/test_models.h"

namespace twinbus {

namespace {

constexpr double kThin = 1e-4;  // of a rod about itself [kg m^2]

using Eigen::Vector3d;

int add_link(LoopScene& scene, int parent, const Vector3d& at_parent, const Vector3d& axis,
             double mass, const Vector3d& com, const Vector3d& inertia) {
  Model& model = scene.model;
  const int index = model.link_count();
  std::string name = "link";
  name += std::to_string(index);
  Joint joint;
  joint.name = "joint_of_" + name;
  joint.kind = JointKind::kContinuous;
  joint.parent = parent;
  joint.child = index;
  joint.placement.translation() = at_parent;
  joint.axis = axis;
  joint.lower = -std::numeric_limits<double>::infinity();
  joint.upper = std::numeric_limits<double>::infinity();
  joint.effort = 1e3;
  model.links.push_back(test::make_link(name, parent, mass, com, inertia));
  model.bus_joints.push_back(model.joint_count());
  model.joints.push_back(joint);
  return index;
}

LoopScene on_a_base(const std::string& name) {
  LoopScene scene;
  scene.model.name = name;
  scene.model.floating_base = false;
  scene.config.fixed_base = true;
  Link base;
  base.name = "base";
  base.mass = 1.0;
  base.inertia = Eigen::Matrix3d::Identity();
  scene.model.links = {base};
  return scene;
}

// A rod of 1 m and 1 kg along a direction of the axes.
int add_rod(LoopScene& scene, int parent, const Vector3d& at_parent, const Vector3d& axis,
            const Vector3d& along) {
  Vector3d inertia = Vector3d::Constant(1.0 / 12.0);
  for (int i = 0; i < 3; ++i) {
    if (along[i] != 0.0) inertia[i] = kThin;
  }
  return add_link(scene, parent, at_parent, axis, 1.0, 0.5 * along, inertia);
}

void add_tie(LoopScene& scene, int a, const Vector3d& point_a, int b, const Vector3d& point_b,
             double stiffness, double damping) {
  Tie tie;
  tie.a = {a, -1, point_a};
  tie.b = {b, -1, point_b};
  tie.stiffness = stiffness;
  tie.damping = damping;
  scene.config.ties.push_back(tie);
}

LoopScene four_bars(int count) {
  LoopScene scene = on_a_base("four_bar");
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  std::vector<int> upright, across;
  for (int i = 0; i <= count; ++i) {
    upright.push_back(add_rod(scene, 0, static_cast<double>(i) * x, y, z));
    if (i < count) across.push_back(add_rod(scene, upright.back(), z, y, x));
  }
  for (std::size_t i = 0; i < across.size(); ++i) {
    add_tie(scene, across[i], x, upright[i + 1], z, 1e8, 1e6);
  }
  scene.start = Configuration(scene.model);
  scene.start.q.setZero();
  scene.start.qd.setZero();
  for (const int link : upright) scene.start.qd[link - 1] = 1.0;
  for (const int link : across) scene.start.qd[link - 1] = -1.0;
  scene.link = upright[0];
  scene.point = z;
  return scene;
}

// Along the edges of a cube; each hinge at right angles to both of its rods.
LoopScene bricard() {
  LoopScene scene = on_a_base("bricard");
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const Vector3d along[] = {x, y, z, -x, -y};
  const Vector3d axis[] = {y, z, x, y, z};
  int link = 0;
  Vector3d end = Vector3d::Zero();
  for (int i = 0; i < 5; ++i) {
    link =
        add_rod(scene, link, i == 0 ? Vector3d(Vector3d::Zero()) : along[i - 1], axis[i], along[i]);
    end += along[i];
  }
  // The sixth hinge: two points of its axis.
  for (const double side : {-0.1, 0.1}) {
    add_tie(scene, link, along[4] + side * x, 0, end + side * x, 1e8, 1e6);
  }
  scene.start = Configuration(scene.model);
  scene.start.q.setZero();
  scene.start.qd.setZero();
  scene.link = 3;
  scene.point = z;
  return scene;
}

LoopScene andrews() {
  LoopScene scene = on_a_base("andrews");
  const Vector3d z = Vector3d::UnitZ();
  const Vector3d a(-0.06934, -0.00227, 0.0), b(-0.03635, 0.03273, 0.0), c(0.014, 0.072, 0.0);
  const double d = 28e-3, da = 115e-4, e = 2e-2, ea = 1421e-5, rr = 7e-3, ra = 92e-5, ss = 35e-3,
               sa = 1874e-5, sb = 1043e-5, sc = 18e-3, sd = 2e-2, ta = 2308e-5, tb = 916e-5,
               u = 4e-2, ua = 1228e-5, ub = 449e-5, zf = 2e-2, zt = 4e-2, fa = 1421e-5;
  const auto body = [&](int parent, const Vector3d& at_parent, double mass, double inertia,
                        const Vector3d& com) {
    return add_link(scene, parent, at_parent, z, mass, com, Vector3d(inertia, inertia, inertia));
  };
  const Vector3d zero = Vector3d::Zero();
  const int k1 = body(0, zero, .04325, 2.194e-6, {ra, 0, 0});
  const int k2 = body(k1, {rr, 0, 0}, .00365, 4.410e-7, {-da, 0, 0});
  const int k3 = body(0, b, .02373, 5.255e-6, {sb, -sa, 0});
  const int k5 = body(0, a, .07050, 1.169e-5, {ta, tb, 0});
  const int k4 = body(k5, {zt, 0, 0}, .00706, 5.667e-7, {0, -(e - ea), 0});
  const int k7 = body(0, a, .05498, 1.912e-5, {-ub, -ua, 0});
  const int k6 = body(k7, {0, -u, 0}, .00706, 5.667e-7, {zf - fa, 0, 0});
  const Vector3d end(-d, 0, 0);
  for (const auto& [link, point] :
       {std::pair<int, Vector3d>{k3, {0, -ss, 0}}, {k4, {0, -e, 0}}, {k6, {zf, 0, 0}}}) {
    add_tie(scene, k2, end, link, point, 1e9, 1e4);
  }
  Tie spring;
  spring.a = {k3, -1, Vector3d(sd, -sc, 0)};
  spring.b = {-1, -1, c};
  spring.stiffness = 45.3;
  spring.damping = 0.0;
  spring.length = 0.07785;
  scene.config.ties.push_back(spring);
  scene.start = Configuration(scene.model);
  scene.start.qd.setZero();
  // beta, Theta, gamma, delta, Phi, epsilon, Omega.
  scene.start.q << -0.0617138900142764496358948458001, 0.0, 0.455279819163070380255912382449,
      0.487364979543842550225598953530, 0.222668390165885884674473185609,
      1.23054744454982119249735015568, -0.222668390165885884674473185609;
  scene.driven = 0;
  scene.torque = 0.00033;
  scene.duration = 0.3;
  scene.link = k1;
  scene.point = {rr, 0, 0};
  return scene;
}

// Three points of the left hand, held where they are in the right hand's link.
LoopScene tied_hands() {
  LoopScene scene;
  scene.model = load_robot("hrp1s");
  const Model& model = scene.model;
  const int pose = model.find_pose("half_sitting");
  Eigen::VectorXd q = Eigen::VectorXd::Zero(model.joint_count());
  for (int j = 0; j < model.joint_count(); ++j) q[j] = model.poses[at(pose)].q[at(j)];
  const std::array<double, 2> corner{model.soles[0].stiffness / kSoleCorners,
                                     model.soles[1].stiffness / kSoleCorners};
  const Standing standing = stand(model, q, 1.0, corner, {0.0, 0.0}, false);
  scene.start = standing.configuration;
  scene.tau = standing.tau;
  scene.start.base_velocity = {0.05, 0.05, 0.0};
  Kinematics kinematics(model);
  kinematics.update(scene.start);
  const Hand &left = model.hands[0], &right = model.hands[1];
  for (const Vector3d& side : {Vector3d(0.05, 0, 0), Vector3d(0, 0.05, 0), Vector3d(0, 0, 0.05)}) {
    const Vector3d point = left.frame * side;
    const Vector3d world = kinematics.link_in_world(left.link) * point;
    add_tie(scene, left.link, point, right.link,
            kinematics.link_in_world(right.link).inverse() * world, 1e6, 1e3);
  }
  scene.duration = 1.0;
  scene.link = 0;
  return scene;
}

}  // namespace

LoopScene loop_scene(const std::string& name) {
  if (name == "four_bar") return four_bars(1);
  const std::string many = "n_four_bar";
  if (name.rfind(many, 0) == 0)
    return four_bars(std::max(1, std::atoi(name.c_str() + many.size())));
  if (name == "tied") return tied_hands();
  if (name == "bricard") return bricard();
  if (name == "andrews") return andrews();
  throw std::runtime_error("there is no mechanism '" + name +
                           "'; take four_bar, n_four_bar40, bricard, andrews or tied");
}

}  // namespace twinbus
