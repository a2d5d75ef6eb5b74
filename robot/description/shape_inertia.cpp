#include "robot/description/shape_inertia.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "robot/description/link_points.h"

namespace twinbus::inline robot {

namespace {

constexpr double kLeastMass = 0.01;      // [kg]
constexpr double kLeastGyration = 1e-3;  // [m]; a body of less is a rounding error
constexpr double kLeastEdge = 0.02;      // of the box [m]
constexpr double kWater = 1000.0;        // [kg/m^3]

}  // namespace

bool lacks_inertia(const Link& link) {
  if (!(link.mass > 0.0)) return true;
  const double least =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(link.inertia, Eigen::EigenvaluesOnly)
          .eigenvalues()[0];
  return !(least > link.mass * kLeastGyration * kLeastGyration);
}

void take_inertia_from_shape(Link& link) {
  const std::vector<Eigen::Vector3d> points = link_points(link);
  Eigen::Vector3d edge;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const bool weightless = !(link.mass > 0.0);
  if (weightless) link.mass = kLeastMass;
  if (points.empty()) {
    // A ball of radius r has the inertia of a cube of edge sqrt(12/5) r.
    edge.setConstant(std::sqrt(2.4) *
                     std::cbrt(3.0 * link.mass / (4.0 * std::numbers::pi * kWater)));
  } else {
    const Eigen::AlignedBox3d box = box_around(points);
    edge = box.sizes();
    middle = box.center();
  }
  if (weightless) link.com = middle;
  const Eigen::Vector3d square = edge.cwiseMax(kLeastEdge).cwiseAbs2();
  link.inertia =
      link.mass / 12.0 *
      Eigen::Vector3d(square.y() + square.z(), square.z() + square.x(), square.x() + square.y())
          .asDiagonal()
          .toDenseMatrix();
}

}  // namespace twinbus::robot
