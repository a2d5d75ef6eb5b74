#include "robot/proposal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include "robot/collision.h"
#include "robot/dynamics.h"
#include "robot/index.h"
#include "robot/kinematics.h"
#include "robot/pose_math.h"
#include "robot/xml.h"

namespace twinbus {

namespace {

namespace fs = std::filesystem;

// Of hrp1s, which stands well with them; others get theirs by weight.
constexpr double kWeight = 130.8;         // [kg]
constexpr double kLegStiffness = 15.6;    // [1/rad], times weight times height of the hips
constexpr double kSoleStiffness = 1.0e6;  // [N/m]
constexpr double kSoleDamping = 2.0e3;    // [N s/m]
constexpr double kArmStiffness = 150.0;   // [1/rad], times the moment of what hangs on the joint

// Two digits are all a guess deserves; plain decimals, which YAML reads as numbers.
std::string rough(double value) {
  if (!(value > 0.0)) return "0";
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  char text[32];
  std::snprintf(text, sizeof(text), "%.10g", std::round(value / unit) * unit);
  return text;
}

std::string fixed(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4f", std::abs(value) < 5e-5 ? 0.0 : value);
  return text;
}

std::string list(const Eigen::Vector3d& v) {
  return std::string("[") + fixed(v.x()) + ", " + fixed(v.y()) + ", " + fixed(v.z()) + "]";
}

class Writer {
 public:
  Writer(const Model& model, const Anatomy& anatomy) : model_(model), anatomy_(anatomy) {
    model_.soles = anatomy.soles;
    posture_ = neutral_posture(model_);
    stands_ = find_standing_posture(model_, posture_);
    for (int j = 0; j < model_.joint_count(); ++j) {
      for (const Hand& hand : anatomy.hands) {
        if (hand.link > 0 && j + 1 != hand.link && above(hand.link, j + 1)) fingers_.push_back(j);
      }
    }
  }

  std::string yaml(const std::string& urdf_name, const std::string& srdf_name,
                   const std::vector<std::pair<std::string, std::string>>& packages) {
    std::string out =
        "# Proposed by `twinbus check`: a beginning.  Measure soles and gains before a real robot "
        "moves.\n";
    out += "urdf: " + urdf_name + "\nsrdf: " + srdf_name +
           "\nbase: " + (model_.soles[0].link >= 0 ? "floating" : "fixed") + "\n";
    if (!packages.empty()) {
      out += "packages:\n";
      for (const auto& [name, folder] : packages) out += "  " + name + ": \"" + folder + "\"\n";
    }
    if (!fingers_.empty()) {
      out += "# Fingers; take those out that a controller moves.\nfixed_joints: [";
      for (std::size_t i = 0; i < fingers_.size(); ++i) {
        out += (i == 0 ? "" : ", ") + model_.joints[at(fingers_[i])].name;
      }
      out += "]\n";
    }
    out += "period: 0.002  # [s]\noff: damp\n\nimu: " + anatomy_.imu_frame + "\n";
    soles(out);
    hands(out);
    if (!anatomy_.leg_joints.empty()) {
      out += "\nleg_joints: [";
      for (std::size_t i = 0; i < anatomy_.leg_joints.size(); ++i) {
        out += (i == 0 ? "" : ", ") + model_.joints[at(anatomy_.leg_joints[i])].name;
      }
      out += "]\n";
    }
    out += "\n# From weight and lever arms [N m/rad, N m s/rad].\nservos:\n";
    for (const int j : model_.bus_joints) {
      if (!is_finger(j)) servo(j, out);
    }
    return out;
  }

  std::string srdf() {
    std::string out =
        "<?xml version=\"1.0\"?>\n<!-- Proposed by `twinbus check`. -->\n<robot name=\"" +
        model_.name + "\">\n";
    const Eigen::VectorXd zero = neutral_posture(model_);
    for (const auto& [name, q] : {std::pair<const char*, const Eigen::VectorXd&>("zero", zero),
                                  {"half_sitting", posture_}}) {
      out += "  <group_state name=\"" + std::string(name) + "\" group=\"all\">\n";
      for (const int j : model_.bus_joints) {
        const Joint& joint = model_.joints[at(j)];
        if (is_finger(j)) continue;
        // Rounding must not leave the limits.
        const double value = std::clamp(std::round(q[j] * 1e6) / 1e6, joint.lower, joint.upper);
        char text[64];
        std::snprintf(text, sizeof(text), "%.17g", value == 0.0 ? 0.0 : value);
        out += "    <joint name=\"" + joint.name + "\" value=\"" + text + "\"/>\n";
      }
      out += "  </group_state>\n";
    }
    for (const CollisionPair& pair : touching()) {
      out += "  <disable_collisions link1=\"" + model_.links[at(pair.link_a)].name + "\" link2=\"" +
             model_.links[at(pair.link_b)].name + "\" reason=\"touch in a proposed posture\"/>\n";
    }
    return out + "</robot>\n";
  }

  bool stands() const { return stands_; }
  std::size_t disabled() const { return disabled_; }

 private:
  void soles(std::string& out) const {
    if (model_.soles[0].link < 0) return;
    const double share = model_.total_mass() / kWeight;
    out +=
        "\n# frame: z up, x forward, on the ground when the foot is flat; at, rpy: where it is in "
        "the link [m, rad].\nsoles:\n";
    for (std::size_t side = 0; side < 2; ++side) {
      const Sole& sole = model_.soles[side];
      const std::string& sensor = anatomy_.sole_sensor[side];
      out += std::string(side == 0 ? "  left:" : "  right:") +
             "\n    {frame: " + model_.links[at(sole.link)].name +
             ", at: " + list(sole.frame.translation()) +
             ", rpy: " + list(rpy_from_rotation(sole.frame.linear())) +
             (sensor.empty() ? "" : ", sensor: " + sensor) + ",\n     front: " + fixed(sole.front) +
             ", back: " + fixed(sole.back) + ", left: " + fixed(sole.left) +
             ", right: " + fixed(sole.right) +
             ",\n     stiffness: " + rough(kSoleStiffness * share) +
             ", damping: " + rough(kSoleDamping * share) + ", friction: 0.8}\n";
    }
  }

  void hands(std::string& out) const {
    if (anatomy_.hands[0].link < 0 && anatomy_.hands[1].link < 0) return;
    out += "\nhands:\n";
    for (std::size_t side = 0; side < 2; ++side) {
      const Hand& hand = anatomy_.hands[side];
      if (hand.link < 0) continue;
      out += std::string(side == 0 ? "  left:" : "  right:") +
             "\n    frame: " + model_.links[at(hand.link)].name +
             "\n    at: " + list(hand.frame.translation()) + "\n";
      if (!anatomy_.hand_sensor[side].empty())
        out += "    sensor: " + anatomy_.hand_sensor[side] + "\n";
      out += "    joints: [";
      for (std::size_t i = 0; i < hand.joints.size(); ++i) {
        out += (i == 0 ? "" : ", ") + model_.joints[at(hand.joints[i])].name;
      }
      out += "]\n";
    }
  }

  bool above(int link, int below) const {
    while (below > link) below = model_.links[at(below)].parent;
    return below == link;
  }

  bool is_finger(int j) const {
    return std::find(fingers_.begin(), fingers_.end(), j) != fingers_.end();
  }

  // Legs and what carries the arms hold the weight of the robot, others what hangs on them.
  void servo(int j, std::string& out) const {
    const Joint& joint = model_.joints[at(j)];
    Configuration c(model_);
    c.q = posture_;
    Kinematics k(model_);
    k.update(c);
    double moment = 0.0;  // of what hangs on the joint, at worst [N m]
    double inertia = joint.rotor_inertia;
    bool carries_hand = false;
    for (const Hand& hand : anatomy_.hands)
      carries_hand = carries_hand || (hand.link > 0 && above(j + 1, hand.link));
    int hands = 0;
    for (const Hand& hand : anatomy_.hands)
      hands += hand.link > 0 && above(j + 1, hand.link) ? 1 : 0;
    for (int i = j + 1; i < model_.link_count(); ++i) {
      if (!above(j + 1, i)) continue;
      const double arm = (k.com_of_link(i) - k.link_in_world(j + 1).translation()).norm();
      moment += model_.links[at(i)].mass * kGravity * arm;
      inertia += model_.links[at(i)].mass * arm * arm + model_.links[at(i)].inertia.trace() / 3.0;
    }
    const bool leg = std::find(anatomy_.leg_joints.begin(), anatomy_.leg_joints.end(), j) !=
                     anatomy_.leg_joints.end();
    double kp = kArmStiffness * moment;
    double kd = 1.4 * std::sqrt(kp * inertia);
    if (leg || hands == 2) {
      kp = kLegStiffness * model_.total_mass() * kGravity * std::max(anatomy_.hip_height, 0.1);
      kd = 0.02 * kp;
    }
    out += "  - {joints: [" + joint.name + "], kp: " + rough(kp) + ", kd: " + rough(kd) + "}\n";
  }

  // Pairs of links that touch in one of the postures.
  std::vector<CollisionPair> touching() {
    Collision collision(model_);
    Kinematics k(model_);
    Configuration c(model_);
    std::set<std::pair<int, int>> found;
    for (const Eigen::VectorXd& q : {neutral_posture(model_), posture_}) {
      c.q = q;
      k.update(c);
      std::vector<PairDistance> near(4096);
      const int count = collision.near_pairs(k, 1e-3, near.data(), static_cast<int>(near.size()));
      for (int i = 0; i < count; ++i) found.insert({near[at(i)].link_a, near[at(i)].link_b});
    }
    std::vector<CollisionPair> pairs;
    for (const auto& [a, b] : found) pairs.push_back({a, b});
    disabled_ = pairs.size();
    return pairs;
  }

  Model model_;
  const Anatomy& anatomy_;
  Eigen::VectorXd posture_;
  std::vector<int> fingers_;  // joints behind the hands
  bool stands_ = false;
  std::size_t disabled_ = 0;
};

}  // namespace

Proposal propose(const Model& model, const std::string& urdf_name,
                 const std::vector<std::pair<std::string, std::string>>& packages) {
  const Anatomy anatomy = find_anatomy(model);
  Writer writer(model, anatomy);
  Proposal proposal;
  proposal.doubts = anatomy.doubts;
  const std::string stem = fs::path(urdf_name).stem().string();
  proposal.yaml = writer.yaml(urdf_name, stem + ".srdf", packages);
  proposal.srdf = writer.srdf();
  if (!writer.stands()) {
    proposal.doubts.emplace_back(
        "no posture was found in which it stands: half_sitting is the zero posture");
  }
  if (writer.disabled() > 0) {
    proposal.doubts.push_back(std::to_string(writer.disabled()) +
                              " pairs of links touch in the proposed postures and are exempt from "
                              "the collision check: look at them");
  }
  return proposal;
}

std::vector<std::pair<std::string, std::string>> find_packages(const std::string& urdf_file) {
  const std::string text = read_text_file(urdf_file);
  const std::string scheme = "package://";
  std::set<std::string> names;
  for (std::size_t i = text.find(scheme); i != std::string::npos; i = text.find(scheme, i + 1)) {
    const std::size_t start = std::min(text.find_first_not_of('/', i + scheme.size()), text.size());
    const std::size_t end = text.find_first_of("/\"'<> \n", start);
    if (end != std::string::npos && end > start && end - start < 200)
      names.insert(text.substr(start, end - start));
    if (names.size() > 100) break;
  }
  std::vector<std::pair<std::string, std::string>> packages;
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(urdf_file), error).parent_path();
  for (const std::string& name : names) {
    if (name == ".." || name == ".") continue;
    for (fs::path up = folder; up.has_relative_path(); up = up.parent_path()) {
      if (up.filename() == name || fs::is_directory(up / name, error)) {
        packages.emplace_back(name, (up.filename() == name ? up : up / name).string());
        break;
      }
    }
  }
  return packages;
}

}  // namespace twinbus
