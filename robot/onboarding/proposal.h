// robot.yaml and SRDF for a robot that has none: a beginning that stands, to be corrected by people.

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/onboarding/anatomy.h"
#include "robot/description/load.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

struct Proposal {
  std::string yaml, srdf;
  std::vector<std::string> doubts;  // what people must look at
};

// Gains that the robot's description gives a joint.
struct KnownServo {
  std::string joint;
  double kp = 0.0, kd = 0.0;  // [N m/rad], [N m s/rad]; a kd of 0 is proposed
};

// What the specification of a policy says of the robot of its training; taken where the robot's own files say nothing.
struct TrainedJoint {
  std::string joint;
  double rotor_inertia = 0.0;  // [kg m^2]; 0 not said
  double friction = 0.0;       // Coulomb [N m]; 0 not said
};

// What is known of the robot besides its model.
struct ProposalSource {
  std::string urdf_name;                                      // file name beside robot.yaml
  std::vector<std::pair<std::string, std::string>> packages;  // name and folder
  UrdfRepairs repairs;                                        // made when it was loaded
  std::string srdf_text, srdf_file;  // an SRDF that is there already; both may be empty
  std::vector<std::string> notes;    // what else was done to the URDF
  // What an MJCF model says and a URDF cannot.
  std::string srdf_origin = "the SRDF that was there";    // what srdf_text is, for messages
  std::optional<bool> floating;                           // else a robot with soles floats
  bool planar = false;                                    // its base moves on the plane; floating is false then
  std::string imu;                                        // frame; empty: one of the trunk
  std::vector<KnownServo> servos;
  bool servos_apply = true;                               // else they are a remark beside the proposed ones
  std::vector<std::pair<std::string, double>> friction;   // frame and coefficient
  std::string mujoco;                                     // the map of robot.yaml, of a MuJoCo model
  std::vector<TrainedJoint> trained;                      // of the specification of a policy
};

// Whether a robot is proposed with a free base: as the source says, else if it has legs.
bool floats(const Model& model, const ProposalSource& source);

// model: as load_repaired_urdf made it.  Of an SRDF that is there, poses, disabled pairs and rotors
// are kept, as far as they fit the URDF.
Proposal propose(const Model& model, const ProposalSource& source);

// Leaves out of the SRDF what touches at rest only when the proposal is loaded, as `loaded` is: with fingers that are
// part of the hands, a hand may touch where the finger did.
void exempt_at_rest(const Model& loaded, Proposal& proposal);

// The SRDF that belongs to a URDF: of its name beside it or in ../srdf, or the only one there;
// empty when there is none.
std::string find_srdf(const std::string& urdf_file);

// Mesh names relative to the URDF's folder as package://FOLDER/..., so that a copy elsewhere finds
// them; adds that package if there was one.  FOLDER is the URDF's, or one of the three above it if meshes lie
// there (urdf/ beside meshes/).  A file that is not where its package://, file:// or absolute name says is looked for there
// by the end of that name, in small letters or capitals: folders are renamed, and workspaces of other machines are written into files.
std::string with_packages(const std::string& urdf_text, const std::string& urdf_file,
                          std::vector<std::pair<std::string, std::string>>& packages);

// Folders of the package:// names that a URDF mentions, looked for above the file: the nearest
// folder of that name, or one that has it.
std::vector<std::pair<std::string, std::string>> find_packages(const std::string& urdf_file);

}  // namespace twinbus::robot
