#include "python/simulation/robot_query.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/pose_math.h"
#include "common/text/closest_name.h"
#include "robot/description/model.h"
#include "robot/description/load.h"
#include "robot/description/named_hands.h"
#include "robot/kinematics/inverse_kinematics.h"

namespace twinbus {

namespace {

constexpr double kFar = 1.0;  // [m]
constexpr int kMostPairs = 10'000;
constexpr int kIkTries = 16;

// A place as a pose.
Eigen::Isometry3d checked(const RobotQuery::Place& place) {
  if (!place.position.allFinite()) throw std::invalid_argument("position: not finite");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = place.position;
  if (place.orientation) {
    const double length = place.orientation->norm();
    if (!(length > 1e-6 && length < 1e6)) throw std::invalid_argument("orientation: a quaternion w x y z, not of length zero");
    pose.linear() = place.orientation->normalized().toRotationMatrix();
  }
  return pose;
}

}  // namespace

RobotQuery::RobotQuery(const std::string& robot)
    : model_(std::make_unique<Model>(load_robot(robot))), kinematics_(*model_), configuration_(*model_) {}

void RobotQuery::place(const std::vector<double>& q) {
  if (q.size() != model_->bus_joints.size()) {
    throw std::invalid_argument("q: " + std::to_string(q.size()) + " numbers, the robot has " +
                                std::to_string(model_->bus_joints.size()) + " joints");
  }
  RobotState state;
  state.joint_count = static_cast<std::int16_t>(q.size());
  for (std::size_t k = 0; k < q.size(); ++k) {
    if (!std::isfinite(q[k])) {
      throw std::invalid_argument("q of joint " + model_->joints[static_cast<std::size_t>(model_->bus_joints[k])].name +
                                  " is not finite");
    }
    state.q[k] = q[k];
  }
  set_joints(*model_, state, configuration_);
  kinematics_.update(configuration_);
}

const Frame& RobotQuery::frame(const std::string& link) const {
  for (const Frame& each : model_->frames) {
    if (each.name == link) return each;
  }
  throw std::invalid_argument("the robot has no link '" + link + "'" + suggestion(link, model_->frames));
}

RobotQuery::Rows RobotQuery::link_pose(const std::vector<double>& q, const std::string& link) {
  const Frame& at = frame(link);
  place(q);
  const Eigen::Matrix4d pose = (kinematics_.link_in_world(at.link) * at.in_link).matrix();
  Rows rows(4, std::vector<double>(4));
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = pose(i, j);
  }
  return rows;
}

std::vector<double> RobotQuery::com(const std::vector<double>& q) {
  place(q);
  const Eigen::Vector3d& com = kinematics_.com();
  return {com.x(), com.y(), com.z()};
}

RobotQuery::Rows RobotQuery::jacobian(const std::vector<double>& q, const std::string& link) {
  const Frame& at = frame(link);
  place(q);
  Eigen::MatrixXd all(6, 6 + model_->joint_count());
  kinematics_.point_jacobian(at.link, kinematics_.link_in_world(at.link) * at.in_link.translation(), all);
  // What follows a joint moves with it.
  for (int j = model_->joint_count() - 1; j >= 0; --j) {
    const Joint& joint = model_->joints[static_cast<std::size_t>(j)];
    if (joint.mimic >= 0) all.col(6 + joint.mimic) += joint.mimic_multiplier * all.col(6 + j);
  }
  Rows rows(6, std::vector<double>(q.size()));
  for (std::size_t k = 0; k < q.size(); ++k) {
    for (int i = 0; i < 6; ++i) rows[static_cast<std::size_t>(i)][k] = all(i, 6 + model_->bus_joints[k]);
  }
  return rows;
}

std::vector<RobotQuery::Near> RobotQuery::nearest(const std::vector<double>& q, int most) {
  if (most < 1 || most > kMostPairs) throw std::invalid_argument("most: 1 to " + std::to_string(kMostPairs));
  place(q);
  if (!collision_) collision_ = std::make_unique<Collision>(*model_);
  std::vector<PairDistance> pairs(static_cast<std::size_t>(most));
  const int count = collision_->near_pairs(kinematics_, kFar, pairs.data(), most);
  std::vector<Near> found;
  for (int i = 0; i < std::min(count, most); ++i) {
    const PairDistance& pair = pairs[static_cast<std::size_t>(i)];
    found.push_back({model_->links[static_cast<std::size_t>(pair.link_a)].name,
                     model_->links[static_cast<std::size_t>(pair.link_b)].name, pair.distance});
  }
  return found;
}

const Hand& RobotQuery::arm(const std::string& name) const {
  const Hand* there = hand_called(*model_, name);
  const std::string names = hand_names(*model_);
  if (there == nullptr) throw std::invalid_argument("the robot has no " + name + " hand; say one of: " + (names.empty() ? "none" : names));
  if (there->joints.empty()) throw std::invalid_argument("no joint moves " + spoken_name(*model_, *there));
  return *there;
}

RobotQuery::Reached RobotQuery::inverse(const std::vector<double>& q, const std::string& hand, const Place& place) {
  const Hand& arm = this->arm(hand);
  const Eigen::Isometry3d target = checked(place);
  this->place(q);
  const int trunk = model_->joints[static_cast<std::size_t>(arm.joints.front())].parent;
  InverseKinematics kinematics(*model_, trunk, arm.link, arm.frame);
  IkOptions options;
  options.restarts = kIkTries;
  if (!place.orientation) options.rotation_weight = 0.0;
  Reached found;
  const IkResult result = kinematics.solve(kinematics_.link_in_world(trunk).inverse() * target, options, configuration_.q);
  found.reached = result.reached;
  found.position_error = result.position_error;
  found.rotation_error = place.orientation ? result.rotation_error : 0.0;
  for (const int j : model_->bus_joints) found.q.push_back(configuration_.q[j]);
  return found;
}

RobotQuery::Path RobotQuery::plan(const std::vector<double>& q, const std::string& hand, const Place& place,
                                  const std::vector<Obstacle>& obstacles, double speed, std::uint64_t seed) {
  ArmGoal goal;
  goal.side = static_cast<ArmSide>(number_of(*model_, arm(hand)) + 1);
  const Eigen::Isometry3d target = checked(place);
  if (!(speed > 0.0 && speed <= 1.0)) throw std::invalid_argument("speed: above 0, at most 1");
  if (obstacles.size() > Collision::kMaxObstacles) {
    throw std::invalid_argument("obstacles: at most " + std::to_string(Collision::kMaxObstacles));
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (!takes_part(obstacles[i], *model_)) {
      throw std::invalid_argument("obstacle " + std::to_string(i + 1) + ": its size must be positive and its numbers finite");
    }
  }
  this->place(q);
  if (!planner_) planner_ = std::make_unique<ArmPlanner>(*model_);
  planner_->set_obstacles(obstacles);
  goal.goal_id = 1;
  goal.kind = place.orientation ? ArmGoalKind::kPose : ArmGoalKind::kPosition;
  Eigen::Map<Eigen::Vector3d>(goal.position.data()) = target.translation();
  goal.orientation = array_from_rotation<double>(target.linear());
  goal.speed = static_cast<float>(speed);
  const ArmPlan plan = planner_->plan(goal, configuration_, Eigen::Isometry3d::Identity(), seed);
  Path path;
  path.text = describe(plan);
  for (const int j : plan.joints) path.joints.push_back(model_->joints[static_cast<std::size_t>(j)].name);
  for (const auto& knot : plan.path) {
    path.time.push_back(knot.time);
    path.q.emplace_back(knot.q.data(), knot.q.data() + knot.q.size());
    path.qd.emplace_back(knot.qd.data(), knot.qd.data() + knot.qd.size());
  }
  return path;
}

}  // namespace twinbus
