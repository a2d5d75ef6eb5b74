#include "robot/mjcf/mjcf_parts.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "robot/mjcf/mjcf_surface.h"

namespace twinbus::inline robot {

namespace {

namespace fs = std::filesystem;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostMass = 1e6;   // [kg]
constexpr double kMostSize = 1e4;   // [m]
constexpr double kNoLength = 1e-10;

void note(const MjcfElement& element, const std::string& what, std::vector<std::string>& notes) {
  const std::string tail = ": " + what;
  const auto same = std::find_if(notes.begin(), notes.end(), [&](const std::string& said) {
    return said.ends_with(tail) && said.find(": " + element.name + " ") != std::string::npos;
  });
  if (same == notes.end()) {
    notes.push_back(*element.place.file + ":" + std::to_string(element.place.line) + ": " + element.title() + tail);
    return;
  }
  // One line for all that it is said of.
  std::string first = same->substr(0, same->size() - tail.size());
  int others = 1;
  const std::size_t counted = first.rfind(" and ");
  if (counted != std::string::npos && (first.ends_with(" others") || first.ends_with(" other"))) others = std::atoi(first.c_str() + counted + 5) + 1;
  if (others > 1) first.resize(counted);
  *same = first + " and " + std::to_string(others) + (others > 1 ? " others" : " other") + tail;
}

// The two ends of a capsule, cylinder, box or ellipsoid: its place and half length.
void read_fromto(const MjcfElement& element, const Eigen::Isometry3d& frame, MjcfGeom& geom) {
  const std::vector<double> v = element.numbers("fromto", 6, 6, kMjcfFarthest);
  if (v.empty()) return;
  if (geom.kind != MjcfGeomKind::kCapsule && geom.kind != MjcfGeomKind::kCylinder && geom.kind != MjcfGeomKind::kBox &&
      geom.kind != MjcfGeomKind::kEllipsoid)
    element.fail("fromto", "is for capsule, cylinder, box and ellipsoid only");
  const Eigen::Vector3d a(v[0], v[1], v[2]), b(v[3], v[4], v[5]);
  if (!((b - a).norm() > kNoLength)) element.fail("fromto", "has two equal ends");
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() = 0.5 * (a + b);
  // MuJoCo turns z from the second end to the first.
  place.linear() = rotation_of_z((a - b).normalized());
  geom.place = frame * place;
  const double half = 0.5 * (b - a).norm();
  if (geom.kind == MjcfGeomKind::kCapsule || geom.kind == MjcfGeomKind::kCylinder) {
    geom.size[1] = half;
  } else {
    geom.size[1] = geom.size[0];
    geom.size[2] = half;
  }
}

int sizes_of(MjcfGeomKind kind) {
  switch (kind) {
    case MjcfGeomKind::kSphere:
      return 1;
    case MjcfGeomKind::kCapsule:
    case MjcfGeomKind::kCylinder:
      return 2;
    case MjcfGeomKind::kEllipsoid:
    case MjcfGeomKind::kBox:
      return 3;
    default:
      return 0;
  }
}

double effort_of(const MjcfElement& element, const std::string& limited, const std::string& range,
                 const MjcfCompiler& compiler) {
  double lower = 0.0, upper = 0.0;
  if (!read_mjcf_limit(element, limited, range, compiler, lower, upper)) return kInfinity;
  return std::max(std::abs(lower), std::abs(upper));
}

}  // namespace

bool read_mjcf_limit(const MjcfElement& element, const std::string& limited, const std::string& range,
                     const MjcfCompiler& compiler, double& lower, double& upper) {
  const std::vector<double> values = element.numbers(range, 2, 2, kMjcfLargest);
  const std::size_t said = element.choice(limited, {"false", "true", "auto"}, 2);
  const bool there = !values.empty() && values[0] < values[1];
  if (said == 2 && there && !compiler.autolimits)
    element.fail(range, "is given, but not " + limited + ", and the compiler's autolimits is false; write " + limited);
  if (said == 1 && !there) element.fail(limited, "is true, but " + range + " has no lower and larger upper number");
  if (!values.empty() && values[0] > values[1]) element.fail(range, "is upside down; exchange the numbers");
  if (said == 0 || !there) return false;
  lower = values[0];
  upper = values[1];
  return true;
}

MjcfJoint read_mjcf_joint(const MjcfElement& element, const MjcfCompiler& compiler, const Eigen::Isometry3d& frame,
                          std::vector<std::string>& notes) {
  MjcfJoint joint;
  joint.element = element;
  joint.name = element.text("name");
  if (element.name == "freejoint") {
    joint.kind = MjcfJointKind::kFree;
    return joint;
  }
  // "free ball slide hinge", MuJoCo's default is the last.
  const std::size_t type = element.choice("type", {"hinge", "slide", "ball", "free"}, 0);
  joint.kind = static_cast<MjcfJointKind>(type);
  if (joint.kind == MjcfJointKind::kFree) {
    for (const char* key : {"armature", "damping", "frictionloss", "stiffness"}) {
      if (element.number(key, 0.0, 0.0, 1e9) > 0.0)
        note(element, std::string("the free joint's ") + key + " is not modelled", notes);
    }
    return joint;
  }
  joint.anchor = frame * element.vector("pos", Eigen::Vector3d::Zero(), kMjcfFarthest);
  const Eigen::Vector3d axis = element.vector("axis", Eigen::Vector3d::UnitZ(), kMjcfLargest);
  if (!(axis.norm() > kNoLength)) element.fail("axis", "has no length; write for example 0 0 1");
  joint.axis = frame.linear() * axis.normalized();
  const bool hinge = joint.kind == MjcfJointKind::kHinge;
  if (joint.kind != MjcfJointKind::kBall) {
    joint.limited = read_mjcf_limit(element, "limited", "range", compiler, joint.lower, joint.upper);
    joint.ref = element.number("ref", 0.0, -1e6, 1e6);
    if (hinge) {
      for (double* angle : {&joint.lower, &joint.upper, &joint.ref}) *angle = compiler.angle(*angle);
    }
  }
  joint.armature = element.number("armature", 0.0, 0.0, 1e6);
  joint.frictionloss = element.number("frictionloss", 0.0, 0.0, 1e6);
  // Since MuJoCo 3.5 these two may be polynomials; what is beyond the first number is not modelled.
  for (const auto& [key, into] : {std::pair{"damping", &joint.damping}, std::pair{"stiffness", &joint.stiffness}}) {
    const std::vector<double> values = element.numbers(key, 1, 8, 1e9);
    if (values.empty()) continue;
    if (values[0] < 0.0) element.fail(key, "must not be negative");
    *into = values[0];
    if (std::any_of(values.begin() + 1, values.end(), [](double v) { return v != 0.0; }))
      note(element, std::string("of ") + key + " only the linear part is modelled", notes);
  }
  if (joint.stiffness > 0.0) note(element, "its spring (stiffness) is not modelled", notes);
  if (element.has("springdamper"))
    note(element, "springdamper is not modelled: neither its spring nor its damping", notes);
  joint.effort = effort_of(element, "actuatorfrclimited", "actuatorfrcrange", compiler);
  return joint;
}

MjcfGeom read_mjcf_geom(const MjcfElement& element, const MjcfCompiler& compiler, const Eigen::Isometry3d& frame,
                        const std::vector<MjcfMesh>& meshes) {
  MjcfGeom geom;
  geom.element = element;
  geom.name = element.text("name");
  geom.kind = static_cast<MjcfGeomKind>(element.choice(
      "type", {"plane", "hfield", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "sdf"}, 2));
  const std::vector<double> size = element.numbers("size", 1, 3, kMostSize);
  for (std::size_t i = 0; i < size.size(); ++i) geom.size[static_cast<Eigen::Index>(i)] = size[i];
  geom.place = frame * read_place(element, compiler);
  read_fromto(element, frame, geom);
  if (const std::string mesh = element.text("mesh"); !mesh.empty()) {
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      if (meshes[i].name == mesh) geom.mesh = static_cast<int>(i);
    }
    if (geom.mesh < 0) element.fail("mesh", mesh.substr(0, 60) + " is no mesh of <asset>; add it");
  } else if (geom.kind == MjcfGeomKind::kMesh || geom.kind == MjcfGeomKind::kSdf) {
    element.fail("type mesh needs mesh=\"...\"");
  }
  if (geom.mesh < 0) {
    for (int i = 0; i < sizes_of(geom.kind); ++i) {
      if (!(geom.size[i] > 0.0)) element.fail("size", "must be positive: number " + std::to_string(i + 1) + " is not");
    }
  }
  geom.touches = element.whole("contype", 1) != 0 || element.whole("conaffinity", 1) != 0;
  geom.group = element.whole("group", 0);
  geom.surface = read_mjcf_surface(element);
  geom.friction = geom.surface.contact.friction[0];
  geom.mass = element.number("mass", geom.mass, 0.0, kMostMass);
  geom.density = element.number("density", geom.density, 0.0, 1e9);
  return geom;
}

MjcfSite read_mjcf_site(const MjcfElement& element, const MjcfCompiler& compiler, const Eigen::Isometry3d& frame) {
  return {element.text("name"), frame * read_place(element, compiler)};
}

MjcfInertia read_mjcf_inertial(const MjcfElement& element, const MjcfCompiler& compiler, const Eigen::Isometry3d& frame) {
  MjcfInertia inertia;
  if (!element.has("mass")) element.fail("has no mass; add mass=\"...\"");
  inertia.mass = element.number("mass", 0.0, 0.0, kMostMass);
  if (!element.has("pos")) element.fail("has no pos, the centre of mass; add pos=\"0 0 0\"");
  const Eigen::Isometry3d place = frame * read_place(element, compiler);
  inertia.com = place.translation();
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  const std::vector<double> full = element.numbers("fullinertia", 6, 6, kMjcfLargest);
  if (!full.empty()) {
    own << full[0], full[3], full[4], full[3], full[1], full[5], full[4], full[5], full[2];
  } else {
    own.diagonal() = element.vector("diaginertia", Eigen::Vector3d::Zero(), kMjcfLargest);
  }
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(own, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(moments[0] >= -1e-9 * std::abs(moments[2])))
    element.fail("the inertia is not that of a body: a principal moment is negative; take it from CAD");
  inertia.about_com = place.linear() * own * place.linear().transpose();
  return inertia;
}

MjcfMesh read_mjcf_mesh(const MjcfElement& element, const MjcfCompiler& compiler, const std::string& folder) {
  MjcfMesh mesh;
  mesh.element = element;
  std::string file = element.text("file");
  mesh.name = element.text("name", fs::path(file).stem().string());
  if (mesh.name.empty()) element.fail("has neither name nor file");
  mesh.scale = element.vector("scale", mesh.scale, 1e6);
  if ((mesh.scale.array() == 0.0).any()) element.fail("scale", "must not be 0");
  mesh.ref.translation() = element.vector("refpos", Eigen::Vector3d::Zero(), kMjcfFarthest);
  const std::vector<double> q = element.numbers("refquat", 4, 4, 1e6);
  if (!q.empty()) {
    const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
    if (!(turn.norm() > kNoLength)) element.fail("refquat", "has no length");
    mesh.ref.linear() = turn.normalized().toRotationMatrix();
  }
  mesh.inertia = static_cast<int>(element.choice("inertia", {"convex", "exact", "legacy", "shell"}, 2));
  if (!file.empty()) {
    if (compiler.strip_path) file = fs::path(file).filename().string();
    const fs::path path(file);
    mesh.file = (path.is_absolute() ? path : fs::path(folder) / compiler.mesh_folder / path).lexically_normal().string();
    return mesh;
  }
  const std::vector<double> vertex = element.numbers("vertex", 3, 3'000'000, kMjcfFarthest);
  for (std::size_t i = 0; i + 2 < vertex.size(); i += 3)
    mesh.points.emplace_back(vertex[i], vertex[i + 1], vertex[i + 2]);
  return mesh;
}

bool read_mjcf_actuator(const MjcfElement& element, const MjcfCompiler& compiler, MjcfActuator& actuator,
                        std::vector<std::string>& notes) {
  actuator.element = element;
  actuator.joint = element.text("joint", element.text("jointinparent"));
  if (actuator.joint.empty()) {
    const char* what = element.has("tendon") ? "a tendon" : element.has("site") ? "a site" : "no joint";
    note(element, std::string("drives ") + what + ": left out", notes);
    return false;
  }
  const std::vector<double> gears = element.numbers("gear", 1, 6, 1e9);
  const double gear = gears.empty() ? 1.0 : gears[0];
  if (gear == 0.0) {
    note(element, "its gear is 0, so it drives nothing: left out", notes);
    return false;
  }
  double gain = 1.0;
  const std::string& kind = element.name;
  if (kind == "position" || (kind == "general" && !element.has("gainprm") && element.has("kp"))) {
    gain = actuator.kp = element.number("kp", 1.0, 0.0, 1e9);
    actuator.kd = element.number("kv", 0.0, 0.0, 1e9);
    if (element.has("dampratio")) note(element, "dampratio is not read: its damping is proposed instead", notes);
  } else if (kind == "velocity") {
    gain = actuator.kd = element.number("kv", 1.0, 0.0, 1e9);
  } else if (kind == "general") {
    const std::vector<double> gains = element.numbers("gainprm", 1, 20, kMjcfLargest);
    if (!gains.empty()) gain = gains[0];
    const std::size_t bias_type = element.choice("biastype", {"none", "affine", "muscle", "user", "dcmotor"}, 0);
    if (bias_type > 1 || element.choice("gaintype", {"fixed", "affine", "muscle", "user", "dcmotor"}, 0) != 0) {
      note(element, "its force law is not read: left out", notes);
      return false;
    }
    const std::vector<double> bias = element.numbers("biasprm", 1, 20, kMjcfLargest);
    if (bias_type == 1 && bias.size() > 1) actuator.kp = std::max(0.0, -bias[1]);
    if (bias_type == 1 && bias.size() > 2) actuator.kd = std::max(0.0, -bias[2]);
  } else if (kind != "motor") {
    note(element, "an actuator of kind " + kind + " is not modelled: left out", notes);
    return false;
  }
  if (element.text("dyntype", "none") != "none" || element.number("timeconst", 0.0, 0.0, 1e6) > 0.0)
    note(element, "its filter is not modelled", notes);
  for (const char* key : {"damping", "armature"}) {
    if (element.has(key)) note(element, std::string("its own ") + key + " is not read", notes);
  }
  actuator.effort = std::abs(gear) * effort_of(element, "forcelimited", "forcerange", compiler);
  if (kind == "motor" || (kind == "general" && actuator.kp == 0.0 && actuator.kd == 0.0)) {
    const double most = effort_of(element, "ctrllimited", "ctrlrange", compiler);
    actuator.effort = std::min(actuator.effort, std::abs(gear * gain) * most);
  }
  actuator.kp *= gear * gear;
  actuator.kd *= gear * gear;
  return true;
}

}  // namespace twinbus::robot
