#include "sim/world/static_equilibrium.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "robot/estimation/point_legs.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/world/link_hull.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

namespace {

constexpr double kHang = 0.3;  // clearance of a fixed-base robot's soles [m]

using Corners = std::array<std::array<Eigen::Vector3d, 4>, 2>;

Corners corners_in_world(const Model& model, const Kinematics& kinematics) {
  Corners corners;
  for (std::size_t side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[side];
    for (int i = 0; i < kSoleCorners; ++i) {
      corners[side][static_cast<std::size_t>(i)] =
          sole.link < 0 ? Eigen::Vector3d::Zero()
                        : Eigen::Vector3d(kinematics.link_in_world(sole.link) *
                                          (sole.frame * sole_corner(sole, i)));
    }
  }
  return corners;
}

// Small rigid motion of the base: up by z, turned about world x and y at pivot.
void move_base(const Eigen::Vector3d& z_roll_pitch, const Eigen::Vector3d& pivot,
               Configuration& configuration) {
  const Eigen::Vector3d turn(z_roll_pitch[1], z_roll_pitch[2], 0.0);
  const double angle = turn.norm();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(pivot + Eigen::Vector3d(0.0, 0.0, z_roll_pitch[0]));
  if (angle > 0.0) motion.rotate(Eigen::AngleAxisd(angle, turn / angle));
  motion.translate(-pivot);
  configuration.base = motion * configuration.base;
}

// Base with the soles' midpoint at the origin, heading 0, sole plane horizontal.
void place_on_ground(const Model& model, Kinematics& kinematics, Configuration& configuration) {
  configuration.base = Eigen::Isometry3d::Identity();
  kinematics.update(configuration);
  int feet = 0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), z = Eigen::Vector3d::Zero();
  for (const Sole& sole : model.soles) {
    if (sole.link < 0) continue;
    const Eigen::Isometry3d frame = kinematics.link_in_world(sole.link) * sole.frame;
    middle += frame.translation();
    x += frame.linear().col(0);
    z += frame.linear().col(2);
    ++feet;
  }
  if (feet == 0) return;
  middle /= feet;
  Eigen::Isometry3d ground = Eigen::Isometry3d::Identity();
  ground.linear().col(2) = z.normalized();
  ground.linear().col(1) = z.cross(x).normalized();
  ground.linear().col(0) = ground.linear().col(1).cross(ground.linear().col(2));
  ground.translation() = middle;
  configuration.base = ground.inverse();
  kinematics.update(configuration);
}

// Torques that hold the links against gravity and the normal forces at the corners.
struct PointLoad {
  int link;
  Eigen::Vector3d point;  // world [m]
  double normal;          // [N]
};

Eigen::VectorXd static_torques(const Model& model, const Kinematics& kinematics, double mass_scale,
                               const Corners& corners,
                               const std::array<std::array<double, 4>, 2>& force,
                               const std::vector<PointLoad>& points) {
  const auto links = model.links.size();
  std::vector<Eigen::Vector3d> sum(links),
      moment(links);  // on the link and all beyond it, about the world origin
  for (std::size_t i = 0; i < links; ++i) {
    const Link& link = model.links[i];
    const Eigen::Vector3d com = kinematics.link_in_world(static_cast<int>(i)) * link.com;
    sum[i] = Eigen::Vector3d(0.0, 0.0, -kGravity * mass_scale * link.mass);
    moment[i] = com.cross(sum[i]);
    for (std::size_t side = 0; side < 2; ++side) {
      if (model.soles[side].link != static_cast<int>(i)) continue;
      for (std::size_t c = 0; c < 4; ++c) {
        const Eigen::Vector3d f(0.0, 0.0, force[side][c]);
        sum[i] += f;
        moment[i] += corners[side][c].cross(f);
      }
    }
    for (const PointLoad& load : points) {
      if (load.link != static_cast<int>(i)) continue;
      const Eigen::Vector3d f(0.0, 0.0, load.normal);
      sum[i] += f;
      moment[i] += load.point.cross(f);
    }
  }
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.joint_count());
  for (std::size_t i = links; i-- > 1;) {
    const Joint& joint = model.joints[i - 1];
    const Eigen::Vector3d axis = kinematics.axis_in_world(static_cast<int>(i) - 1);
    const Eigen::Vector3d at = kinematics.link_in_world(static_cast<int>(i)).translation();
    tau[static_cast<Eigen::Index>(i) - 1] = joint.kind == JointKind::kPrismatic
                                                ? -axis.dot(sum[i])
                                                : -axis.dot(moment[i] - at.cross(sum[i]));
    sum[static_cast<std::size_t>(joint.parent)] += sum[i];
    moment[static_cast<std::size_t>(joint.parent)] += moment[i];
  }
  return tau;
}

// Turns the base so that the points, columns, are on one level; two: the centre of mass above the line between them too.
void level_points(const Eigen::Matrix3Xd& point, const Eigen::Vector3d& com, Eigen::Isometry3d& base) {
  const Eigen::Vector3d middle = point.rowwise().mean();
  Eigen::Vector3d up = com - middle;
  if (point.cols() == 2) {
    const Eigen::Vector3d along = (point.col(0) - point.col(1)).normalized();
    up -= along * along.dot(up);
  } else {
    const Eigen::Matrix3d spread = (point.colwise() - middle) * (point.colwise() - middle).transpose();
    up = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  }
  if (up.z() < 0.0) up = -up;
  base.prerotate(Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()));
}

// Heights of all points of the feet with which they may meet the ground, as engine articulated does [m].
std::vector<double> heights_of(const Model& model, const StandingFeet& feet, const Kinematics& kinematics) {
  std::vector<double> heights;
  for (int foot = 0; foot < feet.count(); ++foot) {
    const Eigen::Isometry3d& link = kinematics.link_in_world(feet.link(foot));
    const std::size_t before = heights.size();
    for (const Shape& shape : model.links[static_cast<std::size_t>(feet.link(foot))].collision) {
      const Eigen::Isometry3d pose = link * shape.pose;
      for (const TouchPoint& point : touch_points(shape)) heights.push_back((pose * point.at).z() - point.radius);
    }
    if (heights.size() == before) heights.push_back(feet.point(foot).z());
  }
  return heights;
}

// Where the ground is when springs at these heights, each pressed in so far below it, carry a load: sum of max(0, level - h) [m].
double ground_level(std::vector<double> heights, double load) {
  std::sort(heights.begin(), heights.end());
  double sum = 0.0, level = 0.0;
  for (std::size_t n = 0; n < heights.size() && (n == 0 || level > heights[n]); ++n) {
    sum += heights[n];
    level = (load + sum) / static_cast<double>(n + 1);
  }
  return level;
}

// Of a robot that stands on points: they come to lie on the ground, as deep as their share of the weight presses them in, their
// middle at the origin.  Normal forces are the smallest that carry the weight; empty when it stands on fewer than two, or the
// centre of mass is not above them.
std::vector<PointLoad> place_on_points(const Model& model, double weight, Kinematics& kinematics, Configuration& configuration) {
  StandingFeet feet(model);
  const auto count = static_cast<Eigen::Index>(feet.count());
  if (count < 2) return {};
  configuration.base = Eigen::Isometry3d::Identity();
  Eigen::Matrix3Xd point(3, count);
  for (int pass = 0; pass < 5; ++pass) {  // a ball that turns touches elsewhere
    kinematics.update(configuration);
    feet.place(kinematics, Eigen::Matrix3d::Identity());
    for (Eigen::Index i = 0; i < count; ++i) point.col(i) = feet.point(static_cast<int>(i));
    level_points(point, kinematics.com(), configuration.base);
  }
  kinematics.update(configuration);
  feet.place(kinematics, Eigen::Matrix3d::Identity());
  for (Eigen::Index i = 0; i < count; ++i) point.col(i) = feet.point(static_cast<int>(i));
  const Eigen::Vector3d middle = point.rowwise().mean();
  const Eigen::Vector3d com = kinematics.com();
  Eigen::VectorXd normal;
  if (count == 2) {
    const Eigen::Vector2d along = (point.col(0) - point.col(1)).head<2>();
    const double first = (com - point.col(1)).head<2>().dot(along) / std::max(1e-12, along.squaredNorm());
    normal = weight * Eigen::Vector2d(first, 1.0 - first);
  } else {
    Eigen::Matrix<double, 3, Eigen::Dynamic> arm(3, count);
    for (Eigen::Index i = 0; i < count; ++i) arm.col(i) << 1.0, point(0, i) - com.x(), point(1, i) - com.y();
    const Eigen::Matrix3d square = arm * arm.transpose();
    normal = arm.transpose() * square.ldlt().solve(Eigen::Vector3d(weight, 0.0, 0.0));
  }
  const double level = ground_level(heights_of(model, feet, kinematics), weight / kLinkStiffness);
  const Eigen::Vector3d way(-middle.x(), -middle.y(), -level);
  configuration.base.pretranslate(way);
  kinematics.update(configuration);
  std::vector<PointLoad> loads;
  if (!normal.allFinite() || normal.minCoeff() < 0.0) return loads;
  for (Eigen::Index i = 0; i < count; ++i) {
    loads.push_back({feet.link(static_cast<int>(i)), point.col(i) + way, normal[i]});
  }
  return loads;
}

}  // namespace

Standing stand(const Model& model, const Eigen::VectorXd& q, double mass_scale,
               const std::array<double, 2>& stiffness, const std::array<double, 2>& ground_height,
               bool fixed_base) {
  Standing result;
  result.configuration = Configuration(model);
  Configuration& configuration = result.configuration;
  configuration.q = q;
  configuration.qd.setZero();
  Kinematics kinematics(model);
  place_on_ground(model, kinematics, configuration);
  const bool has_feet = model.soles[0].link >= 0 || model.soles[1].link >= 0;
  const double weight = mass_scale * kinematics.mass() * kGravity;

  std::vector<PointLoad> points;
  if (!fixed_base && !has_feet && stands_on_points(model)) points = place_on_points(model, weight, kinematics, configuration);
  if (!points.empty()) {
    result.balanced = true;
  } else if (fixed_base || !has_feet) {
    if (has_feet) configuration.base.pretranslate(Eigen::Vector3d(0.0, 0.0, kHang));
    kinematics.update(configuration);
    result.balanced = fixed_base;
  } else {
    // Newton on base height, roll and pitch: the corner springs carry the weight right below the
    // centre of mass.
    double total = 0.0;
    for (std::size_t s = 0; s < 2; ++s) total += model.soles[s].link < 0 ? 0.0 : 4.0 * stiffness[s];
    move_base({-weight / total, 0.0, 0.0}, Eigen::Vector3d::Zero(), configuration);
    for (int pass = 0; pass < 40 && !result.balanced; ++pass) {
      kinematics.update(configuration);
      const Corners corners = corners_in_world(model, kinematics);
      const Eigen::Vector3d& com = kinematics.com();
      Eigen::Vector3d residual(-weight, 0.0,
                               0.0);  // force, moments about the ground point below the com
      Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
      for (std::size_t s = 0; s < 2; ++s) {
        if (model.soles[s].link < 0) continue;
        for (const Eigen::Vector3d& p : corners[s]) {
          const double depth = ground_height[s] - p.z();
          if (!(depth > 0.0)) continue;
          const Eigen::Vector3d arm(1.0, p.y() - com.y(),
                                    -(p.x() - com.x()));  // of a unit force on z, roll, pitch
          residual += stiffness[s] * depth * arm;
          slope -= stiffness[s] * arm * arm.transpose();
        }
      }
      if (residual.cwiseAbs().maxCoeff() < 1e-9 * weight) {
        result.balanced = true;
        break;
      }
      const Eigen::FullPivLU<Eigen::Matrix3d> lu(slope);
      if (lu.rank() < 3) break;
      const Eigen::Vector3d move = -lu.solve(residual);
      if (!(move.cwiseAbs().maxCoeff() < 0.05)) break;
      move_base(move, {com.x(), com.y(), 0.0}, configuration);
    }
    kinematics.update(configuration);
  }

  const Corners corners = corners_in_world(model, kinematics);
  if (!fixed_base) {
    for (std::size_t s = 0; s < 2; ++s) {
      if (model.soles[s].link < 0) continue;
      for (std::size_t c = 0; c < 4; ++c) {
        result.corner_force[s][c] =
            stiffness[s] * std::max(0.0, ground_height[s] - corners[s][c].z());
      }
    }
  }
  result.tau = static_torques(model, kinematics, mass_scale, corners, result.corner_force, points);
  result.needed = result.tau;
  for (Eigen::Index j = 0; j < result.tau.size(); ++j) {
    const double limit = model.joints[static_cast<std::size_t>(j)].effort;
    if (std::isfinite(limit)) result.tau[j] = std::clamp(result.tau[j], -limit, limit);
  }
  return result;
}

namespace {

// The shortest x with system x = right, as near as there is one; the system is symmetric.  (A complete orthogonal
// decomposition does the same, but allocates once the rank is not full.)
Eigen::Vector3d least_solution(const Eigen::Matrix3d& system,
                               const Eigen::Vector3d& right) noexcept {
  constexpr double kNone = 1e-12;  // of the greatest eigenvalue
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(system);
  const double least = kNone * parts.eigenvalues().maxCoeff();
  Eigen::Vector3d along = parts.eigenvectors().transpose() * right;
  for (int i = 0; i < 3; ++i) {
    const double value = parts.eigenvalues()[i];
    along[i] = value > least ? along[i] / value : 0.0;
  }
  return parts.eigenvectors() * along;
}

}  // namespace

std::array<double, 4> corner_forces(const Sole& sole, double fz, double mx, double my) noexcept {
  // f_i = a + b y_i + c x_i with sums fz, sum f y = mx, -sum f x = my; corners that would pull are
  // left out.
  std::array<bool, 4> presses{true, true, true, true};
  std::array<double, 4> force{};
  for (int pass = 0; pass < 4; ++pass) {
    Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
    for (int i = 0; i < kSoleCorners; ++i) {
      if (!presses[static_cast<std::size_t>(i)]) continue;
      const Eigen::Vector3d corner = sole_corner(sole, i);
      const Eigen::Vector3d arm(1.0, corner.y(), -corner.x());
      system += arm * arm.transpose();
    }
    const Eigen::Vector3d plane = least_solution(system, {fz, mx, my});
    bool done = true;
    for (int i = 0; i < kSoleCorners; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Eigen::Vector3d corner = sole_corner(sole, i);
      force[at] = presses[at] ? plane.dot(Eigen::Vector3d(1.0, corner.y(), -corner.x())) : 0.0;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (force[i] < 0.0) {
        presses[i] = false;
        force[i] = 0.0;
        done = false;
      }
    }
    if (done) break;
  }
  return force;
}

void fit_base_to_corner_forces(const Model& model,
                               const std::array<std::array<double, 4>, 2>& force,
                               const std::array<double, 2>& stiffness,
                               const std::array<double, 2>& ground_height, Kinematics& kinematics,
                               Configuration& configuration) noexcept {
  for (int pass = 0; pass < 3; ++pass) {
    kinematics.update(configuration);
    const Corners corners = corners_in_world(model, kinematics);
    Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
    double loaded = 0.0;
    for (std::size_t s = 0; s < 2; ++s) {
      for (std::size_t c = 0; c < 4; ++c) {
        if (!(force[s][c] > 0.0)) continue;
        pivot += force[s][c] * corners[s][c];
        loaded += force[s][c];
      }
    }
    if (!(loaded > 0.0)) return;
    pivot /= loaded;
    Eigen::Matrix3d system = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t s = 0; s < 2; ++s) {
      if (model.soles[s].link < 0) continue;
      for (std::size_t c = 0; c < 4; ++c) {
        if (!(force[s][c] > 0.0)) continue;
        const Eigen::Vector3d& p = corners[s][c];
        const double wanted = ground_height[s] - force[s][c] / stiffness[s];  // z of the corner
        const Eigen::Vector3d arm(1.0, p.y() - pivot.y(), -(p.x() - pivot.x()));
        system += arm * arm.transpose();
        right += arm * (wanted - p.z());
      }
    }
    move_base(system.ldlt().solve(right), {pivot.x(), pivot.y(), 0.0}, configuration);
  }
}

}  // namespace twinbus::sim
