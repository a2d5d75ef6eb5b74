// The files of an MJCF model as one tree: includes are put in, names are checked.

#pragma once

#include <string>
#include <vector>

#include "robot/mjcf/mjcf_element.h"

namespace twinbus::inline robot {

struct MjcfDocument {
  MjcfElement root;                // <mujoco>
  std::string folder;              // of the main file: file names in the model are relative to it
  std::vector<std::string> notes;  // what is ignored, with file and line
};

// Whether the file is to be read as MJCF: its name ends in .xml or .mjcf.
bool is_mjcf_name(const std::string& file);

// Throws std::runtime_error naming file and line: a file that is missing, is no XML or is included a second time, an include
// that leaves the folders around the model, too many files.
MjcfDocument read_mjcf(const std::string& file);

// The same of a text that is no file; includes are looked for in the folder of `file`.
MjcfDocument read_mjcf_text(const std::string& text, const std::string& file);

}  // namespace twinbus::robot
