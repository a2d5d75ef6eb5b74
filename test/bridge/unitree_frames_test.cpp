// Unitree's frames: checksum, layout, what is refused.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "bridge/unitree/crc.h"
#include "bridge/unitree/low_frames.h"
#include "bridge/unitree/motion_service.h"
#include "bridge/unitree/remote.h"
#include "bridge/unitree/sample_age.h"

namespace twinbus {
namespace {

using Bytes = std::vector<std::byte>;
constexpr UnitreeFamily kFamilies[] = {UnitreeFamily::kHg, UnitreeFamily::kGo};

// The definition, bit by bit.
std::uint32_t slow_crc(std::span<const std::byte> bytes) {
  std::uint32_t r = 0xFFFFFFFF;
  for (std::size_t at = 0; at < bytes.size(); at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, 4);
    for (int bit = 31; bit >= 0; --bit) {
      const bool out = (r >> 31) != 0;
      r <<= 1;
      if (out) r ^= 0x04C11DB7;
      if ((word >> bit & 1U) != 0) r ^= 0x04C11DB7;
    }
  }
  return r;
}

LowCommand some_command(std::mt19937& random, UnitreeFamily family) {
  std::uniform_real_distribution<float> number(-100.0F, 100.0F);
  LowCommand command;
  if (family == UnitreeFamily::kHg) command.mode_machine = static_cast<std::uint8_t>(random() % 256);
  for (std::size_t m = 0; m < static_cast<std::size_t>(motor_count(family)); ++m) {
    if (random() % 4 == 0) continue;
    command.motor[m] = {true, number(random), number(random), number(random), std::fabs(number(random)), std::fabs(number(random))};
  }
  return command;
}

// With the checksum made right again.
void seal(Bytes& frame) {
  const std::uint32_t crc = slow_crc(std::span(frame).first(frame.size() - 4));
  std::memcpy(frame.data() + frame.size() - 4, &crc, 4);
}

template <class T>
void put(Bytes& frame, std::size_t at, T value) {
  std::memcpy(frame.data() + at, &value, sizeof value);
}

TEST(UnitreeCrc, EqualsItsDefinitionBitByBit) {
  std::mt19937 random(1);
  for (const std::size_t size : {std::size_t{0}, std::size_t{4}, std::size_t{808}, std::size_t{1000}, std::size_t{2088}}) {
    Bytes bytes(size);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    EXPECT_EQ(crc_of_words(bytes), slow_crc(bytes)) << size;
  }
}

// Checksums that the vendor's Python SDK computes (unitree-sdk2py-dimos 1.0.3) of the same values, printed by
// test/bridge/make_unitree_vectors.py: they are right only if every field lies where the SDK has it.
constexpr std::uint32_t kHgCommand = 0x990CEC7C;
constexpr std::uint32_t kHgState = 0xFF785A45;
constexpr std::uint32_t kGoCommand = 0x4F007FD3;
constexpr std::uint32_t kGoState = 0x8210304B;

template <class Content>
std::uint32_t sealed_with(const Content& content, UnitreeFamily family, std::size_t size) {
  Bytes frame(size);
  encode(content, family, frame);
  std::uint32_t crc = 0;
  std::memcpy(&crc, frame.data() + size - 4, 4);
  return crc;
}

TEST(UnitreeCrc, OfWholeFramesEqualsThatOfTheVendorsSdk) {
  LowCommand command;
  LowReading reading;
  for (std::size_t m = 0; m < kHgMotors; ++m) {
    const auto x = static_cast<float>(m);
    command.motor[m] = {true, x / 8 - 1, x / 4, 0 - x / 2, x + 1, x / 16};
    reading.motor[m] = {true, x / 8 - 1, x / 4, 0 - x / 2, 41.0F, 50.5F};
  }
  command.mode_machine = reading.mode_machine = 5;
  reading.tick = 123456;
  reading.gyro = {1.0F, 2.0F, 3.0F};
  reading.accel = {0.5F, -0.5F, 9.75F};
  for (std::size_t k = 0; k < kRemoteBytes; ++k) reading.remote[k] = static_cast<std::uint8_t>(k);
  reading.foot_force = {10, 20, 30, 40};
  reading.volts = 29.5F;
  EXPECT_EQ(sealed_with(command, UnitreeFamily::kHg, sizeof(HgLowCmd)), kHgCommand);
  EXPECT_EQ(sealed_with(reading, UnitreeFamily::kHg, sizeof(HgLowState)), kHgState);
  EXPECT_EQ(sealed_with(command, UnitreeFamily::kGo, sizeof(GoLowCmd)), kGoCommand);
  EXPECT_EQ(sealed_with(reading, UnitreeFamily::kGo, sizeof(GoLowState)), kGoState);
}

template <class Thing, class... Field>
void expect_same(const Thing& back, const Thing& sent, Field... fields) {
  const auto same = [&](auto field) { EXPECT_EQ(back.*field, sent.*field); };
  (same(fields), ...);
}

template <class Frame, class... Field>
void expect_same_motors(const Frame& back, const Frame& sent, UnitreeFamily family, Field... fields) {
  for (std::size_t m = 0; m < static_cast<std::size_t>(motor_count(family)); ++m) {
    expect_same(back.motor[m], sent.motor[m], fields...);
  }
}

TEST(UnitreeFrames, ACommandComesBackAsItWasSent) {
  std::mt19937 random(2);
  for (const UnitreeFamily family : kFamilies) {
    for (int n = 0; n < 1000; ++n) {
      const LowCommand sent = some_command(random, family);
      Bytes frame(command_bytes(family));
      encode(sent, family, frame);
      LowCommand back;
      ASSERT_EQ(decode(frame, family, back).fault, FrameFault::kNone);
      EXPECT_EQ(back.mode_machine, sent.mode_machine);
      using Motor = std::decay_t<decltype(sent.motor[0])>;
      expect_same_motors(back, sent, family, &Motor::on, &Motor::q, &Motor::dq, &Motor::tau, &Motor::kp, &Motor::kd);
    }
  }
}

TEST(UnitreeFrames, AStateComesBackAsItWasSent) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(-10.0F, 10.0F);
  for (const UnitreeFamily family : kFamilies) {
    LowReading sent;
    sent.mode_machine = family == UnitreeFamily::kHg ? 5 : 0;
    sent.tick = 123456;
    sent.quaternion = {0.5F, 0.5F, -0.5F, 0.5F};
    sent.gyro = {1, 2, 3};
    sent.accel = {4, 5, 6};
    for (std::size_t m = 0; m < static_cast<std::size_t>(motor_count(family)); ++m)
      sent.motor[m] = {true, number(random), number(random), number(random), 41.0F, family == UnitreeFamily::kHg ? 50.5F : 0.0F};
    sent.remote.fill(7);
    if (family == UnitreeFamily::kGo) {
      sent.foot_force = {10, 20, 30, 40};
      sent.volts = 29.5F;
    }
    Bytes frame(state_bytes(family));
    encode(sent, family, frame);
    LowReading back;
    ASSERT_EQ(decode(frame, family, back).fault, FrameFault::kNone);
    using L = LowReading;
    expect_same(back, sent, &L::mode_machine, &L::tick, &L::quaternion, &L::gyro, &L::accel, &L::remote, &L::foot_force, &L::volts);
    using Motor = std::decay_t<decltype(sent.motor[0])>;
    expect_same_motors(back, sent, family, &Motor::q, &Motor::dq, &Motor::tau, &Motor::celsius, &Motor::volts);
  }
}

TEST(UnitreeFrames, AnyFlippedBitIsRefused) {
  std::mt19937 random(4);
  for (const UnitreeFamily family : kFamilies) {
    Bytes frame(command_bytes(family));
    encode(some_command(random, family), family, frame);
    for (std::size_t byte = 0; byte < frame.size(); ++byte) {
      frame[byte] ^= static_cast<std::byte>(1U << (byte % 8));
      LowCommand command;
      EXPECT_EQ(decode(frame, family, command).fault, FrameFault::kCrc) << byte;
      frame[byte] ^= static_cast<std::byte>(1U << (byte % 8));
    }
  }
}

TEST(UnitreeFrames, WhatIsNotFiniteIsRefusedWholeWithItsMotorAndChangesNothing) {
  std::mt19937 random(5);
  const std::size_t first[] = {offsetof(HgLowCmd, motor_cmd), offsetof(GoLowCmd, motor_cmd)};
  const std::size_t size[] = {sizeof(HgMotorCmd), sizeof(GoMotorCmd)};
  for (std::size_t f = 0; f < 2; ++f) {
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      for (std::size_t field = 0; field < 5; ++field) {
        LowCommand sent;
        sent.motor[11].on = true;
        Bytes frame(command_bytes(kFamilies[f]));
        encode(sent, kFamilies[f], frame);
        put(frame, first[f] + 11 * size[f] + 4 + 4 * field, wrong);
        seal(frame);
        LowCommand command;
        command.motor[3].q = 42.0F;
        const FrameVerdict verdict = decode(frame, kFamilies[f], command);
        EXPECT_EQ(verdict.fault, FrameFault::kNotFinite);
        EXPECT_EQ(verdict.motor, 11);
        EXPECT_EQ(command.motor[3].q, 42.0F);
      }
    }
  }
}

TEST(UnitreeFrames, UnknownModesNegativeGainsAndOtherSizesAreRefused) {
  LowCommand sent;
  sent.motor[2].on = true;
  Bytes hg(command_bytes(UnitreeFamily::kHg)), go(command_bytes(UnitreeFamily::kGo));
  LowCommand command;
  encode(sent, UnitreeFamily::kHg, hg);
  hg[offsetof(HgLowCmd, motor_cmd) + 2 * sizeof(HgMotorCmd)] = std::byte{2};
  seal(hg);
  FrameVerdict verdict = decode(hg, UnitreeFamily::kHg, command);
  EXPECT_EQ(verdict.fault, FrameFault::kMotorMode);
  EXPECT_EQ(verdict.motor, 2);
  EXPECT_EQ(verdict.value, 2);

  encode(sent, UnitreeFamily::kHg, hg);
  put(hg, offsetof(HgLowCmd, motor_cmd) + 2 * sizeof(HgMotorCmd) + offsetof(HgMotorCmd, kp), -1.0F);
  seal(hg);
  EXPECT_EQ(decode(hg, UnitreeFamily::kHg, command).fault, FrameFault::kGain);

  encode(sent, UnitreeFamily::kGo, go);
  go[offsetof(GoLowCmd, level_flag)] = std::byte{0xEE};
  seal(go);
  verdict = decode(go, UnitreeFamily::kGo, command);
  EXPECT_EQ(verdict.fault, FrameFault::kLevel);
  EXPECT_EQ(verdict.value, 0xEE);

  encode(sent, UnitreeFamily::kGo, go);
  go[offsetof(GoLowCmd, motor_cmd) + 2 * sizeof(GoMotorCmd)] = std::byte{10};  // "on" of older programs
  seal(go);
  EXPECT_EQ(decode(go, UnitreeFamily::kGo, command).fault, FrameFault::kNone);
  EXPECT_TRUE(command.motor[2].on);

  EXPECT_EQ(decode(go, UnitreeFamily::kHg, command).fault, FrameFault::kSize);
  EXPECT_EQ(decode(std::span(hg).first(100), UnitreeFamily::kHg, command).fault, FrameFault::kSize);
  EXPECT_EQ(decode({}, UnitreeFamily::kHg, command).fault, FrameFault::kSize);
}

TEST(UnitreeFrames, AMotorThatIsOffIsLimpWhateverItsNumbersSay) {
  LowCommand sent;
  sent.motor[0].on = true;
  Bytes frame(command_bytes(UnitreeFamily::kHg));
  encode(sent, UnitreeFamily::kHg, frame);
  put(frame, offsetof(HgLowCmd, motor_cmd), std::uint8_t{0});
  put(frame, offsetof(HgLowCmd, motor_cmd) + offsetof(HgMotorCmd, tau), std::numeric_limits<float>::quiet_NaN());
  seal(frame);
  LowCommand command;
  ASSERT_EQ(decode(frame, UnitreeFamily::kHg, command).fault, FrameFault::kNone);
  EXPECT_FALSE(command.motor[0].on);
  EXPECT_EQ(command.motor[0].tau, 0.0F);
}

TEST(UnitreeRemote, SticksAndButtonsAreWhereTheRemoteHasThem) {
  Gamepad pad;
  EXPECT_EQ(remote_of(pad), (std::array<std::uint8_t, kRemoteBytes>{}));  // not connected
  pad.connected = true;
  pad.left_x = 0.25F;
  pad.left_y = 0.5F;
  pad.right_x = -0.75F;
  pad.right_y = std::numeric_limits<float>::quiet_NaN();
  pad.left_trigger = 1.0F;
  pad.buttons = 1 << 0 | 1 << 10 | 1 << 14;  // A, right shoulder, right
  const auto bytes = remote_of(pad);
  const auto number = [&bytes](std::size_t at) {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
  };
  EXPECT_EQ(bytes[2], 1U << 0 | 1U << 5);  // R1, L2
  EXPECT_EQ(bytes[3], 1U << 0 | 1U << 5);  // A, right
  EXPECT_EQ(number(4), -0.25F);            // lx: right is positive
  EXPECT_EQ(number(8), 0.75F);
  EXPECT_EQ(number(12), 0.0F);
  EXPECT_EQ(number(20), 0.5F);
}

TEST(UnitreeMotionService, IsReleased) {
  EXPECT_STREQ(motion_service(1001, "").data, R"({"form":"0","name":""})");
  EXPECT_EQ(motion_service(1001, "").code, 0);
  EXPECT_EQ(motion_service(1003, "").code, 0);
  EXPECT_NE(motion_service(1002, R"({"name":"ai"})").code, 0);
  EXPECT_NE(motion_service(4242, "").code, 0);
}

TEST(SampleAgeTest, DelayIsFoundWhateverTheOtherClockSays) {
  constexpr std::int64_t kMillisecond = 1'000'000;
  for (const std::int64_t offset : {std::int64_t{0}, std::int64_t{1} << 62, -(std::int64_t{1} << 62)}) {
    SampleAge age;
    EXPECT_EQ(age.of(offset, 1000 * kMillisecond), 0);
    EXPECT_EQ(age.of(offset + 2 * kMillisecond, 1002 * kMillisecond), 0);
    EXPECT_EQ(age.of(offset + 4 * kMillisecond, 1104 * kMillisecond), 100 * kMillisecond);  // lay somewhere
    EXPECT_EQ(age.of(offset + 106 * kMillisecond, 1106 * kMillisecond), 0);
    // A clock that runs 100 ppm slower does not make everything old.
    std::int64_t worst = 0;
    for (std::int64_t t = 2'000 * kMillisecond; t < 600'000 * kMillisecond; t += 20 * kMillisecond)
      worst = std::max(worst, age.of(offset + t - 1000 * kMillisecond - t / 10'000, t));
    EXPECT_LT(worst, 2 * kMillisecond);
  }
}

}  // namespace
}  // namespace twinbus
