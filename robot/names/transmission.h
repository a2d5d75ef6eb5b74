// <transmission> elements of a URDF: gear ratio and rotor inertia of a joint.
//
// URDF has no word for the inertia of a rotor; read are <mechanicalReduction> of ROS and
// drake:rotor_inertia, drake:gear_ratio of Drake.  A rotor of inertia J behind a gear of ratio n
// weighs on the joint like n^2 J.

#pragma once

#include <string>
#include <vector>

#include "common/text/xml.h"

namespace twinbus::inline robot {

struct Transmission {
  std::string joint;
  int line = 0;
  double gear_ratio = 1.0;
  double rotor_inertia = 0.0;  // of the rotor itself [kg m^2]

  double reflected() const { return gear_ratio * gear_ratio * rotor_inertia; }  // at the joint
};

// All of a robot, in document order.  Throws std::runtime_error naming file, line and element when
// a number is none, or when a joint is moved by two rotors of different numbers.
std::vector<Transmission> read_transmissions(const XmlElement& robot, const std::string& file);

}  // namespace twinbus::robot
