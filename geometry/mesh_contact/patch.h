// A contact as the area over which two surfaces press one another: sections 3.3.1 and 3.3.2 of the paper, with areas as
// weights.
//
// Under one constraint, the direction n, the surface of A that faces B lies below the surface of B that faces A over some
// area, whose corners are the paper's points of interference.  The depth over it is fitted by least squares, every
// part of the area with the same weight, and carried by four points,
//
//     x = middle + L s,  s = (+-1, +-1),  L L' = spread of the area,   each with a quarter of the area
//
// which have the area's moments up to the second: a law that is linear in the depth gives the force and moment of
// the whole area.  However many corners there are, however surfaces are cut into triangles or tiles, the result is the
// same, and it changes continuously with the poses.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "geometry/mesh_contact/contact_mesh.h"

namespace twinbus::inline geometry {

// offset + slope.x, over the plane of a patch.
struct LinearField {
  double offset = 0.0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double at(const Eigen::Vector2d& x) const noexcept { return offset + slope.dot(x); }
};
inline LinearField operator-(const LinearField& a, const LinearField& b) noexcept {
  return {a.offset - b.offset, a.slope - b.slope};
}

// Convex, counter-clockwise.
struct PatchPolygon {
  static constexpr int kMost = 32;
  std::array<Eigen::Vector2d, kMost> corner;
  int count = 0;

  void add(const Eigen::Vector2d& x) noexcept {
    if (count < kMost) corner[static_cast<std::size_t>(count++)] = x;
  }
  // Cuts away where the field is negative.
  void keep(const LinearField& field) noexcept;
};

// Of an area, about the origin of its plane.
struct PatchMoments {
  double area = 0.0;                                // [m^2]
  Eigen::Vector2d first = Eigen::Vector2d::Zero();  // integral of x [m^3]
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();  // of x x' [m^4]
};
PatchMoments moments_of(const PatchPolygon& polygon) noexcept;
// Of the same area where x is `turn` times what it was; turn must not mirror it.
PatchMoments mapped(const PatchMoments& moments, const Eigen::Matrix2d& turn) noexcept;

struct PatchPoint {
  Eigen::Vector3d position;  // half way between the two surfaces [m]
  double depth = 0.0;        // [m]; of a fit, may be a little below zero
};

struct Patch {
  static constexpr int kPoints = 4;
  double area = 0.0;    // [m^2]
  double volume = 0.0;  // of the depth over the area [m^3]
  double rough = 0.0;   // of the squared depth, what the fit has lost [m^4]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // from B to A
  std::array<PatchPoint, kPoints> point;
};

// Axes of a patch: x and y across the normal, from an origin that should be near it.
struct PatchFrame {
  Eigen::Vector3d origin, x, y, normal;
  PatchFrame(const Eigen::Vector3d& at, const Eigen::Vector3d& n) noexcept;
  Eigen::Vector2d across(const Eigen::Vector3d& point) const noexcept {
    return {x.dot(point - origin), y.dot(point - origin)};
  }
  double height(const Eigen::Vector3d& point) const noexcept { return normal.dot(point - origin); }
};

// Of a ball that is so deep in something flat or of another radius, in closed form: the cap of a sphere.  normal: out of that.
// Each of its points is the one on which it rolls.
Patch ball_patch(double radius, double other_radius, const Eigen::Vector3d& centre, double depth,
                 const Eigen::Vector3d& normal) noexcept;

// Of polygons that do not overlap.
class PatchSum {
 public:
  // lower: height of A's surface; depth: how far B's lies above it.  sign -1 takes an area out again.
  void add(const PatchMoments& moments, const LinearField& lower, const LinearField& depth,
           double sign = 1.0) noexcept;
  void add(const PatchPolygon& polygon, const LinearField& lower, const LinearField& depth,
           double sign = 1.0) noexcept {
    add(moments_of(polygon), lower, depth, sign);
  }
  // False: there is no area.
  bool finish(const PatchFrame& frame, Patch& patch) const noexcept;

 private:
  double area_ = 0.0, depth_ = 0.0, height_ = 0.0, square_ = 0.0;
  Eigen::Vector2d first_ = Eigen::Vector2d::Zero(), depth_first_ = Eigen::Vector2d::Zero(),
                  height_first_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second_ = Eigen::Matrix2d::Zero();
};

// Of two triangle sets along a direction.
class PatchFinder {
 public:
  PatchFinder();
  // Poses in one frame, that of the result; n: from B to A.  Surfaces that are further in one another than `most` are others
  // than those that touch [m].  False: they do not press.
  bool between(const ContactMesh& a, const Eigen::Isometry3d& pose_a, const ContactMesh& b,
               const Eigen::Isometry3d& pose_b, const Eigen::Vector3d& n, double most,
               Patch& patch) noexcept;
  // Against the half space below z = 0.
  bool with_ground(const ContactMesh& a, const Eigen::Isometry3d& pose_a, Patch& patch) noexcept;

 private:
  static constexpr std::size_t kMostFaces = 1024;  // of each side that press; more are left out
  struct Face {
    std::array<Eigen::Vector2d, 3> corner;  // counter-clockwise
    Eigen::Vector2d low, high;
    LinearField height;
    double least, largest;  // of the height
  };
  // Those of a set that face along `side` times the normal, inside of the rectangle and heights asked for.
  void gather(const ContactMesh& mesh, const Eigen::Isometry3d& pose, const PatchFrame& frame,
              double side, const Eigen::AlignedBox3d& within, std::vector<Face>& faces) noexcept;

  std::vector<Face> lower_, upper_;
};

}  // namespace twinbus::geometry
