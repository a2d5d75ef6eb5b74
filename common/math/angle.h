// Angles for people.

#pragma once

namespace twinbus::inline common {

inline constexpr double kDegrees = 57.29577951308232;  // in one radian

}  // namespace twinbus::common
