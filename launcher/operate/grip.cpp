// `./twinbus grip`: opens and closes the fingers of a hand as one.

#include "launcher/commands/commands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/process.h"
#include "common/text/xml.h"
#include "launcher/operate/asked_hand.h"
#include "launcher/operate/operate.h"
#include "launcher/stack/asked_robot.h"
#include "robot/description/model.h"
#include "robot/description/load.h"
#include "robot/description/named_hands.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kBegins = 0.3;     // a controller looks along the way for so long before it moves [s]
constexpr double kStill = 0.5;      // fingers that have not moved for so long have come to rest [s]
constexpr double kMoved = 0.005, kThere = 0.03;  // of the way from closed to open

using Grippers = std::vector<Gripper>;

// Those that are meant; throws when there is none.
Grippers grippers_asked_for(const Arguments& arguments, const Model& model) {
  const std::string side = arguments.text("--side", "");
  const Hand* only = side.empty() ? nullptr : &asked_hand("grip: --side", model, side);
  Grippers meant;
  std::string others;
  for (const Hand* hand : hands_of(model)) {
    const Gripper gripper = gripper_of(model, *hand);
    if (gripper.joints.empty()) continue;
    if (only == nullptr || hand == only) meant.push_back(gripper);
    else others += (others.empty() ? "" : ", ") + hand->name;
  }
  if (meant.empty() && !others.empty()) throw std::runtime_error(model.name + ": " + side + " has no gripper (robot.yaml, grippers); there is one on: " + others);
  if (meant.empty())
    throw std::runtime_error(model.name + " has no " + (side.empty() ? "" : side + " ") + "gripper (robot.yaml, grippers); --robot names another robot");
  return meant;
}

double share_from(const std::string& word) {
  if (word == "open") return 1.0;
  if (word == "close") return 0.0;
  double share = 0.0;
  if (!parse_numbers(word, &share, 1) || !(share >= 0.0 && share <= 1.0))
    throw UsageError("grip: open, close, or a number from 0 (closed) to 1 (open), not '" + word + "'");
  return share;
}

// Where its joints are at a share of its opening: 0 closed, 1 open.
std::vector<double> opened(const Gripper& gripper, double share) {
  std::vector<double> q(gripper.joints.size());
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = gripper.closed[i] + share * (gripper.open[i] - gripper.closed[i]);
  return q;
}

// Where the fingers are, 0 closed, 1 open: the mean of those that open.
double share_of(const Gripper& gripper, const Model& model, const RobotState& state) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < gripper.joints.size(); ++i) {
    const double way = gripper.open[i] - gripper.closed[i];
    if (way == 0.0) continue;
    const auto k = static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(gripper.joints[i])]);
    sum += (state.q[k] - gripper.closed[i]) / way;
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

double mean_share(const Grippers& grippers, const Model& model, const RobotState& state) {
  double sum = 0.0;
  for (const Gripper& gripper : grippers) sum += share_of(gripper, model, state);
  return sum / static_cast<double>(grippers.size());
}

// What of the least way from closed to open is kMoved [rad or m].
double least_moved(const Grippers& grippers) {
  double least = 1e300;
  for (const Gripper& gripper : grippers) {
    for (std::size_t i = 0; i < gripper.joints.size(); ++i) {
      if (const double way = std::abs(gripper.open[i] - gripper.closed[i]); way > 0.0) least = std::min(least, way);
    }
  }
  return kMoved * least;
}

}  // namespace

int grip_command(const std::vector<std::string>& words) {
  const Arguments arguments({"grip", 1, 1, R"(open|close|SHARE
Opens or closes the fingers of a hand as one, or so far: 0 is closed, 1 open (robot.yaml, grippers).  They move no faster than \
a pose, and stop at what they grip; an arm that is on its way stops.
  --side S  left, right, or the name of an arm (robot.yaml, hands); default all
  --robot R  default the robot of the running ./twinbus up, else hrp1s
  --duration S  seconds; default 0.5
  --prefix --url --allow)"}, words);
  const Model model = load_robot(asked_robot(arguments));
  const Grippers grippers = grippers_asked_for(arguments, model);
  const double wanted = share_from(arguments.word(0));
  ModeRequest request;
  request.mode = Mode::kPose;
  request.duration = static_cast<float>(arguments.number("--duration", 0.5, 0.1, 60.0));
  for (const Gripper& gripper : grippers) {
    const std::vector<double> q = opened(gripper, wanted);
    for (std::size_t i = 0; i < q.size(); ++i) {
      const int k = model.bus_index[static_cast<std::size_t>(gripper.joints[i])];
      request.q[static_cast<std::size_t>(k)] = q[i];
      request.joint_mask |= std::int64_t{1} << k;
    }
  }
  BusLink bus = open_bus(arguments);
  (void)active_source(bus);
  if (bus.seen().newest_state().model_hash != model.hash)
    throw std::runtime_error("the robot on the bus is not " + model.name + "; give its folder with --robot");
  (void)bus.seen().take_events();  // of before
  const double before = mean_share(grippers, model, bus.seen().newest_state());
  (void)ask_controller(bus, request);
  bus.listen(kBegins);
  const double moved_by = least_moved(grippers);
  (void)wait_for_joints(bus, request, {.there = moved_by, .moved = moved_by, .still = kStill});
  const double at = mean_share(grippers, model, bus.seen().newest_state());
  if (std::abs(at - wanted) <= kThere) {
    print_typed(stdout, "grip: at %.2f of the opening\n", at);
    return 0;
  }
  const bool closes = wanted < before, moved = std::abs(at - before) > kMoved;
  if (closes && moved) {
    print_typed(stdout, "grip: something is between the fingers at %.2f of the opening\n", at);
    return 0;
  }
  print_typed(stderr, "grip: the fingers stay at %.2f of the opening: %s\n", at,
              bus.seen().controller().mode == Mode::kPose && bus.seen().controller().mode_sequence == request.sequence && moved
                  ? "a joint is held or blocked (./twinbus status)"
                  : why_it_stays(bus, request).c_str());
  return 1;
}

}  // namespace twinbus::launcher
