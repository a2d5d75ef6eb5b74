// A world with a twin of twice its step beside it: what the two do not agree on is doubted (Doubt::kCoarse), in that step.
// Compared are the centres of mass of links and loose bodies: the origin of a link that hangs on the wall never moves.
//
// Of a method of order 1 the distance of the two is the error of the finer one, of order 2 three times that: dynamics that magnify
// an error magnify it in the twin as well.  It costs half as much again.  A controller that looks at one of them would drive the
// other where it should not go: once a servo is given another target, nothing more is said and the twin stands still.

#pragma once

#include <memory>
#include <vector>

#include "sim/world/forwarding_world.h"

namespace twinbus {

class TwinnedWorld final : public ForwardingWorld {
 public:
  static constexpr double kApart = 2.5e-3;  // beyond it a step is doubted [m]

  // The model must outlive this.  Throws std::runtime_error as make_world() does.
  TwinnedWorld(const Model& model, const WorldConfig& config);

  Status set(const Configuration& configuration, const Eigen::VectorXd* tau = nullptr) noexcept override;
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept override;
  void set_corner_offset(int sole, int corner, double offset) noexcept override;
  void estimate_contact_forces() noexcept override { world_->estimate_contact_forces(); }
  Status step() noexcept override;

  Status set_loose(int body, const LooseState& state) noexcept override;
  Status hold(int tie, bool holds) noexcept override;

 private:
  const World& shown() const noexcept override { return *world_; }
  struct Point {
    Eigen::Vector3d place, velocity;
  };
  void look(const World& world, std::vector<Point>& points) const noexcept;
  double apart() const noexcept;

  std::unique_ptr<World> world_, twin_;
  std::vector<Eigen::Vector3d> coms_;           // of links, in the link's axes
  double step_;                                 // of the world [s]
  std::vector<Point> before_, after_, points_;  // the twin's at both ends of its step, the world's
  std::vector<ServoTarget> targets_;
  bool halfway_ = false;  // of the twin's step
  bool stepped_ = false;  // since set()
  bool watched_ = true;
};

}  // namespace twinbus
