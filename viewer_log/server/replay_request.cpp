#include "viewer_log/server/replay_request.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace twinbus::inline viewer_log {

namespace {

using Asked = ReplayRequest::What;

constexpr double kLongestLog = 1e7;    // [s]
constexpr double kLongestFill = 60.0;  // [s]
constexpr std::size_t kLongestText = 200;

// False unless the member is a finite number from least to most.
bool number_member(const nlohmann::json& json, const char* key, double least, double most,
                   double& value) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return false;
  value = found->get<double>();
  return value >= least && value <= most;
}

bool text_of_member(const nlohmann::json& json, const char* key, std::string& value) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_string()) return false;
  value = found->get<std::string>();
  return value.size() <= kLongestText;
}

// A time, or null for none.
bool mark_member(const nlohmann::json& json, const char* key, double& value) {
  const auto found = json.find(key);
  if (found != json.end() && found->is_null()) return true;
  return number_member(json, key, 0.0, kLongestLog, value);
}

bool read_step(const nlohmann::json& json, int& by) {
  double value = 0.0;
  if (!number_member(json, "by", -1.0, 1.0, value) || !(std::abs(value) >= 1.0)) return false;
  by = value > 0.0 ? 1 : -1;
  return true;
}

bool read_switch(const nlohmann::json& json, bool& on) {
  const auto found = json.find("on");
  if (found == json.end() || !found->is_boolean()) return false;
  on = found->get<bool>();
  return true;
}

bool read_marks(const nlohmann::json& json, ReplayRequest& request) {
  return mark_member(json, "in", request.in) && mark_member(json, "out", request.out) &&
         (request.in < 0.0 || request.out < 0.0 || request.out > request.in);
}

}  // namespace

bool read_replay_request(const std::string& text, bool trusted, ReplayRequest& request,
                         std::string& problem) {
  request = {};
  const auto json = nlohmann::json::parse(text, nullptr, false);
  std::string what;
  if (json.is_discarded() || !json.is_object() || !text_of_member(json, "do", what)) {
    problem = "not understood: a request is a JSON object with do";
    return false;
  }
  if (what == "hello") {
    request.what = Asked::kHello;
    return true;
  }
  if (what == "stop") {
    problem = "this is a recording: there is nothing to stop here";
    return false;
  }
  if (!trusted) {
    problem = "watching only: open the address that the viewer printed to get the buttons";
    return false;
  }
  const auto is = [&](const char* name, Asked kind) {
    if (what != name) return false;
    request.what = kind;
    return true;
  };
  if (is("play", Asked::kPlay) || is("pause", Asked::kPause)) return true;
  if (is("seek", Asked::kSeek)) {
    problem = "seek: s must be a time in seconds";
    return number_member(json, "s", 0.0, kLongestLog, request.seconds);
  }
  if (is("step", Asked::kStep)) {
    problem = "step: by must be 1 or -1";
    return read_step(json, request.by);
  }
  if (is("speed", Asked::kSpeed)) {
    problem = "speed: x must be from 0.05 to 16";
    return number_member(json, "x", kSlowest, kFastest, request.speed);
  }
  if (is("loop", Asked::kLoop)) {
    problem = "loop: on must be true or false";
    return read_switch(json, request.on);
  }
  if (is("mark", Asked::kMark)) {
    problem = "mark: in and out must be times or null, out behind in";
    return read_marks(json, request);
  }
  if (is("open", Asked::kOpen)) {
    problem = "open: log must be the name of one that is listed";
    return text_of_member(json, "log", request.log);
  }
  if (is("beside", Asked::kBeside)) {
    problem =
        "beside: log must be the name of one that is listed, or empty, and shift a number of "
        "seconds";
    return text_of_member(json, "log", request.log) &&
           number_member(json, "shift", -kLongestLog, kLongestLog, request.seconds);
  }
  if (is("fill", Asked::kFill)) {
    problem = "fill: seconds must be from 0 to 60";
    return number_member(json, "seconds", 0.0, kLongestFill, request.seconds);
  }
  problem =
      "a recording is shown: do must be play, pause, seek, step, speed, loop, mark, open, beside "
      "or fill";
  return false;
}

}  // namespace twinbus::viewer_log
