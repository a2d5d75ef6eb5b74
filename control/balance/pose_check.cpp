#include "control/balance/pose_check.h"

#include <algorithm>
#include <cmath>

#include "control/balance/straight_way.h"
#include "robot/estimation/support_polygon.h"

namespace twinbus::inline control {

namespace {
constexpr int kPlaces = 20;        // of the way that are looked at
constexpr double kSlide = 0.015;   // of one sole against the other [m]
constexpr double kTurn = 0.05;     // [rad]
constexpr double kInside = 0.015;  // of the centre of mass, from the edge of the soles [m]
constexpr const char* kFeet =
    "the pose would move one foot against the other on the ground and the robot would fall; give "
    "both legs angles that keep the "
    "soles flat";
constexpr const char* kBalance =
    "on the way to the pose the centre of mass leaves the soles and the robot would fall; ask for "
    "a pose that is balanced";
}  // namespace

PoseCheck::PoseCheck(const Model& model) : model_(&model), way_(model), kinematics_(model) {}

const char* PoseCheck::why_not(const Estimator& estimator, const PerJoint<double>& from,
                               const PerJoint<double>& to, std::int64_t mask) noexcept {
  const Sole& left = model_->soles[0];
  const Sole& right = model_->soles[1];
  way_ = estimator.configuration();
  Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
  for (int place = 0; place <= kPlaces; ++place) {
    const double share = static_cast<double>(place) / kPlaces;
    place_on_way(*model_, from, to, mask, share, way_);
    kinematics_.update(way_);
    const Eigen::Isometry3d left_sole = kinematics_.link_in_world(left.link) * left.frame;
    const Eigen::Isometry3d right_in_left =
        left_sole.inverse() * (kinematics_.link_in_world(right.link) * right.frame);
    if (place == 0) before = right_in_left;
    const Eigen::Matrix3d turned = before.linear().transpose() * right_in_left.linear();
    const double turn = std::acos(std::clamp(0.5 * (turned.trace() - 1.0), -1.0, 1.0));
    if (!((right_in_left.translation() - before.translation()).norm() < kSlide && turn < kTurn))
      return kFeet;
    // Seen from above, in the left sole, which stays where it is.
    SupportPolygon polygon;
    polygon.clear();
    polygon.add(left, Eigen::Isometry3d::Identity());
    polygon.add(right, right_in_left);
    polygon.finish();
    const Eigen::Vector3d com = left_sole.inverse() * kinematics_.com();
    if (!(polygon.margin(com.head<2>()) > kInside)) return kBalance;
  }
  return nullptr;
}

}  // namespace twinbus::control
