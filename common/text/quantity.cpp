#include "common/text/quantity.h"

#include <cstdlib>
#include <limits>
#include <string_view>

namespace twinbus::inline common {

double quantity_of(const std::string& text, std::span<const Unit> units) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (end == text.c_str()) return std::numeric_limits<double>::quiet_NaN();
  while (*end == ' ') ++end;
  for (const Unit& unit : units) {
    if (std::string_view(end) == unit.name) return number * unit.scale;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace twinbus::common
