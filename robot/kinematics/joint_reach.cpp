#include "robot/kinematics/joint_reach.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/math/index.h"

namespace twinbus::inline robot {

namespace {
constexpr double kRounding = 1e-6;  // of a sine
}

JointReach::JointReach(const Model& model, const std::vector<double>& radius)
    : joints_(model.joint_count()),
      reach_(model.links.size() * model.joints.size(), 0.0),
      radius_(radius),
      length_(model.links.size(), 0.0),
      sums_(model.links.size()) {
  for (const Link& link : model.links) parent_.push_back(link.parent);
  for (const Joint& joint : model.joints)
    slides_.push_back(joint.kind == JointKind::kPrismatic ? 1 : 0);
  for (int link = 1; link < model.link_count(); ++link) {
    const Joint& joint = model.joints[at(link - 1)];
    length_[at(link)] = length_[at(joint.parent)] + joint.placement.translation().norm();
    if (joint.kind == JointKind::kPrismatic)
      length_[at(link)] += std::max(std::abs(joint.lower), std::abs(joint.upper));
  }
  for (int link = 0; link < model.link_count(); ++link) {
    double length = radius[at(link)];
    if (!(length > 0.0)) continue;
    double* row = &reach_[at(link) * model.joints.size()];
    for (int child = link; child > 0; child = model.links[at(child)].parent) {
      const Joint& joint = model.joints[at(child - 1)];
      const bool slides = joint.kind == JointKind::kPrismatic;
      row[child - 1] = slides ? 1.0 : length;
      length += joint.placement.translation().norm();
      if (slides) length += std::max(std::abs(joint.lower), std::abs(joint.upper));
    }
  }
}

double JointReach::farthest(int joint) const noexcept {
  double most = 0.0;
  for (std::size_t i = at(joint); i < reach_.size(); i += at(joints_))
    most = std::max(most, reach_[i]);
  return most;
}

// Calls with every joint that moves one of the links against the other, from the outermost on, with
// its reach and which link it moves.  Parents come before their children, so the later of two links
// is never on the way to the other.
template <class Visit>
void JointReach::climb(int link_a, int link_b, Visit visit) const noexcept {
  int now[2] = {std::max(link_a, 0), std::max(link_b, 0)};
  const double* row[2];
  for (int k = 0; k < 2; ++k) row[k] = reach_.data() + std::ptrdiff_t{now[k]} * joints_;
  while (now[0] != now[1]) {
    const int k = now[0] > now[1] ? 0 : 1;
    const int joint = now[k] - 1;
    visit(joint, row[k][joint], k);
    now[k] = parent_[at(now[k])];
  }
}

double JointReach::between(int link_a, int link_b, const Eigen::VectorXd& moves) const noexcept {
  double sum = 0.0;
  climb(link_a, link_b, [&](int joint, double reach, int) { sum += moves[joint] * reach; });
  return sum;
}

// The sum of moves x reach is the length to the end of the link times one sum over the joints, less another.
void JointReach::from_base(const Eigen::VectorXd& moves, std::vector<double>& of_links) noexcept {
  const double* move = moves.data();
  for (std::size_t link = 1; link < sums_.size(); ++link, ++move) {
    Sums& sums = sums_[link];
    sums = sums_[at(parent_[link])];
    if (slides_[link - 1] != 0) {
      sums.less -= *move;
    } else {
      sums.turned += *move;
      sums.less += *move * length_[link];
    }
    of_links[link] = (radius_[link] + length_[link]) * sums.turned - sums.less;
  }
}

double JointReach::along(const Eigen::Vector3d& n, const Kinematics& kinematics, int link_a,
                         int link_b, const Eigen::VectorXd& moves) const noexcept {
  const auto turns = [&](int joint) { return slides_[at(joint)] != 0 ? 0.0 : moves[joint]; };
  double turn[2] = {};  // of the joints not yet passed
  climb(link_a, link_b, [&](int joint, double, int k) { turn[k] += turns(joint); });
  double sum = 0.0;
  climb(link_a, link_b, [&](int joint, double reach, int k) {
    turn[k] = std::max(0.0, turn[k] - turns(joint));
    const double cosine = n.dot(kinematics.axis_in_world(joint));
    const double across = slides_[at(joint)] != 0 ? std::abs(cosine)
                                                  : std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    sum += moves[joint] * reach * std::min(1.0, across + turn[k] + kRounding);
  });
  return sum;
}

}  // namespace twinbus::robot
