// How a robot is to walk: the map `walking` of robot.yaml.
//
// Only what its makers choose; what follows from its legs and soles is not in here.  Not part of the model's hash: it is
// the same robot however it walks.

#pragma once

#include <limits>

namespace twinbus::inline robot {

// Of four point feet: diagonal pairs in turn; one foot at a time; that where the speed asked for is within its reach, else a trot.
enum class PointGait { kTrot, kCrawl, kBySpeed };

struct Walking {
  double single_support = 0.5;  // of a step [s]
  double double_support = 0.1;
  double width = 0.0;         // between the sole frames, 0: as legs and soles say [m]
  double lift = 0.05;         // of the swing foot [m]
  double com_height = 0.0;    // of the centre of mass above the ground, 0: as the legs say [m]
  // Of the reference zero-moment point before a sole frame [m]; NaN: 0.03, or as much as the ankles can hold.
  double zmp_forward = std::numeric_limits<double>::quiet_NaN();
  double zmp_inward = 0.005;  // and towards the other foot [m]; soles that no ankle rolls carry at their edges, whatever is said
  double fastest = 0.0;       // forward that commands may ask for, 0: as the legs say [m/s]
  bool preview = false;  // reference by preview control, not in closed form: `pattern: preview`
  PointGait gait = PointGait::kTrot;  // `gait: trot`, `crawl` or `by_speed`
  bool own_attitude = false;  // from gyro and accelerometer, not the IMU's: `attitude: estimated`
};

}  // namespace twinbus::robot
