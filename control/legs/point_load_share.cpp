#include "control/legs/point_load_share.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "common/math/index.h"

namespace twinbus::inline control {

namespace {
constexpr double kSoft = 1e-6;  // of the weight: what points on a line cannot balance is left
constexpr double kLeastLength = 0.01;  // [m]
}  // namespace

void share_load_on_points(PointLoads& loads) noexcept {
  loads.share.fill(0.0);
  std::array<bool, kMaxFeet> carries{};
  double length = kLeastLength;  // makes shares of moments
  for (int i = 0; i < loads.count; ++i) {
    carries[at(i)] = loads.away[at(i)].allFinite();
    if (carries[at(i)]) length = std::max(length, loads.away[at(i)].norm());
  }
  const auto column = [&](int i) -> Eigen::Vector3d {
    return {1.0, loads.away[at(i)].x() / length, loads.away[at(i)].y() / length};
  };
  for (int round = 0; round < loads.count; ++round) {
    Eigen::Matrix3d normal = kSoft * Eigen::Matrix3d::Identity();
    for (int i = 0; i < loads.count; ++i) {
      if (carries[at(i)]) normal += column(i) * column(i).transpose();
    }
    const Eigen::Vector3d price = normal.llt().solve(Eigen::Vector3d::UnitX());
    int worst = -1;
    double least = 0.0;
    for (int i = 0; i < loads.count; ++i) {
      loads.share[at(i)] = carries[at(i)] ? column(i).dot(price) : 0.0;
      if (loads.share[at(i)] < least) {
        least = loads.share[at(i)];
        worst = i;
      }
    }
    if (worst < 0) break;
    carries[at(worst)] = false;
  }
  double sum = 0.0;
  for (double& share : loads.share) sum += share = std::max(0.0, share);
  if (!(sum > 0.0)) return;
  for (double& share : loads.share) share /= sum;
}

}  // namespace twinbus::control
