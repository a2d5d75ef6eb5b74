// What is wrong in a URDF and has one likely right answer, put right on request: `./twinbus check ROBOT --mend`.

#pragma once

#include <string>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// A mesh that is touched so far from where it is drawn is one in a wrong place [m].
inline constexpr double kFarFromDrawn = 0.3;

// The text with these put right, each said in changes; the text as it is when nothing was.
// Links of a file without any <collision> are touched where they are drawn, of one without any mass get one each; sizes of nothing a millimetre; macros of xacro that only colour, and
// parts without a shape, are left out.
// Commas between three numbers become spaces.
// A mesh that is touched far from where the same mesh is drawn and the link weighs is put there.
// An inertia that no body has becomes the nearest that one has, a placeholder or a negative one that of a box around the
// link's geometry; an axis gets length 1; a range whose ends are exchanged is turned, one in degrees goes to radians; effort and
// speed limits that are none are those of the joint on the other side, else the middle ones of the robot's others of
// that kind, else a guess: of an effort twice what the joint carries with all behind it stretched out, at least 100.
std::string mend_urdf(const std::string& text, const std::string& file, std::vector<std::string>& changes);

// Left and right exchanged in the names of links and joints, where the feet point forward and the left one is on the right.
std::string mend_sides(const std::string& text, const std::string& file, const Model& model, std::vector<std::string>& changes);

// Ranges of legs that are no mirror images of each other though the joints are (robot/lint/mirrored_ranges.h): the one that
// legs need less is replaced.
std::string mend_images(const std::string& text, const std::string& file, const Model& model, std::vector<std::string>& changes);

// The inertia of a link that none within three times its geometry has (other units, or about another point) becomes that of a box
// around the geometry.
std::string mend_far_inertias(const std::string& text, const std::string& file, const Model& model,
                              std::vector<std::string>& changes);

// A body within a ball of radius r about its centre of mass has moments of at most 2/3 m r^2: the r of the largest one [m].
double shell_radius(const Link& link);
double shell_radius(double moment, double mass) noexcept;  // [kg m^2], [kg]

// What the same part is called on the other side, as far as names tell; several guesses or none.
std::vector<std::string> names_on_other_side(const std::string& name);

}  // namespace twinbus::robot
