#include "sim/contact/ties.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace twinbus::inline sim {

namespace {

constexpr double kShortest = 1e-9;  // of a spring that has a direction [m]

bool can_move(const TieEnd& end, const WorldConfig& config) {
  const bool fixed = end.robot < 0 ? config.fixed_base
                                   : !config.robots[at(end.robot)].model->floating_base;
  return end.loose >= 0 || end.link > 0 || (end.link == 0 && !fixed);
}

}  // namespace

// Kept as the contacts are: system -1 is the world.
struct Ties::End {
  int system = -1, link = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();   // world
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // of its body's common point
  Screw velocity = {};
  bool central = false;  // its acceleration is that of its centre, not without w x v

  // Velocity of what is at a place of the world and moves with this end; its acceleration by the
  // velocities alone.
  Eigen::Vector3d velocity_at(const Eigen::Vector3d& at) const {
    return at_point(velocity, at - origin);
  }
  Eigen::Vector3d bias_at(const Eigen::Vector3d& at) const {
    const Eigen::Vector3d w = angular(velocity);
    return w.cross(central ? Eigen::Vector3d(w.cross(at - origin)) : velocity_at(at));
  }
};

std::vector<Tie> checked_ties(const Model& model, const WorldConfig& config) {
  std::vector<Tie> ties = config.ties;
  for (std::size_t i = 0; i < ties.size(); ++i) {
    Tie& tie = ties[i];
    std::string name = "tie ";
    name += std::to_string(i);
    for (const TieEnd* end : {&tie.a, &tie.b}) {
      const bool known = end->robot < static_cast<int>(config.robots.size());
      const Model& of = known && end->robot >= 0 ? *config.robots[at(end->robot)].model : model;
      if (!known || end->link >= of.link_count() ||
          end->loose >= static_cast<int>(config.loose.size()) || !end->point.allFinite()) {
        throw std::runtime_error(name + ": there is no such end");
      }
    }
    if (!can_move(tie.a, config)) std::swap(tie.a, tie.b);
    if (!can_move(tie.a, config) || (tie.a.loose == tie.b.loose && tie.a.link == tie.b.link &&
                                     tie.a.robot == tie.b.robot)) {
      throw std::runtime_error(name + " ties nothing that moves to something else");
    }
    if (!(tie.stiffness > 0.0) || !(tie.damping >= 0.0) || !std::isfinite(tie.stiffness) ||
        !std::isfinite(tie.damping)) {
      throw std::runtime_error(name + ": its stiffness must be positive, its damping not negative");
    }
  }
  return ties;
}

Ties::Ties(const Model& model, const WorldConfig& config)
    : first_robot_(static_cast<int>(config.loose.size()) + 1) {
  for (const Tie& tie : checked_ties(model, config)) ties_.push_back({tie});
}

int Ties::system_of(const TieEnd& end) const noexcept {
  return end.robot >= 0 ? first_robot_ + end.robot : end.loose + 1;
}

Ties::End Ties::placed(const TieEnd& end,
                       const std::vector<ArticulatedBody*>& systems) const noexcept {
  End placed;
  placed.point = end.point;
  if (end.link < 0 && end.loose < 0) return placed;
  placed.central = end.loose >= 0;
  placed.system = system_of(end);
  placed.link = end.loose >= 0 ? 0 : end.link;
  const ArticulatedBody& body = *systems[at(placed.system)];
  const LinkNow link = body.link(placed.link);
  placed.origin = body.origin();
  placed.velocity = link.velocity;
  placed.point = placed.origin + link.origin + link.rotation * end.point;
  if (placed.link == 0 && !body.floating()) placed.system = -1;
  return placed;
}

void Ties::find(const std::vector<ArticulatedBody*>& systems, double h,
                std::vector<Contact>& contacts) const noexcept {
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    const Tie& tie = ties_[i].tie;
    if (!tie.holds || contacts.size() >= contacts.capacity()) continue;
    const End a = placed(tie.a, systems), b = placed(tie.b, systems);
    Contact& c = contacts.emplace_back();
    c.tie = tie.length < 0.0 ? TieKind::kPoint : TieKind::kLength;
    c.system = a.system;
    c.link = a.link;
    c.other_system = b.system;
    c.other = b.system < 0 ? -1 : b.link;
    c.key = -2 - static_cast<int>(i);
    c.params.stiffness = c.params.tangent_stiffness = tie.stiffness;
    c.params.damping = c.params.tangent_damping = tie.damping;
    c.point = a.point;
    c.r = a.point - a.origin;
    c.other_r = a.point - b.origin;
    c.depth = 1.0;
    c.normal = Eigen::Vector3d::UnitZ();
    c.guess = ties_[i].force;
    c.stretch = a.point - b.point;
    const Eigen::Vector3d v = a.velocity_at(a.point) - b.velocity_at(a.point);
    Eigen::Vector3d bias = a.bias_at(a.point) - b.bias_at(a.point);
    if (c.tie == TieKind::kLength) {
      // Both ends on one line of action: the force does not care which of its points it acts at.
      const double apart = c.stretch.norm();
      if (apart > kShortest) c.normal = c.stretch / apart;
      const Eigen::Vector3d ends = a.velocity_at(a.point) - b.velocity_at(b.point);
      const double along = c.normal.dot(v);
      bias = a.bias_at(a.point) - b.bias_at(b.point);
      bias = c.normal * (c.normal.dot(bias) +
                         (apart > kShortest ? (ends.squaredNorm() - along * along) / apart : 0.0));
      c.stretch -= tie.length * c.normal;
    }
    c.v0 = v + h * bias;
    c.stretch -= 0.5 * h * h * bias;
  }
}

void Ties::remember(const std::vector<Contact>& contacts) noexcept {
  for (const Contact& c : contacts) {
    if (c.tie != TieKind::kNone) ties_[at(-2 - c.key)].force = c.now.force;
  }
}

Status Ties::hold(int tie, bool holds, const std::vector<ArticulatedBody*>& systems) noexcept {
  if (tie < 0 || tie >= count()) return Status::kWrongSize;
  Own& own = ties_[at(tie)];
  own.force.setZero();
  own.tie.holds = holds;
  if (!holds) return Status::kOk;
  const TieEnd& to = own.tie.b;
  const Eigen::Vector3d point = placed(own.tie.a, systems).point;
  if (to.link < 0 && to.loose < 0) {
    own.tie.b.point = point;
  } else {
    const ArticulatedBody& body = *systems[at(system_of(to))];
    const LinkNow link = body.link(to.loose >= 0 ? 0 : to.link);
    own.tie.b.point = link.rotation.transpose() * (point - body.origin() - link.origin);
  }
  return Status::kOk;
}

}  // namespace twinbus::sim
