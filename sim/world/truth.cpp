#include "sim/world/truth.h"

#include <algorithm>
#include <array>

#include "lcmtypes/msg/labels.h"
#include "robot/estimation/support_polygon.h"

namespace twinbus::inline sim {

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

void fill_truth(const Model& model, const FeltFeet& feet, const World& world, double standing_height, SimTruth& truth) noexcept {
  const Configuration& now = world.configuration();
  copy(now.base.translation(), truth.base_position);
  copy(Eigen::Matrix3d(now.base.linear()), truth.base_attitude);
  copy(now.base_velocity, truth.base_velocity);
  copy(now.base_angular_velocity, truth.base_angular_velocity);
  copy(world.com(), truth.com);
  copy(world.com_velocity(), truth.com_velocity);

  const auto count = static_cast<std::size_t>(feet.count);
  truth.foot_count = static_cast<std::int16_t>(feet.count);
  std::array<Eigen::Vector3d, kMaxFeet> foot_force;
  foot_force.fill(Eigen::Vector3d::Zero());
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
    if (!contact.moment.isZero(0.0)) moment += Eigen::Vector2d(-contact.moment.y(), contact.moment.x());
    for (std::size_t foot = 0; foot < count; ++foot) {
      if (feet.foot[foot].feels(contact)) foot_force[foot] += contact.force;
    }
    if (truth.contact_count < 8) {
      const auto row = static_cast<std::size_t>(truth.contact_count++);
      copy(contact.point, truth.contact_point[row]);
      copy(contact.force, truth.contact_force[row]);
    }
  }
  truth.penetration = static_cast<float>(penetration);

  SupportPolygon support;
  for (std::size_t k = 0; k < count; ++k) {
    const FeltFoot& foot = feet.foot[k];
    truth.foot_slip[k] = 0.0F;
    copy(foot_force[k], truth.foot_force[k]);
    if (foot.link < 0) continue;
    Eigen::Isometry3d frame = world.link_in_world(foot.link) * foot.frame;
    frame.translation().z() -= foot.radius;
    copy(frame.translation(), truth.foot_position[k]);
    copy(Eigen::Matrix3d(frame.linear()), truth.foot_attitude[k]);
    if (!(foot_force[k].z() > kLoaded)) continue;
    truth.foot_slip[k] = static_cast<float>(world.point_velocity(foot.link, frame.translation()).head<2>().norm());
    if (foot.side < 0) support.add(frame.translation().head<2>());
    for (int corner = 0; foot.side >= 0 && corner < kSoleCorners; ++corner) {
      support.add((frame * sole_corner(model.soles[static_cast<std::size_t>(foot.side)], corner)).head<2>());
    }
  }
  support.finish();
  const Eigen::Vector2d zmp =
      pressure > kLoaded ? Eigen::Vector2d(moment / pressure) : world.com().head<2>();
  truth.zmp = {static_cast<float>(zmp.x()), static_cast<float>(zmp.y())};
  truth.zmp_margin = support.count() > 0 ? static_cast<float>(support.margin(zmp)) : 0.0F;
  truth.fell = model.floating_base && (!(world.com().z() > 0.5 * standing_height) ||
                                       !(now.base.linear()(2, 2) > kFallenTilt));
}

void fill_doubts(const TrustCounts& counts, SimTruth& truth) noexcept {
  static_assert(std::tuple_size_v<decltype(truth.doubted)> == kDoubts);
  static_assert(static_cast<std::size_t>(last_of(StepDoubt{})) == kDoubts);
  constexpr auto same = [](Doubt ours, StepDoubt theirs) { return static_cast<int>(ours) + 1 == static_cast<int>(theirs); };
  static_assert(same(Doubt::kUnconverged, StepDoubt::kUnconverged) && same(Doubt::kUnsettled, StepDoubt::kUnsettled) &&
                same(Doubt::kEnergy, StepDoubt::kEnergyGained) && same(Doubt::kDeep, StepDoubt::kFirstSeenDeep) &&
                same(Doubt::kThrough, StepDoubt::kTunnelling) && same(Doubt::kCoarse, StepDoubt::kTooCoarse));
  constexpr long kMost = 1 << 30;
  truth.doubted_steps = static_cast<std::int32_t>(std::min(counts.doubted, kMost));
  for (std::size_t i = 0; i < kDoubts; ++i) truth.doubted[i] = static_cast<std::int32_t>(std::min(counts.steps[i], kMost));
  truth.last_doubt = counts.doubted > 0 ? static_cast<StepDoubt>(static_cast<int>(counts.last) + 1) : StepDoubt::kNone;
  truth.doubted_since = counts.doubted > 0 ? counts.first_at : 0.0;
}

}  // namespace twinbus::sim
