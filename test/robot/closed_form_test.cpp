#include "robot/kinematics/closed_form.h"

#include "fixtures.h"
#include "robot/kinematics/inverse_kinematics.h"

namespace twinbus::test {
namespace {

// Shoulder of three axes that meet, elbow, wrist of two: any directions and lengths, either way round.
Model arm(unsigned seed, bool reversed, int more) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return Eigen::Vector3d(unit(random), unit(random), unit(random)); };
  std::vector<bool> meets = {false, true, true, false, false, true};  // the axis before it
  if (reversed) meets = {false, true, false, false, true, true};
  for (int i = 0; i < more; ++i) meets.push_back(false);
  Model model;
  model.links.resize(meets.size() + 1);
  for (std::size_t j = 0; j < meets.size(); ++j) {
    Joint joint;
    joint.parent = static_cast<int>(j);
    joint.child = static_cast<int>(j) + 1;
    joint.placement.linear() = rotation_of(2.0 * vector());
    if (!meets[j]) joint.placement.translation() = 0.3 * vector();
    joint.axis = vector().normalized();
    joint.lower = -2.0;
    joint.upper = 2.5;
    model.joints.push_back(joint);
    model.links[j + 1].parent = static_cast<int>(j);
  }
  return model;
}

TEST(ClosedForm, FindsThePostureThatMadeThePose) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-1.9, 2.4);
  int same = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Model model = arm(seed, seed % 2 == 0, static_cast<int>(seed % 3));
    const int last = model.link_count() - 1;
    const InverseKinematics ik(model, 0, last, Eigen::Isometry3d::Identity());
    const ClosedForm closed(model, ik.joints(), Eigen::Isometry3d::Identity());
    ASSERT_TRUE(closed.usable()) << seed;
    ASSERT_EQ(closed.locked().size(), seed % 3);
    ClosedForm::Angles q{}, low{}, high{};
    Eigen::VectorXd truth(model.joint_count()), found(model.joint_count());
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      q[i] = truth[static_cast<Eigen::Index>(i)] = angle(random);
      low[i] = -2.0;
      high[i] = 2.5;
    }
    ClosedForm::Candidate best;
    closed.solve(ik.pose(truth), q, low, high, best);
    ASSERT_LT(best.beyond, 1e-6) << seed;
    same += best.distance < 1e-6 ? 1 : 0;
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      found[static_cast<Eigen::Index>(i)] = best.q[i];
    }
    EXPECT_TRUE(ik.pose(found).isApprox(ik.pose(truth), 1e-6)) << seed;
  }
  EXPECT_GE(same, 199);  // it began there
}

TEST(ClosedForm, OurLegsAndArmsAreOfThisKindAndAStraightChainIsNot) {
  const Model& model = hrp1s();
  for (std::size_t side = 0; side < 2; ++side) {
    const InverseKinematics leg(model, 0, model.soles[side].link, model.soles[side].frame);
    EXPECT_TRUE(ClosedForm(model, leg.joints(), model.soles[side].frame).usable());
    const InverseKinematics limb(model, model.find_link("CHEST"), model.hands[side].link,
                                 model.hands[side].frame);
    const ClosedForm closed(model, limb.joints(), model.hands[side].frame);
    EXPECT_TRUE(closed.usable());
    EXPECT_EQ(closed.locked().size(), 1u);
  }
  Model straight = arm(1, false, 0);
  for (Joint& joint : straight.joints) joint.placement.translation() << 0.1, 0.2, 0.05;
  const InverseKinematics ik(straight, 0, 6, Eigen::Isometry3d::Identity());
  EXPECT_FALSE(ClosedForm(straight, ik.joints(), Eigen::Isometry3d::Identity()).usable());
}

TEST(ClosedForm, OutOfReachIsCounted) {
  const Model& model = hrp1s();
  const InverseKinematics leg(model, 0, model.soles[0].link, model.soles[0].frame);
  const ClosedForm closed(model, leg.joints(), model.soles[0].frame);
  ClosedForm::Angles start{}, low{}, high{};
  for (std::size_t i = 0; i < 6; ++i) {
    low[i] = model.joints[static_cast<std::size_t>(leg.joints()[i])].lower;
    high[i] = model.joints[static_cast<std::size_t>(leg.joints()[i])].upper;
  }
  Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
  target.translation() << 0.0, 0.0, -5.0;
  ClosedForm::Candidate best;
  closed.solve(target, start, low, high, best);
  EXPECT_GT(best.beyond, 0.1);
}

}  // namespace
}  // namespace twinbus::test
