#include "robot/onboarding/anatomy.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "robot/collision/collision_pairs.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/link_points.h"
#include "robot/onboarding/line_feet.h"

namespace twinbus::inline robot {

namespace {

constexpr double kSide = 0.01;   // nearer to the middle plane is in the middle [m]
constexpr double kSole = 0.008;  // what is so near to the lowest point belongs to the sole [m]
constexpr double kFlat = 0.015;  // links that reach so near to the lowest point may be the foot [m]
constexpr double kBeside = 0.25;  // of its width: an ankle nearer to the edge of its sole is not its middle
constexpr double kTurned = 1.5;  // no foot is wider than long by this
constexpr int kLimbJoints = 3;   // in a row, at least
constexpr int kFewestLegJoints = 5, kMostLegJoints = 7;
constexpr int kLegJoints = 6;    // the foot hangs on the sixth; what follows are toes, or an ankle's last joint
constexpr double kAnkle = 0.03;  // between the axes of an ankle [m]
constexpr int kFingers = 3, kFingerJoints = 2;  // of a hand, of each, at least
constexpr double kFinger = 0.35, kAlikeFingers = 2.0;  // the longest [m], against the shortest
const std::vector<const char*> kLegNames{"leg", "hip", "knee", "ankle", "foot", "thigh", "toe", "calf", "coxa", "femur", "tibia"};
const std::vector<const char*> kUpperBodyNames{"shoulder", "elbow", "upper_arm", "upperarm", "forearm", "neck", "head"};
// Of a foot without geometry, of the way from hip to ankle.
constexpr double kFootLength = 0.32, kFootWidth = 0.16, kAnkleHeight = 0.12;

bool mentions(const std::string& name, const std::vector<const char*>& words) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return lower.find(word) != std::string::npos; });
}

struct Branch {
  int root = -1;          // the first link that moves
  double lowest = 1e300;  // [m]
  double mass = 0.0;
};

class Finder {
 public:
  Finder(const Model& model, const std::array<SrdfFoot, 2>& feet, const Eigen::Matrix3d& turn)
      : model_(model), feet_(feet), kinematics_(model) {
    Configuration c(model);
    c.q = neutral_posture(model);
    c.base.linear() = turn;
    kinematics_.update(c);
    children_.resize(model.links.size());
    for (int i = 1; i < model.link_count(); ++i)
      children_[at(model.links[at(i)].parent)].push_back(i);
    for (int i = 0; i < model.link_count(); ++i) {
      std::vector<Eigen::Vector3d> points = link_points(model.links[at(i)]);
      for (Eigen::Vector3d& point : points) point = kinematics_.link_in_world(i) * point;
      points_.push_back(std::move(points));
    }
    sides_.assign(model.links.size(), 0);
    depth_.assign(model.links.size(), 1);
    for (int i = model.link_count() - 1; i >= 0; --i) sum_up(i);
  }

  Anatomy find() {
    measure();
    if (find_fingers()) {
      find_imu();
      return std::move(result_);
    }
    find_limbs();
    const int legs = lowest_pair();
    if (legs < 0) {
      result_.doubts.emplace_back(
          "no pair of limbs with three joints in a row, one left and one right: no legs, no feet");
    } else {
      for (std::size_t side = 0; side < 2; ++side) find_sole(side, pairs_[at(legs)][side]);
    }
    find_arms(legs);
    find_imu();
    return std::move(result_);
  }

 private:
  // Which side the ends of a subtree lie on: 1 left, 2 right, 4 in the middle, as bits.
  void sum_up(int link) {
    if (children_[at(link)].empty()) {
      const double y = middle(link).y();
      sides_[at(link)] = y > kSide ? 1 : y < -kSide ? 2 : 4;
    }
    for (const int child : children_[at(link)]) {
      sides_[at(link)] |= sides_[at(child)];
      depth_[at(link)] = std::max(depth_[at(link)], depth_[at(child)] + 1);
    }
  }

  Eigen::Vector3d middle(int link) const { return middle(points_[at(link)], link); }
  Eigen::Vector3d middle(const std::vector<Eigen::Vector3d>& points, int link) const {
    if (points.empty()) return kinematics_.link_in_world(link).translation();
    return box_around(points).center();
  }

  // Of a hand with its fingers, whose joints the proposal fixes, in its frame: as of a hand that is one piece in its file.
  Eigen::Vector3d middle_of_hand(int link) const {
    std::vector<Eigen::Vector3d> points;
    std::vector<int> left{link};
    while (!left.empty()) {
      const int next = left.back();
      left.pop_back();
      points.insert(points.end(), points_[at(next)].begin(), points_[at(next)].end());
      left.insert(left.end(), children_[at(next)].begin(), children_[at(next)].end());
    }
    return kinematics_.link_in_world(link).inverse() * middle(points, link);
  }

  double lowest(int link) const {
    double z = kinematics_.link_in_world(link).translation().z();
    for (const Eigen::Vector3d& point : points_[at(link)]) z = std::min(z, point.z());
    return z;
  }

  void measure() {
    double low = 1e300;
    double high = -1e300;
    for (int i = 0; i < model_.link_count(); ++i) low_ = std::min(low_, lowest(i));
    for (const auto& points : points_) {
      for (const Eigen::Vector3d& point : points) {
        low = std::min(low, point.z());
        high = std::max(high, point.z());
      }
    }
    result_.height = high > low ? high - low : 0.0;
    if (!(high > low))
      result_.doubts.emplace_back("no link has geometry: sizes are those of joints");
  }

  void collect(int link, Branch& limb) const {
    limb.lowest = std::min(limb.lowest, lowest(link));
    limb.mass += model_.links[at(link)].mass;
    for (const int child : children_[at(link)]) collect(child, limb);
  }

  void find_limbs() {
    std::array<std::vector<Branch>, 2> found;
    for (int i = 1; i < model_.link_count(); ++i) {
      const int side = sides_[at(i)];
      const int above = sides_[at(model_.links[at(i)].parent)];
      if ((side != 1 && side != 2) || above == side || depth_[at(i)] < kLimbJoints) continue;
      Branch limb{.root = i};
      collect(i, limb);
      found[side == 1 ? 0 : 1].push_back(limb);
    }
    // A pair is equally heavy and deep.
    for (const Branch& left : found[0]) {
      for (const Branch& right : found[1]) {
        const bool alike = std::abs(left.mass - right.mass) <= 0.1 * (left.mass + right.mass) &&
                           std::abs(left.lowest - right.lowest) < 0.05 &&
                           depth_[at(left.root)] == depth_[at(right.root)] &&
                           (kinematics_.link_in_world(left.root).translation() -
                            kinematics_.link_in_world(right.root).translation())
                                   .cwiseProduct(Eigen::Vector3d(1, 0, 1))
                                   .norm() < 0.05;
        if (alike) pairs_.push_back({left, right});
      }
    }
  }

  // A hand that no arm carries: three limbs or more of one palm, short, and about as long as each other.  Nothing is called a
  // leg, an arm or a head.
  bool find_fingers() {
    int palm = 0;
    for (int above = 1; children_[at(palm)].size() == 1; ++above) {
      if (above == kLimbJoints) return false;
      palm = children_[at(palm)].front();
    }
    std::vector<int> fingers;
    double shortest = 1e300, longest = 0.0;
    for (const int root : children_[at(palm)]) {
      if (depth_[at(root)] < kFingerJoints) continue;
      double length = 0.0;
      for (int link = root; link < model_.link_count(); ++link) {
        if (!hangs_on(model_, link, root)) continue;
        for (const std::string& name : {model_.links[at(link)].name, model_.joints[at(link - 1)].name}) {
          if (mentions(name, kLegNames) || mentions(name, kUpperBodyNames)) return false;
        }
        for (const Eigen::Vector3d& point : points_[at(link)])
          length = std::max(length, (point - kinematics_.link_in_world(root).translation()).norm());
      }
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
      fingers.push_back(root);
    }
    if (fingers.size() < at(kFingers) || longest > kFinger || longest > kAlikeFingers * shortest) return false;
    result_.doubts.push_back("a hand without an arm: " + std::to_string(fingers.size()) + " fingers on " +
                             (palm == 0 ? "its base" : model_.links[at(palm)].name) +
                             "; each is an arm that reaches by its name, finger_1 and so on in the order of the file");
    for (const int root : fingers) {
      Hand finger;
      finger.name = "finger_" + std::to_string(result_.more_hands.size() + 1);
      for (const int link : chain(root, true)) {
        finger.link = link;
        if (model_.joints[at(link - 1)].mimic < 0) finger.joints.push_back(link - 1);
      }
      finger.frame.translation() = middle_of_hand(finger.link);
      if (!finger.joints.empty() && result_.more_hands.size() + 2 < at(kMostHands)) result_.more_hands.push_back(finger);
    }
    return true;
  }

  // Hanging arms reach lowest when there are no legs.
  bool is_named_like_an_arm(int root) const {
    bool arm = false;
    for (int link = root; link < model_.link_count(); ++link) {
      int up = link;
      while (up > root) up = model_.links[at(up)].parent;
      if (up != root) continue;
      for (const std::string& name :
           {model_.links[at(link)].name, model_.joints[at(link - 1)].name}) {
        if (mentions(name, kLegNames)) return false;
        arm = arm || mentions(name, {"shoulder", "elbow", "wrist", "hand", "grip", "finger", "arm"});
      }
    }
    return arm;
  }

  int lowest_pair() const {
    int best = -1;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (is_named_like_an_arm(pairs_[i][0].root)) continue;
      if (best < 0 || pairs_[i][0].lowest < pairs_[at(best)][0].lowest) best = static_cast<int>(i);
    }
    // Legs reach the ground; a robot on a column has none.
    const bool stands =
        best >= 0 && pairs_[at(best)][0].lowest < low_ + 0.05 * result_.height + 1e-6;
    return stands || result_.height == 0.0 ? best : -1;
  }

  // From the limb's root to its end; at a branch the heavier part goes on unless it must end there.
  std::vector<int> chain(int root, bool ends_at_branch) const {
    std::vector<int> links{root};
    while (!children_[at(links.back())].empty()) {
      const std::vector<int>& next = children_[at(links.back())];
      if (next.size() > 1 && ends_at_branch && links.size() >= at(kLimbJoints)) break;
      int best = next.front();
      for (const int child : next) best = depth_[at(child)] > depth_[at(best)] ? child : best;
      links.push_back(best);
    }
    return links;
  }

  std::string sensor_on(int link) const {
    for (const Frame& frame : model_.frames) {
      if (frame.link == link &&  // "ft" begins a word: the end of "left" is none
          mentions("_" + frame.name, {"force", "_ft", "fsensor", "f_sensor", "sixaxis"}))
        return frame.name;
    }
    return "";
  }

  double apart(int a, int b) const {
    return (kinematics_.link_in_world(a).translation() - kinematics_.link_in_world(b).translation()).norm();
  }

  void find_sole(std::size_t side, const Branch& limb) {
    const char* name = side == 0 ? "left" : "right";
    const std::vector<int> links = chain(limb.root, false);
    int foot = links.back();
    for (const int link : links) {  // the first that reaches the ground; toes hang on it
      if (lowest(link) <= limb.lowest + kFlat) {
        foot = link;
        break;
      }
    }
    // The foot itself may have no geometry: then it is what hangs on the ankle.
    std::size_t sixth = std::min(links.size(), at(kLegJoints)) - 1;
    const bool more = links.size() > at(kLegJoints) && points_[at(links[sixth])].empty();
    if (more && apart(links[sixth], links[at(kLegJoints)]) < kAnkle) ++sixth;
    // What is above the ankle's last joint may reach as low as the sole.
    const bool above = std::find(links.begin(), links.end(), foot) - links.begin() < static_cast<std::ptrdiff_t>(sixth);
    if (points_[at(links[sixth])].empty() || (above && lowest(links[sixth]) <= limb.lowest + kFlat)) foot = links[sixth];
    Sole& sole = result_.soles[side];
    sole.link = foot;
    const Eigen::Isometry3d& pose = kinematics_.link_in_world(foot);
    result_.sole_sensor[side] = sensor_on(foot);
    for (const int link : links) {
      result_.leg_joints.push_back(link - 1);
      if (link == foot) break;
    }
    if (points_[at(foot)].empty()) {
      guess_sole(side, limb.root);
      return;
    }
    const double ground = lowest(foot);
    Eigen::Vector3d low(1e300, 1e300, 0.0);
    Eigen::Vector3d high = -low;
    for (const Eigen::Vector3d& point : points_[at(foot)]) {
      if (point.z() > ground + kSole) continue;
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    if (const auto line = line_on_ground(model_.links[at(foot)], pose, points_[at(foot)], ground)) {
      low.head<2>() = line->min();
      high.head<2>() = line->max();
    }
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.translation() << pose.translation().x(), pose.translation().y(), ground;
    if (!(low.x() < frame.translation().x() && frame.translation().x() < high.x() &&
          low.y() < frame.translation().y() && frame.translation().y() < high.y()) &&
        low.x() < high.x()) {  // the ankle is not above the sole
      frame.translation().head<2>() = 0.5 * (low + high).head<2>();
    }
    // An ankle's last axis may pass beside the foot that the others stand over: both sides of a sole carry.
    const double left = high.y() - frame.translation().y(), right = frame.translation().y() - low.y();
    if (std::min(left, right) < kBeside * (left + right)) frame.translation().y() = 0.5 * (low.y() + high.y());
    sole.frame = pose.inverse() * frame;
    sole.front = std::max(high.x() - frame.translation().x(), 0.005);
    sole.back = std::max(frame.translation().x() - low.x(), 0.005);
    sole.left = std::max(high.y() - frame.translation().y(), 0.005);
    sole.right = std::max(frame.translation().y() - low.y(), 0.005);
    if (is_line(sole)) {
      const bool along = sole.front + sole.back > sole.left + sole.right;
      result_.doubts.push_back(formatted("the %s sole on %s is a line %s the foot, %.0f mm long: %s", name,
                                         model_.links[at(foot)].name.c_str(), along ? "along" : "across",
                                         1e3 * std::max(sole.front + sole.back, sole.left + sole.right),
                                         along ? "what tips the robot over it, steps catch"
                                               : "nobody stands on two such lines, and legs that can turn them do not step on them yet"));
    } else if (sole.left + sole.right > kTurned * (sole.front + sole.back)) {
      result_.doubts.push_back("foot " + model_.links[at(foot)].name +
                               " is wider than long, so its mesh lies crosswise (the up axis of a "
                               "DAE is not used): the sole is taken with the long side forward");
      const Sole crosswise = sole;
      sole.front = std::max(crosswise.left, crosswise.right);
      sole.back = std::min(crosswise.left, crosswise.right);
      sole.left = sole.right = 0.5 * (crosswise.front + crosswise.back);
    }
    if (!is_line(sole) && (sole.front + sole.back < 0.04 || sole.left + sole.right < 0.02)) {
      result_.doubts.push_back(std::string("the ") + name + " sole on " +
                               model_.links[at(foot)].name +
                               " is hardly a surface: measure it, or the feet are points or not "
                               "flat in the zero posture");
    }
    result_.hip_height = kinematics_.link_in_world(limb.root).translation().z() - ground;
  }

  // Of a foot that cannot be seen: as the SRDF says, or in proportion to the leg as people have it.
  void guess_sole(std::size_t side, int root) {
    Sole& sole = result_.soles[side];
    const Eigen::Isometry3d& pose = kinematics_.link_in_world(sole.link);
    const double leg = (kinematics_.link_in_world(root).translation() - pose.translation()).norm();
    SrdfFoot foot = feet_[side];
    if (!foot.present) {
      foot = {false, kFootLength * leg, kFootWidth * leg, -0.1 * kFootLength * leg,
              0.0,   kAnkleHeight * leg};
    }
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.translation() = pose.translation() - Eigen::Vector3d(0.0, 0.0, foot.ankle_height);
    sole.frame = pose.inverse() * frame;
    sole.front = 0.5 * foot.length - foot.ankle_forward;
    sole.back = 0.5 * foot.length + foot.ankle_forward;
    sole.left = 0.5 * foot.width - foot.ankle_left;
    sole.right = 0.5 * foot.width + foot.ankle_left;
    result_.hip_height =
        kinematics_.link_in_world(root).translation().z() - frame.translation().z();
    result_.doubts.push_back(formatted("foot %s has no geometry: its sole is %s, %.0f x %.0f mm, %.0f mm below the ankle; "
                                       "measure at, front, back, left, right under soles in robot.yaml",
                                       model_.links[at(sole.link)].name.c_str(),
                                       foot.present ? "as the SRDF's <specificities> say" : "guessed from the leg",
                                       1e3 * foot.length, 1e3 * foot.width, 1e3 * foot.ankle_height));
  }

  void find_arms(int legs) {
    int best = -1;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (static_cast<int>(i) == legs) continue;
      if (legs >= 0 && pairs_[i][0].lowest < pairs_[at(legs)][0].lowest + 0.1 * result_.height) {
        result_.doubts.emplace_back(
            "four limbs reach the ground: this does not look like a humanoid");
        continue;
      }
      if (best < 0 || pairs_[i][0].mass > pairs_[at(best)][0].mass) best = static_cast<int>(i);
    }
    if (best < 0) {
      if (legs < 0) find_single_arm();
      result_.doubts.emplace_back(result_.hands[1].joints.empty() ? "no pair of arms: no hands" : "no pair of arms: its one arm is called right");
      return;
    }
    for (std::size_t side = 0; side < 2; ++side) {
      const std::vector<int> links = without_gripper(chain(pairs_[at(best)][side].root, true));
      Hand& hand = result_.hands[side];
      for (const int link : links) {
        if (model_.joints[at(link - 1)].mimic < 0) hand.joints.push_back(link - 1);
      }
      if (hand.joints.empty()) {
        result_.doubts.push_back(std::string("all joints of the ") + (side == 0 ? "left" : "right") +
                                 " arm follow others (<mimic>): no hand there");
        continue;
      }
      hand.link = links.back();
      hand.frame.translation() = middle_of_hand(hand.link);
      result_.hand_sensor[side] = sensor_on(hand.link);
    }
  }

  // A gripper in line with the arm is no joint of the arm.
  std::vector<int> without_gripper(std::vector<int> links) const {
    while (links.size() > at(kLimbJoints) && model_.joints[at(links.back() - 1)].mimic >= 0)
      links.pop_back();
    if (links.size() <= at(kLimbJoints + 1)) return links;
    const std::string& last = model_.joints[at(links.back() - 1)].name;
    if (mentions(last, {"hand", "grip", "finger", "thumb", "jaw"}) && !mentions(last, {"wrist"})) links.pop_back();
    return links;
  }

  // A manipulator: its one arm is called right.
  void find_single_arm() {
    const std::vector<int> links = without_gripper(chain(0, true));
    Hand hand;
    for (const int link : links) {
      if (link > 0 && model_.joints[at(link - 1)].mimic < 0) hand.joints.push_back(link - 1);
    }
    if (hand.joints.size() < at(kLimbJoints)) return;
    hand.link = links.back();
    hand.frame.translation() = middle_of_hand(hand.link);
    result_.hands[1] = hand;
    result_.hand_sensor[1] = sensor_on(hand.link);
  }

  void find_imu() {
    const Frame* best = nullptr;
    for (const Frame& frame : model_.frames) {
      const bool in_trunk = (sides_[at(frame.link)] & 3) == 3;
      if (!in_trunk || !mentions(frame.name, {"imu", "gyro", "accel", "inertial", "gsensor"}))
        continue;
      const bool nearer = best == nullptr || frame.link < best->link ||
                          (frame.link == best->link && mentions(frame.name, {"imu"}) &&
                           !mentions(best->name, {"imu"}));
      if (nearer) best = &frame;
    }
    if (best != nullptr) {
      result_.imu_frame = best->name;
      return;
    }
    result_.imu_frame = model_.links.front().name;
    result_.doubts.push_back("no link of the trunk is called IMU: the base link " +
                             result_.imu_frame + " is taken; add a link where the sensor is");
  }

  const Model& model_;
  const std::array<SrdfFoot, 2>& feet_;
  Kinematics kinematics_;
  std::vector<std::vector<int>> children_;
  std::vector<std::vector<Eigen::Vector3d>> points_;  // world
  std::vector<int> sides_, depth_;
  std::vector<std::array<Branch, 2>> pairs_;
  double low_ = 1e300;  // of the whole robot [m]
  Anatomy result_;
};

}  // namespace

Anatomy find_anatomy(const Model& model, const std::array<SrdfFoot, 2>& feet,
                     const Eigen::Matrix3d& turn) {
  return Finder(model, feet, turn).find();
}

std::vector<std::string> joints_above_legs(const Model& model) {
  const Anatomy found = find_anatomy(model);
  std::array<std::vector<int>, 2> chains;  // links below the base, from the base on
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<int>& chain = chains[side];
    for (int link = found.soles[side].link; link > 0; link = model.links[at(link)].parent) chain.insert(chain.begin(), link);
  }
  std::size_t shared = 0;
  while (shared < chains[0].size() && shared < chains[1].size() && chains[0][shared] == chains[1][shared]) ++shared;
  std::vector<std::string> names;
  for (const std::vector<int>& chain : chains) {
    if (chain.size() < shared + at(kFewestLegJoints) || chain.size() > shared + at(kMostLegJoints)) return names;
  }
  for (std::size_t i = 0; i < shared; ++i) names.push_back(model.joints[at(chains[0][i] - 1)].name);
  return names;
}

}  // namespace twinbus::robot
