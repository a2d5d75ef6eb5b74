#include "robot/collision/exact/pair_proof.h"

#include <gtest/gtest.h>

#include "common/math/index.h"

namespace twinbus {
namespace {

// A post, and a ball at the end of two turning arms of 0.3 m, 1 m beside it.
Model crane(double swing) {
  Model model;
  model.name = "crane";
  model.links.resize(3);
  Shape post;
  post.size = Eigen::Vector3d(0.1, 0.1, 1.0);
  model.links[0].collision.push_back(post);
  Shape ball;
  ball.kind = ShapeKind::kSphere;
  ball.size.x() = 0.05;
  ball.pose.translation() = Eigen::Vector3d(-0.3, 0.0, 0.0);
  model.links[2].collision.push_back(ball);
  for (int k = 0; k < 2; ++k) {
    model.links[at(k + 1)].name = k == 0 ? "upper" : "lower";
    model.links[at(k + 1)].parent = k;
    Joint joint;
    joint.name = k == 0 ? "shoulder" : "elbow";
    joint.parent = k;
    joint.child = k + 1;
    joint.lower = -swing;
    joint.upper = swing;
    joint.placement.translation() = Eigen::Vector3d(k == 0 ? 0.5 : -0.3, 0.0, 0.0);
    model.joints.push_back(joint);
  }
  model.links[0].name = "post";
  // Something on the link between, or post and ball are neighbours.
  Shape knob = ball;
  knob.size.x() = 0.01;
  knob.pose.translation().setZero();
  model.links[1].collision.push_back(knob);
  return model;
}

PairVerdict of(const Model& model, int a, int b) {
  for (const PairVerdict& v : judge_pairs(model, build_geometry(model))) {
    if (v.pair.link_a == a && v.pair.link_b == b) return v;
  }
  return {};
}

TEST(PairProof, OnlyWhatCannotTouchIsProvedNeverToTouch) {
  EXPECT_EQ(of(crane(1.5), 0, 1).kind, PairKind::kNeighbours);
  // Stretched out, ball and post touch: the arm is too long for any range around zero.
  EXPECT_EQ(of(crane(1.5), 0, 2).kind, PairKind::kTouches);
  EXPECT_EQ(of(crane(1.5), 0, 2).posture.size(), 2);
  Model folded = crane(0.4);
  folded.joints[0].lower = 1.2;  // turned aside
  folded.joints[0].upper = 1.9;
  const PairVerdict never = of(folded, 0, 2);
  EXPECT_EQ(never.kind, PairKind::kNever);
  EXPECT_GE(never.cells, 1);
}

TEST(PairProof, TheSrdfNamesProvedPairsWithTheirReason) {
  Model folded = crane(0.4);
  folded.joints[0].lower = 1.2;
  folded.joints[0].upper = 1.9;
  folded.srdf_text = "<robot name=\"crane\">\n</robot>\n";
  const RobotGeometry geometry = build_geometry(folded);
  const std::string text = srdf_with_pairs(folded, judge_pairs(folded, geometry));
  EXPECT_NE(text.find("link1=\"post\" link2=\"lower\" reason=\"Never, proved\""),
            std::string::npos);
  EXPECT_NE(text.find("link1=\"post\" link2=\"upper\" reason=\"Adjacent\""), std::string::npos);
  EXPECT_LT(text.find("Never"), text.find("</robot>"));
  folded.disabled_pairs = {{0, 2}};
  EXPECT_EQ(srdf_with_pairs(folded, judge_pairs(folded, geometry)).find("Never"),
            std::string::npos);
}

}  // namespace
}  // namespace twinbus
