// `./twinbus attach` and `release`: tell planner and guard what a hand holds.

#include "launcher/commands/commands.h"

#include <array>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "launcher/bus/bus_link.h"
#include "launcher/operate/asked_hand.h"
#include "launcher/stack/asked_robot.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/messages.h"
#include "robot/collision/obstacle_collector.h"
#include "robot/description/model.h"
#include "robot/description/load.h"
#include "robot/description/named_hands.h"

namespace twinbus::inline launcher {

namespace {

constexpr int kRepeats = 5;                    // of a change, at once
constexpr double kApart = 0.05, kAgain = 1.0;  // [s]

struct HeldShape {
  ObstacleShape shape;
  std::vector<const char*> sizes;  // [m]
};
const std::map<std::string, HeldShape> kShapes = {{"box", {ObstacleShape::kBox, {"LX", "LY", "LZ"}}},
                                                  {"sphere", {ObstacleShape::kSphere, {"RADIUS"}}},
                                                  {"cylinder", {ObstacleShape::kCylinder, {"RADIUS", "LENGTH"}}}};

ObstaclesPiece nothing(std::int16_t hand) {
  ObstaclesPiece piece;
  piece.scene_id = random_id();
  piece.piece = hand;
  piece.pieces = held_pieces(hand);
  piece.attitude.fill({1.0F, 0.0F, 0.0F, 0.0F});
  return piece;
}

void put_shape(const Arguments& arguments, ObstaclesPiece& piece) {
  const std::string shape = arguments.word(1);
  const auto found = kShapes.find(shape);
  if (found == kShapes.end()) throw UsageError("attach: box LX LY LZ, sphere RADIUS or cylinder RADIUS LENGTH, not '" + shape + "'");
  const std::vector<const char*>& sizes = found->second.sizes;
  const std::size_t words = arguments.words().size(), place = 2 + sizes.size();
  if (words != place && words != place + 3) {
    std::string all = "attach: " + shape;
    for (const char* size : sizes) all += std::string(" ") + size;
    throw UsageError(all + ", and X Y Z of its middle in the hand's frame where that is not its origin");
  }
  piece.count = 1;
  piece.shape[0] = found->second.shape;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    piece.size[0][k] = static_cast<float>(arguments.word_number(2 + k, sizes[k], 0.001, 3.0));
  static constexpr std::array<const char*, 3> kAxis{"X", "Y", "Z"};
  for (std::size_t k = 0; words > place && k < 3; ++k)
    piece.position[0][k] = static_cast<float>(arguments.word_number(place + k, kAxis[k], -3.0, 3.0));
}

// Says what a hand holds, and hears what others say of that hand.
class Teller {
 public:
  Teller(const Model& model, const BusOptions& options, std::int16_t hand) : model_(model), bus_(options), hand_(hand) {
    bus_.listen<&Teller::hear_state>(channel::kState, *this);
    bus_.listen<&Teller::hear_held>(channel::kHeld, *this);
  }

  // Until a robot is heard.  Throws std::runtime_error when there is none, or it is another.
  void find_robot() {
    const std::int64_t begin = monotonic_ns();
    while (!robot_ && !quit_requested() && seconds_since(begin) < kFirstState) listen(kApart);
    if (!robot_ && other_robot_)
      throw std::runtime_error("the robot on the bus is not " + model_.name + "; give its folder with --robot");
    if (!robot_) throw std::runtime_error("no robot is heard; start one with ./twinbus up");
  }
  void listen(double seconds) {
    for (const std::int64_t begin = monotonic_ns(); !quit_requested() && seconds_since(begin) < seconds;) {
      if (bus_.receive(kApart) < 0) throw std::runtime_error("the bus is gone");
    }
  }
  void say(ObstaclesPiece& piece) {
    piece.utime = wall_us();
    own_ = piece.scene_id;
    if (!bus_.send(channel::kHeld, piece)) throw std::runtime_error("cannot send on HELD; try ./twinbus doctor");
  }
  void say_often(ObstaclesPiece& piece) {
    for (int i = 0; i < kRepeats; ++i) {
      say(piece);
      listen(kApart);
    }
  }

  void forget_others() { others_ = false; }
  bool others() const { return others_; }           // another program speaks of this hand
  bool holds() const { return others_ && holds_; }  // and says that it holds something

 private:
  void hear_state(const RobotState& state) {
    const bool ours = state.model_hash == model_.hash && state.joint_count == model_.bus_count();
    (ours ? robot_ : other_robot_) = true;
  }
  void hear_held(const ObstaclesPiece& piece) {
    if (piece.piece != hand_ || piece.scene_id == own_) return;
    others_ = true;
    holds_ = piece.count > 0;
  }

  const Model& model_;
  Bus bus_;
  std::int16_t hand_;
  std::int64_t own_ = 0;
  bool robot_ = false, other_robot_ = false, others_ = false, holds_ = false;
};

}  // namespace

int attach_command(const std::vector<std::string>& words) {
  const Arguments arguments({"attach", 3, 8, R"(left|right|ARM box LX LY LZ|sphere RADIUS|cylinder RADIUS LENGTH [X Y Z]
Tells planner and guard that a hand holds this: it moves with the hand and is kept clear of the robot and of obstacles, but not \
of that hand. ARM: of a robot with other arms the name of one (robot.yaml, hands). \
Sizes [m]; X Y Z: its middle in the hand's frame. Until Ctrl-C or ./twinbus release, then the hand is empty.
  --for S  so many seconds instead
  --robot R  default the robot of the running ./twinbus up, else hrp1s
  --prefix --url --allow)"}, words);
  catch_quit_signals();
  const Model model = load_robot(asked_robot(arguments));
  const Hand& arm = asked_hand("attach", model, arguments.word(0));
  const auto hand = static_cast<std::int16_t>(number_of(model, arm));
  const std::string name = spoken_name(model, arm);
  const char* called = name.c_str();
  ObstaclesPiece piece = nothing(hand);
  put_shape(arguments, piece);
  const double seconds = arguments.number("--for", 1e9, 0.1, 1e9);
  Teller teller(model, bus_options(arguments), hand);
  teller.find_robot();
  teller.listen(1.2 * kAgain);
  if (teller.holds()) {
    throw std::runtime_error(name + " holds something already, as another program says: ./twinbus release " +
                             arm.name + ", then ask again");
  }
  teller.forget_others();
  teller.say_often(piece);
  print_typed(stdout, "%s holds a %s; Ctrl-C or ./twinbus release %s lets it go\n", called, arguments.word(1).c_str(), arm.name.c_str());
  std::fflush(stdout);
  const std::int64_t begin = monotonic_ns();
  for (std::int64_t said = begin; !quit_requested() && !teller.others() && seconds_since(begin) < seconds;) {
    teller.listen(kApart);
    if (seconds_since(said) < kAgain || teller.others()) continue;
    said = monotonic_ns();
    teller.say(piece);
  }
  if (teller.holds()) throw std::runtime_error("another program says what " + name + " holds now");
  if (!teller.others()) {
    ObstaclesPiece empty = nothing(hand);
    for (int i = 0; i < kRepeats; ++i) teller.say(empty);
  }
  print_typed(stdout, "%s is empty\n", called);
  return 0;
}

int release_command(const std::vector<std::string>& words) {
  const Arguments arguments({"release", 1, 1, R"(left|right|ARM
Tells planner and guard that the hand is empty, whoever told them what it holds.
  --robot R  default the robot of the running ./twinbus up, else hrp1s
  --prefix --url --allow)"}, words);
  catch_quit_signals();
  const Model model = load_robot(asked_robot(arguments));
  const Hand& arm = asked_hand("release", model, arguments.word(0));
  const auto hand = static_cast<std::int16_t>(number_of(model, arm));
  Teller teller(model, bus_options(arguments), hand);
  teller.find_robot();
  ObstaclesPiece empty = nothing(hand);
  teller.say_often(empty);
  teller.forget_others();
  teller.listen(1.2 * kAgain);
  if (teller.holds())
    throw std::runtime_error("another program goes on saying that the hand holds something: end it, or let its scene let go");
  print_typed(stdout, "%s is empty\n", spoken_name(model, arm).c_str());
  return 0;
}

}  // namespace twinbus::launcher
