#include "robot/onboarding/known_srdf.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/text/formatted.h"
#include "robot/onboarding/anatomy.h"
#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

namespace {

constexpr double kOutside = 1e-3;   // a pose that leaves a limit by no more is put on it [rad or m]
constexpr double kParallel = 0.05;  // tilt of a sole [rad]
constexpr double kMostTilt = 0.025;  // tilt of the base over the soles [rad]
constexpr double kLevel = 0.005;    // of the two soles [m]
constexpr double kWellInside = 0.2;  // of the half length, from the edge

bool is_frame(const Model& model, const std::string& name) {
  return std::any_of(model.frames.begin(), model.frames.end(),
                     [&](const Frame& frame) { return frame.name == name; });
}

void take_pose(const Model& model, const SrdfPose& from, const std::string& origin, KnownSrdf& known) {
  NamedPose pose;
  pose.name = from.name;
  const Eigen::VectorXd neutral = neutral_posture(model);
  pose.q.assign(neutral.data(), neutral.data() + neutral.size());
  int unknown = 0;
  std::string first;
  for (const auto& [name, value] : from.joints) {
    const int j = model.find_joint(name);
    if (j < 0) {
      if (unknown++ == 0) first = name;
      continue;
    }
    const Joint& joint = model.joints[at(j)];
    if (!(value >= joint.lower - kOutside && value <= joint.upper + kOutside)) {
      known.doubts.push_back("pose " + from.name + " of " + origin + " is not used: joint " + name +
                             formatted(" at %.4g; its limits are %.4g to %.4g", value, joint.lower, joint.upper));
      return;
    }
    pose.q[at(j)] = std::clamp(value, joint.lower, joint.upper);
  }
  if (unknown > 0) {
    known.doubts.push_back("pose " + from.name + " of " + origin + " names " +
                           std::to_string(unknown) + " joints that do not move here, the first " +
                           first + ": left out");
  }
  known.poses.push_back(std::move(pose));
}

}  // namespace

KnownSrdf fit_srdf(const Model& model, const std::string& text, const std::string& file, const std::string& origin) {
  KnownSrdf known;
  if (text.empty()) return known;
  Srdf srdf;
  try {
    srdf = parse_srdf(text, file);
  } catch (const std::runtime_error& error) {
    known.doubts.push_back(origin + " is not used: " + error.what());
    return known;
  }
  known.feet = srdf.feet;
  for (const SrdfPose& pose : srdf.poses) take_pose(model, pose, origin, known);
  for (const SrdfPair& pair : srdf.disabled) {
    if (is_frame(model, pair.link_a) && is_frame(model, pair.link_b))
      known.disabled.emplace_back(pair.link_a, pair.link_b);
  }
  for (const SrdfRotor& rotor : srdf.rotors) {
    if (model.find_joint(rotor.joint) >= 0 && rotor.reflected_inertia > 0.0)
      known.rotors.push_back(rotor);
  }
  return known;
}

std::string why_it_falls(const Model& model, const Eigen::VectorXd& q) {
  if (model.soles[0].link <= 0 || model.soles[1].link <= 0) return "it has no two soles";
  Configuration c(model);
  c.q = q;
  Kinematics k(model);
  k.update(c);
  std::array<Eigen::Isometry3d, 2> sole;
  for (std::size_t side = 0; side < 2; ++side)
    sole[side] = k.link_in_world(model.soles[side].link) * model.soles[side].frame;
  const Eigen::Vector3d up = (sole[0].linear().col(2) + sole[1].linear().col(2)).normalized();
  for (const Eigen::Isometry3d& s : sole) {
    if (!(std::acos(std::clamp(s.linear().col(2).dot(up), -1.0, 1.0)) < kParallel))
      return "the soles are not parallel";
  }
  if (!(std::acos(std::clamp(up.z(), -1.0, 1.0)) < kMostTilt))
    return "the base leans when the soles are flat";
  if (!(std::abs(up.dot(sole[0].translation() - sole[1].translation())) < kLevel))
    return "one foot is higher than the other";
  // Forwards and back only: sideways a posture is symmetric or plainly not.
  double inside = 1e300;
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Vector3d com = sole[side].inverse() * k.com();
    const double half = 0.5 * (model.soles[side].front + model.soles[side].back);
    const double margin =
        std::min(model.soles[side].front - com.x(), model.soles[side].back + com.x());
    inside = std::min(inside, margin / half);
  }
  if (!(inside > kWellInside)) return "the centre of mass is not above the soles";
  return "";
}

}  // namespace twinbus::robot
