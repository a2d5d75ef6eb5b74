#include "launcher/check/subject.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/description/load.h"
#include "robot/description/urdf.h"
#include "robot/mjcf/mjcf_document.h"
#include "robot/mjcf/mjcf_to_urdf.h"
#include "robot/onboarding/base_turn.h"
#include "robot/lint/mend.h"
#include "robot/lint/mesh_axis.h"

namespace twinbus::inline launcher {

namespace {

namespace fs = std::filesystem;

std::string only_urdf(const std::string& folder) {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".urdf") found.push_back(entry.path().string());
  }
  if (found.size() == 1) return found.front();
  throw std::runtime_error(folder + ": has neither robot.yaml nor one .urdf, but " +
                           std::to_string(found.size()) + "; name the file");
}

// The URDF of an MJCF file, and in source what a URDF cannot say.
std::string urdf_of_mjcf(const std::string& file, ProposalSource& source) {
  const MjcfRobot robot = import_mjcf(file);
  source.srdf_text = robot.srdf;
  source.srdf_file = file;
  source.srdf_origin = "the MJCF";
  source.floating = robot.floating;
  source.imu = robot.imu;
  for (const MjcfServo& servo : robot.servos) source.servos.push_back({servo.joint, servo.kp, servo.kd});
  source.friction = robot.friction;
  source.mujoco = mujoco_yaml(robot.mujoco);
  source.notes = robot.notes;
  return robot.urdf;
}

// Of the user's file, what is most likely wrong when nothing can be made of its numbers.
std::string likely_cause(const CheckSubject& subject) {
  constexpr double kHeavy = 1000.0;  // [kg]
  const bool as_given = !subject.mjcf && subject.mended.empty();  // lines are those of the file
  const UrdfTree tree = parse_urdf(subject.text, subject.urdf,
                                   {.folder = fs::path(subject.urdf).parent_path().string(),
                                    .packages = subject.source.packages});
  const auto lighter = [](const UrdfLink& a, const UrdfLink& b) { return a.mass < b.mass; };
  const auto heaviest = std::max_element(tree.links.begin(), tree.links.end(), lighter);
  if (heaviest != tree.links.end() && heaviest->mass > kHeavy) {
    return "; look at " + subject.urdf + (as_given ? ":" + std::to_string(heaviest->line) : "") + ": link " + heaviest->name +
           formatted(" weighs %.3g kg", heaviest->mass);
  }
  const UrdfJoint* farthest = nullptr;
  for (const UrdfJoint& joint : tree.joints) {
    if (farthest == nullptr ||
        joint.origin.translation().norm() > farthest->origin.translation().norm())
      farthest = &joint;
  }
  if (farthest == nullptr) return "";
  const std::string line = as_given ? ":" + std::to_string(farthest->line) : "";
  return "; look at " + subject.urdf + line + ": joint " + farthest->name + " is the farthest from its parent" +
         formatted(", %.3g m", farthest->origin.translation().norm());
}

// Reads the text anew, and what is wrong in it is put right as `repairs` says.
void repair(CheckSubject& subject) {
  ProposalSource& source = subject.source;
  subject.repaired = load_repaired_urdf(subject.text, subject.urdf, source.packages, source.repairs);
}

// A robot on a fixed base that reaches below it: the ground of a scene would be in its trunk or its arms.
void raise_base(CheckSubject& subject) {
  ProposalSource& source = subject.source;
  if (floats(subject.repaired, source)) return;
  const double height = height_of_stand(subject.repaired);
  if (!(height > 0.0)) return;
  Eigen::Isometry3d raised = Eigen::Isometry3d::Identity();
  raised.translation().z() = height;
  const std::string name = free_root_name(subject.text, subject.urdf, "stand");
  subject.text =
      with_root_above(subject.text, subject.repaired.links.front().name, name, raised, "the ground is at z = 0");
  repair(subject);
  const std::string millimetres = formatted("%.0f", 1e3 * height);
  source.notes.push_back("it reaches below its fixed base, and the ground of a scene is at z = 0: the copy of the URDF has a link `" +
                         name + "` " + millimetres + " mm below it; give the joint " + name + "_joint the height of the true one");
}

}  // namespace

CheckSubject load_subject(const std::string& name, bool mends, const std::string& base) {
  CheckSubject subject;
  std::error_code error;
  if (fs::is_regular_file(name, error)) {
    subject.urdf = name;
    subject.mjcf = is_mjcf_name(name);
  } else {
    const std::string folder = robot_folder(name);
    if (fs::exists(folder + "/robot.yaml", error)) {
      if (mends) throw std::runtime_error(name + " has a robot.yaml: --mend is for a URDF file that nobody has described");
      if (!base.empty()) throw std::runtime_error(name + " has a robot.yaml: write base: " + base + " there");
      subject.model = load_robot(name);
      return subject;
    }
    subject.urdf = only_urdf(folder);
  }
  ProposalSource& source = subject.source;
  const std::string read = subject.mjcf ? urdf_of_mjcf(subject.urdf, source) : read_text_file(subject.urdf);
  if (!subject.mjcf) source.packages = find_packages(subject.urdf);
  subject.text = with_packages(read, subject.urdf, source.packages);
  std::string left_out;
  subject.text = without_floating_root(subject.text, subject.urdf, left_out);
  if (!left_out.empty()) {
    source.floating = true;
    source.notes.push_back("the copy of the URDF is without " + left_out + ", which say no more than that the base moves freely");
  }
  if (!base.empty()) source.floating = base == "floating";
  source.planar = base == "planar";
  if (mends) subject.text = mend_urdf(subject.text, subject.urdf, subject.mended);
  repair(subject);
  if (mends) {
    subject.text = mend_sides(subject.text, subject.urdf, subject.repaired, subject.mended);
    repair(subject);
    subject.text = mend_far_inertias(subject.text, subject.urdf, subject.repaired, subject.mended);
    repair(subject);
    subject.text = mend_images(subject.text, subject.urdf, subject.repaired, subject.mended);
    repair(subject);
  }
  if (const std::vector<std::string> meshes = meshes_to_turn(subject.repaired); !meshes.empty()) {
    subject.text = with_turned_meshes(subject.text, meshes);
    repair(subject);
    source.notes.push_back("the centres of mass lie in the geometry only if its COLLADA meshes, which say Y_UP, are turned to Z up: the copy "
                           "of the URDF has that turn in the <origin> of " + std::to_string(meshes.size()) + " meshes");
  }
  const Eigen::Matrix3d turn =
      source.floating.value_or(true) ? find_base_turn(subject.repaired) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  if (!turn.isIdentity(1e-9)) {
    Eigen::Isometry3d upright = Eigen::Isometry3d::Identity();
    upright.linear() = turn;
    const std::string root = free_root_name(subject.text, subject.urdf, "upright_base");
    subject.text = with_root_above(subject.text, subject.repaired.links.front().name, root, upright, "z up, x forward");
    repair(subject);
    source.notes.push_back(
        "the base of the file does not have z up and x forward: the copy of the URDF has a link " + root + " above it that has");
  }
  const std::vector<std::string> waist = joints_above_legs(subject.repaired);
  if (!waist.empty() && source.floating.value_or(true)) {
    std::string names;
    for (const std::string& joint : waist) names += (names.empty() ? "" : ", ") + joint;
    source.repairs.fixed_joints.insert(source.repairs.fixed_joints.end(), waist.begin(), waist.end());
    repair(subject);
    source.notes.push_back(names + (waist.size() > 1 ? " lie" : " lies") + " between the base and the legs, and our controller balances legs that " +
                           "hang on the base: fixed in the proposal (fixed_joints), for another controller take it out there");
  }
  raise_base(subject);
  if (subject.mjcf) {
    source.urdf_name = fs::path(subject.urdf).stem().string() + ".urdf";
    subject.model = subject.repaired;
    return subject;
  }
  source.urdf_name = fs::path(subject.urdf).filename().string();
  source.srdf_file = find_srdf(subject.urdf);
  if (!source.srdf_file.empty()) source.srdf_text = read_text_file(source.srdf_file);
  // The robot as its file says it, if that is a robot without repairs.
  if (!subject.mended.empty()) {
    subject.model = subject.repaired;
    return subject;
  }
  try {
    subject.model = load_urdf(subject.urdf, source.packages);
  } catch (const std::runtime_error&) {
    subject.model = subject.repaired;
  }
  return subject;
}

Model load_proposed(const Proposal& proposal, const CheckSubject& subject) try {
  return load_robot_texts({.folder = fs::path(subject.urdf).parent_path().string(),
                           .yaml = proposal.yaml,
                           .urdf = subject.text,
                           .srdf = proposal.srdf});
} catch (const std::runtime_error& error) {
  throw std::runtime_error(subject.urdf + ": no robot can be proposed: " + error.what() +
                           likely_cause(subject));
}

}  // namespace twinbus::launcher
