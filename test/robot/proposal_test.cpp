#include "robot/proposal.h"

#include <functional>

#include "fixtures.h"
#include "robot/suspicions.h"

namespace twinbus::test {
namespace {

// The URDF of hrp1s without its robot.yaml.
Model bare_hrp1s() { return load_urdf(hrp1s().folder + "/hrp1s.urdf", {}); }

TEST(Anatomy, FindsWhatPeopleWroteDownForHrp1s) {
  const Model& known = hrp1s();
  const Anatomy found = find_anatomy(bare_hrp1s());
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_EQ(found.soles[side].link, known.soles[side].link);
    EXPECT_TRUE(found.soles[side].frame.isApprox(known.soles[side].frame, 1e-9));
    EXPECT_NEAR(found.soles[side].front, known.soles[side].front, 1e-9);
    EXPECT_NEAR(found.soles[side].back, known.soles[side].back, 1e-9);
    EXPECT_EQ(found.hands[side].link, known.hands[side].link);
    EXPECT_EQ(found.hands[side].joints, known.hands[side].joints);
  }
  EXPECT_EQ(found.leg_joints.size(), 12u);
  EXPECT_EQ(found.imu_frame, "IMU");
  EXPECT_TRUE(found.doubts.empty()) << found.doubts.front();
}

TEST(Proposal, IsAFolderThatLoadsAndStands) {
  std::vector<std::pair<std::string, std::string>> robots = {
      {"hrp1s", hrp1s().folder + "/hrp1s.urdf"}};
  if (!data_folder().empty())
    robots.emplace_back("jvrc1", data_folder() + "/robots/jvrc1/jvrc1.urdf");
  for (const auto& [name, urdf] : robots) {
    const auto packages = find_packages(urdf);
    const Model bare = load_urdf(urdf, packages);
    const Proposal proposal = propose(bare, name + ".urdf", packages);
    TemporaryFolder folder;
    folder.write("robot.yaml", proposal.yaml);
    folder.write(name + ".srdf", proposal.srdf);
    folder.write(name + ".urdf", bare.urdf_text);
    const Model model = load_robot(folder.path());
    ASSERT_GE(model.soles[0].link, 0);
    ASSERT_GE(model.hands[0].link, 0);
    for (const int j : model.bus_joints)
      EXPECT_GT(model.joints[static_cast<std::size_t>(j)].kp, 0.0);
    const int pose = model.find_pose("half_sitting");
    ASSERT_GE(pose, 0);
    Configuration c(model);
    const auto& q = model.poses[static_cast<std::size_t>(pose)].q;
    c.q = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
    Kinematics k(model);
    k.update(c);
    const Eigen::Isometry3d left = k.link_in_world(model.soles[0].link) * model.soles[0].frame;
    const Eigen::Isometry3d right = k.link_in_world(model.soles[1].link) * model.soles[1].frame;
    EXPECT_LT(rotation_vector(left.linear()).norm(), 1e-3) << name << ": the soles are flat";
    EXPECT_NEAR(left.translation().z(), right.translation().z(), 1e-4) << name;
    const double middle =
        left.translation().x() + 0.5 * (model.soles[0].front - model.soles[0].back);
    EXPECT_NEAR(k.com().x(), middle, 2e-3) << name << ": the centre of mass is above them";
    EXPECT_TRUE(find_missing(model).empty()) << name << ": " << find_missing(model).front().what;
  }
}

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
