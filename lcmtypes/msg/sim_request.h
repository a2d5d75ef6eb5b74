// What only a simulated world can do, sim_request_t: pause, go on, single steps, slow motion, a push.

#pragma once

#include <array>
#include <cstdint>

namespace twinbus {

enum class SimAction : std::int8_t {
  kNone = 0,
  kPause = 1,
  kGo = 2,
  kStep = 3,
  kPace = 4,
  kPush = 5
};

struct SimRequest {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int64_t model_hash = 0;
  std::int32_t sequence = 0;
  std::int32_t ticks = 0;
  std::int16_t link = 0;
  SimAction action = SimAction::kNone;
  float pace = 0;                // times real time
  float duration = 0;            // [s]
  std::array<float, 3> force{};  // world [N]
  std::array<float, 3> point{};  // in the frame of the link [m]
};

}  // namespace twinbus
