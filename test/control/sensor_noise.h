// Settings of noisy sensors: standard deviations in SI units, as --set takes them.

#pragma once

#include <string>
#include <utility>

#include "test/control/sim_rig.h"

namespace twinbus::test {

struct SensorNoise {
  std::string encoder, velocity, attitude, gyro, force = "0", moment = "0";
};

inline Settings noisy(const SensorNoise& noise, Settings more = {}) {
  more.insert(more.end(), {{"sensor.noise.encoder", noise.encoder}, {"sensor.noise.velocity", noise.velocity},
                           {"sensor.noise.attitude", noise.attitude}, {"sensor.noise.gyro", noise.gyro},
                           {"sensor.noise.force", noise.force}, {"sensor.noise.moment", noise.moment}});
  return more;
}

}  // namespace twinbus::test
