// A number with a unit, as people write it: "1 mm", "0.5ms", "0.001".

#pragma once

#include <span>
#include <string>

namespace twinbus::inline common {

struct Unit {
  const char* name;  // "" is the number alone
  double scale;      // what one of it is in the unit of the answer
};

// The number times the scale of its unit (a space may stand before the unit); NaN without a number, or with a unit that is not among
// these.
double quantity_of(const std::string& text, std::span<const Unit> units);

}  // namespace twinbus::common
