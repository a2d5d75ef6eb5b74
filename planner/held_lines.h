// Lines along which every joint can hold the arm, and move it against its own friction, for a search whose ways were too heavy.

#pragma once

#include <algorithm>
#include <cmath>

#include "planner/search/arm_lines.h"
#include "planner/timing/motion_effort.h"

namespace twinbus::inline planner {

class HeldLines : public LineTest {
 public:
  // All must outlive this.
  // share: of their efforts that the joints may need to hold the arm.
  HeldLines(ArmLines& lines, MotionEffort& effort, int joints, double share)
      : lines_(&lines), effort_(&effort), joints_(joints), share_(share) {}

  bool free(const SearchPoint& from, const SearchPoint& step, float length) override {
    constexpr float kApart = 0.1F;  // [rad or m]
    const int parts = std::max(1, static_cast<int>(std::ceil(length / kApart)));
    const JointPoint along = from_search(step, joints_);
    SearchPoint there = from;
    for (int i = 0; i <= parts; ++i) {
      const float share = static_cast<float>(i) / static_cast<float>(parts);
      for (std::size_t j = 0; j < there.size(); ++j) there[j] = from[j] + share * step[j];
      if (!effort_->creeps(from_search(there, joints_), along, share_)) return false;
    }
    return lines_->free(from, step, length);
  }

 private:
  ArmLines* lines_;
  MotionEffort* effort_;
  int joints_;
  double share_;
};

}  // namespace twinbus::planner
