// The hand that is meant by a side.

#pragma once

#include "robot/description/model.h"

namespace twinbus {

// Of that side (0 left, 1 right); of a robot with one hand that one, for either side; null: it has none.
inline const Hand* hand_of(const Model& model, int side) noexcept {
  for (const int one : {side, 1 - side}) {
    const Hand& hand = model.hands[static_cast<std::size_t>(one)];
    if (hand.link >= 0) return &hand;
  }
  return nullptr;
}

}  // namespace twinbus
