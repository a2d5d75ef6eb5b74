#include "robot/onboarding/proposal.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/index.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "robot/kinematics/kinematics.h"
#include "robot/onboarding/carriers.h"
#include "robot/onboarding/finger_groups.h"
#include "robot/onboarding/line_feet.h"
#include "robot/onboarding/point_legged.h"
#include "robot/onboarding/known_srdf.h"
#include "robot/onboarding/passive_toes.h"
#include "robot/onboarding/rest_pairs.h"
#include "common/math/pose_math.h"

namespace twinbus::inline robot {

namespace {

namespace fs = std::filesystem;

// Of hrp1s, which stands well with them; others get theirs by weight.
constexpr double kWeight = 130.8;         // [kg]
constexpr double kLegStiffness = 15.6;    // [1/rad], times weight times height of the hips
// Of a leg joint [s], times its stiffness.  Without a rotor a foot is so light that noise of the velocity, times more than
// the smaller one, shakes it.
constexpr double kLegDamping = 0.02, kLightDamping = 0.007;
// Of a leg on a point.
constexpr double kPointLegStiffness = 3.0;
constexpr double kLegsApart = 0.02;  // in half_sitting, at least [m]
constexpr double kSoleStiffness = 1.0e6;  // [N/m]
constexpr double kSoleDamping = 2.0e3;    // [N s/m]
constexpr double kSoleFriction = 0.8;
constexpr double kLeastStiffness = 1.0;   // [N m/rad]
// Turning stiffness of one sole, in pitch and in roll, against the weight times the height of the hips.
constexpr double kTipping = 6.0, kTippingAside = 4.0;
constexpr double kArmStiffness = 150.0;  // [1/rad], times the moment of what hangs on the joint
constexpr double kStuck = 0.005;         // what friction may leave such a joint off [rad]
constexpr double kSag = 0.0005, kStuckSliding = 0.0005;  // of a joint that slides: by its load if it is upright, by friction [m]
constexpr double kGears = 0.01;          // of its effort a joint rubs where the file does not say more
constexpr double kFastest = 500.0;       // of a light joint that is stiff for that [rad/s]

// Two digits are all a guess deserves; plain decimals, which YAML reads as numbers.
std::string rough(double value) {
  if (!(value > 0.0)) return "0";
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return formatted("%.10g", std::round(value / unit) * unit);
}

std::string fixed(double value) {
  return formatted("%.4f", std::abs(value) < 5e-5 ? 0.0 : value);
}

std::string exact(double value) {
  return formatted("%.17g", value);
}

std::string list(const std::vector<std::string>& names) {
  std::string out = "[";
  for (std::size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "" : ", ") + names[i];
  return out + "]";
}

std::string list(const Eigen::Vector3d& v) {
  return std::string("[") + fixed(v.x()) + ", " + fixed(v.y()) + ", " + fixed(v.z()) + "]";
}

// points: whether it has legs that end in points.
bool base_floats(const ProposalSource& source, const Anatomy& anatomy, bool points) {
  return source.floating.value_or(points || anatomy.soles[0].link >= 0);
}

class Writer {
 public:
  Writer(const Model& model, const Anatomy& anatomy, const KnownSrdf& known, const ProposalSource& source,
         const std::optional<PointLegs>& points)
      : model_(model), anatomy_(anatomy), known_(known), source_(source), points_(points) {
    model_.soles = anatomy.soles;
    for (const auto& [a, b] : known.disabled) {
      const int link_a = link_of(a);
      const int link_b = link_of(b);
      if (link_a != link_b)
        model_.disabled_pairs.push_back({std::min(link_a, link_b), std::max(link_a, link_b)});
    }
    for (int j = 0; j < model_.joint_count(); ++j) {
      for (const Hand& hand : anatomy.hands) {
        if (hand.link > 0 && j + 1 != hand.link && above(hand.link, j + 1)) fingers_.push_back(j);
      }
    }
    toes_ = passive_toes(model_);
    keep_grippers();
    take_trained();
    posture_ = neutral_posture(model_);
    choose_posture();
    pairs_ = pairs_at_rest(model_, {neutral_posture(model_), posture_});
  }

  std::string yaml(const std::string& srdf_name) {
    const ProposalSource& source = source_;
    std::string out =
        "# Proposed by `twinbus check`: a beginning.  Measure soles and gains before a real robot "
        "moves.\n";
    out += "urdf: " + source.urdf_name + "\nsrdf: " + srdf_name + "\nbase: " + (source.planar ? "planar" : floating() ? "floating" : "fixed") + "\n";
    if (source.planar) out += planar_yaml(model_, anatomy_);
    if (!source.packages.empty()) {
      out += "packages:\n";
      for (const auto& [name, folder] : source.packages)
        out += "  " + name + ": \"" + folder + "\"\n";
    }
    std::vector<std::string> fixed = source.repairs.fixed_joints;
    for (const int j : fingers_) fixed.push_back(model_.joints[at(j)].name);
    if (!fixed.empty()) {
      out += "# Fingers, what has no mass, what is between base and legs; take those out that a controller moves.\n";
      out += "fixed_joints: " + list(fixed) + "\n";
    }
    std::vector<std::string> filled;
    for (const std::string& name : source.repairs.inertia_from_shape) {
      const int link = model_.find_link(name);
      if (link > 0 || (link == 0 && floating())) filled.push_back(name);
    }
    if (!filled.empty()) {
      out += "# The URDF gives these no inertia: that of a box around the geometry is taken.\n";
      out += "inertia_from_shape: " + list(filled) + "\n";
    }
    out += "period: 0.002  # [s]\noff: damp\n\nimu: " + (source.imu.empty() ? anatomy_.imu_frame : source.imu) + "\n";
    soles(out);
    hands(out);
    out += gripper_yaml(groups_, model_);
    if (!anatomy_.leg_joints.empty())
      out += "\nleg_joints: " + list(names_of(anatomy_.leg_joints)) + "\n";
    near_pairs(out);
    out += passive_yaml(model_, toes_);
    out += source.mujoco;
    std::string servos;
    for (const int j : model_.bus_joints) {
      if (!is_finger(j) && !is_toe(j)) servo(j, servos);
    }
    if (servos.empty()) return out;
    const bool of_file = source.servos_apply && !source.servos.empty();
    return out + (of_file ? "\n# Of the actuators of the file, the others from weight and lever arms"
                          : "\n# From weight and lever arms") +
           " [N m/rad, N m s/rad].\nservos:\n" + servos;
  }

  std::string srdf() {
    std::string out =
        "<?xml version=\"1.0\"?>\n<!-- Proposed by `twinbus check`. -->\n<robot name=\"" +
        xml_escaped(model_.name) + "\">\n";
    write_pose("zero", neutral_posture(model_), out);
    write_pose("half_sitting", posture_, out);
    for (const NamedPose& pose : known_.poses) {
      if (pose.name == "zero" || pose.name == "half_sitting") continue;
      write_pose(pose.name, to_vector(pose), out);
    }
    if (!known_.rotors.empty()) out += "  <rotor_params>\n";
    for (const SrdfRotor& rotor : known_.rotors) {
      if (is_finger(model_.find_joint(rotor.joint))) continue;  // fixed to its hand
      out += "    <joint name=\"" + xml_escaped(rotor.joint) + "\" mass=\"" +
             exact(rotor.reflected_inertia) + "\" gear_ratio=\"1\"/>\n";
    }
    if (!known_.rotors.empty()) out += "  </rotor_params>\n";
    for (const auto& [a, b] : known_.disabled) {
      out += "  <disable_collisions link1=\"" + xml_escaped(a) + "\" link2=\"" + xml_escaped(b) +
             "\" reason=\"said by " + xml_escaped(source_.srdf_origin) + "\"/>\n";
    }
    for (const RestPair& pair : hand_pairs_) out += exempted(model_, pair);
    disabled_ = pairs_.size();
    for (const RestPair& pair : pairs_) out += exempted(model_, pair);
    return out + "</robot>\n";
  }

  // What people must know of the choices.
  void tell(std::vector<std::string>& doubts) const {
    doubts.insert(doubts.end(), doubts_.begin(), doubts_.end());
    if (!toes_.empty()) doubts.push_back("no motor drives " + list(names_of(toes_)) + kPassiveToes);
    if (disabled_ > 0) {
      doubts.push_back(std::to_string(disabled_) +
                       " pairs of links touch in the proposed postures, or nearly, and are exempt from the "
                       "collision check: look at them in the SRDF");
    }
  }

 private:
  bool has_soles() const { return model_.soles[0].link >= 0; }
  bool floating() const { return base_floats(source_, anatomy_, points_.has_value()); }

  int link_of(const std::string& frame_name) const {
    for (const Frame& frame : model_.frames) {
      if (frame.name == frame_name) return frame.link;
    }
    return -1;
  }

  std::vector<std::string> names_of(const std::vector<int>& joints) const {
    std::vector<std::string> names;
    for (const int j : joints) names.push_back(model_.joints[at(j)].name);
    return names;
  }

  static Eigen::VectorXd to_vector(const NamedPose& pose) {
    return Eigen::Map<const Eigen::VectorXd>(pose.q.data(), static_cast<Eigen::Index>(pose.q.size()));
  }

  bool has_rotor(int joint) const {
    const std::string& name = model_.joints[at(joint)].name;
    return model_.joints[at(joint)].rotor_inertia > 0.0 ||
           std::any_of(known_.rotors.begin(), known_.rotors.end(), [&](const SrdfRotor& rotor) { return rotor.joint == name; });
  }

  // The fingers of an arm move as one group; what is of one hand may touch.
  void keep_grippers() {
    if (floating() && !has_soles() && !points_) return;
    groups_ = finger_groups(model_, anatomy_, source_.planar);
    for (const FingerGroup& group : groups_) {
      const auto& links = group.links;
      std::erase_if(fingers_, [&](int j) { return std::find(links.begin(), links.end(), j + 1) != links.end(); });
      for (const std::array<int, 2>& pair : pairs_within(group, model_)) {
        model_.disabled_pairs.push_back(pair);
        hand_pairs_.push_back({pair[0], pair[1], "of one hand"});
      }
    }
    if (!hand_pairs_.empty())
      doubts_.emplace_back("fingers are kept as grippers: look in robot.yaml whether open and closed are what they are called");
  }

  // What no file of the robot says of its gears and the specification of a policy does.
  void take_trained() {
    int rotors = 0, rubbing = 0;
    for (const TrainedJoint& trained : source_.trained) {
      const int j = model_.find_joint(trained.joint);
      if (std::find(model_.bus_joints.begin(), model_.bus_joints.end(), j) == model_.bus_joints.end() || is_finger(j)) continue;
      Joint& joint = model_.joints[at(j)];
      const bool turns = !has_rotor(j) && trained.rotor_inertia > 0.0;
      const bool rubs = !(joint.friction > 0.0) && trained.friction > 0.0;
      if (turns) joint.rotor_inertia = trained.rotor_inertia;
      if (rubs) joint.friction = trained.friction;
      std::string& more = trained_[j];
      if (turns) more += ", rotor_inertia: " + exact(trained.rotor_inertia);
      if (rubs) more += ", friction: " + exact(trained.friction);
      rotors += turns ? 1 : 0;
      rubbing += rubs ? 1 : 0;
    }
    if (rotors + rubbing > 0) {
      doubts_.push_back(formatted("of the training: the rotors of %d joints and the friction of %d, which the files of the robot do not say",
                                  rotors, rubbing));
    }
  }

  // half_sitting of the SRDF that was there, if the robot stands in it; else one that is computed.
  void choose_posture() {
    if (points_) {
      for (const NamedPose& pose : known_.poses) {
        if (pose.name == "zero" || !bends_in_many_ways(*points_) || !stands_on_point_legs(model_, *points_, to_vector(pose))) continue;
        posture_ = to_vector(pose);
        doubts_.push_back("half_sitting is the pose " + pose.name + " of " + source_.srdf_origin + ": legs of more than three joints bend in many ways");
        return;
      }
      if (!find_point_legged_posture(model_, *points_, posture_))
        doubts_.emplace_back("no posture with its feet below a level trunk was found: half_sitting is the zero posture; look at the limits of the leg joints");
      return;
    }
    for (const NamedPose& pose : known_.poses) {
      if (pose.name != "half_sitting") continue;
      if (!has_soles()) posture_ = to_vector(pose);
      if (!has_soles()) return;
      std::string why = why_it_falls(model_, to_vector(pose));
      if (const double apart = leg_to_leg(model_, anatomy_.soles, to_vector(pose)); why.empty() && apart < kLegsApart) {
        why = formatted("its legs are %.0f mm apart, and %.0f mm let them pass each other", 1e3 * apart, 1e3 * kLegsApart);
      }
      if (why.empty()) {
        posture_ = to_vector(pose);
        return;
      }
      doubts_.push_back("half_sitting of " + source_.srdf_origin + " is not used: " + why);
    }
    if (!has_soles()) {
      if (const std::string turned = lift_arms(model_, anatomy_, posture_); !turned.empty())
        doubts_.push_back("at zero the arm lies in the ground, is too heavy for its joints, or is boxed in by the robot: half_sitting has " + turned);
      return;
    }
    if (find_standing_posture(model_, posture_)) {
      const double turned = hold_arms_out(model_, anatomy_, posture_);
      if (!(turned > 0.0)) return;
      doubts_.push_back(formatted("in half_sitting the arms are turned %.2f rad outwards: they hang within 80 mm of the legs", turned));
      if (find_standing_posture(model_, posture_)) return;
    }
    const std::string why = why_it_falls(model_, posture_);
    doubts_.push_back(
        "no posture with bent knees and flat soles was found: half_sitting is the zero posture" +
        (why.empty() ? std::string() : ", in which " + why) +
        "; look at the limits of the leg joints, or write half_sitting into the SRDF by hand");
  }

  void write_pose(const std::string& name, const Eigen::VectorXd& q, std::string& out) const {
    out += "  <group_state name=\"" + xml_escaped(name) + "\" group=\"all\">\n";
    for (const int j : model_.bus_joints) {
      const Joint& joint = model_.joints[at(j)];
      if (is_finger(j) || is_toe(j)) continue;
      // Rounding must not leave the limits.
      const double value = std::clamp(std::round(q[j] * 1e6) / 1e6, joint.lower, joint.upper);
      out += "    <joint name=\"" + xml_escaped(joint.name) + "\" value=\"" +
             exact(value == 0.0 ? 0.0 : value) + "\"/>\n";
    }
    out += "  </group_state>\n";
  }

  void near_pairs(std::string& out) const {
    std::vector<NearByDesign> pairs = pairs_near_by_design(model_, {neutral_posture(model_), posture_}, pairs_);
    std::erase_if(pairs, [&](const NearByDesign& pair) {  // fingers are fixed to their hands
      return is_finger(pair.link_a - 1) || is_finger(pair.link_b - 1);
    });
    if (pairs.empty()) return;
    out += "\n# Near each other by design: what guards keep of them [m], where they keep " +
           fixed(GuardDefaults::kInController) + " of others.\nnear_pairs:\n";
    for (const NearByDesign& pair : pairs) {
      out += "  - {links: [" + model_.links[at(pair.link_a)].name + ", " + model_.links[at(pair.link_b)].name +
             "], margin: " + fixed(pair.margin) + "}  # " + pair.why + "\n";
    }
  }

  void soles(std::string& out) const {
    if (model_.soles[0].link < 0) return;
    const double share = model_.total_mass() / kWeight;
    out +=
        "\n# frame: z up, x forward, on the ground when the foot is flat; at, rpy: where it is in "
        "the link [m, rad].\nsoles:\n";
    for (std::size_t side = 0; side < 2; ++side) {
      const Sole& sole = model_.soles[side];
      const std::string& sensor = anatomy_.sole_sensor[side];
      // Short and narrow soles must be stiffer, or the robot tips over on their springs; over a line it tips all the same.
      const double tips = model_.total_mass() * kGravity * std::max(anatomy_.hip_height, 0.1);
      const double longer = std::max(sole.front + sole.back, sole.left + sole.right);
      const auto against = [&](double edges) {
        return is_line(sole) && edges < longer ? 0.0 : tips / std::max(0.25 * edges * edges, 1e-4);
      };
      const double stiffness = std::max({kSoleStiffness * share, kTipping * against(sole.front + sole.back),
                                         kTippingAside * against(sole.left + sole.right)});
      out += std::string(side == 0 ? "  left:" : "  right:") +
             "\n    {frame: " + model_.links[at(sole.link)].name +
             ", at: " + list(sole.frame.translation()) +
             ", rpy: " + list(rpy_from_rotation(sole.frame.linear())) +
             (sensor.empty() ? "" : ", sensor: " + sensor) + ",\n     front: " + fixed(sole.front) +
             ", back: " + fixed(sole.back) + ", left: " + fixed(sole.left) +
             ", right: " + fixed(sole.right) + ",\n     stiffness: " + rough(stiffness) +
             ", damping: " + rough(kSoleDamping / kSoleStiffness * stiffness) +
             ", friction: " + rough(friction_of(sole.link)) + "}\n";
    }
  }

  double friction_of(int link) const {
    double friction = -1.0;
    for (const auto& [frame, value] : source_.friction) {
      if (link_of(frame) == link) friction = std::max(friction, value);
    }
    return friction >= 0.0 ? friction : kSoleFriction;
  }

  void hands(std::string& out) const {
    const auto write = [&](const std::string& name, const Hand& hand, const std::string& sensor) {
      out += "  " + name + ":\n    frame: " + model_.links[at(hand.link)].name + "\n    at: " + list(hand.frame.translation()) + "\n";
      if (!sensor.empty()) out += "    sensor: " + sensor + "\n";
      out += "    joints: " + list(names_of(hand.joints)) + "\n";
      if (!floating()) out += carried_by_yaml(model_, anatomy_, hand);
    };
    if (anatomy_.hands[0].link >= 0 || anatomy_.hands[1].link >= 0 || !anatomy_.more_hands.empty()) out += "\nhands:\n";
    for (std::size_t side = 0; side < 2; ++side) {
      if (anatomy_.hands[side].link >= 0) write(side == 0 ? "left" : "right", anatomy_.hands[side], anatomy_.hand_sensor[side]);
    }
    for (const Hand& finger : anatomy_.more_hands) write(finger.name, finger, "");
  }

  bool above(int link, int below) const {
    while (below > link) below = model_.links[at(below)].parent;
    return below == link;
  }

  bool is_finger(int j) const { return std::find(fingers_.begin(), fingers_.end(), j) != fingers_.end(); }
  bool is_toe(int j) const { return std::find(toes_.begin(), toes_.end(), j) != toes_.end(); }

  // Legs and what carries the arms hold the weight of the robot, others what hangs on them.
  void servo(int j, std::string& out) const {
    const Joint& joint = model_.joints[at(j)];
    Configuration c(model_);
    c.q = posture_;
    Kinematics k(model_);
    k.update(c);
    const bool slides = joint.kind == JointKind::kPrismatic;
    double moment = 0.0;  // of what hangs on the joint, at worst [N m]; of one that slides its weight [N]
    double inertia = joint.rotor_inertia;
    int hands = 0;
    for (const Hand& hand : anatomy_.hands) hands += hand.link > 0 && above(j + 1, hand.link) ? 1 : 0;
    for (int i = j + 1; i < model_.link_count(); ++i) {
      if (!above(j + 1, i)) continue;
      const double arm = slides ? 1.0 : (k.com_of_link(i) - k.link_in_world(j + 1).translation()).norm();
      moment += model_.links[at(i)].mass * kGravity * arm;
      inertia += model_.links[at(i)].mass * arm * arm + (slides ? 0.0 : model_.links[at(i)].inertia.trace() / 3.0);
    }
    const bool leg = std::find(anatomy_.leg_joints.begin(), anatomy_.leg_joints.end(), j) != anatomy_.leg_joints.end();
    const double stuck = slides ? kStuckSliding : kStuck;
    const double against_gears = std::min(kGears * joint.effort / stuck, kFastest * kFastest * inertia);
    const double against_load = slides ? moment / kSag : kArmStiffness * moment;
    double kp = std::max({against_load, joint.friction / stuck, against_gears, kLeastStiffness});
    double kd = 1.4 * std::sqrt(kp * inertia);
    if (leg && points_) {
      kp = kPointLegStiffness * model_.total_mass() * kGravity * point_legged_height(model_, *points_, posture_);
      kd = std::min(1.4 * std::sqrt(kp * inertia), kLegDamping * kp);
    } else if (leg || (hands == 2 && has_soles())) {
      kp = kLegStiffness * model_.total_mass() * kGravity * std::max(anatomy_.hip_height, 0.1);
      kd = (joint.rotor_inertia > 0.0 ? kLegDamping : kLightDamping) * kp;
    }
    if (const std::optional<FingerServo> finger = finger_servo(groups_, model_, j)) {
      kp = std::max(finger->kp, joint.friction / kStuck);
      kd = 1.4 * std::sqrt(kp * finger->inertia);
    }
    std::string remark;
    const auto trained = trained_.find(j);
    const std::string more = trained == trained_.end() ? "" : trained->second;
    for (const KnownServo& known : source_.servos) {
      if (known.joint != joint.name) continue;
      const double known_kd = known.kd > 0.0 ? known.kd : 1.4 * std::sqrt(known.kp * inertia);
      if (source_.servos_apply) {
        kp = known.kp;
        kd = known_kd;
      } else {
        remark = "  # of the file: kp " + rough(known.kp) + ", kd " + rough(known.kd);
      }
    }
    out += "  - {joints: [" + joint.name + "], kp: " + rough(kp) + ", kd: " + rough(kd) + more + "}" + remark + "\n";
  }

  Model model_;
  const Anatomy& anatomy_;
  const KnownSrdf& known_;
  const ProposalSource& source_;
  std::optional<PointLegs> points_;
  std::vector<std::string> doubts_;
  Eigen::VectorXd posture_;
  std::vector<int> toes_;     // joints of feet that no motor drives
  std::vector<int> fingers_;  // joints behind the hands that are to be fixed
  FingerGroups groups_;  // and those that are not
  std::vector<RestPair> hand_pairs_;   // of hands with such
  std::vector<RestPair> pairs_;  // left out
  std::map<int, std::string> trained_;  // of joints: further keys of their servos
  std::size_t disabled_ = 0;
};

}  // namespace

bool floats(const Model& model, const ProposalSource& source) {
  Anatomy anatomy = find_anatomy(model);
  const bool points = find_point_legs(model, anatomy).has_value();
  return base_floats(source, anatomy, points);
}

Proposal propose(const Model& model, const ProposalSource& source) {
  const KnownSrdf known = fit_srdf(model, source.srdf_text, source.srdf_file, source.srdf_origin);
  Anatomy anatomy = find_anatomy(model, known.feet);
  const std::optional<PointLegs> points = find_point_legs(model, anatomy);
  Writer writer(model, anatomy, known, source, points);
  Proposal proposal;
  proposal.doubts = source.notes;
  proposal.doubts.insert(proposal.doubts.end(), anatomy.doubts.begin(), anatomy.doubts.end());
  proposal.doubts.insert(proposal.doubts.end(), known.doubts.begin(), known.doubts.end());
  const std::string stem = fs::path(source.urdf_name).stem().string();
  proposal.yaml = writer.yaml(stem + ".srdf");
  proposal.srdf = writer.srdf();
  writer.tell(proposal.doubts);
  return proposal;
}

void exempt_at_rest(const Model& loaded, Proposal& proposal) {
  std::vector<Eigen::VectorXd> postures;
  for (const char* name : {"zero", "half_sitting"}) {
    const int pose = loaded.find_pose(name);
    if (pose < 0) continue;
    const std::vector<double>& q = loaded.poses[at(pose)].q;
    postures.emplace_back(Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size())));
  }
  const std::vector<RestPair> pairs = pairs_at_rest(loaded, postures);
  if (pairs.empty()) return;
  std::string more;
  for (const RestPair& pair : pairs) more += exempted(loaded, pair);
  proposal.srdf.insert(proposal.srdf.rfind("</robot>"), more);
  proposal.doubts.push_back(std::to_string(pairs.size()) +
                            " more pairs touch once fingers are part of the hands, and are exempt too");
}

}  // namespace twinbus::robot
