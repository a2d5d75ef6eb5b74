// The worker has a thread: std::thread inside; the sanitizer looks at it through this test.
#include "planner/plan_worker.h"

#include <gtest/gtest.h>

#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

PlanQuestion question(std::int64_t goal_id, double x) {
  PlanQuestion q;
  q.goal = hand_to(ArmSide::kLeft, x, 0.26, 0.86);
  q.goal.goal_id = goal_id;
  q.start = standing();
  q.seed = static_cast<std::uint64_t>(goal_id);
  return q;
}

PlanAnswer wait(PlanWorker& worker) {
  for (;;) {
    if (auto answer = worker.answer()) return *std::move(answer);
    std::this_thread::yield();
  }
}

TEST(PlanWorker, AnswersAsThePlannerDoes) {
  PlanWorker worker(hrp1s());
  EXPECT_FALSE(worker.answer().has_value());
  worker.ask(question(5, 0.40));
  const PlanAnswer answer = wait(worker);
  EXPECT_EQ(answer.goal.goal_id, 5);
  ASSERT_EQ(answer.plan.status, ArmPathStatus::kOk);
  ArmPlanner planner(hrp1s());
  const PlanQuestion same = question(5, 0.40);
  const ArmPlan plan = planner.plan(same.goal, same.start, same.ground_in_world, same.seed);
  ASSERT_EQ(plan.path.size(), answer.plan.path.size());
  EXPECT_EQ(plan.path.back().q, answer.plan.path.back().q);
}

TEST(PlanWorker, TheNewestQuestionIsAnsweredWhateverCameBefore) {
  PlanWorker worker(hrp1s());
  for (int i = 1; i <= 20; ++i) worker.ask(question(i, 0.3 + 0.005 * i));
  for (;;) {
    const PlanAnswer answer = wait(worker);
    if (answer.goal.goal_id < 20) continue;  // one that had been begun
    EXPECT_EQ(answer.goal.goal_id, 20);
    EXPECT_EQ(answer.plan.status, ArmPathStatus::kOk);
    break;
  }
}

TEST(PlanWorker, CancelDropsTheQuestionAndTheWorkerGoesOn) {
  PlanWorker worker(hrp1s());
  worker.ask(question(1, 0.40));
  worker.cancel();
  worker.ask(question(2, 0.38));
  PlanAnswer answer = wait(worker);
  if (answer.goal.goal_id == 1) answer = wait(worker);
  EXPECT_EQ(answer.goal.goal_id, 2);
  EXPECT_EQ(answer.plan.status, ArmPathStatus::kOk);
}

TEST(PlanWorker, EndsInTheMiddleOfAPlan) {
  for (int i = 0; i < 3; ++i) {
    PlanWorker worker(hrp1s());
    PlanQuestion hard = question(1, 0.40);
    // A cage around the hand: the search takes all its rounds.
    hard.obstacles = {box(0.40, 0.26, 0.86, 0.30, 0.30, 0.01), post(0.25, 0.3)};
    worker.ask(hard);
  }
}

}  // namespace
}  // namespace twinbus
