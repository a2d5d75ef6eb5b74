// Ties as joints of ODE: a ball joint for points held together, a double ball for a distance, soft
// as the tie says.  A row with ERP = h k / (h k + c) and CFM = 1 / (h k + c) is a spring and damper
// by backward Euler.

#include "sim/engine/ode_world.h"
#include "sim/contact/ties.h"

namespace twinbus::inline sim {

void OdeWorld::add_ties(const std::vector<Tie>& tied) {
  for (const Tie& tie : tied) {
    const double gain = h_ * tie.stiffness + tie.damping;
    const bool point = tie.length < 0.0;
    const dJointID joint =
        point ? dJointCreateBall(world_, nullptr) : dJointCreateDBall(world_, nullptr);
    dJointAttach(joint, body_of(tie.a), body_of(tie.b));
    if (point) {
      dJointSetBallParam(joint, dParamERP, h_ * tie.stiffness / gain);
      dJointSetBallParam(joint, dParamCFM, 1.0 / gain);
    } else {
      dJointSetDBallParam(joint, dParamERP, h_ * tie.stiffness / gain);
      dJointSetDBallParam(joint, dParamCFM, 1.0 / gain);
    }
    ties_.push_back({tie, joint});
    join(ties_.size() - 1);
    if (!tie.holds) dJointDisable(joint);
  }
  tie_feedback_.resize(ties_.size());
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    dJointSetFeedback(ties_[i].joint, &tie_feedback_[i]);
  }
}

// By where the bodies are: the kinematics may be of another time.
Eigen::Vector3d OdeWorld::place_of(const TieEnd& end) const noexcept {
  const dBodyID id = body_of(end);
  if (id == nullptr) {
    return end.link >= 0 ? Eigen::Vector3d(robot_of(end).configuration.base * end.point)
                         : end.point;
  }
  Eigen::Vector3d inside = end.point;
  if (end.link >= 0) inside -= robot_of(end).com_in_link[static_cast<std::size_t>(end.link)];
  dVector3 point;
  dBodyGetRelPointPos(id, inside.x(), inside.y(), inside.z(), point);
  return vector(point);
}

void OdeWorld::join(std::size_t index) noexcept {
  const TieJoint& own = ties_[index];
  const Eigen::Vector3d a = place_of(own.tie.a), b = place_of(own.tie.b);
  if (own.tie.length < 0.0) {
    dJointSetBallAnchor(own.joint, a.x(), a.y(), a.z());
    // The second anchor is taken as it is: in the body's own axes.
    dVector3 inside = {b.x(), b.y(), b.z(), 0.0};
    if (const dBodyID id = dJointGetBody(own.joint, 1); id != nullptr) {
      dBodyGetPosRelPoint(id, b.x(), b.y(), b.z(), inside);
    }
    dJointSetBallAnchor2(own.joint, inside[0], inside[1], inside[2]);
  } else {
    dJointSetDBallAnchor1(own.joint, a.x(), a.y(), a.z());
    dJointSetDBallAnchor2(own.joint, b.x(), b.y(), b.z());
    dJointSetDBallDistance(own.joint, own.tie.length);
  }
}

Status OdeWorld::hold(int tie, bool holds) noexcept {
  if (tie < 0 || tie >= static_cast<int>(ties_.size())) return Status::kWrongSize;
  TieJoint& own = ties_[static_cast<std::size_t>(tie)];
  own.tie.holds = holds;
  if (!holds) {
    dJointDisable(own.joint);
    return Status::kOk;
  }
  const Eigen::Vector3d a = place_of(own.tie.a);
  const TieEnd& to = own.tie.b;
  const dBodyID id = body_of(to);
  Eigen::Vector3d& point = own.tie.b.point;
  if (id == nullptr) {
    point = to.link >= 0 ? Eigen::Vector3d(robot_of(to).configuration.base.inverse() * a) : a;
  } else {
    dVector3 inside;
    dBodyGetPosRelPoint(id, a.x(), a.y(), a.z(), inside);
    point = vector(inside);
    if (to.link >= 0) point += robot_of(to).com_in_link[static_cast<std::size_t>(to.link)];
  }
  join(static_cast<std::size_t>(tie));
  dJointEnable(own.joint);
  return Status::kOk;
}

void OdeWorld::read_tie_forces() noexcept {
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    const Tie& tie = ties_[i].tie;
    if (!tie.holds) continue;
    const Eigen::Vector3d point = place_of(tie.a);
    const auto feel = [&](const TieEnd& end, const dReal* force) {
      if (end.link < 0 || end.robot >= 0 ||
          contacts_.size() >= static_cast<std::size_t>(kMaxContacts))
        return;
      contacts_.push_back({.link = end.link,
                          .sole = -1,
                          .point = point,
                          .force = vector(force),
                          .depth = 0.0,
                          .tie = true});
    };
    feel(tie.a, tie_feedback_[i].f1);
    feel(tie.b, tie_feedback_[i].f2);
  }
}

}  // namespace twinbus::sim
