#include "control/foot_compliance.h"

#include <algorithm>
#include <cmath>

namespace twinbus {

namespace {
constexpr double kSinkFilter = 0.015;  // [s]
}

void FootCompliance::start() noexcept {
  fresh_ = true;
  difference_ = 0.0;
  for (auto& moment : moment_) moment.setZero();
}

void FootCompliance::update(const std::array<FootLoad, 2>& wanted,
                            const std::array<FootLoad, 2>& measured, bool measured_valid,
                            double dt) noexcept {
  const FootComplianceGains& g = gains_;
  for (std::size_t s = 0; s < 2; ++s) {
    const double share = fresh_ ? 1.0 : dt / (dt + g.filter);
    measured_[s].force += share * (measured[s].force - measured_[s].force);
    measured_[s].moment += share * (measured[s].moment - measured_[s].moment);
    // What is wanted is compared with what it did: as late as the servo and the filter make it.
    const double late = fresh_ ? 1.0 : dt / (dt + g.lag);
    late_[s].force += late * (wanted[s].force - late_[s].force);
    late_[s].moment += late * (wanted[s].moment - late_[s].moment);
    const double slow = fresh_ ? 1.0 : dt / (dt + kSinkFilter);
    sink_[s] += slow * (wanted[s].force / sole_.vertical - sink_[s]);
    bend_[s] += slow * (-wanted[s].moment.cwiseQuotient(sole_.turning) - bend_[s]);
  }
  fresh_ = false;

  for (std::size_t s = 0; s < 2; ++s) {
    Eigen::Vector2d rate = -moment_[s] / g.ankle_leak;
    if (measured_valid) rate += g.ankle * (late_[s].moment - measured_[s].moment);
    const double most = g.most_lever * std::max(0.0, wanted[s].force);
    moment_[s] = (moment_[s] + dt * rate).cwiseMax(-most).cwiseMin(most);
  }
  double rate = -difference_ / g.difference_leak;
  if (measured_valid) {
    const double wanted_difference = late_[0].force - late_[1].force;
    const double difference = measured_[0].force - measured_[1].force;
    rate += g.difference / vertical_ * (difference - wanted_difference);
  }
  difference_ = std::clamp(difference_ + dt * rate, -g.most_height, g.most_height);
}

double FootCompliance::height(int foot) const noexcept {
  const auto s = static_cast<std::size_t>(foot);
  return (foot == 0 ? 0.5 : -0.5) * difference_ - (sink_[s] - 0.5 * (sink_[0] + sink_[1]));
}

}  // namespace twinbus
