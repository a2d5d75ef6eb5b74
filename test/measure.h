// What every bench measures with; peers too, which are built without the rest of the project.

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "common/time/cpu_time.h"

namespace twinbus {

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace twinbus
