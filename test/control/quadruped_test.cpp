// Robots on four and two point feet, of two sizes, proposed and never tuned: stand, are pushed, step, stop.

#include "control/point_feet/point_feet.h"

#include <gtest/gtest.h>

#include "sim/scene/scene_seed.h"
#include "test/bench/two_sources.h"
#include "test/control/four_legged.h"
#include "test/control/sensor_noise.h"
#include "test/control/sim_rig.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

const Settings kNoisy = test::noisy({"1e-5", "0.002", "1e-4", "0.001"});

Scene flat() {
  Scene scene;
  scene.name = "flat";
  return scene;
}

void say_walk(SimRig& rig, double vx, double vy, double wz) {
  WalkCommand walk;
  walk.run_id = rig.state().run_id;
  walk.sender_id = 12;
  walk.sequence = static_cast<std::int32_t>(rig.ticks());
  walk.vx = static_cast<float>(vx);
  walk.vy = static_cast<float>(vy);
  walk.wz = static_cast<float>(wz);
  walk.timeout = 0.1F;
  rig.loop().on_walk_command(walk, rig.state().time_ns);
}

bool trot(SimRig& rig, double seconds, double vx, double vy, double wz) {
  const auto ticks = static_cast<int>(seconds / 0.002);
  for (int i = 0; i < ticks; ++i) {
    if (i % 10 == 0) say_walk(rig, vx, vy, wz);
    if (!rig.tick()) return false;
  }
  return true;
}

TEST(PointFeetBody, StandsOnFourFeetBelowItsCentreOfMass) {
  for (const double size : {1.0, 2.0}) {
    const Model& model = test::four_legged(size);
    EXPECT_EQ(why_no_point_feet(model), nullptr);
    const PointFeetBody body(model);
    EXPECT_NEAR(body.length, 0.19 * size, 0.01 * size);
    EXPECT_NEAR(body.width, 0.14 * size, 0.01 * size);
    EXPECT_NEAR(body.reach, 0.42 * size, 0.01 * size);
    EXPECT_NEAR((body.stance[0] + body.stance[1] + body.stance[2] + body.stance[3]).norm(), 0.0, 0.005 * size);
    EXPECT_GT(body.height, 0.6 * body.reach);
    EXPECT_LT(body.height, 0.85 * body.reach);
  }
}

TEST(PointFeetBody, AHumanoidAndAnArmAreNone) {
  EXPECT_NE(why_no_point_feet(load_robot("hrp1s")), nullptr);
  Model fixed = test::four_legged(1.0);
  fixed.floating_base = false;
  EXPECT_NE(why_no_point_feet(fixed), nullptr);
}

// An ankle more, and each leg can bend in many ways: that of a pose of the file in which it stands is taken, and no other.
TEST(PointFeetBody, LegsOfFourJointsStandAsTheirFileSays) {
  std::string urdf = test::point_legged_urdf(1.0, 4), ankles, crouch, leaning;
  for (const std::string leg : {"fl", "fr", "hl", "hr"}) {
    const std::string ball = "<collision><origin xyz=\"0 0 -0.2\"/>";
    urdf.replace(urdf.find(ball), urdf.find("</collision>", urdf.find(ball)) + 12 - urdf.find(ball), "");
    ankles += "<link name=\"" + leg + "_toe\"><inertial><mass value=\"0.1\"/><inertia ixx=\"1e-4\" iyy=\"1e-4\" izz=\"1e-4\" ixy=\"0\" "
              "ixz=\"0\" iyz=\"0\"/></inertial><collision><origin xyz=\"0 0 -0.05\"/><geometry><sphere radius=\"0.02\"/></geometry>"
              "</collision></link><joint name=\"" + leg + "_ankle\" type=\"revolute\"><parent link=\"" + leg + "_shank\"/><child link=\"" +
              leg + "_toe\"/><origin xyz=\"0 0 -0.18\"/><axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\" effort=\"30\" "
              "velocity=\"25\"/></joint>\n";
    const auto pose = [&](double swing) {
      return "<joint name=\"" + leg + "_swing\" value=\"" + std::to_string(swing) + "\"/><joint name=\"" + leg + "_knee\" value=\"-1.4\"/>"
             "<joint name=\"" + leg + "_ankle\" value=\"0.6\"/>";
    };
    crouch += pose(0.68);
    leaning += pose(leg[0] == 'f' ? 0.68 : 1.2);
  }
  urdf.insert(urdf.find("</robot>"), ankles);
  test::TemporaryFolder folder;
  folder.write("bare.urdf", urdf);
  const Model bare = load_urdf(folder.path() + "/bare.urdf", {});
  ProposalSource source;
  source.urdf_name = "four.urdf";
  source.srdf_text = "<robot name=\"four\"><group_state name=\"leaning\" group=\"all\">" + leaning +
                "</group_state><group_state name=\"crouch\" group=\"all\">" + crouch + "</group_state></robot>";
  const Proposal proposal = propose(bare, source);
  const std::string half = proposal.srdf.substr(proposal.srdf.find("\"half_sitting\""));
  EXPECT_NE(half.substr(0, half.find("</group_state>")).find("name=\"hl_ankle\" value=\"0.59"), std::string::npos) << half;
  EXPECT_NE(half.substr(0, half.find("</group_state>")).find("name=\"hl_swing\" value=\"0.68"), std::string::npos) << half;
}

TEST(StepGait, DiagonalPairsStepInTurnAndBothStandBetween) {
  const PointFeetBody body(test::four_legged(1.0));
  StepGait gait(body);
  gait.begin();
  int both = 0, none = 0;
  for (int i = 0; i < 1000; ++i) {
    gait.advance(0.001);
    EXPECT_EQ(gait.swings(0), gait.swings(3));
    EXPECT_EQ(gait.swings(1), gait.swings(2));
    both += gait.swings(0) && gait.swings(1) ? 1 : 0;
    none += !gait.swings(0) && !gait.swings(1) ? 1 : 0;
  }
  EXPECT_EQ(both, 0);
  EXPECT_GT(none, 50);
  gait.end();
  for (int i = 0; i < 1000 && gait.steps(); ++i) gait.advance(0.001);
  EXPECT_FALSE(gait.steps());
}

TEST(StepGait, ACrawlLiftsOneFootAtATimeAndOnlyWhenItMay) {
  const PointFeetBody body(test::four_legged(1.0));
  StepGait gait(body, PointGait::kCrawl);
  gait.begin_crawl(false);
  std::array<int, 4> lifted{};
  int swinging = -1, most = 0;
  const double dt = 0.001;
  for (double t = 0.0; t < gait.period() - 2.0 * dt; t += dt) {
    gait.advance(dt);
    int in_air = 0, which = -1;
    for (int leg = 0; leg < 4; ++leg) {
      if (!gait.swings(leg)) continue;
      ++in_air;
      which = leg;
      EXPECT_GE(gait.swing_done(leg), 0.0);
      EXPECT_LE(gait.swing_done(leg), 1.0);
    }
    most = std::max(most, in_air);
    if (which >= 0 && which != swinging) ++lifted[static_cast<std::size_t>(which)];
    swinging = which;
  }
  EXPECT_EQ(most, 1);
  EXPECT_EQ(lifted, (std::array<int, 4>{1, 1, 1, 1}));
  for (const bool backwards : {false, true}) {
    gait.begin_crawl(backwards);
    for (const int quarter : {0, 2}) EXPECT_EQ(gait.leg_of(quarter) < 2, backwards) << "of a side the front foot goes first backwards";
    EXPECT_EQ(gait.leg_of(0) % 2, gait.leg_of(1) % 2);
  }
  gait.begin_crawl(false);
  for (int i = 0; i < 5000; ++i) gait.advance(dt, false);
  for (int leg = 0; leg < 4; ++leg) EXPECT_FALSE(gait.swings(leg)) << "its weight is not above the others";
  gait.end();
  gait.advance(dt);
  EXPECT_FALSE(gait.steps());
}

TEST(StepGait, TheSpeedChoosesBetweenCrawlAndTrot) {
  const PointFeetBody body(test::four_legged(1.0));
  StepGait gait(body, PointGait::kBySpeed);
  const Eigen::Vector3d slow(0.8 * StepGait(body, PointGait::kCrawl).most_velocity().x(), 0.0, 0.0), fast = 2.0 * slow;
  EXPECT_TRUE(gait.crawls_at(slow));
  EXPECT_FALSE(gait.crawls_at(fast));
  EXPECT_EQ(gait.possible(fast), fast);
  gait.begin();
  EXPECT_FALSE(gait.crawls_at(1.1 * slow)) << "who trots goes on until it is clearly slower";
  EXPECT_TRUE(gait.crawls_at(0.9 * slow));
  EXPECT_LT(StepGait(body, PointGait::kCrawl).possible(fast).x(), fast.x());
  EXPECT_FALSE(StepGait(body).crawls_at(slow));
}

TEST(StepGait, ACrawlGoesBackwardsUntilItGoesClearlyForward) {
  const PointFeetBody body(test::four_legged(1.0));
  StepGait gait(body, PointGait::kCrawl);
  const Eigen::Vector3d most(gait.most_velocity().x(), 0.0, 0.0);
  EXPECT_FALSE(gait.backwards_at(-0.1 * most));
  EXPECT_TRUE(gait.backwards_at(-0.5 * most));
  gait.begin_crawl(true);
  EXPECT_TRUE(gait.backwards_at(0.1 * most));
  EXPECT_FALSE(gait.backwards_at(0.5 * most));
}

TEST(CrawlPattern, APointIsBroughtIntoTheTriangleOfTheOthers) {
  const PointFeetBody body(test::four_legged(1.0));
  for (int lifted = 0; lifted < 4; ++lifted) {
    for (const double x : {-0.5, -0.1, 0.0, 0.1, 0.5}) {
      for (const double y : {-0.4, 0.0, 0.05, 0.4}) {
        const Eigen::Vector2d inside = nearest_inside(body.stance, lifted, {x, y}, 0.03);
        EXPECT_GT(inside_others(body.stance, lifted, inside), 0.03 - 1e-9);
        EXPECT_NEAR((nearest_inside(body.stance, lifted, inside, 0.03) - inside).norm(), 0.0, 1e-9) << "who is inside stays";
      }
    }
    EXPECT_GT(inside_others(body.stance, lifted, nearest_inside(body.stance, lifted, {0.0, 0.0}, 1.0)), 0.05) << "no room: the middle";
  }
}

TEST(Quadruped, StandsAndIsPushed) {
  for (const double size : {1.0, 2.0}) {
    const Model& model = test::four_legged(size);
    for (const double way : {1.0, -1.0}) {
      Scene scene = flat();
      const double velocity = 0.5 * std::sqrt(size) * model.total_mass();
      scene.pushes.push_back({.link = "trunk", .point = {0, 0, 0}, .impulse = {0.8 * way * velocity, 0.6 * velocity, 0}, .at = 1.0, .duration = 0.1});
      SimRig rig(model, scene, kNoisy, {});
      EXPECT_TRUE(rig.run(4.0));
      EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
      EXPECT_FALSE(rig.record().fell) << size;
      EXPECT_LT(rig.record().base_tilt_max, 0.2) << size;
      const auto& v = rig.truth().base_velocity;
      EXPECT_LT(std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1])), 0.05) << "it stands again";
    }
  }
}

// In mode hold the legs are told what they carry: under its weight alone they rested 0.05 rad short of it.
TEST(Quadruped, RestsWhereItIsHeld) {
  for (const Model& model : {test::four_legged(1.0), test::four_legged(2.0), load_robot("quad12")}) {
    SimRig rig(model, flat(), kNoisy, {});
    const bool stood = rig.run(1.0);
    rig.ask(Mode::kHold);
    EXPECT_TRUE(stood && rig.run(3.0));
    EXPECT_EQ(rig.loop().status().mode, Mode::kHold);
    double off = 0.0;
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k)
      off = std::max(off, std::abs(static_cast<double>(rig.state().q[k] - rig.command().q[k])));
    EXPECT_LT(off, 0.004) << model.name;
  }
}

// In STATE, TRUTH and ESTIMATE alike: each foot, what it carries, and where.
TEST(Quadruped, ItsFeetSayWhatTheyCarry) {
  const Model& model = test::four_legged(1.0);
  SimRig rig(model, flat(), {}, {});
  ASSERT_TRUE(rig.run(2.0));
  const RobotState& state = rig.state();
  const SimTruth& truth = rig.truth();
  const float weight = static_cast<float>(kGravity * model.total_mass());
  ASSERT_EQ(truth.foot_count, 4);
  EXPECT_GT(truth.zmp_margin, 0.05F);
  float sum = 0.0F;
  for (std::size_t foot = 0; foot < 4; ++foot) {
    const auto& w = state.wrench[foot];
    EXPECT_EQ(state.wrench_kind[foot], WrenchKind::kEstimated) << "it has no sensors";
    EXPECT_NE(state.sensor_flags & wrench_valid(static_cast<Limb>(foot)), 0);
    EXPECT_NEAR(std::hypot(w[0], w[1], w[2]), std::hypot(truth.foot_force[foot][0], truth.foot_force[foot][1], truth.foot_force[foot][2]), 0.1F);
    EXPECT_GT(truth.foot_force[foot][2], 0.15F * weight);
    EXPECT_NEAR(truth.foot_position[foot][2], 0.0F, 0.005F);
    EXPECT_LT(std::hypot(w[3], w[4], w[5]), 0.03F * weight) << "about the middle of its ball";
    sum += truth.foot_force[foot][2];
  }
  EXPECT_NEAR(sum, weight, 0.03F * weight);
  EXPECT_LT(truth.foot_position[0][0] * truth.foot_position[3][0], 0.0F) << "one before, one behind";
  for (std::size_t row = 4; row < kLimbs; ++row) EXPECT_EQ(state.wrench_kind[row], WrenchKind::kAbsent) << row;
}

// Feet of meshes touch with more than one point: each counts when the robot is put on the ground.
TEST(Quadruped, BeginsAsDeepAsItsWeightPressesIt) {
  Model model = test::four_legged(1.0);
  for (Link& link : model.links) {
    const std::vector<Shape> shapes = link.collision;
    for (const Shape& shape : shapes) {
      if (shape.kind != ShapeKind::kSphere) continue;
      for (const double aside : {-0.01, 0.01}) {
        link.collision.push_back(shape);
        link.collision.back().pose.pretranslate(Eigen::Vector3d(0.0, aside, 0.0));
      }
    }
  }
  SimRig rig(model, flat(), {}, {});
  const double weight = kGravity * model.total_mass();
  for (int tick = 0; tick < 20; ++tick) {
    ASSERT_TRUE(rig.tick());
    double sum = 0.0;
    for (int foot = 0; foot < 4; ++foot) sum += static_cast<double>(rig.truth().foot_force[static_cast<std::size_t>(foot)][2]);
    EXPECT_NEAR(sum, weight, 0.25 * weight) << tick;
  }
}

TEST(Quadruped, TrotsWhereItIsToldAndStandsAgain) {
  for (const double size : {1.0, 2.0}) {
    const Model& model = test::four_legged(size);
    SimRig rig(model, flat(), kNoisy, {});
    EXPECT_TRUE(rig.run(0.5));
    rig.ask(Mode::kWalk);
    const double v = 0.5 * std::sqrt(size);
    EXPECT_TRUE(trot(rig, 1.0, v, 0.0, 0.0));
    const double from = rig.truth().base_position[0];
    EXPECT_TRUE(trot(rig, 2.0, v, 0.0, 0.0));
    EXPECT_EQ(rig.loop().status().mode, Mode::kWalk);
    EXPECT_NEAR((rig.truth().base_position[0] - from) / 2.0, v, 0.15 * v) << size;
    EXPECT_TRUE(trot(rig, 1.5, 0.0, 0.0, 0.8 / std::sqrt(size)));
    const auto& q = rig.truth().base_attitude;
    EXPECT_GT(2.0 * std::atan2(q[3], q[0]), 0.5 / std::sqrt(size)) << "turned to the left";
    rig.ask(Mode::kBalance);
    EXPECT_TRUE(rig.run(2.5));
    EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
    EXPECT_FALSE(rig.record().fell);
    EXPECT_LT(rig.record().base_tilt_max, 0.15) << size;
  }
}

// Points meet tiles as soles do, in both engines.
TEST(Quadruped, ClimbsASlope) {
  const Model& model = test::four_legged(1.0);
  Scene scene = flat();
  scene.terrain.ramp = 0.12;
  scene.terrain.from = 0.5;
  scene.terrain.tile = 3.0;
  scene.terrain.length = 9.0;
  apply_seed(scene, model, 1);
  for (const char* engine : {"articulated", "ode"}) {
    Settings settings = kNoisy;
    settings.emplace_back("engine", engine);
    SimRig rig(model, scene, settings, {});
    EXPECT_TRUE(rig.run(0.5));
    const double from = rig.truth().base_position[2];
    rig.ask(Mode::kWalk);
    EXPECT_TRUE(trot(rig, 4.0, 0.5, 0.0, 0.0));
    const auto& to = rig.truth().base_position;
    EXPECT_GT(to[0], 1.5) << engine;
    EXPECT_NEAR(to[2] - from, std::tan(0.12) * (to[0] - 0.5), 0.03) << engine;
    rig.ask(Mode::kBalance);
    EXPECT_TRUE(rig.run(2.5));
    EXPECT_FALSE(rig.record().fell) << engine;
  }
}

TEST(Quadruped, ABalancedStopInATrotEndsStanding) {
  SimRig rig(test::four_legged(1.0), flat(), {}, {});
  EXPECT_TRUE(rig.run(0.3));
  rig.ask(Mode::kWalk);
  EXPECT_TRUE(trot(rig, 1.5, 0.5, 0.0, 0.0));
  rig.state().stop_kind = StopKind::kBalanced;
  EXPECT_TRUE(trot(rig, 2.5, 0.5, 0.0, 0.0));  // nobody listens to the velocity
  EXPECT_FALSE(rig.record().fell);
  EXPECT_FALSE(rig.loop().status().mode == Mode::kWalk);
  EXPECT_EQ(rig.command().flags & kCommandStopping, 0) << "it stands: the stop has ended";
  const auto& v = rig.truth().base_velocity;
  EXPECT_LT(std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1])), 0.05);
}

TEST(Quadruped, SwaysAndSquats) {
  SimRig rig(test::four_legged(1.0), flat(), {}, {});
  EXPECT_TRUE(rig.run(1.0));
  rig.ask(Mode::kBalance, Motion::kSway, 0.03, 0.5);
  double left = 0.0, right = 0.0;
  for (int i = 0; i < 1500; ++i) {
    ASSERT_TRUE(rig.tick());
    left = std::max(left, rig.truth().base_position[1]);
    right = std::min(right, rig.truth().base_position[1]);
  }
  EXPECT_GT(left, 0.02);
  EXPECT_LT(right, -0.02);
  EXPECT_LT(rig.record().base_tilt_max, 0.05);
}

double tilt_of(const SimTruth& truth) {
  const auto& q = truth.base_attitude;
  return std::acos(std::clamp(1.0 - 2.0 * (q[1] * q[1] + q[2] * q[2]), -1.0, 1.0));
}

// To the other engine, where the robot is heavier and the ground softer, and back: standing, then in phases of the gait.
void goes_on_while_another_simulator_takes_over(const Model& model, double walked) {
  TwoSources rig(model, flat(), {}, std::make_unique<SimAdaptor>(flat()),
                 {{{"engine", "ode"}, {"model.mass_scale", "1.03"}, {"contact.stiffness_scale", "0.8"}}});
  double worst = 0.0;
  int said = 0, switches = 0;
  const auto run = [&](double seconds, double speed) {
    for (int i = 0; i < static_cast<int>(seconds / model.period()); ++i) {
      if (speed > 0.0 && ++said % 10 == 0) rig.want(speed, 0.0, 0.0);
      rig.tick();
      if (rig.active() >= 0) worst = std::max(worst, tilt_of(rig.truth(rig.active())));
    }
  };
  const auto change = [&](double speed) {
    const int from = rig.active();
    rig.request(SourceAction::kSwitch, TwoSources::run_of(1 - from), SwitchPolicy::kNow);
    run(0.1, speed);
    switches += rig.active() == 1 - from ? 1 : 0;
    run(1.0, speed);
    EXPECT_EQ(rig.source(rig.active()).state().stop_kind, StopKind::kNone);
  };
  run(1.5, 0.0);
  for (int i = 0; i < 4; ++i) change(0.0);
  EXPECT_EQ(switches, 4);
  EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
  EXPECT_LT(worst, 0.05) << "standing";
  rig.ask(Mode::kWalk);
  run(1.5, walked);
  for (int i = 0; i < 8; ++i) {
    run(0.05 * i, walked);
    change(walked);
  }
  EXPECT_EQ(switches, 12);
  EXPECT_EQ(rig.loop().status().mode, Mode::kWalk);
  EXPECT_LT(worst, 0.2) << "at " << walked << " m/s";
  EXPECT_EQ(rig.unanswered(), 0);
}

TEST(Quadruped, TrotsOnWhileAnotherSimulatorTakesOver) {
  goes_on_while_another_simulator_takes_over(test::four_legged(1.0), 0.5);
  goes_on_while_another_simulator_takes_over(load_robot("quad12"), 0.5);
}

TEST(Quadruped, CrawlsOnWhileAnotherSimulatorTakesOver) { goes_on_while_another_simulator_takes_over(load_robot("quad12"), 0.1); }

// The margin of a crawl at this velocity along x, six seconds of it; how far it went.
struct Crawled {
  double margin = 1.0, way = 0.0;
};
Crawled crawled(const Model& model, double vx) {
  SimRig rig(model, flat(), kNoisy, {});
  EXPECT_TRUE(rig.run(0.5));
  rig.ask(Mode::kWalk);
  EXPECT_TRUE(trot(rig, 2.0, vx, 0.0, 0.0));
  Crawled found;
  const double from = rig.truth().base_position[0];
  for (int i = 0; i < 3000 && trot(rig, 0.002, vx, 0.0, 0.0); ++i)
    found.margin = std::min(found.margin, static_cast<double>(rig.truth().zmp_margin));
  found.way = rig.truth().base_position[0] - from;
  return found;
}

TEST(Quadruped, CrawlsBackwardsOnThreeFeetAndMore) {
  const Crawled found = crawled(load_robot("quad12"), -0.1);
  EXPECT_LT(found.way, -0.45);
  EXPECT_GT(found.margin, 0.01);
}

// Each takes 1.5 of 24 or 36 N m; without the torque against it, the robot hops.
TEST(Quadruped, CrawlsWithJointsThatRub) {
  Model model = load_robot("quad12");
  for (Joint& joint : model.joints) {
    joint.friction = 1.5;
    joint.damping = 0.2;
  }
  const Crawled found = crawled(model, 0.1);
  EXPECT_GT(found.way, 0.45);
  EXPECT_GT(found.margin, 0.003);
}

TEST(TwoPointFeet, AreFoundAndAreNoSoles) {
  const Model& model = test::point_legged(1.0, 2);
  EXPECT_LT(model.soles[0].link, 0);
  ASSERT_EQ(why_no_point_feet(model), nullptr);
  const PointFeetBody body(model);
  EXPECT_TRUE(body.two());
  EXPECT_NEAR(body.width, 0.14, 0.01);
  EXPECT_NEAR(body.stance[0].x(), 0.0, 0.005) << "the centre of mass is above the line between the feet";
  EXPECT_EQ(StepGait(body).possible({0.1, 0.0, 0.5}), Eigen::Vector3d(0.1, 0.0, 0.0)) << "two points cannot turn it";
}

// Steps of the same length, T apart, repeat themselves: the capture point is left behind by what the next foothold needs.
TEST(TwoPointFeet, ThePlaceOfAFootKeepsTheStride) {
  const PointFeetBody body(test::point_legged(1.0, 2));
  const StepGait gait(body);
  const Eigen::Vector2d velocity(0.3, 0.1);
  const double width = 2.0 * body.width, grown = std::exp(gait.omega() * gait.step_time());
  Eigen::Vector2d foot(0.0, body.width), capture = foot - gait.from_capture_point(0, velocity, width), first = foot;
  for (int step = 1; step <= 8; ++step) {
    capture = foot + grown * (capture - foot);
    foot = capture + gait.from_capture_point(step % 2, velocity, width);
  }
  EXPECT_NEAR((foot - first - 8.0 * gait.step_time() * velocity).norm(), 0.0, 1e-9);
}

TEST(TwoPointFeet, StepInPlaceAreCaughtFromAPushAndWalk) {
  for (const double size : {1.0, 2.0}) {
    const Model& model = test::point_legged(size, 2);
    Scene scene = flat();
    const double impulse = 0.15 * std::sqrt(size) * model.total_mass();
    scene.pushes.push_back({.link = "trunk", .point = {0, 0, 0}, .impulse = {0.8 * impulse, 0.6 * impulse, 0}, .at = 2.0, .duration = 0.1});
    SimRig rig(model, scene, kNoisy, {});
    EXPECT_TRUE(rig.run(5.0));
    EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
    rig.ask(Mode::kWalk);
    const double v = 0.2 * std::sqrt(size);
    EXPECT_TRUE(trot(rig, 2.0, v, 0.0, 0.0));
    const auto from = rig.truth().base_position;
    EXPECT_TRUE(trot(rig, 5.0, v, 0.0, 0.0));
    const auto& to = rig.truth().base_position;
    EXPECT_NEAR(std::hypot(to[0] - from[0], to[1] - from[1]) / 5.0, v, 0.25 * v) << size;
    rig.ask(Mode::kBalance);
    EXPECT_TRUE(rig.run(3.0));
    EXPECT_EQ(rig.loop().status().mode, Mode::kBalance) << "in place, it is left";
    EXPECT_FALSE(rig.record().fell) << size;
    EXPECT_LT(rig.record().base_tilt_max, 0.3) << size;
  }
}

TEST(Quadruped, ATickAllocatesNothing) {
  if (!allocations_counted()) GTEST_SKIP() << "not counted in this build";
  SimRig rig(test::four_legged(1.0), flat(), {}, {});
  EXPECT_TRUE(rig.run(0.3));
  rig.ask(Mode::kWalk);
  EXPECT_TRUE(trot(rig, 0.5, 0.3, 0.0, 0.0));
  NoAlloc no_alloc;
  EXPECT_TRUE(trot(rig, 0.2, 0.3, 0.0, 0.0));
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus
