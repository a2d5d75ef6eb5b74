#include "robot/lint/mend.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <utility>

#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/onboarding/anatomy.h"
#include "robot/onboarding/base_turn.h"
#include "robot/lint/mirrored_ranges.h"
#include "robot/description/link_points.h"

namespace twinbus::inline robot {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostDegrees = 720.0;  // a range of more is no angle at all
constexpr double kMostSpeed = 100.0;    // of a joint that turns [rad/s]; of one that slides 20 m/s
constexpr double kForward = 1.15;       // toes before the ankle against the heel behind it
constexpr double kDust = 1e-12;         // [kg m^2]
constexpr double kPlainMass = 1.0;      // [kg]
constexpr double kPlainEffort = 100.0, kPlainSpeed = 3.0, kPlainSlide = 0.3;  // [N m or N], [rad/s], [m/s]
constexpr double kLeastSize = 0.001;    // [m]
constexpr double kFarShell = 3.0;       // of what its geometry allows: nine times the largest moment
constexpr std::array<const char*, 6> kMoments{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};

std::string digits(double value) {
  return formatted("%.6g", value);
}

XmlElement* child_of(XmlElement& element, const char* name) {
  const auto found = std::find_if(element.children.begin(), element.children.end(),
                                  [&](const XmlElement& c) { return c.name == name; });
  return found == element.children.end() ? nullptr : &*found;
}

bool read(const XmlElement& element, const std::string& key, double& value) {
  const std::string* text = element.attribute(key);
  return text != nullptr && parse_numbers(*text, &value, 1);
}

void write(XmlElement& element, const std::string& key, const std::string& value) {
  for (auto& [name, text] : element.attributes) {
    if (name == key) {
      text = value;
      return;
    }
  }
  element.attributes.emplace_back(key, value);
}

std::string name_of(const XmlElement& element) {
  const std::string* name = element.attribute("name");
  return name == nullptr ? "?" : *name;
}

class Mender {
 public:
  Mender(XmlElement& robot, std::vector<std::string>& changes) : robot_(robot), changes_(changes) {}

  void mend() {
    mend_commas(robot_, "");
    give_shapes();
    give_masses();
    for (XmlElement& element : robot_.children) {
      if (element.name == "link") mend_shapes(element);
      if (element.name == "link") mend_places(element);
      if (element.name == "link") mend_inertia(element);
      if (element.name != "joint") continue;
      mend_axis(element);
      mend_range(element);
    }
    const XmlElement before = robot_;  // a guess is no other joint's measure
    for (XmlElement& element : robot_.children) {
      if (element.name != "joint") continue;
      mend_limit(before, element, "effort", "N m", "N", 1e4, 1e4);
      mend_limit(before, element, "velocity", "rad/s", "m/s", kMostSpeed, 20.0);
    }
  }

 private:
  void say(const std::string& about, const std::string& what) { changes_.push_back(about + ": " + what); }

  // Three numbers between commas.
  void mend_commas(XmlElement& element, const std::string& within) {
    const std::string about = element.attribute("name") == nullptr ? within : element.name + " " + name_of(element);
    for (auto& [key, text] : element.attributes) {
      double v[3];
      if ((key != "xyz" && key != "rpy") || text.find(',') == std::string::npos || parse_numbers(text, v, 3)) continue;
      std::string spaced = text;
      std::replace(spaced.begin(), spaced.end(), ',', ' ');
      if (!parse_numbers(spaced, v, 3)) continue;
      say(about, element.name + " " + key + "=\"" + text + "\" has commas between its numbers: spaces");
      text = spaced;
    }
    for (XmlElement& child : element.children) mend_commas(child, about);
  }

  // A file for drawing alone.
  void give_shapes() {
    int given = 0;
    for (XmlElement& link : robot_.children) {
      if (link.name == "link" && child_of(link, "collision") != nullptr) return;
    }
    for (XmlElement& link : robot_.children) {
      if (link.name != "link") continue;
      std::vector<XmlElement> shapes;
      for (const XmlElement& drawn : link.children) {
        if (drawn.name == "visual") shapes.push_back(drawn);
      }
      for (XmlElement& shape : shapes) {
        shape.name = "collision";
        std::erase_if(shape.children, [](const XmlElement& e) { return e.name == "material"; });
        link.children.push_back(shape);
      }
      given += shapes.empty() ? 0 : 1;
    }
    if (given > 0)
      say("robot", "no link can be touched: the " + std::to_string(given) + " that are drawn are touched where they are drawn");
  }

  // A file for drawing and kinematics alone.
  void give_masses() {
    int given = 0;
    for (XmlElement& link : robot_.children) {
      if (link.name == "link" && child_of(link, "inertial") != nullptr) return;
    }
    for (XmlElement& link : robot_.children) {
      if (link.name != "link" || (child_of(link, "collision") == nullptr && child_of(link, "visual") == nullptr)) continue;
      XmlElement inertial, mass, inertia;
      inertial.name = "inertial", mass.name = "mass", inertia.name = "inertia";
      mass.attributes = {{"value", digits(kPlainMass)}};
      for (const char* key : kMoments) inertia.attributes.emplace_back(key, "0");
      inertial.children = {mass, inertia};
      link.children.push_back(inertial);
      ++given;
    }
    if (given > 0)
      say("robot", "no link has a mass: each of the " + std::to_string(given) + " that have a shape weighs " +
                       digits(kPlainMass) + " kg, with the inertia of a box around it; "
                       "a simulation says nothing about weight and torque "
                       "until true ones are there");
  }

  // Macros that were not expanded and only colour, and sizes of nothing.
  void mend_shapes(XmlElement& link) {
    for (XmlElement& part : link.children) {
      if (part.name != "visual" && part.name != "collision") continue;
      const auto colours = [&](const XmlElement& e) {
        return e.name.starts_with("xacro:") && e.attributes.empty() && e.children.empty();
      };
      const std::size_t coloured = std::erase_if(part.children, colours);
      if (coloured > 0 && ++macros_ == 1) {
        say("link " + name_of(link),
            "a macro of xacro that was not expanded, in <" + part.name + ">, is left out, here and elsewhere");
      }
      XmlElement* geometry = child_of(part, "geometry");
      if (geometry == nullptr || geometry->children.size() != 1) continue;
      XmlElement& shape = geometry->children.front();
      for (auto& [key, text] : shape.attributes) {
        const bool is_size = key == "size" || key == "radius" || key == "length";
        double v[3];
        const int count = key == "size" ? 3 : 1;
        if (!is_size || !parse_numbers(text, v, count) || *std::min_element(v, v + count) > 0.0) continue;
        std::string mended;
        for (int i = 0; i < count; ++i) mended += (i > 0 ? " " : "") + digits(v[i] > 0.0 ? v[i] : kLeastSize);
        say("link " + name_of(link) + ", " + part.name, shape.name + " " + key + " " + text + " is nothing: " + mended + " m");
        text = mended;
      }
    }
  }

  // An angle written as a place: the mesh that is touched is far from where it is drawn and weighs.
  void mend_places(XmlElement& link) {
    const auto place = [](const XmlElement* part) {
      double v[3] = {};
      const XmlElement* origin = part == nullptr ? nullptr : part->child("origin");
      const std::string* text = origin == nullptr ? nullptr : origin->attribute("xyz");
      if (text == nullptr || !parse_numbers(*text, v, 3)) return Eigen::Vector3d(0.0, 0.0, 0.0);
      return Eigen::Vector3d(v[0], v[1], v[2]);
    };
    const auto mesh = [](const XmlElement& part) {
      const XmlElement* geometry = part.child("geometry");
      const XmlElement* shape = geometry == nullptr ? nullptr : geometry->child("mesh");
      const std::string* name = shape == nullptr ? nullptr : shape->attribute("filename");
      return name == nullptr ? std::string() : *name;
    };
    const Eigen::Vector3d mass = place(link.child("inertial"));
    for (XmlElement& touched : link.children) {
      if (touched.name != "collision" || mesh(touched).empty()) continue;
      const XmlElement* drawn = nullptr;
      const auto off = [&](const XmlElement& other) { return (place(&other) - place(&touched)).norm(); };
      for (const XmlElement& part : link.children) {
        if (part.name == "visual" && mesh(part) == mesh(touched) && (drawn == nullptr || off(part) < off(*drawn))) drawn = &part;
      }
      if (drawn == nullptr || !(off(*drawn) > kFarFromDrawn) || !((place(drawn) - mass).norm() < (place(&touched) - mass).norm()))
        continue;
      say("link " + name_of(link) + ", collision",
          "its mesh lies " + digits(off(*drawn)) + " m from where the same mesh is drawn: it is put there");
      std::erase_if(touched.children, [](const XmlElement& e) { return e.name == "origin"; });
      if (const XmlElement* origin = drawn->child("origin")) touched.children.push_back(*origin);
    }
  }

  void mend_inertia(XmlElement& link) {
    XmlElement* inertial = child_of(link, "inertial");
    XmlElement* inertia = inertial == nullptr ? nullptr : child_of(*inertial, "inertia");
    if (inertia == nullptr) return;
    double m[6] = {};
    for (std::size_t i = 0; i < 6; ++i) {
      if (!read(*inertia, kMoments[i], m[i])) return;  // the loader says what is wrong with it
    }
    Eigen::Matrix3d tensor;
    tensor << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
    Eigen::Vector3d moments = solver.eigenvalues();
    const std::string about = "link " + name_of(link);
    const bool negative = !(moments[0] >= -1e-6 * std::abs(moments[2]) - kDust);
    if (negative || tensor.isApprox(Eigen::Matrix3d::Identity(), 1e-9)) {
      for (const char* key : kMoments) write(*inertia, key, "0");
      say(about, (negative ? "a principal moment of " + digits(moments[0]) + " kg m^2 is no body's"
                           : std::string("an inertia of 1 1 1 is a placeholder")) +
                     ": that of a box around its geometry is taken, or, where it is fixed to another, of a point of its mass");
      return;
    }
    const double lacks = moments[2] - moments[0] - moments[1];
    if (!(lacks > 1e-9 * moments[2])) return;
    moments[0] += 0.5 * lacks;
    moments[1] += 0.5 * lacks;
    moments *= 1.0 + 1e-6;
    const Eigen::Matrix3d mended = solver.eigenvectors() * moments.asDiagonal() * solver.eigenvectors().transpose();
    const double values[6] = {mended(0, 0), mended(0, 1), mended(0, 2), mended(1, 1), mended(1, 2), mended(2, 2)};
    for (std::size_t i = 0; i < 6; ++i) write(*inertia, kMoments[i], formatted("%.9g", values[i]));
    say(about, "its largest moment exceeded the sum of the others by " + digits(lacks) +
                   " kg m^2, which no body's does: the two smaller ones are raised by half of that");
  }

  void mend_axis(XmlElement& joint) {
    XmlElement* axis = child_of(joint, "axis");
    double v[3];
    const std::string* text = axis == nullptr ? nullptr : axis->attribute("xyz");
    if (text == nullptr || !parse_numbers(*text, v, 3)) return;
    const double length = std::hypot(v[0], v[1], v[2]);
    if (std::abs(length - 1.0) <= 1e-3 || !(length > 1e-6)) return;
    say("joint " + name_of(joint), "axis " + *text + " gets length 1");
    write(*axis, "xyz", formatted("%.9f %.9f %.9f", v[0] / length, v[1] / length, v[2] / length));
  }

  void mend_range(XmlElement& joint) {
    XmlElement* limit = child_of(joint, "limit");
    double lower = 0.0, upper = 0.0;
    if (limit == nullptr || !read(*limit, "lower", lower) || !read(*limit, "upper", upper)) return;
    const std::string about = "joint " + name_of(joint);
    const auto set = [&](double low, double high) {
      write(*limit, "lower", digits(lower = low));
      write(*limit, "upper", digits(upper = high));
    };
    if (lower > upper) {
      say(about, "lower " + digits(lower) + " was above upper " + digits(upper) + ": they are exchanged");
      set(upper, lower);
    }
    const std::string* type = joint.attribute("type");
    const double most = std::max(std::abs(lower), std::abs(upper));
    if (type == nullptr || *type != "revolute" || !(upper - lower > 4.0 * kPi) || most > kMostDegrees) return;
    say(about, "its range of " + digits(lower) + " to " + digits(upper) + " is in degrees: written in radians");
    set(lower * kPi / 180.0, upper * kPi / 180.0);
  }

  static bool slides(const XmlElement& joint) {
    const std::string* type = joint.attribute("type");
    return type != nullptr && *type == "prismatic";
  }

  void mend_limit(const XmlElement& before, XmlElement& joint, const std::string& key, const char* turning,
                  const char* sliding, double most_turning, double most_sliding) {
    XmlElement* limit = child_of(joint, "limit");
    if (limit == nullptr) return;
    const double most = slides(joint) ? most_sliding : most_turning;
    const auto is_one = [&](double value) { return value > 0.0 && value <= most; };
    double value = 0.0;
    if (limit->attribute(key) != nullptr && (!read(*limit, key, value) || is_one(value))) return;
    const std::string unit = slides(joint) ? sliding : turning, about = "joint " + name_of(joint);
    const std::string was = limit->attribute(key) == nullptr
                                ? "it has no " + key + " limit"
                                : "its " + key + " limit of " + digits(value) + " " + unit + " is none";
    std::vector<double> others;
    for (const XmlElement& other : before.children) {
      const bool alike = other.name == "joint" && name_of(other) != name_of(joint) && slides(other) == slides(joint);
      const XmlElement* its = alike ? other.child("limit") : nullptr;
      double found = 0.0;
      if (its == nullptr || !read(*its, key, found) || !is_one(found)) continue;
      others.push_back(found);
      const std::vector<std::string> names = names_on_other_side(name_of(joint));
      if (std::find(names.begin(), names.end(), name_of(other)) == names.end()) continue;
      say(about, was + ": that of " + name_of(other) + " is taken, " + digits(found) + " " + unit);
      write(*limit, key, digits(found));
      return;
    }
    if (others.empty()) {
      const double plain = key == "effort" ? kPlainEffort : slides(joint) ? kPlainSlide : kPlainSpeed;
      say(about, was + ", nor has any other joint one: " + digits(plain) + " " + unit + " is a guess; give the motor's");
      write(*limit, key, digits(plain));
      return;
    }
    std::sort(others.begin(), others.end());
    const double middle = others[others.size() / 2];
    say(about, was + ": the middle one of its other joints is taken, " + digits(middle) + " " + unit + "; give the motor's");
    write(*limit, key, digits(middle));
  }

  XmlElement& robot_;
  std::vector<std::string>& changes_;
  int macros_ = 0;
};

void rename(XmlElement& element, const std::map<std::string, std::string>& names) {
  for (auto& [key, value] : element.attributes) {
    if (const auto found = names.find(value); found != names.end()) value = found->second;
  }
  if (const auto found = names.find(element.text); found != names.end()) element.text = found->second;
  for (XmlElement& child : element.children) rename(child, names);
}

// The link and those that are fixed to it.
std::vector<std::string> fixed_to(const XmlElement& robot, const std::string& link) {
  std::vector<std::string> parts{link};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const XmlElement& joint : robot.children) {
      const std::string* type = joint.name == "joint" ? joint.attribute("type") : nullptr;
      if (type != nullptr && *type == "fixed" && attribute_of(joint, "parent", "link") == parts[i])
        parts.push_back(attribute_of(joint, "child", "link"));
    }
  }
  return parts;
}

std::string written(const XmlElement& robot) {
  std::string text = "<?xml version=\"1.0\"?>\n<!-- Mended by `twinbus check`. -->\n";
  append_xml(robot, text);
  return text;
}

}  // namespace

double shell_radius(double moment, double mass) noexcept { return mass > 0.0 ? std::sqrt(1.5 * moment / mass) : 0.0; }

double shell_radius(const Link& link) {
  return shell_radius(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(link.inertia).eigenvalues()[2], link.mass);
}

std::vector<std::string> names_on_other_side(const std::string& name) {
  std::vector<std::string> found;
  static constexpr std::pair<const char*, const char*> kWords[] = {{"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}};
  const auto with = [&](std::size_t at, std::size_t length, const std::string& word) {
    std::string other = name;
    found.push_back(other.replace(at, length, word));
  };
  for (const auto& [left, right] : kWords) {
    const std::string l = left, r = right;
    if (const std::size_t at = name.find(l); at != std::string::npos) {
      with(at, l.size(), r);
      return found;
    }
    if (const std::size_t at = name.find(r); at != std::string::npos) {
      with(at, r.size(), l);
      return found;
    }
  }
  // A single letter: l_knee, arm_l, LKnee, LLEG_KNEE.
  static constexpr std::pair<char, char> kLetters[] = {{'l', 'r'}, {'r', 'l'}, {'L', 'R'}, {'R', 'L'}};
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i > 0 && name[i - 1] != '_') continue;
    for (const auto& [one, other] : kLetters) {
      if (name[i] == one) with(i, 1, std::string(1, other));
    }
  }
  return found;
}

std::string mend_urdf(const std::string& text, const std::string& file, std::vector<std::string>& changes) {
  XmlElement robot = parse_xml(text, file);
  const std::size_t before = changes.size();
  Mender(robot, changes).mend();
  return changes.size() == before ? text : written(robot);
}

std::string mend_sides(const std::string& text, const std::string& file, const Model& model, std::vector<std::string>& changes) {
  const Anatomy found = find_anatomy(model, {});
  for (std::size_t side = 0; side < 2; ++side) {
    const Sole& sole = found.soles[side];
    if (sole.link < 0 || side_of_name(model.links[static_cast<std::size_t>(sole.link)].name) != (side == 0 ? -1 : 1)) return text;
    const double ahead = sole.frame.translation().x() + sole.front, behind = sole.back - sole.frame.translation().x();
    if (!(ahead > kForward * behind)) return text;  // it may as well look back
  }
  XmlElement robot = parse_xml(text, file);
  std::map<std::string, std::string> names;
  std::vector<std::string> all;
  for (const XmlElement& element : robot.children) {
    if (element.name == "link" || element.name == "joint") all.push_back(name_of(element));
  }
  for (const std::string& name : all) {
    for (const std::string& other : names_on_other_side(name)) {
      if (std::find(all.begin(), all.end(), other) != all.end()) names[name] = other;
    }
  }
  // Only pairs: two names may not become one.
  std::erase_if(names, [&](const auto& pair) {
    const auto back = names.find(pair.second);
    return back == names.end() || back->second != pair.first;
  });
  if (names.empty()) return text;
  rename(robot, names);
  changes.push_back("robot: what is called left is on the right, and the feet point forward: left and right are exchanged in " +
                    std::to_string(names.size()) + " names of links and joints");
  return written(robot);
}

std::string mend_images(const std::string& text, const std::string& file, const Model& model, std::vector<std::string>& changes) {
  XmlElement robot = parse_xml(text, file);
  const std::size_t before = changes.size();
  for (const UnmirroredRange& fault : unmirrored_ranges(model, find_anatomy(model, {}).leg_joints)) {
    const Joint& other = model.joints[static_cast<std::size_t>(fault.other)];
    for (XmlElement& joint : robot.children) {
      XmlElement* limit = joint.name == "joint" && name_of(joint) == other.name ? child_of(joint, "limit") : nullptr;
      if (!fault.of_leg || limit == nullptr) continue;
      write(*limit, "lower", digits(fault.lower));
      write(*limit, "upper", digits(fault.upper));
      changes.push_back("joint " + other.name + ": its range of " + digits(other.lower) + " to " + digits(other.upper) +
                        " is not the mirror image of that of " + model.joints[static_cast<std::size_t>(fault.kept)].name +
                        ", which legs need more: " + digits(fault.lower) + " to " + digits(fault.upper));
    }
  }
  return changes.size() == before ? text : written(robot);
}

std::string mend_far_inertias(const std::string& text, const std::string& file, const Model& model,
                              std::vector<std::string>& changes) {
  XmlElement robot = parse_xml(text, file);
  const std::size_t before = changes.size();
  for (const Link& link : model.links) {
    double reach = 0.0;
    for (const Eigen::Vector3d& point : link_points(link)) reach = std::max(reach, (point - link.com).norm());
    const double shell = shell_radius(link);
    if (!(reach > 0.0) || !(shell > kFarShell * reach)) continue;
    const std::vector<std::string> parts = fixed_to(robot, link.name);
    for (XmlElement& element : robot.children) {
      if (element.name != "link" || std::find(parts.begin(), parts.end(), name_of(element)) == parts.end()) continue;
      XmlElement* inertial = child_of(element, "inertial");
      XmlElement* inertia = inertial == nullptr ? nullptr : child_of(*inertial, "inertia");
      const XmlElement* mass = inertial == nullptr ? nullptr : inertial->child("mass");
      double most = 0.0, moment = 0.0, weighs = 0.0;
      for (const char* key : {"ixx", "iyy", "izz"}) {
        if (inertia != nullptr && read(*inertia, key, moment)) most = std::max(most, moment);
      }
      if (mass == nullptr || !read(*mass, "value", weighs) || !(shell_radius(most, weighs) > kFarShell * reach)) continue;
      for (const char* key : kMoments) write(*inertia, key, "0");
      changes.push_back("link " + name_of(element) + ": its inertia is that of a shell of radius " +
                        digits(shell_radius(most, weighs)) + " m, and its geometry ends at " + digits(reach) +
                        " m: that of a box around its geometry is taken, or, where it is fixed to another, of a point of its mass");
    }
  }
  return changes.size() == before ? text : written(robot);
}

}  // namespace twinbus::robot
