#include "planner/arm_path_pieces.h"

#include <algorithm>
#include <cstddef>

namespace twinbus::inline planner {

std::vector<ArmPathPiece> to_pieces(const ArmPlan& plan, const ArmPathIds& ids) {
  ArmPathPiece common;
  common.planner_id = ids.planner_id;
  common.run_id = ids.run_id;
  common.goal_id = ids.goal_id;
  common.path_id = ids.path_id;
  common.status = plan.status;
  common.miss = static_cast<float>(plan.miss);
  if (plan.status != ArmPathStatus::kOk) {
    common.link_a = static_cast<std::int8_t>(std::min(plan.pair.link_a, 127));
    common.link_b = static_cast<std::int8_t>(std::min(plan.pair.link_b, 127));
    return {common};
  }
  common.clearance = static_cast<float>(plan.clearance);

  constexpr std::size_t kPer = kKnotsPerPiece;
  const std::size_t knots = plan.path.size();
  common.pieces = static_cast<std::int16_t>((knots + kPer - 1) / kPer);
  common.joint_count = static_cast<std::int16_t>(plan.joints.size());
  for (std::size_t k = 0; k < plan.joints.size(); ++k)
    common.joint[k] = static_cast<std::int16_t>(plan.joints[k]);

  std::vector<ArmPathPiece> pieces;
  for (std::size_t first = 0; first < knots; first += kPer) {
    ArmPathPiece piece = common;
    piece.piece = static_cast<std::int16_t>(pieces.size());
    piece.knot_count = static_cast<std::int16_t>(std::min(kPer, knots - first));
    for (std::size_t row = 0; row < static_cast<std::size_t>(piece.knot_count); ++row) {
      const Knot& knot = plan.path[first + row];
      piece.time[row] = knot.time;
      for (std::size_t k = 0; k < plan.joints.size(); ++k) {
        piece.q[row][k] = knot.q[static_cast<int>(k)];
        piece.qd[row][k] = static_cast<float>(knot.qd[static_cast<int>(k)]);
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace twinbus::planner
