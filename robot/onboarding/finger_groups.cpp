#include "robot/onboarding/finger_groups.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "robot/collision/collision_pairs.h"
#include "robot/description/link_points.h"
#include "robot/description/urdf.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

namespace {

constexpr double kClosesBy = 0.02;   // of the distance between fingers: what changes it less neither opens nor closes
constexpr std::size_t kPoints = 60;  // of a link that are looked at
constexpr double kGrip = 0.1;        // of its range, by which a finger is off its place when it grips with all its effort
constexpr double kFastestFinger = 500.0;   // of a light finger [rad/s]

// Each at most kPoints, spread over the link [m].
std::vector<Eigen::Vector3d> some_points(const Link& link) {
  const std::vector<Eigen::Vector3d> all = link_points(link);
  if (all.size() <= kPoints) return all;
  std::vector<Eigen::Vector3d> some;
  for (std::size_t i = 0; i < kPoints; ++i) some.push_back(all[i * all.size() / kPoints]);
  return some;
}

class Fingers {
 public:
  Fingers(const Model& model, int hand) : model_(model), hand_(hand), kinematics_(model) {
    for (int link = hand; link < model.link_count(); ++link) {
      if (!hangs_on(model, link, hand)) continue;
      links_.push_back(link);
      points_.emplace(link, some_points(model.links[at(link)]));
    }
  }

  const std::vector<int>& links() const { return links_; }

  // How far the fingers are apart: the mean over points of each from the nearest point of the others, of a single one from its
  // hand.  NaN where nothing has geometry.
  double apart(const Eigen::VectorXd& q) {
    Configuration c(model_);
    c.q = q;
    set_mimics(model_, c);
    kinematics_.update(c);
    std::map<int, std::vector<Eigen::Vector3d>> fingers;  // by the link that carries them on the hand
    std::vector<Eigen::Vector3d> palm;
    for (const auto& [link, points] : points_) {
      std::vector<Eigen::Vector3d>& into = link == hand_ ? palm : fingers[root_of(link)];
      for (const Eigen::Vector3d& point : points) into.push_back(kinematics_.link_in_world(link) * point);
    }
    std::erase_if(fingers, [](const auto& finger) { return finger.second.empty(); });
    double sum = 0.0;
    int count = 0;
    for (const auto& [root, points] : fingers) {
      for (const Eigen::Vector3d& point : points) {
        double nearest = 1e300;
        const auto look = [&](const std::vector<Eigen::Vector3d>& others) {
          for (const Eigen::Vector3d& other : others) nearest = std::min(nearest, (other - point).squaredNorm());
        };
        for (const auto& [other, others] : fingers) {
          if (other != root) look(others);
        }
        if (fingers.size() == 1) look(palm);
        if (nearest > 1e299) continue;
        sum += std::sqrt(nearest);
        ++count;
      }
    }
    return count > 0 ? sum / count : std::nan("");
  }

 private:
  int root_of(int link) const {
    while (model_.links[at(link)].parent != hand_) link = model_.links[at(link)].parent;
    return link;
  }

  const Model& model_;
  int hand_;
  Kinematics kinematics_;
  std::vector<int> links_;
  std::map<int, std::vector<Eigen::Vector3d>> points_;
};

bool can_move(const Joint& joint) {
  return std::isfinite(joint.lower) && std::isfinite(joint.upper) && joint.upper > joint.lower && joint.effort > 0.0 &&
         joint.velocity > 0.0;
}

// What hangs on a hand may be arms, where the limb that was taken for one is a neck.
bool lighter_than_arm(const Model& model, const Hand& hand) {
  double behind = 0.0, arm = 0.0;
  for (int link = hand.joints.front() + 1; link < model.link_count(); ++link) {
    if (!hangs_on(model, link, hand.joints.front() + 1)) continue;
    const bool finger = link != hand.link && hangs_on(model, link, hand.link);
    (finger ? behind : arm) += model.links[at(link)].mass;
  }
  return behind < arm;
}

FingerGroup group_of(const Model& model, const Hand& hand) {
  FingerGroup group;
  if (hand.joints.empty() || !lighter_than_arm(model, hand)) return {};
  Fingers fingers(model, hand.link);
  for (const int link : fingers.links()) {
    if (link == hand.link) continue;
    const Joint& joint = model.joints[at(link - 1)];
    if (joint.mimic >= 0) {
      if (!hangs_on(model, joint.mimic + 1, hand.link) || joint.mimic + 1 == hand.link) return {};
      continue;
    }
    if (!can_move(joint)) return {};
    group.joints.push_back(link - 1);
  }
  if (group.joints.empty()) return {};
  group.links = fingers.links();
  const Eigen::VectorXd rest = neutral_posture(model);
  for (const int j : group.joints) {
    const Joint& joint = model.joints[at(j)];
    Eigen::VectorXd q = rest;
    q[j] = joint.lower;
    const double low = fingers.apart(q);
    q[j] = joint.upper;
    const double high = fingers.apart(q);
    const bool closes = std::abs(high - low) > kClosesBy * std::max(high, low);
    group.closed.push_back(!closes ? rest[j] : low < high ? joint.lower : joint.upper);
    group.open.push_back(!closes ? rest[j] : low < high ? joint.upper : joint.lower);
  }
  return group.open == group.closed ? FingerGroup{} : group;
}

}  // namespace

FingerGroups finger_groups(const Model& model, const Anatomy& anatomy, bool planar) {
  FingerGroups groups;
  std::size_t kept = 0, behind = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    if (anatomy.hands[side].link > 0) groups[side] = group_of(model, anatomy.hands[side]);
    kept += groups[side].joints.size();
  }
  for (const int j : model.bus_joints) {
    for (const Hand& hand : anatomy.hands)
      behind += hand.link > 0 && j + 1 != hand.link && hangs_on(model, j + 1, hand.link) ? 1 : 0;
  }
  const std::size_t of_base = planar ? std::size(kPlaneJoints) : 0;
  if (model.bus_joints.size() + of_base - behind + kept > at(kMaxJoints)) return {};
  return groups;
}

std::vector<std::array<int, 2>> pairs_within(const FingerGroup& group, const Model& model) {
  std::vector<std::array<int, 2>> pairs;
  for (const int a : group.links) {
    for (const int b : group.links) {
      const std::array<int, 2> pair{a, b};
      const auto& known = model.disabled_pairs;
      if (a < b && std::find(known.begin(), known.end(), pair) == known.end()) pairs.push_back(pair);
    }
  }
  return pairs;
}

std::string gripper_yaml(const FingerGroups& groups, const Model& model) {
  std::string out;
  for (std::size_t side = 0; side < 2; ++side) {
    const FingerGroup& group = groups[side];
    if (group.joints.empty()) continue;
    std::string joints, open, closed;
    for (std::size_t i = 0; i < group.joints.size(); ++i) {
      const char* comma = i == 0 ? "" : ", ";
      joints += comma + model.joints[at(group.joints[i])].name;
      open += comma + formatted("%.9g", group.open[i]);
      closed += comma + formatted("%.9g", group.closed[i]);
    }
    if (out.empty()) out = "\n# What ./twinbus grip opens and closes [rad or m].\ngrippers:\n";
    out += std::string(side == 0 ? "  left" : "  right") + ":\n    joints: [" + joints + "]\n    open: [" + open +
           "]\n    closed: [" + closed + "]\n";
  }
  return out;
}

std::optional<FingerServo> finger_servo(const FingerGroups& groups, const Model& model, int joint) {
  const bool kept = std::any_of(groups.begin(), groups.end(), [&](const FingerGroup& group) {
    return std::find(group.joints.begin(), group.joints.end(), joint) != group.joints.end();
  });
  if (!kept) return {};
  const Joint& finger = model.joints[at(joint)];
  FingerServo servo{.inertia = finger.rotor_inertia};
  for (int k = 0; k < model.joint_count(); ++k) {
    const Joint& moved = model.joints[at(k)];
    if (k != joint && moved.mimic != joint) continue;
    const double ratio = k == joint ? 1.0 : moved.mimic_multiplier;
    for (int i = k + 1; i < model.link_count(); ++i) {
      if (!hangs_on(model, i, k + 1)) continue;
      const Link& link = model.links[at(i)];
      const bool slides = moved.kind == JointKind::kPrismatic;
      servo.inertia += ratio * ratio * (slides ? link.mass : link.mass * link.com.squaredNorm() + link.inertia.trace() / 3.0);
    }
  }
  servo.kp = std::min(finger.effort / (kGrip * (finger.upper - finger.lower)), kFastestFinger * kFastestFinger * servo.inertia);
  return servo;
}

}  // namespace twinbus::robot
