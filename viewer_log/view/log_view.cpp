#include "viewer_log/view/log_view.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/math/pose_math.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr double kBefore =
    2.3;  // read before a moment that is jumped to: more than a rate's window [s]
constexpr double kStatesBefore =
    1.2;  // of it with what comes at every tick: more than the real-time factor's [s]
constexpr double kSearchStep = 0.05;   // [s]
constexpr double kSearchFirst = 30.0;  // a log whose first STATE comes later has none [s]
constexpr double kSearchPlace = 0.2;   // [s]
constexpr std::int64_t kTotalsEvery = 100'000'000;  // [ns]
constexpr int kMostHalves = 200;                    // of half a period, for the next state

// Heading and place of a base on the ground.
Eigen::Isometry3d on_ground(const Eigen::Isometry3d& base) {
  Eigen::Isometry3d plane = Eigen::Isometry3d::Identity();
  plane.linear() = Eigen::AngleAxisd(yaw_of(base.linear()), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  plane.translation() = Eigen::Vector3d(base.translation().x(), base.translation().y(), 0.0);
  return plane;
}

std::optional<Eigen::Isometry3d> believed_base(const StackView& view) {
  if (view.controller().at_ns == 0) return {};
  const ControllerStatus& c = view.controller().value;
  const auto& w = c.base_attitude;
  Eigen::Quaterniond attitude(static_cast<double>(w[0]), static_cast<double>(w[1]),
                              static_cast<double>(w[2]), static_cast<double>(w[3]));
  if (!(attitude.norm() > 0.5)) return {};
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  base.linear() = attitude.normalized().toRotationMatrix();
  for (int i = 0; i < 3; ++i)
    base.translation()[i] = static_cast<double>(c.base_position[static_cast<std::size_t>(i)]);
  return base;
}

}  // namespace

LogView::LogView(const Model& model, std::string file, LogFeed& feed)
    : model_(&model), file_(std::move(file)), feed_(&feed), player_(file_) {
  view_.emplace(model);
  find_first_state();
  seek(first_state_);
}

void LogView::find_first_state() {
  LogEvent event;
  LogReader reader(file_);
  if (!reader.next(event)) return;
  first_utime_ = event.utime;
  do {
    first_state_ = 1e-6 * (static_cast<double>(event.utime) - static_cast<double>(first_utime_));
    take(event);
    if (view_->state().at_ns != 0) return;
  } while (first_state_ < kSearchFirst && reader.next(event));
  throw std::runtime_error(
      "log " + file_ + ": no STATE of " + model_->name +
      " in it; of another robot? say which with --robot; recorded with a prefix? say which with "
      "--recorded-prefix");
}

std::int64_t LogView::now_ns() const {
  return 1000 * first_utime_ + static_cast<std::int64_t>(std::llround(1e9 * player_.position()));
}

void LogView::take(const LogEvent& event) {
  const std::int64_t now = 1000 * event.utime;
  LogFeed::Kind kind = counting_ ? feed_->kind_of(event) : LogFeed::Kind::kOther;
  if (kind == LogFeed::Kind::kOther) kind = feed_->feed(event, *view_, now);
  switch (kind) {
    case LogFeed::Kind::kState:
      ++states_;
      break;
    case LogFeed::Kind::kCommand:
      ++commands_;
      break;
    case LogFeed::Kind::kGuard:
      ++guards_;
      break;
    case LogFeed::Kind::kEachTick:
    case LogFeed::Kind::kOther:
      break;
  }
  if (now - told_ns_ < kTotalsEvery && now >= told_ns_) return;
  told_ns_ = now;
  view_->on_totals(states_, commands_, guards_, now);
}

void LogView::play(double dt) {
  player_.advance(dt, [this](const LogEvent& event) { take(event); });
}

void LogView::advance(double dt) {
  play(dt);
  view_->forget_silent(now_ns());
}

// The first states and the first word of the controller say where the robot is.
void LogView::find_place() {
  place_.setIdentity();
  for (double read = 0.0; read < kSearchPlace && !player_.at_end(); read += kSearchStep) {
    play(kSearchStep);
    const auto base = believed_base(*view_);
    if (view_->state().at_ns == 0 || !base) continue;
    place_ = on_ground(*base) * on_ground(view_->estimator().configuration().base).inverse();
    return;
  }
}

void LogView::seek(double seconds) {
  const double target = std::clamp(seconds >= 0.0 ? seconds : 0.0, 0.0, player_.duration());
  const auto before = [&](double span) {
    return std::min(target, std::max(first_state_, target - span));
  };
  const double begin = before(kBefore), states_begin = before(kStatesBefore);
  ++jumps_;
  view_.emplace(*model_);
  player_.seek(states_begin);
  find_place();
  view_.emplace(*model_);
  told_ns_ = states_ = commands_ = guards_ = 0;
  player_.seek(begin);
  counting_ = true;
  play(states_begin - begin);
  counting_ = false;
  play(target - states_begin +
       0.5e-6);  // rounded to the nearest microsecond; also what is at that very moment
}

void LogView::step(int by) {
  const std::int64_t tick = view_->state().value.tick;
  const double half = 0.5 * model_->period();
  const double start = player_.position();
  for (int i = 1; i <= kMostHalves && view_->state().value.tick == tick && !player_.at_end(); ++i) {
    if (by > 0) {
      play(half);
    } else if (start - i * half > first_state_) {
      seek(start - i * half);
    } else {
      seek(first_state_);
      return;
    }
  }
}

}  // namespace twinbus::viewer_log
