// What a page may ask for, read from the JSON text it sent.
//
//   {"do":"stop","kind":1..3}   needs no token: anyone may stop
//   {"do":"clear"}  {"do":"switch","run":R}  {"do":"mode","mode":"balance|sway|squat|hold|idle"}
//   need it
//   {"do":"hello"}

#pragma once

#include <cstdint>
#include <string>

#include "robot/requests.h"

namespace twinbus {

struct PageRequest {
  enum class What { kNone, kHello, kStop, kClear, kSwitch, kMode };
  What what = What::kNone;
  StopKind stop = StopKind::kNone;
  std::int64_t run_id = 0;  // switch: the source that is to become active
  Mode mode = Mode::kNone;
  Motion motion = Motion::kNone;
  float amplitude = 0;  // [m]
  float frequency = 0;  // [Hz]
};

// False, with one sentence in problem, when the text is not one of the above or the page may not
// ask for it.
[[nodiscard]] bool read_page_request(const std::string& text, bool trusted, PageRequest& request,
                                     std::string& problem);

// The same sentence as JSON for the page: {"type":"note","text":...}.
std::string note_frame(const std::string& text);

}  // namespace twinbus
