// Plans in a thread of its own, so that whoever asks can go on listening to the robot.
//
// One question at a time: a new one makes the worker drop the one it is at.

#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "planner/arm_planner.h"

namespace twinbus::inline planner {

struct PlanQuestion {
  ArmGoal goal;
  Configuration start;
  Eigen::Isometry3d ground_in_world = Eigen::Isometry3d::Identity();
  std::vector<Obstacle> obstacles;  // in the world of start's base
  std::uint64_t seed = 0;
  bool balancing = false;  // as of ArmPlanner
};

struct PlanAnswer {
  ArmGoal goal;
  ArmPlan plan;
  double seconds = 0.0;  // that planning took
};

class PlanWorker {
 public:
  // The model must outlive the worker.
  explicit PlanWorker(const Model& model);
  ~PlanWorker();

  void ask(PlanQuestion question);
  // Drops the question that is being worked on, if any.
  void cancel();
  // The next answer, if one is there.  An answer to a question that was replaced says kCancelled.
  std::optional<PlanAnswer> answer();

 private:
  void work();
  static bool keep_on(void* worker);

  ArmPlanner planner_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::unique_ptr<PlanQuestion> question_;
  std::vector<PlanAnswer> answers_;
  std::atomic<bool> stop_{false}, drop_{false}, answered_{false};
  std::thread thread_;
};

}  // namespace twinbus::planner
