// Lower bounds of the distances of shapes all along a way: eight places of it at a time, and what lies
// between them.
//
// A direction n that is still for the link that both shapes hang on parts them at a place by
//
//     gap(n) = n . (b - a) - h_a(n) - h_b(n),     h the support function of a shape about its middle,
//
// and from one place to the next by no less than the smaller of the two gaps, less what their points
// leave the straight way by: joints that go together from nothing to their steps d, each off that by
// no more than its bend, take a point of a link off it by at most
//
//     sum over the joints between of reach(link, j) (bend_j + |d_j| (|d_j| / 8 + turn_j / 4)),
//
// turn_j the sum of |d| of the joints before j (joint_reach.h).  Single precision about link 0; what it
// may lose is taken off every bound.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/distance/convex_shape.h"
#include "geometry/distance/gjk.h"
#include "robot/kinematics/joint_reach.h"
#include "robot/kinematics/kinematics.h"
#include "geometry/distance/broad_phase.h"

namespace twinbus::inline robot {

class SweptShapes {
 public:
  static constexpr int kPlaces = 8;
  using AtPlaces = std::array<float, kPlaces>;

  // A way from place to place; of every joint what it is there [rad or m], and how far it is at most off
  // the straight way to the next place while all joints go together.
  struct Way {
    std::vector<std::array<double, kPlaces>> q;  // [joint_count]
    std::vector<AtPlaces> bend;                  // [joint_count]
    // 0: nothing that is asked for depends on this joint, and whatever the other two say of it is not
    // looked at [joint_count].
    std::vector<std::uint8_t> asked;
  };

  struct Part {
    int link = -1;  // below zero: stands still in the world
    const ConvexShape* shape = nullptr;
    const GjkShape* hull = nullptr;  // of a mesh, else null
    Ball inside;                     // of a hull, in its frame
    Eigen::Isometry3d local = Eigen::Isometry3d::Identity();
  };

  SweptShapes(const Model& model, const JointReach& reach);
  ~SweptShapes();

  // What they point to must outlive this.  No pair is wanted afterwards.  Allocates, like want.
  void set(const std::vector<Part>& parts);
  void want(int a, int b);  // a < b; pairs are numbered as they are wanted

  void go(const Eigen::Isometry3d& base, const Way& way) noexcept;

  // Of these shapes, which are wanted, the pairs that no direction at hand proves to stay `margin` [m]
  // apart at every place and `clear` between: their numbers, at most capacity; how many there are, or
  // that there are more.
  int open(std::span<const NearShapes::Candidate> shapes, double margin, double clear, int* pairs,
           int capacity) noexcept;

  // Of a pair: its shapes; where one is; the gaps at all places along a direction (world, from a to b)
  // that is seen at one of them, which is remembered when it says more than the last.
  struct Shapes {
    int a = 0, b = 0;
  };
  Shapes shapes(int pair) const noexcept;
  Eigen::Isometry3d pose(int shape, int place) const noexcept;
  Eigen::Vector3d remembered(int pair, int place) const noexcept;  // world; zero: nothing is
  void remember(int pair, const Eigen::Vector3d& direction, int place) noexcept;
  AtPlaces gaps(int pair, const Eigen::Vector3d& direction, int place) const noexcept;
  struct Bounds {
    AtPlaces gaps;        // along the direction that is remembered
    AtPlaces left_out;    // what the way from each place to the next takes off the smaller of the two gaps
    AtPlaces most_apart;  // the shapes are no farther apart at the places
    AtPlaces travel;      // by how much the way to the next can bring them together
  };
  Bounds bounds(int pair) const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus::robot
