#include "control/legs/foot_compliance.h"

#include <algorithm>

namespace twinbus::inline control {

void FootCompliance::start() noexcept {
  fresh_ = true;
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
    const double late = fresh_ ? 1.0 : dt / (dt + g.lag);
    late_[s].force += late * (wanted[s].force - late_[s].force);
    late_[s].moment += late * (wanted[s].moment - late_[s].moment);
    Eigen::Vector2d rate = -moment_[s] / g.ankle_leak;
    if (measured_valid) rate += g.ankle * (late_[s].moment - measured_[s].moment);
    const double most = g.most_lever * std::max(0.0, wanted[s].force);
    moment_[s] = (moment_[s] + dt * rate).cwiseMax(-most).cwiseMin(most);
  }
  fresh_ = false;
}

}  // namespace twinbus::control
