#include "robot/mjcf/urdf_text.h"

#include <cstdlib>

#include "common/math/pose_math.h"
#include "common/text/formatted.h"

namespace twinbus::inline robot {

std::string exact_number(double value) {
  std::string text;
  for (const int digits : {9, 15, 17}) {
    text = formatted("%.*g", digits, value == 0.0 ? 0.0 : value);
    if (std::strtod(text.c_str(), nullptr) == value) break;
  }
  return text;
}

std::string exact_numbers(const Eigen::Vector3d& v) {
  return exact_number(v.x()) + " " + exact_number(v.y()) + " " + exact_number(v.z());
}

std::string urdf_origin(const Eigen::Isometry3d& place) {
  return "<origin xyz=\"" + exact_numbers(place.translation()) + "\" rpy=\"" +
         exact_numbers(rpy_from_rotation(place.linear())) + "\"/>";
}

}  // namespace twinbus::robot
