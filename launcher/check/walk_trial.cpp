#include "launcher/check/walk_trial.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <vector>

#include "common/math/angle.h"
#include "common/math/index.h"
#include "common/text/formatted.h"
#include "control/balance/balance.h"
#include "control/legs/leg_reach.h"
#include "control/point_feet/step_gait.h"
#include "control/walk/footsteps.h"
#include "launcher/run/judge_scene.h"
#include "launcher/run/local_stack.h"
#include "robot/description/robot_yaml.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kShare = 0.85;        // of the largest speed, reported
constexpr double kTiltMost = 5.0;      // [degrees]
constexpr double kVelocityMost = 20.0; // error of the velocity [percent]
constexpr double kShort = 5.0, kLong = 10.0;  // of a walk [s]
constexpr double kStart = 1.0, kStop = 2.5;   // before it and after it [s]
constexpr double kFroude = 0.45;       // of sqrt(g l), at most tried
constexpr double kSlower = 0.65;       // the next speed after one that failed
constexpr int kSlowerTimes = 5, kBisections = 3;
constexpr double kGain = 1.08;         // a gait that does not walk so much faster is not worth a setting
constexpr double kPlenty = 0.16;       // of sqrt(g l) [1]: who walks so fast gives up no margin for more
constexpr double kCalm = 0.5;          // of the usual gait's largest speed: where margins are compared
constexpr double kMargin = 0.9;        // of the usual gait's least margin of the zero-moment point
constexpr double kBeyondPatience = 4.0;    // of the processor's time, for slopes and pushes together [s]
constexpr double kSteepest = 20.0, kHardest = 0.35;  // tried: [degrees]; change of velocity, of sqrt(g l)
constexpr double kSlopeTilt = 10.0, kPushTilt = 20.0;  // [degrees]
constexpr double kBeforeRamp = 0.5, kFrontFeet = 0.5, kRampWidth = 3.0;  // of the leg
constexpr double kPushed = 3.0;        // of a walk that is pushed in its middle [s]
constexpr int kHalvings = 4;
constexpr double kPinned = 0.98;       // of a limit: the joint is at it
constexpr double kNearEnd = 0.01;      // of a range: the joint is at its end [rad]

// Entries of the map `walking` that the search may give.
struct GaitChoice {
  double single_support = std::nan(""), zmp_forward = std::nan(""), com_height = std::nan("");
  double fastest = std::nan("");

  std::string text() const {
    std::string out;
    const auto add = [&](const char* key, double value) {
      if (std::isnan(value)) return;
      out += formatted("%s%s: %.4g", out.empty() ? "" : ", ", key, value);
    };
    add("single_support", single_support);
    add("zmp_forward", zmp_forward);
    add("com_height", com_height);
    add("fastest", fastest);
    return out;
  }
};

// The joint that is at a limit first while the robot walks.
class LimitWatch {
 public:
  explicit LimitWatch(const Model& model) : model_(model) {}

  void add(const RobotState& state, double time) {
    if (!text_.empty()) return;
    if (stood_at_.empty()) {
      for (std::size_t k = 0; k < model_.bus_joints.size(); ++k) stood_at_.push_back(end_of_range(k, state.q[k]));
    }
    for (std::size_t k = 0; k < model_.bus_joints.size(); ++k) {
      const Joint& joint = model_.joints[at(model_.bus_joints[k])];
      const double q = state.q[k], v = std::abs(static_cast<double>(state.qd[k]));
      const double t = std::abs(static_cast<double>(state.tau[k]));
      if (t > kPinned * joint.effort) {
        text_ = formatted("%s is the first at a limit: %.3g N m of torque, %.2f s after the start", joint.name.c_str(),
                          joint.effort, time);
      } else if (v > kPinned * joint.velocity) {
        text_ = formatted("%s is the first at a limit: %.3g rad/s, %.2f s after the start", joint.name.c_str(),
                          joint.velocity, time);
      } else if (const int end = end_of_range(k, q); end != 0 && end != stood_at_[k]) {
        text_ = formatted("%s is the first at a limit: %.3g rad, the %s end of its range, %.2f s after the start",
                          joint.name.c_str(), end < 0 ? joint.lower : joint.upper, end < 0 ? "lower" : "upper", time);
      } else {
        continue;
      }
      return;
    }
  }
  const std::string& text() const { return text_; }

 private:
  // -1: at the lower end, 1: at the upper one.
  int end_of_range(std::size_t k, double q) const {
    const Joint& joint = model_.joints[at(model_.bus_joints[k])];
    const double near = std::min(kNearEnd, (1.0 - kPinned) * (joint.upper - joint.lower));
    return q < joint.lower + near ? -1 : q > joint.upper - near ? 1 : 0;
  }

  const Model& model_;
  std::vector<int> stood_at_;  // ends at which a joint was before: no limit that walking met
  std::string text_;
};

Scene walk_scene(const Model& model, double speed, double seconds) {
  Scene scene;
  scene.name = "walk";
  scene.robot = model.name;
  scene.duration = kStart + seconds + kStop;
  const auto mode = [&](double at, Mode wanted) {
    TimedMode timed;
    timed.at = at;
    timed.request.mode = wanted;
    scene.modes.push_back(timed);
  };
  mode(0.0, Mode::kBalance);
  mode(0.5, Mode::kWalk);
  mode(kStart + seconds + 0.5, Mode::kBalance);
  TimedWalk walk;
  walk.at = kStart;
  walk.duration = seconds;
  walk.request.vx = static_cast<float>(speed);
  walk.request.timeout = 0.1F;
  scene.walks.push_back(walk);
  scene.criteria.max_tilt_deg = kTiltMost;
  scene.criteria.velocity_error_percent = kVelocityMost;
  return scene;
}

// Of this process: what others do to the machine costs no walks.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Search {
 public:
  Search(const Model& model, double patience) : model_(model), usual_(model.walking), ends_(cpu_seconds() + patience) {}

  bool time_left() const { return cpu_seconds() < ends_; }
  int runs() const { return runs_; }
  const std::string& failure() const { return failure_; }
  const std::string& limit() const { return limit_; }
  // Of the last walk: how near the zero-moment point came to the soles' edge [m].
  double margin() const { return margin_; }

  // Whether it walks so; why not: failure(), limit().
  bool walks(const GaitChoice& gait, double speed, double seconds) { return passes(gait, walk_scene(model_, speed, seconds)); }
  // The same of any walk.
  bool passes(const GaitChoice& gait, Scene scene) {
    ++runs_;
    take(gait);
    failure_.clear();
    limit_.clear();
    margin_ = -1.0;
    try {
      apply_seed(scene, model_, 1);
      OneProcess run(model_, scene, {});
      LimitWatch limits(model_);
      const auto ticks = static_cast<std::int64_t>(std::llround(scene.duration / model_.period()));
      while (run.ticks() < ticks && run.tick()) {
        if (run.seen().figures().fell || run.state().role == Role::kStopped) break;
        const double time = static_cast<double>(run.ticks()) * model_.period();
        if (time > 0.4) limits.add(run.state(), time - kStart);
      }
      margin_ = run.seen().figures().zmp_margin_min;
      const RunVerdict verdict = judge_scene(run, scene.criteria, run.ticks());
      if (verdict.passed && run.ticks() >= ticks) return true;
      for (const std::string& failure : verdict.failures) {
        // Of a run that has ended early, that is the cause, and not what could not be measured any more.
        if (failure.find("could be measured") == std::string::npos) failure_ += (failure_.empty() ? "" : ", ") + failure;
      }
      if (failure_.empty() && !verdict.failures.empty()) failure_ = verdict.failures.front();
      limit_ = limits.text();
    } catch (const std::runtime_error& error) {
      failure_ = error.what();
    }
    return false;
  }

  double fastest_of_legs(const GaitChoice& gait) {
    take(gait);
    try {
      return gait_of(model_, model_.walking, 0.01).most_velocity.x();
    } catch (const std::runtime_error& error) {
      failure_ = error.what();
      return 0.0;
    }
  }

 private:
  void take(const GaitChoice& gait) {
    const std::string entries = gait.text();
    model_.walking = entries.empty() ? usual_ : read_walking(ConfigNode::parse("{" + entries + "}", "the gait that is tried"));
  }

  Model model_;
  Walking usual_;
  std::string failure_, limit_;
  double ends_;  // [s]
  double margin_ = -1.0;  // [m]
  int runs_ = 0;
};

struct Found {
  double speed = 0.0;  // 0: none
  std::string failure, limit;  // at the lowest speed that failed
};

// The largest speed below `most` that walks.
Found largest(Search& search, const GaitChoice& gait, double most, double seconds) {
  Found found;
  double fails = most, walks = 0.0;
  for (int k = 0; k <= kSlowerTimes && search.time_left(); ++k) {
    if (search.walks(gait, fails, seconds)) {
      walks = fails;
      break;
    }
    found.failure = search.failure();
    found.limit = search.limit();
    fails *= kSlower;
  }
  found.speed = walks;
  if (!(walks > 0.0) || walks >= most) return found;
  double high = walks / kSlower;
  for (int k = 0; k < kBisections && search.time_left(); ++k) {
    const double middle = 0.5 * (found.speed + high);
    if (search.walks(gait, middle, seconds)) {
      found.speed = middle;
    } else {
      high = middle;
      found.failure = search.failure();
      found.limit = search.limit();
    }
  }
  return found;
}

// 10 s, slower until it walks.
double verified(Search& search, const GaitChoice& gait, double speed) {
  for (int k = 0; k < 6; ++k, speed *= 0.92) {
    if (search.walks(gait, speed, kLong)) return speed;
  }
  return 0.0;
}

// One after the other each way that a gait may differ; what walks faster is kept.  A robot that is fast enough keeps its margins: scenes ask
// for them, and a shorter step that is faster may have the zero-moment point at the edge.
GaitChoice tuned(Search& search, const Gait& usual, double leg, double& speed) {
  GaitChoice best;
  const double scale = std::sqrt(kGravity * leg);
  const double target = 0.5 * kPlenty * scale, calm = kCalm * speed;
  const double margin = speed >= kPlenty * scale && search.walks({}, calm, kShort) ? kMargin * search.margin() : -1.0;
  const auto keeps_margin = [&](const GaitChoice& gait) {
    return margin < 0.0 || (search.walks(gait, calm, kShort) && search.margin() >= margin);
  };
  const auto try_one = [&](GaitChoice gait) {
    for (int k = 0; k < 3 && search.time_left(); ++k) {
      const double wanted = speed > 0.0 ? kGain * speed : target;
      if (wanted > search.fastest_of_legs(gait) || !search.walks(gait, wanted, kShort)) return;
      if (k == 0 && !keeps_margin(gait)) return;
      best = gait;
      speed = wanted;
    }
  };
  for (const double place : {0.5 * usual.zmp_forward, 0.0, 0.25 * usual.zmp_forward + 0.01}) {
    GaitChoice gait = best;
    gait.zmp_forward = place;
    try_one(gait);
  }
  for (const double time : {0.41, 0.45, 0.6, 0.35}) {
    GaitChoice gait = best;
    gait.single_support = time;
    try_one(gait);
  }
  for (const double share : {-0.03, 0.025}) {
    GaitChoice gait = best;
    gait.com_height = usual.com_height + share * leg;
    try_one(gait);
  }
  return best;
}

// What the search took, and whether it found a speed; verb: what the robot does not do at any otherwise.
bool judged(const Search& search, const Found& found, double begin, double speed, const char* verb, WalkTrial& trial) {
  trial.runs = search.runs();
  trial.cpu_s = cpu_seconds() - begin;
  trial.limit = found.limit.empty() ? found.failure : found.failure + "; " + found.limit;
  if (speed > 0.0) return true;
  trial.why_not = trial.limit.empty() ? std::string("it does not ") + verb + " at any speed" : trial.limit;
  return false;
}

// The largest share of what is hardest with which the walk that `scene_of` makes of it passes; why not more.
template <class SceneOf>
Found most_of(Search& search, const GaitChoice& gait, double ends, const SceneOf& scene_of) {
  Found found;
  double fails = 1.0;
  for (int k = 0; k <= kHalvings && cpu_seconds() < ends; ++k) {
    const double share = k == 0 ? 1.0 : 0.5 * (found.speed + fails);
    if (search.passes(gait, scene_of(share))) {
      found.speed = share;
      if (k == 0) break;
    } else {
      fails = share;
      found.failure = search.failure();
      found.limit = search.limit();
    }
  }
  return found;
}

WalkBound bound_of(const Found& found, double hardest) {
  return {found.speed * hardest, found.failure + (found.failure.empty() || found.limit.empty() ? "" : "; ") + found.limit};
}

// At half of its speed: how steep it walks up, and how hard it may be pushed meanwhile.
void find_bounds(const Model& model, const GaitChoice& choice, WalkTrial& trial) {
  const double begin = cpu_seconds(), speed = 0.5 * trial.fastest;
  Search search(model, kBeyondPatience);
  const auto ends = [&](int part) { return begin + kBeyondPatience * part / 3.0; };
  const Found slope = most_of(search, choice, ends(1), [&](double share) {
    Scene scene = walk_scene(model, speed, kShort);
    scene.terrain.ramp = share * kSteepest / kDegrees;
    scene.terrain.from = (kBeforeRamp + (trial.trots ? kFrontFeet : 0.0)) * trial.leg;
    scene.terrain.tile = speed * (kShort + kStop);  // one goes up, and there the walk ends
    scene.terrain.length = 3.0 * scene.terrain.tile;
    scene.terrain.width = std::max(scene.terrain.tile, kRampWidth * trial.leg);
    scene.criteria.max_tilt_deg = kSlopeTilt;
    return scene;
  });
  trial.slope_deg = bound_of(slope, kSteepest);
  const double hardest = kHardest * std::sqrt(kGravity * trial.leg);
  for (const bool aside : {false, true}) {
    const Found push = most_of(search, choice, ends(aside ? 3 : 2), [&](double share) {
      Scene scene = walk_scene(model, speed, kPushed);
      Push shove;
      shove.link = model.links.front().name;
      shove.point = model.links.front().com;
      shove.impulse[aside ? 1 : 0] = share * hardest * model.total_mass();
      shove.at = kStart + 0.5 * kPushed;
      scene.pushes.push_back(shove);
      scene.criteria.max_tilt_deg = kPushTilt;
      scene.criteria.velocity_error_percent = std::nan("");
      return scene;
    });
    (aside ? trial.push_aside : trial.push) = bound_of(push, hardest);
  }
  trial.runs += search.runs();
  trial.cpu_s += cpu_seconds() - begin;
}

WalkTrial find_steps(const Model& model, double patience) {
  WalkTrial trial;
  const double begin = cpu_seconds();
  const PointFeetBody body(model);
  const StepGait gait(body);
  trial.leg = body.reach;
  Search search(model, patience);
  Found found = largest(search, {}, gait.most_velocity().x(), kShort);
  const double speed = found.speed > 0.0 ? verified(search, {}, found.speed) : 0.0;
  if (!judged(search, found, begin, speed, body.two() ? "walk" : "trot", trial)) return trial;
  trial.trots = !body.two();
  trial.fastest = std::floor(1e3 * kShare * speed) / 1e3;
  trial.step = 0.5 * trial.fastest * gait.period();
  GaitChoice choice;
  choice.fastest = trial.fastest;
  trial.walking = choice.text();
  find_bounds(model, choice, trial);
  return trial;
}

}  // namespace

WalkTrial find_walk(const Model& model, double patience) {
  WalkTrial trial;
  if (why_no_point_feet(model) == nullptr) return find_steps(model, patience);
  if (const char* why = Balance::why_not(model)) {
    trial.why_not = why;
    return trial;
  }
  const double begin = cpu_seconds();
  Gait usual;
  try {
    const LegReach reach = leg_reach(model, 0);
    trial.leg = reach.longest + reach.ankle_height;
    usual = gait_of(model, model.walking, 0.01);
  } catch (const std::runtime_error& error) {
    trial.why_not = error.what();
    return trial;
  }
  Search search(model, patience);
  const double scale = std::sqrt(kGravity * trial.leg);
  const double most = std::min(usual.most_velocity.x(), kFroude * scale);
  Found found = largest(search, {}, most, kShort);
  GaitChoice choice;
  double start = found.speed > 0.0 ? verified(search, choice, found.speed) : 0.0;
  if (search.time_left()) {
    double speed = start;
    const GaitChoice other = tuned(search, usual, trial.leg, speed);
    if (!other.text().empty() && speed > start) {
      const double reached = verified(search, other, speed);
      if (reached > kGain * start) {
        choice = other;
        start = reached;
      }
    }
  }
  if (!judged(search, found, begin, start, "walk", trial)) return trial;
  trial.fastest = kShare * start;
  const Walking walking = model.walking;
  const double single = std::isnan(choice.single_support) ? walking.single_support : choice.single_support;
  trial.step = trial.fastest * (single + walking.double_support);
  choice.fastest = std::floor(1e3 * trial.fastest) / 1e3;
  trial.fastest = choice.fastest;
  trial.walking = choice.text();
  find_bounds(model, choice, trial);
  return trial;
}

}  // namespace twinbus::launcher
