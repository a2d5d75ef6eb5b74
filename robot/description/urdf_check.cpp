// What urdfdom lets pass: every number, name and reference of a URDF file is checked here, with its
// line.

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <stdexcept>

#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "robot/names/known_names.h"
#include "robot/description/urdf.h"

namespace twinbus::inline robot {

namespace {

constexpr std::size_t kMaxLinks = 2000;
constexpr std::size_t kMostFaults = 12;  // told at once
constexpr double kFarthest = 1e3;  // of an origin from its parent [m], and of an angle [rad]
constexpr double kLargest = 1e20;  // of an effort, speed, damping, inertia and so on, in SI units

class Checker {
 public:
  explicit Checker(const std::string& file) : file_(file) {}

  void check(const XmlElement& robot, std::vector<std::string>& notes) {
    refuse_xacro(robot);
    if (robot.name != "robot")
      fail_at(file_, robot.line,
              "the root element is <" + robot.name + ">, not <robot>; this is not a URDF");
    const std::string* version = robot.attribute("version");
    if (version != nullptr && *version != "1.0" && *version != "1") {
      fail_at(file_, robot.line,
              "URDF version " + *version + " is not known; write version=\"1.0\"");
    }
    check_names(robot, known_urdf(), file_, notes);
    std::vector<const XmlElement*> joints;
    for (const XmlElement& element : robot.children) {
      if (element.name == "link") {
        keep_fault([&] {
          if (!links_.emplace(name_of(element), element.line).second)
            fail_at(file_, element.line, "link " + name_of(element) + " is there twice; rename one");
          check_link(element);
        });
      } else if (element.name == "joint") {
        keep_fault([&] {
          if (!joints_.emplace(name_of(element), &element).second)
            fail_at(file_, element.line, "joint " + name_of(element) + " is there twice; rename one");
          joints.push_back(&element);
        });
      }
    }
    if (links_.empty()) throw_faults();
    if (links_.empty())
      fail_at(file_, robot.line, "the robot has no link; add <link name=\"base\"/>");
    if (links_.size() > kMaxLinks || joints.size() > kMaxLinks) {
      fail_at(file_, robot.line,
              std::to_string(links_.size()) + " links and " + std::to_string(joints.size()) +
                  " joints; at most " + std::to_string(kMaxLinks) +
                  " are read: simplify the robot");
    }
    for (const XmlElement* joint : joints) keep_fault([&] { check_joint(*joint); });
    throw_faults();
    check_tree(joints);
  }

 private:
  // What is wrong with one link or joint says nothing of the others.
  template <class Check>
  void keep_fault(const Check& check) {
    try {
      check();
    } catch (const std::runtime_error& fault) {
      if (++faults_ > kMostFaults) return;
      told_ += (faults_ == 1 ? "" : "\n  ") + std::string(fault.what());
    }
  }

  void throw_faults() const {
    if (faults_ == 0) return;
    throw std::runtime_error(told_ + (faults_ > kMostFaults ? "\n  and " + std::to_string(faults_ - kMostFaults) + " more" : std::string()));
  }

  // A macro file looks like a URDF and says nothing; its expansion is one.
  void refuse_xacro(const XmlElement& element) const {
    bool macro = element.name.rfind("xacro:", 0) == 0;
    for (const auto& [key, value] : element.attributes) {
      macro =
          macro || value.find("${") != std::string::npos || value.find("$(") != std::string::npos;
    }
    if (macro) {
      fail_at(file_, element.line,
              "<" + element.name + "> is a xacro macro, not URDF; expand the file first: xacro " +
                  file_ + " > robot.urdf (pip install xacro)");
    }
    for (const XmlElement& child : element.children) refuse_xacro(child);
  }

  std::string name_of(const XmlElement& element) const {
    const std::string* name = element.attribute("name");
    if (name == nullptr || name->empty())
      fail_at(file_, element.line, "<" + element.name + "> without a name; add name=\"...\"");
    return *name;
  }

  [[noreturn]] void fail(const XmlElement& element, const std::string& owner,
                         const std::string& what) const {
    fail_at(file_, element.line, owner + ": " + what);
  }

  // Adds what is wrong with a numeric attribute to faults.  Returns whether it is there and good.
  bool read(const XmlElement& element, const char* key, double* values, int count,
            std::string& faults) const {
    const std::string* text = element.attribute(key);
    if (text == nullptr) return false;
    if (parse_numbers(*text, values, count)) return true;
    add(faults, element.name + " " + key + "=\"" + text->substr(0, 60) + "\" is not " +
                    (count == 1 ? "a finite number" : std::to_string(count) + " finite numbers") +
                    (text->find(',') != std::string::npos ? "; write a decimal point, no comma"
                                                          : "; write numbers like 0.5 or -1e-3"));
    return false;
  }

  // Numbers that no robot has overflow in what is computed from them, so that different robots look the same.
  bool read_bounded(const XmlElement& element, const char* key, double* values, int count,
                    double most, const char* unit, std::string& faults) const {
    if (!read(element, key, values, count, faults)) return false;
    for (int i = 0; i < count; ++i) {
      if (std::abs(values[i]) <= most) continue;
      add(faults, formatted("%s %s has %.3g; at most %.0e %s are read", element.name.c_str(), key, values[i], most, unit));
      return false;
    }
    return true;
  }

  static void add(std::string& faults, const std::string& fault) {
    if (!faults.empty()) faults += "; ";
    faults += fault;
  }

  void check_origin(const XmlElement& element, const std::string& owner) const {
    const XmlElement* origin = element.child("origin");
    if (origin == nullptr) return;
    std::string faults;
    double v[3];
    read_bounded(*origin, "xyz", v, 3, kFarthest, "m", faults);
    read_bounded(*origin, "rpy", v, 3, kFarthest, "rad", faults);
    if (!faults.empty()) fail(*origin, owner, faults);
  }

  void check_link(const XmlElement& link) const {
    const std::string owner = "link " + name_of(link);
    if (const XmlElement* inertial = link.child("inertial")) check_inertial(*inertial, owner);
    for (const XmlElement& part : link.children) {
      if (part.name != "collision" && part.name != "visual") continue;
      check_origin(part, owner + ", " + part.name);
      const XmlElement* geometry = part.child("geometry");
      if (geometry == nullptr || geometry->children.size() != 1) {
        fail(part, owner, part.name + " needs one <geometry> with one shape");
      }
      check_shape(geometry->children.front(), owner + ", " + part.name);
    }
  }

  void check_inertial(const XmlElement& inertial, const std::string& owner) const {
    check_origin(inertial, owner + ", inertial");
    std::string faults;
    double mass = 0.0;
    const XmlElement* mass_element = inertial.child("mass");
    const XmlElement* inertia = inertial.child("inertia");
    if (mass_element == nullptr || mass_element->attribute("value") == nullptr) {
      add(faults, "mass is missing in <inertial>; add <mass value=\"...\"/>");
    } else if (read(*mass_element, "value", &mass, 1, faults) && !(mass >= 0.0 && mass <= 1e6)) {
      add(faults,
          "mass " + *mass_element->attribute("value") + " must be positive and at most 1e6 kg");
    }
    double m[6] = {};
    if (inertia == nullptr) {
      add(faults, "inertia is missing in <inertial>; add <inertia ixx=... izz=...>");
    } else {
      const char* keys[6] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
      bool complete = true;
      for (int i = 0; i < 6; ++i) {
        if (inertia->attribute(keys[i]) == nullptr) {
          add(faults, std::string("inertia has no ") + keys[i]);
          complete = false;
        } else {
          complete =
              read_bounded(*inertia, keys[i], &m[i], 1, kLargest, "kg m^2", faults) && complete;
        }
      }
      if (complete) check_inertia(m, faults);
    }
    if (!faults.empty()) fail(mass_element != nullptr ? *mass_element : inertial, owner, faults);
  }

  // No body has a negative principal moment, and nothing can be computed with one.  One that exceeds
  // the sum of the others is no body's either; `twinbus check` says so, many robots have it.
  static void check_inertia(const double* m, std::string& faults) {
    Eigen::Matrix3d inertia;
    inertia << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    const Eigen::Vector3d moments =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
    // Rounding of a point mass is no body's fault.
    constexpr double kDust = 1e-12;  // [kg m^2]
    if (!(moments[0] >= -1e-6 * std::abs(moments[2]) - kDust)) {
      add(faults,
          "inertia is not that of a body: a principal moment is negative; take it from CAD, about "
          "the centre of mass");
    }
  }

  void check_shape(const XmlElement& shape, const std::string& owner) const {
    std::string faults;
    double v[3] = {1, 1, 1};
    const auto need = [&](const char* key, int count) {
      if (shape.attribute(key) == nullptr) {
        add(faults, shape.name + " has no " + key);
      } else if (read(shape, key, v, count, faults)) {
        if (shape.name == "sphere" && v[0] == 0.0) return;  // a contact point
        for (int i = 0; i < count; ++i) {
          if (!(v[i] > 0.0 && v[i] <= 1e4)) {
            add(faults, shape.name + " " + key + " must be positive and at most 1e4");
            return;
          }
        }
      }
    };
    if (shape.name == "box") {
      need("size", 3);
    } else if (shape.name == "sphere") {
      need("radius", 1);
    } else if (shape.name == "cylinder") {
      need("radius", 1);
      need("length", 1);
    } else if (shape.name == "mesh") {
      if (shape.attribute("filename") == nullptr) add(faults, "mesh has no filename");
      read_bounded(shape, "scale", v, 3, kLargest, "", faults);
      if (v[0] == 0.0 || v[1] == 0.0 || v[2] == 0.0) add(faults, "mesh scale must not be 0");
    } else {
      add(faults, "shape <" + shape.name + "> is not known; use box, cylinder, sphere or mesh");
    }
    if (!faults.empty()) fail(shape, owner, faults);
  }

  std::string link_reference(const XmlElement& joint, const char* role,
                             const std::string& owner) const {
    const XmlElement* element = joint.child(role);
    const std::string* name = element == nullptr ? nullptr : element->attribute("link");
    if (name == nullptr)
      fail(joint, owner, std::string("<") + role + " link=...> is missing; name the link");
    if (links_.count(*name) == 0) {
      std::vector<std::string> known;
      for (const auto& entry : links_) known.push_back(entry.first);
      fail(*element, owner,
           std::string(role) + " link " + *name + " does not exist" + suggestion(*name, known));
    }
    return *name;
  }

  void check_joint(const XmlElement& joint) const {
    const std::string owner = "joint " + name_of(joint);
    static const std::vector<std::string> kTypes = {"fixed", "revolute", "continuous", "prismatic"};
    const std::string* type = joint.attribute("type");
    if (type == nullptr) fail(joint, owner, "type is missing; use revolute, prismatic or fixed");
    if (*type == "floating" || *type == "planar") {
      fail(
          joint, owner,
          "type " + *type +
              " is not supported; remove the joint and its parent: robot.yaml says base: floating");
    }
    bool known = false;
    for (const std::string& t : kTypes) known = known || t == *type;
    if (!known)
      fail(joint, owner, "type " + *type + " is not supported" + suggestion(*type, kTypes));

    const std::string parent = link_reference(joint, "parent", owner);
    const std::string child = link_reference(joint, "child", owner);
    if (parent == child)
      fail(joint, owner, "link " + parent + " is its own parent; name another one");
    check_origin(joint, owner);
    if (*type == "fixed") return;

    std::string faults;
    if (const XmlElement* axis = joint.child("axis")) {
      double v[3];
      if (axis->attribute("xyz") == nullptr) {
        add(faults, "axis has no xyz");
      } else if (read(*axis, "xyz", v, 3, faults)) {
        const double length = std::hypot(v[0], v[1], v[2]);
        if (!(std::abs(length - 1.0) <= 1e-3)) {
          add(faults,
              "axis " + *axis->attribute("xyz") + " must have length 1; write for example 0 0 1");
        }
      }
    }
    check_limit(joint, *type, faults);
    if (const XmlElement* dynamics = joint.child("dynamics")) {
      for (const char* key : {"damping", "friction"}) {
        double value = 0.0;
        if (read_bounded(*dynamics, key, &value, 1, kLargest, "", faults) && !(value >= 0.0)) {
          add(faults, std::string("dynamics ") + key + " must not be negative");
        }
      }
    }
    if (const XmlElement* mimic = joint.child("mimic")) check_mimic(joint, *mimic, faults);
    if (!faults.empty()) fail(joint, owner, faults);
  }

  void check_limit(const XmlElement& joint, const std::string& type, std::string& faults) const {
    const XmlElement* limit = joint.child("limit");
    if (limit == nullptr) {
      if (type != "continuous")
        add(faults, "limit is missing; add <limit lower= upper= effort= velocity=/>");
      return;
    }
    double lower = 0.0, upper = 0.0, effort = 0.0, velocity = 0.0;
    const bool bounds = (limit->attribute("lower") == nullptr ||
                         read_bounded(*limit, "lower", &lower, 1, kLargest, "rad", faults)) &&
                        (limit->attribute("upper") == nullptr ||
                         read_bounded(*limit, "upper", &upper, 1, kLargest, "rad", faults));
    if (bounds && !(lower <= upper)) add(faults, "limit lower is above upper; exchange them");
    if (limit->attribute("effort") == nullptr) {
      add(faults, "limit has no effort");
    } else if (read_bounded(*limit, "effort", &effort, 1, kLargest, "N m", faults) &&
               !(effort >= 0.0)) {
      add(faults, "limit effort must not be negative; give its size");
    }
    if (limit->attribute("velocity") == nullptr) {
      add(faults, "limit has no velocity");
    } else if (read_bounded(*limit, "velocity", &velocity, 1, kLargest, "rad/s", faults) &&
               !(velocity >= 0.0)) {
      add(faults, "limit velocity must not be negative; give its size");
    }
  }

  void check_mimic(const XmlElement& joint, const XmlElement& mimic, std::string& faults) const {
    const std::string* followed = mimic.attribute("joint");
    double value = 0.0;
    read_bounded(mimic, "multiplier", &value, 1, kLargest, "", faults);
    read_bounded(mimic, "offset", &value, 1, kLargest, "", faults);
    if (followed == nullptr) {
      add(faults, "mimic names no joint");
      return;
    }
    // Follow the chain of mimics: it must end at a joint that moves by itself.
    std::string at = *followed;
    for (std::size_t steps = 0;; ++steps) {
      if (at == name_of(joint) || steps > joints_.size()) {
        add(faults, "mimic: the joint follows itself; name one that moves by itself");
        return;
      }
      const auto found = joints_.find(at);
      if (found == joints_.end()) {
        std::vector<std::string> known;
        for (const auto& entry : joints_) known.push_back(entry.first);
        add(faults, "mimic: there is no joint " + at + suggestion(at, known));
        return;
      }
      const std::string* type = found->second->attribute("type");
      if (type != nullptr && *type == "fixed") {
        add(faults, "mimic: joint " + at + " is fixed");
        return;
      }
      const XmlElement* next = found->second->child("mimic");
      const std::string* name = next == nullptr ? nullptr : next->attribute("joint");
      if (name == nullptr) return;
      at = *name;
    }
  }

  void check_tree(const std::vector<const XmlElement*>& joints) const {
    std::map<std::string, const XmlElement*> joint_of_child;
    std::multimap<std::string, std::string> children;
    for (const XmlElement* joint : joints) {
      const std::string child = *joint->child("child")->attribute("link");
      const auto [other, first] = joint_of_child.emplace(child, joint);
      if (!first) {
        fail_at(file_, joint->line,
                "link " + child + " has two parents: joints " + name_of(*other->second) + " and " +
                    name_of(*joint) + "; a URDF is a tree: remove one");
      }
      children.emplace(*joint->child("parent")->attribute("link"), child);
    }
    std::vector<std::string> roots;
    for (const auto& link : links_) {
      if (joint_of_child.count(link.first) == 0) roots.push_back(link.first);
    }
    if (roots.size() > 1) {
      fail_at(file_, links_.at(roots[1]),
              "two roots, " + roots[0] + " and " + roots[1] + "; join them by a joint");
    }
    std::set<std::string> reached;
    std::vector<std::string> open = roots;
    while (!open.empty()) {
      const std::string link = open.back();
      open.pop_back();
      reached.insert(link);
      const auto [from, to] = children.equal_range(link);
      for (auto child = from; child != to; ++child) open.push_back(child->second);
    }
    if (reached.size() == links_.size()) return;
    std::string lost;
    int line = 0;
    for (const auto& [name, at] : links_) {
      if (reached.count(name) != 0) continue;
      if (lost.size() < 100) lost += (lost.empty() ? "" : ", ") + name;
      if (line == 0) line = at;
    }
    if (roots.empty())
      fail_at(
          file_, line,
          "no root: the joints form a cycle through links " + lost + "; remove one of its joints");
    fail_at(file_, line,
            "links " + lost + " form a cycle and cannot be reached from the root " + roots[0] +
                "; remove one of its joints and hang the rest on the root");
  }

  std::size_t faults_ = 0;
  std::string told_;
  std::string file_;
  std::map<std::string, int> links_;  // name, line
  std::map<std::string, const XmlElement*> joints_;
};

}  // namespace

void check_urdf(const XmlElement& robot, const std::string& file, std::vector<std::string>& notes) {
  Checker(file).check(robot, notes);
}

}  // namespace twinbus::robot
