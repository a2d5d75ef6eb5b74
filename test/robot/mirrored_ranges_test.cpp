// Ranges that were mirrored as if an axis pointed the other way: found, and put right in legs.

#include "robot/lint/mirrored_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "robot/description/load.h"
#include "robot/onboarding/anatomy.h"
#include "robot/lint/mend.h"

namespace twinbus {
namespace {

Model turned(Model model, const std::vector<std::string>& joints) {
  for (const std::string& name : joints) {
    Joint& joint = model.joints[static_cast<std::size_t>(model.find_joint(name))];
    std::swap(joint.lower, joint.upper);
    joint.lower = -joint.lower, joint.upper = -joint.upper;
  }
  return model;
}

TEST(MirroredRanges, OfOurRobotsAreImages) {
  for (const char* name : {"hrp1s", "hrp2p", "biped12", "quad12"}) {
    const Model model = load_robot(name);
    EXPECT_TRUE(unmirrored_ranges(model, model.leg_joints).empty()) << name;
  }
}

TEST(MirroredRanges, KeepTheOneThatALegNeeds) {
  const Model right = load_robot("hrp1s");
  const std::vector<std::string> wrong = {"RLEG_KNEE", "LLEG_HIP_P", "RLEG_ANKLE_P", "LARM_SHOULDER_P"};
  const Model model = turned(right, wrong);
  const std::vector<UnmirroredRange> found = unmirrored_ranges(model, model.leg_joints);
  ASSERT_EQ(found.size(), wrong.size());
  for (const UnmirroredRange& fault : found) {
    const Joint& other = right.joints[static_cast<std::size_t>(fault.other)];
    EXPECT_EQ(fault.of_leg, other.name.find("LEG") != std::string::npos) << other.name;
    if (!fault.of_leg) continue;
    EXPECT_NE(std::find(wrong.begin(), wrong.end(), other.name), wrong.end()) << other.name;
    EXPECT_NEAR(fault.lower, other.lower, 1e-9) << other.name;
    EXPECT_NEAR(fault.upper, other.upper, 1e-9) << other.name;
  }
}

TEST(MirroredRanges, AreMendedInTheFile) {
  const Model whole = load_robot("hrp1s");
  const std::string file = whole.folder + "/hrp1s.urdf";
  const Model right = load_urdf(file, {});
  std::vector<std::string> changes;
  EXPECT_EQ(mend_images(right.urdf_text, file, right, changes), right.urdf_text);
  const std::string text = mend_images(right.urdf_text, file, turned(right, {"RLEG_KNEE"}), changes);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NE(changes[0].find("RLEG_KNEE"), std::string::npos) << changes[0];
  UrdfRepairs repairs;
  const Model mended = load_repaired_urdf(text, file, {}, repairs);
  const int knee = right.find_joint("RLEG_KNEE");
  EXPECT_NEAR(mended.joints[static_cast<std::size_t>(knee)].lower, right.joints[static_cast<std::size_t>(knee)].lower, 1e-5);
  EXPECT_NEAR(mended.joints[static_cast<std::size_t>(knee)].upper, right.joints[static_cast<std::size_t>(knee)].upper, 1e-5);
}

}  // namespace
}  // namespace twinbus
