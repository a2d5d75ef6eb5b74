#include "bridge/unitree/face.h"

#include <algorithm>
#include <cmath>

#include "bridge/unitree/remote.h"
#include "common/math/index.h"
#include "robot/estimation/point_legs.h"

namespace twinbus::inline bridge {

namespace {

constexpr double kFramePeriod = 0.002;                  // of the robots [s]
constexpr std::int64_t kMs = 1'000'000;                 // [ns]
constexpr std::int64_t kWriterLeaves = 1000 * kMs;      // of silence, after which another may command
constexpr std::int64_t kOtherDrives = 200 * kMs;        // since another controller's last command
constexpr std::int64_t kAskAgain = 20 * kMs;            // to be obeyed
constexpr std::int64_t kPadFresh = 250 * kMs;
constexpr std::int64_t kRateWindow = 500 * kMs;
constexpr std::int64_t kListenFirst = 3;  // STATEs, whether somebody answers them
constexpr double kRepeat = 0.75;  // of the command timeout, after which a LowCmd goes out again
constexpr double kLate = 1.5;     // of the command timeout: a loop that missed more than a turn
constexpr double kTooFast = 1.5;  // of the robot's own rate

std::int64_t ticks_of(double seconds, const Model& model) {
  return std::max<std::int64_t>(1, std::llround(seconds / model.period()));
}

}  // namespace

Face::Face(const Model& model, const FaceOptions& options)
    : model_(model),
      options_(options),
      order_(motor_order(model, options.family)),
      mode_machine_(options.mode_machine >= 0 ? options.mode_machine : order_.mode_machine),
      every_(ticks_of(std::max(kFramePeriod, 1.0 / options.rate), model)),
      repeat_ticks_(ticks_of(kRepeat * model.command_timeout, model)),
      late_ticks_(ticks_of(kLate * model.command_timeout, model)),
      silence_ticks_(ticks_of(std::max(options.patience, model.command_timeout), model)) {
  if (!stands_on_points(model)) return;
  const std::optional<PointLegs> legs = point_legs(model, StandingFeet(model));
  if (legs && legs->size() == 4)
    foot_ = {(*legs)[1].foot, (*legs)[0].foot, (*legs)[3].foot, (*legs)[2].foot};
}

double Face::rate() const noexcept { return 1.0 / (model_.period() * static_cast<double>(every_)); }

std::int64_t Face::id() const noexcept { return options_.first_id + (phase_ == Phase::kHolding ? 0 : programs_); }

const char* Face::motor_name(int motor) const noexcept {
  const int bus = motor >= 0 && motor < kHgMotors ? order_.bus_index[at(motor)] : -1;
  return bus < 0 ? "no joint here" : model_.joints[at(model_.bus_joints[at(bus)])].name.c_str();
}

void Face::start_holding() noexcept {
  phase_ = Phase::kHolding;
  posture_ = state_.q;
  pending_ = false;
  writer_ = 0;
}

void Face::on_state(const RobotState& state, std::int64_t now_ns) noexcept {
  if (state.joint_count != model_.bus_count() || state.model_hash != model_.hash) {
    ++refused_;
    return;
  }
  if (heard_ && state.run_id == state_.run_id && state.term == state_.term && state.tick == state_.tick) {
    again_ = answered_;  // lock-step: the same answer once more
    return;
  }
  const StopKind before = state_.stop_kind;
  bool first = !heard_;
  if (state.run_id != state_.run_id || state.term != state_.term) {
    bound_ = 0;
    // A robot that takes over goes on counting, and what was last sent named the one before.  One that begins anew is met as the first is.
    const bool goes_on = std::abs(state.tick - accepted_tick_) <= silence_ticks_;
    pending_ = phase_ == Phase::kObeying && goes_on;
    first = first || (phase_ != Phase::kHolding && !goes_on && state.tick < accepted_tick_);
  }
  state_ = state;
  heard_ = true;
  answered_ = again_ = false;
  due_ = states_++ % every_ == 0;
  if (first) start_holding();
  if (before == StopKind::kNone && state.stop_kind != StopKind::kNone && phase_ != Phase::kHolding) {
    notes_.add(FaceNote::kStopped, 1, now_ns, "the robot is stopped: LowCmd is not obeyed until ./twinbus clear");
  }
  const bool silent = phase_ != Phase::kHolding && state.tick - accepted_tick_ > silence_ticks_;
  if (before != StopKind::kNone && state.stop_kind == StopKind::kNone && silent) start_holding();
  if (phase_ == Phase::kObeying && silent) {
    phase_ = Phase::kSilent;
    pending_ = false;
    notes_.add(FaceNote::kSilent, 1, now_ns,
               "no good LowCmd for %.0f ms: the robot is held by its own stop; start the program again, then ./twinbus clear",
               1e3 * model_.period() * static_cast<double>(silence_ticks_));
  }
}

void Face::on_gamepad(const Gamepad& pad, std::int64_t now_ns) noexcept {
  pad_ = pad;
  pad_ns_ = now_ns;
}

void Face::on_source(const SourceStatus& status) noexcept {
  if (heard_ && status.run_id == state_.run_id && status.term == state_.term) bound_ = status.controller_id;
}

void Face::on_command(std::int64_t controller_id, std::int64_t now_ns) noexcept {
  if (controller_id >= options_.first_id && controller_id <= options_.first_id + programs_) return;
  other_id_ = controller_id;
  other_ns_ = now_ns;
}

bool Face::other_drives(std::int64_t now_ns) const noexcept {
  return other_ns_ != 0 && now_ns - other_ns_ < kOtherDrives && (bound_ == 0 || bound_ == other_id_);
}

// Tells what is wrong with it, once.
bool Face::frame_is_good(const LowCommand& command, const FrameVerdict& verdict, std::int64_t now_ns) noexcept {
  switch (verdict.fault) {
    case FrameFault::kNone:
      break;
    case FrameFault::kSize:
      notes_.add(FaceNote::kSize, 1, now_ns, "LowCmd refused: its size is not that of %s; use the types of this robot",
                 family_name(options_.family));
      return false;
    case FrameFault::kCrc:
      notes_.add(FaceNote::kCrc, 1, now_ns,
                 "LowCmd refused: wrong CRC; compute it last, over the frame that is written (SDK: cmd.crc = CRC().Crc(cmd))");
      return false;
    case FrameFault::kNotFinite:
      notes_.add(FaceNote::kNotFinite, 1, now_ns,
                 "LowCmd refused whole: motor %d (%s) has a number that is not finite; check the program's q, dq, tau, kp, kd", verdict.motor,
                 motor_name(verdict.motor));
      return false;
    case FrameFault::kGain:
      notes_.add(FaceNote::kGain, 1, now_ns, "LowCmd refused whole: motor %d (%s) has kp or kd below zero; gains are 0 or more",
                 verdict.motor, motor_name(verdict.motor));
      return false;
    case FrameFault::kMotorMode:
      notes_.add(FaceNote::kMotorMode, 1, now_ns, "LowCmd refused whole: motor %d (%s) has mode %d; 1 is on, 0 is off", verdict.motor,
                 motor_name(verdict.motor), verdict.value);
      return false;
    case FrameFault::kLevel:
      notes_.add(FaceNote::kLevel, 1, now_ns, "LowCmd refused: level_flag is 0x%02X; 0xFF is low level",
                 static_cast<unsigned>(verdict.value));
      return false;
  }
  if (options_.family != UnitreeFamily::kHg) return true;
  if (command.mode_pr != 0 && !(command.mode_pr == 1 && options_.ab_as_series)) {
    notes_.add(FaceNote::kModePr, 1, now_ns,
               "LowCmd refused: mode_pr is %d; ankles and waist are pitch and roll here: use mode_pr 0, or start the face with --ab-as-series",
               command.mode_pr);
    return false;
  }
  if (command.mode_machine != mode_machine_) {
    notes_.add(FaceNote::kModeMachine, 1, now_ns,
               "LowCmd refused: mode_machine is %d, the robot's is %d; copy it from LowState (or start the face with --mode-machine %d)",
               command.mode_machine, mode_machine_, command.mode_machine);
    return false;
  }
  return true;
}

// Whoever commands first is obeyed until he has been silent for a while.
bool Face::writer_is_bound(std::uint64_t writer, std::int64_t now_ns) noexcept {
  if (writer_ == writer) return true;
  if (writer_ != 0 && now_ns - accepted_ns_ < kWriterLeaves) {
    notes_.add(FaceNote::kSecondWriter, 1, now_ns,
               "a second program writes rt/lowcmd: refused, the first one is obeyed; end one of the two (a motion service of the robot too)");
    return false;
  }
  writer_ = writer;
  age_ = {};
  ++programs_;
  window_ns_ = 0;
  notes_.add(FaceNote::kProgramBegins, 0, now_ns, "a program commands the robot (its controller_id: %lld)",
             static_cast<long long>(options_.first_id + programs_));
  return true;
}

void Face::count_rate(std::int64_t now_ns) noexcept {
  if (window_ns_ == 0 || now_ns - window_ns_ >= kRateWindow) {
    const auto elapsed = static_cast<double>(std::max<std::int64_t>(1, now_ns - window_ns_));
    const double rate = 1e9 * static_cast<double>(in_window_) / elapsed;
    const double taken = 1.0 / (model_.period() * static_cast<double>(ticks_of(kFramePeriod, model_)));
    if (window_ns_ != 0 && rate > kTooFast * taken) {
      notes_.add(FaceNote::kTooFast, 1, now_ns,
                 "LowCmd comes %.0f times a second, the robot takes %.0f: the newest of each period is obeyed; write once per LowState", rate,
                 taken);
    }
    window_ns_ = now_ns;
    in_window_ = 0;
  }
  ++in_window_;
}

void Face::on_frame(std::span<const std::byte> frame, std::uint64_t writer, std::int64_t stamp_ns, std::int64_t arrival_ns,
                    std::int64_t now_ns) noexcept {
  LowCommand command;
  const FrameVerdict verdict = decode(frame, options_.family, command);
  // Nobody is obeyed before there is a robot.
  if (!frame_is_good(command, verdict, now_ns) || !heard_ || !writer_is_bound(writer, now_ns)) {
    ++refused_;
    return;
  }
  count_rate(now_ns);
  const std::int64_t age = age_.of(stamp_ns, arrival_ns);
  if (1e-9 * static_cast<double>(age) > model_.command_timeout) {
    ++refused_;
    notes_.add(FaceNote::kTooOld, 1, now_ns,
               "LowCmd refused: %.0f ms old, more than the command timeout of %.0f ms; look at network and load of the program's machine",
               1e-6 * static_cast<double>(age), 1e3 * model_.command_timeout);
    return;
  }
  ++taken_;
  if (other_drives(now_ns)) {
    notes_.add(FaceNote::kOtherController, 1, now_ns,
               "LowCmd moves nothing: the source obeys another controller (controller_id %lld); end that one, or use a stack client*",
               static_cast<long long>(bound_));
  }
  const std::int64_t paused = state_.tick - accepted_tick_;
  if (phase_ == Phase::kObeying && paused > late_ticks_ && paused <= silence_ticks_) {
    notes_.add(FaceNote::kPaused, 1, now_ns,
               "no LowCmd for %.0f ms, the last one went on: a robot that balances may fall or hit itself by that; look for what "
               "stands the program still (load, a garbage collection)",
               1e3 * model_.period() * static_cast<double>(paused));
  }
  wish_ = command;
  pending_ = true;
  accepted_ns_ = now_ns;
  accepted_tick_ = state_.tick;
  phase_ = Phase::kObeying;
}

bool Face::reading_due() noexcept {
  const bool due = due_;
  due_ = false;
  return due;
}

LowReading Face::reading(std::int64_t now_ns) const noexcept {
  LowReading reading;
  reading.mode_machine = static_cast<std::uint8_t>(mode_machine_);
  reading.tick = static_cast<std::uint32_t>(static_cast<std::uint64_t>(state_.time_ns / kMs));
  reading.quaternion = state_.attitude;
  reading.gyro = state_.gyro;
  reading.accel = state_.accel;
  for (std::size_t m = 0; m < order_.bus_index.size(); ++m) {
    const int bus = order_.bus_index[m];
    if (bus < 0) continue;
    const std::size_t i = at(bus);
    reading.motor[m] = {.on = (state_.enabled & bit(bus)) != 0,
                        .q = static_cast<float>(state_.q[i]),
                        .dq = state_.qd[i],
                        .tau = state_.tau[i],
                        .celsius = options_.celsius,
                        .volts = options_.volts};
  }
  for (std::size_t foot = 0; foot < foot_.size(); ++foot) {
    if (foot_[foot] < 0 || state_.wrench_kind[at(foot_[foot])] == WrenchKind::kAbsent) continue;
    const auto& w = state_.wrench[at(foot_[foot])];
    reading.foot_force[foot] = std::hypot(w[0], w[1], w[2]);
  }
  if (pad_ns_ != 0 && now_ns - pad_ns_ < kPadFresh) reading.remote = remote_of(pad_);
  reading.volts = options_.volts;
  return reading;
}

bool Face::take_request(ControllerRequest& request, std::int64_t now_ns) noexcept {
  if (!heard_ || bound_ == 0 || bound_ == id() || other_drives(now_ns) || phase_ == Phase::kSilent) return false;
  if (asked_ns_ != 0 && now_ns - asked_ns_ < kAskAgain) return false;
  asked_ns_ = now_ns;
  request.run_id = state_.run_id;
  request.controller_id = id();
  return true;
}

void Face::hold(JointCommand& command) const noexcept {
  for (int j = 0; j < model_.bus_count(); ++j) {
    const Joint& joint = model_.joints[at(model_.bus_joints[at(j)])];
    command.q[at(j)] = posture_[at(j)];
    command.kp[at(j)] = static_cast<float>(joint.kp);
    command.kd[at(j)] = static_cast<float>(joint.kd);
  }
}

// What a gain of zero makes meaningless (the SDK writes 2.1e9 there) becomes what is measured.
void Face::obey(JointCommand& command) const noexcept {
  if (!options_.fade) command.flags = kCommandNoFade;
  for (std::size_t m = 0; m < order_.bus_index.size(); ++m) {
    const int bus = order_.bus_index[m];
    if (bus < 0) continue;
    const MotorWish& wish = wish_.motor[m];
    const std::size_t i = at(bus);
    command.q[i] = wish.on && wish.kp > 0.0F ? static_cast<double>(wish.q) : state_.q[i];
    command.qd[i] = wish.on && wish.kd > 0.0F ? wish.dq : 0.0F;
    command.tau[i] = wish.tau;
    command.kp[i] = wish.kp;
    command.kd[i] = wish.kd;
  }
}

bool Face::take_command(JointCommand& command, std::int64_t now_ns) noexcept {
  if (again_) {
    again_ = false;
    command = answer_;
    return true;
  }
  if (!heard_ || answered_ || other_drives(now_ns)) return false;
  const bool again = phase_ == Phase::kObeying && state_.tick - sent_tick_ >= repeat_ticks_;
  if (phase_ == Phase::kHolding ? states_ <= kListenFirst : !pending_ && !again) return false;
  command = {};
  command.tick = state_.tick;
  command.run_id = state_.run_id;
  command.model_hash = model_.hash;
  command.controller_id = id();
  command.term = state_.term;
  command.joint_count = static_cast<std::int16_t>(model_.bus_count());
  if (phase_ == Phase::kHolding) {
    hold(command);
  } else {
    obey(command);
    pending_ = false;
    sent_tick_ = state_.tick;
  }
  answered_ = true;
  answer_ = command;
  return true;
}

}  // namespace twinbus::bridge
