// The joints between the base and a sole.

#pragma once

#include <array>

#include "robot/description/model.h"

namespace twinbus {

struct LegChain {
  std::array<int, 6> joint{};  // base first
  int count = 0;               // 6, or this is no leg that balance can use
};

LegChain leg_chain(const Model& model, int foot) noexcept;

}  // namespace twinbus
