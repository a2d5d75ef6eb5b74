#include "bridge/adaptor/threaded_adaptor.h"

#include <semaphore.h>

#include <atomic>
#include <ctime>
#include <thread>

#include "bridge/adaptor/mailbox.h"

namespace twinbus::inline bridge {

namespace {

constexpr double kCloseWaits = 0.5;  // [s]
constexpr double kFallSafeWaits = 0.001;

timespec after(double seconds) noexcept {
  timespec t;
  ::clock_gettime(CLOCK_MONOTONIC, &t);
  const long ns = t.tv_nsec + static_cast<long>(seconds * 1e9);
  t.tv_sec += ns / 1'000'000'000;
  t.tv_nsec = ns % 1'000'000'000;
  return t;
}

class Semaphore {
 public:
  Semaphore() { ::sem_init(&semaphore_, 0, 0); }
  ~Semaphore() { ::sem_destroy(&semaphore_); }
  Semaphore(const Semaphore&) = delete;
  Semaphore& operator=(const Semaphore&) = delete;
  void post() noexcept { ::sem_post(&semaphore_); }
  void wait() noexcept {
    while (::sem_wait(&semaphore_) != 0) {
    }
  }
  bool wait_until(const timespec& due) noexcept {
    return ::sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &due) == 0;
  }

 private:
  sem_t semaphore_;
};

struct Measured {
  RobotState state;
  Status status = Status::kTimeout;
  std::int64_t request = 0;  // the read it answers
};

}  // namespace

struct ThreadedAdaptor::Shared {
  RobotAdaptor* inner = nullptr;
  double read_timeout = 0.0;
  std::thread thread;
  Semaphore work, answered, ended, fallen;
  std::atomic<std::int64_t> reads_wanted{0};
  std::atomic<bool> fall_wanted{false}, quit{false};
  std::atomic<Status> write_status{Status::kOk}, fall_status{Status::kTimeout};
  Mailbox<JointCommand> command;
  Mailbox<Measured> measured;
  RobotState last;  // the loop's side
  std::int64_t reads_asked = 0;

  static void run(const std::shared_ptr<Shared>& shared) {
    Shared& s = *shared;
    std::int64_t answered_reads = 0;
    JointCommand command;
    Measured measured;
    for (;;) {
      s.work.wait();
      // Before the end too: who asks a device to fall safely and closes it means both.
      if (s.fall_wanted.exchange(false)) {
        s.fall_status.store(s.inner->fall_safe());
        s.fallen.post();
      }
      if (s.quit.load()) break;
      if (s.command.take(command)) s.write_status.store(s.inner->write(command));
      const std::int64_t wanted = s.reads_wanted.load();
      if (wanted == answered_reads) continue;
      answered_reads = wanted;
      measured.status = s.inner->read(measured.state, s.read_timeout);
      measured.request = wanted;
      s.measured.put(measured);
      s.answered.post();
    }
    s.inner->close();
    s.ended.post();
  }
};

ThreadedAdaptor::ThreadedAdaptor(RobotAdaptor& inner) : shared_(std::make_shared<Shared>()) {
  shared_->inner = &inner;
}

ThreadedAdaptor::~ThreadedAdaptor() { close(); }

Status ThreadedAdaptor::open(const Model& model, const AdaptorConfig& config) {
  const Status status = shared_->inner->open(model, config);
  if (status != Status::kOk) return status;
  shared_->read_timeout = model.device_timeout;
  shared_->last.joint_count = static_cast<std::int16_t>(model.bus_count());
  shared_->thread = std::thread(&Shared::run, shared_);
  return Status::kOk;
}

Status ThreadedAdaptor::read(RobotState& state, double timeout_s) {
  if (!shared_->thread.joinable()) return Status::kNotOpen;
  shared_->reads_wanted.store(++shared_->reads_asked);
  shared_->work.post();
  const timespec due = after(timeout_s);
  Measured measured;
  for (;;) {
    if (shared_->measured.take(measured) && measured.request == shared_->reads_asked) {
      if (measured.status == Status::kOk) state = measured.state;
      return measured.status;
    }
    if (!shared_->answered.wait_until(due)) return Status::kTimeout;
  }
}

Status ThreadedAdaptor::write(const JointCommand& command) {
  if (!shared_->thread.joinable()) return Status::kNotOpen;
  shared_->command.put(command);
  shared_->work.post();
  return shared_->write_status.load();
}

Status ThreadedAdaptor::fall_safe() {
  if (!shared_->thread.joinable()) return Status::kNotOpen;
  shared_->fall_wanted.store(true);
  shared_->work.post();
  return shared_->fallen.wait_until(after(kFallSafeWaits)) ? shared_->fall_status.load()
                                                           : Status::kTimeout;
}

void ThreadedAdaptor::close() {
  if (!shared_->thread.joinable()) return;
  shared_->quit.store(true);
  shared_->work.post();
  if (shared_->ended.wait_until(after(kCloseWaits))) {
    shared_->thread.join();
  } else {
    hung_ = true;
    shared_->thread.detach();
  }
}

bool ThreadedAdaptor::is_hardware() const { return shared_->inner->is_hardware(); }

}  // namespace twinbus::bridge
