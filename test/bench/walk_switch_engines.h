// A robot that walks or stands goes from one simulator to another engine and back, at every phase of the step and with late sources.

#pragma once

#include "robot/description/model.h"

namespace twinbus {

struct EngineSwitches {
  int count = 60;      // phases over two steps
  double speed = 0.3;  // [m/s]
  bool stands = false; // in balance
  bool trace = false;  // a line for every switch
};

// From one foot's being put down to the next one's, of soles or of point feet that trot [s].
double step_time_of(const Model& model);

// Prints a line for each lateness and engine; 1 if a robot fell, a STATE had no answer or a commanded acceleration was
// over 1.5 times that of walking; standing, if a torque of the body that took over jumped by more than 5 % of its limit, or a foot force by
// more than 10 % of the weight.
int switch_engines(const Model& model, const EngineSwitches& how);

}  // namespace twinbus
