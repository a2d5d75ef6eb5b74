// Links side by side: whatever the tree, each once, behind its parent, and all that they fold into
// their parents arrives.

#include "sim/articulated/articulated_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/math/index.h"
#include "common/math/random.h"

namespace twinbus {
namespace {

// Two legs of six, a waist of two, two arms of seven and a neck of two on it.
std::vector<int> humanoid() {
  std::vector<int> parent{-1};
  const auto chain = [&](int from, int count) {
    for (int i = 0; i < count; ++i) {
      parent.push_back(i == 0 ? from : static_cast<int>(parent.size()) - 1);
    }
    return static_cast<int>(parent.size()) - 1;
  };
  chain(0, 6);
  chain(0, 6);
  const int chest = chain(0, 2);
  chain(chest, 2);
  chain(chest, 7);
  chain(chest, 7);
  return parent;
}

std::vector<int> any_tree(Random& random, int links) {
  std::vector<int> parent{-1};
  for (int i = 1; i < links; ++i) {
    parent.push_back(static_cast<int>(random.uniform() * i));
  }
  return parent;
}

// Each link sends one to its parent, with all that it was sent, by the places that ranks name.
int arrives(const std::vector<Rank>& ranks, int lanes) {
  std::vector<std::vector<int>> folded(ranks.size(), std::vector<int>(at(lanes), -1000000));
  int at_root = 0;
  for (std::size_t r = ranks.size(); r-- > 0;) {
    const Rank& rank = ranks[r];
    std::vector<int>& own = folded[at(rank.folded)];
    if (rank.leaf) std::fill(own.begin(), own.end(), 0);
    if (r == 0) {
      for (const int sent : own) at_root += sent;
      continue;
    }
    for (int lane = 0; lane < lanes; ++lane) own[at(lane)] += rank.link[lane] >= 0 ? 1 : 0;
    if (rank.parents >= 0) {
      std::vector<int>& to = folded[at(ranks[at(rank.parents)].folded)];
      EXPECT_EQ(rank.first[0], &to == &own);
      for (int lane = 0; lane < lanes && !rank.first[0]; ++lane) to[at(lane)] += own[at(lane)];
      continue;
    }
    for (int lane = 0; lane < lanes; ++lane) {
      if (rank.link[lane] < 0) continue;
      std::vector<int>& to = folded[at(ranks[at(rank.parent[lane] / lanes)].folded)];
      if (rank.first[lane]) std::fill(to.begin(), to.end(), 0);
      to[at(rank.parent[lane] % lanes)] += own[at(lane)];
    }
  }
  return at_root;
}

void check(const std::vector<int>& parent, int lanes) {
  const std::vector<Rank> ranks = side_by_side(parent, lanes);
  std::vector<int> place(parent.size(), -1);  // rank times lanes plus lane
  for (int r = 0; r < static_cast<int>(ranks.size()); ++r) {
    for (int lane = 0; lane < lanes; ++lane) {
      const int link = ranks[at(r)].link[lane];
      if (link < 0) continue;
      EXPECT_EQ(place[at(link)], -1) << "stands twice";
      place[at(link)] = r * lanes + lane;
      if (link == 0) continue;
      const int on = place[at(parent[at(link)])];
      EXPECT_EQ(ranks[at(r)].parent[lane], on);
      EXPECT_LT(on / lanes, r);
      if (ranks[at(r)].parents < 0) continue;
      EXPECT_EQ(ranks[at(r)].parents, on / lanes);
      EXPECT_TRUE(on / lanes == 0 || on % lanes == lane);
    }
  }
  EXPECT_EQ(std::count(place.begin(), place.end(), -1), 0);
  EXPECT_EQ(place[0], 0);
  EXPECT_EQ(arrives(ranks, lanes), static_cast<int>(parent.size()) - 1);
}

TEST(ArticulatedLanes, LegsAndArmsStandSideBySide) {
  const std::vector<int> parent = humanoid();
  check(parent, 4);
  check(parent, 1);
  // The waist and an arm are nine deep: fewer cannot be.
  EXPECT_EQ(side_by_side(parent, 4).size(), 10U);
}

TEST(ArticulatedLanes, AnyTreeStandsBehindItsParents) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const std::vector<int> parent = any_tree(random, 1 + i % 60);
    SCOPED_TRACE(i);
    for (const int lanes : {1, 4}) check(parent, lanes);
  }
}

TEST(ArticulatedLanes, AChainKeepsItsLane) {
  std::vector<int> parent;
  for (int i = 0; i < 31; ++i) parent.push_back(i - 1);
  check(parent, 4);
  for (const Rank& rank : side_by_side(parent, 4)) EXPECT_GE(rank.link[0], 0);
}

}  // namespace
}  // namespace twinbus
