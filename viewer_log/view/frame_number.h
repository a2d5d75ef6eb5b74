// Numbers, points and poses as JSON for the page; a number that is not finite becomes null.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace twinbus::inline viewer_log {

using Json = nlohmann::json;
using Eigen::Vector3d;

// Rounded to a number of decimals, so that 0.1f does not print as 0.10000000149011612.
inline Json number(double value, int decimals = 4) {
  if (!std::isfinite(value)) return nullptr;
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

inline Json point(const Vector3d& p) { return {number(p.x()), number(p.y()), number(p.z())}; }

template <class T>
Vector3d vector(const std::array<T, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

inline Json pose(const Eigen::Isometry3d& isometry) {
  const Eigen::Quaterniond attitude(isometry.linear());
  Json list = point(isometry.translation());
  for (double value : {attitude.w(), attitude.x(), attitude.y(), attitude.z()}) {
    list.push_back(number(value, 5));
  }
  return list;
}

// The first count numbers of a message's array.
template <class Array>
Json numbers(const Array& values, int count, int decimals = 4) {
  Json list = Json::array();
  for (int i = 0; i < count; ++i) {
    list.push_back(number(static_cast<double>(values[static_cast<std::size_t>(i)]), decimals));
  }
  return list;
}

// Text from the bus may be any bytes; what is not UTF-8 becomes U+FFFD.
inline std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace twinbus::viewer_log
