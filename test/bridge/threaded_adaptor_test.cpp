#include "bridge/adaptor/threaded_adaptor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "test/bridge/small_robot.h"

namespace twinbus {
namespace {

using namespace test;

// A device that hangs in read() for as long as it is told to.
class HangingRobot : public PointRobot {
 public:
  HangingRobot() : PointRobot(false) {}
  Status read(RobotState& state, double) override {
    std::unique_lock<std::mutex> lock(mutex_);
    hanging = hangs_;
    free_.wait(lock, [&] { return !hangs_; });
    state.q[0] = 0.001 * static_cast<double>(++reads_);
    return Status::kOk;
  }
  Status write(const JointCommand& command) override {
    last_tick = command.tick;
    return write_result.load();
  }
  Status fall_safe() override {
    fell = true;
    return Status::kOk;
  }
  void hang(bool hangs) {
    const std::lock_guard<std::mutex> lock(mutex_);
    hangs_ = hangs;
    free_.notify_all();
  }
  std::atomic<std::int64_t> last_tick{-1};
  std::atomic<Status> write_result{Status::kOk};
  std::atomic<bool> fell{false}, hanging{false};

 private:
  std::mutex mutex_;
  std::condition_variable free_;
  bool hangs_ = false;
  std::int64_t reads_ = 0;
};

constexpr double kPatience = 5.0;  // [s]

TEST(ThreadedAdaptor, ReadsAndWritesTheDevice) {
  const Model model = small_model();
  HangingRobot robot;
  ThreadedAdaptor adaptor(robot);
  RobotState state;
  EXPECT_EQ(adaptor.read(state, 0.0), Status::kNotOpen);
  ASSERT_EQ(adaptor.open(model, {}), Status::kOk);
  for (int i = 1; i <= 100; ++i) {
    ASSERT_EQ(adaptor.read(state, kPatience), Status::kOk);
    EXPECT_DOUBLE_EQ(state.q[0], 0.001 * i);
    JointCommand command;
    command.tick = i;
    EXPECT_EQ(adaptor.write(command), Status::kOk);
  }
  ASSERT_EQ(adaptor.read(state, kPatience), Status::kOk);  // the thread has written before
  EXPECT_EQ(robot.last_tick.load(), 100);
  adaptor.close();
  EXPECT_FALSE(adaptor.hung());
}

TEST(ThreadedAdaptor, ADeviceThatHangsGivesATimeoutAndThenGoesOn) {
  const Model model = small_model();
  HangingRobot robot;
  ThreadedAdaptor adaptor(robot);
  ASSERT_EQ(adaptor.open(model, {}), Status::kOk);
  RobotState state;
  ASSERT_EQ(adaptor.read(state, kPatience), Status::kOk);
  robot.hang(true);
  state.q[0] = 5.0;
  EXPECT_EQ(adaptor.read(state, 0.001), Status::kTimeout);
  EXPECT_EQ(adaptor.read(state, 0.001), Status::kTimeout);
  EXPECT_EQ(state.q[0], 5.0);  // nothing old is taken for new
  robot.hang(false);
  EXPECT_EQ(adaptor.read(state, kPatience), Status::kOk);
  EXPECT_NE(state.q[0], 5.0);
}

TEST(ThreadedAdaptor, AFailedWriteIsToldByTheNext) {
  const Model model = small_model();
  HangingRobot robot;
  ThreadedAdaptor adaptor(robot);
  ASSERT_EQ(adaptor.open(model, {}), Status::kOk);
  robot.write_result.store(Status::kDeviceError);
  RobotState state;
  const Status first = adaptor.write({});  // of the write before it
  static_cast<void>(first);
  ASSERT_EQ(adaptor.read(state, kPatience), Status::kOk);
  EXPECT_EQ(adaptor.write({}), Status::kDeviceError);
}

TEST(ThreadedAdaptor, CloseLeavesADeviceThatHangsForGood) {
  const Model model = small_model();
  auto robot = std::make_unique<HangingRobot>();
  ThreadedAdaptor adaptor(*robot);
  ASSERT_EQ(adaptor.open(model, {}), Status::kOk);
  robot->hang(true);
  RobotState state;
  EXPECT_EQ(adaptor.read(state, 0.001), Status::kTimeout);
  while (!robot->hanging) std::this_thread::yield();  // a busy machine lets its thread begin late
  adaptor.close();
  EXPECT_TRUE(adaptor.hung());
  robot->hang(false);
  static HangingRobot* left_for_good = nullptr;  // the thread may still be inside; no leak, for something points to it
  left_for_good = robot.release();
  EXPECT_NE(left_for_good, nullptr);
}

TEST(ThreadedAdaptor, FallSafeReachesTheDevice) {
  const Model model = small_model();
  HangingRobot robot;
  ThreadedAdaptor adaptor(robot);
  ASSERT_EQ(adaptor.open(model, {}), Status::kOk);
  static_cast<void>(adaptor.fall_safe());  // a busy machine may take longer than it waits
  adaptor.close();
  EXPECT_TRUE(robot.fell.load());
}

}  // namespace
}  // namespace twinbus
