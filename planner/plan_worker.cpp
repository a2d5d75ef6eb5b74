#include "planner/plan_worker.h"

#include <utility>

#include "common/process/process.h"

namespace twinbus::inline planner {

PlanWorker::PlanWorker(const Model& model) : planner_(model), thread_([this] { work(); }) {}

PlanWorker::~PlanWorker() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    drop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void PlanWorker::ask(PlanQuestion question) {
  {
    const std::lock_guard lock(mutex_);
    question_ = std::make_unique<PlanQuestion>(std::move(question));
    drop_ = true;
  }
  wake_.notify_one();
}

void PlanWorker::cancel() {
  const std::lock_guard lock(mutex_);
  question_.reset();
  drop_ = true;
}

std::optional<PlanAnswer> PlanWorker::answer() {
  if (!answered_.load(std::memory_order_acquire)) return std::nullopt;  // asked every tick: no lock
  const std::lock_guard lock(mutex_);
  PlanAnswer answer = std::move(answers_.front());
  answers_.erase(answers_.begin());
  answered_ = !answers_.empty();
  return answer;
}

bool PlanWorker::keep_on(void* worker) { return !static_cast<PlanWorker*>(worker)->drop_.load(); }

void PlanWorker::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return stop_.load() || question_ != nullptr; });
    if (stop_) return;
    const std::unique_ptr<PlanQuestion> question = std::move(question_);
    drop_ = false;
    lock.unlock();
    const std::int64_t begin = monotonic_ns();
    planner_.set_obstacles(question->obstacles);
    planner_.set_balancing(question->balancing);
    PlanAnswer answer;
    answer.goal = question->goal;
    answer.plan = planner_.plan(question->goal, question->start, question->ground_in_world,
                                question->seed, &keep_on, this);
    answer.seconds = 1e-9 * static_cast<double>(monotonic_ns() - begin);
    lock.lock();
    answers_.push_back(std::move(answer));
    answered_.store(true, std::memory_order_release);
  }
}

}  // namespace twinbus::planner
