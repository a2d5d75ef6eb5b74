// What `twinbus check` is asked about: a folder with robot.yaml, or a URDF or MJCF file that has none.

#pragma once

#include <string>

#include "robot/onboarding/proposal.h"

namespace twinbus::inline launcher {

struct CheckSubject {
  Model model;
  std::string urdf;  // file, when there is no robot.yaml; an MJCF file stands for the URDF made of it
  std::string text;  // of the URDF as it is proposed
  bool mjcf = false;
  ProposalSource source;
  Model repaired;  // what the proposal is made of
  std::vector<std::string> mended;  // what was put right in the text
};

// name: a robot of config/robots, a folder, a .urdf, or an .xml of MuJoCo.  Throws std::runtime_error, one line.
// mends: what is wrong in a URDF and has one likely right answer is put right.  base: floating, fixed or planar, where the user says so.
CheckSubject load_subject(const std::string& name, bool mends = false, const std::string& base = "");

// The robot that the proposal makes, as `run` will load it.  What is wrong with it is said of the user's file.
Model load_proposed(const Proposal& proposal, const CheckSubject& subject);

}  // namespace twinbus::launcher
