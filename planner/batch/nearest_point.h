// Which of many points in joint space is nearest: a plain scan, eight at a time.

#pragma once

namespace twinbus::inline planner {

// columns: coordinate j of point i is columns[j stride + i]; filled up to a multiple of 8 points with
// some that are far away.  found: squared distance.  The first of equals.
int nearest_point(const float* columns, int stride, int count, int joints, const float* q,
                  float& found) noexcept;

}  // namespace twinbus::planner
