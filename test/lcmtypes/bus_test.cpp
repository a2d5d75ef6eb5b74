#include "lcmtypes/bus/bus.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "lcmtypes/bus/channels.h"
#include "test/lcmtypes/samples.h"
#include "test/error_of.h"
#include "common/allocation/no_alloc.h"
#include "test/tools/bus_options.h"

namespace twinbus {
namespace {

BusOptions memory() { return {.url = "memq://", .prefix = "", .allow = {}}; }

RobotState state_at(std::int64_t tick) {
  RobotState state = sample<RobotState>();
  state.tick = tick;
  return state;
}

TEST(Bus, TheNewestMessageWins) {
  Bus bus(memory());
  Latest<RobotState> latest;
  bus.listen(channel::kState, latest);
  for (std::int64_t tick = 1; tick <= 5; ++tick)
    ASSERT_TRUE(bus.send(channel::kState, state_at(tick)));
  EXPECT_EQ(bus.receive(0), 5);
  RobotState out;
  ASSERT_TRUE(latest.take(out));
  EXPECT_EQ(out.tick, 5);
  EXPECT_EQ(bus.counters().received, 5);
  EXPECT_EQ(bus.counters().sent, 5);
}

TEST(Bus, EveryStopOfABatchIsHandledInOrder) {
  Bus bus(memory());
  std::vector<StopKind> kinds;
  const auto handler = [&](const StopRequest& stop) { kinds.push_back(stop.kind); };
  bus.listen(channel::kStop, handler);
  StopRequest stop = sample<StopRequest>();
  for (const StopKind kind : {StopKind::kHold, StopKind::kNone, StopKind::kOff}) {
    stop.kind = kind;
    ++stop.sequence;
    ASSERT_TRUE(bus.send(channel::kStop, stop));
  }
  bus.receive(0);
  EXPECT_EQ(kinds, (std::vector{StopKind::kHold, StopKind::kNone, StopKind::kOff}));
}

TEST(Bus, AHandlerWrittenInTheCallIsKept) {
  Bus bus(memory());
  std::int64_t sum = 0, heard_at = 0;
  bus.listen(channel::kState, [&sum, many = std::vector<std::int64_t>(1000, 1)](const RobotState& state) mutable {
    sum += state.tick * many.back()++;
  });
  bus.listen(channel::kStateSim, [&](const RobotState&, std::int64_t now_ns) { heard_at = now_ns; });
  for (const std::int64_t tick : {1, 2}) {
    ASSERT_TRUE(bus.send(channel::kState, state_at(tick)));
    ASSERT_TRUE(bus.send(channel::kStateSim, state_at(tick)));
  }
  bus.receive(0);
  EXPECT_EQ(sum, 1 * 1 + 2 * 2);
  EXPECT_GT(heard_at, 0);
}

// Whether a handler judges for itself or a Latest does, the heartbeat tells the same.
TEST(Bus, TheHeartbeatTellsHowEachChannelDoes) {
  Bus bus(memory());
  Latest<RobotState> latest;
  bus.listen(channel::kState, latest);
  const auto handler = [](const RobotState&) {};
  bus.listen(channel::kStateSim, handler);
  const std::array<std::uint8_t, 5> rubbish{};
  for (const Channel<RobotState>& name : {channel::kState, channel::kStateSim}) {
    for (std::int64_t tick : {1, 2, 2, 6}) ASSERT_TRUE(bus.send(name, state_at(tick)));
    ASSERT_TRUE(bus.send_raw(name, rubbish));
  }
  bus.receive(0);
  const Heartbeat beat = bus.with_channels(Heartbeat{});
  ASSERT_EQ(beat.channels, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_STREQ(channel_table()[static_cast<std::size_t>(beat.channel[i] - 1)].channel,
                 i == 0 ? "STATE" : "STATE_SIM");
    EXPECT_EQ(beat.channel_lost[i], 3);
    EXPECT_EQ(beat.channel_repeated[i], 1);
    EXPECT_EQ(beat.channel_rejected[i], 1);
    EXPECT_GE(beat.channel_age_ms[i], 0.0F);
  }
  EXPECT_EQ(bus.counters().lost, 6);
  EXPECT_EQ(bus.counters().rejected, 2);
}

TEST(Bus, ChannelsWithSeveralSendersKeepOneSlotEach) {
  Bus bus(memory());
  Slots<Heartbeat> slots;
  bus.listen(channel::kHeartbeat, slots);
  Heartbeat heartbeat = sample<Heartbeat>();
  for (std::int64_t id = 1; id <= 3; ++id) {
    heartbeat.process_id = id;
    ASSERT_TRUE(bus.send(channel::kHeartbeat, heartbeat));
  }
  bus.receive(0);
  for (std::int64_t id = 1; id <= 3; ++id) EXPECT_NE(slots.find(id), nullptr);
}

TEST(Bus, DamagedMessagesAreCountedAndNeverReplaceAGoodOne) {
  Bus bus(memory());
  Latest<RobotState> latest;
  bus.listen(channel::kState, latest);
  ASSERT_TRUE(bus.send(channel::kState, state_at(1)));
  std::vector<std::uint8_t> bytes(kLargestMessage);
  bytes.resize(static_cast<std::size_t>(encode(state_at(2), bytes)));
  for (std::size_t size : {std::size_t{1}, std::size_t{8}, bytes.size() - 1}) {
    ASSERT_TRUE(bus.send_raw(channel::kState, std::span(bytes.data(), size)));
  }
  bytes[0] ^= 0xff;
  ASSERT_TRUE(bus.send_raw(channel::kState, bytes));
  ASSERT_TRUE(bus.send(Channel<StopRequest>{channel::kState}, sample<StopRequest>()));  // another type on this channel
  bus.receive(0);
  EXPECT_EQ(latest.message.tick, 1);
  EXPECT_EQ(latest.rejected, 5);
  EXPECT_EQ(bus.counters().rejected, 5);
}

TEST(Bus, GapsAndRepetitionsAreCounted) {
  Bus bus(memory());
  Latest<RobotState> latest;
  bus.listen(channel::kState, latest);
  for (const std::int64_t tick : {1, 2, 5, 5, 4})
    ASSERT_TRUE(bus.send(channel::kState, state_at(tick)));
  bus.receive(0);
  EXPECT_EQ(bus.counters().lost, 2);
  EXPECT_EQ(bus.counters().repeated, 1);
  EXPECT_EQ(bus.counters().rejected, 1);
}

TEST(Bus, ThePrefixKeepsTwoRobotsApart) {
  BusOptions options = memory();
  options.prefix = "R1_";
  Bus bus(options);
  Latest<RobotState> mine;
  bus.listen(channel::kState, mine);
  std::vector<std::string> names;
  const auto raw = [&](const char* name, std::span<const std::uint8_t>, std::int64_t) {
    names.emplace_back(name);
  };
  bus.listen_raw(".*", raw);
  ASSERT_TRUE(bus.send(channel::kState, state_at(1)));
  bus.receive(0);
  EXPECT_EQ(mine.received, 1);
  EXPECT_EQ(names, std::vector<std::string>{"STATE"});
}

TEST(Bus, WhatIsNotFitToSendIsCountedAndNotSent) {
  Bus bus(memory());
  RobotState state = state_at(1);
  state.q[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(bus.send(channel::kState, state));
  EXPECT_EQ(bus.counters().send_failures, 1);
}

TEST(Bus, AWaitWithoutMessagesEndsAndTheDescriptorTellsOfMessages) {
  Bus bus(memory());
  Latest<RobotState> latest;
  bus.listen(channel::kState, latest);
  EXPECT_EQ(bus.receive(0.0005), 0);
  pollfd ready{.fd = bus.fileno(), .events = POLLIN, .revents = 0};
  EXPECT_EQ(poll(&ready, 1, 0), 0);
  ASSERT_TRUE(bus.send(channel::kState, state_at(1)));
  EXPECT_EQ(poll(&ready, 1, 0), 1);
  EXPECT_EQ(bus.receive(0), 1);
}

TEST(Bus, SendingAndReceivingAllocateNothing) {
  if (!allocations_counted()) GTEST_SKIP() << "malloc belongs to a sanitizer";
  Bus bus(memory());
  Latest<RobotState> state;
  Latest<JointCommand> command;
  Slots<Heartbeat> heartbeats;
  std::int64_t stops = 0;
  const auto on_stop = [&](const StopRequest&) noexcept { ++stops; };
  bus.listen(channel::kState, state);
  bus.listen(channel::kCommand, command);
  bus.listen(channel::kHeartbeat, heartbeats);
  bus.listen(channel::kStop, on_stop);
  const RobotState some_state = sample<RobotState>();
  // Handling memq messages frees and makes LCM's own list nodes, so what is counted is ours:
  // encode, decode, judge.
  for (int round = 0; round < 2; ++round) {
    NoAlloc ours;
    for (int i = 0; i < 1000; ++i) {
      std::array<std::uint8_t, kLargestMessage> bytes;
      const int size = encode(some_state, bytes);
      RobotState out;
      ASSERT_EQ(
          decode(std::span<const std::uint8_t>(bytes.data(), static_cast<std::size_t>(size)), out),
          Status::kOk);
      state.offer(out, i);
      heartbeats.offer(Heartbeat{}, i);
      bus.receive(0);
    }
    EXPECT_EQ(ours.count(), 0);
  }
}

TEST(Bus, ALogIsReadToItsEnd) {
  const std::string path = "/tmp/twinbus_bus_test_" + std::to_string(getpid()) + ".log";
  {
    Bus writer({.url = "file://" + path + "?mode=w", .prefix = "", .allow = {}});
    for (std::int64_t tick = 1; tick <= 3; ++tick) {
      ASSERT_TRUE(writer.send(channel::kState, state_at(tick)));
    }
  }
  Bus reader({.url = "file://" + path + "?speed=0", .prefix = "", .allow = {}});
  Latest<RobotState> latest;
  reader.listen(channel::kState, latest);
  while (reader.receive(1.0) > 0) {
  }
  EXPECT_EQ(latest.received, 3);
  std::remove(path.c_str());
}

std::string complaint(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  BusOptions options;
  return test::error_of([&] {
    int i = 0;
    take_bus_option(static_cast<int>(argv.size()), argv.data(), i, options);
    Bus bus(options);
  });
}

TEST(BusOptions, BadValuesAreRefusedWithTheirName) {
  EXPECT_NE(complaint({"--url"}).find("--url"), std::string::npos);
  EXPECT_NE(complaint({"--url", "tcpq://"}).find("udpm://"), std::string::npos);
  EXPECT_NE(complaint({"--url", "udpm://239.255.76.67:99999"}).find("port"), std::string::npos);
  EXPECT_NE(complaint({"--prefix", "A.*"}).find("--prefix"), std::string::npos);
  EXPECT_NE(complaint({"--allow", "10.0.0.300"}).find("10.0.0.300"), std::string::npos);
  EXPECT_NE(complaint({"--allow", "10.0.0.1,"}).find("--allow"), std::string::npos);
}

TEST(BusOptions, AllowTakesSeveralAddresses) {
  std::vector<std::string> words{"--allow", "10.0.0.1,10.0.0.2"};
  std::vector<char*> argv{words[0].data(), words[1].data()};
  BusOptions options;
  int i = 0;
  EXPECT_TRUE(take_bus_option(2, argv.data(), i, options));
  EXPECT_EQ(i, 1);
  EXPECT_EQ(options.allow, (std::vector<std::string>{"10.0.0.1,10.0.0.2"}));
}

}  // namespace
}  // namespace twinbus
