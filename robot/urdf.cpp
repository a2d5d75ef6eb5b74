#include "robot/urdf.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <filesystem>
#include <limits>
#include <map>

namespace twinbus {

namespace {

namespace fs = std::filesystem;

Eigen::Isometry3d to_isometry(const urdf::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  const urdf::Rotation& r = pose.rotation;
  result.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  return result;
}

// Files come from the robot's folder or from a named root, never from elsewhere.
std::string resolve_mesh(const std::string& name, const AssetRoots& roots,
                         const std::string& where) {
  const fs::path own = fs::weakly_canonical(roots.folder);
  fs::path root = own;
  std::string rest = name;
  const std::string scheme = "package://";
  if (name.compare(0, scheme.size(), scheme) == 0) {
    const std::size_t start = name.find_first_not_of('/', scheme.size());
    const std::string path = start == std::string::npos ? "" : name.substr(start);
    const std::size_t slash = path.find('/');
    const std::string package = path.substr(0, slash);
    rest = slash == std::string::npos ? "" : path.substr(slash + 1);
    bool found = package == own.filename();
    for (const auto& [known, folder] : roots.packages) {
      if (known == package) {
        root = fs::weakly_canonical(own / folder);
        found = true;
      }
    }
    if (!found) {
      throw std::runtime_error(where + ": package " + package +
                               " is not known; name its folder in robot.yaml, packages");
    }
  } else if (name.find("://") != std::string::npos) {
    throw std::runtime_error(where + ": " + name +
                             ": only package:// and paths relative to the robot's folder are read");
  }
  const fs::path full = fs::weakly_canonical(root / rest);
  const fs::path inside = full.lexically_relative(root);
  if (inside.empty() || *inside.begin() == "..") {
    throw std::runtime_error(where + ": " + name + " leaves the robot's folder");
  }
  return full.string();
}

Shape to_shape(const urdf::Collision& collision, const AssetRoots& roots,
               const std::string& where) {
  Shape shape;
  shape.pose = to_isometry(collision.origin);
  const urdf::Geometry& geometry = *collision.geometry;
  if (geometry.type == urdf::Geometry::BOX) {
    const auto& box = dynamic_cast<const urdf::Box&>(geometry);
    shape.kind = ShapeKind::kBox;
    shape.size << box.dim.x, box.dim.y, box.dim.z;
  } else if (geometry.type == urdf::Geometry::SPHERE) {
    shape.kind = ShapeKind::kSphere;
    shape.size[0] = dynamic_cast<const urdf::Sphere&>(geometry).radius;
  } else if (geometry.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
    shape.kind = ShapeKind::kCylinder;
    shape.size << cylinder.radius, cylinder.length, 0.0;
  } else {
    const auto& mesh = dynamic_cast<const urdf::Mesh&>(geometry);
    shape.kind = ShapeKind::kMesh;
    shape.size << mesh.scale.x, mesh.scale.y, mesh.scale.z;
    shape.mesh = resolve_mesh(mesh.filename, roots, where);
  }
  return shape;
}

UrdfLink to_link(const urdf::Link& from, int line, const AssetRoots& roots,
                 const std::string& file) {
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
    link.collision.push_back(to_shape(*collision, roots, where));
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

}  // namespace

UrdfTree parse_urdf(const std::string& text, const std::string& file, const AssetRoots& roots) {
  const XmlElement robot = parse_xml(text, file);
  check_urdf(robot, file);

  console_bridge::noOutputHandler();  // what it would print is checked above, with lines
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(text);
  } catch (const std::exception& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
  if (!model)
    throw std::runtime_error(
        file + ": the URDF parser refused it; compare it with the URDF specification");

  UrdfTree tree;
  tree.name = model->getName();
  std::map<std::string, int> link_index;
  for (const XmlElement& element : robot.children) {
    if (element.name != "link") continue;
    const std::string& name = *element.attribute("name");
    const auto link = model->getLink(name);
    if (!link) fail_at(file, element.line, "link " + name + ": the URDF parser lost it");
    link_index[name] = static_cast<int>(tree.links.size());
    tree.links.push_back(to_link(*link, element.line, roots, file));
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
  return tree;
}

}  // namespace twinbus
