#include "viewer_log/view/switch_plan.h"

#include <gtest/gtest.h>

#include "test/viewer/standing.h"

namespace twinbus {
namespace {

constexpr std::int64_t kPlanMs = 1'000'000;

using test::model;

RobotState state_of(std::int64_t run, Role role) {
  RobotState state;
  state.run_id = run;
  state.role = role;
  state.joint_count = static_cast<std::int16_t>(model().bus_count());
  return state;
}

SourceStatus status_of_target(Role role) {
  SourceStatus status;
  status.run_id = 12;
  status.role = role;
  return status;
}

TEST(SwitchPlan, AShadowFollowsForASecondBeforeItTakesOver) {
  StackView view(model());
  SwitchPlan plan;
  std::int64_t now = 1000 * kPlanMs;
  SourceRequest request;
  view.on_state(state_of(11, Role::kActive), now);
  view.on_source_status(status_of_target(Role::kParked), now);
  EXPECT_FALSE(plan.next(view, now, request));
  plan.start(12, now);
  ASSERT_TRUE(plan.next(view, now, request));
  EXPECT_EQ(request.action, SourceAction::kStandbyShadow);
  EXPECT_EQ(request.run_id, 12);
  EXPECT_FALSE(plan.next(view, now + kPlanMs, request));

  view.on_source_status(status_of_target(Role::kStandbyShadow), now);
  const std::int64_t begin = now;
  while (!plan.next(view, now, request) && now < begin + 3000 * kPlanMs) {
    now += 20 * kPlanMs;
    view.on_state(state_of(11, Role::kActive), now);
    view.on_standby_state(state_of(12, Role::kStandbyShadow), now);
  }
  EXPECT_EQ(request.action, SourceAction::kSwitch);
  EXPECT_EQ(request.run_id, 11);
  EXPECT_EQ(request.target_run_id, 12);
  EXPECT_GE(now - begin, 1000 * kPlanMs);
  EXPECT_LT(now - begin, 1200 * kPlanMs);
  EXPECT_FALSE(plan.next(view, now, request));
}

TEST(SwitchPlan, WithNobodyActiveItActivates) {
  StackView view(model());
  SwitchPlan plan;
  SourceRequest request;
  plan.start(12, 1000 * kPlanMs);
  ASSERT_TRUE(plan.next(view, 1000 * kPlanMs, request));
  EXPECT_EQ(request.action, SourceAction::kActivate);
  EXPECT_EQ(request.target_run_id, 12);
  EXPECT_FALSE(plan.next(view, 1001 * kPlanMs, request));
}

}  // namespace
}  // namespace twinbus
