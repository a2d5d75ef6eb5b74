// What the steps of a world are off, summed up from what each of them knows of itself: no second run, no second solve.
//
// A method of order p moves a body wrongly in a step h by about
//     c_p h |D^p v|,  c_1 = 1/2, c_2 = 1/6, c_3 = 1/24
// where D^p v is the p-th difference of the velocities at the ends of its steps: for p = 1 that is h^2 a / 2.  Of a link the velocity
// of its centre of mass changes along the axes of the world or its own ones, whichever is less: a wheel that turns
// evenly is not off.  What the world makes of these errors it does not know, and errors that cancel one another are added: it speaks too
// early rather than too late.  A mechanism that nothing touches magnifies them, at order 2 the more the longer it is (10 to 2,000 times
// in ./twinbus bench maps chain loop): so much less is allowed of it.
//
// Of a loose body that falls as nothing touches it, engine articulated knows the motion exactly: nothing is added then.
//
// A controller that looks at the world takes errors back.  From the first command that differs from the one before, errors of order 1 are
// added as vectors, which is h (v - v_0) / 2 (of walks, reaches and pushed boxes the true error is 0.7 to 1.2 times that; of a robot in
// balance that is pushed or squats 10 to 20 times, which ./twinbus tune finds and this does not); those of a higher order fade in 3 s, as
// they were seen to heal.

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "sim/world/world.h"

namespace twinbus::inline sim {

class LocalError {
 public:
  static constexpr int kLeastLinks = 10;    // of order 2 or 3, of a mechanism that nothing touches: beyond so much a part of it, or of as many as it has

  // Of bodies that are links, then of others.  Explicit flight (config.flight) is better than this knows: nothing is said of it.
  LocalError(std::size_t links, std::size_t others, const WorldConfig& config);

  // Velocities of the centres of mass: in world of all, and of links in their own axes too [m/s].  Before the first step, and
  // after every jump; until then nothing has been faster or slower.
  void begin(const std::vector<Eigen::Vector3d>& world, const std::vector<Eigen::Vector3d>& own) noexcept;
  // After a step.  touched: something that is no tie touched a link in it.  True: a body is off by too much since the sum began.
  bool add(const std::vector<Eigen::Vector3d>& world, const std::vector<Eigen::Vector3d>& own, bool touched) noexcept;
  // Somebody looked at the world and asks for something else.
  void driven() noexcept;
  double limit() const noexcept { return limit_; }  // config.accuracy, or config.bands.off where that is more: beyond it a step is doubted [m]
  double band() const noexcept { return band_; }    // the least limit with which no step since the world began would have been doubted [m]

  double most() const noexcept { return std::max(most_of_links_, most_of_others_); }  // the sum of the body that is off the most [m]

 private:
  static constexpr int kMostOrder = 3;
  // Of a velocity: the last ones, of which the newest is first.
  using Past = std::array<Eigen::Vector3d, kMostOrder>;
  double change(const Past& past, const Eigen::Vector3d& now) const noexcept;
  void keep(const Eigen::Vector3d& now, Past& past) const noexcept;  // as far back as its order looks

  int order_;
  double limit_;
  double scale_;  // c_p h [s]
  double fall_;   // of the speed of what nothing touches in a step [m/s]; NaN: the engine does not know it exactly
  double keep_;   // of a sum of a driven world from step to step
  bool driven_ = false;
  std::vector<Past> world_, own_;
  std::vector<double> sum_;           // [m]
  std::vector<Eigen::Vector3d> off_;  // of a driven world of order 1 [m]
  double most_of_links_ = 0.0, most_of_others_ = 0.0;
  double band_ = 0.0;
};

}  // namespace twinbus::sim
