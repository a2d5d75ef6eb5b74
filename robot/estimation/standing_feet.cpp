#include "robot/estimation/standing_feet.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "robot/description/link_points.h"
#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline robot {

namespace {

// A foot surely stands above kSure of the robot's weight, surely not below kNot; where torques tell, which miss what the limb's
// own acceleration takes, later.
struct Shares {
  double nothing, sure;
};
constexpr Shares kMeasured{0.04, 0.15};
constexpr Shares kReckoned{0.08, 0.25};
constexpr double kStandsAbove = 0.5;     // of certainty
constexpr double kLands = 0.020;         // a foot that has come down rolls and slips for so long [s]
constexpr double kTorqueFilter = 0.004;  // of load that torques tell [s]
constexpr double kSoft = 0.003;          // points this much higher than the lowest press 1/e as much [m]
constexpr double kNothing = -20.0;       // in those: presses nothing
constexpr double kAsLow = 0.15;          // a limb is a leg if it reaches as low as the soles but for this share of their depth
constexpr double kNoTorque = 1e-6;       // of the weight times a metre: nothing measures torques
constexpr double kMomentArm = 0.1;       // of the moment on a sole, as likely as its force at that arm [m]
constexpr int kDirections = 256;         // in which corners of a mesh are sought
constexpr std::size_t kMostChain = 12;   // joints of a limb that are looked at

double ramp(double x, const Shares& s) noexcept { return std::clamp((x - s.nothing) / (s.sure - s.nothing), 0.0, 1.0); }

}  // namespace

StandingFeet::StandingFeet(const Model& model) : model_(&model), weight_force_(kGravity * model.total_mass()) {
  for (int side = 0; side < 2; ++side) {
    if (model.soles[at(side)].link >= 0) add_foot(model, model.soles[at(side)].link, side);
  }
  // Last links that reach down as far as the soles do, or as the lowest of them where there are none, in the posture nearest
  // to zero.
  Configuration neutral(model);
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    neutral.q[static_cast<Eigen::Index>(j)] = std::clamp(0.0, model.joints[j].lower, model.joints[j].upper);
  }
  Kinematics kinematics(model);
  kinematics.update(neutral);
  const std::size_t soles = feet_.size();
  std::vector<bool> has_child(model.links.size(), false);
  for (const Link& link : model.links) {
    if (link.parent >= 0) has_child[at(link.parent)] = true;
  }
  for (int link = 1; link < model.link_count(); ++link) {
    // Toes are part of the foot that they hang on.
    bool is_foot = false;
    for (int up = link; up > 0 && !is_foot; up = model.links[at(up)].parent)
      is_foot = up == model.soles[0].link || up == model.soles[1].link;
    const bool is_hand = link == model.hands[0].link || link == model.hands[1].link;
    if (!has_child[at(link)] && !is_foot && !is_hand) add_foot(model, link, -1);
  }
  double deepest = 0.0, of_soles = 0.0;
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    Foot& foot = feet_[i];
    find_point(kinematics, Eigen::Matrix3d::Identity(), foot);
    foot.centre = kinematics.link_in_world(foot.link).inverse() * (foot.point + foot.radius * Eigen::Vector3d::UnitZ());
    deepest = std::min(deepest, feet_[i].lowest);
    if (i < soles) of_soles = std::min(of_soles, feet_[i].lowest);
  }
  const double depth = (1.0 - kAsLow) * (soles > 0 ? of_soles : deepest);
  std::vector<Foot> kept;
  for (std::size_t i = 0; i < feet_.size() && kept.size() < kMaxFeet; ++i) {
    if (i < soles || (!feet_[i].balls.empty() && depth < 0.0 && feet_[i].lowest <= depth)) kept.push_back(feet_[i]);
  }
  feet_ = std::move(kept);
  std::vector<bool> needed(model.joints.size(), false);
  for (const Foot& foot : feet_) {
    for (const int joint : foot.chain) needed[at(joint)] = true;
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    if (needed[at(j)]) joints_.push_back(j);
  }
}

void StandingFeet::add_foot(const Model& model, int link, int limb) {
  Foot foot;
  foot.link = link;
  foot.limb = limb;
  if (limb >= 0) {
    const Sole& sole = model.soles[at(limb)];
    foot.sole = &sole;
    for (const double x : {sole.front, -sole.back}) {
      for (const double y : {sole.left, -sole.right}) foot.balls.push_back({sole.frame * Eigen::Vector3d(x, y, 0.0), 0.0});
    }
  } else {
    for (const Shape& shape : model.links[at(link)].collision) {
      const Eigen::Vector3d& size = shape.size;
      if (shape.kind == ShapeKind::kSphere) {
        foot.balls.push_back({shape.pose.translation(), size.x()});
      } else if (shape.kind == ShapeKind::kBox) {
        for (int i = 0; i < 8; ++i) {
          const Eigen::Vector3d corner((i & 1) != 0 ? size.x() : -size.x(), (i & 2) != 0 ? size.y() : -size.y(),
                                       (i & 4) != 0 ? size.z() : -size.z());
          foot.balls.push_back({shape.pose * (0.5 * corner), 0.0});
        }
      } else if (shape.kind == ShapeKind::kCylinder) {
        const double half = std::max(0.0, 0.5 * size.y() - size.x());
        for (const double z : {half, -half}) foot.balls.push_back({shape.pose * Eigen::Vector3d(0.0, 0.0, z), size.x()});
      } else if (model.soles[0].link < 0 && model.soles[1].link < 0) {
        add_corners(shape, foot);
      }
    }
  }
  for (int l = link; l > 0 && foot.chain.size() < kMostChain; l = model.links[at(l)].parent) {
    foot.chain.push_back(l - 1);
    if (foot.bus_joint < 0) foot.bus_joint = model.bus_index[at(l - 1)];
  }
  feet_.push_back(foot);
}

// Of a mesh, those that are farthest out in any direction.
void StandingFeet::add_corners(const Shape& shape, Foot& foot) {
  std::vector<Eigen::Vector3d> points;
  try {
    add_points(shape, points);
  } catch (const std::runtime_error&) {  // check says so
    return;
  }
  std::vector<std::size_t> taken;
  for (int i = 0; i < kDirections && !points.empty(); ++i) {
    // Evenly over the sphere, along a spiral.
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections, angle = 2.399963229728653 * i;
    const double r = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d way(r * std::cos(angle), r * std::sin(angle), z);
    std::size_t best = 0;
    for (std::size_t k = 1; k < points.size(); ++k) best = way.dot(points[k]) > way.dot(points[best]) ? k : best;
    if (std::find(taken.begin(), taken.end(), best) != taken.end()) continue;
    taken.push_back(best);
    foot.balls.push_back({points[best], 0.0});
  }
}

void StandingFeet::reset() noexcept {
  for (Foot& foot : feet_) {
    foot.load = foot.certainty = 0.0;
    foot.stands = false;
  }
  from_ = LoadFrom::kUnknown;
}

// The mean of what is lowest: a sole that rolls turns about its edge.
void StandingFeet::find_point(const Kinematics& kinematics, const Eigen::Matrix3d& base, Foot& foot) const noexcept {
  const Eigen::Isometry3d& pose = kinematics.link_in_world(foot.link);
  const Eigen::Vector3d up = base.row(2).transpose();
  foot.lowest = std::numeric_limits<double>::infinity();
  for (const Ball& ball : foot.balls) {
    const double low = up.dot(pose * ball.centre) - ball.radius;
    if (!(low < foot.lowest)) continue;
    foot.lowest = low;
    foot.radius = ball.radius;
  }
  if (foot.balls.empty()) foot.lowest = 0.0;
  double sum = 0.0;
  foot.point.setZero();
  for (const Ball& ball : foot.balls) {
    const Eigen::Vector3d p = pose * ball.centre - ball.radius * up;
    const double off = (foot.lowest - up.dot(p)) / kSoft;
    if (off < kNothing) continue;
    const double share = std::exp(off);
    sum += share;
    foot.point += share * p;
  }
  if (sum > 0.0) foot.point /= sum;
}

// By its force sensor; false: it has none, or it is not valid.
bool StandingFeet::measure(const RobotState& state, const Kinematics& kinematics, const Eigen::Matrix3d& base,
                           Foot& foot) const noexcept {
  if (foot.limb < 0 || state.wrench_kind[at(foot.limb)] == WrenchKind::kAbsent) return false;
  if ((state.sensor_flags & wrench_valid(static_cast<Limb>(foot.limb))) == 0) return false;
  const auto& w = state.wrench[at(foot.limb)];
  const Eigen::Isometry3d sensor = kinematics.link_in_world(foot.link) * foot.sole->sensor;
  const Eigen::Isometry3d sole = kinematics.link_in_world(foot.link) * foot.sole->frame;
  const Eigen::Vector3d force = sensor.linear() * vector_from_array<float>({w[0], w[1], w[2]});
  foot.load = base.row(2).dot(force) / weight_force_;
  // Where force and moment meet the plane of the sole.
  const Eigen::Vector3d moment = sensor.linear() * vector_from_array<float>({w[3], w[4], w[5]}) +
                                 (sensor.translation() - sole.translation()).cross(force);
  const Eigen::Vector3d f = sole.linear().transpose() * force;
  const Eigen::Vector3d m = sole.linear().transpose() * moment;
  if (f.z() > kMeasured.nothing * weight_force_) {
    foot.point = sole * Eigen::Vector3d(std::clamp(-m.y() / f.z(), -foot.sole->back, foot.sole->front),
                                        std::clamp(m.x() / f.z(), -foot.sole->right, foot.sole->left), 0.0);
  }
  return true;
}

// By the torques of the joints before it.
void StandingFeet::weigh(const RobotState& state, const Kinematics& kinematics, const Eigen::Matrix3d& base,
                         const Eigen::Vector3d& felt, double dt, Foot& foot) const noexcept {
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Vector3d moment_of_mass = Eigen::Vector3d::Zero();  // of the links behind a joint, about the base's origin [kg m]
  double mass = 0.0;
  int rows = 0;
  const bool wrench = foot.sole != nullptr && foot.chain.size() >= 6;
  for (const int joint : foot.chain) {
    const Link& link = model_->links[at(joint + 1)];
    const Eigen::Isometry3d& pose = kinematics.link_in_world(joint + 1);
    mass += link.mass;
    moment_of_mass += link.mass * (pose * link.com);
    const int bus = model_->bus_index[at(joint)];
    if (bus < 0 || model_->joints[at(joint)].kind == JointKind::kPrismatic) continue;
    const Eigen::Vector3d& axis = kinematics.axis_in_world(joint);
    const Eigen::Vector3d arm = foot.point - pose.translation();
    Eigen::Matrix<double, 6, 1> row = Eigen::Matrix<double, 6, 1>::Zero();
    row.head<3>() = axis.cross(arm);
    if (wrench) row.tail<3>() = kMomentArm * axis;
    const double held = axis.dot((moment_of_mass - mass * pose.translation()).cross(felt));
    normal += row * row.transpose();
    right += row * (held - static_cast<double>(state.tau[at(bus)]));
    ++rows;
  }
  const double scale = normal.trace() / 6.0;
  if (rows < 2 || !(scale > 0.0)) return;
  for (int i = 0; i < 6; ++i) normal(i, i) += 1e-4 * scale;
  const Eigen::Matrix<double, 6, 1> found = normal.ldlt().solve(right);
  if (!found.allFinite()) return;
  const double load = base.row(2).dot(found.head<3>()) / weight_force_;
  foot.load += dt / (dt + kTorqueFilter) * (load - foot.load);
}

void StandingFeet::place(const Kinematics& kinematics, const Eigen::Matrix3d& base) noexcept {
  for (Foot& foot : feet_) find_point(kinematics, base, foot);
}

void StandingFeet::update(const RobotState& state, const Kinematics& kinematics, const Eigen::Matrix3d& base,
                          const Eigen::Vector3d& felt, double dt) noexcept {
  double torque = 0.0;
  for (const int joint : joints_) {
    const int bus = model_->bus_index[at(joint)];
    if (bus >= 0) torque += std::abs(static_cast<double>(state.tau[at(bus)]));
  }
  const bool torques = torque > kNoTorque * weight_force_;
  from_ = feet_.empty() ? LoadFrom::kUnknown : LoadFrom::kForces;
  double lowest = std::numeric_limits<double>::infinity();
  for (Foot& foot : feet_) {
    find_point(kinematics, base, foot);
    lowest = std::min(lowest, foot.lowest);
  }
  for (Foot& foot : feet_) {
    double sure = 0.0;
    if (measure(state, kinematics, base, foot)) {
      sure = ramp(foot.load, kMeasured);
    } else if (torques) {
      weigh(state, kinematics, base, felt, dt, foot);
      sure = ramp(foot.load, kReckoned);
      from_ = LoadFrom::kTorques;
    } else {
      sure = foot.lowest < lowest + kSameHeight ? 1.0 : 0.0;
      from_ = LoadFrom::kHeights;
    }
    foot.certainty = std::min(sure, foot.certainty + dt / kLands);
    foot.stands = foot.certainty > kStandsAbove;
  }
  if (from_ != LoadFrom::kHeights) return;
  const auto standing = std::count_if(feet_.begin(), feet_.end(), [](const Foot& f) { return f.certainty > 0.0; });
  for (Foot& foot : feet_) foot.load = foot.certainty > 0.0 ? 1.0 / static_cast<double>(standing) : 0.0;
}

}  // namespace twinbus::robot
