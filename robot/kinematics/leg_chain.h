// The joints between the base and a sole.

#pragma once

#include <array>

#include "robot/description/model.h"

namespace twinbus::inline robot {

struct LegChain {
  std::array<int, 7> joint{};  // base first
  int count = 0;               // 5, 6 or 7, or this is no leg that balance can use

  bool balances() const noexcept { return count >= 5; }
  const int* begin() const noexcept { return joint.data(); }
  const int* end() const noexcept { return joint.data() + count; }
  int ankle() const noexcept { return joint[static_cast<std::size_t>(count - 1)]; }  // the last one
};

// Empty when a joint follows another one, or belongs to both legs.
LegChain leg_chain(const Model& model, int foot) noexcept;

// For who throws: what is wrong with a leg that does not balance.
inline constexpr const char* kNoLegs = "a sole does not hang on the base by five to seven joints of its own";

}  // namespace twinbus::robot
