#include "sim/scene/scene_criteria.h"

#include <algorithm>

#include "sim/scene/scene_vectors.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

namespace {

std::string loose_name(const ConfigNode& node, const std::vector<std::string>& bodies) {
  const std::string name = node.text("name");
  if (std::find(bodies.begin(), bodies.end(), name) == bodies.end()) {
    node.fail("name", "there is no loose body '" + name + "' in this scene");
  }
  return name;
}

LooseEnd read_loose_end(const ConfigNode& node, const std::vector<std::string>& bodies) {
  LooseEnd end;
  end.name = loose_name(node, bodies);
  end.position = bounded(node, "position", 1000.0, nullptr);
  end.within = node.number("within_m", 0.0, 100.0, end.within);
  end.speed = node.number("speed_m_s", 0.0, kMaxSpeed, end.speed);
  node.finish();
  return end;
}

RobotEnd read_robot_end(const ConfigNode& node, const std::vector<std::string>& robots) {
  RobotEnd end;
  end.name = node.text("name");
  if (std::find(robots.begin(), robots.end(), end.name) == robots.end()) {
    node.fail("name", "there is no robot '" + end.name + "' among the robots of this scene");
  }
  end.within = node.number("within_m", 0.0, 100.0, end.within);
  end.max_tilt_deg = node.number("max_tilt_deg", 0.0, 180.0, end.max_tilt_deg);
  node.finish();
  return end;
}

JointEnd read_joint_end(const ConfigNode& node) {
  JointEnd end;
  end.name = node.text("name");
  end.position = node.number("position", -1e4, 1e4);
  end.within = node.number("within", 0.0, 1e4);
  end.speed = node.number("speed", -kMaxSpeed, kMaxSpeed, kNotAsked);
  end.speed_within = node.number("speed_within", 0.0, kMaxSpeed, end.within);
  node.finish();
  return end;
}

SpinAsked read_spin(const ConfigNode& node, const std::vector<std::string>& bodies) {
  SpinAsked asked;
  asked.name = loose_name(node, bodies);
  asked.energy_drift = node.number("energy_drift", 0.0, 1e9, asked.energy_drift);
  asked.momentum_drift = node.number("momentum_drift", 0.0, 1e9, asked.momentum_drift);
  asked.flips = static_cast<int>(node.integer("flips", 0, 1000000, -1));
  node.finish();
  return asked;
}

TouchAsked read_touch(const ConfigNode& node) {
  TouchAsked asked;
  asked.points = static_cast<int>(node.integer("points", 1, 1000));
  asked.force = node.number("force_n", 0.0, 1e6);
  asked.within = node.number("within", 0.0, 1.0);
  asked.from = node.number("from", 0.0, 86400.0);
  node.finish();
  return asked;
}

}  // namespace

Criteria read_criteria(const ConfigNode& node, const std::vector<std::string>& loose,
                       const std::vector<std::string>& robots) {
  Criteria criteria;
  criteria.max_tilt_deg = node.number("max_tilt_deg", 0.0, 180.0, kNotAsked);
  criteria.zmp_margin_min_mm = node.number("zmp_margin_min_mm", -1000.0, 1000.0, kNotAsked);
  criteria.slip_max_mm = node.number("slip_max_mm", 0.0, 1e4, kNotAsked);
  criteria.sole_tilt_max_deg = node.number("sole_tilt_max_deg", 0.0, 180.0, kNotAsked);
  criteria.zmp_margin_p5_mm = node.number("zmp_margin_p5_mm", -1000.0, 1000.0, kNotAsked);
  criteria.step_slip_max_mm = node.number("step_slip_max_mm", 0.0, 1e4, kNotAsked);
  criteria.force_rms_percent = node.number("force_rms_percent", 0.0, 1e4, kNotAsked);
  criteria.velocity_error_percent = node.number("velocity_error_percent", 0.0, 1e4, kNotAsked);
  criteria.travel_min_m = node.number("travel_min_m", 0.0, 1e4, kNotAsked);
  criteria.drift_max_m = node.number("drift_max_m", 0.0, 1e4, kNotAsked);
  criteria.energy_drift_j = node.number("energy_drift_j", 0.0, 1e9, kNotAsked);
  criteria.loose_energy_drift_j = node.number("loose_energy_drift_j", 0.0, 1e9, kNotAsked);
  criteria.loose_energy_gain_j = node.number("loose_energy_gain_j", 0.0, 1e9, kNotAsked);
  criteria.goals_reached_min = node.number("goals_reached_min", 0.0, 1e4, kNotAsked);
  criteria.max_doubted_steps = node.number("max_doubted_steps", 0.0, 1e12, kNotAsked);
  criteria.no_fall = node.flag("no_fall", true);
  criteria.no_self_collision = node.flag("no_self_collision", true);
  for (const ConfigNode& end : node.list("loose")) {
    criteria.loose.push_back(read_loose_end(end, loose));
  }
  for (const ConfigNode& end : node.list("robots")) {
    criteria.robots.push_back(read_robot_end(end, robots));
  }
  for (const ConfigNode& end : node.list("joints")) {
    criteria.joints.push_back(read_joint_end(end));
  }
  for (const ConfigNode& asked : node.list("spins")) {
    criteria.spins.push_back(read_spin(asked, loose));
  }
  if (node.has("touch")) criteria.touch = read_touch(node.map("touch"));
  if (node.has("swing")) {
    const ConfigNode swing = node.map("swing");
    SwingAsked& asked = criteria.swing;
    asked.joint = swing.text("joint");
    asked.period_percent = swing.number("period_percent", 0.0, 100.0, asked.period_percent);
    asked.decay_percent = swing.number("decay_percent", 0.0, 100.0, asked.decay_percent);
    swing.finish();
  }
  node.finish();
  return criteria;
}

}  // namespace twinbus::sim
