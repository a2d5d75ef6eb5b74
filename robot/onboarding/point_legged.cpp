#include "robot/onboarding/point_legged.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"
#include "robot/onboarding/line_feet.h"

namespace twinbus::inline robot {

namespace {

constexpr double kLevelFeet = 0.005;  // the highest above the lowest, at most [m]
constexpr double kMiddle = 0.3;       // of the way to the edge the centre of mass may be off
constexpr double kBentLength = 0.72;      // of the length of a leg: from the joint that swings it down to the ground
constexpr double kPoint = 0.1;      // of the height of the hips: a longer foot is a sole
constexpr double kReached = 1e-4;   // [m]
constexpr double kReserve = 0.05;   // to the end of a joint's range [rad]
constexpr int kRounds = 60, kShifts = 12;
constexpr std::array<double, 3> kHips{-0.8, 0.0, 0.8};
constexpr std::array<double, 4> kKnees{-1.5, -0.8, 0.8, 1.5};

class LegSolver {
 public:
  LegSolver(const Model& model, const PointLeg& leg) : model_(model), leg_(leg), feet_(model), k_(model) {}

  // Moves the joints of the leg in c until its foot is at target; how far it is from there [m].
  double solve(const Eigen::Vector3d& target, Configuration& c) {
    double off = look(target, c).norm();
    for (int round = 0; round < kRounds && off > 0.1 * kReached; ++round) {
      const Eigen::Vector3d error = look(target, c);
      Eigen::Matrix3d square = 1e-6 * Eigen::Matrix3d::Identity();
      for (const int j : leg_.joints) square += column(j) * column(j).transpose();
      const Eigen::Vector3d w = square.ldlt().solve(error);
      for (const int j : leg_.joints) {
        const Joint& joint = model_.joints[at(j)];
        const double low = joint.lower + kReserve, high = joint.upper - kReserve;
        c.q[j] = std::clamp(c.q[j] + std::clamp(column(j).dot(w), -0.3, 0.3), std::min(low, high), std::max(low, high));
      }
      off = look(target, c).norm();
    }
    return off;
  }

  // How far the knee is before the line from hip to foot [m].
  double knee_forward() const {
    const Eigen::Vector3d hip = k_.link_in_world(leg_.joints[1] + 1).translation();
    const Eigen::Vector3d knee = k_.link_in_world(leg_.joints[2] + 1).translation();
    return knee.x() - 0.5 * (hip.x() + feet_.point(leg_.foot).x());
  }

 private:
  Eigen::Vector3d look(const Eigen::Vector3d& target, const Configuration& c) {
    k_.update(c);
    feet_.place(k_, Eigen::Matrix3d::Identity());
    return target - feet_.point(leg_.foot);
  }
  Eigen::Vector3d column(int j) const {
    const Eigen::Vector3d& axis = k_.axis_in_world(j);
    if (model_.joints[at(j)].kind == JointKind::kPrismatic) return axis;
    return axis.cross(feet_.point(leg_.foot) - k_.link_in_world(j + 1).translation());
  }

  const Model& model_;
  const PointLeg& leg_;
  StandingFeet feet_;
  Kinematics k_;
};

// The best of what the leg ends in from several bends.
bool bend_to(const Model& model, const PointLeg& leg, const Eigen::Vector3d& target, const Eigen::VectorXd& neutral,
             Configuration& c) {
  LegSolver solver(model, leg);
  Configuration best = c;
  double behind = 1e300;
  for (const double hip : kHips) {
    for (const double knee : kKnees) {
      Configuration tried = c;
      for (const int j : leg.joints) tried.q[j] = neutral[j];
      const auto bend = [&](int j, double angle) {
        tried.q[j] = std::clamp(angle, model.joints[at(j)].lower, model.joints[at(j)].upper);
      };
      bend(leg.joints[1], hip);
      bend(leg.joints[2], knee);
      if (!(solver.solve(target, tried) < kReached)) continue;
      const double forward = solver.knee_forward();
      if (!(forward < behind - 1e-3)) continue;
      behind = forward;
      best = tried;
    }
  }
  if (behind > 1e299) return false;
  c = best;
  return true;
}

}  // namespace

std::optional<PointLegs> find_point_legs(const Model& model, Anatomy& anatomy) {
  Model bare = model;
  bare.soles = {};
  bare.floating_base = true;
  const StandingFeet feet(bare);
  const char* why = "";
  std::optional<PointLegs> legs = point_legs(bare, feet, &why);
  if (legs && legs->size() == 2) {
    for (const Sole& sole : anatomy.soles) {
      const double size = std::max(sole.front + sole.back, sole.left + sole.right);
      if (sole.link < 0 || (size > kPoint * anatomy.hip_height && !is_line(sole))) return std::nullopt;
    }
  }
  if (!legs) {
    if (feet.count() == 4 && anatomy.soles[0].link < 0)
      anatomy.doubts.push_back(std::string("four limbs reach the ground, but it is not taken for a quadruped that stands and trots: ") + why);
    return legs;
  }
  const bool lines = anatomy.soles[0].link >= 0 && is_line(anatomy.soles[0]);
  anatomy.soles = {};
  anatomy.sole_sensor = {};
  anatomy.leg_joints.clear();
  for (const PointLeg& leg : *legs) {
    anatomy.leg_joints.insert(anatomy.leg_joints.end(), leg.joints.begin(), leg.joints.end());
  }
  std::erase_if(anatomy.doubts, [](const std::string& doubt) {
    return doubt.find("imb") != std::string::npos || doubt.find("sole") != std::string::npos || doubt.find("arms") != std::string::npos ||
           doubt.find("hand without") != std::string::npos;
  });
  std::string names;
  for (const PointLeg& leg : *legs) names += (names.empty() ? "" : ", ") + model.links[at(leg.link)].name;
  anatomy.doubts.push_back(std::string("it is taken for a robot on ") + (legs->size() == 2 ? "two" : "four") + " feet that are points" +
                           (lines ? ", or lines: " : ": ") + names);
  return legs;
}

bool find_point_legged_posture(const Model& model, const PointLegs& legs, Eigen::VectorXd& q) {
  Configuration c(model);
  const Eigen::VectorXd neutral = neutral_posture(model);
  c.q = q.size() == model.joint_count() ? q : neutral;
  Kinematics k(model);
  k.update(c);
  StandingFeet feet(model);
  feet.place(k, Eigen::Matrix3d::Identity());
  const double each = 1.0 / static_cast<double>(legs.size());
  std::vector<Eigen::Vector3d> target(legs.size());
  double shortest = 1e300, level = 0.0;
  for (const PointLeg& leg : legs) {
    shortest = std::min(shortest, leg_length(model, leg, feet));
    level += each * k.link_in_world(leg.joints[1] + 1).translation().z();
  }
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double x = k.link_in_world(legs[i].joints[1] + 1).translation().x();
    target[i] << x, feet.point(legs[i].foot).y(), level - kBentLength * shortest;
  }
  for (int shift = 0; shift < kShifts; ++shift) {
    double middle = 0.0;
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const bool bent = shift == 0 ? bend_to(model, legs[i], target[i], neutral, c)
                                   : LegSolver(model, legs[i]).solve(target[i], c) < kReached;
      if (!bent) return false;
      middle += each * target[i].x();
    }
    k.update(c);
    const double off = k.com().x() - middle;
    if (std::abs(off) < 1e-4) break;
    for (Eigen::Vector3d& t : target) t.x() += off;
  }
  q = c.q;
  return true;
}

namespace {
// Where legs and feet are in a posture, the base upright.
struct PlacedFeet {
  PlacedFeet(const Model& model, const Eigen::VectorXd& q) : kinematics(model), feet(model) {
    Configuration c(model);
    c.q = q;
    kinematics.update(c);
    feet.place(kinematics, Eigen::Matrix3d::Identity());
  }
  double swings_above(const PointLeg& leg) const {
    return (kinematics.link_in_world(leg.joints[1] + 1).translation() - feet.point(leg.foot)).z();
  }
  Kinematics kinematics;
  StandingFeet feet;
};
}  // namespace

double point_legged_height(const Model& model, const PointLegs& legs, const Eigen::VectorXd& q) {
  const PlacedFeet placed(model, q);
  double height = 0.0;
  for (const PointLeg& leg : legs) height += placed.swings_above(leg) / static_cast<double>(legs.size());
  return std::max(height, 0.05);
}

bool stands_on_point_legs(const Model& model, const PointLegs& legs, const Eigen::VectorXd& q) {
  if (q.size() != model.joint_count()) return false;
  const PlacedFeet placed(model, q);
  Eigen::AlignedBox3d box;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const PointLeg& leg : legs) {
    const Eigen::Vector3d point = placed.feet.point(leg.foot);
    box.extend(point);
    middle += point / static_cast<double>(legs.size());
    if (!(placed.swings_above(leg) > 0.0)) return false;
  }
  const Eigen::Vector2d off = (placed.kinematics.com() - middle).head<2>().cwiseAbs(), half = 0.5 * box.sizes().head<2>();
  return box.sizes().z() < kLevelFeet && off.x() < kMiddle * half.x() && off.y() < kMiddle * half.y();
}

bool bends_in_many_ways(const PointLegs& legs) noexcept {
  return std::any_of(legs.begin(), legs.end(), [](const PointLeg& leg) { return leg.joints.size() > 3; });
}

}  // namespace twinbus::robot
