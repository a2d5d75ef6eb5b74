#include "robot/lint/mend.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/lint/urdf_edit.h"

namespace twinbus::inline robot {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostDegrees = 720.0;  // a range of more is no angle at all
constexpr double kMostSpeed = 100.0;    // of a joint that turns [rad/s]; of one that slides 20 m/s
constexpr double kDust = 1e-12;         // [kg m^2]
constexpr double kPlainMass = 1.0;      // [kg]
constexpr double kSpare = 2.0;          // of an effort that is a guess, over what the joint carries
constexpr double kPlainEffort = 100.0, kPlainSpeed = 3.0, kPlainSlide = 0.3;  // [N m or N], [rad/s], [m/s]
constexpr double kLeastSize = 0.001;    // [m]

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
    const std::string about = element.attribute("name") == nullptr ? within : element.name + " " + element_name(element);
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
      if (link.name == "link" && child_to_change(link, "collision") != nullptr) return;
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
      if (link.name == "link" && child_to_change(link, "inertial") != nullptr) return;
    }
    for (XmlElement& link : robot_.children) {
      if (link.name != "link" || (child_to_change(link, "collision") == nullptr && child_to_change(link, "visual") == nullptr)) continue;
      XmlElement inertial, mass, inertia;
      inertial.name = "inertial", mass.name = "mass", inertia.name = "inertia";
      mass.attributes = {{"value", short_number(kPlainMass)}};
      for (const char* key : kInertiaKeys) inertia.attributes.emplace_back(key, "0");
      inertial.children = {mass, inertia};
      link.children.push_back(inertial);
      ++given;
    }
    if (given > 0)
      say("robot", "no link has a mass: each of the " + std::to_string(given) + " that have a shape weighs " +
                       short_number(kPlainMass) + " kg, with the inertia of a box around it; "
                       "a simulation says nothing about weight and torque "
                       "until true ones are there");
  }

  // Macros that were not expanded and only colour, parts without a shape, and sizes of nothing.
  void mend_shapes(XmlElement& link) {
    const std::size_t empty = std::erase_if(link.children, [](const XmlElement& part) {
      const bool has_shape = part.child("geometry") != nullptr && !part.child("geometry")->children.empty();
      return (part.name == "visual" || part.name == "collision") && !has_shape;
    });
    if (empty > 0) say("link " + element_name(link), "a <collision> or <visual> without a shape is left out");
    for (XmlElement& part : link.children) {
      if (part.name != "visual" && part.name != "collision") continue;
      const auto colours = [&](const XmlElement& e) {
        return e.name.starts_with("xacro:") && e.attributes.empty() && e.children.empty();
      };
      const std::size_t coloured = std::erase_if(part.children, colours);
      if (coloured > 0 && ++macros_ == 1) {
        say("link " + element_name(link),
            "a macro of xacro that was not expanded, in <" + part.name + ">, is left out, here and elsewhere");
      }
      XmlElement* geometry = child_to_change(part, "geometry");
      if (geometry == nullptr || geometry->children.size() != 1) continue;
      XmlElement& shape = geometry->children.front();
      for (auto& [key, text] : shape.attributes) {
        const bool is_size = key == "size" || key == "radius" || key == "length";
        double v[3];
        const int count = key == "size" ? 3 : 1;
        if (!is_size || !parse_numbers(text, v, count) || *std::min_element(v, v + count) > 0.0) continue;
        std::string mended;
        for (int i = 0; i < count; ++i) mended += (i > 0 ? " " : "") + short_number(v[i] > 0.0 ? v[i] : kLeastSize);
        say("link " + element_name(link) + ", " + part.name, shape.name + " " + key + " " + text + " is nothing: " + mended + " m");
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
      say("link " + element_name(link) + ", collision",
          "its mesh lies " + short_number(off(*drawn)) + " m from where the same mesh is drawn: it is put there");
      std::erase_if(touched.children, [](const XmlElement& e) { return e.name == "origin"; });
      if (const XmlElement* origin = drawn->child("origin")) touched.children.push_back(*origin);
    }
  }

  void mend_inertia(XmlElement& link) {
    XmlElement* inertial = child_to_change(link, "inertial");
    XmlElement* inertia = inertial == nullptr ? nullptr : child_to_change(*inertial, "inertia");
    if (inertia == nullptr) return;
    double m[6] = {};
    for (std::size_t i = 0; i < 6; ++i) {
      if (!read_number(*inertia, kInertiaKeys[i], m[i])) return;  // the loader says what is wrong with it
    }
    Eigen::Matrix3d tensor;
    tensor << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
    Eigen::Vector3d moments = solver.eigenvalues();
    const std::string about = "link " + element_name(link);
    const bool negative = !(moments[0] >= -1e-6 * std::abs(moments[2]) - kDust);
    if (negative || tensor.isApprox(Eigen::Matrix3d::Identity(), 1e-9)) {
      for (const char* key : kInertiaKeys) write_attribute(*inertia, key, "0");
      say(about, (negative ? "a principal moment of " + short_number(moments[0]) + " kg m^2 is no body's"
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
    for (std::size_t i = 0; i < 6; ++i) write_attribute(*inertia, kInertiaKeys[i], formatted("%.9g", values[i]));
    say(about, "its largest moment exceeded the sum of the others by " + short_number(lacks) +
                   " kg m^2, which no body's does: the two smaller ones are raised by half of that");
  }

  void mend_axis(XmlElement& joint) {
    XmlElement* axis = child_to_change(joint, "axis");
    double v[3];
    const std::string* text = axis == nullptr ? nullptr : axis->attribute("xyz");
    if (text == nullptr || !parse_numbers(*text, v, 3)) return;
    const double length = std::hypot(v[0], v[1], v[2]);
    if (std::abs(length - 1.0) <= 1e-3 || !(length > 1e-6)) return;
    say("joint " + element_name(joint), "axis " + *text + " gets length 1");
    write_attribute(*axis, "xyz", formatted("%.9f %.9f %.9f", v[0] / length, v[1] / length, v[2] / length));
  }

  void mend_range(XmlElement& joint) {
    XmlElement* limit = child_to_change(joint, "limit");
    double lower = 0.0, upper = 0.0;
    if (limit == nullptr || !read_number(*limit, "lower", lower) || !read_number(*limit, "upper", upper)) return;
    const std::string about = "joint " + element_name(joint);
    const auto set = [&](double low, double high) {
      write_attribute(*limit, "lower", short_number(lower = low));
      write_attribute(*limit, "upper", short_number(upper = high));
    };
    if (lower > upper) {
      say(about, "lower " + short_number(lower) + " was above upper " + short_number(upper) + ": they are exchanged");
      set(upper, lower);
    }
    const std::string* type = joint.attribute("type");
    const double most = std::max(std::abs(lower), std::abs(upper));
    if (type == nullptr || *type != "revolute" || !(upper - lower > 4.0 * kPi) || most > kMostDegrees) return;
    say(about, "its range of " + short_number(lower) + " to " + short_number(upper) + " is in degrees: written in radians");
    set(lower * kPi / 180.0, upper * kPi / 180.0);
  }

  static bool slides(const XmlElement& joint) {
    const std::string* type = joint.attribute("type");
    return type != nullptr && *type == "prismatic";
  }

  void mend_limit(const XmlElement& before, XmlElement& joint, const std::string& key, const char* turning,
                  const char* sliding, double most_turning, double most_sliding) {
    XmlElement* limit = child_to_change(joint, "limit");
    if (limit == nullptr) return;
    const double most = slides(joint) ? most_sliding : most_turning;
    const auto is_one = [&](double value) { return value > 0.0 && value <= most; };
    double value = 0.0;
    if (limit->attribute(key) != nullptr && (!read_number(*limit, key, value) || is_one(value))) return;
    const std::string unit = slides(joint) ? sliding : turning, about = "joint " + element_name(joint);
    const std::string was = limit->attribute(key) == nullptr
                                ? "it has no " + key + " limit"
                                : "its " + key + " limit of " + short_number(value) + " " + unit + " is none";
    std::vector<double> others;
    for (const XmlElement& other : before.children) {
      const bool alike = other.name == "joint" && element_name(other) != element_name(joint) && slides(other) == slides(joint);
      const XmlElement* its = alike ? other.child("limit") : nullptr;
      double found = 0.0;
      if (its == nullptr || !read_number(*its, key, found) || !is_one(found)) continue;
      others.push_back(found);
      const std::vector<std::string> names = names_on_other_side(element_name(joint));
      if (std::find(names.begin(), names.end(), element_name(other)) == names.end()) continue;
      say(about, was + ": that of " + element_name(other) + " is taken, " + short_number(found) + " " + unit);
      write_attribute(*limit, key, short_number(found));
      return;
    }
    if (others.empty()) {
      const double carried = key == "effort" ? most_carried(before, attribute_of(joint, "child", "link"), slides(joint)) : 0.0;
      const double plain = key == "effort" ? std::max(kPlainEffort, kSpare * carried) : slides(joint) ? kPlainSlide : kPlainSpeed;
      say(about, was + ", nor has any other joint one: " + short_number(plain) + " " + unit + " is a guess; give the motor's");
      write_attribute(*limit, key, short_number(plain));
      return;
    }
    std::sort(others.begin(), others.end());
    const double middle = others[others.size() / 2];
    say(about, was + ": the middle one of its other joints is taken, " + short_number(middle) + " " + unit + "; give the motor's");
    write_attribute(*limit, key, short_number(middle));
  }

  // By a joint above this link: of a level arm stretched out at its longest, or of what hangs on a slide [N m or N].
  static double most_carried(const XmlElement& robot, const std::string& link, bool slides) {
    struct Part {
      std::string link;
      double far;  // along the joints [m]
    };
    const auto length = [](const XmlElement* element) {
      double v[3] = {};
      const XmlElement* origin = element == nullptr ? nullptr : element->child("origin");
      const std::string* text = origin == nullptr ? nullptr : origin->attribute("xyz");
      return text != nullptr && parse_numbers(*text, v, 3) ? std::hypot(v[0], v[1], v[2]) : 0.0;
    };
    std::vector<Part> parts{{link, 0.0}};
    double carried = 0.0;
    for (std::size_t i = 0; i < parts.size() && parts.size() <= robot.children.size(); ++i) {  // no circle ends it
      const Part part = parts[i];
      for (const XmlElement& element : robot.children) {
        if (element.name == "joint" && attribute_of(element, "parent", "link") == part.link)
          parts.push_back({attribute_of(element, "child", "link"), part.far + length(&element)});
        if (element.name != "link" || element_name(element) != part.link) continue;
        const XmlElement* inertial = element.child("inertial");
        const XmlElement* mass = inertial == nullptr ? nullptr : inertial->child("mass");
        double m = 0.0;
        if (mass != nullptr && read_number(*mass, "value", m)) carried += kGravity * m * (slides ? 1.0 : part.far + length(inertial));
      }
    }
    return carried;
  }

  XmlElement& robot_;
  std::vector<std::string>& changes_;
  int macros_ = 0;
};

}  // namespace

std::string mend_urdf(const std::string& text, const std::string& file, std::vector<std::string>& changes) {
  XmlElement robot = parse_xml(text, file);
  const std::size_t before = changes.size();
  Mender(robot, changes).mend();
  return changes.size() == before ? text : mended_text(robot);
}

}  // namespace twinbus::robot
