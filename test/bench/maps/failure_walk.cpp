// A robot walks while its servos come late, its loop turns slowly, its sensors are noisy.

#include <cmath>
#include <cstdint>
#include <string>

#include "robot/description/load.h"
#include "test/bench/maps/failure_scenes.h"
#include "test/control/hrp1s.h"
#include "test/control/sim_rig.h"

namespace twinbus {

// cell: "engine", "delay" of the servos [ms], "period" of the loop [ms], "noise" of every sensor, of that of walk_noisy.
nlohmann::json run_walk(const nlohmann::json& cell) {
  constexpr double kSpeed = 0.3, kSeconds = 6.0;
  Model model = load_robot("hrp1s");
  model.period_ns = static_cast<std::int32_t>(std::lround(1e6 * cell.at("period").get<double>()));
  Scene scene;
  const std::string engine = cell.at("engine").get<std::string>();
  scene.engine = engine == "ode" ? "ode" : "articulated";
  scene.step = std::min(0.002, model.period());
  const double noise = cell.at("noise").get<double>();
  Settings settings = {{"servo.delay_ms", std::to_string(cell.at("delay").get<double>())}};
  if (engine == "articulated2") settings.push_back({"solver.order", "2"});
  const std::pair<const char*, double> sensors[] = {{"encoder", 1e-5}, {"velocity", 0.01}, {"attitude", 0.002},
                                                    {"gyro", 0.01},    {"force", 5.0},     {"moment", 0.5}};
  for (const auto& [name, own] : sensors) settings.push_back({std::string("sensor.noise.") + name, std::to_string(noise * own)});
  SimRig rig(model, scene, settings, {});
  bool held = rig.run(0.5);
  rig.ask(Mode::kWalk);
  WalkCommand command;
  command.run_id = rig.state().run_id;
  command.vx = static_cast<float>(kSpeed);
  command.timeout = 0.2F;
  const auto ticks = static_cast<int>(std::lround(kSeconds / model.period()));
  const int each = std::max(1, static_cast<int>(std::lround(0.02 / model.period())));
  for (int i = 0; i < ticks && held; ++i) {
    if (i % each == 0) {
      command.sequence = i + 1;
      rig.loop().on_walk_command(command, rig.state().time_ns);
    }
    held = rig.tick() && !rig.record().fell;
  }
  return {{"held", held}};
}

}  // namespace twinbus
