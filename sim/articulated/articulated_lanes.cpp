#include "sim/articulated/articulated_lanes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/math/index.h"
#include "common/simd/vec4.h"

namespace twinbus::inline sim {

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

void set_vector(const Eigen::Vector3d& from, double* to, std::size_t stride) {
  for (int k = 0; k < 3; ++k) to[static_cast<std::size_t>(k) * stride] = from[k];
}
void set_matrix(const Eigen::Matrix3d& from, double* to, std::size_t stride) {
  for (int k = 0; k < 9; ++k) to[static_cast<std::size_t>(k) * stride] = from.data()[k];
}

}  // namespace

TWINBUS_AVX2_CLONES
void find_sines(const std::vector<double>& angle, std::vector<double>& sine,
                std::vector<double>& cosine) noexcept {
  Int4 near = Int4{} - 1;
  for (std::size_t j = 0; j < angle.size(); j += 4) {
    Vec4 s, c;
    const Vec4 a = load4(&angle[j]);
    sine_cosine(a, s, c);
    store4(&sine[j], s);
    store4(&cosine[j], c);
    near &= (a <= kMostAngle) & (a >= -kMostAngle);
  }
  if ((near[0] & near[1] & near[2] & near[3]) != 0) return;
  for (std::size_t j = 0; j < angle.size(); ++j) {
    if (std::abs(angle[j]) <= kMostAngle) continue;
    sine[j] = std::sin(angle[j]);
    cosine[j] = std::cos(angle[j]);
  }
}

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

// In order of depth: links that follow one another seldom wait for one another.
template <class L>
void fill(BodyLanes<L>& lanes, const Model& model, double mass_scale, LinkNumbers& to_links) {
  constexpr auto kLanes = static_cast<std::size_t>(BodyLanes<L>::kLanes);
  const std::size_t ranks = lanes.ranks.size();
  lanes.links.resize(ranks);
  int most_folded = 0;
  for (const Rank& rank : lanes.ranks) most_folded = std::max(most_folded, rank.folded + 1);
  lanes.folded.resize(at(most_folded));
  lanes.stiff.resize(ranks);
  lanes.of_joint.resize(model.joints.size());
  for (std::vector<double>* numbers :
       {&lanes.angle, &lanes.rate, &lanes.sine, &lanes.cosine, &lanes.force, &lanes.gain}) {
    numbers->assign((ranks * kLanes + 3) / 4 * 4, 0.0);
  }
  to_links.first = reinterpret_cast<double*>(lanes.links.data());
  to_links.stride = kLanes;
  to_links.where.assign(model.links.size(), 0);
  std::fill_n(to_links.first, ranks * sizeof(LinkLanes<L>) / sizeof(double), 0.0);
  for (std::size_t r = 0; r < ranks; ++r) {
    Rank& rank = lanes.ranks[r];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto number = [&](std::size_t field) {
        return to_links.first + r * sizeof(LinkLanes<L>) / sizeof(double) + field * kLanes + lane;
      };
      *number(TWINBUS_LANE_FIELD(rotor)) = 1.0;  // without a link: so that D is not zero
      if (r == 0)
        set_matrix(Eigen::Matrix3d::Identity(), number(TWINBUS_LANE_FIELD(rotation)), kLanes);
      const int i = rank.link[lane];
      set_matrix(Eigen::Matrix3d::Identity(), number(TWINBUS_LANE_FIELD(placed)), kLanes);
      if (i < 0) continue;
      const Link& link = model.links[at(i)];
      to_links.where[at(i)] = static_cast<std::size_t>(number(0) - to_links.first);
      *number(TWINBUS_LANE_FIELD(mass)) = link.mass * mass_scale;
      set_vector(link.com, number(TWINBUS_LANE_FIELD(com)), kLanes);
      const Eigen::Matrix3d inertia = link.inertia * mass_scale;
      double* to = number(TWINBUS_LANE_FIELD(inertia));
      for (int row = 0; row < 3; ++row) {
        for (int k = row; k < 3; ++k, to += kLanes) *to = inertia(row, k);
      }
      if (i == 0) continue;
      const Joint& joint = model.joints[at(i - 1)];
      const bool slides = joint.kind == JointKind::kPrismatic;
      rank.slides = rank.slides || slides;
      *number(TWINBUS_LANE_FIELD(slides)) = slides ? 1.0 : 0.0;
      *number(TWINBUS_LANE_FIELD(rotor)) = joint.rotor_inertia;
      set_vector(joint.placement.translation(), number(TWINBUS_LANE_FIELD(offset)), kLanes);
      set_vector(joint.axis, number(TWINBUS_LANE_FIELD(joint_axis)), kLanes);
      const Eigen::Matrix3d placed = joint.placement.linear();
      set_matrix(placed, number(TWINBUS_LANE_FIELD(placed)), kLanes);
      rank.turned = rank.turned || placed != Eigen::Matrix3d::Identity();
      lanes.of_joint[at(i - 1)] = r * kLanes + lane;
    }
  }
}

template void fill(BodyLanes<Vec4>&, const Model&, double, LinkNumbers&);
template void fill(BodyLanes<double>&, const Model&, double, LinkNumbers&);

}  // namespace twinbus::sim
