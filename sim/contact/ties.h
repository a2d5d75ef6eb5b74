// Ties as contacts of the one implicit solve.
//
//     f = -k s+ - c v+          s+ = s + h v+ - h^2/2 b,   v+ = v + h (J a + b)
//
// with b the part of the points' acceleration that the velocities alone make: links turn within the
// step, and a stiff tie feels that at once.  Nothing is remembered of a step but the force, as the
// next one's first guess: where the ends are says how far apart they are.

#pragma once

#include <vector>

#include "sim/contact/contact_solve.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

class Ties {
 public:
  // Throws std::runtime_error for an end that is not there.
  Ties(const Model& model, const WorldConfig& config);

  int count() const noexcept { return static_cast<int>(ties_.size()); }
  // Appends those that hold.
  void find(const std::vector<ArticulatedBody*>& systems, double h,
            std::vector<Contact>& contacts) const noexcept;
  void remember(const std::vector<Contact>& contacts) noexcept;

  // holds: its ends are to stay together as they now are.
  Status hold(int tie, bool holds, const std::vector<ArticulatedBody*>& systems) noexcept;

 private:
  struct Own {
    Tie tie;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // of the last step [N]
  };
  struct End;  // as placed

  int system_of(const TieEnd& end) const noexcept;
  End placed(const TieEnd& end, const std::vector<ArticulatedBody*>& systems) const noexcept;

  int first_robot_ = 1;  // of the further ones, as a system
  std::vector<Own> ties_;
};

// Throws std::runtime_error for an end that is not there, or ties that tie nothing that moves.  The
// first end of what comes back moves.
std::vector<Tie> checked_ties(const Model& model, const WorldConfig& config);

}  // namespace twinbus::sim
