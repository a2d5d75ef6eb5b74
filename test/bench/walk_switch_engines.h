// A walk goes from one simulator to another engine and back, at every phase of the step and with late sources.

#pragma once

#include "robot/description/model.h"

namespace twinbus {

struct EngineSwitches {
  int count = 60;      // phases over two steps
  double speed = 0.3;  // [m/s]
  bool trace = false;  // a line for every switch
};

// Prints a line for each lateness and engine; 1 if a robot fell, a STATE had no answer or a commanded acceleration was
// over 1.5 times that of walking.
int switch_engines(const Model& model, const EngineSwitches& how);

}  // namespace twinbus
