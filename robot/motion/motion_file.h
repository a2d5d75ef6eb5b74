// A recorded or designed motion as its file has it: times, joints by name, and the pose of the root if it says so.
//
// CSV with a header row of names, CSV without one in a named order of columns, or NPZ of numpy.  Nothing is known of a
// robot here; motion_clip.h binds the names.  Every file is of somebody else: sizes, numbers and times are checked, and what is
// wrong is one error that names file, line and column.

#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace twinbus::inline robot {

constexpr double kUnitTolerance = 0.05;  // that a quaternion may be off its length, by rounding

struct MotionFile {
  std::string file;
  std::vector<std::string> joints;  // one a column of q
  std::vector<double> time;         // [s], increasing, the first is 0; one a frame
  std::vector<double> q;            // [frames x joints], frame by frame [rad or m]
  std::vector<Eigen::Isometry3d>
      root;  // of the base in the file's world; empty: the file does not say
  int frames() const { return static_cast<int>(time.size()); }
  double at(int frame, int joint) const {
    return q[static_cast<std::size_t>(frame) * joints.size() + static_cast<std::size_t>(joint)];
  }
};

struct MotionFormat {
  double rate = 0.0;  // frames a second of a file without times [Hz]; 0: as it says
  std::vector<std::string> columns = {};  // names of those of a CSV without a header; `-`: not used
  bool quaternion_xyzw = true;     // order of root_rot in an NPZ
  double from = 0.0, until = 0.0;  // the part that is taken [s]; until 0: to the end
};

// Largest files that are read.
inline constexpr int kMostMotionFrames = 1'000'000;
inline constexpr int kMostMotionColumns = 512;

// CSV: names of columns are `time`, root_x root_y root_z root_qw root_qx root_qy root_qz, and joints; others are an error.
// NPZ (motion_npz.h): joints and their names, rate or times, root.  Throws std::runtime_error that says what is wrong where.
MotionFile read_motion(const std::string& file, const MotionFormat& format);

// The same of text that was read already; file: what errors call it.
MotionFile parse_motion_csv(const std::string& file, const std::string& text,
                            const MotionFormat& format);
MotionFile parse_motion_npz(const std::string& file, const std::string& bytes,
                            const MotionFormat& format);

// Names of columns: `lafan1` (root_x y z, quaternion x y z w, then the 29 joints of Unitree's G1 as the retargeted LAFAN1
// dataset has them), else a file of names.  Throws std::runtime_error.
std::vector<std::string> motion_columns(const std::string& name_or_file);

// Checks times, takes the part from..until, makes quaternions unit.  Called by the two above.
void finish_motion(MotionFile& motion, const MotionFormat& format);

}  // namespace twinbus::robot
