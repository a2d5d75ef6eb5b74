#include "control/teleop/hand_target.h"

namespace twinbus::inline control {

namespace {
constexpr double kIdle = 0.001;                // a wish no further than this asks for nothing [m]
constexpr double kNearTurn = 0.005;            // [rad]
constexpr double kLead = 0.15;                 // the wish is never further from the hand [m]
constexpr double kLeadTurn = 0.5;              // [rad]
constexpr std::int64_t kGoalAgainNs = 60'000'000;  // the same goal once more
constexpr std::int64_t kPatienceNs = 3'000'000'000;  // with a planner that does not answer
constexpr std::int64_t kLongestNs = 10'000'000'000;  // of one short way
constexpr std::int64_t kHandFreshNs = 2'000'000'000;     // then a wish begins anew where the hand is
constexpr int kCancels = 5;
constexpr float kSpeed = 0.4F;  // share of the joints' velocity limits
}  // namespace

void HandTarget::finish(Phase phase, std::int64_t now_ns) noexcept {
  phase_ = phase;
  idle_ns_ = now_ns;
  moving_ = arrived_ = false;
  path_id_ = 0;
}

void HandTarget::choose(ArmSide side) noexcept {
  if (side == side_) return;
  stop();
  side_ = side;
}

void HandTarget::move(const Eigen::Vector3d& by, const Eigen::Vector3d& turn, const Eigen::Isometry3d& hand) noexcept {
  if (!by.allFinite() || !turn.allFinite() || !hand.matrix().allFinite()) return;
  if (by.isZero(0.0) && turn.isZero(0.0)) return;
  const Eigen::Vector3d place = hand.translation();
  const Eigen::Quaterniond at(hand.linear());
  const bool idle = phase_ == Phase::kIdle || phase_ == Phase::kRefused;
  if (!begun_ || (idle && now_ns_ - idle_ns_ > kHandFreshNs)) wanted_ = asked_ = reached_ = place;
  if (!begun_ || !turned_) wanted_turn_ = asked_turn_ = reached_turn_ = at;
  begun_ = true;
  wanted_ += by;
  const Eigen::Vector3d lead = wanted_ - place;
  if (lead.norm() > kLead) wanted_ = place + kLead / lead.norm() * lead;
  if (turn.isZero(0.0)) return;
  turned_ = true;
  const double angle = turn.norm();
  const Eigen::Quaterniond wish = (Eigen::AngleAxisd(angle, turn / angle) * wanted_turn_).normalized();
  const double ahead = at.angularDistance(wish);
  wanted_turn_ = ahead > kLeadTurn ? at.slerp(kLeadTurn / ahead, wish) : wish;
}

void HandTarget::stop() noexcept {
  if (phase_ == Phase::kAsked || phase_ == Phase::kGoing) cancels_left_ = kCancels;
  begun_ = turned_ = turn_reached_ = false;
  finish(Phase::kIdle, now_ns_);
}

void HandTarget::on_path(const ArmPathPiece& piece) noexcept {
  if (phase_ != Phase::kAsked || piece.goal_id != goal_id_) return;
  if (piece.status == ArmPathStatus::kOk) {
    phase_ = Phase::kGoing;
    path_id_ = piece.path_id;
    moving_ = arrived_ = false;
    return;
  }
  refusal_ = piece.status;
  unanswered_ = false;
  touching_ = {piece.link_a, piece.link_b};
  miss_ = static_cast<double>(piece.miss);
  oriented_ = turned_;
  wanted_ = asked_ = reached_;
  wanted_turn_ = asked_turn_ = reached_turn_;
  turned_ = turned_ && turn_reached_;  // an arm that cannot turn its hand still moves it
  finish(Phase::kRefused, now_ns_);
}

void HandTarget::on_status(const ControllerStatus& status) noexcept {
  if (phase_ != Phase::kGoing) return;
  const bool ours = status.arm_path_id == path_id_;
  if (ours) moving_ = true;
  if (moving_ && !ours) arrived_ = true;
}

bool HandTarget::next(std::int64_t now_ns, std::int64_t run_id, std::int64_t new_id,
                      ArmGoal& goal) noexcept {
  now_ns_ = now_ns;
  goal.run_id = run_id;
  goal.side = side_;
  goal.speed = kSpeed;
  goal.goal_id = goal_id_;
  if (cancels_left_ > 0) {
    --cancels_left_;
    goal.kind = ArmGoalKind::kCancel;
    goal.sequence = ++sequence_;
    return true;
  }
  goal.kind = turned_ ? ArmGoalKind::kPose : ArmGoalKind::kPosition;
  if (phase_ == Phase::kGoing && arrived_) {
    reached_ = asked_;
    reached_turn_ = asked_turn_;
    turn_reached_ = turned_;
    finish(Phase::kIdle, now_ns);
  }
  if (phase_ == Phase::kAsked && now_ns - asked_ns_ > kPatienceNs) {
    refusal_ = ArmPathStatus::kTimeLimit;
    unanswered_ = true;
    begun_ = false;
    finish(Phase::kRefused, now_ns);
  }
  const std::int64_t longest = moving_ ? kLongestNs : kPatienceNs;  // a path may not be followed
  if (phase_ == Phase::kGoing && now_ns - asked_ns_ > longest) stop();
  const bool idle = phase_ == Phase::kIdle || phase_ == Phase::kRefused;
  const bool elsewhere = (wanted_ - asked_).norm() > kIdle || (turned_ && wanted_turn_.angularDistance(asked_turn_) > kNearTurn);
  const bool wants = begun_ && idle && elsewhere;
  const bool again = phase_ == Phase::kAsked && now_ns - sent_ns_ >= kGoalAgainNs;
  if (!wants && !again) return false;
  if (wants) {
    asked_ = wanted_;
    asked_turn_ = wanted_turn_;
    asked_ns_ = now_ns;
    goal_id_ = new_id;
    phase_ = Phase::kAsked;
  }
  sent_ns_ = now_ns;
  goal.goal_id = goal_id_;
  goal.sequence = ++sequence_;
  for (std::size_t k = 0; k < 3; ++k) goal.position[k] = asked_[static_cast<Eigen::Index>(k)];
  if (turned_) goal.orientation = {asked_turn_.w(), asked_turn_.x(), asked_turn_.y(), asked_turn_.z()};
  return true;
}

}  // namespace twinbus::control
