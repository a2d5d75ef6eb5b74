// A path that is free everywhere, not only at the postures that were looked at.

#pragma once

#include "planner/search/block_line_test.h"
#include "planner/search/shorten.h"

namespace twinbus::inline planner {

struct CertainPath {
  SearchPath path;       // empty: none was found
  int rounds = 0;        // of the search
  bool certain = false;  // every line is proved free
  bool ends_certain = false;  // the start is, and a goal
};

// Is a posture proved free by itself?  Postures that are nearer to touching than rounding errors are not.
bool certain_at(BlockCheck& check, const SearchPoint& q);

// First a path as a search with postures finds it; what cannot be proved of it is done again with proved lines only.  No
// path is found from a start, or to goals, that are not certain themselves, and none is looked for.  density: postures per
// radian.  keep_on: as of JointSearch.
CertainPath find_certain(JointSearch& search, BlockCheck& check, float density,
                         const SearchPoint& start, const SearchPath& goals,
                         bool (*keep_on)(void*) = nullptr, void* user = nullptr);

}  // namespace twinbus::planner
