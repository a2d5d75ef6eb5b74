// Follows a planned arm motion: collects the numbered pieces of an ARM_PATH and starts only when
// every piece is there and the motion begins where the arm is.
//
// Between knots the way is a cubic Hermite in the planner's time; our own clock along it runs at a
// rate 0..1, so that a guard, a stop or a cancel slows the arm down on its path instead of off it.

#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "control/joint/posture.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/obeyed_once.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

enum class ArmState : std::int8_t { kNone = 0, kFollowing = 1, kDone = 2, kStoppedByGuard = 3 };

class ArmFollow {
 public:
  static constexpr int kMaxPieces = 64;

  explicit ArmFollow(const Model& model);

  // A piece that makes no sense (sizes, joints, times, limits) spoils its path, which then never
  // starts.
  void add(const ArmPathPiece& piece) noexcept;
  // A path that came when none could be followed, for this reason: it is not followed later either.
  void refuse(const ArmPathPiece& piece, const char* why) noexcept;
  // Ends on the path, as soon as it can be stopped smoothly.
  void cancel() noexcept;
  // At once: the joints are someone else's from now on.
  void drop() noexcept;

  // Moves the joints of the path in `posture`.  masked: bit per bus joint that the guard holds.
  void update(Posture& posture, std::int64_t masked, double dt) noexcept;

  ArmState state() const noexcept { return state_; }
  std::int64_t path_id() const noexcept { return following_ ? active_.path_id : 0; }
  bool moving() const noexcept { return following_ && rate_ > 0.0; }
  // Along the path that is followed: the planner's time [s], and how fast our own runs along it.
  double time() const noexcept { return time_; }
  double rate() const noexcept { return rate_; }
  // Puts the joints of the path that is followed where it is at `time`.
  void place(double time, double rate, Posture& posture) const noexcept;
  // A whole path has come and begins at the next update.
  bool begins() const noexcept { return waiting_ && !following_; }
  // Why a path was not followed, once, or null.
  const char* take_refusal() noexcept { return std::exchange(refusal_, nullptr); }

 private:
  struct Path {
    std::int64_t path_id = 0;
    std::int64_t goal_id = 0;
    int pieces = 0, joint_count = 0, knot_count = 0;
    std::uint64_t have = 0;  // bit per piece
    bool spoilt = false;
    std::array<std::int16_t, kArmJoints> joint{};  // model index
    std::array<int, kArmJoints> bus_joint{};
    std::array<std::int16_t, kMaxPieces> knots_of{};
    std::vector<double> time;  // [kMaxPieces x kKnotsPerPiece]
    std::vector<std::array<double, kArmJoints>> q, qd;
    bool complete() const noexcept {
      return pieces > 0 && have == (pieces == 64 ? ~0ULL : (1ULL << pieces) - 1);
    }
  };
  void begin(Path& path, const ArmPathPiece& piece) noexcept;
  bool finish(Path& path) noexcept;  // packs the knots; false if they make no path
  void sample(int segment, double time, double rate, Posture& posture) const noexcept;

  const Model* model_;
  std::vector<int> bus_of_;  // model joint -> bus joint, -1
  std::vector<bool> allowed_;
  Path active_, incoming_;
  SpentNumbers<256> spent_;  // of paths that came whole, or were cancelled: each is followed once
  bool following_ = false, ending_ = false, waiting_ = false;
  double time_ = 0.0, rate_ = 0.0, clear_for_ = 0.0;
  int blocked_ = 0, segment_ = 0;
  ArmState state_ = ArmState::kNone;
  const char* refusal_ = nullptr;
};

}  // namespace twinbus::control
