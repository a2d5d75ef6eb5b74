// Links that are no soles with their area against flat ground and obstacles: contact patch (geometry/mesh_contact/patch.h).
//
// A shape is a convex set of triangles, of a mesh its hull, or a ball, whose cap is known in closed form.  As deep as it is along the way
// on which it is out of the other the soonest, what of its surface lies in the other presses, as it will lie at the end of the step;
// so no edge of an obstacle enters between two points.  A foot keeps the points of its shapes: its sole presses for it.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/mesh_contact/contact_mesh.h"
#include "geometry/mesh_contact/patch.h"
#include "sim/world/solid.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

struct LinkPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // at the start of the step, world [m]
  double depth = 0.0;                                  // then [m]
};

struct LinkPress {
  std::array<LinkPoint, Patch::kPoints> point;
  int count = 0;                                       // a ball rolls on one
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   // out of what is touched, world
  double weight = 0.0;  // of each point the springs of a point of a link
  double rough = 0.0;   // of its springs' energy what the points have lost: 0.5 k rough [m^2]
};

class LinkPatches {
 public:
  // Throws std::runtime_error when a mesh cannot be read.
  LinkPatches(const Model& model, const WorldConfig& config);

  // Of a collision shape of a link; -1: it has none, as what is of a foot.
  int of(int link, int shape) const noexcept;
  // How it presses within the next h.  link: in world; velocity: of its origin, world.  surface: 0 the ground, then the obstacles that
  // have a shape.  False: it does not.
  bool find(int which, const Eigen::Isometry3d& link, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin, double h,
            std::size_t surface, LinkPress& press) const noexcept;

 private:
  struct Piece {
    int link = 0, shape = 0;
    Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();  // about the middle of its box
    std::optional<ContactMesh> mesh;                            // none: a ball
    double radius = 0.0;                                        // of it [m]
    double face = 0.0;                                          // the mean face of the box around it [m^2]
  };
  struct Fixed {
    Eigen::Isometry3d pose;
    Solid solid;
    ContactMesh mesh;
  };
  bool presses(const Piece& piece, const Eigen::Isometry3d& pose, std::size_t surface, Patch& patch) const noexcept;

  std::vector<Piece> pieces_;
  std::vector<Fixed> fixed_;
  mutable PatchFinder finder_;
};

}  // namespace twinbus::sim
