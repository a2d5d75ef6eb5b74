#include "robot/mjcf/urdf_shapes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "common/math/index.h"
#include "common/text/xml.h"
#include "geometry/mesh/mesh_file.h"
#include "robot/mjcf/urdf_text.h"

namespace twinbus::inline robot {

namespace {

namespace fs = std::filesystem;

class ShapeWriter {
 public:
  ShapeWriter(const MjcfGeom& geom, const MjcfModel& model, const Eigen::Isometry3d& in_link, std::string& urdf,
              std::vector<std::string>& notes)
      : geom_(geom), model_(model), place_(in_link * geom.place), urdf_(urdf), notes_(notes) {}

  void write() {
    const Eigen::Vector3d& size = geom_.size;
    if (geom_.mesh >= 0) {
      write_mesh(model_.meshes[at(geom_.mesh)]);
      return;
    }
    switch (geom_.kind) {
      case MjcfGeomKind::kSphere:
        add(place_, ball(size[0]));
        break;
      case MjcfGeomKind::kBox:
        add(place_, box(2.0 * size));
        break;
      case MjcfGeomKind::kCylinder:
        add(place_, cylinder(size[0], size[1]));
        break;
      case MjcfGeomKind::kCapsule:
        add(place_, cylinder(size[0], size[1]));
        for (const double end : {size[1], -size[1]})
          add(place_ * Eigen::Translation3d(0.0, 0.0, end), ball(size[0]));
        break;
      case MjcfGeomKind::kEllipsoid:
        add(place_, box(2.0 * size));
        if (geom_.touches) tell("an ellipsoid touches as the box around it");
        break;
      case MjcfGeomKind::kPlane:
      case MjcfGeomKind::kHeightField:
        tell("a plane or height field is no part of a robot: left out");
        break;
      default:
        break;
    }
  }

 private:
  static std::string ball(double radius) { return "<sphere radius=\"" + exact_number(radius) + "\"/>"; }
  static std::string box(const Eigen::Vector3d& edges) { return "<box size=\"" + exact_numbers(edges) + "\"/>"; }
  static std::string cylinder(double radius, double half) {
    return "<cylinder radius=\"" + exact_number(radius) + "\" length=\"" + exact_number(2.0 * half) + "\"/>";
  }

  void add(const Eigen::Isometry3d& place, const std::string& shape) {
    const std::string kind = geom_.touches ? "collision" : "visual";
    urdf_ += "    <" + kind + ">\n      " + urdf_origin(place) + "\n      <geometry>" + shape + "</geometry>\n    </" + kind +
             ">\n";
  }

  void tell(const std::string& what) {
    notes_.push_back(*geom_.element.place.file + ":" + std::to_string(geom_.element.place.line) + ": " +
                     geom_.element.title() + ": " + what);
  }

  // What a mesh that cannot be used means: nothing for what is only seen.
  void miss(const MjcfMesh& mesh, const std::string& why) {
    if (geom_.touches) mesh.element.fail(why);
    notes_.push_back("mesh " + mesh.name + ", only seen, is left out: " + why);
  }

  void write_mesh(const MjcfMesh& mesh) {
    const bool fitted = geom_.kind != MjcfGeomKind::kMesh;
    if (geom_.kind == MjcfGeomKind::kSdf) {
      miss(mesh, "a shape of a signed distance field is not read; use type=\"mesh\"");
      return;
    }
    if (mesh.file.empty() && mesh.points.empty()) {
      miss(mesh, "a mesh that MuJoCo builds by itself (builtin) is not read; save it as STL or OBJ");
      return;
    }
    if (!mesh.file.empty() && !readable(mesh)) return;
    if (mesh.file.empty() || (fitted && geom_.touches)) {
      write_box_around(mesh);
      return;
    }
    // v' = S R^T (v - p): as a place and a scale, if R is none or S the same along all axes.
    const bool turned = !mesh.ref.linear().isIdentity(1e-9);
    if (turned && !mesh.scale.isApproxToConstant(mesh.scale.x())) {
      miss(mesh, "refquat and a scale that differs along the axes together are not read; apply them to the file");
      return;
    }
    Eigen::Isometry3d ref = Eigen::Isometry3d::Identity();
    ref.linear() = mesh.ref.linear().transpose();
    ref.translation() = -(ref.linear() * mesh.scale.cwiseProduct(mesh.ref.translation()));
    const fs::path relative = fs::path(mesh.file).lexically_relative(model_.folder);
    std::string shape = "<mesh filename=\"" + xml_escaped(relative.generic_string()) + "\"";
    if (!mesh.scale.isApproxToConstant(1.0)) shape += " scale=\"" + exact_numbers(mesh.scale) + "\"";
    add(place_ * ref, shape + "/>");
  }

  bool readable(const MjcfMesh& mesh) {
    std::string ending = fs::path(mesh.file).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    std::error_code error;
    if (!fs::is_regular_file(mesh.file, error)) {
      miss(mesh, mesh.file + " is not there; copy it, or correct meshdir");
      return false;
    }
    if (ending != ".stl" && ending != ".obj" && ending != ".dae") {
      miss(mesh, "files " + ending + " are not read; save the mesh as STL or OBJ");
      return false;
    }
    return true;
  }

  void write_box_around(const MjcfMesh& mesh) {
    std::vector<Eigen::Vector3d> points = mesh.points;
    if (!mesh.file.empty()) points = load_mesh(mesh.file, Eigen::Vector3d::Ones()).points;
    Eigen::AlignedBox3d around;
    for (const Eigen::Vector3d& p : points)
      around.extend((mesh.ref.linear().transpose() * (p - mesh.ref.translation())).cwiseProduct(mesh.scale));
    if (geom_.touches) tell("its mesh touches as the box around it");
    add(place_ * Eigen::Translation3d(around.center()), box(around.sizes().cwiseMax(1e-4)));
  }

  const MjcfGeom& geom_;
  const MjcfModel& model_;
  Eigen::Isometry3d place_;
  std::string& urdf_;
  std::vector<std::string>& notes_;
};

}  // namespace

void append_urdf_shapes(const MjcfGeom& geom, const MjcfModel& model, const Eigen::Isometry3d& in_link,
                        std::string& urdf, std::vector<std::string>& notes) {
  ShapeWriter(geom, model, in_link, urdf, notes).write();
}

}  // namespace twinbus::robot
