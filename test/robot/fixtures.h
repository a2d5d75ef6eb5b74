// Robots and motions that several tests of robot/ share.

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "robot/kinematics/kinematics.h"
#include "robot/description/load.h"
#include "common/math/pose_math.h"
#include "test/error_of.h"
#include "test/temporary_folder.h"

namespace twinbus::test {

// hrp1s with one joint made prismatic, so that every kind of joint is exercised, and rotors.
inline const Model& hrp1s() {
  static const Model model = load_robot("hrp1s");
  return model;
}

inline Model robot_with_every_joint() {
  Model model = hrp1s();
  Joint& slide = model.joints[static_cast<std::size_t>(model.find_joint("CHEST"))];
  slide.kind = JointKind::kPrismatic;
  Joint& wheel = model.joints[static_cast<std::size_t>(model.find_joint("LARM_WRIST_Y"))];
  wheel.kind = JointKind::kContinuous;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    model.joints[i].rotor_inertia = 0.01 * static_cast<double>(i % 5);
    model.joints[i].axis =
        Eigen::Vector3d(0.3, -0.2 * static_cast<double>(i % 3), 1.0).normalized();
  }
  return model;
}

// A smooth motion of everything: joints and base are sums of sines of time.
struct Motion {
  explicit Motion(const Model& model, unsigned seed = 7) : model_(&model) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    for (int i = 0; i < model.joint_count() + 6; ++i) {
      offset.push_back(0.5 * value(random));
      size.push_back(0.4 * value(random));
      rate.push_back(2.0 + value(random));
    }
  }
  double at(int i, double t, int derivative) const {
    const auto k = static_cast<std::size_t>(i);
    const double phase = rate[k] * t + offset[k];
    if (derivative == 0) return offset[k] + size[k] * std::sin(phase);
    if (derivative == 1) return size[k] * rate[k] * std::cos(phase);
    return -size[k] * rate[k] * rate[k] * std::sin(phase);
  }
  Configuration configuration(double t) const {
    Configuration c(*model_);
    const int n = model_->joint_count();
    for (int j = 0; j < n; ++j) {
      c.q[j] = at(j, t, 0);
      c.qd[j] = at(j, t, 1);
    }
    const double roll = at(n, t, 0), pitch = at(n + 1, t, 0), yaw = at(n + 2, t, 0);
    c.base.linear() = rotation_from_rpy(roll, pitch, yaw);
    const Eigen::Matrix3d rz = rotation_z(yaw);
    const Eigen::Vector3d y = rz * Eigen::Vector3d::UnitY();
    const Eigen::Vector3d x =
        rz * rotation_about(Eigen::Vector3d::UnitY(), pitch) * Eigen::Vector3d::UnitX();
    c.base_angular_velocity =
        at(n + 2, t, 1) * Eigen::Vector3d::UnitZ() + at(n + 1, t, 1) * y + at(n, t, 1) * x;
    for (int i = 0; i < 3; ++i) {
      c.base.translation()[i] = at(n + 3 + i, t, 0);
      c.base_velocity[i] = at(n + 3 + i, t, 1);
    }
    return c;
  }
  Eigen::VectorXd qdd(double t) const {
    Eigen::VectorXd result(model_->joint_count());
    for (int j = 0; j < model_->joint_count(); ++j) result[j] = at(j, t, 2);
    return result;
  }
  Eigen::Vector3d base_acceleration(double t) const {
    const int n = model_->joint_count() + 3;
    return {at(n, t, 2), at(n + 1, t, 2), at(n + 2, t, 2)};
  }
  Eigen::Vector3d base_angular_acceleration(double t) const {
    constexpr double h = 1e-5;
    return (configuration(t + h).base_angular_velocity -
            configuration(t - h).base_angular_velocity) /
           (2 * h);
  }

  const Model* model_;
  std::vector<double> offset, size, rate;
};

// Folder of foreign robots; empty if it is not there.
inline std::string data_folder() {
  const char* named = std::getenv("TWINBUS_DATA");
  const std::string folder = named != nullptr ? named : TWINBUS_DATA_FOLDER;
  return std::filesystem::is_directory(folder) ? folder : "";
}

}  // namespace twinbus::test
