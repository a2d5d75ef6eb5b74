#include "robot/lint/model_lint.h"

#include <functional>
#include <string>

#include "fixtures.h"

namespace twinbus::test {
namespace {

// Its covered joints are for the eye only, which is said.
TEST(Suspicions, NothingElseIsSaidOfHrp1s) {
  for (const Suspicion& s : find_suspicions(hrp1s())) {
    EXPECT_NE(s.what.find("can be seen but not touched"), std::string::npos) << s.about << s.what;
  }
}

TEST(Suspicions, EachPlantedMistakeIsNamed) {
  const auto says = [](const std::function<void(Model&)>& spoil, const std::string& about,
                       const std::string& what) {
    Model model = hrp1s();
    spoil(model);
    for (const Suspicion& s : find_suspicions(model)) {
      if (s.about == about && s.what.find(what) != std::string::npos && !s.remedy.empty())
        return true;
    }
    return false;
  };
  const std::size_t link = 2;
  const std::string name = "link " + hrp1s().links[link].name;
  const std::string joint = "joint " + hrp1s().joints[0].name;
  EXPECT_TRUE(says([&](Model& m) { m.links[link].inertia.setIdentity(); }, name, "1 1 1"));
  EXPECT_TRUE(
      says([&](Model& m) { m.links[link].inertia.diagonal() << 1, 1, 3; }, name, "no body has"));
  EXPECT_TRUE(says([&](Model& m) { m.links[link].inertia *= 1000.0; }, name, "inertia of a shell"));
  EXPECT_TRUE(says([&](Model& m) { m.links[link].inertia *= 1e-6; }, name, "in one point"));
  EXPECT_TRUE(says([&](Model& m) { m.links[1].com.x() += 0.3; }, "link " + hrp1s().links[1].name,
                   "outside its geometry"));
  EXPECT_TRUE(says([&](Model& m) { m.links[1].mass *= 100.0; }, "link " + hrp1s().links[1].name,
                   "per m^3"));
  EXPECT_TRUE(says([&](Model& m) { m.joints[0].upper = 180.0; }, joint, "a limit of no use"));
  EXPECT_TRUE(says([&](Model& m) { m.joints[0].lower = m.joints[0].upper; }, joint, "cannot move"));
  EXPECT_TRUE(says([&](Model& m) { m.joints[0].velocity = 0.0; }, joint, "velocity limit of 0"));
  EXPECT_TRUE(says([&](Model& m) { m.joints[0].effort = 1e6; }, joint, "effort limit of 1e+06"));
}

TEST(Suspicions, LeftAndRightThatDifferAreNamed) {
  Model model = hrp1s();
  model.joints[static_cast<std::size_t>(model.find_joint("LLEG_KNEE"))].upper -= 0.3;
  model.joints[static_cast<std::size_t>(model.find_joint("RLEG_ANKLE_P"))].effort *= 0.1;
  std::string all;
  for (const Suspicion& s : find_suspicions(model)) all += s.about + " " + s.what + "\n";
  EXPECT_NE(all.find("joint LLEG_KNEE has limits"), std::string::npos) << all;
  EXPECT_NE(all.find("joint LLEG_ANKLE_P has an effort limit"), std::string::npos) << all;
}

TEST(Suspicions, ManyAlikeAreSaidOnce) {
  Model model = hrp1s();
  for (Link& link : model.links) link.inertia.setIdentity();
  int said = 0;
  for (const Suspicion& s : find_suspicions(model)) {
    if (s.what.find("1 1 1") == std::string::npos) continue;
    ++said;
    EXPECT_NE(s.about.find(" and 29 others"), std::string::npos) << s.about;
  }
  EXPECT_EQ(said, 1);
}

TEST(Suspicions, HolesOfAMeshAreCounted) {
  const TemporaryFolder folder;
  const std::string closed = folder.write(
      "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const std::string open =
      folder.write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  EXPECT_EQ(open_edges(closed), 0);
  EXPECT_EQ(open_edges(open), 3);
}

}  // namespace
}  // namespace twinbus::test
