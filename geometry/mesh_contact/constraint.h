// The constraint of a region of crossing points: along which direction the two bodies are pushed
// apart, and how deep each point is along it.
//
// Section 3.3.1 of the paper: "We choose the constraint that gives the smallest penetration depth
// in the neighborhood of each penetrating point."  A region whose shared body is thinnest along a
// direction in which both surfaces really end is under one constraint, that direction.  Otherwise,
// as for a block in a groove, each corner inside is under the face it is least deep under.

#pragma once

#include <span>
#include <vector>

#include "geometry/mesh_contact/intersection.h"

namespace twinbus::inline geometry {

// One penetrating point.
struct Penetration {
  CrossingPoint::Kind kind = CrossingPoint::kVertexA;
  int id = 0, face = -1;  // as in CrossingPoint
  Eigen::Vector3d point;   // on A's surface, or of kVertexB and kEdgeB on B's; B's axes [m]
  Eigen::Vector3d normal;  // from B to A, unit
  double depth = 0.0;      // [m]
  int constraint = 0;      // points with the same number are under the same one
};

class Constraints {
 public:
  void reserve(std::size_t points);

  // points: of regions 0 to `regions`.  Appends what penetrates in one, as far as there is room;
  // the numbers of its constraints begin at `first`.  Returns the next.
  int find(const std::vector<CrossingPoint>& points, int regions, int region, int first,
           std::vector<Penetration>& found) noexcept;

 private:
  struct Extent {
    double low = 0.0, high = 0.0;
    double width() const noexcept { return high - low; }
  };

  void gather(const std::vector<CrossingPoint>& points, int regions, int region) noexcept;
  void suggest_faces() noexcept;
  void suggest_crossed_edges() noexcept;
  void suggest_thinnest() noexcept;
  void suggest(const Eigen::Vector3d& normal) noexcept;
  // False: wider than `most`.
  bool extent_along(const Eigen::Vector3d& n, double most, Extent& extent) const noexcept;
  bool ends_here(const Eigen::Vector3d& n, const Extent& extent) const noexcept;
  void under_one(const Eigen::Vector3d& n, const Extent& extent, int number,
                 std::vector<Penetration>& found) const noexcept;
  void between_edges(const Eigen::Vector3d& n, const Extent& extent, int number,
                     std::vector<Penetration>& found) const noexcept;
  double level(const Eigen::Vector3d& n, const Eigen::Vector3d& point,
               bool surface_of_a) const noexcept;
  int under_faces(int first, std::vector<Penetration>& found) noexcept;

  std::span<const CrossingPoint> points_;  // of the region
  std::vector<CrossingPoint> gathered_;    // where they do not lie together
  std::vector<Eigen::Vector3d> normals_;  // tried
  std::vector<Eigen::Vector3d> groups_;   // of under_faces()
};

}  // namespace twinbus::geometry
