// Runs another adaptor in a thread of its own, so that a device that hangs cannot hang the loop.
//
// read() asks the thread for one device cycle and waits for its timeout at most; write() leaves the
// newest command in a mailbox.  A device that does not answer gives kTimeout, tick after tick,
// until the source stops.

#pragma once

#include <memory>

#include "bridge/adaptor/adaptor.h"

namespace twinbus::inline bridge {

class ThreadedAdaptor final : public RobotAdaptor {
 public:
  // inner must outlive this, or be abandoned when hung() after close().
  explicit ThreadedAdaptor(RobotAdaptor& inner);
  ~ThreadedAdaptor() override;

  // May take as long as the device's own open().
  Status open(const Model& model, const AdaptorConfig& config) override;
  // Real-time safe: blocks for timeout_s at most.
  Status read(RobotState& state, double timeout_s) override;
  Status write(const JointCommand& command) override;  // result of the device's last write
  Status fall_safe() override;                         // blocks for a millisecond at most
  void close() override;                               // gives a hanging device half a second
  bool is_hardware() const override;

  // After close(): the device still hangs in its thread.
  bool hung() const noexcept { return hung_; }

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  bool hung_ = false;
};

}  // namespace twinbus::bridge
