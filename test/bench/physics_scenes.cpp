#include "test/bench/physics_scenes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "sim/world/static_equilibrium.h"
#include "test/sim/test_models.h"

namespace twinbus {

namespace {

constexpr double kArmSwing = 0.5;  // [rad/s] at the start

// Joints that turn freely for ever.
void bare(Model& model) {
  for (Joint& joint : model.joints) {
    if (joint.kind == JointKind::kRevolute) joint.kind = JointKind::kContinuous;
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
    joint.friction = joint.damping = 0.0;
  }
}

// The links of one hand's arm, the link that carries it as base.
Model arm_of(const Model& robot) {
  const Hand& hand = robot.hands[1];
  if (hand.joints.empty()) throw std::runtime_error("scene arm: the robot has no right arm");
  Model arm;
  arm.name = "arm";
  arm.floating_base = false;
  const int carrier = robot.joints[static_cast<std::size_t>(hand.joints[0])].parent;
  arm.links.push_back(robot.links[static_cast<std::size_t>(carrier)]);
  arm.links[0].parent = -1;
  for (const int j : hand.joints) {
    Joint joint = robot.joints[static_cast<std::size_t>(j)];
    Link link = robot.links[static_cast<std::size_t>(joint.child)];
    joint.parent = link.parent = static_cast<int>(arm.links.size()) - 1;
    joint.child = joint.parent + 1;
    arm.bus_joints.push_back(static_cast<int>(arm.joints.size()));
    arm.joints.push_back(joint);
    arm.links.push_back(link);
  }
  for (Link& link : arm.links) link.collision.clear();
  bare(arm);
  return arm;
}

// A brick of 10 kg on two soles of 0.1 x 0.05 m, with a light wheel so that it has a joint.
Model brick() {
  Model model;
  model.name = "brick";
  model.links.resize(2);
  Link& body = model.links[0];
  body.name = "brick";
  body.mass = 10.0;
  body.com = {0, 0, 0.03};
  body.inertia = Eigen::Vector3d(0.02, 0.04, 0.05).asDiagonal();
  Link& wheel = model.links[1];
  wheel.name = "wheel";
  wheel.parent = 0;
  wheel.mass = 0.01;
  wheel.inertia = Eigen::Vector3d(1e-5, 1e-5, 1e-5).asDiagonal();
  Joint axle;
  axle.name = "axle";
  axle.child = 1;
  axle.kind = JointKind::kContinuous;
  axle.placement.translation() = Eigen::Vector3d(0, 0, 0.03);
  model.joints = {axle};
  model.bus_joints = {0};
  bare(model);
  test::put_soles(model, 0.05, 0.025, 1e6, 2e3);
  return model;
}

// Links of 1 kg, hinge axes in turn along y, x, z.
Model chain(int joints) {
  Model model;
  model.name = "chain";
  for (int i = 0; i <= joints; ++i) {
    Link link;
    link.name = "link" + std::to_string(i);
    link.parent = i - 1;
    link.mass = 1.0;
    link.com = {0.15, 0.0, 0.02};
    link.inertia = Eigen::Vector3d(0.002, 0.01, 0.01).asDiagonal();
    model.links.push_back(link);
    if (i == 0) continue;
    Joint joint;
    joint.name = "joint" + std::to_string(i);
    joint.parent = i - 1;
    joint.child = i;
    joint.placement.translation() = Eigen::Vector3d(0.3, 0.0, 0.0);
    joint.axis = Eigen::Vector3d::Unit(i % 3 == 1 ? 1 : (i % 3 == 2 ? 0 : 2));
    model.bus_joints.push_back(i - 1);
    model.joints.push_back(joint);
  }
  bare(model);
  return model;
}

Eigen::VectorXd half_sitting(const Model& model) {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(model.joint_count());
  const int pose = model.find_pose("half_sitting");
  if (pose < 0) return q;
  for (int j = 0; j < model.joint_count(); ++j) {
    q[j] = model.poses[static_cast<std::size_t>(pose)].q[static_cast<std::size_t>(j)];
  }
  return q;
}

void on_its_feet(PhysicsScene& scene, double gain) {
  const Model& model = scene.model;
  const double corner = model.soles[0].stiffness / kSoleCorners;
  const Standing standing =
      stand(model, half_sitting(model), 1.0, {corner, corner}, {0.0, 0.0}, false);
  scene.start = standing.configuration;
  scene.tau = standing.tau;
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    scene.servos[static_cast<std::size_t>(j)] = {.q = scene.start.q[j],
                                                 .qd = 0.0,
                                                 .tau = standing.tau[j],
                                                 .kp = gain * joint.kp,
                                                 .kd = gain * joint.kd};
  }
}

}  // namespace

PhysicsScene physics_scene(const std::string& name, double gain) {
  PhysicsScene scene;
  scene.name = name;
  const bool is_chain = name.rfind("chain", 0) == 0;
  if (is_chain) {
    const int joints = std::atoi(name.c_str() + 5);
    if (joints < 1 || joints > 1000) throw std::runtime_error("scene chainN: N is 1 to 1000");
    scene.model = chain(joints);
  } else {
    scene.model = name == "slide" ? brick() : load_robot("hrp1s");
  }
  Model& model = scene.model;
  if (name == "arm") model = arm_of(model);
  if (name == "flight" || name == "arm") {
    scene.ground = false;
    bare(model);
    for (Link& link : model.links) link.collision.clear();
    model.soles = {};
  }
  if (is_chain) scene.ground = false;
  scene.fixed_base = name == "arm";
  scene.start = Configuration(model);
  scene.start.q = half_sitting(model);
  scene.start.qd.setZero();
  scene.servos.resize(model.joints.size());
  scene.tau = Eigen::VectorXd::Zero(model.joint_count());
  if (name == "flight" || name == "throw" || is_chain) {
    scene.duration = name == "flight" ? 0.5 : 2.0;
    scene.start.base.translation().z() = name == "throw" ? 1.5 : 100.0;
    scene.start.base_velocity = {0.5, 0.2, 0.0};
    scene.start.base_angular_velocity = {1.0, 2.0, 0.5};
    scene.start.base.linear() =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 0.5, 0.0).normalized()).toRotationMatrix();
  }
  if (name == "flight" || is_chain) {
    for (int j = 0; j < model.joint_count(); ++j) scene.start.qd[j] = 0.2 * std::sin(1.0 + j);
  } else if (name == "throw") {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[static_cast<std::size_t>(j)];
      scene.servos[static_cast<std::size_t>(j)] = {
          .q = scene.start.q[j], .kp = 0.1 * gain * joint.kp, .kd = 0.1 * gain * joint.kd};
    }
  } else if (name == "arm") {
    scene.duration = 0.5;
    scene.start.q.setZero();
    scene.start.q[0] = -1.5;
    scene.start.q[1] = -0.4;
    scene.start.q[3] = -0.5;
    scene.start.qd.setConstant(kArmSwing);
  } else if (name == "stand") {
    scene.duration = 0.5;
    on_its_feet(scene, gain);
    scene.start.base_velocity = {0.05, 0.05, 0.0};
  } else if (name == "landing") {
    scene.duration = 0.6;
    on_its_feet(scene, gain);
    scene.start.base.translation().z() += 0.05;
  } else if (name == "push" || name == "push_soft") {
    scene.duration = 0.6;
    on_its_feet(scene, gain);
    for (std::size_t j = 0; name == "push_soft" && j < scene.servos.size(); ++j) {
      const double own = scene.model.joints[j].kp;
      scene.servos[j].kp = gain * (own > 1e4 ? 5000.0 : own > 1e3 ? 1500.0 : 150.0);
      scene.servos[j].kd = 0.02 * scene.servos[j].kp;
    }
    scene.start.base.translation().z() += 0.01;
    scene.start.base_velocity.x() = 0.2;
  } else if (name == "slide") {
    scene.duration = 0.4;
    const double weight = model.total_mass() * kGravity;
    scene.start.base.translation().z() = -weight / (2.0 * model.soles[0].stiffness);
    scene.start.base_velocity.x() = 1.0;
  } else {
    throw std::runtime_error("no scene '" + name +
                             "': there are flight, arm, stand, push, push_soft, landing, slide, throw");
  }
  return scene;
}

std::string mjcf_numbers(std::initializer_list<double> values) {
  std::string text;
  char word[40];
  for (const double value : values) {
    std::snprintf(word, sizeof word, "%s%.17g", text.empty() ? "" : " ", value);
    text += word;
  }
  return text;
}

namespace {

std::string vec(const Eigen::Vector3d& v) { return mjcf_numbers({v.x(), v.y(), v.z()}); }

std::string quat(const Eigen::Matrix3d& turn) {
  const Eigen::Quaterniond q(turn);
  return mjcf_numbers({q.w(), q.x(), q.y(), q.z()});
}

class Writer {
 public:
  explicit Writer(const PhysicsScene& scene) : s_(scene) {}

  std::string text() {
    std::string bodies;
    body(0, bodies);
    std::string out = "<mujoco model='";
    out += s_.name;
    out +=
        "'>\n<compiler angle='radian' boundmass='0' balanceinertia='false'/>\n"
        "<option gravity='0 0 -9.81' cone='elliptic' impratio='1' tolerance='1e-10'/>\n"
        "<size nkey='1'/>\n<worldbody>\n";
    if (s_.ground) {
      out +=
          "<geom type='plane' size='100 100 1' contype='2' conaffinity='1' friction='0.8 0.005 "
          "0.0001'/>\n";
    }
    out += bodies;
    out += "</worldbody>\n<actuator>\n";
    out += actuators_;
    out += "</actuator>\n<keyframe><key";
    for (const auto& [name, list] :
         {std::pair{"qpos", &qpos_}, {"qvel", &qvel_}, {"ctrl", &ctrl_}}) {
      if (list->empty()) continue;
      out += std::string(" ") + name;
      out += "='" + *list + "'";
    }
    out += "/></keyframe>\n</mujoco>\n";
    return out;
  }

 private:
  static void append(std::string& list, const std::string& more) {
    if (!list.empty()) list += ' ';
    list += more;
  }

  void root(std::string& out) {
    const Configuration& c = s_.start;
    if (s_.fixed_base) return;
    out += "<freejoint/>";
    append(qpos_, vec(c.base.translation()));
    append(qpos_, quat(c.base.linear()));
    append(qvel_, vec(c.base_velocity));
    append(qvel_, vec(c.base.linear().transpose() * c.base_angular_velocity));
  }

  void hinge(std::size_t j, std::string& out) {
    const Joint& joint = s_.model.joints[j];
    const auto index = static_cast<Eigen::Index>(j);
    out += "<joint name='j" + std::to_string(j) + "' type='";
    out += joint.kind == JointKind::kPrismatic ? "slide" : "hinge";
    out += "' axis='" + vec(joint.axis) + "' armature='" + mjcf_numbers({joint.rotor_inertia});
    out += "' damping='" + mjcf_numbers({joint.damping}) + "' frictionloss='" +
           mjcf_numbers({joint.friction}) + "'";
    if (joint.kind != JointKind::kContinuous) {
      out += " limited='true' range='" + mjcf_numbers({joint.lower, joint.upper}) + "'";
    }
    out += "/>";
    append(qpos_, mjcf_numbers({s_.start.q[index]}));
    append(qvel_, mjcf_numbers({s_.start.qd[index]}));
    const ServoTarget& t = s_.servos[j];
    if (!(t.kp > 0.0)) return;
    // Its force is kp ctrl - kp q - kd qd: the feed-forward torque moves the reference.
    actuators_ += "<general joint='j" + std::to_string(j) + "' gainprm='" + mjcf_numbers({t.kp}) +
                  "' biastype='affine' biasprm='0 " + mjcf_numbers({-t.kp, -t.kd}) +
                  "' forcelimited='true' forcerange='" + mjcf_numbers({-joint.effort, joint.effort}) +
                  "'/>\n";
    append(ctrl_, mjcf_numbers({t.q + t.tau / t.kp}));
  }

  void shapes(std::size_t i, std::string& out) const {
    const char* const rest = " contype='1' conaffinity='2' friction='0.8 0.005 0.0001'/>";
    for (const Sole& sole : s_.model.soles) {
      if (sole.link != static_cast<int>(i)) continue;
      const double thick = 0.01;
      const Eigen::Vector3d middle(0.5 * (sole.front - sole.back), 0.5 * (sole.left - sole.right),
                                   thick);
      out += "<geom type='box' size='" +
             mjcf_numbers({0.5 * (sole.front + sole.back), 0.5 * (sole.left + sole.right), thick});
      out += "' pos='" + vec(sole.frame * middle) + "' quat='" + quat(sole.frame.linear()) + "'";
      out += rest;
    }
    for (const Shape& shape : s_.model.links[i].collision) {
      bool skin = false;  // what the ground is the sole's business of
      for (const Sole& sole : s_.model.soles) skin = skin || sole.link == static_cast<int>(i);
      if (skin || shape.kind == ShapeKind::kMesh) continue;
      out += "<geom type='";
      if (shape.kind == ShapeKind::kBox) {
        out += "box' size='" + vec(0.5 * shape.size);
      } else if (shape.kind == ShapeKind::kSphere) {
        out += "sphere' size='" + mjcf_numbers({shape.size.x()});
      } else {
        out += "cylinder' size='" + mjcf_numbers({shape.size.x(), 0.5 * shape.size.y()});
      }
      out +=
          "' pos='" + vec(shape.pose.translation()) + "' quat='" + quat(shape.pose.linear()) + "'";
      out += rest;
    }
  }

  void body(std::size_t i, std::string& out) {
    const Link& link = s_.model.links[i];
    const Eigen::Isometry3d at = i == 0 ? s_.start.base : s_.model.joints[i - 1].placement;
    out += "<body name='link" + std::to_string(i) + "' pos='" + vec(at.translation()) + "' quat='" +
           quat(at.linear()) + "'>";
    if (i == 0) {
      root(out);
    } else {
      hinge(i - 1, out);
    }
    const Eigen::Matrix3d& I = link.inertia;
    out += "<inertial pos='" + vec(link.com) + "' mass='" + mjcf_numbers({link.mass}) +
           "' fullinertia='" + mjcf_numbers({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}) +
           "'/>";
    if (s_.ground) shapes(i, out);
    out += "\n";
    for (std::size_t k = i + 1; k < s_.model.links.size(); ++k) {
      if (s_.model.links[k].parent == static_cast<int>(i)) body(k, out);
    }
    out += "</body>\n";
  }

  const PhysicsScene& s_;
  std::string qpos_, qvel_, ctrl_, actuators_;
};

}  // namespace

std::string mjcf(const PhysicsScene& scene) { return Writer(scene).text(); }

}  // namespace twinbus
