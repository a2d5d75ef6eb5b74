// The elements and attributes that URDF and SRDF know, and what becomes of others.
//
// A name one or two letters off a known one is a mistake and refused: `<colision>` would lose the shape, `velocty=` the
// limit.  Extensions of other programs (gazebo, drake, mujoco ...) pass.  Anything else is ignored, and said.

#pragma once

#include <string>
#include <vector>

#include "common/text/xml.h"

namespace twinbus::inline robot {

// What may stand in an element.
struct KnownElement {
  const char* name;
  std::vector<const char*> attributes;
  std::vector<KnownElement> children;
  bool open = false;  // of another program: not looked into
  bool once = false;  // a second one in the same element would be lost
};

const KnownElement& known_urdf();
const KnownElement& known_srdf();

// Throws std::runtime_error with file, line and the name meant for a name close to a known one.  Adds one line to notes for
// each kind of name that is ignored.
void check_names(const XmlElement& root, const KnownElement& known, const std::string& file,
                 std::vector<std::string>& notes);

}  // namespace twinbus::robot
