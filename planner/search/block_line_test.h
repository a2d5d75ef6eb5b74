// The block check as a search asks it: free at so many postures per radian.

#pragma once

#include <algorithm>
#include <cmath>

#include "planner/batch/check.h"
#include "planner/search/rrt_connect.h"

namespace twinbus::inline planner {

class BlockLineTest : public LineTest {
 public:
  // check must outlive this.  density: postures per radian of joint-space length.
  BlockLineTest(BlockCheck& check, float density) : check_(&check), density_(density) {}

  bool free(const SearchPoint& from, const SearchPoint& step, float length) override {
    const int blocks = std::max(1, static_cast<int>(std::ceil(length * density_ / 8.0F)));
    return check_->line_free(from.data(), step.data(), blocks);
  }

 private:
  BlockCheck* check_;
  float density_;
};

}  // namespace twinbus::planner
