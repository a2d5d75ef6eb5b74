#include "robot/mjcf/model_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "common/math/index.h"
#include "common/text/xml.h"
#include "geometry/bounds/convex_hull.h"
#include "geometry/mesh/mesh_file.h"
#include "robot/description/mujoco_config.h"
#include "robot/mjcf/urdf_text.h"

namespace twinbus::inline robot {

namespace {

std::string obj_text(const TriangleMesh& mesh) {
  std::string out = "# Written by twinbus export.\n";
  for (const Eigen::Vector3d& p : mesh.points) out += "v " + exact_numbers(p) + "\n";
  for (const auto& t : mesh.triangles)
    out += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
  return out;
}

template <std::size_t N>
std::string attribute(const char* name, const std::array<double, N>& numbers) {
  std::string out;
  for (const double each : numbers) out += (out.empty() ? "" : " ") + exact_number(each);
  return std::string(name) + "=\"" + out + "\"";
}

// On that ground.
std::string mjcf_surface(const MujocoContact& contact, double ground_friction) {
  std::array<double, 3> friction = contact.friction;
  friction[0] *= std::sqrt(ground_friction / kMujocoGround);
  return attribute("friction", friction) + " condim=\"" + std::to_string(contact.condim) + "\" " +
         attribute("solref", contact.solref) + " " + attribute("solimp", contact.solimp);
}

constexpr double kSoleHalf = 0.004;  // half thickness of the box that a sole becomes [m]
constexpr double kLeastMass = 1e-9;  // of a link without mass that cannot be joined with the next [kg]

// What MuJoCo gives one body: a link with mass and the massless ones before it, whose joints it has too.
// Null: the joint is no passive one.
const PassiveJoint* spring_among(const std::vector<PassiveJoint>& passive, int joint) {
  const auto found = std::find_if(passive.begin(), passive.end(), [&](const PassiveJoint& p) { return p.joint == joint; });
  return found == passive.end() ? nullptr : &*found;
}

class BodyWriter {
 public:
  BodyWriter(const Model& model, const MjcfContact& contact, const MjcfParts& parts, ExportedMeshes& meshes)
      : model_(model), contact_(contact), parts_(parts), meshes_(meshes),
        mujoco_(model.mujoco), passive_(passive_joints_of(model)), children_(model.links.size()) {
    for (int i = 1; i < model.link_count(); ++i) children_[at(model.links[at(i)].parent)].push_back(i);
  }

  void write(int link, const Eigen::Isometry3d& place, const std::string& indent, std::string& out) {
    std::vector<std::pair<int, Eigen::Isometry3d>> joints;  // of the body, with their frames in the parent
    Eigen::Isometry3d frame = place;
    if (link > 0) joints.emplace_back(link - 1, frame);
    while (link > 0 && is_passage(link)) {
      link = children_[at(link)].front();
      frame = frame * model_.joints[at(link - 1)].placement;
      joints.emplace_back(link - 1, frame);
    }
    const Link& body = model_.links[at(link)];
    out += indent + "<body name=\"" + xml_escaped(body.name) + "\" " +
           (link == 0 && !model_.floating_base && parts_.placeable ? "mocap=\"true\" " : "") + mjcf_place(frame) + ">\n";
    const std::string inner = indent + "  ";
    if (link == 0 && model_.floating_base) out += inner + "<freejoint name=\"" + kMjcfBase + "\"/>\n";
    for (const auto& [joint, joint_frame] : joints) write_joint(joint, frame.inverse() * joint_frame, inner, out);
    write_inertial(body, link == 0 && !model_.floating_base, inner, out);
    write_geoms(link, inner, out);
    for (const Frame& each : model_.frames) {
      if (each.link == link && each.name != body.name)
        out += inner + "<site name=\"" + xml_escaped(each.name) + "\" " + mjcf_place(each.in_link) + "/>\n";
    }
    if (link == model_.imu_link) out += inner + "<site name=\"imu_sensor\" " + mjcf_place(model_.imu) + "/>\n";
    for (const int child : children_[at(link)])
      write(child, model_.joints[at(child - 1)].placement, inner, out);
    out += indent + "</body>\n";
  }
  const std::map<std::string, MjcfText::Geom>& geoms() const { return geoms_; }

 private:
  // A link that only stands between two joints.
  bool is_passage(int link) const {
    const Link& body = model_.links[at(link)];
    return !(body.mass > 0.0) && children_[at(link)].size() == 1 && body.collision.empty() && link != model_.imu_link;
  }

  void write_joint(int index, const Eigen::Isometry3d& in_body, const std::string& indent, std::string& out) const {
    const Joint& joint = model_.joints[at(index)];
    out += indent + "<joint name=\"" + xml_escaped(joint.name) + "\" type=\"" +
           (joint.kind == JointKind::kPrismatic ? "slide" : "hinge") + "\" pos=\"" + exact_numbers(in_body.translation()) +
           "\" axis=\"" + exact_numbers(in_body.linear() * joint.axis) + "\"";
    if (std::isfinite(joint.lower) && std::isfinite(joint.upper) && joint.lower < joint.upper)
      out += " range=\"" + exact_number(joint.lower) + " " + exact_number(joint.upper) + "\"";
    if (joint.rotor_inertia > 0.0) out += " armature=\"" + exact_number(joint.rotor_inertia) + "\"";
    if (joint.damping > 0.0 && parts_.drives) out += " damping=\"" + exact_number(joint.damping) + "\"";
    if (const PassiveJoint* passive = spring_among(passive_, index)) {
      out += " stiffness=\"" + exact_number(passive->stiffness) + "\" springref=\"" + exact_number(passive->rest) + "\"";
    }
    if (joint.friction > 0.0) out += " frictionloss=\"" + exact_number(joint.friction) + "\"";
    if (joint.effort > 0.0 && joint.effort < 1e9 && parts_.drives && spring_among(passive_, index) == nullptr)
      out += " actuatorfrcrange=\"" + exact_number(-joint.effort) + " " + exact_number(joint.effort) + "\"";
    out += "/>\n";
  }

  void write_inertial(const Link& link, bool still, const std::string& indent, std::string& out) const {
    if (link.mass > 0.0) {
      const Eigen::Matrix3d& m = link.inertia;
      out += indent + "<inertial pos=\"" + exact_numbers(link.com) + "\" mass=\"" + exact_number(link.mass) +
             "\" fullinertia=\"" + exact_number(m(0, 0)) + " " + exact_number(m(1, 1)) + " " + exact_number(m(2, 2)) + " " +
             exact_number(m(0, 1)) + " " + exact_number(m(0, 2)) + " " + exact_number(m(1, 2)) + "\"/>\n";
    } else if (!still) {
      out += indent + "<inertial pos=\"0 0 0\" mass=\"" + exact_number(kLeastMass) + "\" diaginertia=\"1e-9 1e-9 1e-9\"/>\n";
    }
  }

  // said: by robot.yaml, or null.
  std::string touching(const std::string& name, double friction, const MujocoContact* said, const std::string& bits) const {
    const std::string usual = "friction=\"" + exact_number(std::sqrt(friction * contact_.ground_friction)) + " 0.005 0.0001\"";
    const std::string what = said != nullptr ? mjcf_surface(*said, contact_.ground_friction) : usual;
    return "name=\"" + xml_escaped(name) + "\" class=\"collision\" " + what + (bits.empty() ? "" : " " + bits);
  }

  void write_geoms(int link, const std::string& indent, std::string& out) {
    const Link& body = model_.links[at(link)];
    const bool has_sole = link == model_.soles[0].link || link == model_.soles[1].link;
    const std::string& bits = has_sole ? contact_.foot_bits : contact_.robot_bits;
    const MujocoContact* said = mujoco_.of_link(model_, link);
    int index = 0;
    for (const Shape& shape : body.collision) {
      const std::string name = body.name + "/" + std::to_string(index++);
      geoms_[name] = {link, -1};
      out += indent + mjcf_geom(shape, touching(name, contact_.link_friction, said, bits), meshes_) + "\n";
    }
    if (parts_.visual) {
      for (const Shape& shape : body.visual) out += indent + mjcf_geom(shape, "class=\"visual\"", meshes_) + "\n";
    }
    for (std::size_t side = 0; side < 2; ++side) {
      const Sole& sole = model_.soles[side];
      if (sole.link != link) continue;
      Shape box;
      box.kind = ShapeKind::kBox;
      box.size << sole.front + sole.back, sole.left + sole.right, 2.0 * kSoleHalf;
      box.pose = sole.frame * Eigen::Translation3d(0.5 * (sole.front - sole.back), 0.5 * (sole.left - sole.right), kSoleHalf);
      const std::string name = side == 0 ? "left_sole" : "right_sole";
      geoms_[name] = {link, static_cast<int>(side)};
      out += indent + mjcf_geom(box, touching(name, sole.friction, said, contact_.robot_bits), meshes_) + "\n";
    }
  }

  const Model& model_;
  const MjcfContact& contact_;
  const MjcfParts& parts_;
  ExportedMeshes& meshes_;
  const MujocoConfig& mujoco_;
  std::vector<PassiveJoint> passive_;
  std::vector<std::vector<int>> children_;
  std::map<std::string, MjcfText::Geom> geoms_;
};

std::string servo_of(const Joint& joint) {
  const std::string name = xml_escaped(joint.name);
  const std::string force = joint.effort > 0.0 && joint.effort < 1e9
                                ? exact_number(-joint.effort) + " " + exact_number(joint.effort)
                                : std::string();
  if (!(joint.kp > 0.0)) {
    return "    <motor name=\"" + name + "\" joint=\"" + name + "\"" +
           (force.empty() ? "" : " ctrlrange=\"" + force + "\"") + "/>\n";
  }
  return "    <position name=\"" + name + "\" joint=\"" + name + "\" kp=\"" + exact_number(joint.kp) + "\" kv=\"" +
         exact_number(joint.kd) + "\"" + (force.empty() ? "" : " forcerange=\"" + force + "\"") + "/>\n";
}

std::string urdf_shape(const Shape& shape, const char* kind, ExportedMeshes& meshes) {
  std::string geometry;
  switch (shape.kind) {
    case ShapeKind::kBox:
      geometry = "<box size=\"" + exact_numbers(shape.size) + "\"/>";
      break;
    case ShapeKind::kSphere:
      geometry = "<sphere radius=\"" + exact_number(shape.size[0]) + "\"/>";
      break;
    case ShapeKind::kCylinder:
      geometry = "<cylinder radius=\"" + exact_number(shape.size[0]) + "\" length=\"" + exact_number(shape.size[1]) + "\"/>";
      break;
    case ShapeKind::kMesh:
      geometry = "<mesh filename=\"meshes/" + meshes.name_of(shape) + ".obj\"/>";
      break;
  }
  return std::string("    <") + kind + ">" + urdf_origin(shape.pose) + "<geometry>" + geometry + "</geometry></" + kind +
         ">\n";
}

}  // namespace

std::string ExportedMeshes::name_of(const Shape& shape) {
  for (const auto& [name, known] : names_) {
    if (known.mesh == shape.mesh && known.size == shape.size) return name;
  }
  const std::string stem = std::filesystem::path(shape.mesh).stem().string();
  std::string name = stem;
  for (int i = 2; names_.count(name) != 0; ++i) name = stem + "_" + std::to_string(i);
  names_.emplace(name, shape);
  return name;
}

std::string mjcf_place(const Eigen::Isometry3d& place) {
  std::string text = "pos=\"" + exact_numbers(place.translation()) + "\"";
  if (place.linear().isIdentity(1e-15)) return text;
  const Eigen::Quaterniond q(place.linear());
  return text + " quat=\"" + exact_number(q.w()) + " " + exact_numbers(q.vec()) + "\"";
}

std::string mjcf_geom(const Shape& shape, const std::string& attributes, ExportedMeshes& meshes) {
  std::string kind;
  switch (shape.kind) {
    case ShapeKind::kBox:
      kind = "type=\"box\" size=\"" + exact_numbers(0.5 * shape.size) + "\"";
      break;
    case ShapeKind::kSphere:
      kind = "type=\"sphere\" size=\"" + exact_number(shape.size[0]) + "\"";
      break;
    case ShapeKind::kCylinder:
      kind = "type=\"cylinder\" size=\"" + exact_number(shape.size[0]) + " " + exact_number(0.5 * shape.size[1]) + "\"";
      break;
    case ShapeKind::kMesh:
      kind = "type=\"mesh\" mesh=\"" + xml_escaped(meshes.name_of(shape)) + "\"";
      break;
  }
  return "<geom " + kind + " " + mjcf_place(shape.pose) + " " + attributes + "/>";
}

MjcfText mjcf_of_model(const Model& model, const Eigen::Isometry3d& base, const MjcfContact& contact,
                       ExportedMeshes& meshes, const MjcfParts& parts) {
  MjcfText text;
  BodyWriter writer(model, contact, parts, meshes);
  writer.write(0, base, "    ", text.body);
  text.geoms = writer.geoms();
  for (const auto& [a, b] : model.disabled_pairs) {
    if (!(model.links[at(a)].mass > 0.0 && model.links[at(b)].mass > 0.0)) continue;  // may be part of the next body
    text.contact += "    <exclude body1=\"" + xml_escaped(model.links[at(a)].name) + "\" body2=\"" +
                    xml_escaped(model.links[at(b)].name) + "\"/>\n";
  }
  const std::vector<PassiveJoint> passive = passive_joints_of(model);
  for (const Joint& joint : model.joints) {
    if (joint.mimic < 0 || spring_among(passive, joint.child - 1) != nullptr) continue;
    text.equality += "    <joint joint1=\"" + xml_escaped(joint.name) + "\" joint2=\"" +
                     xml_escaped(model.joints[at(joint.mimic)].name) + "\" polycoef=\"" + exact_number(joint.mimic_offset) +
                     " " + exact_number(joint.mimic_multiplier) + " 0 0 0\"/>\n";
  }
  for (const int j : model.bus_joints) {
    if (parts.drives) text.actuator += servo_of(model.joints[at(j)]);
  }
  for (const char* sensor : {"gyro", "accelerometer"})
    text.sensor += std::string("    <") + sensor + " site=\"imu_sensor\" name=\"imu_" + sensor + "\"/>\n";
  text.sensor += "    <framequat objtype=\"site\" objname=\"imu_sensor\" name=\"imu_attitude\"/>\n";
  return text;
}

std::string urdf_of_model(const Model& model, ExportedMeshes& meshes) {
  std::string out = "<?xml version=\"1.0\"?>\n<!-- Written by `twinbus export`. -->\n<robot name=\"" +
                    xml_escaped(model.name) + "\" xmlns:drake=\"http://drake.mit.edu\">\n";
  std::string rotors;
  const std::vector<PassiveJoint> passive = passive_joints_of(model);
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[at(i)];
    out += "  <link name=\"" + xml_escaped(link.name) + "\">\n";
    if (link.mass > 0.0) {
      Eigen::Isometry3d com = Eigen::Isometry3d::Identity();
      com.translation() = link.com;
      const Eigen::Matrix3d& m = link.inertia;
      out += "    <inertial>" + urdf_origin(com) + "<mass value=\"" + exact_number(link.mass) + "\"/><inertia ixx=\"" +
             exact_number(m(0, 0)) + "\" ixy=\"" + exact_number(m(0, 1)) + "\" ixz=\"" + exact_number(m(0, 2)) + "\" iyy=\"" +
             exact_number(m(1, 1)) + "\" iyz=\"" + exact_number(m(1, 2)) + "\" izz=\"" + exact_number(m(2, 2)) +
             "\"/></inertial>\n";
    }
    for (const Shape& shape : link.collision) out += urdf_shape(shape, "collision", meshes);
    for (const Shape& shape : link.visual) out += urdf_shape(shape, "visual", meshes);
    out += "  </link>\n";
    for (const Frame& frame : model.frames) {
      if (frame.link != i || frame.name == link.name) continue;
      const std::string name = xml_escaped(frame.name);
      out += "  <link name=\"" + name + "\"/>\n  <joint name=\"" + name + "_fixed\" type=\"fixed\">" +
             urdf_origin(frame.in_link) + "<parent link=\"" + xml_escaped(link.name) + "\"/><child link=\"" + name +
             "\"/></joint>\n";
    }
  }
  for (const Joint& joint : model.joints) {
    const std::string name = xml_escaped(joint.name);
    const bool slide = joint.kind == JointKind::kPrismatic, endless = joint.kind == JointKind::kContinuous;
    out += "  <joint name=\"" + name + "\" type=\"" + (slide ? "prismatic" : endless ? "continuous" : "revolute") + "\">\n    " +
           urdf_origin(joint.placement) + "<parent link=\"" + xml_escaped(model.links[at(joint.parent)].name) +
           "\"/><child link=\"" + xml_escaped(model.links[at(joint.child)].name) + "\"/><axis xyz=\"" +
           exact_numbers(joint.axis) + "\"/>\n    <limit ";
    if (!endless) out += "lower=\"" + exact_number(joint.lower) + "\" upper=\"" + exact_number(joint.upper) + "\" ";
    out += "effort=\"" + exact_number(std::min(joint.effort, 1e9)) + "\" velocity=\"" +
           exact_number(std::min(joint.velocity, 1e9)) + "\"/><dynamics damping=\"" + exact_number(joint.damping) +
           "\" friction=\"" + exact_number(joint.friction) + "\"/>\n";
    if (joint.mimic >= 0 && spring_among(passive, joint.child - 1) == nullptr) {
      out += "    <mimic joint=\"" + xml_escaped(model.joints[at(joint.mimic)].name) + "\" multiplier=\"" +
             exact_number(joint.mimic_multiplier) + "\" offset=\"" + exact_number(joint.mimic_offset) + "\"/>\n";
    }
    out += "  </joint>\n";
    rotors += "  <transmission name=\"" + name + "_drive\"><type>transmission_interface/SimpleTransmission</type><joint name=\"" +
              name + "\"/><actuator name=\"" + name + "_motor\"><drake:gear_ratio value=\"1\"/><drake:rotor_inertia value=\"" +
              exact_number(joint.rotor_inertia) + "\"/></actuator></transmission>\n";
  }
  return out + rotors + "</robot>\n";
}

std::string obj_of(const Shape& mesh) {
  TriangleMesh triangles = load_mesh(mesh.mesh, mesh.size);
  if (mesh.size.prod() < 0.0) {
    for (auto& t : triangles.triangles) std::swap(t[1], t[2]);
  }
  return obj_text(triangles);
}

std::string obj_of_hull(const Shape& mesh) {
  const TriangleMesh hull = convex_hull(load_mesh(mesh.mesh, mesh.size).points);
  return hull.triangles.empty() ? obj_of(mesh) : obj_text(hull);
}

}  // namespace twinbus::robot
