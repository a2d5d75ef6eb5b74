// What a page may ask for, read from the JSON text it sent.
//
//   {"do":"stop","kind":1..3}   needs no token: anyone may stop
//   {"do":"clear"}  {"do":"switch","run":R}  {"do":"mode","mode":"balance|walk|sway|squat|hold|idle"}
//   {"do":"pose","joints":{"NAME":Q,...}}  the others stay [rad or m]
//   {"do":"walk","vx":V,"vy":V,"wz":W}  {"do":"reach","side":"left|right|ARM","at":[x,y,z]}  {"do":"cancel"}
//   {"do":"setup","setup":{...}}  see launcher/up/setup.h, which judges it
//   {"do":"reset"}  the simulated world begins anew
//   {"do":"sim","action":"pause|go"}  {"do":"sim","action":"step","ticks":N}  {"do":"sim","action":"pace","pace":X}
//   {"do":"push","link":L,"force":[x,y,z],"point":[x,y,z],"seconds":S}   world [N], in the link's frame [m]
//   need it
//   {"do":"hello"}

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline viewer_log {

struct PageRequest {
  enum class What {
    kNone,
    kHello,
    kStop,
    kClear,
    kSwitch,
    kMode,
    kPose,
    kWalk,
    kReach,
    kCancel,
    kSetup,
    kReset,
    kSim,
    kRecord
  };
  What what = What::kNone;
  StopKind stop = StopKind::kNone;
  std::int64_t run_id = 0;  // switch: the source that is to become active
  Mode mode = Mode::kNone;
  Motion motion = Motion::kNone;
  float amplitude = 0;           // [m]
  float frequency = 0;           // [Hz]
  std::vector<std::pair<std::string, double>> joints;  // pose: names and targets [rad or m]
  ModeRequest pose;            // its joints, once the robot is known
  float vx = 0, vy = 0, wz = 0;  // walk [m/s, m/s, rad/s]
  std::string hand;  // its name, looked at where the robot is known
  std::string setup;           // JSON
  bool saves = false;          // the setup only writes the robot
  SimRequest sim;              // without sender, run and robot
  std::string link;            // push
  bool on = false;             // record
  std::array<double, 3> at{};  // reach: where the hand shall be, in the world that is drawn [m]
};

// False, with one sentence in problem, when the text is not one of the above or the page may not
// ask for it.
[[nodiscard]] bool read_page_request(const std::string& text, bool trusted, PageRequest& request,
                                     std::string& problem);

// The same sentence as JSON for the page: {"type":"note","text":...}.
std::string note_frame(const std::string& text);

}  // namespace twinbus::viewer_log
