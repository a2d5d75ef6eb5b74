#include "sim/world/truth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/estimation/support_polygon.h"

namespace twinbus {

namespace {

constexpr double kFallenTilt = 0.5;  // cosine of 60 degrees
constexpr double kLoaded = 1.0;      // a sole with less is in the air [N]

template <std::size_t N>
void copy(const Eigen::Vector3d& from, std::array<float, N>& to) {
  for (int i = 0; i < 3; ++i) to[static_cast<std::size_t>(i)] = static_cast<float>(from[i]);
}

template <std::size_t N>
void copy(const Eigen::Vector3d& from, std::array<double, N>& to) {
  for (int i = 0; i < 3; ++i) to[static_cast<std::size_t>(i)] = from[i];
}

template <class Number>
void copy(const Eigen::Matrix3d& rotation, std::array<Number, 4>& to) {
  const Eigen::Quaterniond q(rotation);
  to = {static_cast<Number>(q.w()), static_cast<Number>(q.x()), static_cast<Number>(q.y()),
        static_cast<Number>(q.z())};
}

}  // namespace

void fill_truth(const Model& model, const World& world, double standing_height,
                SimTruth& truth) noexcept {
  const Configuration& now = world.configuration();
  copy(now.base.translation(), truth.base_position);
  copy(Eigen::Matrix3d(now.base.linear()), truth.base_attitude);
  copy(now.base_velocity, truth.base_velocity);
  copy(now.base_angular_velocity, truth.base_angular_velocity);
  copy(world.com(), truth.com);
  copy(world.com_velocity(), truth.com_velocity);

  std::array<Eigen::Vector3d, 2> foot_force{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  double pressure = 0.0, penetration = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  truth.contact_count = 0;
  truth.contact_point = {};
  truth.contact_force = {};
  for (const ContactPoint& contact : world.contacts()) {
    if (contact.tie) continue;
    penetration = std::max(penetration, contact.depth);
    pressure += contact.force.z();
    moment += contact.force.z() * contact.point.head<2>();
    for (std::size_t side = 0; side < 2; ++side) {
      if (of_foot(model, contact, side)) foot_force[side] += contact.force;
    }
    if (truth.contact_count < 8) {
      const auto row = static_cast<std::size_t>(truth.contact_count++);
      copy(contact.point, truth.contact_point[row]);
      copy(contact.force, truth.contact_force[row]);
    }
  }
  truth.penetration = static_cast<float>(penetration);

  SupportPolygon support;
  for (std::size_t side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[side];
    truth.foot_slip[side] = 0.0F;
    copy(foot_force[side], truth.foot_force[side]);
    if (sole.link < 0) continue;
    const Eigen::Isometry3d frame = world.link_in_world(sole.link) * sole.frame;
    copy(frame.translation(), truth.foot_position[side]);
    copy(Eigen::Matrix3d(frame.linear()), truth.foot_attitude[side]);
    if (!(foot_force[side].z() > kLoaded)) continue;
    truth.foot_slip[side] =
        static_cast<float>(world.point_velocity(sole.link, frame.translation()).head<2>().norm());
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      support.add((frame * sole_corner(sole, corner)).head<2>());
    }
  }
  support.finish();
  const Eigen::Vector2d zmp =
      pressure > kLoaded ? Eigen::Vector2d(moment / pressure) : world.com().head<2>();
  truth.zmp = {static_cast<float>(zmp.x()), static_cast<float>(zmp.y())};
  truth.zmp_margin = support.count() > 0 ? static_cast<float>(support.margin(zmp)) : 0.0F;
  truth.fell = model.floating_base && (!(now.base.translation().z() > 0.5 * standing_height) ||
                                       !(now.base.linear()(2, 2) > kFallenTilt));
}

}  // namespace twinbus
