// What people are told when a guard holds a joint that was sent somewhere: which two things come too near, and how to go on.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "control/guard/guard.h"

namespace twinbus::inline control {

class HoldWords {
 public:
  explicit HoldWords(const Model& model) noexcept : model_(&model) {}

  // waits, given_up: bit per bus joint, as Posture tells them.  guard: in the controller, or null; heard: what a guard process
  // says of this tick, or null.  A sentence that lives until the fourth next one; null where there is nothing new to say.
  const char* tell(std::int64_t waits, std::int64_t given_up, const Guard* guard, const GuardReport* heard,
                   std::int64_t tick) noexcept;

 private:
  const Model* model_;
  std::array<std::array<char, 200>, 4> sentences_{};
  std::size_t sentence_ = 0;
  std::int64_t told_ = 0, told_tick_ = 0;  // of these joints that wait, when
  std::vector<Obstacle> none_;
};

}  // namespace twinbus::control
