#include "control/balance/squat_check.h"

#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline control {

namespace {
constexpr int kRounds = 16;            // of the inverse kinematics
constexpr double kMiss = 0.002;        // that a posture found is off at most [m, rad]
constexpr double kEffortShare = 0.95;  // some is needed to move
}  // namespace

SquatCheck::SquatCheck(const Model& model)
    : model_(&model),
      torque_(model),
      ik_(model),
      dynamics_(model),
      still_(Eigen::VectorXd::Zero(model.joint_count())),
      tau_(still_),
      wrench_(2) {
  for (std::size_t f = 0; f < 2; ++f) wrench_[f].link = model.soles[f].link;
}

const char* SquatCheck::why_not(const Estimator& estimator, double depth) noexcept {
  const Configuration& now = estimator.configuration();
  const Eigen::Vector3d com = estimator.kinematics().com() - Eigen::Vector3d(0.0, 0.0, depth);
  ik_.start(now);
  ik_.solve(com, now.base.linear(), {estimator.sole_in_world(0), estimator.sole_in_world(1)}, now.q,
            kRounds);
  ik_.update();
  if (!(ik_.error() < kMiss))
    return "the limits of the leg joints are too tight to squat so deep; the robot stands as it "
           "did";
  // Half of the weight on each sole, as far from its frame as the centre of mass is from the middle of both.
  const Kinematics& k = ik_.kinematics();
  const Eigen::Vector2d middle =
      0.5 * (estimator.sole_in_world(0).translation() + estimator.sole_in_world(1).translation())
                .head<2>();
  const double weight = model_->total_mass() * kGravity;
  for (std::size_t f = 0; f < 2; ++f) {
    const Sole& sole = model_->soles[f];
    wrench_[f].point = (k.link_in_world(sole.link) * sole.frame).translation();
    wrench_[f].point.head<2>() += k.com().head<2>() - middle;
    wrench_[f].force << 0.0, 0.0, 0.5 * weight;
    wrench_[f].torque.setZero();
  }
  (void)dynamics_.solve(k, ik_.configuration(), still_, Eigen::Vector3d::Zero(),
                        Eigen::Vector3d::Zero(), wrench_, tau_);
  for (int j = 0; j < model_->joint_count(); ++j) {
    if (ik_.is_leg(j) && !(torque_.share(j, ik_.configuration().q, tau_) < kEffortShare))
      return "the efforts of the leg joints are too small to squat so deep; the robot stands as it "
             "did";
  }
  return nullptr;
}

}  // namespace twinbus::control
