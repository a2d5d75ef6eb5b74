#include "sim/objects/other_robots.h"

#include <algorithm>

#include "common/math/index.h"
#include "robot/description/model.h"
#include "sim/articulated/richardson.h"

namespace twinbus::inline sim {

OtherRobots::OtherRobots(const WorldConfig& config) {
  for (const OtherRobot& robot : config.robots) {
    check_robot(robot);
    const Model& model = *robot.model;
    const WorldConfig own = config_of(robot, config);
    robots_.push_back({ArticulatedBody(model, own.fixed_base, 1.0),
                       GroundContacts(model, own),
                       {},
                       std::vector<JointRow>(model.joints.size()),
                       robot.start,
                       robot.start,
                       robot.start,
                       {robot.start, robot.start}});
    Robot& added = robots_.back();
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      added.joints.emplace_back(model.joints[j], own);
      added.joints.back().set_target(robot.servos[j]);
      added.joints.back().set_tau(robot.servos[j].tau);
    }
    for (const PassiveJoint& p : passive_joints_of(model)) added.joints[at(p.joint)].make_spring(p.stiffness, p.rest);
    added.motors = MotorLimits(model, added.joints);
    added.body.place(added.now);
  }
  if (!robots_.empty()) found_.reserve(kMostContacts);
}

Eigen::Isometry3d OtherRobots::link_in_world(int robot, int link) const noexcept {
  const ArticulatedBody& body = robots_[at(robot)].body;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = body.link(link).rotation;
  pose.translation() = body.origin() + body.link(link).origin;
  return pose;
}

void OtherRobots::find(int system, double h, std::vector<Contact>& contacts) noexcept {
  for (const Robot& robot : robots_) {
    robot.ground.find(robot.body, h, found_);
    for (Contact& c : found_) {
      if (contacts.size() == contacts.capacity()) return;
      c.system = system;
      contacts.push_back(c);
    }
    ++system;
  }
}

void OtherRobots::begin(double h) noexcept {
  for (Robot& robot : robots_) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      robot.joints[j].begin(robot.now.q[index], robot.now.qd[index], h);
    }
    robot.motors.begin(robot.joints, robot.now.q);
  }
}

bool OtherRobots::inward(double h) noexcept {
  bool sound = true;
  for (Robot& robot : robots_) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) robot.rows[j] = robot.joints[j].row();
    sound = robot.body.inward(robot.rows, h) && sound;
  }
  return sound;
}

void OtherRobots::outward() noexcept {
  for (Robot& robot : robots_) robot.body.outward();
}

double OtherRobots::end_speed(const Robot& robot, std::size_t joint, double h) noexcept {
  return robot.now.qd[static_cast<Eigen::Index>(joint)] +
         h * robot.body.qdd(static_cast<int>(joint));
}

bool OtherRobots::holds(const Robot& robot, std::size_t joint, double h) noexcept {
  return robot.joints[joint].holds(end_speed(robot, joint, h));
}

int OtherRobots::wrong(double h) const noexcept {
  int count = 0;
  for (const Robot& robot : robots_) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) count += holds(robot, j, h) ? 0 : 1;
    count += robot.motors.wrong(robot.joints, [&](std::size_t j) { return end_speed(robot, j, h); });
  }
  return count;
}

void OtherRobots::approach(double h, bool all) noexcept {
  for (Robot& robot : robots_) robot.motors.approach(robot.joints, [&](std::size_t j) { return end_speed(robot, j, h); });
  for (std::size_t r = robots_.size(); r-- > 0;) {
    Robot& robot = robots_[r];
    for (std::size_t j = robot.joints.size(); j-- > 0;) {
      if (holds(robot, j, h)) continue;
      if (all) {
        robot.joints[j].approach(end_speed(robot, j, h));
        continue;
      }
      robot.joints[j].approach_by_one(end_speed(robot, j, h));
      return;
    }
  }
}

bool OtherRobots::advance(const std::vector<Contact>& contacts, int system, double h,
                          double share) noexcept {
  for (Robot& robot : robots_) {
    robot.body.advance(h, robot.now);
    if (check_configuration(robot.joints.size(), robot.now) != Status::kOk) return false;
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      robot.joints[j].finish(robot.now.qd[static_cast<Eigen::Index>(j)], share);
    }
    robot.ground.remember(contacts, system++, h);
    robot.body.place(robot.now);
  }
  return true;
}

void OtherRobots::place_all() noexcept {
  for (Robot& robot : robots_) robot.body.place(robot.now);
}

void OtherRobots::save() noexcept {
  for (Robot& robot : robots_) {
    robot.start = robot.now;
    robot.ground.save();
    for (JointLaw& joint : robot.joints) joint.save();
  }
}

void OtherRobots::restore() noexcept {
  for (Robot& robot : robots_) {
    robot.now = robot.start;
    robot.ground.restore();
    for (JointLaw& joint : robot.joints) joint.restore();
    robot.body.place(robot.now);
  }
}

void OtherRobots::keep_coarse(int which) noexcept {
  for (Robot& robot : robots_) robot.coarse[at(which)] = robot.now;
}

double OtherRobots::extrapolate(int order) noexcept {
  double correction = 0.0;
  for (Robot& robot : robots_) {
    robot.fine = robot.now;
    correction = std::max(correction, twinbus::extrapolate(order, robot.coarse, robot.now));
    if (passes_stops(robot.joints, robot.fine, robot.now)) robot.now = robot.fine;
    robot.body.place(robot.now);
  }
  return correction;
}

std::uint64_t OtherRobots::pattern(std::uint64_t pattern) const noexcept {
  for (const Robot& robot : robots_) {
    for (const JointLaw& joint : robot.joints) pattern = mix(pattern, joint.pattern());
    pattern = robot.motors.pattern(pattern);
  }
  return pattern;
}

}  // namespace twinbus::sim
