#include "robot/description/urdf.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <limits>
#include <map>

#include "robot/names/transmission.h"

namespace twinbus::inline robot {

namespace {

// Spheres without a radius mark contact points: balls that small.  [m]
constexpr double kPointRadius = 1e-4;

Eigen::Isometry3d to_isometry(const urdf::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  const urdf::Rotation& r = pose.rotation;
  result.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  return result;
}

Shape to_shape(const urdf::Pose& origin, const urdf::Geometry& geometry, const AssetRoots& roots,
               const std::string& where) {
  Shape shape;
  shape.pose = to_isometry(origin);
  if (geometry.type == urdf::Geometry::BOX) {
    const auto& box = dynamic_cast<const urdf::Box&>(geometry);
    shape.kind = ShapeKind::kBox;
    shape.size << box.dim.x, box.dim.y, box.dim.z;
  } else if (geometry.type == urdf::Geometry::SPHERE) {
    shape.kind = ShapeKind::kSphere;
    shape.size[0] = std::max(dynamic_cast<const urdf::Sphere&>(geometry).radius, kPointRadius);
  } else if (geometry.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
    shape.kind = ShapeKind::kCylinder;
    shape.size << cylinder.radius, cylinder.length, 0.0;
  } else {
    const auto& mesh = dynamic_cast<const urdf::Mesh&>(geometry);
    shape.kind = ShapeKind::kMesh;
    shape.size << mesh.scale.x, mesh.scale.y, mesh.scale.z;
    shape.mesh = resolve_asset(mesh.filename, roots, where);
  }
  return shape;
}

UrdfLink to_link(const urdf::Link& from, int line, const AssetRoots& roots, const std::string& file,
                 std::vector<std::string>& notes) {
  UrdfLink link;
  link.name = from.name;
  link.line = line;
  if (from.inertial) {
    const urdf::Inertial& i = *from.inertial;
    link.mass = i.mass;
    link.inertial = to_isometry(i.origin);
    link.inertia << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
  }
  const std::string where = file + ":" + std::to_string(line) + ": link " + link.name;
  for (const auto& collision : from.collision_array) {
    link.collision.push_back(to_shape(collision->origin, *collision->geometry, roots, where));
  }
  for (const auto& visual : from.visual_array) {  // nothing depends on it: a lost one does no harm
    try {
      link.visual.push_back(to_shape(visual->origin, *visual->geometry, roots, where + ", visual"));
    } catch (const std::runtime_error& error) {
      notes.emplace_back(error.what());
    }
  }
  return link;
}

UrdfJoint to_joint(const urdf::Joint& from, int line) {
  UrdfJoint joint;
  joint.name = from.name;
  joint.line = line;
  joint.fixed = from.type == urdf::Joint::FIXED;
  joint.kind = from.type == urdf::Joint::PRISMATIC    ? JointKind::kPrismatic
               : from.type == urdf::Joint::CONTINUOUS ? JointKind::kContinuous
                                                      : JointKind::kRevolute;
  joint.origin = to_isometry(from.parent_to_joint_origin_transform);
  if (joint.fixed) return joint;
  joint.axis = Eigen::Vector3d(from.axis.x, from.axis.y, from.axis.z).normalized();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  joint.velocity = joint.effort = kInfinity;
  if (from.limits) {
    joint.lower = from.limits->lower;
    joint.upper = from.limits->upper;
    joint.velocity = from.limits->velocity;
    joint.effort = from.limits->effort;
  }
  if (joint.kind == JointKind::kContinuous) {
    joint.lower = -kInfinity;
    joint.upper = kInfinity;
  }
  if (from.dynamics) {
    joint.damping = from.dynamics->damping;
    joint.friction = from.dynamics->friction;
  }
  if (from.mimic) {
    joint.mimic = from.mimic->joint_name;
    joint.mimic_multiplier = from.mimic->multiplier;
    joint.mimic_offset = from.mimic->offset;
  }
  return joint;
}

// What urdfdom is given: the elements that it knows, as they were read here.  Its own reader takes malformed XML for
// something else.
std::string for_urdfdom(const XmlElement& robot) {
  XmlElement known;
  known.name = robot.name;
  known.attributes = robot.attributes;
  for (const XmlElement& element : robot.children) {
    if (element.name == "link" || element.name == "joint" || element.name == "material")
      known.children.push_back(element);
  }
  std::string text;
  append_xml(known, text);
  return text;
}

}  // namespace

UrdfTree parse_urdf(const std::string& text, const std::string& file, const AssetRoots& roots) {
  const XmlElement robot = parse_xml(text, file);
  UrdfTree tree;
  check_urdf(robot, file, tree.notes);

  console_bridge::noOutputHandler();  // what it would print is checked above, with lines
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(for_urdfdom(robot));
  } catch (const std::exception& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
  if (!model)
    throw std::runtime_error(
        file + ": the URDF parser refused it; compare it with the URDF specification");

  tree.name = model->getName();
  std::map<std::string, int> link_index;
  for (const XmlElement& element : robot.children) {
    if (element.name != "link") continue;
    const std::string& name = *element.attribute("name");
    const auto link = model->getLink(name);
    if (!link) fail_at(file, element.line, "link " + name + ": the URDF parser lost it");
    link_index[name] = static_cast<int>(tree.links.size());
    tree.links.push_back(to_link(*link, element.line, roots, file, tree.notes));
  }
  for (const XmlElement& element : robot.children) {
    if (element.name != "joint") continue;
    const std::string& name = *element.attribute("name");
    const auto joint = model->getJoint(name);
    if (!joint) fail_at(file, element.line, "joint " + name + ": the URDF parser lost it");
    UrdfJoint converted = to_joint(*joint, element.line);
    converted.parent = link_index.at(joint->parent_link_name);
    converted.child = link_index.at(joint->child_link_name);
    tree.links[static_cast<std::size_t>(converted.child)].parent_joint =
        static_cast<int>(tree.joints.size());
    tree.joints.push_back(std::move(converted));
  }
  tree.root = link_index.at(model->getRoot()->name);
  for (const Transmission& transmission : read_transmissions(robot, file)) {
    const auto joint =
        std::find_if(tree.joints.begin(), tree.joints.end(),
                     [&](const UrdfJoint& each) { return each.name == transmission.joint; });
    if (joint == tree.joints.end() || joint->fixed) {
      tree.notes.push_back(file + ":" + std::to_string(transmission.line) +
                           ": transmission of joint " + transmission.joint +
                           ", which does not move");
      continue;
    }
    joint->rotor_inertia = transmission.reflected();
  }
  return tree;
}

}  // namespace twinbus::robot
