// The posture nearest to zero; and legs of a robot that is known by its soles only, bent until it stands over them.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "robot/onboarding/anatomy.h"
#include "common/math/index.h"
#include "robot/kinematics/inverse_kinematics.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

namespace {

// Of the length of the leg that the hips go down; less where the joints do not allow more.
constexpr double kDrops[] = {0.06, 0.04, 0.025, 0.015, 0.008, 0.005, 0.003, 0.002, 0.001};
constexpr int kPostureRounds = 60;
constexpr double kKneeShare = 0.75;  // of its torque that carrying the robot on one leg may take
// The centre of mass stands behind the middle of the soles by this share of their length, but no farther than that [m]: balance
// keeps it there (balance_gains.h), and a push from behind has room in front.
constexpr double kBehind = 0.085, kMostBehind = 0.02;
constexpr double kBetweenSoles = 0.05;  // at least: feet that all but touch cannot be lifted past each other [m]
constexpr double kBetweenLegs = 0.015;  // at rest, where wider stances allow it: a guard keeps 0.01 [m]
constexpr double kMostWider = 0.08, kWiderStep = 0.01;  // [m]

// Those of a leg that turn about y, from the foot up: ankle, knee and hip.  Of more the knee is nearest to halfway.
std::vector<int> pitch_joints(const Model& model, const Kinematics& k, int foot_link) {
  std::vector<int> pitch;
  for (int link = foot_link; link > 0; link = model.links[at(link)].parent) {
    if (std::abs(k.axis_in_world(link - 1).y()) > 0.7) pitch.push_back(link - 1);
  }
  if (pitch.size() <= 3) return pitch;
  const auto place = [&](int joint) -> Eigen::Vector3d { return k.link_in_world(joint + 1).translation(); };
  const auto to_ends = [&](int joint) {
    return std::min((place(joint) - place(pitch.front())).norm(), (place(joint) - place(pitch.back())).norm());
  };
  const int knee = *std::max_element(pitch.begin() + 1, pitch.end() - 1, [&](int a, int b) { return to_ends(a) < to_ends(b); });
  return {pitch.front(), knee, pitch.back()};
}

// Knees forward: the joints of a leg that turn about y are bent like hip, knee and ankle.
void bend(const Model& model, const Kinematics& k, int foot, Eigen::VectorXd& q) {
  const std::vector<int> pitch = pitch_joints(model, k, model.soles[at(foot)].link);
  if (pitch.size() != 3) return;
  const double angle[3] = {-0.35, 0.7, -0.35};  // ankle, knee, hip
  for (std::size_t i = 0; i < 3; ++i) {
    const Joint& joint = model.joints[at(pitch[i])];
    const double sign = k.axis_in_world(pitch[i]).y() > 0.0 ? 1.0 : -1.0;
    q[pitch[i]] = std::clamp(sign * angle[i], joint.lower, joint.upper);
  }
}

// Whether each knee, the middle one of three joints that turn about y, carries the robot when the weight is on its leg alone.
bool knees_carry(const Model& model, const Kinematics& k) {
  for (const Sole& sole : model.soles) {
    const std::vector<int> pitch = pitch_joints(model, k, sole.link);
    if (pitch.size() != 3) continue;
    const double lever = (k.link_in_world(pitch[1] + 1).translation() - k.com()).x();
    if (std::abs(lever) * model.total_mass() * kGravity > kKneeShare * model.joints[at(pitch[1])].effort) return false;
  }
  return true;
}

// Both soles flat at `target` (base's frame) and the centre of mass a little behind their middle.
bool put(const Model& model, std::vector<InverseKinematics>& legs,
         std::array<Eigen::Isometry3d, 2> target, Kinematics& k, Configuration& c) {
  for (int round = 0; round < kPostureRounds; ++round) {
    double middle = 0.0;
    for (int foot = 0; foot < 2; ++foot) {
      const IkResult result = legs[at(foot)].solve(target[at(foot)], {.restarts = 5}, c.q);
      if (!result.reached) return false;
      const Sole& sole = model.soles[at(foot)];
      middle += 0.5 * (target[at(foot)].translation().x() + 0.5 * (sole.front - sole.back) -
                       std::min(kMostBehind, kBehind * (sole.front + sole.back)));
    }
    k.update(c);
    const double error = k.com().x() - middle;
    if (std::abs(error) < 1e-6) return true;
    for (Eigen::Isometry3d& sole : target) sole.translation().x() += error;
  }
  return false;
}

}  // namespace

Eigen::VectorXd neutral_posture(const Model& model) {
  Eigen::VectorXd q(model.joint_count());
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[at(j)];
    q[j] = std::clamp(0.0, joint.lower, joint.upper);
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[at(j)];
    if (joint.mimic >= 0) q[j] = joint.mimic_multiplier * q[joint.mimic] + joint.mimic_offset;
  }
  return q;
}

Kinematics at_rest(const Model& model) {
  Configuration c(model);
  c.q = neutral_posture(model);
  Kinematics k(model);
  k.update(c);
  return k;
}

namespace {

// With the feet so much farther apart than they are at rest, or than kBetweenSoles asks for [m].
bool find_stance(const Model& model, double apart, Eigen::VectorXd& q) {
  Configuration c(model);
  c.q = q.size() == model.joint_count() ? q : neutral_posture(model);
  Kinematics k(model);
  k.update(c);
  std::array<Eigen::Isometry3d, 2> target;  // in the base's frame
  double leg = 0.0, level = 0.0;
  for (int foot = 0; foot < 2; ++foot) {
    const Sole& sole = model.soles[at(foot)];
    target[at(foot)] = k.link_in_world(sole.link) * sole.frame;
    int root = sole.link;
    while (model.links[at(root)].parent > 0) root = model.links[at(root)].parent;
    leg = (k.link_in_world(root).translation() - target[at(foot)].translation()).norm();
    level += 0.5 * target[at(foot)].translation().z();
  }
  const double between = target[0].translation().y() - target[1].translation().y() - model.soles[0].right - model.soles[1].left;
  const double wider = std::max(0.0, kBetweenSoles - between) + apart;
  target[0].translation().y() += 0.5 * wider;
  target[1].translation().y() -= 0.5 * wider;
  Eigen::VectorXd bent = c.q;
  for (int foot = 0; foot < 2; ++foot) bend(model, k, foot, bent);
  std::vector<InverseKinematics> legs;
  for (int foot = 0; foot < 2; ++foot) {
    legs.emplace_back(model, 0, model.soles[at(foot)].link, model.soles[at(foot)].frame);
  }
  bool found = false;
  for (const double drop : kDrops) {
    for (Eigen::Isometry3d& sole : target) {
      sole.linear().setIdentity();
      sole.translation().z() = level + drop * leg;
    }
    c.q = bent;
    if (!put(model, legs, target, k, c)) continue;
    if (!found) q = c.q;
    found = true;
    if (!knees_carry(model, k)) continue;
    q = c.q;
    return true;
  }
  return found;
}

}  // namespace

bool find_standing_posture(const Model& model, Eigen::VectorXd& q) {
  if (model.soles[0].link <= 0 || model.soles[1].link <= 0) return false;
  const Eigen::VectorXd given = q;
  if (!find_stance(model, 0.0, q)) return false;
  // Thighs or hips that all but touch.
  double gap = leg_to_leg(model, model.soles, q);
  for (double apart = kWiderStep; gap < kBetweenLegs && apart < kMostWider + 0.5 * kWiderStep; apart += kWiderStep) {
    Eigen::VectorXd wider = given;
    if (!find_stance(model, apart, wider)) break;
    const double reached = leg_to_leg(model, model.soles, wider);
    if (!(reached > gap)) continue;
    gap = reached;
    q = wider;
  }
  return true;
}

}  // namespace twinbus::robot
