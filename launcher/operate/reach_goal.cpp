#include "launcher/operate/reach_goal.h"

#include <algorithm>
#include <stdexcept>

#include "common/math/pose_math.h"
#include "common/text/closest_name.h"

namespace twinbus::inline launcher {

namespace {
constexpr double kOwnFrame = 1e-9;  // a tool no further from the hand's frame is that [m, rad]
}

ReachFrame reach_frame(const Model& model, const std::string& name) {
  using Kind = ReachFrame::Kind;
  if (name == "ground") return {};
  if (name == "base") return {.kind = Kind::kBase};
  if (name == "world") return {.kind = Kind::kWorld};
  const auto found = std::find_if(model.frames.begin(), model.frames.end(), [&](const Frame& f) { return f.name == name; });
  if (found != model.frames.end()) return {.kind = Kind::kLink, .frame = static_cast<int>(found - model.frames.begin())};
  throw std::runtime_error("frame '" + name + "' is none of ground, base and world, and no link of " + model.name +
                           suggestion(name, model.frames));
}

std::optional<Eigen::Isometry3d> frame_in_ground(const ReachFrame& frame, const Model& model, const Estimator& estimator,
                                                 const std::optional<Eigen::Isometry3d>& base_in_world) {
  using Kind = ReachFrame::Kind;
  const Eigen::Isometry3d to_ground = estimator.ground_in_world().inverse();
  const auto link = [&](int index) { return Eigen::Isometry3d(to_ground * estimator.kinematics().link_in_world(index)); };
  switch (frame.kind) {
    case Kind::kGround:
      break;
    case Kind::kBase:
      return link(model.plane_joints.empty() ? 0 : model.plane_joints.back() + 1);
    case Kind::kWorld:
      if (!base_in_world) return {};
      return link(0) * base_in_world->inverse();
    case Kind::kLink: {
      const Frame& of = model.frames[static_cast<std::size_t>(frame.frame)];
      return link(of.link) * of.in_link;
    }
  }
  return Eigen::Isometry3d::Identity();
}

void aim_hand(const Eigen::Isometry3d& tool_in_ground, bool oriented, const Eigen::Isometry3d& tool_in_hand,
              const Eigen::Isometry3d& hand_in_ground, ArmGoal& goal) {
  const bool own = tool_in_hand.isApprox(Eigen::Isometry3d::Identity(), kOwnFrame);
  Eigen::Isometry3d tool = tool_in_ground;
  if (!oriented && !own) tool.linear() = (hand_in_ground * tool_in_hand).linear();
  const Eigen::Isometry3d hand = tool * tool_in_hand.inverse();
  goal.kind = oriented || !own ? ArmGoalKind::kPose : ArmGoalKind::kPosition;
  Eigen::Map<Eigen::Vector3d>(goal.position.data()) = hand.translation();
  if (goal.kind == ArmGoalKind::kPose) goal.orientation = array_from_rotation<double>(hand.linear());
}

}  // namespace twinbus::launcher
