#include "viewer_log/view/scene_frame.h"

namespace twinbus {

namespace {

Eigen::Isometry3d pose_of(const ObstaclesPiece& piece, std::size_t row) {
  const auto& a = piece.attitude[row];
  Eigen::Isometry3d found = Eigen::Isometry3d::Identity();
  found.linear() =
      Eigen::Quaternionf(a[0], a[1], a[2], a[3]).normalized().toRotationMatrix().cast<double>();
  found.translation() = vector(piece.position[row]);
  return found;
}

template <class Use>
void each_row(const std::vector<ObstaclesPiece>& pieces, Use use) {
  for (const ObstaclesPiece& piece : pieces) {
    for (std::size_t row = 0; row < static_cast<std::size_t>(piece.count); ++row) use(piece, row);
  }
}

Json shapes(const std::vector<ObstaclesPiece>& pieces, const Eigen::Isometry3d& place) {
  Json list = Json::array();
  each_row(pieces, [&](const ObstaclesPiece& piece, std::size_t row) {
    list.push_back({{"shape", static_cast<int>(piece.shape[row])},
                    {"size", point(vector(piece.size[row]))},
                    {"pose", pose(place * pose_of(piece, row))}});
  });
  return list;
}

bool is_of(const std::vector<ObstaclesPiece>& pieces, std::int64_t run_id) {
  return !pieces.empty() && pieces.front().scene_id == run_id;
}

}  // namespace

std::string scene_frame(const StackView& view, const Eigen::Isometry3d& place) {
  const Eigen::Isometry3d sim = place * view.world_from_sim();
  const std::int64_t run = view.state().value.run_id;
  Json frame = {{"type", "scene"},
                {"obstacles", shapes(view.obstacles(), Eigen::Isometry3d::Identity())}};
  frame["terrain"] = is_of(view.terrain(), run) ? shapes(view.terrain(), sim) : Json::array();
  frame["loose"] = is_of(view.loose(), run) ? shapes(view.loose(), sim) : Json::array();
  return dump(frame);
}

void add_moving(const StackView& view, std::int64_t now_ns, const Eigen::Isometry3d& place,
                Json& frame) {
  if (view.loose_applies(now_ns)) {
    const Eigen::Isometry3d sim = place * view.world_from_sim();
    Json poses = Json::array();
    each_row(view.loose(), [&](const ObstaclesPiece& piece, std::size_t row) {
      poses.push_back(pose(sim * pose_of(piece, row)));
    });
    frame["loose"] = poses;
  }
  if (!view.footsteps_apply(now_ns)) return;
  // They belong to the feet as the controller estimates them.
  const Eigen::Isometry3d ground =
      place * view.drawn_from_estimated(now_ns) * view.estimator().ground_in_world();
  frame["footsteps"] = shapes({view.footsteps().value}, ground);
}

}  // namespace twinbus
