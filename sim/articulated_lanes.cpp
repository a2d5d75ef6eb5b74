#include "sim/articulated_lanes.h"

#include <algorithm>

#include "robot/index.h"

namespace twinbus {

namespace {

struct Standing {
  int rank = -1, lane = 0;
};

// A lane for each link of a rank: its parent's, if that is free.
void take_lanes(const std::vector<int>& links, const std::vector<int>& parent, int rank, int lanes,
                std::vector<Standing>& stands, Rank& to) {
  for (const bool kept : {true, false}) {
    for (const int link : links) {
      if (stands[at(link)].rank == rank) continue;
      int lane = stands[at(parent[at(link)])].lane;
      if (parent[at(link)] == 0) lane = 0;
      const bool own = parent[at(link)] != 0 && to.link[lane] < 0;
      if (kept && !own) continue;
      for (lane = own ? lane : 0; to.link[lane] >= 0;) ++lane;
      to.link[lane] = link;
      stands[at(link)] = {rank, lane};
    }
  }
  // Link 0 stands in all lanes.
  bool straight = true;
  int common = -1;
  for (int lane = 0; lane < lanes; ++lane) {
    if (to.link[lane] < 0) continue;
    const Standing& on = stands[at(parent[at(to.link[lane])])];
    straight = straight && (common < 0 || common == on.rank) && (on.rank == 0 || on.lane == lane);
    common = on.rank;
  }
  to.parents = straight ? common : -1;
  for (int lane = 0; lane < lanes; ++lane) {
    const int link = to.link[lane];
    to.parent[lane] =
        link < 0 ? 0
                 : stands[at(parent[at(link)])].rank * lanes + stands[at(parent[at(link)])].lane;
  }
}

// From the last rank on: a rank's place is taken over by its parents if it is the first of their
// children and they stand in its lanes.
void share_folded(std::vector<Rank>& ranks, int lanes) {
  std::vector<bool> used;
  const auto take = [&used](Rank& rank) {
    const auto free = std::find(used.begin(), used.end(), false);
    rank.folded = static_cast<int>(free - used.begin());
    if (free == used.end()) used.push_back(true);
    used[at(rank.folded)] = true;
  };
  for (std::size_t r = ranks.size() - 1; r > 0; --r) {
    Rank& rank = ranks[r];
    if (rank.leaf) take(rank);
    bool taken_over = false;
    for (int lane = 0; lane < lanes; ++lane) {
      if (rank.link[lane] < 0) continue;
      Rank& on = ranks[at(rank.parent[lane] / lanes)];
      if (!on.leaf) continue;
      on.leaf = false;
      taken_over = rank.parents >= 0;
      rank.first[lane] = true;
      if (!taken_over) {
        take(on);
        continue;
      }
      std::fill_n(rank.first, lanes, true);
      on.folded = rank.folded;
    }
    if (!taken_over) used[at(rank.folded)] = false;
  }
  if (ranks[0].leaf) take(ranks[0]);
}

}  // namespace

std::vector<Rank> side_by_side(const std::vector<int>& parent, int lanes) {
  const int count = static_cast<int>(parent.size());
  std::vector<int> behind(parent.size(), 0);
  for (int i = count - 1; i > 0; --i) {
    int& most = behind[at(parent[at(i)])];
    most = std::max(most, behind[at(i)] + 1);
  }
  std::vector<Standing> stands(parent.size());
  stands[0].rank = 0;
  std::vector<Rank> ranks(1);
  ranks[0].link[0] = 0;
  for (int placed = 1; placed < count;) {
    const int rank = static_cast<int>(ranks.size());
    std::vector<int> ready;
    for (int i = 1; i < count; ++i) {
      const int on = stands[at(parent[at(i)])].rank;
      if (stands[at(i)].rank < 0 && on >= 0 && on < rank) ready.push_back(i);
    }
    std::stable_sort(ready.begin(), ready.end(),
                     [&](int a, int b) { return behind[at(a)] > behind[at(b)]; });
    if (static_cast<int>(ready.size()) > lanes) ready.resize(at(lanes));
    placed += static_cast<int>(ready.size());
    take_lanes(ready, parent, rank, lanes, stands, ranks.emplace_back());
  }
  share_folded(ranks, lanes);
  return ranks;
}

}  // namespace twinbus
