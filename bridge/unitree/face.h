// A robot's face: what a Unitree robot would say and do, made of STATE and COMMAND, without DDS, bus or clock.
//
// To programs it is the robot: STATE becomes LowState, LowCmd becomes COMMAND.  To the source below it is a controller like any
// other: gate, limits, stops and switches are the source's.  Until a program commands, the face holds the posture that it found;
// each program is a controller_id of its own, so the gate fades it in.  As a motor does, the face obeys a LowCmd until the next; after
// FaceOptions::patience no COMMAND goes out, and the source does what it does when any controller falls silent.
//
//   face.on_state(state, now);                 // whenever STATE comes
//   if (face.reading_due()) publish(face.reading(now));
//   face.on_frame(bytes, writer, stamp, arrival, now);   // whenever LowCmd comes
//   while (face.take_request(request, now)) ... ;  if (face.take_command(command, now)) ...

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "bridge/unitree/face_notes.h"
#include "bridge/unitree/low_frames.h"
#include "bridge/unitree/motor_table.h"
#include "bridge/unitree/sample_age.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"

namespace twinbus::inline bridge {

struct FaceOptions {
  UnitreeFamily family = UnitreeFamily::kHg;
  int mode_machine = -1;   // -1: that of the table
  bool fade = true;        // a program's first commands are faded in
  double rate = 500.0;     // LowStates per second, of a robot 500; a multiple of the period apart
  double patience = 0.1;   // a LowCmd goes on as long when the next is late; the command timeout at least [s]
  bool ab_as_series = false;  // mode_pr 1 is obeyed: motor A moves roll, motor B pitch, as if there were no linkage
  float volts = 0.0F;      // that are reported, since STATE has none; 0: not known
  float celsius = 0.0F;    // the same
  std::int64_t first_id = 1;  // of the controller ids that are used, counting up
};

class Face {
 public:
  // The model must outlive the face.  Throws std::runtime_error when its joints are not those of a robot of the family.
  Face(const Model& model, const FaceOptions& options);

  const MotorOrder& order() const noexcept { return order_; }
  int mode_machine() const noexcept { return mode_machine_; }
  double rate() const noexcept;  // LowStates per second

  // An admitted STATE (StateAdmission); others of another model are counted and left out.
  void on_state(const RobotState& state, std::int64_t now_ns) noexcept;
  void on_gamepad(const Gamepad& pad, std::int64_t now_ns) noexcept;
  void on_source(const SourceStatus& status) noexcept;
  // Of anybody, ourselves included: who else drives.
  void on_command(std::int64_t controller_id, std::int64_t now_ns) noexcept;

  // A LowCmd.  writer: who sent it, as DDS tells writers apart; stamp_ns: by his clock, arrival_ns: by ours, same unit.
  void on_frame(std::span<const std::byte> frame, std::uint64_t writer, std::int64_t stamp_ns, std::int64_t arrival_ns,
                std::int64_t now_ns) noexcept;

  // True once per LowState that is due.
  bool reading_due() noexcept;
  LowReading reading(std::int64_t now_ns) const noexcept;

  bool take_request(ControllerRequest& request, std::int64_t now_ns) noexcept;
  bool take_command(JointCommand& command, std::int64_t now_ns) noexcept;
  bool take_line(FaceLine& line) noexcept { return notes_.take(line); }

  std::int64_t frames_taken() const noexcept { return taken_; }
  std::int64_t frames_refused() const noexcept { return refused_; }
  const FaceNotes& notes() const noexcept { return notes_; }

 private:
  enum class Phase : std::int8_t { kHolding, kObeying, kSilent };

  bool frame_is_good(const LowCommand& command, const FrameVerdict& verdict, std::int64_t now_ns) noexcept;
  bool writer_is_bound(std::uint64_t writer, std::int64_t now_ns) noexcept;
  void count_rate(std::int64_t now_ns) noexcept;
  void start_holding() noexcept;
  std::int64_t id() const noexcept;
  bool other_drives(std::int64_t now_ns) const noexcept;
  void hold(JointCommand& command) const noexcept;
  void obey(JointCommand& command) const noexcept;
  const char* motor_name(int motor) const noexcept;

  const Model& model_;
  FaceOptions options_;
  MotorOrder order_;
  std::array<int, 4> foot_{1, 0, -1, -1};  // row of STATE of each foot of the frame: front right, front left, rear right, rear left
  int mode_machine_;
  std::int64_t every_;          // STATEs per LowState
  std::int64_t repeat_ticks_;   // after which a LowCmd goes out again
  std::int64_t late_ticks_;     // after which it is told that none came
  std::int64_t silence_ticks_;  // after which it does not

  Phase phase_ = Phase::kHolding;
  RobotState state_;
  bool heard_ = false, answered_ = true, again_ = false, due_ = false;
  std::int64_t states_ = 0;
  PerJoint<double> posture_{};  // that is held

  LowCommand wish_;
  bool pending_ = false;        // wish_ has not gone out
  std::uint64_t writer_ = 0;    // that is obeyed; 0 none
  SampleAge age_;
  std::int64_t accepted_ns_ = 0, accepted_tick_ = 0, sent_tick_ = 0, programs_ = 0;
  std::int64_t window_ns_ = 0, in_window_ = 0, taken_ = 0, refused_ = 0;

  std::int64_t bound_ = 0;      // the controller that the source obeys; 0 none or not known
  std::int64_t other_id_ = 0, other_ns_ = 0, asked_ns_ = 0;
  JointCommand answer_;
  Gamepad pad_;
  std::int64_t pad_ns_ = 0;
  FaceNotes notes_;
};

}  // namespace twinbus::bridge
