#include "robot/motion/motion_clip.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "common/text/closest_name.h"
#include "common/text/printable.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/estimation/support_polygon.h"
#include "robot/kinematics/leg_chain.h"
#include "robot/motion/motion_spline.h"

namespace twinbus::inline robot {

namespace {

constexpr double kFrame = 0.02;        // between frames [s]
constexpr double kShortest = 0.1;      // of a motion [s]
constexpr double kDeepest = 0.2;       // of the centre of mass, as a squat's [m]
constexpr double kMostTilt = 0.3;      // of the base: balance does not begin beyond 0.35 [rad]
constexpr double kInside = 0.02;       // of the zero-moment point, from the edge of the soles [m]
constexpr double kSmooth = 0.1;        // of what the legs do, as long as half a frame of 5 Hz [s]

// A cubic through four neighbouring frames at times of their own (Catmull-Rom with uneven times).
double between(const std::vector<double>& t, std::size_t k, double time,
               const std::array<double, 4>& x) {
  const std::size_t n = t.size();
  const double h = t[k + 1] - t[k], s = std::clamp((time - t[k]) / h, 0.0, 1.0);
  const double before = k > 0 ? t[k] - t[k - 1] : h, after = k + 2 < n ? t[k + 2] - t[k + 1] : h;
  const double slope = (x[2] - x[1]) / h;
  double va = h * slope, vb = va;
  if (k > 0) va = h * (before * slope + h * (x[1] - x[0]) / before) / (before + h);
  if (k + 2 < n) vb = h * (after * slope + h * (x[3] - x[2]) / after) / (after + h);
  if (k == 0) va = 1.5 * h * slope - 0.5 * vb;  // an end without a curve of its own
  if (k + 2 == n) vb = 1.5 * h * slope - 0.5 * va;
  const double s2 = s * s, s3 = s2 * s;
  return (2.0 * s3 - 3.0 * s2 + 1.0) * x[1] + (s3 - 2.0 * s2 + s) * va +
         (3.0 * s2 - 2.0 * s3) * x[2] + (s3 - s2) * vb;
}

// Twice a moving mean: no phase, no overshoot.
void smooth(std::vector<Eigen::Vector3d>& x, int half) {
  std::vector<Eigen::Vector3d> y(x.size());
  const int n = static_cast<int>(x.size());
  for (int pass = 0; pass < 2 && half > 0; ++pass) {
    for (int i = 0; i < n; ++i) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int d = -half; d <= half; ++d) sum += x[at(std::clamp(i + d, 0, n - 1))];
      y[at(i)] = sum / (2 * half + 1);
    }
    x.swap(y);
  }
}

}  // namespace

MotionClip::MotionClip(const Model& model, const MotionFile& file, const MotionOptions& options)
    : model_(&model),
      period_(std::max(kFrame, 2.0 * model.period())),
      speed_(options.speed),
      standing_(model) {
  std::vector<std::string> names;
  for (const int j : model.bus_joints) names.push_back(model.joints[at(j)].name);
  column_.assign(names.size(), -1);
  for (std::size_t c = 0; c < file.joints.size(); ++c) {
    const auto found = std::find(names.begin(), names.end(), file.joints[c]);
    if (found == names.end()) {
      throw std::runtime_error(file.file + ": column '" + printable(file.joints[c], 60) +
                               "' is no joint on the bus of " + model.name +
                               suggestion(printable(file.joints[c], 60), names) +
                               "; --columns can leave it out by -");
    }
    const auto k = found - names.begin();
    column_[static_cast<std::size_t>(k)] = static_cast<int>(c);
    named_ |= std::int64_t{1} << k;
  }
  has_root_ = !file.root.empty();
  find_stand(model, options.stand);
  sample_file(file);
  std::int64_t legs = 0;
  const bool can_stand =
      model.floating_base && model.soles[0].link >= 0 && model.soles[1].link >= 0;
  for (int foot = 0; foot < 2 && can_stand; ++foot) {
    const LegChain chain = leg_chain(model, foot);
    for (int i = 0; i < chain.count; ++i) {
      if (const int k = model.bus_index[at(chain.joint[at(i)])]; k >= 0) legs |= bit(k);
    }
  }
  mask_ = named_ & ~legs;
  moves_legs_ = can_stand && (named_ & legs) != 0 && !options.upper_only;
  if (moves_legs_) project_legs(model);
  for (std::size_t k = 0; k < column_.size(); ++k) {
    if ((mask_ >> k & 1) == 0) continue;
    std::vector<double> x(frames_.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = frames_[i].q[k];
    spline_frames(x);
    for (std::size_t i = 0; i < x.size(); ++i) frames_[i].q[k] = x[i];
  }
}

// Midway between the soles, z up; x where the soles point.
Eigen::Isometry3d MotionClip::ground_of(const Kinematics& kinematics) const {
  Eigen::Isometry3d ground = Eigen::Isometry3d::Identity();
  std::array<Eigen::Isometry3d, 2> sole;
  for (std::size_t f = 0; f < 2; ++f)
    sole[f] = kinematics.link_in_world(model_->soles[f].link) * model_->soles[f].frame;
  const double yaw = yaw_of(sole[0].linear()) +
                     0.5 * wrap_angle(yaw_of(sole[1].linear()) - yaw_of(sole[0].linear()));
  ground.linear() = rotation_z(yaw);
  ground.translation() = 0.5 * (sole[0].translation() + sole[1].translation());
  return ground;
}

void MotionClip::find_stand(const Model& model, const std::string& pose) {
  if (const int found = model.find_pose(pose); found >= 0) {
    const std::vector<double>& q = model.poses[at(found)].q;
    standing_.q = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
  } else if (pose != "half_sitting") {
    throw std::runtime_error(model.name + " has no pose '" + printable(pose, 60) + "'" + suggestion(printable(pose, 60), model.poses));
  }
  for (int k = 0; k < model.bus_count(); ++k) stand_[at(k)] = standing_.q[model.bus_joints[at(k)]];
  if (model.soles[0].link < 0 || model.soles[1].link < 0) return;
  // Turned so that the soles lie level.
  Kinematics kinematics(model);
  kinematics.update(standing_);
  const Eigen::Vector3d up =
      ((kinematics.link_in_world(model.soles[0].link) * model.soles[0].frame).linear().col(2) +
       (kinematics.link_in_world(model.soles[1].link) * model.soles[1].frame).linear().col(2))
          .normalized();
  standing_.base =
      Eigen::Isometry3d(Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()));
  kinematics.update(standing_);
  standing_.base = ground_of(kinematics).inverse() * standing_.base;
}

void MotionClip::sample_file(const MotionFile& file) {
  const double length = file.time.back() / speed_;
  if (!(length >= kShortest)) throw std::runtime_error(file.file + ": is shorter than 0.1 s");
  const int count = std::min(kMostMotionFrames, static_cast<int>(std::ceil(length / period_ - 1e-9)) + 1);
  period_ = length / (count - 1);  // the last frame is the end
  frames_.resize(at(count));
  recorded_.resize(at(count));
  const int last = file.frames() - 1;
  std::size_t k = 0;
  for (int i = 0; i < count; ++i) {
    const double time = std::min(speed_ * (period_ * i), file.time.back());
    while (static_cast<int>(k) < last - 1 && time >= file.time[k + 1]) ++k;
    PerJoint<double>& q = recorded_[at(i)];
    q = stand_;
    for (std::size_t j = 0; j < column_.size(); ++j) {
      if (column_[j] < 0) continue;
      std::array<double, 4> x{};
      for (int d = 0; d < 4; ++d)
        x[at(d)] = file.at(std::clamp(static_cast<int>(k) + d - 1, 0, last), column_[j]);
      q[j] = between(file.time, k, time, x);
    }
    frames_[at(i)].q = q;
    if (!has_root_) continue;
    const Eigen::Isometry3d &a = file.root[k], &b = file.root[k + 1];
    const double s =
        std::clamp((time - file.time[k]) / (file.time[k + 1] - file.time[k]), 0.0, 1.0);
    Eigen::Isometry3d& root = root_.emplace_back(Eigen::Isometry3d::Identity());
    root.linear() =
        Eigen::Quaterniond(a.linear()).slerp(s, Eigen::Quaterniond(b.linear())).toRotationMatrix();
    root.translation() = (1.0 - s) * a.translation() + s * b.translation();
  }
}

void MotionClip::as_recorded(double time, Configuration& configuration) const {
  const double along = std::clamp(time / period_, 0.0, static_cast<double>(frames() - 1));
  const auto k = static_cast<std::size_t>(along), next = std::min(k + 1, frames_.size() - 1);
  const double s = along - static_cast<double>(k);
  configuration.q = standing_.q;
  configuration.qd.setZero();
  for (int j = 0; j < model_->bus_count(); ++j)
    configuration.q[model_->bus_joints[at(j)]] =
        (1.0 - s) * recorded_[k][at(j)] + s * recorded_[next][at(j)];
  set_mimics(*model_, configuration);
  configuration.base = standing_.base;
  if (!has_root_) return;
  configuration.base.linear() = Eigen::Quaterniond(root_[k].linear())
                                    .slerp(s, Eigen::Quaterniond(root_[next].linear()))
                                    .toRotationMatrix();
  configuration.base.translation() =
      (1.0 - s) * root_[k].translation() + s * root_[next].translation();
}

// Centre of mass over the middle of the soles, and the lean of the base, as the file has them; then what balance can do of it.
void MotionClip::project_legs(const Model& model) {
  Kinematics kinematics(model);
  Configuration place(model);
  kinematics.update(standing_);
  const Eigen::Vector3d home = kinematics.com();
  const Eigen::Vector3d upright_turn =
      rotation_vector(rotation_z(-yaw_of(standing_.base.linear())) * standing_.base.linear());
  std::vector<Eigen::Vector3d> com(frames_.size()), tilt(frames_.size());
  for (int i = 0; i < frames(); ++i) {
    as_recorded(i * period_, place);
    if (!has_root_) {  // nobody says how the base lies: the soles are level
      place.base.setIdentity();
      kinematics.update(place);
      Eigen::Vector3d up = Eigen::Vector3d::Zero();
      for (const Sole& sole : model.soles)
        up += (kinematics.link_in_world(sole.link) * sole.frame).linear().col(2);
      place.base = Eigen::Isometry3d(
          Eigen::Quaterniond::FromTwoVectors(up.normalized(), Eigen::Vector3d::UnitZ()));
    }
    kinematics.update(place);
    const Eigen::Isometry3d ground = ground_of(kinematics);
    com[at(i)] = ground.inverse() * kinematics.com() - home;
    const Eigen::Matrix3d base = ground.linear().transpose() * place.base.linear();
    tilt[at(i)] = rotation_vector(rotation_z(-yaw_of(base)) * base) - upright_turn;
  }
  const int half = static_cast<int>(std::lround(kSmooth / period_));
  smooth(com, half);
  smooth(tilt, half);
  // Where the soles are, of the standing robot.
  SupportPolygon polygon;
  kinematics.update(standing_);
  for (const Sole& sole : model.soles) polygon.add(sole, kinematics.link_in_world(sole.link) * sole.frame);
  polygon.finish();
  // The zero-moment point of a point mass at home + share * (x, y): inside, with the largest share.
  const double omega2 = kGravity / std::max(0.1, home.z());
  const auto fits = [&](double share) {
    for (int i = 0; i < frames(); ++i) {
      const Eigen::Vector3d &a = com[at(std::max(0, i - 1))], &b = com[at(i)],
                            &c = com[at(std::min(frames() - 1, i + 1))];
      const Eigen::Vector2d acceleration = (a - 2.0 * b + c).head<2>() / (period_ * period_);
      const Eigen::Vector2d zmp = polygon.centre() + share * (b.head<2>() - acceleration / omega2);
      if (!(polygon.margin(zmp) > kInside)) return false;
    }
    return true;
  };
  // The file's feet are where they are: what counts is how the centre of mass moves, not how the feet stand.
  double low = 0.0, high = 1.0;
  if (fits(1.0)) low = 1.0;
  for (int round = 0; round < 20 && low < 1.0; ++round)
    (fits(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  com_share_ = low;
  for (int i = 0; i < frames(); ++i) {
    asked_depth_ = std::max(asked_depth_, -com[at(i)].z());
    Frame& frame = frames_[at(i)];
    frame.com << com_share_ * com[at(i)].head<2>(), std::clamp(com[at(i)].z(), -kDeepest, 0.0);
    frame.tilt = tilt[at(i)].head<2>().cwiseMax(-kMostTilt).cwiseMin(kMostTilt);
    depth_ = std::max(depth_, -frame.com.z());
  }
}

MotionPoint MotionClip::at_time(double time) const {
  const SplinePlace place = spline_place(time, frames(), period_);
  MotionPoint point;
  point.q = stand_;
  for (std::size_t i = 0; i < 4; ++i) {
    const Frame& frame = frames_[at(place.frame[i])];
    for (std::size_t k = 0; k < column_.size(); ++k) {
      if ((mask_ >> k & 1) == 0) continue;
      if (i == 0) point.q[k] = 0.0;
      point.q[k] += place.position[i] * frame.q[k];
      point.qd[k] += place.velocity[i] * frame.q[k];
      point.qdd[k] += place.acceleration[i] * frame.q[k];
    }
    point.com += place.position[i] * frame.com;
    point.com_velocity += place.velocity[i] * frame.com;
    point.com_acceleration += place.acceleration[i] * frame.com;
    point.tilt += place.position[i] * frame.tilt;
    point.tilt_rate += place.velocity[i] * frame.tilt;
  }
  return point;
}

std::vector<MotionPiece> MotionClip::pieces(std::int64_t motion_id) const {
  std::vector<MotionPiece> pieces;
  for (int first = 0; first < frames(); first += kFramesPerPiece) {
    MotionPiece& piece = pieces.emplace_back();
    piece.motion_id = motion_id;
    piece.joint_mask = mask_;
    piece.frames = frames();
    piece.first = first;
    piece.joint_count = static_cast<std::int16_t>(model_->bus_count());
    piece.count = static_cast<std::int16_t>(std::min(kFramesPerPiece, frames() - first));
    piece.period = static_cast<float>(period_);
    piece.depth = static_cast<float>(depth_);
    for (int i = 0; i < piece.count; ++i) {
      const Frame& frame = frames_[at(first + i)];
      for (std::size_t k = 0; k < column_.size(); ++k)
        piece.q[at(i)][k] = static_cast<float>(frame.q[k]);
      for (int d = 0; d < 3; ++d) piece.com[at(i)][at(d)] = static_cast<float>(frame.com[d]);
      for (int d = 0; d < 2; ++d) piece.tilt[at(i)][at(d)] = static_cast<float>(frame.tilt[d]);
    }
  }
  return pieces;
}

}  // namespace twinbus::robot
