#include "sim/articulated/torque_free_rotation.h"

#include <Eigen/Geometry>

namespace twinbus::inline sim {

namespace {

constexpr int kMostSweeps = 50;
constexpr double kMostParts = 1000.0;
constexpr double kOuter = 1.3512071919596578;  // 1 / (2 - 2^(1/3))

}  // namespace

void turn_freely(const Eigen::Vector3d& inertia, double h, Eigen::Matrix3d& rotation,
                 Eigen::Vector3d& spin) noexcept {
  if (!(spin.squaredNorm() > 0.0)) return;
  const Eigen::Vector3d in_world =
      rotation * inertia.cwiseProduct(rotation.transpose() * spin);  // momentum, kept to the bit
  const double fastest = spin.norm() * inertia.maxCoeff() / inertia.minCoeff();
  const int parts = 1 + static_cast<int>(std::min(kMostParts - 1.0, 4.0 * h * fastest));  // of a needle no int holds it
  Eigen::Quaterniond attitude(rotation);
  for (int i = 0; i < 3 * parts; ++i) {
    const double part = h / parts * (i % 3 == 1 ? 1.0 - 2.0 * kOuter : kOuter);
    const Eigen::Vector3d start = attitude.conjugate() * in_world;
    Eigen::Vector3d end = start;
    Eigen::Vector3d half = Eigen::Vector3d::Zero();  // h wm / 2
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      half = 0.25 * part * (start + end).cwiseQuotient(inertia);
      // cay(-2 half) start: the quaternion (1, -half), normalised.
      const Eigen::Vector3d next =
          Eigen::Quaterniond(1.0, -half.x(), -half.y(), -half.z()).normalized() * start;
      const double change = (next - end).norm();
      end = next;
      if (!(change > 1e-15 * start.norm())) break;
    }
    attitude = (attitude * Eigen::Quaterniond(1.0, half.x(), half.y(), half.z())).normalized();
  }
  rotation = attitude.toRotationMatrix();
  spin = rotation * (rotation.transpose() * in_world).cwiseQuotient(inertia);
}

}  // namespace twinbus::sim
