// Where the numbers of a robot's links are while the articulated-body algorithm works on them.
//
// Links that do not hang on one another stand side by side in a rank, one in each lane of L: both
// legs and both arms take their steps together.  L is a vector of four, or one double for what has
// few branches (an arm, a loose box).  A lane without a link has no mass and no axis, and so no
// effect.  Rank 0 has link 0 in its first lane; where that is and how fast is in all of its lanes.

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "robot/description/model.h"
#include "sim/articulated/spatial.h"

// The alignment that Vec4 names is lost in a template argument; what needs it says so again.
#pragma GCC diagnostic ignored "-Wignored-attributes"

namespace twinbus::inline sim {

// Copied number by number: g++ copies a whole struct of vectors in pieces of 16 bytes, some by way
// of integers, and what is stored in pieces is slow to read as one vector again.
template <class L>
struct Three {
  L x, y, z;

  Three() = default;
  TWINBUS_INLINE Three(const L& a, const L& b, const L& c) : x(a), y(b), z(c) {}
  TWINBUS_INLINE Three(const Three& v) : x(v.x), y(v.y), z(v.z) {}
  TWINBUS_INLINE Three& operator=(const Three& v) {
    x = v.x, y = v.y, z = v.z;
    return *this;
  }
};

template <class L>
struct Six {
  Three<L> w, v;  // angular, linear
};

template <class L>
struct Columns3 {
  Three<L> x, y, z;
};

template <class L>
struct Symmetric3 {
  L xx, xy, xz, yy, yz, zz;

  Symmetric3() = default;
  TWINBUS_INLINE Symmetric3(const L& a, const L& b, const L& c, const L& d, const L& e, const L& f)
      : xx(a), xy(b), xz(c), yy(d), yz(e), zz(f) {}
  TWINBUS_INLINE Symmetric3(const Symmetric3& m)
      : xx(m.xx), xy(m.xy), xz(m.xz), yy(m.yy), yz(m.yz), zz(m.zz) {}
  TWINBUS_INLINE Symmetric3& operator=(const Symmetric3& m) {
    xx = m.xx, xy = m.xy, xz = m.xz, yy = m.yy, yz = m.yz, zz = m.zz;
    return *this;
  }
};

// [ ww wv ; wv' vv ]
template <class L>
struct Inertia {
  Symmetric3<L> ww;
  Columns3<L> wv;
  Symmetric3<L> vv;
};

// What children add to their parent.
template <class L>
struct Folded {
  Inertia<L> inertia;
  Six<L> bias;
};

// World axes about the common point O, unless said otherwise.  Nothing but L:
// TWINBUS_LANE_FIELD counts on it.
template <class L>
struct alignas(64) LinkLanes {
  // What never changes.
  Columns3<L> placed;     // axes of the joint in the parent's; used where a rank is turned
  Three<L> offset;        // of the joint, in the parent's axes
  Three<L> joint_axis;    // in the link's axes
  Three<L> com;           // in the link's axes
  Symmetric3<L> inertia;  // about com, link axes
  L mass, rotor;
  L slides;  // 1: the joint is prismatic, else 0
  // As placed.
  Columns3<L> rotation;  // link axes in world
  Three<L> origin, center;
  Six<L> velocity;        // V
  Six<L> axis;            // S
  Six<L> coriolis;        // c = V x S qd
  Symmetric3<L> turning;  // inertia about O: of wv and vv it is mass times center, and mass
  Six<L> bias;            // gyroscopic forces, minus gravity, pushes and contacts
  // Of the sweeps.
  Six<L> inertia_axis;  // U = articulated inertia times S
  L inverse_d;          // 1 / D
  L u;                  // torque - S' bias
  L qdd;
  Six<L> acceleration;  // a
};

// The place of a member of LinkLanes, counted in L.
#define TWINBUS_LANE_FIELD(member) (offsetof(twinbus::LinkLanes<double>, member) / sizeof(double))

inline constexpr int kMostLanes = 4;

// Links side by side.
struct Rank {
  int link[kMostLanes] = {-1, -1, -1, -1};
  int parent[kMostLanes] = {};  // rank times the number of lanes plus lane
  int parents = -1;             // the rank in which all of them are, in the same lanes; else -1
  bool leaf = true;             // nothing hangs on it
  bool slides = false;          // there is a prismatic joint
  bool turned = false;          // a joint's axes are not its parent's
  bool touched = false;         // contacts have made its links stiff
  // The place in BodyLanes::folded of its articulated inertia; few are in use at once.
  int folded = -1;
  // The first of its parents' children to be folded in, from the last rank on: then its place is
  // theirs too, if parents says which.
  bool first[kMostLanes] = {};
};

// Link 0 alone, then the others, those with the longest chain behind them first.  parent: of each
// link, before it; -1 of link 0.
std::vector<Rank> side_by_side(const std::vector<int>& parent, int lanes);

template <class T>
struct alignas(64) Aligned {
  T value;
};

template <class L>
struct BodyLanes {
  static constexpr int kLanes = static_cast<int>(sizeof(L) / sizeof(double));
  std::vector<Rank> ranks;
  std::vector<LinkLanes<L>> links;  // by rank
  std::vector<Aligned<Folded<L>>> folded;
  std::vector<Aligned<Inertia<L>>> stiff;  // by rank: of contacts
  // Of the joints, by rank and lane.
  std::vector<double> angle, rate, sine, cosine, force, gain;
  std::vector<std::size_t> of_joint;  // where each joint is among these
  alignas(64) Six<L> momentum;        // of all links, about O; to be summed over lanes
  alignas(64) Three<L> moment;        // sum of mass times centre, about O
};

// What holds link 0 up is in lane 0 of a robot's ranks; N is L where each lane is a robot of its own.
template <class N>
struct RootFactors {
  bool floating = true;
  // Of link 0's articulated inertia: L, D and 1 / D of its L D L'.
  N root[6][6] = {}, root_d[6] = {}, root_inverse[6] = {};
  N root_bias[6] = {};
  N wrong = {};  // above 0: an inertia was not positive when it was last factored
};

// The same numbers, one link at a time.
struct LinkNumbers {
  double* first = nullptr;  // of all
  std::size_t stride = 1;   // between the members of a link
  std::vector<std::size_t> where;
  std::vector<int> parent;

  double* of(int link, std::size_t field) const noexcept {
    return first + where[static_cast<std::size_t>(link)] + field * stride;
  }
  Eigen::Vector3d three(int link, std::size_t field) const noexcept {
    const double* x = of(link, field);
    return {x[0], x[stride], x[2 * stride]};
  }
  Screw screw(int link, std::size_t field) const noexcept {
    const double* x = of(link, field);
    return {Vec4{x[0], x[stride], x[2 * stride], 0.0},
            Vec4{x[3 * stride], x[4 * stride], x[5 * stride], 0.0}};
  }
};

// Of angles whose number is a multiple of four.
void find_sines(const std::vector<double>& angle, std::vector<double>& sine,
                std::vector<double>& cosine) noexcept;

// The numbers of a model's links in lanes whose ranks are set, and where they are: of several copies the last.
template <class L>
void fill(BodyLanes<L>& lanes, const Model& model, double mass_scale, LinkNumbers& to_links);

}  // namespace twinbus::sim
