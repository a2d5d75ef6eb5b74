#include "common/math/pose_math.h"

#include <gtest/gtest.h>

#include <random>

namespace twinbus {
namespace {

TEST(PoseMath, ConversionsAreInverses) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-1.5, 1.5);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d v(angle(random), angle(random), angle(random));
    const Eigen::Matrix3d r = rotation_from_rpy(v.x(), v.y(), v.z());
    EXPECT_LT((rpy_from_rotation(r) - v).norm(), 1e-12);
    EXPECT_LT((rotation_vector(rotation_of(v)) - v).norm(), 1e-12);
    EXPECT_LT((quaternion_from_array(array_from_rotation<double>(r)).toRotationMatrix() - r).norm(),
              1e-12);
  }
}

TEST(PoseMath, APitchOfARightAngleKeepsTheRotation) {
  for (const double near : {0.0, 1e-13, 1e-9, 1e-7, 1e-5}) {
    for (int i = 0; i < 400; ++i) {
      const double pitch = (i % 2 == 0 ? 1.0 : -1.0) * (0.5 * 3.14159265358979323846 - near);
      const Eigen::Matrix3d r = rotation_from_rpy(0.1 * i, pitch, 7.0 - 0.37 * i);
      const Eigen::Vector3d v = rpy_from_rotation(r);
      EXPECT_LT((rotation_from_rpy(v.x(), v.y(), v.z()) - r).norm(), 1e-9) << near << ' ' << i;
    }
  }
  const Eigen::Matrix3d r = Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5).toRotationMatrix();  // exactly
  const Eigen::Vector3d v = rpy_from_rotation(r);
  EXPECT_LT((rotation_from_rpy(v.x(), v.y(), v.z()) - r).norm(), 1e-12);
}

TEST(PoseMath, SmallRotationsKeepTheirDigits) {
  const Eigen::Vector3d tiny(1e-10, -2e-10, 3e-10);
  EXPECT_LT((rotation_vector(rotation_of(tiny)) - tiny).norm(), 1e-19);
  const Eigen::Vector3d half_turn(3.14159265358979, 0, 0);
  EXPECT_NEAR(rotation_vector(rotation_of(half_turn)).norm(), half_turn.norm(), 1e-9);
}

TEST(PoseMath, RotationAboutIsEigens) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 0.5).normalized();
  EXPECT_LT((rotation_about(axis, 0.7) - Eigen::AngleAxisd(0.7, axis).toRotationMatrix()).norm(),
            1e-14);
}

TEST(PoseMath, AnglesWrap) {
  EXPECT_NEAR(wrap_angle(7.0), 7.0 - 2 * 3.14159265358979323846, 1e-12);
  EXPECT_NEAR(wrap_angle(-3.0), -3.0, 1e-15);
}

TEST(PoseMath, UprightKeepsHeadingAndPlace) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation_from_rpy(0.1, 0.2, 0.9);
  pose.translation() << 1, 2, 3;
  EXPECT_LT((upright(pose).linear() - rotation_z(0.9)).norm(), 1e-12);
  EXPECT_EQ(upright(pose).translation(), pose.translation());
}

}  // namespace
}  // namespace twinbus
