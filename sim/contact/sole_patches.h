// Soles of their real shape against flat ground, tiles and boxes: contact patch (geometry/mesh_contact/patch.h).
//
// A sole is the outline of what its foot's collision geometry has within a few millimetres of the sole plane, or the sole's own
// rectangle where that says less.  Pressed is the part of it that will be below a surface at the end of the step.  Surfaces of one
// direction make one patch, so that a seam of two tiles is not felt; where tile and ground overlap the higher one counts.  A
// sole is pushed out upwards: only tops count, of a box as deep as kSoleSkin, beyond which it is beside the box rather than on it.

#pragma once

#include <array>
#include <vector>

#include "geometry/mesh_contact/patch.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

struct SolePoint {
  SolePoint() noexcept {}    // of many few are found: filling all would take as long as finding these
  int key;                   // of its direction and corner, from 0 to keys()
  Eigen::Vector3d position;  // on the sole, world [m]
  Eigen::Vector3d normal;    // world
  double depth;              // at the start of the step [m]
  double weight;  // of it the springs of a corner of the sole; 1: all of the sole presses
};

class SolePatches {
 public:
  static constexpr int kMostPoints = 64;
  using Points = std::array<SolePoint, kMostPoints>;
  using Offsets = std::array<double, kSoleCorners>;

  // The obstacles, then the tiles.
  SolePatches(const Model& model, const WorldConfig& config);

  // How many points of a sole so placed press within the next h.  sole: its frame in world; velocity: of the frame's
  // origin, world; ground: its height, lowered by `offset` under the corners.
  int find(std::size_t side, const Eigen::Isometry3d& sole, const Eigen::Vector3d& velocity,
           const Eigen::Vector3d& spin, double h, double ground, const Offsets& offset,
           Points& points) const noexcept;
  int keys() const noexcept { return Patch::kPoints * static_cast<int>(normals_.size()); }
  // Whether a point stands on that obstacle as a sole does.
  bool stands_on(std::size_t obstacle, const Eigen::Vector3d& point) const noexcept;

 private:
  struct Surface {
    int direction = 0;       // of normals_
    int obstacle = -1;       // of a box with sides; -1: a tile
    Eigen::Vector3d middle;  // of the top, world
    Eigen::Vector3d along, across;
    double half_along = 0.0, half_across = 0.0;
    double reach = 0.0;  // no point of it is farther from the middle
  };
  struct Outline {
    PatchPolygon outline;  // in the sole frame
    PatchMoments moments;  // of it
    double radius = 0.0;   // about the frame's origin
    double front = 0.0, back = 0.0, left = 0.0, right = 0.0;
  };
  struct Placed;

  void add_top(const Obstacle& box, int axis, double sign, int obstacle);
  int direction_of(const Eigen::Vector3d& normal);
  static Outline outline_of(const Model& model, const Sole& sole);

  std::array<Outline, 2> soles_;
  std::vector<Eigen::Vector3d> normals_;  // the first is up
  std::vector<PatchFrame> frames_;        // across each of them
  std::vector<Surface> tops_;
};

}  // namespace twinbus::sim
