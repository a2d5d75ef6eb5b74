// What a page may ask of the log viewer, read from the JSON text it sent.
//
//   {"do":"hello"}                                    needs no token
//   {"do":"play"} {"do":"pause"} {"do":"seek","s":S} {"do":"step","by":1|-1} {"do":"speed","x":X}
//   {"do":"loop","on":B} {"do":"mark","in":S|null,"out":S|null} {"do":"open","log":NAME}
//   {"do":"beside","log":NAME|"","shift":S} {"do":"fill","seconds":S}     need it

#pragma once

#include <string>

namespace twinbus::inline viewer_log {

struct ReplayRequest {
  enum class What {
    kNone,
    kHello,
    kPlay,
    kPause,
    kSeek,
    kStep,
    kSpeed,
    kLoop,
    kMark,
    kOpen,
    kBeside,
    kFill
  };
  What what = What::kNone;
  double seconds = 0.0;          // seek, fill; shift of beside
  double in = -1.0, out = -1.0;  // mark; negative: none
  double speed = 1.0;
  int by = 1;
  bool on = false;
  std::string log;
};

inline constexpr double kSlowest = 0.05, kFastest = 16.0;  // times as fast as it was

// False with a sentence in problem for anything else, and for an untrusted page that wants to move the log.
[[nodiscard]] bool read_replay_request(const std::string& text, bool trusted,
                                       ReplayRequest& request, std::string& problem);

}  // namespace twinbus::viewer_log
