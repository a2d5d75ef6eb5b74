// Pushes that somebody asks for while the world runs, at most eight at once.

#pragma once

#include <Eigen/Core>
#include <array>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/status.h"
#include "robot/description/model.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

class LivePushes {
 public:
  static constexpr std::size_t kMost = 8;        // at once
  static constexpr double kLongest = 60.0;       // [s]
  static constexpr double kLargest = 100'000.0;  // [N]
  static constexpr double kFarthest = 10.0;      // from the link's frame [m]

  // force: world [N]; point: in the frame of the link [m].
  Status add(const Model& model, int link, const Eigen::Vector3d& force,
             const Eigen::Vector3d& point, double seconds) noexcept {
    if (link < 0 || link >= model.link_count()) return Status::kOutOfRange;
    if (!force.allFinite() || !point.allFinite()) return Status::kNotFinite;
    if (!(seconds > 0.0 && seconds <= kLongest && force.norm() <= kLargest &&
          point.norm() <= kFarthest)) {
      return Status::kOutOfRange;
    }
    for (One& p : pushes_) {
      if (p.left > 0.0) continue;
      p = {link, seconds, force, point};
      return Status::kOk;
    }
    return Status::kOutOfRange;  // so many at once
  }

  // One step of the world; the last push is told as that of the scene.
  // watch(link, point, force): each of them.
  template <class Watch>
  void apply(World& world, double step, SimTruth& truth, const Watch& watch) noexcept {
    for (One& p : pushes_) {
      if (!(p.left > 0.5 * step)) {  // what is left of less than half a step is rounding
        p.left = 0.0;
        continue;
      }
      p.left -= step;
      const Eigen::Vector3d point = world.link_in_world(p.link) * p.point;
      (void)world.push(p.link, point, p.force);
      watch(p.link, p.point, p.force);
      for (int i = 0; i < 3; ++i) {
        truth.push_force[static_cast<std::size_t>(i)] = static_cast<float>(p.force[i]);
        truth.push_point[static_cast<std::size_t>(i)] = static_cast<float>(point[i]);
      }
    }
  }

  void clear() noexcept { pushes_ = {}; }

 private:
  struct One {
    int link = -1;
    double left = 0.0;  // [s]
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), point = Eigen::Vector3d::Zero();
  };
  std::array<One, kMost> pushes_;
};

}  // namespace twinbus::sim
