#include "robot/mjcf/mjcf_to_urdf.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/mjcf/geom_inertia.h"
#include "robot/mjcf/mjcf_selection.h"
#include "robot/mjcf/urdf_shapes.h"
#include "robot/mjcf/urdf_text.h"

namespace twinbus::inline robot {

namespace {

constexpr std::size_t kMostRobotNotes = 60;
constexpr std::size_t kMostSites = 300;  // that become frames
constexpr double kPassage = 1e-6;        // mass of a link between two joints of a body, against the body's
constexpr double kLeastPassage = 1e-3;   // of the body's [kg]
constexpr double kGyration = 2e-3;       // of such a link, at least [m]; of less no link is believed

// NameMaker that URDF, SRDF and YAML all take, each once.
class NameMaker {
 public:
  std::string make(std::string wanted) {
    for (char& c : wanted) {
      if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-' && c != '.') c = '_';
    }
    if (wanted.empty() || (std::isalpha(static_cast<unsigned char>(wanted[0])) == 0 && wanted[0] != '_'))
      wanted.insert(0, "_");
    wanted.resize(std::min<std::size_t>(wanted.size(), 100));
    std::string name = wanted;
    for (int i = 2; !taken_.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    return name;
  }

 private:
  std::set<std::string> taken_;
};

Eigen::Isometry3d moved(const Eigen::Vector3d& by) {
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() = by;
  return place;
}

class Converter {
 public:
  Converter(const MjcfModel& model, const std::string& file) : model_(model), file_(file) {
    robot_.notes = model.notes;
    selection_ = select_robot(model, file, robot_.notes);
    robot_.floating = selection_.floating;
    robot_.mujoco = model.option;
    links_.resize(model.bodies.size());
    anchors_.assign(model.bodies.size(), Eigen::Vector3d::Zero());
    for (const MjcfActuator& actuator : model.actuators) drives_[actuator.joint].push_back(&actuator);
  }

  MjcfRobot convert() {
    weigh();
    for (const int i : selection_.bodies) {
      for (const MjcfJoint& joint : model_.bodies[at(i)].joints) {
        if (joint.kind == MjcfJointKind::kFree) continue;
        joints_.emplace_back(&joint, joint_names_.make(joint.name.empty() ? body_name(i) + "_joint" : joint.name));
      }
    }
    std::string name = model_.name.empty() ? std::filesystem::path(file_).stem().string() : model_.name;
    robot_.urdf = "<?xml version=\"1.0\"?>\n<!-- Made of an MJCF model by `twinbus check`. -->\n<robot name=\"" +
                  NameMaker().make(name) + "\">\n";
    if (!robot_.floating) {
      links_[0] = link_names_.make("world");
      robot_.urdf += "  <link name=\"" + links_[0] + "\"/>\n";
    }
    for (const int body : selection_.bodies) write_body(body);
    write_sites();
    robot_.urdf += "</robot>\n";
    write_srdf();
    if (robot_.notes.size() > kMostRobotNotes) {
      const std::size_t more = robot_.notes.size() - kMostRobotNotes;
      robot_.notes.resize(kMostRobotNotes);
      robot_.notes.push_back("and " + std::to_string(more) + " more notes of this kind");
    }
    tell();
    return std::move(robot_);
  }

 private:
  // Masses of all bodies; what moves must have one.
  void weigh() {
    inertia_.resize(model_.bodies.size());
    double total = 0.0;
    for (const int i : selection_.bodies) {
      inertia_[at(i)] = body_inertia(model_.bodies[at(i)], model_);
      total += inertia_[at(i)].mass;
    }
    if (model_.compiler.total_mass > 0.0 && total > 0.0) {
      const double scale = model_.compiler.total_mass / total;
      for (const int i : selection_.bodies) {
        inertia_[at(i)].mass *= scale;
        inertia_[at(i)].about_com *= scale;
      }
    }
    std::vector<double> behind(model_.bodies.size(), 0.0);
    for (auto i = selection_.bodies.rbegin(); i != selection_.bodies.rend(); ++i) {
      const MjcfBody& body = model_.bodies[at(*i)];
      behind[at(*i)] += inertia_[at(*i)].mass;
      if (!body.joints.empty() && !(behind[at(*i)] > 0.0))
        body.element.fail("moves but has no mass: neither <inertial> nor geoms with mass, and nothing on it has; add "
                          "<inertial pos= mass= diaginertia=/>");
      behind[at(body.parent)] += behind[at(*i)];
    }
  }

  std::string body_name(int index) const {
    const std::string& name = model_.bodies[at(index)].name;
    return name.empty() ? "body_" + std::to_string(index) : name;
  }

  const std::string& urdf_name(const MjcfJoint& joint) const {
    return std::find_if(joints_.begin(), joints_.end(), [&](const auto& each) { return each.first == &joint; })->second;
  }

  void write_body(int index) {
    const MjcfBody& body = model_.bodies[at(index)];
    const bool base = robot_.floating && body.parent == 0;
    std::string parent = links_[at(body.parent)];
    const std::string given = body_name(index);
    links_[at(index)] = link_names_.make(given);
    Eigen::Isometry3d place = moved(-anchors_[at(body.parent)]) * body.place;
    Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; !base && k < body.joints.size(); ++k) {
      const MjcfJoint& joint = body.joints[k];
      const bool last = k + 1 == body.joints.size();
      const std::string name = urdf_name(joint);
      const std::string child = last ? links_[at(index)] : link_names_.make(name + "_link");
      if (!last) write_passage(child, inertia_[at(index)]);
      write_joint(joint, name, parent, child, place * moved(joint.anchor - anchor));
      place = Eigen::Isometry3d::Identity();
      anchor = joint.anchor;
      parent = child;
    }
    if (!base && body.joints.empty()) {
      robot_.urdf += "  <joint name=\"" + joint_names_.make(given + "_fixed") + "\" type=\"fixed\">\n    " +
                     urdf_origin(place) + "\n    <parent link=\"" + parent + "\"/>\n    <child link=\"" +
                     links_[at(index)] + "\"/>\n  </joint>\n";
    }
    anchors_[at(index)] = anchor;
    write_link(index);
  }

  // Between two joints of a body: simulators want mass in every link that moves, so little that it does not matter.
  void write_passage(const std::string& link, const MjcfInertia& of_body) {
    const double mass = kPassage * std::max(of_body.mass, kLeastPassage);
    const double inertia = kPassage * std::max(of_body.about_com.trace() / 3.0, kLeastPassage * kLeastPassage);
    MjcfInertia little;
    little.mass = mass;
    little.about_com.diagonal().setConstant(std::max(inertia, mass * kGyration * kGyration));
    robot_.urdf += "  <link name=\"" + link + "\">\n";
    write_inertial(little);
    robot_.urdf += "  </link>\n";
  }

  void write_inertial(const MjcfInertia& inertia) {
    const Eigen::Matrix3d& m = inertia.about_com;
    robot_.urdf += "    <inertial>\n      " + urdf_origin(moved(inertia.com)) + "\n      <mass value=\"" +
                   exact_number(inertia.mass) + "\"/>\n      <inertia ixx=\"" + exact_number(m(0, 0)) + "\" ixy=\"" +
                   exact_number(m(0, 1)) + "\" ixz=\"" + exact_number(m(0, 2)) + "\" iyy=\"" + exact_number(m(1, 1)) +
                   "\" iyz=\"" + exact_number(m(1, 2)) + "\" izz=\"" + exact_number(m(2, 2)) + "\"/>\n    </inertial>\n";
  }

  void write_link(int index) {
    const MjcfBody& body = model_.bodies[at(index)];
    MjcfInertia inertia = inertia_[at(index)];
    std::string& urdf = robot_.urdf;
    urdf += "  <link name=\"" + links_[at(index)] + "\">\n";
    const Eigen::Isometry3d in_link = moved(-anchors_[at(index)]);
    inertia.com = in_link * inertia.com;
    if (inertia.mass > 0.0) write_inertial(inertia);
    double friction = -1.0;
    const MujocoContact* contact = nullptr;  // of the geom with the most friction
    for (const MjcfGeom& geom : body.geoms) {
      append_urdf_shapes(geom, model_, in_link, urdf, robot_.notes);
      if (!geom.touches) continue;
      friction = std::max(friction, geom.friction);
      if (contact == nullptr || geom.surface.contact.friction[0] > contact->friction[0]) contact = &geom.surface.contact;
    }
    urdf += "  </link>\n";
    if (contact == nullptr) return;
    robot_.friction.emplace_back(links_[at(index)], friction);
    std::vector<MujocoContact>& all = robot_.mujoco.contacts;
    auto alike = std::find_if(all.begin(), all.end(), [&](const MujocoContact& each) { return each.same_but_links(*contact); });
    if (alike == all.end()) alike = all.insert(alike, *contact);
    alike->links.push_back(links_[at(index)]);
  }

  // What the actuators can do at a joint, cut by the joint's own limit.
  double effort_of(const MjcfJoint& joint) {
    const auto found = drives_.find(joint.name);
    if (found == drives_.end() || joint.name.empty()) {
      if (model_.actuators.empty()) return std::isfinite(joint.effort) ? joint.effort : no_limit();
      ++passive_;
      return 0.0;
    }
    double effort = 0.0;
    for (const MjcfActuator* actuator : found->second) effort += actuator->effort;
    effort = std::min(effort, joint.effort);
    return std::isfinite(effort) ? effort : no_limit();
  }

  double no_limit() {
    ++unlimited_;
    return kMjcfEffort;
  }

  void write_joint(const MjcfJoint& joint, const std::string& name, const std::string& parent, const std::string& child,
                   const Eigen::Isometry3d& origin) {
    const bool hinge = joint.kind == MjcfJointKind::kHinge;
    double lower = joint.lower - joint.ref, upper = joint.upper - joint.ref;
    if (!joint.limited) {
      lower = -kMjcfTravel;
      upper = kMjcfTravel;
    }
    const char* type = !hinge ? "prismatic" : joint.limited ? "revolute" : "continuous";
    std::string& urdf = robot_.urdf;
    urdf += "  <joint name=\"" + name + "\" type=\"" + type + "\">\n    " + urdf_origin(origin) + "\n    <parent link=\"" +
            parent + "\"/>\n    <child link=\"" + child + "\"/>\n    <axis xyz=\"" + exact_numbers(joint.axis) +
            "\"/>\n    <limit ";
    if (joint.limited || !hinge) urdf += "lower=\"" + exact_number(lower) + "\" upper=\"" + exact_number(upper) + "\" ";
    urdf += "effort=\"" + exact_number(effort_of(joint)) + "\" velocity=\"" +
            exact_number(hinge ? kMjcfVelocity : kMjcfSlideVelocity) + "\"/>\n";
    if (joint.damping > 0.0 || joint.frictionloss > 0.0) {
      urdf += "    <dynamics damping=\"" + exact_number(joint.damping) + "\" friction=\"" +
              exact_number(joint.frictionloss) + "\"/>\n";
    }
    for (const MjcfMimic& mimic : model_.mimics) {
      if (mimic.joint != joint.name || joint.name.empty()) continue;
      const auto followed = std::find_if(joints_.begin(), joints_.end(),
                                         [&](const auto& each) { return each.first->name == mimic.follows; });
      if (followed == joints_.end()) joint.element.fail("follows joint " + mimic.follows + ", which is not of the robot");
      urdf += "    <mimic joint=\"" + followed->second + "\" multiplier=\"" + exact_number(mimic.multiplier) +
              "\" offset=\"" + exact_number(mimic.offset) + "\"/>\n";
      mimics_.insert(&joint);
      break;
    }
    urdf += "  </joint>\n";
    if (joint.armature > 0.0) {
      rotors_ += "    <joint name=\"" + name + "\" mass=\"" + exact_number(joint.armature) + "\" gear_ratio=\"1\"/>\n";
    }
    const auto found = drives_.find(joint.name);
    if (found == drives_.end() || joint.name.empty()) return;
    MjcfServo servo{.joint = name};
    for (const MjcfActuator* actuator : found->second) {
      servo.kp += actuator->kp;
      servo.kd += actuator->kd;
    }
    if (servo.kp > 0.0) robot_.servos.push_back(servo);
  }

  void write_sites() {
    std::size_t count = 0;
    for (const int i : selection_.bodies) count += model_.bodies[at(i)].sites.size();
    for (const int i : selection_.bodies) {
      for (const MjcfSite& site : model_.bodies[at(i)].sites) {
        const bool imu = !model_.imu_site.empty() && site.name == model_.imu_site;
        if (site.name.empty() || (count > kMostSites && !imu)) continue;
        const std::string link = link_names_.make(site.name);
        if (imu) robot_.imu = link;
        robot_.urdf += "  <link name=\"" + link + "\"/>\n  <joint name=\"" + joint_names_.make(site.name + "_site") +
                       "\" type=\"fixed\">\n    " + urdf_origin(moved(-anchors_[at(i)]) * site.place) +
                       "\n    <parent link=\"" + links_[at(i)] + "\"/>\n    <child link=\"" + link + "\"/>\n  </joint>\n";
      }
    }
  }

  void write_srdf() {
    robot_.srdf = "<?xml version=\"1.0\"?>\n<robot name=\"mjcf\">\n";
    for (const MjcfKey& key : model_.keys) write_pose(key, key.name);
    if (const MjcfKey* start = start_key()) write_pose(*start, "half_sitting");
    if (!rotors_.empty()) robot_.srdf += "  <rotor_params>\n" + rotors_ + "  </rotor_params>\n";
    for (const auto& [a, b] : model_.excludes) {
      const std::string& first = links_[at(model_.find_body(a))];
      const std::string& second = links_[at(model_.find_body(b))];
      if (first.empty() || second.empty()) continue;
      robot_.srdf += "  <disable_collisions link1=\"" + first + "\" link2=\"" + second + "\" reason=\"excluded\"/>\n";
    }
    robot_.srdf += "</robot>\n";
  }

  // The keyframe to start in: one that is named so, else the first.
  const MjcfKey* start_key() const {
    for (const char* word : {"home", "stand", "init", "start"}) {
      for (const MjcfKey& key : model_.keys) {
        if (key.name.rfind(word, 0) == 0) return &key;
      }
    }
    return model_.keys.empty() ? nullptr : &model_.keys.front();
  }

  void write_pose(const MjcfKey& key, const std::string& name) {
    std::string joints;
    for (const auto& [joint, urdf_name] : joints_) {
      if (mimics_.count(joint) != 0) continue;
      joints += "    <joint name=\"" + urdf_name + "\" value=\"" + exact_number(key.qpos[at(joint->qpos)] - joint->ref) +
                "\"/>\n";
    }
    robot_.srdf += "  <group_state name=\"" + xml_escaped(name) + "\" group=\"all\">\n" + joints + "  </group_state>\n";
  }

  void tell() {
    std::vector<std::string>& notes = robot_.notes;
    notes.push_back(formatted("MJCF limits no speeds: %g rad/s and %g m/s are written; correct them, the gate cuts by them",
                              kMjcfVelocity, kMjcfSlideVelocity));
    if (unlimited_ > 0) {
      notes.push_back(formatted("%d joints have no limit of effort in the MJCF: %g N m or N is written", unlimited_,
                                kMjcfEffort));
    }
    if (passive_ > 0)
      notes.push_back(std::to_string(passive_) + " joints have no actuator: their effort is 0, nothing holds them");
    if (const MjcfKey* start = start_key()) notes.push_back("keyframe " + start->name + " is taken for half_sitting, in which scenes begin");
  }

  const MjcfModel& model_;
  const std::string& file_;
  MjcfSelection selection_;
  MjcfRobot robot_;
  NameMaker link_names_, joint_names_;
  std::vector<std::string> links_;          // of each body; empty: not of the robot
  std::vector<Eigen::Vector3d> anchors_;    // where the link's frame is in the body
  std::vector<MjcfInertia> inertia_;        // of each body
  std::map<std::string, std::vector<const MjcfActuator*>> drives_;
  std::vector<std::pair<const MjcfJoint*, std::string>> joints_;  // of the robot, in the order of the file, with URDF names
  std::set<const MjcfJoint*> mimics_;
  std::string rotors_;
  int passive_ = 0, unlimited_ = 0;
};

}  // namespace

MjcfRobot robot_of_mjcf(const MjcfModel& model, const std::string& file) { return Converter(model, file).convert(); }

MjcfRobot import_mjcf(const std::string& file) { return robot_of_mjcf(read_mjcf_model(file), file); }

}  // namespace twinbus::robot
