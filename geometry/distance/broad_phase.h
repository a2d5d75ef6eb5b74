// Which shapes can be near each other: lower bounds of the distances of many pairs, from a capsule
// around each shape, eight pairs at a time.
//
// Single precision about an origin near the robot; what it may lose is taken off every bound.
//
// From one posture to the next what is known is used up by what the shapes walk: a pair stays farther
// apart than it was, less what both have walked since.  Most pairs are not looked at again for long.

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

#include "geometry/shapes.h"

namespace twinbus::inline geometry {

class NearShapes {
 public:
  struct Candidate {
    int a = 0, b = 0;       // shapes, a < b
    float bound = 0.0F;     // of their distance [m]; below zero when the capsules overlap
    float towards[3] = {};  // from near the nearest point of a's axis to that of b's [m]
  };

  NearShapes();
  ~NearShapes();

  // Capsules in the frames of their shapes.  Nothing is wanted afterwards.  Allocates, like want.
  void set(const std::vector<Capsule>& capsules);
  void want(int a, int b, bool on);

  // Where a shape is; origin: the same for all shapes of a posture.
  void place(int shape, const Eigen::Isometry3d& pose, const Eigen::Vector3d& origin) noexcept;

  // By how much a shape may move on, for nearer_than [m]; 0 to begin with.
  void let_move(int shape, double travel) noexcept;

  // The wanted pairs whose bound is at most `reach` [m], or at most `ahead` [m] when both have moved
  // on by what they may, by a and then by b; valid until the next call.  Bounds are those of where
  // the shapes are.  By what is kept, when walk has said of every posture how it was reached.
  std::span<Candidate> nearer_than(double reach, double ahead, bool by_kept) noexcept;
  std::span<Candidate> nearer_than(double reach) noexcept {
    return nearer_than(reach, -1e9, false);
  }

  // Of how many shapes, from the first, something is kept; all is forgotten.  After want.
  void keep(int shapes) noexcept;
  // A shape has moved by no more than this since it was placed last [m].
  void walk(int shape, double way) noexcept;
  // Where they are, they are at least so far apart [m].
  void know(int a, int b, double apart) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus::geometry
