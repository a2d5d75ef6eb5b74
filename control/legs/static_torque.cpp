#include "control/legs/static_torque.h"

#include <cmath>

#include "common/math/pose_math.h"

namespace twinbus::inline control {

StaticTorque::StaticTorque(const Model& model)
    : model_(&model),
      mass_(model.total_mass()),
      configuration_(model),
      kinematics_(model),
      dynamics_(model),
      no_acceleration_(Eigen::VectorXd::Zero(model.joint_count())),
      standing_(2) {}

void StaticTorque::solve(const Estimator& estimator, const Eigen::VectorXd& q,
                         Eigen::VectorXd& tau) noexcept {
  configuration_.base = estimator.configuration().base;
  configuration_.q = q;
  kinematics_.update(configuration_);
  const bool stands = model_->floating_base && model_->soles[0].link >= 0 &&
                      model_->soles[1].link >= 0 && estimator.loaded(0) && estimator.loaded(1);
  if (stands) {
    std::array<SoleOnGround, 2> soles;
    const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
    std::array<Eigen::Isometry3d, 2> frame;
    for (std::size_t s = 0; s < 2; ++s) {
      const Sole& sole = model_->soles[s];
      frame[s] = kinematics_.link_in_world(sole.link) * sole.frame;
      const Eigen::Isometry3d in_ground = world_in_ground * frame[s];
      soles[s] = {.position = in_ground.translation().head<2>(),
                  .yaw = yaw_of(in_ground.linear()),
                  .front = sole.front,
                  .back = sole.back,
                  .left = sole.left,
                  .right = sole.right};
    }
    const Eigen::Vector3d com = world_in_ground * kinematics_.com();
    const ZmpShare share = share_zmp(soles, com.head<2>(), 0.0, 0.0);
    for (std::size_t s = 0; s < 2; ++s) {
      const double part = s == 0 ? share.left : 1.0 - share.left;
      standing_[s].link = model_->soles[s].link;
      standing_[s].point = frame[s] * Eigen::Vector3d(share.cop[s].x(), share.cop[s].y(), 0.0);
      standing_[s].force << 0.0, 0.0, part * mass_ * kGravity;
    }
  }
  (void)dynamics_.solve(kinematics_, configuration_, no_acceleration_, Eigen::Vector3d::Zero(),
                        Eigen::Vector3d::Zero(), stands ? standing_ : hanging_, tau);
}

}  // namespace twinbus::control
