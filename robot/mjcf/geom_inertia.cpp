#include "robot/mjcf/geom_inertia.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "common/math/index.h"
#include "geometry/bounds/convex_hull.h"
#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline robot {

namespace {

using std::numbers::pi;

// Of a body of density 1 about its middle, and its volume.
struct Moments {
  double volume = 0.0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

Moments of_ellipsoid(const Eigen::Vector3d& radius) {
  Moments m;
  m.volume = 4.0 / 3.0 * pi * radius.prod();
  const Eigen::Vector3d square = radius.cwiseAbs2();
  m.inertia.diagonal() =
      m.volume / 5.0 * Eigen::Vector3d(square.y() + square.z(), square.z() + square.x(), square.x() + square.y());
  return m;
}

Moments of_box(const Eigen::Vector3d& half) {
  Moments m;
  m.volume = 8.0 * half.prod();
  const Eigen::Vector3d square = half.cwiseAbs2();
  m.inertia.diagonal() =
      m.volume / 3.0 * Eigen::Vector3d(square.y() + square.z(), square.z() + square.x(), square.x() + square.y());
  return m;
}

Moments of_cylinder(double radius, double half) {
  Moments m;
  const double length = 2.0 * half;
  m.volume = pi * radius * radius * length;
  const double across = m.volume * (3.0 * radius * radius + length * length) / 12.0;
  m.inertia.diagonal() << across, across, 0.5 * m.volume * radius * radius;
  return m;
}

Moments of_capsule(double radius, double half) {
  Moments m = of_cylinder(radius, half);
  const double length = 2.0 * half;
  const double ball = 4.0 / 3.0 * pi * radius * radius * radius;  // of both ends
  // Each half ball has its middle 3/8 of the radius beyond the end.
  const double across = ball * (0.4 * radius * radius + 0.25 * length * length + 0.375 * length * radius);
  m.inertia.diagonal() += Eigen::Vector3d(across, across, 0.4 * ball * radius * radius);
  m.volume += ball;
  return m;
}

double triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, Eigen::Vector3d& normal) {
  normal = (b - a).cross(c - a);
  const double twice = normal.norm();
  if (twice > 0.0) normal /= twice;
  return 0.5 * twice;
}

// Tetrahedra between each triangle and the middle of all faces, then about the middle of the body:
//   P_jk = sum V / 20 (2 sum_i d_i d_i^T + sum_{i != k} d_i d_k^T),  I = tr(P) 1 - P
Moments of_triangles(const TriangleMesh& mesh, bool same_sign, const MjcfGeom& geom) {
  Eigen::Vector3d faces = Eigen::Vector3d::Zero(), normal;
  double area = 0.0;
  const auto point = [&](int i) -> const Eigen::Vector3d& { return mesh.points[at(i)]; };
  for (const auto& t : mesh.triangles) {
    const double a = triangle(point(t[0]), point(t[1]), point(t[2]), normal);
    faces += a / 3.0 * (point(t[0]) + point(t[1]) + point(t[2]));
    area += a;
  }
  if (!(area > 0.0)) geom.element.fail("mesh", "has no area, so no mass follows from it; give the body an <inertial>");
  faces /= area;
  Moments m;
  for (const auto& t : mesh.triangles) {
    const double a = triangle(point(t[0]), point(t[1]), point(t[2]), normal);
    const Eigen::Vector3d centre = (point(t[0]) + point(t[1]) + point(t[2])) / 3.0;
    double volume = (centre - faces).dot(normal) * a / 3.0;
    if (same_sign) volume = std::abs(volume);
    m.volume += volume;
    m.middle += volume * (0.75 * centre + 0.25 * faces);
  }
  if (!(m.volume > 1e-15)) geom.element.fail("mesh", "has no volume, so no mass follows from it; give the body an <inertial>");
  m.middle /= m.volume;
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  double total = 0.0;
  for (const auto& t : mesh.triangles) {
    const std::array<Eigen::Vector3d, 3> d = {point(t[0]) - m.middle, point(t[1]) - m.middle, point(t[2]) - m.middle};
    const double a = triangle(d[0], d[1], d[2], normal);
    double volume = ((d[0] + d[1] + d[2]) / 3.0).dot(normal) * a / 3.0;
    if (same_sign) volume = std::abs(volume);
    total += volume;
    const Eigen::Vector3d sum = d[0] + d[1] + d[2];
    products += volume / 20.0 *
                (sum * sum.transpose() + d[0] * d[0].transpose() + d[1] * d[1].transpose() + d[2] * d[2].transpose());
  }
  m.inertia = products.trace() * Eigen::Matrix3d::Identity() - products;
  m.volume = total;
  return m;
}

// In the geom's frame.
Moments of_mesh(const MjcfGeom& geom, const MjcfModel& model) {
  const MjcfMesh& asset = model.meshes[at(geom.mesh)];
  if (geom.kind != MjcfGeomKind::kMesh)
    geom.element.fail("a " + geom.element.text("type") + " fitted to a mesh gives no mass here; give the body an <inertial>");
  if (asset.inertia == 3) geom.element.fail("mesh", "has inertia=\"shell\", which is not read; give the body an <inertial>");
  TriangleMesh mesh;
  if (asset.file.empty()) {
    mesh = convex_hull(asset.points);
  } else {
    try {
      mesh = load_mesh(asset.file, Eigen::Vector3d::Ones());
    } catch (const std::runtime_error& error) {
      asset.element.fail(std::string("the mesh is needed for the mass of a body: ") + error.what());
    }
  }
  for (Eigen::Vector3d& p : mesh.points)
    p = (asset.ref.linear().transpose() * (p - asset.ref.translation())).cwiseProduct(asset.scale);
  if (asset.scale.prod() < 0.0) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  if (asset.inertia == 0) mesh = convex_hull(mesh.points);
  return of_triangles(mesh, asset.inertia == 2, geom);
}

Moments of_geom(const MjcfGeom& geom, const MjcfModel& model) {
  if (geom.mesh >= 0) return of_mesh(geom, model);
  switch (geom.kind) {
    case MjcfGeomKind::kSphere:
      return of_ellipsoid(Eigen::Vector3d::Constant(geom.size[0]));
    case MjcfGeomKind::kEllipsoid:
      return of_ellipsoid(geom.size);
    case MjcfGeomKind::kBox:
      return of_box(geom.size);
    case MjcfGeomKind::kCylinder:
      return of_cylinder(geom.size[0], geom.size[1]);
    case MjcfGeomKind::kCapsule:
      return of_capsule(geom.size[0], geom.size[1]);
    default:
      return {};
  }
}

}  // namespace

MjcfInertia geom_inertia(const MjcfGeom& geom, const MjcfModel& model) {
  if (geom.mass == 0.0 || (std::isnan(geom.mass) && geom.density == 0.0)) return {};
  if (geom.element.flag("shellinertia", false) && geom.kind != MjcfGeomKind::kPlane)
    geom.element.fail("shellinertia", "is not read; give the body an <inertial>");
  const Moments m = of_geom(geom, model);
  if (!(m.volume > 0.0)) return {};
  const double density = std::isnan(geom.mass) ? geom.density : geom.mass / m.volume;
  MjcfInertia inertia;
  inertia.mass = density * m.volume;
  inertia.com = geom.place * m.middle;
  inertia.about_com = density * geom.place.linear() * m.inertia * geom.place.linear().transpose();
  return inertia;
}

MjcfInertia sum_of(const MjcfInertia& a, const MjcfInertia& b) {
  if (!(a.mass > 0.0)) return b;
  if (!(b.mass > 0.0)) return a;
  MjcfInertia sum;
  sum.mass = a.mass + b.mass;
  sum.com = (a.mass * a.com + b.mass * b.com) / sum.mass;
  for (const MjcfInertia* part : {&a, &b}) {
    const Eigen::Vector3d d = part->com - sum.com;
    sum.about_com += part->about_com + part->mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
  }
  return sum;
}

MjcfInertia body_inertia(const MjcfBody& body, const MjcfModel& model) {
  const MjcfCompiler& compiler = model.compiler;
  const bool from_geoms = compiler.inertia == InertiaFromGeom::kAlways ||
                          (compiler.inertia == InertiaFromGeom::kIfMissing && !body.has_inertial);
  MjcfInertia inertia;
  if (from_geoms) {
    for (const MjcfGeom& geom : body.geoms) {
      if (geom.group >= compiler.first_group && geom.group <= compiler.last_group)
        inertia = sum_of(inertia, geom_inertia(geom, model));
    }
  } else if (body.has_inertial) {
    inertia = body.inertia;
  }
  inertia.mass = std::max(inertia.mass, compiler.least_mass);
  if (!compiler.balance_inertia && !(compiler.least_inertia > 0.0)) return inertia;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia.about_com);
  Eigen::Vector3d moments = axes.eigenvalues().cwiseMax(compiler.least_inertia);
  // Three moments that no body has become their mean.
  if (compiler.balance_inertia && moments[0] + moments[1] < moments[2]) moments.setConstant(moments.mean());
  inertia.about_com = axes.eigenvectors() * moments.asDiagonal() * axes.eigenvectors().transpose();
  return inertia;
}

}  // namespace twinbus::robot
