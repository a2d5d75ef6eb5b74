// The simulator's settings, `--set key=value`: one table of names, ranges and meanings.
//
// They describe how this simulation differs from the nominal robot (masses, friction, sensors,
// ground) and are no part of the model hash.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/scene/sensors.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

struct SimSettings {
  WorldConfig world;
  SensorOptions sensors;
  double servo_delay_ms = 0.0;  // between write() and the servo
};

// Applies key=value.  Returns an empty string, or one sentence that says what is wrong and names
// the nearest valid key.
std::string apply_setting(const std::string& key, const std::string& value, double period,
                          SimSettings& settings);

// All of a list; throws std::runtime_error with that sentence.
void apply_settings(const std::vector<std::pair<std::string, std::string>>& list, double period,
                    SimSettings& settings);

// Lines for --help: key, range, meaning.
std::string settings_help();

}  // namespace twinbus::sim
