#include "robot/mjcf/urdf_text.h"

#include <cstdio>

#include "common/math/pose_math.h"

namespace twinbus {

std::string exact_number(double value) {
  char text[40];
  for (const int digits : {9, 15, 17}) {
    std::snprintf(text, sizeof(text), "%.*g", digits, value == 0.0 ? 0.0 : value);
    double back = 0.0;
    if (std::sscanf(text, "%lf", &back) == 1 && back == value) break;
  }
  return text;
}

std::string exact_numbers(const Eigen::Vector3d& v) {
  return exact_number(v.x()) + " " + exact_number(v.y()) + " " + exact_number(v.z());
}

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return out;
}

std::string urdf_origin(const Eigen::Isometry3d& place) {
  return "<origin xyz=\"" + exact_numbers(place.translation()) + "\" rpy=\"" +
         exact_numbers(rpy_from_rotation(place.linear())) + "\"/>";
}

}  // namespace twinbus
