#include "viewer_log/view/scene_frame.h"

#include "robot/collision/thing_name.h"
#include "robot/description/model.h"

namespace twinbus::inline viewer_log {

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

Json shape_frame(ObstacleShape shape, const Eigen::Vector3d& size, const Eigen::Isometry3d& at) {
  return {{"shape", static_cast<int>(shape)}, {"size", point(size)}, {"pose", pose(at)}};
}

Json shapes(const std::vector<ObstaclesPiece>& pieces, const Eigen::Isometry3d& place) {
  Json list = Json::array();
  each_row(pieces, [&](const ObstaclesPiece& piece, std::size_t row) {
    list.push_back(shape_frame(piece.shape[row], vector(piece.size[row]), place * pose_of(piece, row)));
  });
  return list;
}

// Without the ground, which is drawn anyway.
Json standing(const std::vector<Obstacle>& things) {
  Json list = Json::array();
  for (const Obstacle& thing : things) {
    if (thing.hand < 0 && !is_floor(thing)) list.push_back(shape_frame(thing.shape, thing.size, thing.pose));
  }
  return list;
}

// By the link that carries it.
Json held(const StackView& view) {
  Json list = Json::array();
  for (const Obstacle& thing : view.things()) {
    if (thing.hand < 0 || !takes_part(thing, view.model())) continue;
    const Hand* hand = hand_of(view.model(), thing.hand);
    list.push_back(shape_frame(thing.shape, thing.size, hand->frame * thing.pose));
    list.back()["link"] = view.model().links[static_cast<std::size_t>(hand->link)].name;
  }
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
                {"obstacles", standing(view.things())},
                {"held", held(view)}};
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

}  // namespace twinbus::viewer_log
