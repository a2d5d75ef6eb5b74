// Where two parts of a planned robot with one or two joints between are proved apart.
//
// The ranges of these joints are cut into boxes.  At the middle of a box the hulls are d apart, across a plane with
// normal n.  A corner x of a hull moves along n by the sum of (z_j x (x - o_j)) . n dq_j to first order, z_j and o_j the axes, and
// by no more than half of (sum h_j)(sum h_j r_j) beside that, h_j the half widths and r_j how far the hull reaches from the axes.
// What is linear is least at a corner of the box: with all these looked at, two hulls that slide past each other at a few
// millimetres need few boxes.  A cell that hulls leave open is asked of their pieces in the same way: of every two that the box
// could bring together.

#include <algorithm>
#include <array>
#include <cmath>

#include "common/math/index.h"
#include "geometry/distance/gjk.h"
#include "test/oracles/clear_cells.h"

namespace twinbus {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int kMostJoints = 2, kMostCells = 160;  // of a joint
constexpr double kBeyond = 0.02;                  // the limits [rad or m]
constexpr double kCell = 0.08;                    // [rad or m]
constexpr double kClose = 2e-5;                   // single precision of the bodies, and more [m]

Isometry3d pose_in_parent(const BlockBody& body, double q) {
  Isometry3d pose = Isometry3d::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) pose.linear()(r, c) = static_cast<double>(body.rotation[3 * r + c]);
    pose.translation()[r] = static_cast<double>(body.offset[r]);
  }
  const double moved = static_cast<double>(body.scale) * q + static_cast<double>(body.shift);
  if (body.slides) {
    pose.translation() += moved * pose.linear().col(2);
  } else {
    pose.linear() = pose.linear() * Eigen::AngleAxisd(moved, Vector3d::UnitZ()).toRotationMatrix();
  }
  return pose;
}

std::vector<Vector3d> corners_of(const BlockRobot& robot, const BlockPiece& hull) {
  const float* x = robot.corners.data() + hull.first;
  std::vector<Vector3d> corners;
  for (int k = 0; k < hull.count; ++k)
    corners.emplace_back(static_cast<double>(x[k]), static_cast<double>(x[hull.room + k]), static_cast<double>(x[2 * hull.room + k]));
  return corners;
}

struct Part {
  std::vector<Vector3d> corners;
  GjkShape shape;
  Vector3d middle;  // of a ball around it, in the body
  double radius;
};

// The hull of a group, its pieces, and the bodies that carry it from the last one common to both, the outermost first.
struct Side {
  const BlockGroup* group;
  std::vector<int> bodies;
  Part hull;
  std::vector<Part> pieces;       // the hull alone where there are none
  std::vector<Vector3d> middles;  // of the pieces, in the common body
  Isometry3d pose = Isometry3d::Identity();
  std::vector<Vector3d> axes, origins;  // of the bodies, in the common one
};

struct Box {
  std::array<int, kMostJoints> first{}, end{};  // of its cells
  std::array<double, kMostJoints> middle{}, half{};
};

class PairProof {
 public:
  PairProof(const BlockRobot& robot, int a, int b) : robot_(robot) {
    int of[2] = {robot.groups[at(a)].body, robot.groups[at(b)].body};
    for (const int k : {0, 1}) sides_[at(k)].group = &robot.groups[at(k == 0 ? a : b)];
    while (of[0] != of[1]) {
      const int k = of[0] > of[1] ? 0 : 1;
      const int joint = robot.bodies[at(of[k])].joint;
      sides_[at(k)].bodies.push_back(of[k]);
      if (std::find(joints_.begin(), joints_.end(), joint) == joints_.end()) joints_.push_back(joint);
      of[k] = robot.bodies[at(of[k])].parent;
    }
  }

  // No joints when the two are not of that kind, or nowhere proved apart.
  ClearCells find() {
    ClearCells cells;
    if (joints_.size() > at(kMostJoints)) return cells;
    Box whole;
    for (std::size_t k = 0; k < at(kMostJoints); ++k) {
      cells.count[k] = whole.end[k] = 1;
      if (k >= joints_.size()) continue;
      const double low = static_cast<double>(robot_.lower[at(joints_[k])]) - kBeyond;
      const double range = static_cast<double>(robot_.upper[at(joints_[k])]) + kBeyond - low;
      if (!std::isfinite(range) || !(range > 0.0)) return cells;
      cells.count[k] = whole.end[k] = std::clamp(static_cast<int>(std::ceil(range / kCell)), 1, kMostCells);
      cells.joint[k] = joints_[k];
      cells.low[k] = static_cast<float>(low);
      cells.per_unit[k] = static_cast<float>(cells.count[k] / range);
    }
    for (Side& side : sides_) {
      const BlockPiece* pieces = robot_.pieces.data() + side.group->first_piece;
      side.hull = part_of(pieces[0]);
      for (int k = side.group->piece_count > 1 ? 1 : 0; k < side.group->piece_count; ++k) side.pieces.push_back(part_of(pieces[k]));
    }
    const int rows = cells.count[0] + 1, columns = cells.count[1] + 1;
    cells.open.assign(at(rows * columns), 1);
    std::vector<Box> open{whole};
    int clear = 0;
    while (!open.empty()) {
      Box box = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < joints_.size(); ++k) {
        const double cell = 1.0 / static_cast<double>(cells.per_unit[k]);
        box.middle[k] = static_cast<double>(cells.low[k]) + 0.5 * cell * (box.first[k] + box.end[k]);
        box.half[k] = 0.5 * cell * (box.end[k] - box.first[k]) + kOverlap;
      }
      const std::size_t cut = box.end[1] - box.first[1] > box.end[0] - box.first[0] ? 1 : 0;
      const bool one_cell = box.end[cut] - box.first[cut] < 2;
      if (hulls_clear(box) || (one_cell && pieces_clear(box))) {
        for (int i = box.first[0]; i < box.end[0]; ++i) {
          for (int k = box.first[1]; k < box.end[1]; ++k) cells.open[at((i + 1) * columns + k + 1)] = 0, ++clear;
        }
        continue;
      }
      if (one_cell) continue;
      Box upper = box;
      box.end[cut] = upper.first[cut] = (box.first[cut] + box.end[cut]) / 2;
      open.push_back(box);
      open.push_back(upper);
    }
    if (clear == 0) return cells;
    for (int i = 0; i < rows; ++i) {
      for (int k = 0; k < columns; ++k) {
        int& sum = cells.open[at(i * columns + k)];
        if (i == 0 || k == 0) {
          sum = 0;
        } else {
          sum += cells.open[at((i - 1) * columns + k)] + cells.open[at(i * columns + k - 1)] - cells.open[at((i - 1) * columns + k - 1)];
        }
      }
    }
    cells.joints = static_cast<int>(joints_.size());
    return cells;
  }

 private:
  static constexpr double kOverlap = 1e-4;  // of cells, for what single precision makes of a posture [rad or m]

  double of(const std::array<double, kMostJoints>& values, int joint) const {
    return values[at(static_cast<int>(std::find(joints_.begin(), joints_.end(), joint) - joints_.begin()))];
  }

  Part part_of(const BlockPiece& piece) const {
    Part part{.corners = corners_of(robot_, piece), .shape = {}, .middle = Vector3d(static_cast<double>(piece.around.x), static_cast<double>(piece.around.y),
                                   static_cast<double>(piece.around.z)),
              .radius = static_cast<double>(piece.around.radius)};
    part.shape = gjk_hull(part.corners);
    return part;
  }

  void go_to(Side& side, const Box& box) {
    side.pose = Isometry3d::Identity();
    side.axes.assign(side.bodies.size(), {});
    side.origins = side.axes;
    for (std::size_t i = side.bodies.size(); i-- > 0;) {
      const BlockBody& body = robot_.bodies[at(side.bodies[i])];
      side.pose = side.pose * pose_in_parent(body, of(box.middle, body.joint));
      side.axes[i] = side.pose.linear().col(2) * static_cast<double>(body.scale);
      side.origins[i] = side.pose.translation();
    }
  }

  // The farthest that the hull reaches along n at this corner of the box, to first order.
  double extent(const Side& side, const Part& part, const Vector3d& n, const Box& box, unsigned corner) const {
    Vector3d d = n;
    double offset = 0.0;
    for (std::size_t i = 0; i < side.bodies.size(); ++i) {
      const BlockBody& body = robot_.bodies[at(side.bodies[i])];
      const auto k = at(static_cast<int>(std::find(joints_.begin(), joints_.end(), body.joint) - joints_.begin()));
      const double move = (corner >> k & 1U) != 0 ? box.half[k] : -box.half[k];
      if (body.slides) {
        offset += move * n.dot(side.axes[i]);
        continue;
      }
      const Vector3d across = n.cross(side.axes[i]);
      d += move * across;
      offset -= move * across.dot(side.origins[i]);
    }
    const Vector3d in_body = side.pose.linear().transpose() * d;
    double most = -1e30;
    for (const Vector3d& x : part.corners) most = std::max(most, in_body.dot(x));
    return most + d.dot(side.pose.translation()) + offset;
  }

  // Goes to the middle of the box.
  bool hulls_clear(const Box& box) {
    bend_ = 0.0;
    swing_ = 0.0;
    for (Side& side : sides_) {
      go_to(side, box);
      double turns = 0.0, swing = 0.0;
      for (const int b : side.bodies) {
        const BlockBody& body = robot_.bodies[at(b)];
        turns += of(box.half, body.joint) * std::abs(static_cast<double>(body.scale));
        swing += of(box.half, body.joint) * static_cast<double>(side.group->travel[body.joint]);
      }
      bend_ += 0.5 * turns * swing;
      swing_ += swing;
    }
    return are_clear(sides_[0].hull, sides_[1].hull, box);
  }

  // At the middle already.
  bool pieces_clear(const Box& box) {
    Side &a = sides_[0], &b = sides_[1];
    if (a.pieces.size() == 1 && b.pieces.size() == 1) return false;
    // What was in the way of the last cell is in the way of its neighbour.
    if (!are_clear(a.pieces[blocking_[0]], b.pieces[blocking_[1]], box)) return false;
    for (Side& side : sides_) {
      side.middles.clear();
      for (const Part& piece : side.pieces) side.middles.push_back(side.pose * piece.middle);
    }
    for (std::size_t i = 0; i < a.pieces.size(); ++i) {
      for (std::size_t k = 0; k < b.pieces.size(); ++k) {
        const double reach = a.pieces[i].radius + b.pieces[k].radius + swing_ + kClose;
        if ((a.middles[i] - b.middles[k]).squaredNorm() > reach * reach || are_clear(a.pieces[i], b.pieces[k], box)) continue;
        blocking_ = {i, k};
        return false;
      }
    }
    return true;
  }

  bool are_clear(const Part& a, const Part& b, const Box& box) {
    const double kept = 2.0 * static_cast<double>(robot_.grow) + kClose;
    const GjkResult found = gjk_distance(a.shape, sides_[0].pose, b.shape, sides_[1].pose, swing_ + kept);
    if (found.below > swing_ + kept) return true;
    if (!(found.distance > bend_ + kept)) return false;
    for (unsigned corner = 0; corner < 1U << joints_.size(); ++corner) {
      const double gap = -extent(sides_[1], b, -found.normal, box, corner) - extent(sides_[0], a, found.normal, box, corner);
      if (!(gap > bend_ + kept)) return false;
    }
    return true;
  }

  const BlockRobot& robot_;
  std::array<Side, 2> sides_;
  std::vector<int> joints_;
  double bend_ = 0.0, swing_ = 0.0;          // how far the two swing together from the middle of a box, of it what is not linear [m]
  std::array<std::size_t, 2> blocking_{};    // of the pieces
};

}  // namespace

void find_clear_cells(BlockRobot& robot) {
  robot.clear.clear();
  std::vector<std::pair<int, int>> left;
  for (const auto& [a, b] : robot.pairs) {
    const bool hulls = robot.groups[at(a)].piece_count > 0 && robot.groups[at(b)].piece_count > 0;
    ClearCells cells = hulls ? PairProof(robot, a, b).find() : ClearCells{};
    if (cells.joints > 0 && cells.open.back() == 0) continue;
    left.emplace_back(a, b);
    robot.clear.push_back(std::move(cells));
  }
  robot.pairs = std::move(left);
}

}  // namespace twinbus
