#include "launcher/motion/motion_play.h"

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/process/command_word.h"
#include "common/process/process.h"
#include "launcher/operate/operate.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kLead = 1.0;   // that a frame is said before it can be played [s]
constexpr double kAgain = 0.1;  // after which a piece is said once more, in case one is lost [s]
constexpr double kBegins =
    15.0;  // a walk is brought to rest, and the robot gone to the first frame, by then [s]
constexpr double kSlowest = 60.0;  // beyond the motion's own time, with stops by a guard [s]
constexpr double kThereAndBack = 2.0;  // to the first frame and back, at least [s]
constexpr double kSilence = 1.0;   // of the robot, after which it is gone [s]

// What the controller said of it, if it was why it did not play to its end.
std::string complaint(BusLink& bus) {
  std::string last;
  for (const std::string& event : bus.seen().take_events()) {
    const bool said =
        event.starts_with("controller: ") && event.find("it stops first") == std::string::npos;
    if (said) last = event.substr(event.find(' ') + 1);
  }
  return last;
}

class Player {
 public:
  Player(BusLink& bus, std::vector<MotionPiece> pieces, double period)
      : bus_(bus), pieces_(std::move(pieces)), period_(period) {}

  // time: since the begin, of the robot's clock [s].
  void say(double time, std::int64_t run_id) {
    for (; next_ < pieces_.size() && due(next_) <= time; ++next_) send(pieces_[next_], run_id);
    for (; again_ < next_ && due(again_) + kAgain <= time; ++again_) send(pieces_[again_], run_id);
  }

 private:
  double due(std::size_t piece) const { return pieces_[piece].first * period_ - kLead; }
  void send(MotionPiece& piece, std::int64_t run_id) {
    piece.run_id = run_id;
    piece.sequence = 0;  // each its own
    bus_.send(piece);
  }

  BusLink& bus_;
  std::vector<MotionPiece> pieces_;
  double period_;
  std::size_t next_ = 0, again_ = 0;
};

}  // namespace

int play_motion(BusLink& bus, const Model& model, const MotionClip& clip) {
  (void)active_source(bus);
  refuse_while_paused(bus.seen(), monotonic_ns());
  refuse_in_replay(bus.seen(), monotonic_ns());
  bus.listen(0.1);
  if (bus.seen().controller_statuses().received() == 0)
    throw std::runtime_error("no controller is running");
  if (bus.seen().newest_state().model_hash != model.hash)
    throw std::runtime_error("the robot that runs is not " + model.name + ": say --robot");
  (void)bus.seen().take_events();
  Player player(bus, clip.pieces(random_id()), clip.period());
  const std::int64_t begin_ns = bus.seen().newest_state().time_ns, begin = monotonic_ns();
  std::int64_t heard_ns = begin_ns, heard = begin;
  bool plays = false;
  double begun = 0.0;  // of the robot's clock [s]
  while (!quit_requested()) {
    const RobotState& state = bus.seen().newest_state();
    if (state.time_ns != heard_ns) {
      heard_ns = state.time_ns;
      heard = monotonic_ns();
    }
    if (seconds_since(heard) > kSilence && !is_paused(bus.seen(), monotonic_ns()))
      throw std::runtime_error("the robot is not heard any more (./twinbus status)");
    const double time = 1e-9 * static_cast<double>(state.time_ns - begin_ns);
    player.say(time, state.run_id);
    bus.listen(0.02);
    const bool now = bus.seen().controller().motion == Motion::kPlayed;
    if (now && !plays) {
      begun = time;
      print_typed(stdout, "motion: the robot plays it, %.1f s (./twinbus mode balance ends it)\n",
                  clip.duration());
      std::fflush(stdout);
    }
    if (plays && !now) {
      const std::string why = complaint(bus);
      if (why.empty() && time - begun > clip.duration() + kThereAndBack) {
        print_typed(stdout, "motion: done; the robot stands as before\n");
        return 0;
      }
      print_typed(stderr, "motion: ended after %.1f s: %s\n", time,
                  why.empty() ? "something else was asked" : why.c_str());
      return 1;
    }
    plays = plays || now;
    if (!plays && time > 0.5) {
      if (const std::string why = complaint(bus); !why.empty()) {
        print_typed(stderr, "motion: %s\n", why.c_str());
        return 1;
      }
    }
    if (!plays && time > kBegins)
      throw std::runtime_error("the controller does not begin it (./twinbus status)");
    if (time > kBegins + clip.duration() + kSlowest)
      throw std::runtime_error("it does not come to its end; ./twinbus mode balance ends it");
  }
  ModeRequest stand;
  stand.mode = Mode::kBalance;
  (void)ask_controller(bus, stand);
  print_typed(stdout, "motion: interrupted; the robot goes back to where it stood\n");
  return 1;
}

}  // namespace twinbus::launcher
