// Contact of two triangle sets as at most eight points, each found once, with position, normal and
// true depth: section 3.3.1 of the paper.
//
// Crossing points (intersection.h), the constraint of smallest depth in the neighbourhood of each
// (constraint.h), then of all that is under one constraint the points that carry: in each of as
// many directions as there is room for, the point of largest depth times lever, and the deepest.  So a
// point that comes or goes does so with the smallest part in the moment.  A body that is wholly
// inside of the other is pushed out along the nearest face.
//
// Exchanging the bodies turns the normals round and leaves all else, to rounding.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh_contact/constraint.h"

namespace twinbus::inline geometry {

struct ManifoldPoint {
  Eigen::Vector3d position;  // half way between the two surfaces [m]
  Eigen::Vector3d normal;    // from B to A, unit
  double depth = 0.0;        // [m], positive
  std::int64_t feature = 0;  // the same corner or edge has the same number next time
};

struct Manifold {
  static constexpr int kMost = 8;
  std::array<ManifoldPoint, kMost> point;
  int count = 0;
  int found = 0;           // penetrating points before they were reduced
  bool truncated = false;  // more crossed than there is room for
};

class ManifoldFinder {
 public:
  ManifoldFinder();
  // Makes room for this set; before it is asked about.
  void reserve(const ContactMesh& mesh);

  // Poses in one frame, that of the result.  False when they do not penetrate.
  bool between(const ContactMesh& a, const Eigen::Isometry3d& pose_a, const ContactMesh& b,
               const Eigen::Isometry3d& pose_b, Manifold& manifold) noexcept;

  // Against the half space below z = 0.
  bool with_ground(const ContactMesh& a, const Eigen::Isometry3d& pose_a,
                   Manifold& manifold) noexcept;

 private:
  // A penetrating point seen along its constraint.
  struct Lever {
    double x = 0.0, y = 0.0, depth = 0.0;
    int point = 0;  // of found_
  };
  // All that is under constraints of one direction.
  struct Group {
    Eigen::Vector3d normal;  // B's axes
    double deepest = 0.0;
    int room = 0;
  };
  static constexpr std::size_t kMostGroups = 32;

  void push_out(const ContactMesh& inner, const Eigen::Isometry3d& inner_in_b,
                const ContactMesh& outer, const Eigen::Isometry3d& outer_in_b,
                bool inner_is_a) noexcept;
  void reduce(const Eigen::Isometry3d& to_frame, Manifold& manifold) noexcept;
  void share_room() noexcept;
  void choose(int group, const Eigen::Isometry3d& to_frame, Manifold& manifold) noexcept;

  Intersection intersection_;
  Constraints constraints_;
  std::vector<Penetration> found_;
  std::vector<Lever> levers_;
  std::vector<Group> groups_;
  // So many, evenly round.
  std::array<std::array<Eigen::Vector2d, Manifold::kMost>, Manifold::kMost + 1> directions_;
};

}  // namespace twinbus::geometry
