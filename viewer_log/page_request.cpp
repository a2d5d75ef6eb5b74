#include "viewer_log/page_request.h"

#include <nlohmann/json.hpp>

namespace twinbus {

namespace {

using Json = nlohmann::json;

constexpr std::int64_t kLargestId = (std::int64_t{1} << 53) - 1;

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

bool read_mode(const std::string& name, PageRequest& request) {
  struct Row {
    const char* name;
    Mode mode;
    Motion motion;
    float amplitude, frequency;  // as in the scenes sway and squat
  };
  static constexpr Row kRows[] = {{"balance", Mode::kBalance, Motion::kNone, 0, 0},
                                  {"sway", Mode::kBalance, Motion::kSway, 0.03f, 0.4f},
                                  {"squat", Mode::kBalance, Motion::kSquat, 0.05f, 0.3f},
                                  {"hold", Mode::kHold, Motion::kNone, 0, 0},
                                  {"idle", Mode::kIdle, Motion::kNone, 0, 0}};
  for (const Row& row : kRows) {
    if (name == row.name) {
      request.mode = row.mode;
      request.motion = row.motion;
      request.amplitude = row.amplitude;
      request.frequency = row.frequency;
      return true;
    }
  }
  return false;
}

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
  if (what == "clear") {
    request.what = PageRequest::What::kClear;
    return true;
  }
  if (what == "switch") {
    request.run_id = integer_member(json, "run", kLargestId);
    request.what = PageRequest::What::kSwitch;
    problem = "switch: run must be the number of a source";
    return request.run_id > 0;
  }
  if (what == "mode") {
    request.what = PageRequest::What::kMode;
    problem = "mode: one of balance, sway, squat, hold, idle";
    return read_mode(text_member(json, "mode"), request);
  }
  problem = "not understood: do must be stop, clear, switch or mode";
  return false;
}

std::string note_frame(const std::string& text) {
  return Json({{"type", "note"}, {"text", text}})
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace twinbus
