#include "robot/collision/loop_joints.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robot/collision/collision_pairs.h"
#include "test/robot/fixtures.h"

namespace twinbus::test {
namespace {

Model with_loops(const std::string& loops) {
  return load_robot_texts({.folder = hrp1s().folder,
                           .yaml = hrp1s().yaml_text + "\nloops:\n" + loops,
                           .urdf = hrp1s().urdf_text,
                           .srdf = hrp1s().srdf_text});
}

bool names(const Model& model, const std::vector<int>& joints, const std::string& joint) {
  return std::find(joints.begin(), joints.end(), model.find_joint(joint)) != joints.end();
}

TEST(LoopJoints, PinnedHandsTieTheJointsOfBothArmsAndNoOther) {
  const Model model = with_loops("  - {link: LHAND, to: RHAND}\n");
  const std::vector<int> joints = joints_in_loops(model);
  EXPECT_EQ(joints.size(), model.hands[0].joints.size() + model.hands[1].joints.size());
  for (const Hand& hand : model.hands) {
    for (const int j : hand.joints)
      EXPECT_TRUE(names(model, joints, model.joints[static_cast<std::size_t>(j)].name));
  }
  EXPECT_NE(loops_sentence(model).find("LARM_ELBOW"), std::string::npos);
}

TEST(LoopJoints, ALinkPinnedToTheWorldTiesAllJointsToTheBase) {
  const Model model = with_loops("  - {link: LHAND, to: world}\n");
  const std::vector<int> joints = joints_in_loops(model);
  EXPECT_TRUE(names(model, joints, "LARM_ELBOW"));
  EXPECT_TRUE(names(model, joints, "CHEST"));
  EXPECT_FALSE(names(model, joints, "RARM_ELBOW"));
}

TEST(LoopJoints, SpringsAndNoLoopsTieNothing) {
  for (const Model& model : {hrp1s(), with_loops("  - {link: LHAND, to: RHAND, length: 0.1}\n")}) {
    EXPECT_TRUE(joints_in_loops(model).empty());
    EXPECT_TRUE(pinned_links(model).empty());
    EXPECT_EQ(loops_sentence(model), "");
  }
}

TEST(LoopJoints, PinnedLinksAreNeighboursThatAreNotCheckedForCollision) {
  const Model model = with_loops("  - {link: LHAND, to: RHAND}\n");
  const PinnedLinks pin = pinned_links(model).front();
  const auto checked = [&](const std::vector<CollisionPair>& pairs) {
    return std::count_if(pairs.begin(), pairs.end(), [&](const CollisionPair& p) {
      return (p.link_a == pin.a && p.link_b == pin.b) || (p.link_a == pin.b && p.link_b == pin.a);
    });
  };
  EXPECT_EQ(checked(pairs_to_check(hrp1s())), 1);
  EXPECT_EQ(checked(pairs_to_check(model)), 0);
  EXPECT_EQ(pairs_to_check(model).size(), pairs_to_check(hrp1s()).size() - 1);
}

TEST(LoopJoints, ALoopOfALinkThatIsNotThereIsRefusedByName) {
  const std::string complaint =
      error_of([] { (void)joints_in_loops(with_loops("  - {link: LHAND, to: TAIL}\n")); });
  EXPECT_NE(complaint.find("loops: there is no link TAIL"), std::string::npos) << complaint;
}

}  // namespace
}  // namespace twinbus::test
