#include "sim/world/weld.h"

#include <stdexcept>

#include "common/math/index.h"

namespace twinbus::inline sim {

namespace {

// Where joint j puts its child, in the parent link.
Eigen::Isometry3d child_in_parent(const Joint& joint, double q) {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  if (joint.kind == JointKind::kPrismatic) {
    moved.translation() = q * joint.axis;
  } else {
    moved.linear() = Eigen::AngleAxisd(q, joint.axis).toRotationMatrix();
  }
  return joint.placement * moved;
}

// Inertia of a mass about a point `away` from its centre.
Eigen::Matrix3d steiner(double mass, const Eigen::Vector3d& away) {
  return mass * (away.squaredNorm() * Eigen::Matrix3d::Identity() - away * away.transpose());
}

void add_part(const Link& part, const Eigen::Isometry3d& pose, Link& whole) {
  const Eigen::Vector3d com = pose * part.com;
  const Eigen::Matrix3d inertia = pose.linear() * part.inertia * pose.linear().transpose();
  const double mass = whole.mass + part.mass;
  if (mass > 0.0) {
    const Eigen::Vector3d middle = (whole.mass * whole.com + part.mass * com) / mass;
    whole.inertia += steiner(whole.mass, whole.com - middle) + inertia + steiner(part.mass, com - middle);
    whole.com = middle;
  }
  whole.mass = mass;
  for (Shape shape : part.collision) {
    shape.pose = pose * shape.pose;
    whole.collision.push_back(shape);
  }
  for (Shape shape : part.visual) {
    shape.pose = pose * shape.pose;
    whole.visual.push_back(shape);
  }
}

// What names links and joints by their number.
void renumber(const Model& model, WeldedModel& welded) {
  Model& to = welded.model;
  const auto moved = [&](int link, const Eigen::Isometry3d& frame) -> Eigen::Isometry3d {
    return link < 0 ? frame : welded.in_link[at(link)] * frame;
  };
  const auto link_of = [&](int link) { return link < 0 ? -1 : welded.link[at(link)]; };
  const auto joints_of = [&](const std::vector<int>& joints) {
    std::vector<int> left;
    for (const int j : joints) {
      if (welded.joint[at(j)] >= 0) left.push_back(welded.joint[at(j)]);
    }
    return left;
  };
  for (Frame& frame : to.frames) {
    frame.in_link = moved(frame.link, frame.in_link);
    frame.link = link_of(frame.link);
  }
  for (Sole& sole : to.soles) {
    sole.frame = moved(sole.link, sole.frame);
    sole.sensor = moved(sole.link, sole.sensor);
    sole.link = link_of(sole.link);
  }
  const auto move_hand = [&](Hand& hand) {
    hand.frame = moved(hand.link, hand.frame);
    hand.sensor = moved(hand.link, hand.sensor);
    hand.link = link_of(hand.link);
    hand.joints = joints_of(hand.joints);
    hand.carriers = joints_of(hand.carriers);
  };
  for (Hand& hand : to.hands) move_hand(hand);
  for (Hand& hand : to.more_hands) move_hand(hand);
  to.plane_joints = joints_of(model.plane_joints);
  to.imu = moved(to.imu_link, to.imu);
  to.imu_link = link_of(to.imu_link);
  to.leg_joints = joints_of(model.leg_joints);
  to.bus_joints = joints_of(model.bus_joints);
  to.bus_index.assign(to.joints.size(), -1);
  for (std::size_t k = 0; k < to.bus_joints.size(); ++k) to.bus_index[at(to.bus_joints[k])] = static_cast<int>(k);
  for (NamedPose& pose : to.poses) {
    std::vector<double> q;
    for (std::size_t j = 0; j < pose.q.size(); ++j) {
      if (welded.joint[j] >= 0) q.push_back(pose.q[j]);
    }
    pose.q = q;
  }
}

void part_pairs(const Model& model, WeldedModel& welded) {
  const std::size_t n = model.links.size(), m = welded.model.links.size();
  std::vector<char> apart(n * n, 0), touch(m * m, 0);
  for (const auto& [a, b] : model.disabled_pairs) apart[at(a) * n + at(b)] = apart[at(b) * n + at(a)] = 1;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const bool neighbours = model.links[a].parent == static_cast<int>(b) || model.links[b].parent == static_cast<int>(a);
      if (a != b && !neighbours && apart[a * n + b] == 0) touch[at(welded.link[a]) * m + at(welded.link[b])] = 1;
    }
  }
  welded.model.disabled_pairs.clear();
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = a + 1; b < m; ++b) {
      if (touch[a * m + b] == 0) welded.model.disabled_pairs.push_back({static_cast<int>(a), static_cast<int>(b)});
    }
  }
}

}  // namespace

void hold_followers(const Model& model, std::vector<bool>& held) {
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      const int leader = model.joints[j].mimic;
      if (leader < 0 || held[j] == held[at(leader)]) continue;
      held[j] = held[at(leader)] = true;
      grown = true;
    }
  }
}

WeldedModel weld(const Model& model, const std::vector<bool>& held, const Eigen::VectorXd& q) {
  const std::size_t joints = model.joints.size();
  if (held.size() != joints || static_cast<std::size_t>(q.size()) != joints)
    throw std::invalid_argument("weld: one flag and one position for each joint are needed");
  WeldedModel welded;
  welded.model = model;
  Model& to = welded.model;
  to.joints.clear();
  to.links.clear();
  to.links.push_back(model.links.front());
  welded.joint.assign(joints, -1);
  welded.link.assign(joints + 1, 0);
  welded.in_link.assign(joints + 1, Eigen::Isometry3d::Identity());
  welded.former_link.push_back(0);
  welded.first_shape.assign(joints + 1, 0);
  for (std::size_t j = 0; j < joints; ++j) {
    Joint joint = model.joints[j];
    const std::size_t parent = at(joint.parent), child = j + 1;
    const int body = welded.link[parent];
    if (held[j]) {
      welded.link[child] = body;
      welded.in_link[child] = welded.in_link[parent] * child_in_parent(joint, q[static_cast<Eigen::Index>(j)]);
      welded.first_shape[child] = static_cast<int>(to.links[at(body)].collision.size());
      add_part(model.links[child], welded.in_link[child], to.links[at(body)]);
      continue;
    }
    welded.joint[j] = static_cast<int>(to.joints.size());
    joint.placement = welded.in_link[parent] * joint.placement;
    joint.parent = body;
    joint.child = static_cast<int>(to.links.size());
    if (joint.mimic >= 0) {
      if (held[at(joint.mimic)]) throw std::invalid_argument("weld: " + joint.name + " follows a joint that is held");
      joint.mimic = joint.mimic < static_cast<int>(j) ? welded.joint[at(joint.mimic)] : joint.mimic;
    }
    welded.link[child] = joint.child;
    welded.former_link.push_back(static_cast<int>(child));
    Link link = model.links[child];
    link.parent = body;
    to.joints.push_back(joint);
    to.links.push_back(link);
  }
  for (std::size_t j = 0; j < joints; ++j) {  // those that follow a later joint
    if (welded.joint[j] >= 0 && model.joints[j].mimic >= static_cast<int>(j))
      to.joints[at(welded.joint[j])].mimic = welded.joint[at(model.joints[j].mimic)];
    if (held[j] && model.joints[j].mimic >= 0 && !held[at(model.joints[j].mimic)])
      throw std::invalid_argument("weld: " + model.joints[j].name + " is held and follows a joint that moves");
  }
  renumber(model, welded);
  part_pairs(model, welded);
  return welded;
}

}  // namespace twinbus::sim
