#include "viewer_log/server/page_request.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/text/json_depth.h"
#include "lcmtypes/msg/motion_defaults.h"

namespace twinbus::inline viewer_log {

namespace {

using Json = nlohmann::json;

constexpr std::int64_t kLargestId = (std::int64_t{1} << 53) - 1;
constexpr double kLargestJoint = 1000.0;  // [rad or m]; the robot's own limits are looked at where the robot is known
constexpr double kFarthestHand =
    1000.0;  // a robot that has walked for long may be far from where it began [m]

std::string text_member(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// -1 unless the member is an integer from 0 to largest.
std::int64_t integer_member(const Json& json, const char* key, std::int64_t largest) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number_integer()) return -1;
  if (found->is_number_unsigned() && found->get<std::uint64_t>() > std::uint64_t(largest))
    return -1;
  const auto value = found->get<std::int64_t>();
  return value >= 0 && value <= largest ? value : -1;
}

// False unless it is a finite number of at most this size.
bool read_number(const Json& json, double largest, double& value) {
  if (!json.is_number()) return false;
  value = json.get<double>();
  return std::abs(value) <= largest;
}

bool read_walk(const Json& json, PageRequest& request) {
  double vx = 0, vy = 0, wz = 0;
  if (!read_number(json.value("vx", Json()), 2.0, vx) ||
      !read_number(json.value("vy", Json()), 1.0, vy) ||
      !read_number(json.value("wz", Json()), 2.0, wz)) {
    return false;
  }
  request.vx = static_cast<float>(vx);
  request.vy = static_cast<float>(vy);
  request.wz = static_cast<float>(wz);
  return true;
}

template <class T>
bool read_three(const Json& json, const char* key, double largest, std::array<T, 3>& values) {
  const auto at = json.find(key);
  if (at == json.end() || !at->is_array() || at->size() != 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    double value = 0.0;
    if (!read_number((*at)[i], largest, value)) return false;
    values[i] = static_cast<T>(value);
  }
  return true;
}

bool read_reach(const Json& json, PageRequest& request) {
  request.hand = text_member(json, "side");
  return !request.hand.empty() && read_three(json, "at", kFarthestHand, request.at);
}

bool read_sim(const Json& json, PageRequest& request) {
  SimRequest& sim = request.sim;
  const std::string action = text_member(json, "action");
  double pace = 1.0;
  sim.action = action == "pause"  ? SimAction::kPause
               : action == "go"   ? SimAction::kGo
               : action == "step" ? SimAction::kStep
               : action == "pace" ? SimAction::kPace
                                  : SimAction::kNone;
  if (sim.action == SimAction::kStep)
    sim.ticks = static_cast<std::int32_t>(integer_member(json, "ticks", 100'000));
  if (sim.action == SimAction::kPace && !read_number(json.value("pace", Json()), 100.0, pace))
    return false;
  sim.pace = static_cast<float>(pace);
  return sim.action != SimAction::kNone && sim.ticks >= 0;
}

bool read_push(const Json& json, PageRequest& request) {
  double seconds = 0.0;
  request.link = text_member(json, "link");
  request.sim.action = SimAction::kPush;
  if (!read_number(json.value("seconds", Json()), 60.0, seconds)) return false;
  request.sim.duration = static_cast<float>(seconds);
  return !request.link.empty() && seconds > 0.0 &&
         read_three(json, "force", 100'000.0, request.sim.force) &&
         read_three(json, "point", 10.0, request.sim.point);
}

bool read_pose(const Json& json, PageRequest& request) {
  const auto joints = json.find("joints");
  if (joints == json.end() || !joints->is_object() || joints->empty() || joints->size() > kMaxJoints) return false;
  for (const auto& [name, value] : joints->items()) {
    double q = 0.0;
    if (!read_number(value, kLargestJoint, q)) return false;
    request.joints.emplace_back(name, q);
  }
  return true;
}

bool read_mode(const Json& json, PageRequest& request) {
  const std::string name = text_member(json, "mode");
  struct Row {
    const char* name;
    Mode mode;
    Motion motion;
  };
  static constexpr Row kRows[] = {{"balance", Mode::kBalance, Motion::kNone}, {"sway", Mode::kBalance, Motion::kSway},
                                  {"squat", Mode::kBalance, Motion::kSquat},  {"hold", Mode::kHold, Motion::kNone},
                                  {"walk", Mode::kWalk, Motion::kNone},       {"idle", Mode::kIdle, Motion::kNone}};
  for (const Row& row : kRows) {
    if (name == row.name) {
      request.mode = row.mode;
      request.motion = row.motion;
      request.amplitude = defaults_of(row.motion).amplitude;
      request.frequency = defaults_of(row.motion).frequency;
      return true;
    }
  }
  return false;
}

bool read_switch(const Json& json, PageRequest& request) {
  request.run_id = integer_member(json, "run", kLargestId);
  return request.run_id > 0;
}

bool read_setup(const Json& json, PageRequest& request) {
  const auto setup = json.find("setup");
  if (setup == json.end() || !setup->is_object() || text_member(*setup, "scene").empty()) return false;
  request.saves = setup->contains("save");
  if (request.saves && integer_member(*setup, "save", kLargestSave) < 0) return false;
  request.setup = setup->dump(-1, ' ', true, Json::error_handler_t::replace);
  return true;
}

bool read_record(const Json& json, PageRequest& request) {
  const auto on = json.find("on");
  if (on == json.end() || !on->is_boolean()) return false;
  request.on = on->get<bool>();
  return true;
}

// What only a trusted page may ask; read: what more is said of it, problem: when that is not understood.
struct Kind {
  const char* name;
  PageRequest::What what;
  bool (*read)(const Json& json, PageRequest& request);
  const char* problem;
};
using What = PageRequest::What;
constexpr Kind kKinds[] = {
    {"clear", What::kClear, nullptr, nullptr},
    {"switch", What::kSwitch, &read_switch, "switch: run must be the number of a source"},
    {"mode", What::kMode, &read_mode, "mode: one of balance, walk, sway, squat, hold, idle"},
    {"pose", What::kPose, &read_pose, "pose: joints must be an object of joint names and numbers, rad or m"},
    {"walk", What::kWalk, &read_walk, "walk: vx, vy and wz must be numbers of at most 2 m/s, 1 m/s and 2 rad/s"},
    {"reach", What::kReach, &read_reach, "reach: side must name an arm, at three numbers in metres"},
    {"reset", What::kReset, nullptr, nullptr},
    {"sim", What::kSim, &read_sim, "sim: action is pause, go, step with ticks, or pace with pace"},
    {"push", What::kSim, &read_push, "push: link, force and point of three numbers each, and seconds"},
    {"cancel", What::kCancel, nullptr, nullptr},
    {"setup", What::kSetup, &read_setup, "setup: a JSON object with the name of a scene; save: a whole number from 0 to 2^53"},
    {"record", What::kRecord, &read_record, "record: on must be true or false"},
};

}  // namespace

bool read_page_request(const std::string& text, bool trusted, PageRequest& request,
                       std::string& problem) {
  request = {};
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    problem = "not understood: a request is a JSON object";
    return false;
  }
  const std::string what = text_member(json, "do");
  if (what == "hello") {
    request.what = PageRequest::What::kHello;
    return true;
  }
  if (what == "stop") {
    const std::int64_t kind = integer_member(json, "kind", 3);
    // A stop whose kind is damaged is still a stop.
    request.stop = kind >= 1 ? StopKind(kind) : StopKind::kBalanced;
    request.what = PageRequest::What::kStop;
    return true;
  }
  if (!trusted) {
    problem = "watching only: open the address that the viewer printed to get the buttons";
    return false;
  }
  if (nests_deeper(text, kDeepestWish)) {
    problem = "not understood: a request is at most 8 brackets deep";
    return false;
  }
  for (const Kind& kind : kKinds) {
    if (what != kind.name) continue;
    request.what = kind.what;
    if (kind.read == nullptr || kind.read(json, request)) return true;
    problem = kind.problem;
    return false;
  }
  problem =
      "not understood: do must be stop, clear, switch, mode, pose, walk, reach, cancel, setup, reset, sim, push or record";
  return false;
}

std::string note_frame(const std::string& text) {
  return Json({{"type", "note"}, {"text", text}})
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace twinbus::viewer_log
