// Motions from NPZ: root pose and joints as arrays, of the layouts that are in use.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

#include "common/math/index.h"
#include "common/text/printable.h"
#include "robot/motion/motion_file.h"
#include "robot/motion/npz.h"

namespace twinbus::inline robot {

namespace {


// The first of these names that the file has; null.
const NpyArray* find(const std::vector<NpyArray>& arrays,
                     std::initializer_list<const char*> names) {
  for (const char* name : names) {
    for (const NpyArray& array : arrays) {
      if (array.name == name) return &array;
    }
  }
  return nullptr;
}

std::string shape_text(const NpyArray& array) {
  std::string text = "(";
  for (const std::size_t d : array.shape) text += (text.size() > 1 ? ", " : "") + std::to_string(d);
  return text + ")";
}

void check_finite(const std::string& file, const NpyArray& array) {
  const auto bad = std::find_if(array.numbers.begin(), array.numbers.end(),
                                [](double x) { return !std::isfinite(x); });
  if (bad == array.numbers.end()) return;
  const auto index = static_cast<std::size_t>(bad - array.numbers.begin());
  const std::size_t row =
      array.shape.empty() ? 1 : std::max<std::size_t>(1, array.size() / array.shape[0]);
  refuse_npz(file + ": " + array.name, "frame " + std::to_string(index / row) + ", column " +
                                     std::to_string(index % row + 1) + " is no finite number");
}

// frames x width, the first body of frames x bodies x width.
std::vector<double> rows_of(const std::string& file, const NpyArray& array, std::size_t frames,
                            std::size_t width) {
  const bool flat = array.shape.size() == 2 && array.shape[1] == width;
  const bool bodies = array.shape.size() == 3 && array.shape[2] == width && array.shape[1] > 0;
  if (array.shape.empty() || array.shape[0] != frames || !(flat || bodies) || array.numbers.empty())
    refuse_npz(file + ": " + array.name, "has the shape " + shape_text(array) + ", and must have (" +
                                       std::to_string(frames) + ", " + std::to_string(width) +
                                       ") or a row of such for each body");
  check_finite(file, array);
  const std::size_t stride = flat ? width : width * array.shape[1];
  std::vector<double> rows(frames * width);
  for (std::size_t f = 0; f < frames; ++f)
    std::copy_n(array.numbers.begin() + static_cast<std::ptrdiff_t>(f * stride), width,
                rows.begin() + static_cast<std::ptrdiff_t>(f * width));
  return rows;
}

void read_times(const std::vector<NpyArray>& arrays, std::size_t frames, const MotionFormat& format,
                MotionFile& motion) {
  if (const NpyArray* time = find(arrays, {"time", "times", "timestamps"})) {
    if (format.rate > 0.0)
      refuse_npz(motion.file, "has its own times, and --rate says others: leave --rate out");
    if (time->numbers.size() != frames)
      refuse_npz(motion.file + ": " + time->name, "has " + std::to_string(time->numbers.size()) +
                                                " times for " + std::to_string(frames) + " frames");
    check_finite(motion.file, *time);
    for (std::size_t f = 1; f < frames; ++f) {
      if (!(time->numbers[f] > time->numbers[f - 1]))
        refuse_npz(motion.file + ": " + time->name,
             "frame " + std::to_string(f) + ": the time does not increase");
    }
    motion.time = time->numbers;
    return;
  }
  double rate = format.rate;
  if (const NpyArray* fps =
          find(arrays, {"fps", "rate", "framerate", "frame_rate", "mocap_framerate"});
      fps != nullptr && !(rate > 0.0)) {
    if (fps->numbers.size() != 1) refuse_npz(motion.file + ": " + fps->name, "must be one number");
    rate = fps->numbers[0];
  } else if (const NpyArray* dt = find(arrays, {"dt"}); dt != nullptr && !(rate > 0.0)) {
    if (dt->numbers.size() != 1) refuse_npz(motion.file + ": dt", "must be one number");
    rate = 1.0 / dt->numbers[0];
  }
  if (rate == 0.0)
    refuse_npz(motion.file, "has neither time nor fps nor dt: say its frames a second with --rate");
  if (!(rate >= 1.0 && rate <= 10'000.0))
    refuse_npz(motion.file, "says a rate outside 1 to 10000 frames a second; --rate says another");
  for (std::size_t f = 0; f < frames; ++f) motion.time.push_back(static_cast<double>(f) / rate);
}

void read_root(const std::vector<NpyArray>& arrays, std::size_t frames, const MotionFormat& format,
               MotionFile& motion) {
  const NpyArray* position =
      find(arrays, {"root_pos", "root_position", "root_trans", "body_pos_w", "body_positions"});
  const NpyArray* wxyz = find(arrays, {"root_quat", "body_quat_w", "body_rotations"});
  const NpyArray* rotation = find(arrays, {"root_rot"});
  if (position == nullptr || (wxyz == nullptr && rotation == nullptr)) return;
  const std::vector<double> p = rows_of(motion.file, *position, frames, 3);
  const NpyArray& turns = wxyz != nullptr ? *wxyz : *rotation;
  const std::vector<double> r = rows_of(motion.file, turns, frames, 4);
  const bool w_last = wxyz == nullptr && format.quaternion_xyzw;
  for (std::size_t f = 0; f < frames; ++f) {
    const double* q = r.data() + 4 * f;
    const Eigen::Quaterniond turn = w_last ? Eigen::Quaterniond(q[3], q[0], q[1], q[2])
                                           : Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
    if (!(std::abs(turn.norm() - 1.0) < kUnitTolerance))
      refuse_npz(motion.file + ": " + turns.name,
           "frame " + std::to_string(f) + ": the quaternion has not length 1");
    Eigen::Isometry3d& place = motion.root.emplace_back(Eigen::Isometry3d::Identity());
    place.linear() = turn.normalized().toRotationMatrix();
    place.translation() << p[3 * f], p[3 * f + 1], p[3 * f + 2];
  }
}

}  // namespace

MotionFile parse_motion_npz(const std::string& file, const std::string& bytes,
                            const MotionFormat& format) {
  const std::vector<NpyArray> arrays = read_npz(file, bytes);
  MotionFile motion;
  motion.file = file;
  const NpyArray* q = find(arrays, {"joint_pos", "joint_positions", "dof_pos", "dof_positions"});
  if (q == nullptr || q->shape.size() != 2 || q->shape[0] == 0 || q->shape[1] == 0)
    refuse_npz(file, "has no array joint_pos (or dof_pos, dof_positions) of frames x joints");
  const std::size_t frames = q->shape[0], width = q->shape[1];
  if (frames > static_cast<std::size_t>(kMostMotionFrames) ||
      width > static_cast<std::size_t>(kMostMotionColumns))
    refuse_npz(file + ": " + q->name,
         "has the shape " + shape_text(*q) + "; at most 1,000,000 frames of 512 joints are read");
  if (q->numbers.size() != frames * width) refuse_npz(file + ": " + q->name, "holds no numbers");
  check_finite(file, *q);
  motion.q = q->numbers;
  const NpyArray* names = find(arrays, {"joint_names", "dof_names"});
  motion.joints = names != nullptr ? names->texts : format.columns;
  if (names == nullptr) {  // an order of columns names the root, too, which has its own arrays here
    std::erase_if(motion.joints, [](const std::string& name) {
      return name == "time" || name.starts_with("root_");
    });
    if (motion.joints.empty())
      refuse_npz(file, "has no joint_names: say the order of its joints with --columns");
  }
  if (motion.joints.size() != width)
    refuse_npz(file, std::to_string(motion.joints.size()) + " names of joints for " +
                   std::to_string(width) + " columns of " + q->name);
  for (std::size_t i = 0; i < width; ++i) {
    if (std::find(motion.joints.begin(), motion.joints.begin() + static_cast<std::ptrdiff_t>(i),
                  motion.joints[i]) != motion.joints.begin() + static_cast<std::ptrdiff_t>(i))
      refuse_npz(file, "two joints are called " + printable(motion.joints[i], 60));
  }
  read_times(arrays, frames, format, motion);
  read_root(arrays, frames, format, motion);
  finish_motion(motion, format);
  return motion;
}

}  // namespace twinbus::robot
