// Tells why commands are refused: a controller that copies a wrong field would else be met by silence.

#pragma once

#include <array>
#include <cstdint>

#include "bridge/gate/refused_command.h"
#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"

namespace twinbus::inline bridge {

// "its model_hash is 1, that of hrp1s 4760: copy model_hash from STATE"; empty where a refusal is no fault.
std::array<char, 200> refusal_sentence(const RefusedCommand& refused, const Model& model) noexcept;

// Once so many of one kind came in a row, and again when another kind does or after ten seconds.
class RefusalTeller {
 public:
  static constexpr std::int64_t kInARow = 20;
  // Fills text and severity of event; false when there is nothing to say.
  bool next(const RefusedCommand& refused, const Model& model, std::int64_t now_ns, Event& event) noexcept;

 private:
  GateVerdict told_ = GateVerdict::kAccepted;
  std::int64_t told_ns_ = 0;
};

}  // namespace twinbus::bridge
