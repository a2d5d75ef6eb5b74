// A world with a twin of half its step beside it: what the two do not agree on is doubted (Doubt::kCoarse), in that step.
// Compared are the centres of mass of links and loose bodies: the origin of a link that hangs on the wall never moves.
//
// The distance of the two is the error of the world, of order 1 half of it: dynamics that magnify an error magnify it in the twin as well.
// The twin takes the same commands and pushes at the same moments, for twice the work of the world again.  A controller looks at the world
// and would let the twin go its way: once a servo is given another target, a twin that has parted goes on from where the world is.

#pragma once

#include <memory>
#include <vector>

#include "sim/world/forwarding_world.h"

namespace twinbus::inline sim {

class TwinnedWorld final : public ForwardingWorld {
 public:
  // The model must outlive this.  Throws std::runtime_error as make_world() does.
  TwinnedWorld(const Model& model, const WorldConfig& config);

  Status set(const Configuration& configuration, const Eigen::VectorXd* tau = nullptr) noexcept override;
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept override;
  void set_corner_offset(int sole, int corner, double offset) noexcept override;
  void estimate_contact_forces() noexcept override { world_->estimate_contact_forces(); }
  Status step() noexcept override;
  double work() const noexcept override { return world_->work() + twin_->work(); }

  Status set_loose(int body, const LooseState& state) noexcept override;
  Status hold(int tie, bool holds) noexcept override;

 private:
  const World& shown() const noexcept override { return *world_; }
  static constexpr std::size_t kMostPushes = 16;
  struct Push {
    int link;
    Eigen::Vector3d point, force;
  };
  double apart() const noexcept;
  void meet() noexcept;

  std::unique_ptr<World> world_, twin_;
  double allowed_;                     // distance of the two [m]
  std::vector<Eigen::Vector3d> coms_;  // of links, in the link's axes
  std::vector<ServoTarget> targets_;
  std::vector<Push> pushes_;  // in the next step
  Eigen::VectorXd tau_;
  bool stepped_ = false;  // since set()
  bool driven_ = false;   // since then, another target has come
  bool watched_ = true;
};

}  // namespace twinbus::sim
