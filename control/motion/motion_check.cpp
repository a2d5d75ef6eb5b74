#include "control/motion/motion_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "control/legs/whole_body_ik.h"
#include "control/legs/wrench_share.h"
#include "robot/collision/collision.h"
#include "robot/collision/near_pairs.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/dynamics/pair_torque.h"
#include "robot/estimation/support_polygon.h"
#include "robot/kinematics/leg_chain.h"

namespace twinbus::inline control {

namespace {

constexpr double kRounding = 1e-4;   // of a limit that was written with few digits [rad, m]
constexpr double kNoNearer = 0.001;  // two links that are near while the robot stands [m]
constexpr double kSeen = 0.05;       // nearest links are told of from here on [m]
constexpr int kPlaces = 24;          // of the ways to the first frame and back
constexpr int kMostPairs = 32;
constexpr int kRounds = 4;           // of the inverse kinematics
constexpr double kMiss = 0.005;      // that the legs may be off [m, rad]
constexpr double kOnGround = 0.02;   // of a recorded sole above the lowest [m]
constexpr double kNearlyFlat = 0.2;  // of a recorded sole that stands [rad]
constexpr double kTold = 0.05;       // two faults of one thing with less between them are one [s]

// Faults of one thing in a row become one.
class Faults {
 public:
  explicit Faults(std::int64_t gap) : gap_(gap) {}
  // excess: how much worse than the limit, to find the worst.
  void add(FaultKind kind, std::int64_t tick, const std::string& what, double value, double limit,
           double excess) {
    for (Open& open : open_) {
      MotionFault& fault = faults_[open.index];
      if (fault.kind != kind || fault.what != what || tick - fault.last_tick > gap_) continue;
      fault.last_tick = tick;
      if (excess > open.excess) {
        open.excess = excess;
        fault.value = value;
        fault.limit = limit;
        fault.worst_tick = tick;
      }
      return;
    }
    std::erase_if(open_,
                  [&](const Open& open) { return tick - faults_[open.index].last_tick > gap_; });
    open_.push_back({faults_.size(), excess});
    faults_.push_back({kind, tick, tick, tick, what, value, limit});
  }
  std::vector<MotionFault> take() {
    std::stable_sort(faults_.begin(), faults_.end(),
                     [](const auto& a, const auto& b) { return a.tick < b.tick; });
    return std::move(faults_);
  }

 private:
  struct Open {
    std::size_t index;
    double excess;
  };
  std::int64_t gap_;
  std::vector<Open> open_;
  std::vector<MotionFault> faults_;
};

class Check {
 public:
  Check(const Model& model, const MotionClip& motion, const MotionCheckConfig& config)
      : model_(model),
        torque_(model),
        motion_(motion),
        config_(config),
        faults_(std::max<std::int64_t>(1, std::llround(kTold / model.period()))),
        every_(std::max<std::int64_t>(1, std::llround(config.every / model.period()))),
        collision_(model),
        shares_(model),
        kinematics_(model),
        dynamics_(model),
        tau_(Eigen::VectorXd::Zero(model.joint_count())),
        qdd_(tau_) {
    stands_ = model.floating_base && model.soles[0].link >= 0 && model.soles[1].link >= 0;
    const bool legs = stands_ && leg_chain(model, 0).balances() && leg_chain(model, 1).balances();
    if (legs && !config.as_recorded) ik_.emplace(model);
    kinematics_.update(motion.standing());
    home_ = kinematics_.com();
    for (std::size_t f = 0; f < 2 && stands_; ++f)
      soles_[f] = kinematics_.link_in_world(model.soles[f].link) * model.soles[f].frame;
    near_count_ = collision_.near_pairs(kinematics_, kSeen, standing_pairs_.data(), kMostPairs);
  }

  MotionVerdict run() {
    verdict_.ticks = std::llround(motion_.duration() / model_.period()) + 1;
    verdict_.nearest = kSeen;
    verdict_.least_margin = 1e9;
    const std::int64_t mask = config_.as_recorded ? motion_.named() : motion_.mask();
    if (!config_.as_recorded) look_on_way(motion_.at_time(0.0).q);
    for (std::int64_t tick = 0; tick < verdict_.ticks; ++tick) look_at_limits(tick, mask);
    if (!config_.as_recorded) look_on_way(motion_.at_time(motion_.duration()).q);
    if (ik_) ik_->start(motion_.standing());
    std::array<Configuration, 3> place;
    for (std::int64_t i = 0; i * every_ < verdict_.ticks + every_; ++i) {
      const std::int64_t tick = std::min(i * every_, verdict_.ticks - 1);
      place[0] = place[1];
      place[1] = place[2];
      place[2] = configuration(tick);
      if (i * every_ < verdict_.ticks) look_at_links(place[2], tick);
      if (i >= 2) look_at_balance(place, (i - 1) * every_);
    }
    verdict_.balance_known = verdict_.least_margin < 1e8;
    verdict_.faults = faults_.take();
    return std::move(verdict_);
  }

 private:
  const std::string& joint_name(int k) const {
    return model_.joints[at(model_.bus_joints[at(k)])].name;
  }

  // Positions and speeds, from one tick to the next.
  void look_at_limits(std::int64_t tick, std::int64_t mask) {
    const double time = static_cast<double>(tick) * model_.period();
    MotionPoint point;
    if (config_.as_recorded) {
      Configuration a(model_), b(model_);
      motion_.as_recorded(time, a);
      motion_.as_recorded(std::min(time + motion_.period(), motion_.duration()), b);
      for (int k = 0; k < model_.bus_count(); ++k) {
        const int j = model_.bus_joints[at(k)];
        point.q[at(k)] = a.q[j];
        point.qd[at(k)] = (b.q[j] - a.q[j]) / motion_.period();
      }
    } else {
      point = motion_.at_time(time);
    }
    for (int k = 0; k < model_.bus_count(); ++k) {
      if ((mask >> k & 1) == 0) continue;
      const Joint& joint = model_.joints[at(model_.bus_joints[at(k)])];
      const double q = point.q[at(k)], qd = point.qd[at(k)];
      if (joint.kind != JointKind::kContinuous) {
        if (q > joint.upper + kRounding)
          faults_.add(FaultKind::kPosition, tick, joint.name, q, joint.upper, q - joint.upper);
        if (q < joint.lower - kRounding)
          faults_.add(FaultKind::kPosition, tick, joint.name, q, joint.lower, joint.lower - q);
      }
      double limit = joint.velocity;
      if (joint.rate > 0.0 && (joint.rate < limit || !(limit > 0.0))) limit = joint.rate;
      if (!(limit > 0.0)) continue;
      const double share = std::abs(qd) / limit;
      if (share > verdict_.speed_share) {
        verdict_.speed_share = share;
        verdict_.speed_joint = joint.name;
      }
      if (share > 1.0 + 1e-6)
        faults_.add(FaultKind::kSpeed, tick, joint.name, std::abs(qd), limit, share);
    }
  }

  // The whole robot at a tick.
  Configuration configuration(std::int64_t tick) {
    const double time = static_cast<double>(tick) * model_.period();
    Configuration c = motion_.standing();
    if (config_.as_recorded) {
      motion_.as_recorded(time, c);
      return c;
    }
    const MotionPoint point = motion_.at_time(time);
    for (int k = 0; k < model_.bus_count(); ++k) c.q[model_.bus_joints[at(k)]] = point.q[at(k)];
    set_mimics(model_, c);
    if (!ik_) return c;
    const Eigen::Matrix3d base = rotation_of(Eigen::Vector3d(point.tilt.x(), point.tilt.y(), 0.0)) *
                                 motion_.standing().base.linear();
    ik_->solve(home_ + point.com, base, soles_, c.q, tick == 0 ? 8 * kRounds : kRounds);
    if (!(ik_->error() < kMiss))
      faults_.add(FaultKind::kReach, tick, "legs", ik_->error(), kMiss, ik_->error());
    c.base = ik_->configuration().base;
    c.q = ik_->configuration().q;
    return c;
  }

  bool was_near(const PairDistance& pair) const {
    const auto end = standing_pairs_.begin() + near_count_;
    return std::any_of(standing_pairs_.begin(), end, [&](const PairDistance& p) {
      return p.link_a == pair.link_a && p.link_b == pair.link_b &&
             pair.distance > p.distance - kNoNearer;
    });
  }

  void look_at_links(const Configuration& c, std::int64_t tick) {
    kinematics_.update(c);
    std::array<PairDistance, kMostPairs> pairs;
    const int count = collision_.near_pairs(kinematics_, kSeen, pairs.data(), kMostPairs);
    for (int i = 0; i < count; ++i) {
      const PairDistance& pair = pairs[at(i)];
      if (was_near(pair)) continue;
      const std::string name =
          model_.links[at(pair.link_a)].name + " / " + model_.links[at(pair.link_b)].name;
      if (pair.distance < verdict_.nearest) {
        verdict_.nearest = pair.distance;
        verdict_.nearest_pair = name;
      }
      const double margin = config_.link_margin * shares_.of(pair.link_a, pair.link_b);
      if (pair.distance < margin) faults_.add(FaultKind::kTouch, tick, name, pair.distance, margin, -pair.distance);
    }
  }

  // From standing to a frame, straight in the joints.
  void look_on_way(const PerJoint<double>& to) {
    Configuration c = motion_.standing();
    for (int place = 0; place <= kPlaces; ++place) {
      const double share = static_cast<double>(place) / kPlaces;
      for (int k = 0; k < model_.bus_count(); ++k)
        c.q[model_.bus_joints[at(k)]] =
            motion_.stand()[at(k)] + share * (to[at(k)] - motion_.stand()[at(k)]);
      set_mimics(model_, c);
      look_at_links(c, -1);
    }
  }

  // Which soles stand, in the recorded world; false: none.
  bool find_support(SupportPolygon& polygon, double& ground) {
    polygon.clear();
    double lowest = 1e9;
    const auto frame = [&](std::size_t f) {
      return Eigen::Isometry3d(kinematics_.link_in_world(model_.soles[f].link) *
                               model_.soles[f].frame);
    };
    for (std::size_t f = 0; f < 2; ++f) lowest = std::min(lowest, frame(f).translation().z());
    ground = lowest;
    for (std::size_t f = 0; f < 2; ++f) {
      const Eigen::Isometry3d sole = frame(f);
      const bool flat = sole.linear()(2, 2) > std::cos(kNearlyFlat);
      if (config_.as_recorded && !(sole.translation().z() < lowest + kOnGround && flat)) continue;
      polygon.add(model_.soles[f], sole);
    }
    polygon.finish();
    return polygon.count() >= 3;
  }

  // The ground's push that the motion needs, where it acts, and what every joint does for it.
  void look_at_balance(const std::array<Configuration, 3>& place, std::int64_t tick) {
    const double h = static_cast<double>(every_) * model_.period();
    Configuration now = place[1];
    now.qd = (place[2].q - place[0].q) / (2.0 * h);
    now.base_velocity = (place[2].base.translation() - place[0].base.translation()) / (2.0 * h);
    now.base_angular_velocity =
        rotation_vector(place[2].base.linear() * place[0].base.linear().transpose()) / (2.0 * h);
    qdd_ = (place[2].q - 2.0 * place[1].q + place[0].q) / (h * h);
    const Eigen::Vector3d a = (place[2].base.translation() - 2.0 * place[1].base.translation() +
                               place[0].base.translation()) /
                              (h * h);
    const Eigen::Vector3d alpha =
        (rotation_vector(place[2].base.linear() * place[1].base.linear().transpose()) -
         rotation_vector(place[1].base.linear() * place[0].base.linear().transpose())) /
        (h * h);
    kinematics_.update(now);
    std::vector<ExternalWrench> none;
    const Eigen::Matrix<double, 6, 1> w =
        dynamics_.solve(kinematics_, now, qdd_, a, alpha, none, tau_);
    if (stands_) {
      SupportPolygon polygon;
      double ground = 0.0;
      const bool supported = find_support(polygon, ground);
      const Eigen::Vector3d origin = kinematics_.link_in_world(0).translation();
      const Eigen::Vector3d force = w.head<3>(), torque = w.tail<3>();
      if (!supported || !(force.z() > 1.0)) {
        if (config_.as_recorded || !(force.z() > 1.0))
          faults_.add(FaultKind::kBalance, tick,
                      supported ? "leaves the ground" : "no sole stands flat", 0.0,
                      config_.zmp_margin, 1.0);
        return;
      }
      // Of the wrench about the base, where on the ground it has no torque about x and y.
      const double below = ground - origin.z();
      const Eigen::Vector2d zmp =
          origin.head<2>() + Eigen::Vector2d((-torque.y() + below * force.x()) / force.z(),
                                             (torque.x() + below * force.y()) / force.z());
      const double margin = polygon.margin(zmp);
      verdict_.least_margin = std::min(verdict_.least_margin, margin);
      if (margin < config_.zmp_margin)
        faults_.add(FaultKind::kBalance, tick, "zero-moment point", margin, config_.zmp_margin,
                    -margin);
      if (!config_.as_recorded) share_wrench(now, a, alpha, zmp, force);
    }
    if (stands_ && config_.as_recorded) return;  // who carries what is not known
    for (int k = 0; k < model_.bus_count(); ++k) {
      const Joint& joint = model_.joints[at(model_.bus_joints[at(k)])];
      if (!(joint.effort > 0.0)) continue;
      const double share = torque_.share(model_.bus_joints[at(k)], now.q, tau_);
      if (share > verdict_.effort_share) {
        verdict_.effort_share = share;
        verdict_.effort_joint = joint.name;
      }
      if (share > 1.0)
        faults_.add(FaultKind::kEffort, tick, joint.name, share * joint.effort, joint.effort,
                    share);
    }
  }

  // As the balance controller shares it.
  void share_wrench(const Configuration& now, const Eigen::Vector3d& a,
                    const Eigen::Vector3d& alpha, const Eigen::Vector2d& zmp,
                    const Eigen::Vector3d& force) {
    std::array<SoleOnGround, 2> soles;
    std::array<Eigen::Isometry3d, 2> frame;
    for (std::size_t f = 0; f < 2; ++f) {
      const Sole& sole = model_.soles[f];
      frame[f] = kinematics_.link_in_world(sole.link) * sole.frame;
      soles[f] = {.position = frame[f].translation().head<2>(),
                  .yaw = yaw_of(frame[f].linear()),
                  .front = sole.front,
                  .back = sole.back,
                  .left = sole.left,
                  .right = sole.right};
    }
    const ZmpShare share = share_zmp(soles, zmp, 0.0, 0.0);
    std::vector<ExternalWrench> wrench(2);
    for (std::size_t f = 0; f < 2; ++f) {
      wrench[f].link = model_.soles[f].link;
      wrench[f].point = frame[f] * Eigen::Vector3d(share.cop[f].x(), share.cop[f].y(), 0.0);
      wrench[f].force = (f == 0 ? share.left : 1.0 - share.left) * force;
    }
    (void)dynamics_.solve(kinematics_, now, qdd_, a, alpha, wrench, tau_);
  }

  const Model& model_;
  PairTorque torque_;
  const MotionClip& motion_;
  const MotionCheckConfig& config_;
  Faults faults_;
  std::int64_t every_;
  Collision collision_;
  MarginShares shares_;
  Kinematics kinematics_;
  InverseDynamics dynamics_;
  std::optional<WholeBodyIk> ik_;
  Eigen::VectorXd tau_, qdd_;
  bool stands_ = false;
  Eigen::Vector3d home_ = Eigen::Vector3d::Zero();
  std::array<Eigen::Isometry3d, 2> soles_{Eigen::Isometry3d::Identity(),
                                          Eigen::Isometry3d::Identity()};
  std::array<PairDistance, kMostPairs> standing_pairs_{};
  int near_count_ = 0;
  MotionVerdict verdict_;
};

}  // namespace

const char* label(FaultKind kind) noexcept {
  switch (kind) {
    case FaultKind::kPosition:
      return "position";
    case FaultKind::kSpeed:
      return "speed";
    case FaultKind::kEffort:
      return "effort";
    case FaultKind::kTouch:
      return "links";
    case FaultKind::kBalance:
      return "balance";
    case FaultKind::kReach:
      return "reach";
  }
  return "";
}

MotionVerdict check_motion(const Model& model, const MotionClip& motion,
                           const MotionCheckConfig& config) {
  return Check(model, motion, config).run();
}

}  // namespace twinbus::control
