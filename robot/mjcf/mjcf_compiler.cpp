#include "robot/mjcf/mjcf_compiler.h"

#include <numbers>

#include "common/math/pose_math.h"

namespace twinbus::inline robot {

namespace {

constexpr double kShort = 1e-10;  // a direction of no more says nothing

Eigen::Vector3d direction(const MjcfElement& element, const std::string& key, const Eigen::Vector3d& v) {
  if (!(v.norm() > kShort)) element.fail(key, "has no length; give a direction");
  return v.normalized();
}

Eigen::Matrix3d from_euler(const Eigen::Vector3d& angles, const std::string& sequence) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const char letter = sequence[static_cast<std::size_t>(i)];
    const char axis = static_cast<char>(letter | 0x20);
    const Eigen::Matrix3d one = rotation_about(Eigen::Vector3d::Unit(axis - 'x'), angles[i]);
    // Small letters turn about the axes that move, capitals about those that do not.
    rotation = letter == axis ? Eigen::Matrix3d(rotation * one) : Eigen::Matrix3d(one * rotation);
  }
  return rotation;
}

void read_one(const MjcfElement& element, MjcfCompiler& c) {
  if (element.choice("coordinate", {"local", "global"}, 0) == 1)
    element.fail("coordinate", "global is not read, nor by MuJoCo since 2.3; save the model anew with an older MuJoCo");
  c.degrees = element.choice("angle", {"radian", "degree"}, c.degrees ? 1 : 0) == 1;
  c.autolimits = element.flag("autolimits", c.autolimits);
  c.strip_path = element.flag("strippath", c.strip_path);
  c.balance_inertia = element.flag("balanceinertia", c.balance_inertia);
  c.eulerseq = element.text("eulerseq", c.eulerseq);
  if (c.eulerseq.size() != 3 || c.eulerseq.find_first_not_of("xyzXYZ") != std::string::npos)
    element.fail("eulerseq", "must be three of the letters xyzXYZ");
  c.mesh_folder = element.text("meshdir", element.text("assetdir", c.mesh_folder));
  c.inertia = static_cast<InertiaFromGeom>(
      element.choice("inertiafromgeom", {"false", "true", "auto"}, static_cast<std::size_t>(c.inertia)));
  const std::vector<double> groups = element.numbers("inertiagrouprange", 2, 2, 1e6);
  if (!groups.empty()) {
    c.first_group = static_cast<int>(groups[0]);
    c.last_group = static_cast<int>(groups[1]);
  }
  c.total_mass = element.number("settotalmass", c.total_mass, -1e6, 1e6);
  c.least_mass = element.number("boundmass", c.least_mass, 0.0, 1e6);
  c.least_inertia = element.number("boundinertia", c.least_inertia, 0.0, 1e6);
}

}  // namespace

double MjcfCompiler::angle(double value) const noexcept { return degrees ? value * std::numbers::pi / 180.0 : value; }

MjcfCompiler read_compiler(const MjcfElement& mujoco) {
  MjcfCompiler compiler;
  for (const MjcfElement& element : mujoco.children) {
    if (element.name == "compiler") read_one(element, compiler);
  }
  return compiler;
}

Eigen::Matrix3d rotation_of_z(const Eigen::Vector3d& z) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z).toRotationMatrix();
}

Eigen::Matrix3d read_orientation(const MjcfElement& element, const MjcfCompiler& compiler) {
  // The first one counts: an element's own attributes come before those of its class.
  for (const MjcfAttribute& attribute : element.attributes) {
    const std::string& key = attribute.name;
    if (key == "quat") break;
    if (key == "euler") {
      Eigen::Vector3d angles = element.vector(key, Eigen::Vector3d::Zero(), 1e6);
      for (double& angle : angles) angle = compiler.angle(angle);
      return from_euler(angles, compiler.eulerseq);
    }
    if (key == "axisangle") {
      const std::vector<double> v = element.numbers(key, 4, 4, 1e6);
      return rotation_about(direction(element, key, {v[0], v[1], v[2]}), compiler.angle(v[3]));
    }
    if (key == "zaxis") return rotation_of_z(direction(element, key, element.vector(key, Eigen::Vector3d::Zero(), 1e6)));
    if (key == "xyaxes") {
      const std::vector<double> v = element.numbers(key, 6, 6, 1e6);
      const Eigen::Vector3d x = direction(element, key, {v[0], v[1], v[2]});
      const Eigen::Vector3d y(v[3], v[4], v[5]);
      Eigen::Matrix3d axes;
      axes.col(0) = x;
      axes.col(1) = direction(element, key, y - x.dot(y) * x);
      axes.col(2) = x.cross(axes.col(1));
      return axes;
    }
  }
  const std::vector<double> q = element.numbers("quat", 4, 4, 1e6);
  if (q.empty()) return Eigen::Matrix3d::Identity();
  const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
  if (!(quaternion.norm() > kShort)) element.fail("quat", "has no length; write 1 0 0 0");
  return quaternion.normalized().toRotationMatrix();
}

Eigen::Isometry3d read_place(const MjcfElement& element, const MjcfCompiler& compiler) {
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() = element.vector("pos", Eigen::Vector3d::Zero(), kMjcfFarthest);
  place.linear() = read_orientation(element, compiler);
  return place;
}

}  // namespace twinbus::robot
