#include "launcher/run/fit_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "common/text/formatted.h"
#include "control/balance/balance.h"
#include "control/motion/motion_check.h"
#include "control/point_feet/point_feet_body.h"
#include "control/point_feet/step_gait.h"
#include "control/walk/footsteps.h"
#include "control/walk/walk_gains.h"
#include "lcmtypes/msg/labels.h"
#include "robot/description/load.h"
#include "robot/description/walking_config.h"
#include "robot/kinematics/leg_motion.h"
#include "sim/scene/arm_places.h"
#include "sim/scene/scene_obstacle.h"
#include "sim/scene/scene_places.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kEdgeShare = 0.25;                        // of a sole's length, from its edge
constexpr double kTrotTilt = 6.0;                          // on point feet, at least [degrees]
constexpr double kSoleLength = 220.0, kSoleWidth = 130.0;  // on which a margin is asked as the scene says [mm]
constexpr double kSaid = 0.01;                             // [m/s], [rad/s]

bool walks(const Scene& scene) {
  return !scene.walks.empty() || !scene.pads.empty() || !scene.steps.empty() ||
         std::any_of(scene.modes.begin(), scene.modes.end(),
                     [](const TimedMode& timed) { return timed.request.mode == Mode::kWalk; });
}

bool turns(const Scene& scene) {
  return std::any_of(scene.walks.begin(), scene.walks.end(), [](const TimedWalk& walk) { return walk.request.wz != 0.0F; }) ||
         std::any_of(scene.pads.begin(), scene.pads.end(), [](const auto& timed) { return timed.request.right_x != 0.0F; });
}

Eigen::Vector3d fastest_of(const Model& model) {
  return gait_of(model, model.walking, WalkGains{}.stabilizer.margin).most_velocity;
}

// How far the sticks of a scene lead a robot that goes at most so fast [m].
double way_of(const std::vector<TimedPad>& pads, const Eigen::Vector3d& most) {
  double way = 0.0;
  for (const TimedPad& timed : pads) {
    const double x = static_cast<double>(timed.request.left_y) * most.x();
    const double y = static_cast<double>(timed.request.left_x) * most.y();
    way += timed.duration * std::hypot(x, y);
  }
  return way;
}

// A robot that was proposed is asked for no more than its legs can, which the controller would cut all the same, and sticks, which ask
// for shares of that, lead it no farther than that.  Said in Scene::scaled.
void ask_what_it_can(Scene& scene, const Model& model) {
  const bool points = why_no_point_feet(model) == nullptr;
  if (!(model.walking.fastest > 0.0) || !(points || Balance::why_not(model) == nullptr) || !walks(scene)) return;
  const Model own = load_robot(scene.robot);
  if (own.hash == model.hash) return;
  const Gait gait = points ? Gait{} : gait_of(model, model.walking, WalkGains{}.stabilizer.margin);
  const std::optional<StepGait> steps = points ? std::optional(step_gait_of(model)) : std::nullopt;
  for (TimedWalk& walk : scene.walks) {
    const Eigen::Vector3d asked = Eigen::Vector3f(walk.request.vx, walk.request.vy, walk.request.wz).cast<double>();
    const Eigen::Vector3d possible = points ? steps->possible(asked) : gait.possible(asked);
    if (!((possible - asked).cwiseAbs().maxCoeff() > kSaid)) continue;
    walk.request.vx = static_cast<float>(possible.x());
    walk.request.vy = static_cast<float>(possible.y());
    walk.request.wz = static_cast<float>(possible.z());
    scene.scaled += formatted("%sof %.2f %.2f %.2f (m/s, m/s, rad/s) its legs%s can %.2f %.2f %.2f",
                              scene.scaled.empty() ? "" : "; ", asked.x(), asked.y(), asked.z(), points ? "" : " and soles",
                              possible.x(), possible.y(), possible.z());
    if (asked.x() != 0.0) scene.criteria.travel_min_m *= possible.x() / asked.x();
  }
  if (scene.pads.empty() || std::isnan(scene.criteria.travel_min_m)) return;
  const double way = way_of(scene.pads, fastest_of(own));
  if (way > 0.0)
    scene.criteria.travel_min_m *= std::min(1.0, way_of(scene.pads, points ? steps->most_velocity() : gait.most_velocity) / way);
}

}  // namespace

std::string why_not_for(const Scene& scene, const Model& model) {
  const char* why = Balance::why_not(model);
  const bool points = why != nullptr && why_no_point_feet(model) == nullptr;
  if (walks(scene)) {
    if (why != nullptr && !points)
      return std::string("it walks, which needs a free base, and two legs of five to seven joints with soles, or two or four on point feet, and ") + why;
    if (why == nullptr && turns(scene) && free_axis(model, 0) == 2)
      return "it turns, and legs without a joint about the vertical cannot turn a robot";
    if (points && !scene.steps.empty()) return "it places the footsteps of two soles, and the robot has point feet";
  }
  const bool moves = std::any_of(scene.modes.begin(), scene.modes.end(),
                                 [](const TimedMode& timed) { return timed.request.motion != Motion::kNone; });
  if (moves && why != nullptr && !points)
    return std::string("it sways or squats, which needs legs that balance, and ") + why;
  if (points && PointFeetBody(model).two()) {
    if (turns(scene)) return "it turns, and two point feet cannot turn a robot";
    if (moves) return "it sways or squats, and a robot on two point feet only steps";
  }
  for (const auto why_not : {begins_in_ground, begins_too_heavy}) {
    if (const std::string reason = why_not(scene, model); !reason.empty()) return reason;
  }
  for (const TimedGoal& timed : scene.goals) {
    const bool left = timed.request.side == ArmSide::kLeft;
    if (hand_of(model, number_of(timed.request.side)) == nullptr)
      return std::string("it reaches with the ") + (left ? "left" : "right") +
             " hand, and robot.yaml names none (hands)";
  }
  const auto no_link = [&](const std::string& link) {
    return !link.empty() && link.find('/') == std::string::npos && find_place(model, link) < 0;
  };
  const auto no_loose = [&](const std::string& name) {
    return std::none_of(scene.loose.begin(), scene.loose.end(), [&](const LooseBody& body) { return body.name == name; });
  };
  for (const Push& push : scene.pushes) {
    if (no_link(push.link)) return "it pushes " + push.link + ", which the robot does not have";
  }
  for (const BodyChange& body : scene.bodies) {
    if (no_link(body.link)) return "it puts a mass on " + body.link + ", which the robot does not have";
  }
  for (const Grasp& grasp : scene.grasps) {
    if (no_link(grasp.link)) return "it grips with " + grasp.link + ", which the robot does not have";
    if (no_link(grasp.to) && grasp.to != "world" && no_loose(grasp.to)) return "it grips " + grasp.to + ", which the robot does not have";
  }
  const auto unknown = [&](const std::string& joint) { return !joint.empty() && model.find_joint(joint) < 0; };
  for (const auto& [joint, speed] : scene.start_velocity) {
    if (unknown(joint)) return "it starts with joint " + joint + " in motion, which the robot does not have";
  }
  for (const JointEnd& end : scene.criteria.joints) {
    if (unknown(end.name)) return "it asks where joint " + end.name + " ends, which the robot does not have";
  }
  if (unknown(scene.criteria.swing.joint))
    return "it asks how joint " + scene.criteria.swing.joint + " swings, which the robot does not have";
  return "";
}

std::string why_scene_is_not_for(Scene scene, const Model& model) {
  resolve_poses(scene, model);
  return why_not_for(scene, model);
}

void check_motions(const Scene& scene, const Model& model) {
  for (const TimedMotion& timed : scene.motions) {
    const MotionVerdict verdict = check_motion(model, clip_of(timed, scene, model), {});
    if (verdict.passed()) continue;
    const MotionFault& fault = verdict.faults.front();
    const std::string text = formatted("%s of %.60s is %.4g, and the limit %.4g, at %.3f s", label(fault.kind),
                                       fault.what.c_str(), fault.value, fault.limit,
                                       static_cast<double>(std::max<std::int64_t>(0, fault.tick)) * model.period());
    throw std::runtime_error("scene " + scene.name + ": the motion " + timed.file + " is refused: " + text + "; ./twinbus motion " +
                             timed.file + " --check lists all");
  }
}

void fit_scene(Scene& scene, const Model& model) {
  resolve_poses(scene, model);
  if (const std::string why = why_not_for(scene, model); !why.empty()) {
    throw std::runtime_error("scene " + scene.name + " does not apply to the robot " + model.name + ": " + why +
                             "; ./twinbus run --help says how to name another scene");
  }
  ask_what_it_can(scene, model);
  const bool margins = !std::isnan(scene.criteria.zmp_margin_min_mm) || !std::isnan(scene.criteria.zmp_margin_p5_mm);
  const double margin = scene.criteria.zmp_margin_min_mm;
  scene.criteria = for_robot(scene.criteria, model, walks(scene));
  // Of point feet a scene asks for a margin only where it was written for this robot.
  if (!std::isnan(margin) && stands_on_points(model) && load_robot(scene.robot).hash == model.hash)
    scene.criteria.zmp_margin_min_mm = margin;
  if (margins && walks(scene) && leans(model)) {
    scene.scaled += scene.scaled.empty() ? "" : "; ";
    scene.scaled += "soles that no ankle rolls carry at their edges: no ZMP margin is asked";
  }
  check_motions(scene, model);
}

Criteria for_robot(Criteria criteria, const Model& model, bool walks) {
  const double asked_min = criteria.zmp_margin_min_mm, asked_p5 = criteria.zmp_margin_p5_mm;
  const double asked_tilt = criteria.sole_tilt_max_deg;
  if (model.soles[0].link < 0 && model.soles[1].link < 0) {  // nothing stands, so nothing of standing is asked
    for (double* asked :
         {&criteria.zmp_margin_min_mm, &criteria.slip_max_mm, &criteria.sole_tilt_max_deg, &criteria.zmp_margin_p5_mm,
          &criteria.step_slip_max_mm, &criteria.force_rms_percent})
      *asked = std::nan("");
    if (!model.floating_base) criteria.velocity_error_percent = std::nan("");
    // The trunk of a trotting robot rolls about the line of the two feet that stand; on two feet it always steps.
    const bool steps = walks || (why_no_point_feet(model) == nullptr && PointFeetBody(model).two());
    if (model.floating_base && steps && criteria.max_tilt_deg < kTrotTilt) criteria.max_tilt_deg = kTrotTilt;
  }
  for (const Sole& sole : model.soles) {
    if (sole.link < 0) continue;
    const double length = 1e3 * (sole.front + sole.back), width = 1e3 * (sole.left + sole.right);
    // On one foot: soles that are narrower than those the scenes are written for are asked for as much less.
    const double share = std::min({1.0, width / kSoleWidth, length / kSoleLength});
    // An edge that yields as far tilts a narrower sole more.
    criteria.sole_tilt_max_deg = std::max(criteria.sole_tilt_max_deg, asked_tilt * std::max(1.0, kSoleWidth / width));
    if (!std::isnan(criteria.zmp_margin_min_mm)) {
      criteria.zmp_margin_min_mm = std::min(criteria.zmp_margin_min_mm, kEdgeShare * length);
      if (walks) criteria.zmp_margin_min_mm = std::min(criteria.zmp_margin_min_mm, share * asked_min);
    }
    if (!std::isnan(criteria.zmp_margin_p5_mm)) criteria.zmp_margin_p5_mm = std::min(criteria.zmp_margin_p5_mm, share * asked_p5);
  }
  if (walks && leans(model)) criteria.zmp_margin_min_mm = criteria.zmp_margin_p5_mm = std::nan("");
  return criteria;
}

}  // namespace twinbus::launcher
