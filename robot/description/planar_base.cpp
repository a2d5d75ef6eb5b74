// A base that moves on the plane: the links and joints between the ground and the root link of its URDF.

#include <algorithm>
#include <set>
#include <vector>

#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/description/urdf.h"

namespace twinbus::inline robot {

namespace {

constexpr const char* kGround = "plane";
constexpr const char* kCarriages[2] = {"plane_x", "plane_xy"};
constexpr double kCarriage = 0.01;  // a joint moves what has mass [kg]
constexpr double kPush = 10.0;      // of the weight on it, times its mass [m/s^2]
constexpr double kTurn = 5.0;       // [m^2/s^2]
constexpr double kLightest = 1.0;   // [kg]

double mass_of(const XmlElement& link) {
  const XmlElement* inertial = link.child("inertial");
  const XmlElement* mass = inertial == nullptr ? nullptr : inertial->child("mass");
  const std::string* text = mass == nullptr ? nullptr : mass->attribute("value");
  double value = 0.0;
  return text != nullptr && parse_numbers(*text, &value, 1) && value > 0.0 ? value : 0.0;
}

std::string carriage(const char* name) {
  return formatted("  <link name=\"%s\"><inertial><mass value=\"%g\"/>"
                   "<inertia ixx=\"1e-5\" iyy=\"1e-5\" izz=\"1e-5\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n",
                   name, kCarriage);
}

std::string joint(const char* name, const std::string& parent, const std::string& child, double height, const char* axis,
                  const std::string& limit) {
  const bool turns = axis[4] == '1';
  return formatted("  <joint name=\"%s\" type=\"%s\">\n    <origin xyz=\"0 0 %.9g\"/>\n    <parent link=\"%s\"/>\n    <child link=\"%s\"/>\n",
                   name, turns ? "continuous" : "prismatic", height, xml_escaped(parent).c_str(), xml_escaped(child).c_str()) +
         "    <axis xyz=\"" + axis + "\"/>\n    <limit " + limit + "/>\n  </joint>\n";
}

}  // namespace

std::string with_plane_joints(const std::string& text, const std::string& file, const PlaneBase& base) {
  const XmlElement robot = parse_xml(text, file);
  std::set<std::string> links, children;
  std::vector<const XmlElement*> taken;
  double mass = 0.0;
  for (const XmlElement& part : robot.children) {
    const std::string* name = part.attribute("name");
    if (name == nullptr || (part.name != "link" && part.name != "joint")) continue;
    const auto is_one_of = [&](const auto& ours) { return std::find(std::begin(ours), std::end(ours), *name) != std::end(ours); };
    if (*name == kGround || is_one_of(kCarriages) || is_one_of(kPlaneJoints)) taken.push_back(&part);
    const std::string moved = attribute_of(part, "child", "link");
    if (part.name == "link") links.insert(*name);
    if (part.name == "link") mass += mass_of(part);
    if (part.name == "joint" && !moved.empty()) children.insert(moved);
  }
  std::vector<std::string> roots;
  std::set_difference(links.begin(), links.end(), children.begin(), children.end(), std::back_inserter(roots));
  if (taken.size() == 6 && roots == std::vector<std::string>{kGround}) return text;
  if (!taken.empty()) {
    fail_at(file, taken.front()->line, taken.front()->name + " " + *taken.front()->attribute("name") +
                                           " has the name of one that base: planar of robot.yaml adds: give it another name");
  }
  const std::size_t end = text.rfind("</robot>");
  if (roots.size() != 1 || end == std::string::npos) return text;  // who reads it next says what is wrong
  mass = std::max(mass, kLightest);
  const std::string slide = formatted("lower=\"%.9g\" upper=\"%.9g\" effort=\"%.9g\" velocity=\"%.9g\"", -base.area, base.area,
                                      kPush * mass, base.speed);
  const std::string turn = formatted("effort=\"%.9g\" velocity=\"%.9g\"", kTurn * mass, base.turn_speed);
  return text.substr(0, end) + formatted("  <link name=\"%s\"/>\n", kGround) + carriage(kCarriages[0]) + carriage(kCarriages[1]) +
         joint(kPlaneJoints[0], kGround, kCarriages[0], 0.0, "1 0 0", slide) +
         joint(kPlaneJoints[1], kCarriages[0], kCarriages[1], 0.0, "0 1 0", slide) +
         joint(kPlaneJoints[2], kCarriages[1], roots.front(), base.height, "0 0 1", turn) + text.substr(end);
}

}  // namespace twinbus::robot
