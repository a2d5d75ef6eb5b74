#include "robot/hand/tools.h"

#include <algorithm>
#include <stdexcept>

#include "common/math/pose_math.h"
#include "common/text/xml.h"

namespace twinbus::inline robot {

namespace {

constexpr double kFar = 5.0;  // from a hand [m]

Eigen::Isometry3d placed(const double* xyz_rpy) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << xyz_rpy[0], xyz_rpy[1], xyz_rpy[2];
  pose.linear() = rotation_from_rpy(xyz_rpy[3], xyz_rpy[4], xyz_rpy[5]);
  return pose;
}

// Of a link of the URDF, in the hand that carries it.
Eigen::Isometry3d link_in_hand(const Model& model, const Hand& hand, const std::string& name, const std::string& who) {
  const Frame& frame = frame_called(model, name, who);
  if (frame.link != hand.link) {
    throw std::runtime_error(who + ": link " + name + " is not carried by the hand on " +
                             model.links[static_cast<std::size_t>(hand.link)].name + ": a joint is between them");
  }
  return hand.frame.inverse() * frame.in_link;
}

}  // namespace

Eigen::Isometry3d tool_in_hand(const Model& model, const Hand& hand, const std::string& text) {
  if (text.find(',') != std::string::npos) {
    std::string blanks = text;
    std::replace(blanks.begin(), blanks.end(), ',', ' ');
    double values[6] = {};
    const bool turned = std::count(text.begin(), text.end(), ',') == 5;
    if (!parse_numbers(blanks, values, turned ? 6 : 3))
      throw std::runtime_error("tool '" + text + "' is not X,Y,Z or X,Y,Z,R,P,Y [m, rad] in the frame of the hand");
    if (!std::all_of(values, values + 3, [](double v) { return std::abs(v) <= kFar; }))
      throw std::runtime_error("tool '" + text + "' is more than 5 m from the hand");
    return placed(values);
  }
  for (const Tool& tool : model.tools) {
    if (tool.name == text) return link_in_hand(model, hand, tool.frame, tool.where) * tool.offset;
  }
  return link_in_hand(model, hand, text, "no tool is called so");
}

}  // namespace twinbus::robot
