// Walking run ahead of the robot, on its own model: for stop plans, and for a controller that was silent.

#include <cmath>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "control/walk/walk.h"

namespace twinbus::inline control {

// What is measured is replaced by what the model says: the DCM follows the ZMP that the soles carry, xi' = omega (xi - p),
// soles are where they were sent, loads as wanted, and a foot in the air lands when its time is over.
void Walk::foresee(double dt) noexcept {
  height_.advance(dt);
  first_.advance(dt);
  const double w0 = omega();
  const Eigen::Vector2d zmp = stabilizer_.share().zmp, before = dcm_;
  dcm_ = zmp + std::exp(w0 * dt) * (dcm_ - zmp);
  const Eigen::Vector2d velocity = w0 * (0.5 * (before + dcm_) - com_.head<2>());
  com_.head<2>() += dt * velocity;
  com_velocity_.head<2>() = velocity;
  std::array<bool, 2> touching{true, true};
  for (int f = 0; f < 2; ++f) {
    const bool swings = pattern_.swings(f);
    measured_feet_[at(f)] = swings ? pattern_.swing().place() : pattern_.foot(f);
    if (!swings) continue;
    touching[at(f)] = pattern_.swing().progress() >= 1.0;
    measured_feet_[at(f)].height = pattern_.target().height;
    measured_feet_[at(f)].gradient = pattern_.slope().gradient();
  }
  measured_ = wanted_;
  pattern_.advance(touching, measured_feet_, dt);
  ground_.advance(pattern_.ground_at(stabilizer_.com()), dt);
  const double w = omega();
  pattern_.plan(dcm_, w);
  stabilizer_.update(pattern_, com_.head<2>(), dcm_, w, dt);
  heading_ += wrap_angle(pattern_.heading() - heading_) * std::min(1.0, dt / gains_.turn);
  load_feet(nullptr, dt);
}

void Walk::foresee_joints(const Eigen::VectorXd& q_given, int rounds) noexcept {
  ik_.solve(com_reference(), attitude(), feet_.target(), q_given, rounds);
}

void Walk::take_over(const Eigen::VectorXd& q, const Eigen::VectorXd& qd) noexcept {
  Configuration& c = ik_.configuration();
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    if (!ik_.is_leg(static_cast<int>(j))) continue;
    c.q[j] = q_[j] = q[j];
    qd_[j] = qd[j];
  }
  ik_.update();
  std::array<Eigen::Isometry3d, 2> sent;
  for (std::size_t f = 0; f < 2; ++f) {
    const Sole& sole = model_->soles[f];
    sent[f] = ik_.kinematics().link_in_world(sole.link) * sole.frame;
  }
  feet_.take_over(pattern_, sent);
  resumes_ = true;
}

}  // namespace twinbus::control
