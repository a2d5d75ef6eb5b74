// Torque of joints against their limits, where two motors may turn two joints over rods (`parallel_joints` of robot.yaml): those are
// limited at the motors, posture by posture, all others by their own effort.

#pragma once

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "common/math/index.h"
#include "robot/description/model.h"
#include "robot/description/parallel_joints.h"
#include "robot/parallel/drive_torque.h"

namespace twinbus::inline robot {

class PairTorque {
 public:
  explicit PairTorque(const Model& model);  // must outlive this

  bool empty() const noexcept { return pairs_.empty(); }
  const ParallelJoints* with(int joint) const noexcept { return pair_with(pairs_, joint); }

  // Cuts the torques of each pair to what the motors give at the posture q; arrays in bus order.  cut(bus index, asked, given) is told
  // of each joint whose torque is another then.
  template <class Positions, class Torques, class Cut>
  void limit(const Positions& q, Torques& tau, Cut&& cut) const noexcept {
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const std::array<std::size_t, 2>& bus = bus_[p];
      RodPosture posture;
      if (!pairs_[p].drive.at({static_cast<double>(q[bus[0]]), static_cast<double>(q[bus[1]])}, posture)) continue;
      const LimitedTorque given = limit_at_motors(posture.jacobian, pairs_[p].drive.torque_limits(),
                                                  {static_cast<double>(tau[bus[0]]), static_cast<double>(tau[bus[1]])});
      if (!given.limited) continue;
      for (std::size_t i = 0; i < 2; ++i) {
        const double asked = static_cast<double>(tau[bus[i]]), left = given.tau[static_cast<Eigen::Index>(i)];
        tau[bus[i]] = static_cast<std::remove_reference_t<decltype(tau[bus[i]])>>(left);
        cut(bus[i], asked, left);
      }
    }
  }
  template <class Positions, class Torques>
  void limit(const Positions& q, Torques& tau) const noexcept {
    limit(q, tau, [](std::size_t, double, double) {});
  }

  // How much of its limit a joint's torque takes: |tau| over its effort, of a pair that of the motor that has most to do.  q, tau: one
  // a joint of the model.  A joint without a limit takes none.
  double share(int joint, const Eigen::VectorXd& q, const Eigen::VectorXd& tau) const noexcept;
  // What a joint may count on in a posture: its effort; of a pair its side of the largest box inside what the motors give, so that the
  // other joint has its own at the same time [N m or N].
  double effort_in(int joint, const Eigen::VectorXd& q) const noexcept;

 private:
  const Model* model_;
  std::vector<ParallelJoints> pairs_;
  std::vector<std::array<std::size_t, 2>> bus_;  // of the pairs
};

}  // namespace twinbus::robot
