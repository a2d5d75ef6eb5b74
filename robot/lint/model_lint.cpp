#include "robot/lint/model_lint.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <tuple>

#include "common/text/formatted.h"
#include "robot/estimation/point_legs.h"
#include "robot/onboarding/anatomy.h"
#include "robot/lint/mend.h"
#include "robot/lint/mirrored_ranges.h"
#include "robot/description/link_points.h"
#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline robot {

namespace {

constexpr double kAlike = 0.01;           // limits of left and right [rad or m]
constexpr std::size_t kSaidOneByOne = 3;  // links or joints of which the same is said

std::string number(double value) {
  return formatted("%.4g", value);
}

class Looker {
 public:
  explicit Looker(const Model& model) : model_(model) {}

  std::vector<Suspicion> look() {
    for (const std::string& note : model_.notes) add("files", note, "correct or remove it");
    for (const Link& link : model_.links) {
      look_at_inertia(link);
      look_at_geometry(link);
    }
    for (const Joint& joint : model_.joints) look_at_limits(joint);
    look_at_partners();
    look_at_images();
    if (model_.floating_base && !(model_.total_mass() >= 0.5 && model_.total_mass() <= 500.0)) {
      add("robot", "weighs " + number(model_.total_mass()) + " kg", "are the masses in kg?");
    }
    put_together();
    return std::move(found_);
  }

 private:
  void add(const std::string& about, const std::string& what, const std::string& remedy) {
    found_.push_back({about, what, remedy});
  }

  void look_at_inertia(const Link& link) {
    const std::string about = "link " + link.name;
    if (!(link.mass > 0.0)) {
      add(about, "has no mass",
          "give it an <inertial>, or fix a joint beside it; it cannot be simulated");
      return;
    }
    const Eigen::Vector3d m =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(link.inertia).eigenvalues();
    if (!(m[0] > 0.0)) {
      add(about, "has an inertia without a moment about one axis",
          "take it from CAD; it cannot be simulated");
      return;
    }
    if (m[0] + m[1] < m[2] * (1.0 - 1e-9)) {
      add(about,
          "has an inertia that no body has: " + number(m[2]) + " exceeds " + number(m[0]) + " + " +
              number(m[1]),
          "take it from CAD, about the centre of mass");
    }
    if (link.inertia.isApprox(Eigen::Matrix3d::Identity(), 1e-9)) {
      add(about, "has the inertia 1 1 1", "this is a placeholder; take it from CAD");
    }
    const std::vector<Eigen::Vector3d> points = link_points(link);
    if (points.empty()) return;
    double reach = 0.0;  // from the centre of mass
    for (const Eigen::Vector3d& point : points) reach = std::max(reach, (point - link.com).norm());
    const double most = shell_radius(link);
    if (most > 1.2 * reach) {
      add(about,
          "has the inertia of a shell of radius " + number(most) + " m; its geometry ends at " +
              number(reach) + " m",
          "is the inertia about the centre of mass, in kg m^2?  --mend takes a box's where it is three times as far");
    }
    if (std::sqrt(m[2] / link.mass) < 0.02 * reach) {
      add(about,
          "has nearly all mass in one point: gyration " + number(std::sqrt(m[2] / link.mass)) +
              " m, size " + number(reach) + " m",
          "check the inertia");
    }
    const double outside = outside_hull(points, link.com);
    if (outside > 0.05 * reach + 0.005) {
      add(about, "has its centre of mass " + number(outside) + " m outside its geometry",
          "check <inertial><origin>");
    }
    const double density = link.mass / std::max(box_around(points).volume(), 1e-9);
    if (density > 12000.0 || density < 5.0) {
      add(about, "weighs " + number(density) + " kg per m^3 of the box around it",
          "check mass and the scale of the geometry");
    }
  }

  void look_at_geometry(const Link& link) {
    const std::string about = "link " + link.name;
    if (link.collision.empty() && !link.visual.empty()) {
      add(about, "can be seen but not touched: it has no <collision>",
          "the guard does not see it; give it one");
    }
    for (const Shape& shape : link.collision) look_at_mesh(about + ", collision", shape);
    for (const Shape& shape : link.collision) look_at_place(about, link, shape);
    for (const Shape& shape : link.visual) look_at_mesh("", shape);
  }

  void look_at_place(const std::string& about, const Link& link, const Shape& shape) {
    double off = 1e300;
    for (const Shape& drawn : link.visual) {
      if (shape.kind == ShapeKind::kMesh && drawn.kind == ShapeKind::kMesh && drawn.mesh == shape.mesh)
        off = std::min(off, (drawn.pose.translation() - shape.pose.translation()).norm());
    }
    if (off < 1e300 && off > kFarFromDrawn)
      add(about, "mesh " + shape.mesh.substr(shape.mesh.rfind('/') + 1) + " is touched " + number(off) + " m from where it is drawn",
          "correct one of the two <origin>; --mend takes that of <visual> where it is nearer to the centre of mass");
  }

  // about empty: only whether it can be read.
  void look_at_mesh(const std::string& about, const Shape& shape) {
    if (shape.kind != ShapeKind::kMesh || !seen_.insert({shape.mesh, about.empty()}).second) return;
    try {
      if (about.empty()) {
        load_mesh(shape.mesh, shape.size);
      } else if (const int open = open_edges(shape.mesh); open > 0) {
        add(about,
            "mesh " + shape.mesh.substr(shape.mesh.rfind('/') + 1) +
                " has holes: " + std::to_string(open) + " open edges",
            "close it; inside and outside are not defined");
      }
    } catch (const std::runtime_error& error) {
      add("visual", error.what(), "the viewer will not show it");
    }
  }

  void look_at_limits(const Joint& joint) {
    const std::string about = "joint " + joint.name;
    const bool turns = joint.kind != JointKind::kPrismatic;
    const double range = joint.upper - joint.lower;
    if (range == 0.0)
      add(about, "cannot move: lower is upper", "make it fixed, or give it a range");
    if (joint.kind == JointKind::kRevolute && range > 4.0 * std::numbers::pi) {
      add(about, "turns by " + number(range) + " rad: a limit of no use",
          "are the limits in rad? or make it continuous");
    }
    if (!(joint.lower <= 0.0 && joint.upper >= 0.0)) {
      add(about, "cannot be at zero: " + number(joint.lower) + " to " + number(joint.upper),
          "poses and the zero posture must avoid it");
    }
    if (!(joint.velocity > 0.0) || joint.velocity > (turns ? 100.0 : 20.0)) {
      add(about, "has a velocity limit of " + number(joint.velocity) + (turns ? " rad/s" : " m/s"),
          "give the motor's");
    }
    const bool passive = joint.mimic >= 0 && joint.mimic_multiplier == 0.0;
    if (!passive && (!(joint.effort > 0.0) || joint.effort > 1e4)) {
      add(about, "has an effort limit of " + number(joint.effort) + (turns ? " N m" : " N"),
          "give the motor's");
    }
  }

  // Left and right are built alike: equal limits, or mirrored ones.
  void look_at_partners() {
    for (const Joint& joint : model_.joints) {
      const int other = partner(joint.name);
      if (other < 0 || model_.joints[static_cast<std::size_t>(other)].kind != joint.kind ||
          joint.kind == JointKind::kContinuous)
        continue;
      const Joint& right = model_.joints[static_cast<std::size_t>(other)];
      const std::string about = "joint " + joint.name;
      const auto alike = [&](double a, double b) { return std::abs(a - b) <= kAlike; };
      const bool equal = alike(joint.lower, right.lower) && alike(joint.upper, right.upper);
      const bool mirrored = alike(joint.lower, -right.upper) && alike(joint.upper, -right.lower);
      if (!equal && !mirrored) {
        add(about,
            "has limits " + number(joint.lower) + " to " + number(joint.upper) + "; " + right.name +
                " on the other side " + number(right.lower) + " to " + number(right.upper),
            "is one of them wrong? they are neither equal nor mirrored");
      }
      if (std::max(joint.effort, right.effort) > 1.5 * std::min(joint.effort, right.effort)) {
        add(about,
            "has an effort limit of " + number(joint.effort) + "; " + right.name +
                " on the other side " + number(right.effort),
            "is one of them wrong?");
      }
    }
  }

  // The same of what is on the other side, whatever it is called, as the axes are.
  void look_at_images() {
    for (const UnmirroredRange& fault : unmirrored_ranges(model_, find_anatomy(model_, {}).leg_joints)) {
      const Joint& kept = model_.joints[static_cast<std::size_t>(fault.kept)];
      const Joint& other = model_.joints[static_cast<std::size_t>(fault.other)];
      add("joint " + other.name,
          "turns the other way than " + kept.name + ", its mirror image: " + number(other.lower) + " to " + number(other.upper) +
              " rad about its axis, where the image of that one's range is " + number(fault.lower) + " to " + number(fault.upper),
          fault.of_leg ? "correct one of the two, or the axis; --mend takes the range that legs need" : "correct one of the two, or the axis");
    }
  }

  // The joint of the other side that a left joint's name names; -1: none.
  int partner(const std::string& name) const {
    for (const std::string& other : names_on_other_side(name)) {
      if (const int found = model_.find_joint(other); found >= 0 && other > name) return found;
    }
    return -1;
  }

  // What is said of many alike is said once.
  void put_together() {
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> alike;
    for (std::size_t i = 0; i < found_.size(); ++i)
      alike[{found_[i].what, found_[i].remedy}].push_back(i);
    std::vector<Suspicion> kept;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const auto& same = alike[{found_[i].what, found_[i].remedy}];
      if (same.size() <= kSaidOneByOne) {
        kept.push_back(found_[i]);
      } else if (same.front() == i) {
        kept.push_back(found_[i]);
        kept.back().about += std::string(" and ") + std::to_string(same.size() - 1) + " others";
      }
    }
    found_ = std::move(kept);
  }

  const Model& model_;
  std::set<std::pair<std::string, bool>> seen_;
  std::vector<Suspicion> found_;
};

}  // namespace

std::vector<Suspicion> find_suspicions(const Model& model) { return Looker(model).look(); }

std::vector<Suspicion> find_missing(const Model& model) {
  std::vector<Suspicion> missing;
  const auto add = [&](const std::string& about, const std::string& what,
                       const std::string& remedy) {
    missing.push_back({about, what, remedy});
  };
  if (model.yaml_text.empty()) add("robot.yaml", "is not there", "take the proposal below");
  const bool four = stands_on_points(model) && point_legs(model, StandingFeet(model)).has_value();
  if (model.floating_base && !four && (model.soles[0].link < 0 || model.soles[1].link < 0)) {
    add("robot.yaml", "says no soles: the robot cannot balance, nor can its base be estimated",
        "add soles");
  }
  if (model.floating_base && model.leg_joints.empty()) {
    add("robot.yaml", "says no leg_joints: the guard could hold a leg while walking",
        "add leg_joints");
  }
  if (hand_of(model, 0) == nullptr) {
    add("robot.yaml", "says no hands: reach does not work", "add hands, if it has any");
  }
  int without = 0;
  std::string first;
  for (const int j : model.bus_joints) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    if (joint.kp > 0.0) continue;
    if (without++ == 0) first = joint.name;
  }
  if (without > 0) {
    add("robot.yaml",
        "has no servo gains for " + std::to_string(without) + " joints, the first is " + first,
        "add servos");
  }
  if (model.find_pose("half_sitting") < 0) {
    add("SRDF", "has no pose half_sitting, in which scenes begin",
        "add a group_state of this name");
  }
  if (model.disabled_pairs.empty() && model.srdf_text.empty()) {
    add("SRDF", "is not there: only neighbours are exempt from the collision check",
        "disable pairs that touch by design");
  }
  return missing;
}

int open_edges(const std::string& mesh_file) {
  const TriangleMesh mesh = load_mesh(mesh_file, Eigen::Vector3d::Ones());
  double size = 0.0;
  for (const Eigen::Vector3d& point : mesh.points)
    size = std::max(size, point.cwiseAbs().maxCoeff());
  const double grain = std::max(1e-6 * size, 1e-12);
  std::map<std::tuple<long long, long long, long long>, int> corners;
  std::vector<int> corner_of;
  for (const Eigen::Vector3d& point : mesh.points) {
    const Eigen::Vector3d p = point / grain;
    corner_of.push_back(
        corners
            .try_emplace({std::llround(p.x()), std::llround(p.y()), std::llround(p.z())},
                         static_cast<int>(corners.size()))
            .first->second);
  }
  std::map<std::pair<int, int>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corner_of[static_cast<std::size_t>(triangle[k])];
      const int b = corner_of[static_cast<std::size_t>(triangle[(k + 1) % 3])];
      if (a != b) ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  int open = 0;
  for (const auto& edge : edges) open += edge.second % 2;
  return open;
}

}  // namespace twinbus::robot
