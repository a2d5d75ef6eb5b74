// Plays a motion that comes in pieces on MOTION: keeps its frames, and runs a clock of its own along them.
//
// The clock runs at a rate 0..1: it starts and ends smoothly, waits for frames that have not come, and slows the robot down on
// the motion's own path when a guard holds a joint of it or when it is to end.  What the legs are asked is a way of the
// centre of mass and a lean of the base, for balance; without balance they are not asked.

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "control/joint/min_jerk.h"
#include "control/joint/posture.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/obeyed_once.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

class MotionFollow {
 public:
  // kWaits: a motion has been asked and its first frames are there.  kLooks, kLooksBack: whether the way to its first frame,
  // and from its last to where the robot stood, is free.
  enum class Stage : std::int8_t {
    kNone,
    kComes,
    kWaits,
    kLooks,
    kApproaches,
    kPlays,
    kLooksBack,
    kReturns
  };
  // What balance is asked besides standing, in its ground frame.
  struct Body {
    Eigen::Vector3d com = Eigen::Vector3d::Zero(), com_velocity = com,
                    com_acceleration = com;                            // from home [m]
    Eigen::Vector2d tilt = Eigen::Vector2d::Zero(), tilt_rate = tilt;  // roll and pitch [rad]
  };

  // Allocates everything.
  explicit MotionFollow(const Model& model);

  // A piece that makes no sense (joints, limits, speeds) spoils its motion, which then is not played, or is ended.
  void add(const MotionPiece& piece) noexcept;
  // The motion that waits is not played, now or later.
  void refuse() noexcept;
  // From standing: the joints of the mask are at `first` and the motion begins within `duration` [s].
  void approach(double duration) noexcept;
  void play() noexcept { stage_ = Stage::kPlays; }
  void set_stage(Stage stage) noexcept { stage_ = stage; }
  // Ends on its path, as soon as it can be stopped smoothly.
  void cancel() noexcept { ending_ = true; }
  // At once: the joints are someone else's from now on.
  void drop() noexcept;
  void forget() noexcept;

  // Moves the joints of the motion in `posture`; in stage kApproaches and kPlays.  masked: bit per bus joint that the guard holds.
  void update(Posture& posture, std::int64_t masked, double dt) noexcept;

  Stage stage() const noexcept { return stage_; }
  bool active() const noexcept { return stage_ > Stage::kWaits; }
  bool ending() const noexcept { return ending_; }
  bool approached() const noexcept { return !fade_.moving(); }
  bool over() const noexcept { return over_; }  // after kPlays: it came to its end, or was ended
  bool moves_body() const noexcept {
    return stage_ == Stage::kApproaches || stage_ == Stage::kPlays;
  }
  const Body& body() const noexcept { return body_; }
  std::int64_t mask() const noexcept { return mask_; }  // of the joints it moves
  void keep_off(std::int64_t legs) noexcept { mask_ &= ~legs; }
  double depth() const noexcept { return depth_; }  // of the centre of mass below standing [m]
  // Joints of the mask at the first frame, bus order.
  const PerJoint<double>& first() const noexcept { return first_; }
  // What people should be told, or null; a string that lives for ever.
  const char* take_refusal() noexcept;

 private:
  static constexpr int kFrames =
      4096;  // that are kept: 82 s of a motion that comes ahead of its time

  struct Frame {
    int number = -1;
    std::array<float, kMaxJoints> q{};
    std::array<float, 3> com{};
    std::array<float, 2> tilt{};
  };
  Frame& slot(int number) noexcept { return frames_[static_cast<std::size_t>(number % kFrames)]; }
  const Frame& slot(int number) const noexcept {
    return frames_[static_cast<std::size_t>(number % kFrames)];
  }
  void begin(const MotionPiece& piece) noexcept;
  bool fits(const MotionPiece& piece) const noexcept;
  void sample(Posture& posture, double rate, double rate_change) noexcept;

  const Model* model_;
  std::vector<Frame> frames_;
  SpentNumbers<64> spent_;  // motions that were played or refused: each is played once
  std::int64_t id_ = 0, mask_ = 0;
  Stage stage_ = Stage::kNone;
  int count_ = 0, have_ = 0;  // frames of the motion; of them without a gap from the first
  double period_ = 0.02, depth_ = 0.0;
  double time_ = 0.0, rate_ = 0.0, clear_for_ = 0.0, starved_for_ = 0.0, held_for_ = 0.0;
  bool ending_ = false, over_ = false;
  PerJoint<double> first_{};
  MinJerk fade_;  // of the body's way and lean, 0 -> 1 while approaching
  Body body_;
  const char* refusal_ = nullptr;
};

}  // namespace twinbus::control
