#include "sim/engine/local_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/index.h"
#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline sim {

namespace {

constexpr double kHeals = 3.0;        // of a driven world of order 2 or 3 [s]
constexpr double kRounding = 1e-9;    // of speeds [m/s]
constexpr std::array<double, 3> kShare = {1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0};

}  // namespace

LocalError::LocalError(std::size_t links, std::size_t others, const WorldConfig& config)
    : order_(config.engine == Engine::kArticulated ? std::clamp(config.order, 1, kMostOrder) : 1),
      limit_(std::max(config.accuracy, config.bands.off)),
      scale_(config.flight == Flight::kImplicit ? kShare[at(order_ - 1)] * config.step : 0.0),
      fall_(config.engine == Engine::kArticulated ? kGravity * config.step : std::numeric_limits<double>::quiet_NaN()),
      keep_(std::exp(-config.step / kHeals)),
      world_(links + others),
      own_(links),
      sum_(links + others, 0.0),
      off_(links + others, Eigen::Vector3d::Zero()) {}

void LocalError::begin(const std::vector<Eigen::Vector3d>& world, const std::vector<Eigen::Vector3d>& own) noexcept {
  for (std::size_t i = 0; i < world_.size(); ++i) world_[i].fill(world[i]);
  for (std::size_t i = 0; i < own_.size(); ++i) own_[i].fill(own[i]);
  std::fill(sum_.begin(), sum_.end(), 0.0);
  std::fill(off_.begin(), off_.end(), Eigen::Vector3d::Zero());
  driven_ = false;
  most_of_links_ = most_of_others_ = 0.0;
}

void LocalError::driven() noexcept {
  if (driven_) return;
  driven_ = true;
  if (order_ == 1) std::fill(sum_.begin(), sum_.end(), 0.0);
}

void LocalError::keep(const Eigen::Vector3d& now, Past& past) const noexcept {
  for (std::size_t i = at(order_ - 1); i > 0; --i) past[i] = past[i - 1];
  past[0] = now;
}

double LocalError::change(const Past& past, const Eigen::Vector3d& now) const noexcept {
  if (order_ == 1) return (now - past[0]).norm();
  if (order_ == 2) return (now - 2.0 * past[0] + past[1]).norm();
  return (now - 3.0 * past[0] + 3.0 * past[1] - past[2]).norm();
}

bool LocalError::add(const std::vector<Eigen::Vector3d>& world, const std::vector<Eigen::Vector3d>& own,
                     bool touched) noexcept {
  if (!(scale_ > 0.0)) return false;
  if (driven_) most_of_links_ = most_of_others_ = 0.0;
  const bool by_vectors = driven_ && order_ == 1;  // needs only what the last speed was, in world
  std::size_t i = 0;
  if (by_vectors) {  // of links it is asked in every step of every driven world
    double most = 0.0;
    for (; i < own_.size(); ++i) {
      off_[i] += scale_ * (world[i] - world_[i][0]);
      world_[i][0] = world[i];
      const double square = off_[i].squaredNorm();
      if (!(square <= most)) most = square;
    }
    most_of_links_ = std::sqrt(most);
  }
  for (; i < world_.size(); ++i) {
    const bool link = i < own_.size();
    Eigen::Vector3d faster = world[i] - world_[i][0];
    double changed = by_vectors ? 0.0 : change(world_[i], world[i]);
    keep(world[i], world_[i]);
    if (link) {
      changed = std::min(changed, change(own_[i], own[i]));
      keep(own[i], own_[i]);
    } else if ((faster + fall_ * Eigen::Vector3d::UnitZ()).norm() < kRounding) {
      faster.setZero();
      changed = 0.0;
    }
    if (by_vectors) {
      off_[i] += scale_ * faster;
      sum_[i] = off_[i].norm();
    } else {
      sum_[i] = (driven_ ? keep_ : 1.0) * sum_[i] + scale_ * changed;
    }
    double& most = link ? most_of_links_ : most_of_others_;
    if (!(sum_[i] <= most)) most = sum_[i];
  }
  double needed = most();
  if (order_ > 1 && !touched)
    needed = std::max(needed, most_of_links_ * static_cast<double>(std::max<std::size_t>(kLeastLinks, own_.size())));
  if (!(needed <= band_)) band_ = needed;
  return !(needed <= limit_);
}

}  // namespace twinbus::sim
