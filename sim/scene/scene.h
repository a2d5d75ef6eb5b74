// A scene: what stands where, what is asked of the robot and when, and when the run counts as
// passed.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bridge/source/scene_script.h"
#include "robot/collision/collision.h"
#include "robot/description/loops.h"
#include "robot/description/model.h"
#include "robot/motion/motion_clip.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/step_list.h"
#include "sim/scene/scene_criteria.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

struct Push {  // constant force on a link for a while
  std::string link;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // in the link frame [m]
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  // world [N s]
  double at = 0.0;                                    // [s] of scene time
  double duration = 0.1;                              // [s]
};

struct TimedMode : Scripted<ModeRequest> {
  std::string pose;  // named pose of the robot that request.q is to take; see resolve_poses
};

struct TimedGoal : Scripted<ArmGoal> {
  std::string pose;
  std::string hand;  // left, right, or as robot.yaml calls an arm; resolve_poses makes request.side of it
  // Of a goal for any arm: from the shoulder, in shares of the stretched arm; resolve_poses makes the position of it.
  bool of_reach = false;
  Eigen::Vector3d reach = Eigen::Vector3d::Zero();
};

using TimedWalk = Scripted<WalkCommand>;  // said again and again while it lasts
using TimedPad = Scripted<Gamepad>;       // held so
using TimedSteps = Scripted<StepList>;    // obeyed in mode walk while the robot stands

// A motion file that is played; resolve_poses makes the pieces of it.
struct TimedMotion {
  double at = 0.0;  // [s]
  std::string file, columns;
  double rate = 0.0, speed = 1.0, from = 0.0, until = 0.0;  // as in robot/motion/motion_file.h
  bool upper_only = false;
  double period = 0.0;  // between frames [s]
  std::vector<MotionPiece> pieces;
};

// Uneven ground: square tiles of random height and slope from x = from on; see scene_seed.
struct Terrain {
  double tile = 0.3;    // edge [m]
  double height = 0.0;  // of a tile, 0 to this [m]
  double slope = 0.0;   // about x and y, +- this [rad]
  double ramp =
      0.0;  // the first third goes up so steeply, the second is level, the last goes down [rad]
  double from = 0.4, length = 0.0;  // along x [m]; 0: no tiles
  double width = 1.8;               // along y, about the x axis [m]
};

// Pushes one after the other, each in the next of eight directions and at a phase of its own; see scene_seed.
struct PushRound {
  std::string link;                                  // empty: the base
  double at = 4.0, every = 5.0;                      // [s]
  int count = 0;                                     // 0: none
  double phase = 0.6;                                // a push comes up to so much later [s]
  double forward = 0.0, back = 0.0, sideways = 0.0;  // change of velocity of the whole robot [m/s]
  double duration = 0.1;                             // [s]
};

// Each seed is another world: how far from what the scene says its start may be drawn, evenly within +- this;
// see scene_seed.
struct Disturbance {
  double position = 0.0;  // of each loose body, along each axis [m]
  double angle = 0.0;     // about each of its axes [rad]
  double velocity = 0.0;  // along each axis [m/s]
  double spin = 0.0;      // about each axis [rad/s]
  double mass = 0.0;      // of each loose body and of the robot as a whole, relative
  double friction = 0.0;  // of each loose body and of the ground, relative
  double joints = 0.0;    // speed of each of the robot's joints at the start [rad/s or m/s]
  bool level = false;     // what is loose stays as high and as upright as it was
};

// The simulated robot is not the one that the controller knows: a mass on a link, a shifted centre of mass.
struct BodyChange {
  std::string link;
  double mass = 0.0;                                // added [kg]
  Eigen::Vector3d at = Eigen::Vector3d::Zero();     // where, in the link frame [m]
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  // of the link's own centre of mass [m]
};

// A hand, or any link, grips something as it then lies in it, and lets it go.
struct Grasp {
  std::string link;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // in its frame [m]
  std::string to;                // a loose body, a link, NAME/LINK of a further robot or world
  double at = 0.0, until = 1e9;  // [s] of scene time
  double reach = 0.03;           // of the three points that hold, from that one [m]
  double stiffness = 1e6;        // of all three [N/m]
  double damping = 1e3;          // [N s/m]
};

// A further robot that nothing commands: it stands in a pose, its servos hold it.
struct SceneRobot {
  std::string name;
  std::string robot;  // as Scene::robot
  std::string pose = "half_sitting";
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();  // of the middle between its soles
};

struct Scene {
  std::string name;
  std::string robot = "hrp1s";
  std::string engine = "articulated";     // or ode, mujoco
  std::string contact = "spring_damper";  // or hunt_crossley, patch, or rigid, engine ode only
  double duration = 10.0;                 // [s] of `twinbus run`
  std::string about;                      // one sentence
  double accuracy = 0.0;  // error asked for: `run` finds order and step that hold it [m]; 0: not asked
  TrustBands bands;       // no key: of the run that was found, WorldConfig::bands
  std::string fidelity = "full";           // or auto, legs, rigid: sim/scene/fidelity.h
  std::vector<std::string> held, rigid;    // joints, further robots: the same
  std::vector<std::string> aloft, untouched;  // links of the robot: the same
  double step = 0.0;  // physics step [s], a whole part of the robot's period; 0: the period
  std::string start_pose = "half_sitting";
  std::vector<std::pair<std::string, double>> start_velocity;  // of joints [rad/s or m/s]
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // where in the simulated world all of it begins [m]
  bool fixed_base = false;
  bool in_arm_lengths = false;  // obstacles, loose bodies and where these end count from the shoulder, in lengths of the arm
  double ground_friction = 0.8;
  std::vector<Obstacle> obstacles;  // in the ground frame, for planner, guard and the world
  std::vector<Push> pushes;
  std::vector<TimedMode> modes;
  std::vector<TimedGoal> goals;
  std::vector<TimedWalk> walks;
  std::vector<TimedPad> pads;
  std::vector<TimedSteps> steps;
  std::vector<TimedMotion> motions;
  Terrain terrain;
  std::vector<Obstacle> tiles;  // of the terrain: ground to the soles, unknown to planner and guard
  PushRound push_round;
  Disturbance disturbance;
  bool robust = false;             // holds in worlds that are a little different: those of several seeds are
  std::vector<BodyChange> bodies;
  std::vector<LooseBody> loose;    // bodies that nothing holds; planner and guard do not know them
  std::vector<std::string> loose_at;  // where each has its name: "file:line: name"
  std::vector<SceneRobot> robots;  // nor these
  bool self_contact = false;       // links of one robot touch one another
  bool asleep = false;             // loose bodies that lie still, until something touches them
  std::vector<Loop> loops;         // beside those of the robot
  std::vector<Grasp> grasps;
  Criteria criteria;
  std::string text;                                           // as read
  std::string scaled;  // what scale_to made of it for the robot, in words; empty: nothing
  std::vector<std::pair<std::string, std::string>> settings;  // model.mass_scale=1.03 and the like
};

// Finds what the scene names by what it is (scene_places.h), and fills q and joint_mask of the modes and goals that name a pose, in bus order.  Throws
// std::runtime_error if the robot has no such pose.
void resolve_poses(Scene& scene, const Model& model);
// The motion of the robot that begins in the scene's start_pose.  Throws std::runtime_error.
MotionClip clip_of(const TimedMotion& timed, const Scene& scene, const Model& model);
// Lets the scene begin in another named pose.  Throws std::runtime_error that names the nearest one if the robot has none such.
void start_in(const std::string& pose, const Model& model, Scene& scene);

// name_or_file: a YAML file, or a name under config/scenes.  Throws std::runtime_error naming file,
// line and the nearest valid key.
//
// Keys: about, robot, engine (articulated, ode or mujoco), contact (spring_damper, hunt_crossley, patch or rigid), duration, step, accuracy (0.001 or 1 mm), fidelity, held, aloft, untouched and rigid as in
// sim/scene/fidelity.h, start_pose, start_velocity: {JOINT: speed, ...}, origin, base (floating or fixed), lengths (metres or arm), ground:
// {friction}, obstacles: see scene_obstacle.h, pushes: [link, point, impulse, at,
// duration], modes: [at, mode, motion, pose, duration, amplitude, frequency], goals: [at, hand,
// position, reach (from the shoulder, in lengths of the arm), rpy_deg, pose, speed, cancel], walks: [at, for, vx, vy, wz], pads: [at, for, left_x, left_y, right_x],
// footsteps: [at, steps: [foot, x, y, yaw]], motions: [at, file, columns, rate, speed, from, until, upper],
// terrain: {tile, height, slope_deg, ramp_deg, from, length, width}, push_round: {link, at, every, count, phase, forward, back,
// sideways, duration}, disturbance: {position, angle_deg, velocity, spin, mass, friction, joints}, robust, bodies: [link, mass, at, shift], loose: [name, shape (box, sphere, cylinder,
// capsule, mesh), size (of a mesh: file beside the scene, scale), mass, position, rpy_deg, velocity,
// angular_velocity, friction, stiffness, damping], robots: [name, robot, pose, position, yaw_deg],
// self_contact, asleep, loops: as in robot/description/loops.h, grasps:
// [link, point, to, at, until, reach, stiffness, damping], criteria: as in sim/scene/scene_criteria.h, settings: {model.mass_scale: 1.03, ...} as in
// sim/scene/settings.h.  Scene time starts with the first command.
Scene load_scene(const std::string& name_or_file);

// "0.001", "1 mm", "0.1mm", "20 um" as metres; 0 if it is none of these or not positive.
double metres_of(const std::string& text);
// The same of an accuracy.  What is wrong with it, to be read after its key, or empty: a plain 1 is a metre, which nobody means.
std::string read_accuracy(const std::string& text, double& metres);

// Of config/scenes, by alphabet.
std::vector<std::string> scene_names();

}  // namespace twinbus::sim
