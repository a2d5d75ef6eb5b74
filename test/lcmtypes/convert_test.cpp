#include "lcmtypes/bus/convert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "lcmtypes/msg/robot_io.h"
#include "test/lcmtypes/samples.h"

namespace twinbus {
namespace {

template <class T>
Message<T> message_of(const T& value) {
  Message<T> message;
  EXPECT_EQ(to_message(value, message), Status::kOk);
  return message;
}

TEST(Convert, TheSamplesOfAllTypesPassInBothDirections) {
  for_every_type([]<class T>() {
    Message<T> message;
    ASSERT_EQ(to_message(sample<T>(), message), Status::kOk) << Message<T>::getTypeName();
    T back;
    EXPECT_EQ(from_message(message, back), Status::kOk) << Message<T>::getTypeName();
  });
}

TEST(Convert, FieldsGoWhereTheyBelong) {
  const RobotState state = sample<RobotState>();
  const robot_state_t message = message_of(state);
  EXPECT_EQ(message.tick, state.tick);
  EXPECT_EQ(message.time_ns, state.time_ns);
  EXPECT_EQ(message.grant_tick, state.grant_tick);
  EXPECT_EQ(message.role, static_cast<int>(state.role));
  EXPECT_EQ(message.q[47], state.q[47]);
  EXPECT_EQ(message.qd[0], state.qd[0]);
  EXPECT_EQ(message.wrench[kRightHand][5], state.wrench[kRightHand][5]);
  const joint_command_t command = message_of(sample<JointCommand>());
  EXPECT_EQ(command.flags, sample<JointCommand>().flags);
  EXPECT_EQ(command.kd[47], sample<JointCommand>().kd[47]);
}

TEST(Convert, JointsBeyondTheCountComeOutAsZero) {
  robot_state_t message = message_of(sample<RobotState>());
  message.joint_count = 29;
  RobotState state;
  ASSERT_EQ(from_message(message, state), Status::kOk);
  EXPECT_NE(state.q[28], 0.0);
  for (std::size_t i = 29; i < state.q.size(); ++i) {
    EXPECT_EQ(state.q[i], 0.0);
    EXPECT_EQ(state.tau[i], 0.0f);
  }
}

TEST(Convert, ReasonsAreTold) {
  RobotState state;
  robot_state_t message = message_of(sample<RobotState>());
  message.qd[3] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(from_message(message, state), Status::kNotFinite);
  message = message_of(sample<RobotState>());
  message.joint_count = 49;
  EXPECT_EQ(from_message(message, state), Status::kWrongSize);
  message = message_of(sample<RobotState>());
  message.role = 7;
  EXPECT_EQ(from_message(message, state), Status::kOutOfRange);
}

TEST(Convert, AttitudeMustBeARotationWhereTheImuIsValid) {
  RobotState state;
  robot_state_t message = message_of(sample<RobotState>());
  for (float& x : message.attitude) x = 0.0f;
  EXPECT_EQ(from_message(message, state), Status::kOutOfRange);
  message.sensor_flags &= ~kImuValid;
  EXPECT_EQ(from_message(message, state), Status::kOk);
}

TEST(Convert, AnEstimateIsARotationWithDeviationsAndProbabilities) {
  Estimate estimate;
  const estimate_t good = message_of(sample<Estimate>());
  ASSERT_EQ(from_message(good, estimate), Status::kOk);
  EXPECT_EQ(estimate.foot_position[5][2], sample<Estimate>().foot_position[5][2]);
  const auto refuses = [&](auto&& spoil) {
    estimate_t message = good;
    spoil(message);
    return from_message(message, estimate) == Status::kOutOfRange;
  };
  EXPECT_TRUE(refuses([](estimate_t& m) { m.base_attitude[0] = 2.0; }));
  EXPECT_TRUE(refuses([](estimate_t& m) { m.velocity_deviation[2] = -0.1f; }));
  EXPECT_TRUE(refuses([](estimate_t& m) { m.foot_certainty[3] = 1.5f; }));
  EXPECT_TRUE(refuses([](estimate_t& m) { m.foot_joint[0] = 48; }));
  EXPECT_TRUE(refuses([](estimate_t& m) { m.foot_stands[1] = 2; }));
  EXPECT_TRUE(refuses([](estimate_t& m) { m.velocity_from = 5; }));
  estimate_t message = good;
  message.foot_count = 7;
  EXPECT_EQ(from_message(message, estimate), Status::kWrongSize);
}

TEST(Convert, NegativeGainsAreRefused) {
  JointCommand command;
  joint_command_t message = message_of(sample<JointCommand>());
  message.kp[4] = -1.0f;
  EXPECT_EQ(from_message(message, command), Status::kOutOfRange);
}

TEST(Convert, IdentifiersKeepTheirPrecisionInJavaScript) {
  StopRequest stop = sample<StopRequest>();
  stop.sender_id = (std::int64_t{1} << 53) - 1;
  EXPECT_EQ(message_of(stop).sender_id, stop.sender_id);
  stop_t message = message_of(stop);
  message.sender_id = std::int64_t{1} << 53;
  EXPECT_EQ(from_message(message, stop), Status::kOutOfRange);
}

TEST(Convert, KnotsOfAPathAreInOrder) {
  ArmPathPiece piece;
  arm_path_t message = message_of(sample<ArmPathPiece>());
  message.time[3] = message.time[2] - 0.001;
  EXPECT_EQ(from_message(message, piece), Status::kOutOfRange);
}

TEST(Convert, TextForPeopleHasAnEndAndCannotDriveATerminal) {
  Event event;
  event_t message = message_of(sample<Event>());
  message.text[0] = 27;  // escape
  message.text[1] = '\n';
  ASSERT_EQ(from_message(message, event), Status::kOk);
  EXPECT_EQ(std::string(event.text.data()).substr(0, 2), "??");
  for (auto& c : message.text) c = 'x';
  EXPECT_EQ(from_message(message, event), Status::kWrongSize);
}

}  // namespace
}  // namespace twinbus
