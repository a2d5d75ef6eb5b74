#include "robot/motion/motion_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "common/math/index.h"
#include "common/text/printable.h"

namespace twinbus::inline robot {

namespace {

constexpr std::uintmax_t kMostBytes = 512U << 20U;
constexpr double kDefaultRate = 30.0;  // of lafan1 [Hz]
constexpr const char* kRoot[7] = {"root_x",  "root_y",  "root_z", "root_qw",
                                  "root_qx", "root_qy", "root_qz"};
constexpr const char* kLafan1[29] = {
    "left_hip_pitch_joint",      "left_hip_roll_joint",        "left_hip_yaw_joint",
    "left_knee_joint",           "left_ankle_pitch_joint",     "left_ankle_roll_joint",
    "right_hip_pitch_joint",     "right_hip_roll_joint",       "right_hip_yaw_joint",
    "right_knee_joint",          "right_ankle_pitch_joint",    "right_ankle_roll_joint",
    "waist_yaw_joint",           "waist_roll_joint",           "waist_pitch_joint",
    "left_shoulder_pitch_joint", "left_shoulder_roll_joint",   "left_shoulder_yaw_joint",
    "left_elbow_joint",          "left_wrist_roll_joint",      "left_wrist_pitch_joint",
    "left_wrist_yaw_joint",      "right_shoulder_pitch_joint", "right_shoulder_roll_joint",
    "right_shoulder_yaw_joint",  "right_elbow_joint",          "right_wrist_roll_joint",
    "right_wrist_pitch_joint",   "right_wrist_yaw_joint"};

[[noreturn]] void fail(const std::string& file, int line, const std::string& what) {
  throw std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : std::string()) + ": " +
                           what);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '"'))
    text.remove_prefix(1);
  while (!text.empty() &&
         (text.back() == ' ' || text.back() == '\t' || text.back() == '\r' || text.back() == '"'))
    text.remove_suffix(1);
  return text;
}

// Fields of a row: commas, semicolons or tabs part them, whichever the first row has.
char separator_of(std::string_view row) {
  for (const char c : {',', ';', '\t'}) {
    if (row.find(c) != std::string_view::npos) return c;
  }
  return ',';
}

void split(std::string_view row, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  for (std::size_t from = 0; from <= row.size();) {
    const std::size_t end = std::min(row.find(separator, from), row.size());
    fields.push_back(trimmed(row.substr(from, end - from)));
    from = end + 1;
  }
  if (fields.size() > 1 && fields.back().empty())
    fields.pop_back();  // a separator at the end of the row
}

bool to_number(std::string_view text, double& number) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

// Where each column goes.
struct Columns {
  std::vector<int> of;  // a joint, or one of the constants below
  int count = 0;
};
constexpr int kUnused = -2, kTime = -1, kFirstRoot = 10'000;

Columns bind(const std::string& file, int line, const std::vector<std::string>& names,
             MotionFile& motion, bool& root) {
  Columns columns;
  columns.count = static_cast<int>(names.size());
  unsigned roots = 0;
  bool timed = false;
  for (const std::string& name : names) {
    const auto known = std::find(std::begin(kRoot), std::end(kRoot), name);
    if (name.empty())
      fail(file, line, "column " + std::to_string(columns.of.size() + 1) + " has no name");
    if (name == "-") {
      columns.of.push_back(kUnused);
    } else if (name == "time") {
      if (timed) fail(file, line, "two columns are called time");
      timed = true;
      columns.of.push_back(kTime);
    } else if (known != std::end(kRoot)) {
      const auto i = static_cast<unsigned>(known - std::begin(kRoot));
      if ((roots >> i & 1U) != 0) fail(file, line, "two columns are called " + name);
      roots |= 1U << i;
      columns.of.push_back(kFirstRoot + static_cast<int>(i));
    } else {
      if (std::find(motion.joints.begin(), motion.joints.end(), name) != motion.joints.end())
        fail(file, line, "two columns are called " + printable(name, 60));
      columns.of.push_back(static_cast<int>(motion.joints.size()));
      motion.joints.push_back(name);
    }
  }
  if (motion.joints.empty())
    fail(file, line,
         "names no joint; a header row names the columns: time, root_x ... root_qz, joints");
  if (roots != 0 && roots != 0x7fU)
    fail(file, line,
         "a root needs all of root_x root_y root_z root_qw root_qx root_qy root_qz, and some are "
         "missing");
  root = roots != 0;
  return columns;
}

}  // namespace

std::vector<std::string> motion_columns(const std::string& name_or_file) {
  std::vector<std::string> names;
  if (name_or_file == "lafan1") {
    for (const int i : {0, 1, 2, 4, 5, 6, 3}) names.emplace_back(kRoot[i]);
    names.insert(names.end(), std::begin(kLafan1), std::end(kLafan1));
    return names;
  }
  std::ifstream stream(name_or_file);
  if (!stream)
    throw std::runtime_error(
        "no columns '" + printable(name_or_file, 200) +
        "': say lafan1, or a file with the names of the columns in their order");
  std::string word;
  for (char c = 0; stream.get(c);) {
    const bool parts = c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!parts) word += c;
    if (word.size() > 200 || names.size() > kMostMotionColumns)
      throw std::runtime_error(name_or_file + ": is no list of at most 512 names of columns");
    if (parts && !word.empty()) names.push_back(std::exchange(word, {}));
  }
  if (!word.empty()) names.push_back(word);
  if (names.empty())
    throw std::runtime_error(name_or_file +
                             ": is empty; it gives the names of the columns in their order");
  return names;
}

MotionFile parse_motion_csv(const std::string& file, const std::string& text,
                            const MotionFormat& format) {
  MotionFile motion;
  motion.file = file;
  Columns columns;
  bool root = false, timed = false, header = !format.columns.empty();
  if (header) columns = bind(file, 0, format.columns, motion, root);
  char separator = 0;
  std::vector<std::string_view> fields;
  std::array<double, 7> pose{};
  int line = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string_view row = trimmed(std::string_view(text).substr(from, end - from));
    from = end + 1;
    if (++line == 1 && row.starts_with("\xef\xbb\xbf")) row.remove_prefix(3);
    if (row.empty() || row.front() == '#') continue;
    if (separator == 0) separator = separator_of(row);
    split(row, separator, fields);
    if (static_cast<int>(fields.size()) > kMostMotionColumns)
      fail(file, line, "has more than 512 columns");
    double number = 0.0;
    const bool names = !fields.empty() && !to_number(fields[0], number) && !fields[0].empty() &&
                       motion.time.empty();
    if (!header && names) {
      columns = bind(file, line, {fields.begin(), fields.end()}, motion, root);
      header = true;
      continue;
    }
    if (!header)
      fail(file, line,
           "has no header row; --columns says what the columns are: lafan1, or a file of names");
    if (names) continue;  // a header that --columns overrules
    if (static_cast<int>(fields.size()) != columns.count)
      fail(file, line,
           "has " + std::to_string(fields.size()) + " columns, and must have " +
               std::to_string(columns.count));
    if (motion.frames() >= kMostMotionFrames)
      fail(file, line, "is the 1,000,001st frame; cut it with --from and --until, or in pieces");
    double time = static_cast<double>(motion.time.size());
    const std::size_t base = motion.q.size();
    motion.q.resize(base + motion.joints.size());
    for (std::size_t c = 0; c < fields.size(); ++c) {
      const int to = columns.of[c];
      if (to == kUnused) continue;
      if (!to_number(fields[c], number))
        fail(file, line,
             "column " + std::to_string(c + 1) + ": '" +
                 printable(std::string(fields[c].substr(0, 40)), 40) + "' is no finite number");
      if (to == kTime) {
        time = number;
        timed = true;
      } else if (to >= kFirstRoot) {
        pose[at(to - kFirstRoot)] = number;
      } else {
        motion.q[base + at(to)] = number;
      }
    }
    if (timed && !motion.time.empty() && !(time > motion.time.back()))
      fail(file, line,
           "the time does not increase: " + std::to_string(time) + " s after " +
               std::to_string(motion.time.back()) + " s");
    motion.time.push_back(time);
    if (!root) continue;
    Eigen::Quaterniond turn(pose[3], pose[4], pose[5], pose[6]);
    if (!(std::abs(turn.norm() - 1.0) < kUnitTolerance))
      fail(file, line,
           "the quaternion of the root has length " + std::to_string(turn.norm()) +
               ", and must have 1");
    Eigen::Isometry3d& place = motion.root.emplace_back(Eigen::Isometry3d::Identity());
    place.linear() = turn.normalized().toRotationMatrix();
    place.translation() << pose[0], pose[1], pose[2];
  }
  if (motion.time.empty()) fail(file, 0, "has no frames");
  if (!timed) {
    const bool lafan1 = format.columns.size() == 36 && format.columns == motion_columns("lafan1");
    const double rate = format.rate > 0.0 ? format.rate : lafan1 ? kDefaultRate : 0.0;
    if (!(rate > 0.0)) fail(file, 0, "has no column time: say its frames a second with --rate");
    for (double& time : motion.time) time /= rate;
  } else if (format.rate > 0.0) {
    fail(file, 0, "has a column time, and --rate says another: leave one out");
  }
  finish_motion(motion, format);
  return motion;
}

void finish_motion(MotionFile& motion, const MotionFormat& format) {
  const auto first = std::lower_bound(motion.time.begin(), motion.time.end(),
                                      motion.time.front() + format.from - 1e-9);
  const auto last = format.until > 0.0 ? std::upper_bound(motion.time.begin(), motion.time.end(),
                                                          motion.time.front() + format.until + 1e-9)
                                       : motion.time.end();
  if (last - first < 2)
    fail(motion.file, 0, "has fewer than two frames between --from and --until");
  const auto a = first - motion.time.begin(), b = last - motion.time.begin();
  const auto width = static_cast<std::ptrdiff_t>(motion.joints.size());
  motion.q = std::vector<double>(motion.q.begin() + a * width, motion.q.begin() + b * width);
  if (!motion.root.empty())
    motion.root = std::vector<Eigen::Isometry3d>(motion.root.begin() + a, motion.root.begin() + b);
  motion.time = std::vector<double>(first, last);
  const double start = motion.time.front();
  for (double& time : motion.time) time -= start;
}

MotionFile read_motion(const std::string& file, const MotionFormat& format) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream)
    throw std::runtime_error(printable(file, 300) +
                             ": cannot be read: there is no such file, or it may not be read");
  if (size > kMostBytes)
    throw std::runtime_error(file + ": is larger than 512 MB; cut it into pieces");
  std::stringstream text;
  text << stream.rdbuf();
  const std::string bytes = text.str();
  if (bytes.starts_with("PK")) return parse_motion_npz(file, bytes, format);
  if (bytes.find('\0') != std::string::npos)
    throw std::runtime_error(
        file + ": is neither CSV nor NPZ; a pickle or HDF5 is saved as NPZ by numpy.savez");
  return parse_motion_csv(file, bytes, format);
}

}  // namespace twinbus::robot
