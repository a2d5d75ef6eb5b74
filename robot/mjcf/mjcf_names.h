// The elements and attributes of MJCF that are read here, and what becomes of others.
//
// As for a URDF: a name one or two letters off a known one is refused, anything else that is not known is ignored and said.
// Source: the table of elements of MuJoCo 4.0.

#pragma once

#include <string>
#include <vector>

#include "common/text/xml.h"

namespace twinbus::inline robot {

// What the children of an element are checked as: "mujoco", "body", "equality/joint" ...; empty: not looked into.
std::string mjcf_context(const std::string& parent, const std::string& element);

// Checks attributes of one element and names of its children.  Throws std::runtime_error with file, line and the name
// meant; adds to notes what is ignored.
void check_mjcf_names(const XmlElement& element, const std::string& context, const std::string& file,
                      std::vector<std::string>& notes);

}  // namespace twinbus::robot
