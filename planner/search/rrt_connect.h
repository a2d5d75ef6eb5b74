// Two trees that grow towards each other in joint space: RRT-Connect (Kuffner and LaValle 2000) with
// the dynamic domain of Yershova et al. (2005), on a Halton sequence.
//
// A node from which a step failed gets a radius outside of which samples are dropped unseen: most
// samples pull nodes at the rim of free space into what blocks them.
//
// More joints than an arm has: random postures are farther apart, as the root of their number, and so is that radius; a step
// of a given length has as many more things to touch as there are more joints, and is that much shorter.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "planner/batch/robot.h"

namespace twinbus::inline planner {

// Positions of the planned joints; the rest is zero [rad or m].
using SearchPoint = std::array<float, kMostPlanned>;
using SearchPath = std::vector<SearchPoint>;

float distance(const SearchPoint& a, const SearchPoint& b, int joints) noexcept;
float length_of(const SearchPath& path, int joints) noexcept;

// What a search asks: which straight lines are free.
class LineTest {
 public:
  virtual ~LineTest() = default;
  // From a free point to from + step, `length` away.
  virtual bool free(const SearchPoint& from, const SearchPoint& step, float length) = 0;

  bool between(const SearchPoint& a, const SearchPoint& b, int joints);
};

struct SearchLimits {
  std::vector<float> lower, upper;  // samples are drawn between them
  float range = 0.0F;               // longest step [rad]; 0: as long as suits so many joints
  int most_rounds = 100000;         // each draws one sample
  std::uint64_t seed = 0;           // where the sequence starts; 0: at its beginning
};

class JointSearch {
 public:
  explicit JointSearch(SearchLimits limits);

  // start and goals must be free.  Empty when no path was found.  keep_on: asked now and then; the
  // search ends when it says false.
  SearchPath find(LineTest& test, const SearchPoint& start, const SearchPath& goals,
                  bool (*keep_on)(void*) = nullptr, void* user = nullptr);

  int rounds() const { return rounds_; }  // of the last search; 0: a goal was in sight
  const SearchLimits& limits() const { return limits_; }

 private:
  struct Tree {
    std::vector<float> columns;  // [joints x stride]
    int stride = 0;
    std::vector<SearchPoint> points;
    std::vector<int> parents;
    std::vector<float> radii;
    void clear();
    int add(const SearchPoint& q, int parent, int joints);
    int nearest(const SearchPoint& q, int joints, float& gap) const;
    void branch(int node, SearchPath& path) const;
  };
  const SearchPoint& sample();
  int extend(LineTest& test, Tree& tree, const SearchPoint& to);
  int connect(LineTest& test, Tree& tree, const SearchPoint& to);

  SearchLimits limits_;
  int joints_;
  Tree from_start_, from_goals_;
  std::vector<SearchPoint> table_;  // of samples, grows as they are asked for
  std::size_t next_ = 0;
  int rounds_ = 0;
  float first_radius_ = 0.0F, least_radius_ = 0.0F;  // of nodes from which a step failed [rad]
};

}  // namespace twinbus::planner
