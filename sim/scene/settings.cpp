#include "sim/scene/settings.h"

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include "common/text/closest_name.h"
#include "common/text/formatted.h"

namespace twinbus::inline sim {

namespace {

struct Entry {
  const char* key;
  double low, high;
  const char* meaning;
  void (*set)(SimSettings&, double value, double period);
};

int ticks(double ms, double period) { return static_cast<int>(std::lround(1e-3 * ms / period)); }

template <Imperfection SensorOptions::*Sensor, double Imperfection::*Property>
void sensor(SimSettings& s, double value, double) {
  s.sensors.*Sensor.*Property = value;
}

constexpr double kDelayMs = 60.0;

// In the order of kEngineNames and of kContactNames.
constexpr const char* kEngineMeanings[] = {
    "takes microseconds a step (default)",
    "about a millisecond a step: for machines with a fast core for each simulated robot",
    "where MuJoCo is installed",
};
constexpr const char* kContactMeanings[] = {
    "a spring and damper at each point (default)",
    "a spring at each point, and a damper that grows with the depth: a bounce by contact.dissipation",
    "the LCP of engine ode, which alone has it, for comparison",
    "springs of the area that presses, with dampers as of hunt_crossley; engines articulated and ode",
    "MuJoCo's soft one, which creeps; engine mujoco, and articulated of the robot on what is fixed",
};
static_assert(std::size(kEngineMeanings) == std::size(kEngineNames) && std::size(kContactMeanings) == std::size(kContactNames));

// a, b or c
template <std::size_t kCount>
std::string any_of(const char* const (&names)[kCount]) {
  std::string list = names[0];
  for (std::size_t i = 1; i < kCount; ++i) list += (i + 1 < kCount ? ", " : " or ") + std::string(names[i]);
  return list;
}

template <std::size_t kCount>
std::string choices_help(const char* key, const char* what, const char* const (&names)[kCount],
                         const char* const (&meanings)[kCount]) {
  std::string help = formatted("  %-27s %s\n", key, what);
  for (std::size_t i = 0; i < kCount; ++i) help += formatted("    %-25s %s\n", names[i], meanings[i]);
  return help;
}

const Entry kEntries[] = {
    {"solver.order", 1.0, 3.0,
     "of accuracy; 2 and 3 (engine articulated) take 3 and 6 solves a step",
     [](SimSettings& s, double v, double) { s.world.order = static_cast<int>(std::lround(v)); }},
    {"solver.local_error", 0.0, 1e3,
     "orders 2 and 3 (engine articulated) take a step in parts, down to a 128th, so fine that none makes a speed wrong by more than this "
     "times its length [m/s^2]; 0: where events lie only",
     [](SimSettings& s, double v, double) { s.world.local_error = v; }},
    {"solver.flight", 0.0, 4.0,
     "what touches nothing moves by 1: Adams-Bashforth 4, 2: Runge-Kutta 4, 3: Fehlberg 8, 4: "
     "Gauss "
     "8; 0: like all else",
     [](SimSettings& s, double v, double) {
       s.world.flight = static_cast<Flight>(std::lround(v));
     }},
    {"solver.flight_error", 0.0, 1e-3,
     "flight 4 takes a step in parts, each of which makes no speed wrong by more [rad/s], [m/s]; "
     "0: whole",
     [](SimSettings& s, double v, double) { s.world.flight_error = v; }},
    {"solver.twin", 0.0, 1.0,
     "1: a twin of half the step runs beside it, twice the work again; where they part by more than the accuracy, a step is doubted",
     [](SimSettings& s, double v, double) { s.world.twin = v != 0.0; }},
    {"model.mass_scale", 0.1, 10.0, "masses and inertias times this",
     [](SimSettings& s, double v, double) { s.world.mass_scale = v; }},
    {"model.friction", 0.0, 1e3, "Coulomb friction added to every joint [N m]",
     [](SimSettings& s, double v, double) { s.world.joint_friction = v; }},
    {"model.friction_share", 0.0, 1.0, "of model.friction a joint gets at most this share of its effort limit",
     [](SimSettings& s, double v, double) { s.world.joint_friction_share = v; }},
    {"model.friction_scale", 0.0, 100.0, "friction and damping of the joints times this",
     [](SimSettings& s, double v, double) { s.world.friction_scale = v; }},
    {"model.backlash", 0.0, 0.1, "play of every joint [rad]",
     [](SimSettings& s, double v, double) { s.world.backlash = v; }},
    {"servo.delay_ms", 0.0, kDelayMs, "from command to servo, whole periods [ms]",
     [](SimSettings& s, double v, double) { s.servo_delay_ms = v; }},
    {"servo.kp_scale", 0.0, 100.0, "position gains times this",
     [](SimSettings& s, double v, double) { s.world.servo_kp_scale = v; }},
    {"servo.kd_scale", 0.0, 100.0, "velocity gains times this",
     [](SimSettings& s, double v, double) { s.world.servo_kd_scale = v; }},
    {"contact.stiffness_scale", 1e-3, 1e3, "stiffness of the soles times this",
     [](SimSettings& s, double v, double) { s.world.stiffness_scale = v; }},
    {"contact.damping_scale", 0.0, 1e3, "damping of the soles times this",
     [](SimSettings& s, double v, double) { s.world.damping_scale = v; }},
    {"contact.dissipation", 0.0, 1e3,
     "damping of contacts hunt_crossley and patch, as much less a bounce [s/m]",
     [](SimSettings& s, double v, double) { s.world.dissipation = v; }},
    {"contact.rolling_friction", 0.0, 1.0, "moment of every contact against rolling, of its normal force; all laws but soft [m]",
     [](SimSettings& s, double v, double) { s.world.rolling_friction = v; }},
    {"contact.torsional_friction", 0.0, 1.0, "moment of every contact against spinning about its normal, of its normal force; the same [m]",
     [](SimSettings& s, double v, double) { s.world.torsional_friction = v; }},
    {"contact.friction", 0.0, 10.0, "Coulomb coefficient of the ground",
     [](SimSettings& s, double v, double) { s.world.ground_friction = v; }},
    {"contact.continuous", 0.0, 1.0,
     "1: what is loose leaves a box by the face through which it came, so that nothing fast goes through a thin plate",
     [](SimSettings& s, double v, double) { s.world.continuous = v != 0.0; }},
    {"ground.left_height_error", -0.05, 0.05, "ground under the left sole is this much higher [m]",
     [](SimSettings& s, double v, double) { s.world.ground_height[0] = v; }},
    {"ground.right_height_error", -0.05, 0.05,
     "ground under the right sole is this much higher [m]",
     [](SimSettings& s, double v, double) { s.world.ground_height[1] = v; }},
    {"sensor.noise.encoder", 0.0, 0.1, "standard deviation [rad]", sensor<&SensorOptions::encoder, &Imperfection::noise>},
    {"sensor.bias.encoder", -1, 1.0, "added to every reading [rad]", sensor<&SensorOptions::encoder, &Imperfection::bias>},
    {"sensor.quantum.encoder", 0.0, 0.1, "one count [rad]", sensor<&SensorOptions::encoder, &Imperfection::quantum>},
    {"sensor.limit.encoder", 0.0, 100.0, "reads no further, either way; 0: no limit [rad]",
     sensor<&SensorOptions::encoder, &Imperfection::limit>},
    {"sensor.noise.velocity", 0.0, 10.0, "standard deviation [rad/s]", sensor<&SensorOptions::velocity, &Imperfection::noise>},
    {"sensor.bias.velocity", -10, 10.0, "added to every reading [rad/s]", sensor<&SensorOptions::velocity, &Imperfection::bias>},
    {"sensor.quantum.velocity", 0.0, 1.0, "one count [rad/s]", sensor<&SensorOptions::velocity, &Imperfection::quantum>},
    {"sensor.limit.velocity", 0.0, 1000.0, "reads no further, either way; 0: no limit [rad/s]",
     sensor<&SensorOptions::velocity, &Imperfection::limit>},
    {"sensor.noise.torque", 0.0, 1000.0, "standard deviation [N m]", sensor<&SensorOptions::torque, &Imperfection::noise>},
    {"sensor.bias.torque", -1000.0, 1000.0, "added to every reading [N m]", sensor<&SensorOptions::torque, &Imperfection::bias>},
    {"sensor.quantum.torque", 0.0, 100.0, "one count [N m]", sensor<&SensorOptions::torque, &Imperfection::quantum>},
    {"sensor.limit.torque", 0.0, 100000.0, "reads no further, either way; 0: no limit [N m]",
     sensor<&SensorOptions::torque, &Imperfection::limit>},
    {"sensor.noise.attitude", 0.0, 0.1, "standard deviation [rad]", sensor<&SensorOptions::inclination, &Imperfection::noise>},
    {"sensor.quantum.inclination", 0.0, 0.1, "roll and pitch, one count [rad]",
     sensor<&SensorOptions::inclination, &Imperfection::quantum>},
    {"sensor.limit.inclination", 0.0, 1.57,
     "roll and pitch, reads no further, either way; 0: no limit [rad]",
     sensor<&SensorOptions::inclination, &Imperfection::limit>},
    {"sensor.noise.gyro", 0.0, 10.0, "standard deviation [rad/s]", sensor<&SensorOptions::gyro, &Imperfection::noise>},
    {"sensor.bias.gyro", -1, 1.0, "added to every reading [rad/s]", sensor<&SensorOptions::gyro, &Imperfection::bias>},
    {"sensor.quantum.gyro", 0.0, 1.0, "one count [rad/s]", sensor<&SensorOptions::gyro, &Imperfection::quantum>},
    {"sensor.limit.gyro", 0.0, 1000.0, "reads no further, either way; 0: no limit [rad/s]",
     sensor<&SensorOptions::gyro, &Imperfection::limit>},
    {"sensor.noise.accel", 0.0, 100.0, "standard deviation [m/s^2]", sensor<&SensorOptions::accel, &Imperfection::noise>},
    {"sensor.bias.accel", -10, 10.0, "added to every reading [m/s^2]", sensor<&SensorOptions::accel, &Imperfection::bias>},
    {"sensor.quantum.accel", 0.0, 10.0, "one count [m/s^2]", sensor<&SensorOptions::accel, &Imperfection::quantum>},
    {"sensor.limit.accel", 0.0, 10000.0, "reads no further, either way; 0: no limit [m/s^2]",
     sensor<&SensorOptions::accel, &Imperfection::limit>},
    {"sensor.noise.force", 0.0, 1000.0, "feet and hands, standard deviation [N]",
     sensor<&SensorOptions::force, &Imperfection::noise>},
    {"sensor.bias.force", -1000.0, 1000.0, "feet and hands, added to every reading [N]",
     sensor<&SensorOptions::force, &Imperfection::bias>},
    {"sensor.quantum.force", 0.0, 100.0, "feet and hands, one count [N]", sensor<&SensorOptions::force, &Imperfection::quantum>},
    {"sensor.limit.force", 0.0, 1000000.0,
     "feet and hands, reads no further, either way; 0: no limit [N]",
     sensor<&SensorOptions::force, &Imperfection::limit>},
    {"sensor.noise.moment", 0.0, 1000.0, "feet and hands, standard deviation [N m]",
     sensor<&SensorOptions::moment, &Imperfection::noise>},
    {"sensor.bias.moment", -1000.0, 1000.0, "feet and hands, added to every reading [N m]",
     sensor<&SensorOptions::moment, &Imperfection::bias>},
    {"sensor.quantum.moment", 0.0, 100.0, "feet and hands, one count [N m]",
     sensor<&SensorOptions::moment, &Imperfection::quantum>},
    {"sensor.limit.moment", 0.0, 100000.0,
     "feet and hands, reads no further, either way; 0: no limit [N m]",
     sensor<&SensorOptions::moment, &Imperfection::limit>},
    {"sensor.bias.roll", -0.2, 0.2, "of the attitude [rad]",
     [](SimSettings& s, double v, double) { s.sensors.roll_bias = v; }},
    {"sensor.bias.pitch", -0.2, 0.2, "of the attitude [rad]",
     [](SimSettings& s, double v, double) { s.sensors.pitch_bias = v; }},
    {"sensor.rate.encoder", 0.0, 1e5, "samples a second, 0: one a tick [Hz]",
     [](SimSettings& s, double v, double) { s.sensors.encoder_rate = v; }},
    {"sensor.rate.imu", 0.0, 1e5, "samples a second, 0: one a tick [Hz]",
     [](SimSettings& s, double v, double) { s.sensors.imu_rate = v; }},
    {"sensor.rate.force", 0.0, 1e5, "feet and hands, samples a second, 0: one a tick [Hz]",
     [](SimSettings& s, double v, double) { s.sensors.force_rate = v; }},
    {"sensor.foot_forces", 0.0, 1.0, "0: the feet have no force sensors",
     [](SimSettings& s, double v, double) { s.sensors.foot_forces = v != 0.0; }},
    {"sensor.imu_yaw_drift", -1.0, 1.0, "of the attitude about the vertical [rad/s]",
     [](SimSettings& s, double v, double) { s.sensors.yaw_drift = v; }},
    {"sensor.delay_ms", 0.0, kDelayMs, "of all sensors, whole periods [ms]",
     [](SimSettings& s, double v, double period) { s.sensors.delay_ticks = ticks(v, period); }},
    {"sensor.seed", 0.0, 9e15, "of the noise",
     [](SimSettings& s, double v, double) { s.sensors.seed = static_cast<std::uint64_t>(v); }},
};

}  // namespace

std::string apply_setting(const std::string& key, const std::string& value, double period,
                          SimSettings& settings) {
  if (key == "engine") {
    if (engine_of(value, settings.world.engine)) return "";
    return "setting engine=" + value + ": must be " + any_of(kEngineNames);
  }
  if (key == "contact") {
    if (contact_of(value, settings.world.contact)) return "";
    return "setting contact=" + value + ": must be " + any_of(kContactNames);
  }
  const Entry* nearest = kEntries;
  for (const Entry& entry : kEntries) {
    if (edits(key, entry.key) < edits(key, nearest->key)) nearest = &entry;
    if (key != entry.key) continue;
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0' || !(number >= entry.low && number <= entry.high)) {
      return "setting " + key + "=" + value + ": must be a number" +
             formatted(" from %g to %g (%s)", entry.low, entry.high, entry.meaning);
    }
    entry.set(settings, number, period);
    return "";
  }
  return "unknown setting '" + key + "': the nearest is '" + nearest->key + "' (" +
         nearest->meaning + ")";
}

void apply_settings(const std::vector<std::pair<std::string, std::string>>& list, double period,
                    SimSettings& settings) {
  for (const auto& [key, value] : list) {
    const std::string complaint = apply_setting(key, value, period, settings);
    if (!complaint.empty()) throw std::runtime_error(complaint);
  }
}

std::string settings_help() {
  std::string help = choices_help("engine", "physics engine", kEngineNames, kEngineMeanings) +
                     choices_help("contact", "what pushes back where something touches", kContactNames, kContactMeanings);
  for (const Entry& entry : kEntries) {
    help += formatted("  %-27s %8g .. %-8g %s\n", entry.key, entry.low, entry.high, entry.meaning);
  }
  return help;
}

}  // namespace twinbus::sim
