#include "robot/onboarding/rest_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/collision/collision.h"
#include "lcmtypes/msg/guard_defaults.h"
#include "robot/collision/collision_pairs.h"
#include "robot/kinematics/kinematics.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus::inline robot {

namespace {

constexpr double kTouch = 1e-3;   // nearer counts as touching [m]
constexpr double kMargin = GuardDefaults::kInController;  // [m]
constexpr double kNear = 3.0 * kMargin;                   // at rest, of pairs that are so by design
constexpr double kOff = 0.01;         // by which each joint may end off the place foretold [rad]
constexpr double kOffSliding = 1e-3;  // [m]
constexpr double kLeastMargin = 0.003;  // [m]
constexpr int kFewJoints = 3;     // between links that are near by their makers' intent; on two limbs as many of each
constexpr double kSamePlace = 0.01;  // of a mirror image [m]
constexpr double kAlike = 0.05;      // of its mass
constexpr int kMostPairs = 4096;

int depth(const Model& model, int link) {
  int count = 0;
  for (; link > 0; link = model.links[at(link)].parent) ++count;
  return count;
}

int joints_between(const Model& model, int a, int b) {
  int count = 0;
  while (a != b) {
    int& later = depth(model, a) >= depth(model, b) ? a : b;
    later = model.links[at(later)].parent;
    ++count;
  }
  return count;
}

// By how much the pair comes together when all joints between are off by kOff towards it, to first order [m].
double play(const Model& model, const Kinematics& k, const PairDistance& pair) {
  double sum = 0.0;
  for (int j = 0; j < model.joint_count(); ++j) {
    if (!joint_moves_pair(model, j, pair.link_a, pair.link_b)) continue;
    const Eigen::Vector3d& axis = k.axis_in_world(j);
    const Eigen::Vector3d& point = joint_moves_pair(model, j, pair.link_a, -1) ? pair.point_a : pair.point_b;
    sum += model.joints[at(j)].kind == JointKind::kPrismatic
               ? kOffSliding * std::abs(pair.normal.dot(axis))
               : kOff * std::abs(pair.normal.dot(axis.cross(point - k.link_in_world(j + 1).translation())));
  }
  return sum;
}

// Calls use(kinematics, pair) for all pairs nearer than that, in each posture.
template <class Use>
void each_near(const Model& model, Collision& collision, const std::vector<Eigen::VectorXd>& postures, double nearer, Use use) {
  Configuration c(model);
  Kinematics k(model);
  std::vector<PairDistance> near(at(kMostPairs));
  for (const Eigen::VectorXd& q : postures) {
    c.q = q;
    k.update(c);
    const int count = collision.near_pairs(k, nearer, near.data(), kMostPairs);
    for (int i = 0; i < count; ++i) use(k, near[at(i)]);
  }
}

}  // namespace

std::vector<int> mirror_images(const Model& model) {
  const Kinematics k = at_rest(model);
  std::vector<int> images(model.links.size(), -1);
  for (int a = 0; a < model.link_count(); ++a) {
    const Eigen::Vector3d com = k.com_of_link(a);
    const Eigen::Vector3d image(com.x(), -com.y(), com.z());
    double nearest = kSamePlace;
    for (int b = 0; b < model.link_count(); ++b) {
      const double mass = model.links[at(a)].mass, other = model.links[at(b)].mass;
      if (depth(model, a) != depth(model, b) || std::abs(mass - other) > kAlike * std::max(mass, other)) continue;
      const double off = (k.com_of_link(b) - image).norm();
      if (!(off < nearest)) continue;
      nearest = off;
      images[at(a)] = b;
    }
  }
  return images;
}

std::string exempted(const Model& model, const RestPair& pair) {
  return "  <disable_collisions link1=\"" + xml_escaped(model.links[at(pair.link_a)].name) + "\" link2=\"" +
         xml_escaped(model.links[at(pair.link_b)].name) + "\" reason=\"" + xml_escaped(pair.why) + "\"/>\n";
}

std::vector<RestPair> pairs_at_rest(const Model& model, const std::vector<Eigen::VectorXd>& postures) {
  Collision collision(model);
  std::map<std::pair<int, int>, double> least;
  each_near(model, collision, postures, kMargin, [&](const Kinematics&, const PairDistance& near) {
    const std::pair<int, int> pair{near.link_a, near.link_b};
    if (!(near.distance < kTouch) && joints_between(model, pair.first, pair.second) > kFewJoints) return;
    const auto [known, fresh] = least.emplace(pair, near.distance);
    if (!fresh) known->second = std::min(known->second, near.distance);
  });
  std::vector<RestPair> pairs;
  for (const auto& [pair, distance] : least) {
    std::string why;
    if (distance < kTouch) {
      why = "touch in a proposed posture";
    } else {
      why = formatted("%.1f mm apart at rest, %d joints between them", 1e3 * distance,
                      joints_between(model, pair.first, pair.second));
    }
    pairs.push_back({pair.first, pair.second, why});
  }
  const std::vector<int> images = mirror_images(model);
  const auto checked = [&](int a, int b) {
    return std::any_of(collision.pairs().begin(), collision.pairs().end(), [&](const CollisionPair& p) {
      return (p.link_a == a && p.link_b == b) || (p.link_a == b && p.link_b == a);
    });
  };
  for (const auto& [pair, distance] : least) {
    const int a = images[at(pair.first)], b = images[at(pair.second)];
    if (a < 0 || b < 0 || !checked(a, b) || least.contains({std::min(a, b), std::max(a, b)})) continue;
    pairs.push_back({std::min(a, b), std::max(a, b),
                     "mirror image of " + model.links[at(pair.first)].name + ", " + model.links[at(pair.second)].name});
  }
  return pairs;
}

std::vector<NearByDesign> pairs_near_by_design(const Model& model, const std::vector<Eigen::VectorXd>& postures,
                                               const std::vector<RestPair>& left_out) {
  Collision collision(model);
  struct Seen {
    double distance = kNear, play = 0.0;
  };
  std::map<std::pair<int, int>, Seen> seen;
  each_near(model, collision, postures, kNear, [&](const Kinematics& k, const PairDistance& pair) {
    Seen& s = seen[{pair.link_a, pair.link_b}];
    s.distance = std::min(s.distance, pair.distance);
    s.play = std::max(s.play, play(model, k, pair));
  });
  for (const RestPair& pair : left_out) seen.erase({pair.link_a, pair.link_b});
  std::erase_if(seen, [&](const auto& of) {
    return joints_between(model, of.first.first, of.first.second) > 2 * kFewJoints;
  });
  std::vector<NearByDesign> pairs;
  for (const auto& [pair, s] : seen) {
    const double margin = std::ceil(1e3 * std::max(s.play, kLeastMargin)) * 1e-3;
    if (!(margin < kMargin)) continue;
    const std::string why = formatted("%.1f mm apart at rest; joints that end %.2f rad off move them by %.1f mm",
                                      1e3 * s.distance, kOff, 1e3 * s.play);
    pairs.push_back({pair.first, pair.second, margin, why});
  }
  return pairs;
}

}  // namespace twinbus::robot
