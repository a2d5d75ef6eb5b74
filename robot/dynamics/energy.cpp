#include "robot/dynamics/energy.h"

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/index.h"

namespace twinbus::inline robot {

double mechanical_energy(const Kinematics& kinematics,
                         const Configuration& configuration) noexcept {
  const Model& model = kinematics.model();
  double sum = 0.0;
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[at(i)];
    const Eigen::Vector3d& com = kinematics.com_of_link(i);
    const Eigen::Vector3d spin =
        kinematics.link_in_world(i).linear().transpose() * kinematics.angular_velocity(i);
    sum +=
        link.mass * (0.5 * kinematics.point_velocity(i, com).squaredNorm() + kGravity * com.z()) +
        0.5 * spin.dot(link.inertia * spin);
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    const double speed = configuration.qd[j];
    sum += 0.5 * model.joints[at(j)].rotor_inertia * speed * speed;
  }
  return sum;
}

}  // namespace twinbus::robot
