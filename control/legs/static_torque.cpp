#include "control/legs/static_torque.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
constexpr int kLeastPoints = 3;     // that carry a robot at rest
constexpr double kUpright = 0.8;    // of the base; one that lies is carried by its trunk [rad]
}  // namespace

StaticTorque::StaticTorque(const Model& model)
    : model_(&model),
      mass_(model.total_mass()),
      configuration_(model),
      kinematics_(model),
      dynamics_(model),
      no_acceleration_(Eigen::VectorXd::Zero(model.joint_count())),
      standing_(2),
      on_points_(kMaxFeet) {
  for (ExternalWrench& foot : on_points_) foot.link = 0;
}

bool StaticTorque::stands_on_points(const Estimator& estimator) noexcept {
  const StandingFeet* feet = estimator.feet();
  if (feet == nullptr || !(estimator.tilt() < kUpright)) return false;
  std::array<int, kMaxFeet> which{};
  loads_.count = 0;
  for (int f = 0; f < std::min(feet->count(), kMaxFeet); ++f) {
    ExternalWrench& foot = on_points_[at(f)];
    foot.force.setZero();
    if (!feet->stands(f)) continue;
    // Where it presses as measured, in its link; there it presses in the posture that is held.
    foot.link = feet->link(f);
    const Eigen::Vector3d pressed = estimator.configuration().base * feet->point(f);
    foot.point = kinematics_.link_in_world(foot.link) * (estimator.kinematics().link_in_world(foot.link).inverse() * pressed);
    which[at(loads_.count)] = f;
    loads_.away[at(loads_.count)] = (foot.point - kinematics_.com()).head<2>();
    ++loads_.count;
  }
  if (loads_.count < kLeastPoints) return false;
  share_load_on_points(loads_);
  for (int k = 0; k < loads_.count; ++k) on_points_[at(which[at(k)])].force.z() = loads_.share[at(k)] * mass_ * kGravity;
  return true;
}

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
                        Eigen::Vector3d::Zero(), stands ? standing_ : stands_on_points(estimator) ? on_points_ : hanging_, tau);
}

}  // namespace twinbus::control
