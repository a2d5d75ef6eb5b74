#include "viewer_log/view/scene_frame.h"

#include <gtest/gtest.h>

#include <cstring>

#include "robot/description/load.h"

namespace twinbus {
namespace {

constexpr std::int64_t kSceneNow = 5'000'000'000, kRun = 77;

const Model& robot() {
  static const Model loaded = load_robot("hrp1s");
  return loaded;
}

StackView running() {
  StackView view(robot());
  RobotState state;
  state.run_id = kRun;
  state.joint_count = static_cast<std::int16_t>(robot().bus_count());
  state.attitude = {1, 0, 0, 0};
  view.on_state(state, kSceneNow);
  return view;
}

ObstaclesPiece ball(std::int64_t run, float x) {
  ObstaclesPiece piece;
  piece.scene_id = run;
  piece.pieces = 1;
  piece.count = 1;
  piece.shape[0] = ObstacleShape::kSphere;
  piece.size[0] = {0.1F, 0, 0};
  piece.position[0] = {x, 0, 0.1F};
  for (auto& attitude : piece.attitude) attitude = {1, 0, 0, 0};
  return piece;
}

Json scene(const StackView& view) { return Json::parse(scene_frame(view)); }

TEST(SceneFrame, WhatIsOfAnotherRunIsNotDrawn) {
  StackView view = running();
  view.on_terrain(ball(kRun + 1, 1));
  view.on_loose(ball(kRun + 1, 1), kSceneNow);
  view.on_footsteps(ball(kRun + 1, 1), kSceneNow);
  EXPECT_TRUE(scene(view)["terrain"].empty());
  EXPECT_TRUE(scene(view)["loose"].empty());
  EXPECT_FALSE(view.footsteps_apply(kSceneNow));
}

// The ground is drawn anyway; what a hand holds is drawn with the link that carries it.
TEST(SceneFrame, TheFloorIsNoObstacleAndWhatIsHeldIsDrawn) {
  StackView view = running();
  ObstaclesPiece around = ball(kRun, 1);
  around.count = 2;
  around.shape[1] = ObstacleShape::kBox;
  around.size[1] = {0.3F, 5, 0.1F};
  around.position[1] = {0, 0, -0.05F};
  view.on_obstacles(around);
  ASSERT_EQ(scene(view)["obstacles"].size(), 1U);
  EXPECT_EQ(scene(view)["obstacles"][0]["shape"], 2);
  EXPECT_TRUE(scene(view)["held"].empty());
  const std::int64_t version = view.scene_version();
  ObstaclesPiece held = ball(5, 0);
  held.pieces = 2;
  held.piece = 1;  // the right hand
  view.on_held(held);
  EXPECT_NE(view.scene_version(), version);
  ASSERT_EQ(scene(view)["held"].size(), 1U);
  EXPECT_EQ(scene(view)["held"][0]["link"], robot().links[static_cast<std::size_t>(robot().hands[1].link)].name);
  held.scene_id = 6;
  held.count = 0;
  view.on_held(held);
  EXPECT_TRUE(scene(view)["held"].empty());
}

TEST(SceneFrame, ABodyThatMovesIsNoNewScene) {
  StackView view = running();
  view.on_loose(ball(kRun, 1), kSceneNow);
  const std::int64_t version = view.scene_version();
  view.on_loose(ball(kRun, 2), kSceneNow);
  EXPECT_EQ(view.scene_version(), version);
  Json live;
  add_moving(view, kSceneNow, Eigen::Isometry3d::Identity(), live);
  EXPECT_EQ(live["loose"][0][0], 2.0);
  view.on_terrain(ball(kRun, 1));
  EXPECT_GT(view.scene_version(), version);
  EXPECT_EQ(scene(view)["terrain"].size(), 1U);
}

TEST(SceneFrame, FootstepsThatNobodyRenewsAreGone) {
  StackView view = running();
  view.on_footsteps(ball(kRun, 1), kSceneNow);
  Json live;
  add_moving(view, kSceneNow, Eigen::Isometry3d::Identity(), live);
  EXPECT_EQ(live["footsteps"].size(), 1U);
  Json later;
  add_moving(view, kSceneNow + 1'000'000'000, Eigen::Isometry3d::Identity(), later);
  EXPECT_FALSE(later.contains("footsteps"));
}

ModelTextPiece part(const std::string& picture, std::int16_t piece, std::int64_t taken = 1) {
  ModelTextPiece p;
  p.utime = taken;
  p.run_id = kRun;
  p.kind = kCameraPicture;
  p.size = static_cast<std::int32_t>(picture.size());
  p.pieces = static_cast<std::int16_t>((picture.size() + kModelTextBytes - 1) / kModelTextBytes);
  p.piece = piece;
  const std::string text =
      picture.substr(static_cast<std::size_t>(piece) * kModelTextBytes, kModelTextBytes);
  p.count = static_cast<std::int16_t>(text.size());
  std::memcpy(p.text.data(), text.data(), text.size());
  return p;
}

TEST(CameraView, APictureIsWholeOrNotShown) {
  const std::string picture = "\xff\xd8\xff" + std::string(3000, 'x');
  CameraView camera;
  camera.on_piece(part(picture, 2), kSceneNow);
  camera.on_piece(part(picture, 0), kSceneNow);
  camera.on_piece(part(picture, 0), kSceneNow);  // said again
  EXPECT_EQ(camera.version(), 0);
  camera.on_piece(part(picture, 1, 2), kSceneNow);  // of the next picture
  camera.on_piece(part(picture, 1), kSceneNow);     // overtaken
  EXPECT_EQ(camera.version(), 0);
  for (std::int16_t i = 0; i < 3; ++i) camera.on_piece(part(picture, i, 3), kSceneNow);
  EXPECT_EQ(camera.version(), 1);
  EXPECT_EQ(camera.picture(), picture);
  const Json frame = Json::parse(camera.frame());
  EXPECT_EQ(frame["image"].get<std::string>().substr(0, 31), "data:image/jpeg;base64,/9j/eHh4");
}

TEST(CameraView, NothingButPicturesOfItsSize) {
  CameraView camera;
  camera.on_piece(part("GIF89a, no picture of ours", 0), kSceneNow);
  ModelTextPiece wrong = part("\x89PNG\r\n", 0);
  for (const auto& [pieces, size] : {std::pair{30000, 6}, {1, 1 << 24}, {0, 6}, {1, -1}}) {
    wrong.pieces = static_cast<std::int16_t>(pieces);
    wrong.size = size;
    camera.on_piece(wrong, kSceneNow);
  }
  EXPECT_EQ(camera.version(), 0);
}

}  // namespace
}  // namespace twinbus
