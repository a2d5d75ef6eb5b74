// The face as a program meets it: what becomes COMMAND, what is refused, with which line.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/unitree/face.h"

namespace twinbus {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kFirstId = 100;

const char* const kLeg[] = {"hip", "thigh", "calf"};

// A Go2 whose joints come in another order than its motors: FL FR RL RR.
Model quadruped() {
  Model model;
  model.name = "go2";
  model.links.resize(13);
  for (const char* leg : {"FL", "FR", "RL", "RR"}) {
    for (const char* part : kLeg) {
      Joint joint;
      joint.name = std::string(leg) + "_" + part + "_joint";
      joint.kp = 50.0;
      joint.kd = 1.0;
      joint.child = static_cast<int>(model.joints.size()) + 1;
      joint.parent = part == kLeg[0] ? 0 : joint.child - 1;
      model.links[static_cast<std::size_t>(joint.child)].parent = joint.parent;
      model.bus_joints.push_back(static_cast<int>(model.joints.size()));
      model.bus_index.push_back(static_cast<int>(model.joints.size()));
      model.joints.push_back(joint);
    }
  }
  model.hash = 4711;
  return model;
}

// The face, a robot that repeats its posture, and the clock.
class Bench {
 public:
  explicit Bench(FaceOptions options = {.family = UnitreeFamily::kGo, .first_id = kFirstId}) : face(model, options) {
    state.joint_count = 12;
    state.model_hash = model.hash;
    state.run_id = 5;
    state.term = 1;
    state.tick = 10;
    state.enabled = 0xFFF;
    for (int j = 0; j < 12; ++j) state.q[static_cast<std::size_t>(j)] = 0.1 * j;
  }

  // One period: STATE, then what the face answers.
  bool tick(JointCommand* command = nullptr) {
    now += 2 * kMs;
    ++state.tick;
    state.time_ns += 2 * kMs;
    face.on_state(state, now);
    return answer(command);
  }
  bool answer(JointCommand* command = nullptr) {
    JointCommand mine;
    return face.take_command(command != nullptr ? *command : mine, now);
  }
  void status(std::int64_t controller) {
    SourceStatus status;
    status.run_id = state.run_id;
    status.term = state.term;
    status.controller_id = controller;
    face.on_source(status);
  }
  void write(const LowCommand& command, std::uint64_t writer = 1, std::int64_t delay = 0) {
    std::array<std::byte, kLargestFrame> frame;
    encode(command, UnitreeFamily::kGo, frame);
    send(std::span(frame).first(command_bytes(UnitreeFamily::kGo)), writer, delay);
  }
  void send(std::span<const std::byte> frame, std::uint64_t writer = 1, std::int64_t delay = 0) {
    face.on_frame(frame, writer, now - delay, now, now);
  }
  std::vector<std::string> lines() {
    std::vector<std::string> all;
    FaceLine line;
    while (face.take_line(line)) all.emplace_back(line.text.data());
    return all;
  }
  int lines_with(const std::string& words) {
    int count = 0;
    for (const std::string& line : lines()) count += line.find(words) != std::string::npos;
    return count;
  }

  Model model = quadruped();
  Face face;
  RobotState state;
  std::int64_t now = 1'000'000 * kMs;
};

LowCommand stand(float q = 0.5F) {
  LowCommand command;
  for (std::size_t m = 0; m < 12; ++m) command.motor[m] = {true, q + 0.01F * static_cast<float>(m), 0.0F, 1.0F, 30.0F, 2.0F};
  return command;
}

TEST(UnitreeMotorOrder, IsThatOfTheTableWhateverTheOrderOfTheModel) {
  const Model model = quadruped();
  const MotorOrder order = motor_order(model, UnitreeFamily::kGo);
  EXPECT_EQ(order.robot, "Go2");
  const char* const legs[] = {"FR", "FL", "RR", "RL"};
  for (std::size_t m = 0; m < 12; ++m) {
    EXPECT_EQ(model.joints[static_cast<std::size_t>(order.bus_index[m])].name, std::string(legs[m / 3]) + "_" + kLeg[m % 3] + "_joint");
  }
  EXPECT_EQ(order.bus_index[12], -1);
}

TEST(UnitreeMotorOrder, JointsOfNoMotorAreNamed) {
  Model model = quadruped();
  model.joints[4].name = "FR_thigh_jiont";
  try {
    motor_order(model, UnitreeFamily::kGo);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("FR_thigh_jiont"), std::string::npos) << error.what();
  }
  EXPECT_THROW(motor_order(quadruped(), UnitreeFamily::kHg), std::runtime_error);
  model = quadruped();
  model.name = "go1";
  EXPECT_EQ(motor_order(model, UnitreeFamily::kGo).robot, "Go1");
}

// A G1 with its waist locked, or with 23 joints, calls itself otherwise, and its programs ask for that.
TEST(UnitreeMotorOrder, ModeMachineOfAG1FollowsFromTheMotorsItLacks) {
  const std::vector<std::string> legs = {"hip_pitch", "hip_roll", "hip_yaw", "knee", "ankle_pitch", "ankle_roll"};
  const std::vector<std::string> arms = {"shoulder_pitch", "shoulder_roll", "shoulder_yaw", "elbow", "wrist_roll"};
  const auto g1 = [&](std::vector<std::string> waist, const std::vector<std::string>& wrists) {
    std::vector<std::string> names = std::move(waist);
    for (const char* side : {"left_", "right_"}) {
      for (const auto& list : {legs, arms, wrists}) {
        for (const std::string& joint : list) names.push_back(side + joint);
      }
    }
    Model model;
    for (const std::string& name : names) {
      model.bus_joints.push_back(static_cast<int>(model.joints.size()));
      model.bus_index.push_back(static_cast<int>(model.joints.size()));
      model.joints.emplace_back().name = name + "_joint";
    }
    return motor_order(model, UnitreeFamily::kHg).mode_machine;
  };
  EXPECT_EQ(g1({"waist_yaw", "waist_roll", "waist_pitch"}, {"wrist_pitch", "wrist_yaw"}), 5);
  EXPECT_EQ(g1({"waist_yaw"}, {"wrist_pitch", "wrist_yaw"}), 6);
  EXPECT_EQ(g1({"waist_yaw"}, {}), 4);
  EXPECT_EQ(g1({}, {}), 5);  // no build of the vendor
}

TEST(UnitreeFace, HoldsThePostureThatItFindsUntilAProgramCommands) {
  Bench bench;
  JointCommand command;
  int answered = 0;
  for (int n = 0; n < 10; ++n) answered += bench.tick(&command);
  EXPECT_EQ(answered, 7);  // after listening whether somebody else drives
  EXPECT_EQ(command.tick, bench.state.tick);
  EXPECT_EQ(command.controller_id, kFirstId);
  EXPECT_EQ(command.run_id, 5);
  EXPECT_EQ(command.joint_count, 12);
  EXPECT_EQ(command.q[7], bench.state.q[7]);
  EXPECT_EQ(command.kp[7], 50.0F);
}

TEST(UnitreeFace, ACommandReachesTheJointOfItsNameOncePerTick) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  bench.tick();
  bench.write(stand());
  EXPECT_FALSE(bench.answer()) << "this tick has been answered";
  JointCommand command;
  ASSERT_TRUE(bench.tick(&command));
  EXPECT_EQ(command.controller_id, kFirstId + 1);
  EXPECT_EQ(command.tick, bench.state.tick);
  for (std::size_t m = 0; m < 12; ++m) {
    const auto bus = static_cast<std::size_t>(bench.face.order().bus_index[m]);
    EXPECT_EQ(command.q[bus], static_cast<double>(0.5F + 0.01F * static_cast<float>(m)));
    EXPECT_EQ(command.kp[bus], 30.0F);
    EXPECT_EQ(command.kd[bus], 2.0F);
    EXPECT_EQ(command.tau[bus], 1.0F);
  }
  EXPECT_FALSE(bench.tick()) << "nothing new was written";
  bench.write(stand(0.6F));
  bench.write(stand(0.7F));
  ASSERT_TRUE(bench.answer(&command));
  EXPECT_EQ(command.q[static_cast<std::size_t>(bench.face.order().bus_index[0])], static_cast<double>(0.7F));
}

// A program of 50 Hz would else leave the robot that takes over without a command for up to 20 ms.
TEST(UnitreeFace, TheLastCommandIsSentAgainToTheRobotThatTakesOver) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  JointCommand before, after;
  bench.write(stand());
  ASSERT_TRUE(bench.tick(&before));
  ASSERT_FALSE(bench.tick());
  bench.state.run_id = 6;
  bench.state.term = 2;
  bench.state.tick -= 3;  // its own count may be a little behind
  ASSERT_TRUE(bench.tick(&after));
  EXPECT_EQ(after.run_id, 6);
  EXPECT_EQ(after.term, 2);
  EXPECT_EQ(after.controller_id, before.controller_id);
  EXPECT_EQ(after.q, before.q);
  EXPECT_FALSE(bench.tick()) << "once";
}

// What a program wanted before the source was started anew moves nothing: the face holds the posture that it finds.
TEST(UnitreeFace, ASourceThatBeginsAnewIsNotDrivenByAProgramThatHasEnded) {
  Bench bench;
  for (int n = 0; n < 500; ++n) bench.tick();
  JointCommand command;
  bench.write(stand());
  ASSERT_TRUE(bench.tick(&command));
  bench.state.run_id = 6;
  bench.state.term = 1;
  bench.state.tick = 0;
  int answers = 0;
  for (int n = 0; n < 400; ++n) {
    if (!bench.tick(&command)) continue;
    ++answers;
    EXPECT_EQ(command.controller_id, kFirstId) << n;
    for (std::size_t j = 0; j < 12; ++j) ASSERT_EQ(command.q[j], bench.state.q[j]) << n;
  }
  EXPECT_GT(answers, 0);
}

TEST(UnitreeFace, AProgramIsAControllerOfItsOwnAndTheSourceIsAskedForIt) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  bench.status(kFirstId);
  ControllerRequest request;
  EXPECT_FALSE(bench.face.take_request(request, bench.now));
  bench.write(stand());
  ASSERT_TRUE(bench.face.take_request(request, bench.now));
  EXPECT_EQ(request.controller_id, kFirstId + 1);
  EXPECT_EQ(request.run_id, 5);
  EXPECT_FALSE(bench.face.take_request(request, bench.now)) << "not at once again";
  bench.status(kFirstId + 1);
  bench.now += 100 * kMs;
  EXPECT_FALSE(bench.face.take_request(request, bench.now));
}

TEST(UnitreeFace, AnotherControllerIsNotDisturbed) {
  Bench bench;
  bench.status(42);
  for (int n = 0; n < 10; ++n) {
    bench.face.on_command(42, bench.now);
    EXPECT_FALSE(bench.tick());
    bench.status(42);
  }
  bench.write(stand());
  ControllerRequest request;
  EXPECT_FALSE(bench.face.take_request(request, bench.now));
  bench.face.on_command(42, bench.now);
  EXPECT_FALSE(bench.tick());
  EXPECT_EQ(bench.lines_with("another controller"), 1);
  // It has gone: the program may drive.
  bench.now += 300 * kMs;
  bench.write(stand());
  EXPECT_TRUE(bench.face.take_request(request, bench.now));
  EXPECT_TRUE(bench.tick());
}

TEST(UnitreeFace, WhatIsWrongMovesNothingAndIsToldOnceWithItsRemedy) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  bench.lines();
  std::array<std::byte, sizeof(GoLowCmd)> frame;
  encode(stand(), UnitreeFamily::kGo, frame);
  frame[100] ^= std::byte{1};
  LowCommand infinite = stand();
  infinite.motor[4].kd = std::numeric_limits<float>::infinity();
  for (int n = 0; n < 500; ++n) {
    bench.send(frame);
    bench.write(infinite);
    JointCommand command;
    ASSERT_TRUE(bench.tick(&command));
    ASSERT_EQ(command.controller_id, kFirstId) << "still held";
  }
  const std::vector<std::string> lines = bench.lines();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[0].find("CRC"), std::string::npos);
  EXPECT_NE(lines[1].find("motor 4 (FL_thigh_joint)"), std::string::npos) << lines[1];
  EXPECT_EQ(bench.face.frames_taken(), 0);
  EXPECT_EQ(bench.face.frames_refused(), 1000);
}

TEST(UnitreeFace, FewerStatesForAProgramThatCannotReadThemAll) {
  const auto states = [](double rate) {
    Bench bench({.family = UnitreeFamily::kGo, .rate = rate, .first_id = kFirstId});
    int count = 0;
    for (int n = 0; n < 500; ++n) {
      bench.tick();
      count += bench.face.reading_due() ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(states(500.0), 500);
  EXPECT_EQ(states(100.0), 100);
}

TEST(UnitreeFace, ALateCommandIsRepeatedAndSilenceIsToldOnce) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  bench.write(stand());
  ASSERT_TRUE(bench.tick());
  const auto first_motor = static_cast<std::size_t>(bench.face.order().bus_index[0]);
  std::vector<int> sent;
  JointCommand command;
  for (int n = 1; n <= 500; ++n) {
    if (!bench.tick(&command)) continue;
    sent.push_back(n);
    EXPECT_EQ(command.q[first_motor], 0.5);
    EXPECT_EQ(command.tick, bench.state.tick);
  }
  EXPECT_EQ(sent, (std::vector<int>{15, 30, 45}));
  EXPECT_EQ(bench.lines_with("no good LowCmd for 100 ms"), 1);
  // Stopped by the source, cleared without a program: held where it is then.
  bench.state.stop_kind = StopKind::kHold;
  bench.tick();
  bench.state.q[3] = -1.0;
  bench.state.stop_kind = StopKind::kNone;
  ASSERT_TRUE(bench.tick(&command));
  EXPECT_EQ(command.q[3], -1.0);
}

TEST(UnitreeFace, APauseThatTheLastCommandBridgesIsTold) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  const auto pause = [&bench](int ticks) {
    bench.write(stand());
    for (int n = 0; n < ticks; ++n) bench.tick();
    bench.write(stand());
    return bench.lines_with("no LowCmd for");
  };
  const int timeout = static_cast<int>(bench.model.command_timeout / bench.model.period());
  EXPECT_EQ(pause(timeout), 0);
  EXPECT_EQ(pause(2 * timeout), 1);
  EXPECT_EQ(pause(2 * timeout), 0) << "it goes on";
  for (int n = 0; n < 200; ++n) bench.tick();
  EXPECT_EQ(bench.lines_with("the last one went on"), 0) << "silence is another matter";
}

TEST(UnitreeFace, OfTwoProgramsTheFirstIsObeyedUntilItIsSilent) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  const auto first_motor = static_cast<std::size_t>(bench.face.order().bus_index[0]);
  for (int n = 0; n < 100; ++n) {
    bench.write(stand(0.1F), 1);
    bench.write(stand(0.9F), 2);
    JointCommand command;
    ASSERT_TRUE(bench.tick(&command));
    ASSERT_EQ(command.q[first_motor], static_cast<double>(0.1F));
  }
  EXPECT_EQ(bench.lines_with("a second program"), 1);
  for (int n = 0; n < 600; ++n) bench.tick();
  bench.write(stand(0.9F), 2);
  JointCommand command;
  ASSERT_TRUE(bench.tick(&command));
  EXPECT_EQ(command.q[first_motor], static_cast<double>(0.9F));
  EXPECT_EQ(command.controller_id, kFirstId + 2);
}

TEST(UnitreeFace, AFloodIsToldOnceAndTheNewestOfEachPeriodIsObeyed) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  const auto first_motor = static_cast<std::size_t>(bench.face.order().bus_index[0]);
  for (int n = 0; n < 1000; ++n) {
    for (int k = 1; k <= 4; ++k) bench.write(stand(0.1F * static_cast<float>(k)));
    JointCommand command;
    ASSERT_TRUE(bench.tick(&command));
    ASSERT_EQ(command.q[first_motor], static_cast<double>(0.1F * 4.0F));
  }
  const std::vector<std::string> lines = bench.lines();
  ASSERT_EQ(lines.size(), 2U);  // that a program began, and this
  EXPECT_NE(lines[1].find("2000 times a second"), std::string::npos) << lines[1];
}

TEST(UnitreeFace, WhatLayTooLongIsRefused) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  bench.write(stand());
  ASSERT_TRUE(bench.tick());
  bench.write(stand(), 1, 50 * kMs);
  EXPECT_FALSE(bench.tick());
  EXPECT_EQ(bench.lines_with("50 ms old"), 1);
  bench.write(stand(), 1, 30 * kMs);
  EXPECT_TRUE(bench.tick());
}

TEST(UnitreeFace, NumbersThatAGainOfZeroMakesMeaninglessAreNotPassedOn) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  LowCommand command = stand();
  for (std::size_t m = 0; m < 12; ++m) command.motor[m] = {true, 2.146e9F, 16000.0F, 0.5F, 0.0F, 0.0F};  // "no position, no speed" of the SDK
  bench.write(command);
  JointCommand out;
  ASSERT_TRUE(bench.tick(&out));
  for (std::size_t j = 0; j < 12; ++j) {
    EXPECT_EQ(out.q[j], bench.state.q[j]);
    EXPECT_EQ(out.qd[j], 0.0F);
    EXPECT_EQ(out.tau[j], 0.5F);
  }
}

TEST(UnitreeFace, TheSameAnswerIsGivenToARepeatedTick) {
  Bench bench;
  for (int n = 0; n < 5; ++n) bench.tick();
  bench.write(stand());
  JointCommand first, second;
  ASSERT_TRUE(bench.tick(&first));
  EXPECT_FALSE(bench.answer());
  bench.face.on_state(bench.state, bench.now);
  ASSERT_TRUE(bench.answer(&second));
  EXPECT_EQ(second.tick, first.tick);
  EXPECT_EQ(second.q, first.q);
}

TEST(UnitreeFace, ALowStateHasEachMotorsJointTheClockAndThePad) {
  Bench bench({.family = UnitreeFamily::kGo, .volts = 29.0F, .celsius = 35.0F});
  bench.tick();
  ASSERT_TRUE(bench.face.reading_due());
  EXPECT_FALSE(bench.face.reading_due());
  Gamepad pad;
  pad.connected = true;
  bench.face.on_gamepad(pad, bench.now);
  LowReading reading = bench.face.reading(bench.now);
  for (std::size_t m = 0; m < 12; ++m) {
    const auto bus = static_cast<std::size_t>(bench.face.order().bus_index[m]);
    EXPECT_EQ(reading.motor[m].q, static_cast<float>(bench.state.q[bus]));
    EXPECT_TRUE(reading.motor[m].on);
    EXPECT_EQ(reading.motor[m].celsius, 35.0F);
  }
  EXPECT_FALSE(reading.motor[12].on);
  EXPECT_EQ(reading.tick, 2U);
  EXPECT_EQ(reading.volts, 29.0F);
  EXPECT_EQ(reading.remote[0], 0x55);
  reading = bench.face.reading(bench.now + 300 * kMs);
  EXPECT_EQ(reading.remote[0], 0) << "a pad that has gone";
}

TEST(UnitreeFace, ForeignModelsAreNotAnswered) {
  Bench bench;
  bench.state.model_hash = 1;
  for (int n = 0; n < 10; ++n) EXPECT_FALSE(bench.tick());
  EXPECT_FALSE(bench.face.reading_due());
}

}  // namespace
}  // namespace twinbus
