#include "robot/collision/exact/posture_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "robot/collision/collision_pairs.h"
#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"
#include "geometry/distance/mesh_distance.h"
#include "robot/collision/exact/self_collision.h"

namespace twinbus::inline robot {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostClusters = 65535;  // that a list can name
constexpr double kRounding = 1e-5;  // of distances and poses, the check's single precision too [m]
constexpr double kEdge = 1e-9;      // postures this far over the edge of a cell may be taken for it

// A cluster of triangles of a link.
struct Piece {
  Ball ball;                      // in the link, as are
  std::vector<Vector3d> corners;  // of its triangles
  std::unique_ptr<ClusteredMesh> mesh;
};

std::vector<Piece> pieces_of(const LinkGeometry& link) {
  std::vector<Piece> pieces;
  for (const TriangleCluster& cluster : link.clusters) {
    TriangleMesh mesh;
    for (int lane = 0; lane < cluster.count; ++lane) {
      const int first = static_cast<int>(mesh.points.size());
      for (const auto& corner : cluster.corner) {
        mesh.points.emplace_back(static_cast<double>(corner[0][lane]),
                                 static_cast<double>(corner[1][lane]),
                                 static_cast<double>(corner[2][lane]));
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    Piece piece;
    piece.ball.center = {static_cast<double>(cluster.center[0]),
                         static_cast<double>(cluster.center[1]),
                         static_cast<double>(cluster.center[2])};
    piece.ball.radius = static_cast<double>(cluster.radius);
    piece.mesh = std::make_unique<ClusteredMesh>(mesh);
    piece.corners = std::move(mesh.points);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

struct Box {  // of cells: from low up to, not with, high
  std::array<int, JointCells::kMostJoints> low{}, high{};
};

using Couple = std::pair<int, int>;  // pieces of a and b

// The joints that move link a, and link b, alone; from the outermost on.
using Sides = std::array<std::vector<int>, 2>;

Sides joints_between(const Model& model, const CollisionPair& pair) {
  Sides sides;
  for (int j = model.joint_count() - 1; j >= 0; --j) {
    if (!joint_moves_pair(model, j, pair.link_a, pair.link_b)) continue;
    sides[joint_moves_pair(model, j, pair.link_a, -1) ? 0 : 1].push_back(j);
  }
  return sides;
}

// Cells of which nothing is known yet; without joints where there are too many, or one without limits.
JointCells unknown_cells(const Model& model, const Sides& sides, int per_joint) {
  JointCells cells;
  const std::size_t between = sides[0].size() + sides[1].size();
  if (between == 0 || between > JointCells::kMostJoints) return {};
  std::size_t total = 1;
  for (const std::vector<int>& side : sides) {
    for (const int j : side) {
      const Joint& joint = model.joints[at(j)];
      const bool turns = joint.kind != JointKind::kPrismatic;
      const double low = turns ? std::max(joint.lower, -std::numbers::pi) : joint.lower;
      const double high = turns ? std::min(joint.upper, std::numbers::pi) : joint.upper;
      if (!(std::isfinite(high - low) && high > low)) return {};
      const int k = cells.joints++;
      cells.joint[k] = j;
      cells.count[k] = per_joint;
      cells.low[k] = low;
      cells.per_unit[k] = cells.count[k] / (high - low);
      total *= at(cells.count[k]);
    }
  }
  cells.cell.assign(total, JointCells::kUnknown);
  cells.lists.assign(2, 0);  // so that no list begins where the numbers mean something else
  return cells;
}

class Finder {
 public:
  Finder(const Model& model, const RobotGeometry& geometry, const JointCellOptions& options)
      : model_(model),
        geometry_(geometry),
        options_(options),
        kinematics_(model),
        now_(model),
        pieces_(geometry.links.size()) {}

  JointCells find(const CollisionPair& pair) {
    pair_ = pair;
    side_ = joints_between(model_, pair);
    JointCells cells = unknown_cells(model_, side_, options_.per_joint);
    if (cells.joints == 0) return cells;
    cells_ = &cells;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<Piece>& pieces = of_link(k == 0 ? pair.link_a : pair.link_b);
      if (pieces.size() > kMostClusters) return {};
      moved_[k].resize(pieces.size());
      centers_[k].resize(pieces.size());
      for (const Piece& piece : pieces) distance_.reserve(*piece.mesh);
    }
    std::vector<Couple> all;
    for (int a = 0; a < static_cast<int>(moved_[0].size()); ++a) {
      for (int b = 0; b < static_cast<int>(moved_[1].size()); ++b) all.emplace_back(a, b);
    }
    check_ = std::make_unique<SelfCollision>(model_, geometry_, std::vector<CollisionPair>{pair});
    looks_ = 0;
    Box whole;
    for (int k = 0; k < cells.joints; ++k) whole.high[at(k)] = cells.count[k];
    search(whole, all);
    return cells;
  }

 private:
  std::vector<Piece>& of_link(int link) {
    const std::size_t index = at(geometry_.of_link[at(link)]);
    if (pieces_[index].empty()) pieces_[index] = pieces_of(geometry_.links[index]);
    return pieces_[index];
  }

  double half_width(const Box& box, int k) const {
    return 0.5 * (box.high[at(k)] - box.low[at(k)]) / cells_->per_unit[k] + kEdge;
  }

  // To the middle of the box; what its joints can then move every piece of a side by.
  void place(const Box& box) {
    const JointCells& cells = *cells_;
    for (int k = 0; k < cells.joints; ++k) {
      now_.q[cells.joint[k]] =
          cells.low[k] + 0.5 * (box.low[at(k)] + box.high[at(k)]) / cells.per_unit[k];
    }
    kinematics_.update(now_);
    int k = 0;
    for (std::size_t s = 0; s < 2; ++s) {
      half_[s].clear();
      slide_[s] = 0.0;
      for (const int j : side_[s]) {
        half_[s].push_back(half_width(box, k++));
        if (model_.joints[at(j)].kind == JointKind::kPrismatic) slide_[s] += half_[s].back();
      }
      const int link = s == 0 ? pair_.link_a : pair_.link_b;
      const std::vector<Piece>& pieces = of_link(link);
      for (std::size_t p = 0; p < pieces.size(); ++p) {
        const Vector3d center = kinematics_.link_in_world(link) * pieces[p].ball.center;
        double moved = 0.0;
        for (std::size_t i = 0; i < side_[s].size(); ++i) {
          const int j = side_[s][i];
          const double half = half_[s][i];
          if (model_.joints[at(j)].kind == JointKind::kPrismatic) {
            moved += half;
            continue;
          }
          const Vector3d arm = center - kinematics_.link_in_world(j + 1).translation();
          const double reach =
              kinematics_.axis_in_world(j).cross(arm).norm() + pieces[p].ball.radius + moved;
          moved += 2.0 * reach * std::sin(0.5 * std::min(half, std::numbers::pi));
        }
        moved_[s][p] = moved;
        centers_[s][p] = center;
      }
    }
  }

  bool apart(const Couple& couple) {
    const std::size_t a = at(couple.first), b = at(couple.second);
    const Piece& of_a = of_link(pair_.link_a)[a];
    const Piece& of_b = of_link(pair_.link_b)[b];
    const double moved = moved_[0][a] + moved_[1][b] + kRounding;
    const double gap =
        (centers_[0][a] - centers_[1][b]).norm() - of_a.ball.radius - of_b.ball.radius;
    if (gap > moved) return true;
    MeshMemory memory;
    MeshGap found;
    if (!distance_.between(*of_a.mesh, kinematics_.link_in_world(pair_.link_a), *of_b.mesh,
                           kinematics_.link_in_world(pair_.link_b), moved, 0.0, memory, found))
      return true;
    if (!(found.distance > kRounding)) return false;
    // Along the way between the nearest points they may be parted though they can move farther.
    const Vector3d way = (found.point_b - found.point_a) / found.distance;
    return nearest_along(0, a, -way) + nearest_along(1, b, way) > kRounding;
  }

  // How near the piece of side s comes, along `way` (unit, world): no point of it has a smaller product
  // with `way` in the box.  First order in the joints' moves, and a bound of the second:
  //     |d2x / ds2 at q + s dq|  <=  (sum of |dq_j|)^2 (largest distance from their axes)
  double nearest_along(std::size_t s, std::size_t p, const Vector3d& way) {
    const int link = s == 0 ? pair_.link_a : pair_.link_b;
    const Piece& piece = of_link(link)[p];
    const Eigen::Isometry3d& pose = kinematics_.link_in_world(link);
    const Vector3d way_in_link = pose.linear().transpose() * way;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector3d& corner : piece.corners)
      nearest = std::min(nearest, way_in_link.dot(corner));
    nearest += way.dot(pose.translation());
    double turn = 0.0, farthest = 0.0, first_order = 0.0;
    for (std::size_t i = 0; i < side_[s].size(); ++i) {
      const int j = side_[s][i];
      const Vector3d& axis = kinematics_.axis_in_world(j);
      const double half = half_[s][i];
      if (model_.joints[at(j)].kind == JointKind::kPrismatic) {
        first_order += half * std::abs(axis.dot(way));
        continue;
      }
      // way . (axis x (corner - origin)) = (way x axis) . (corner - origin)
      const Vector3d lever = pose.linear().transpose() * way.cross(axis);
      const Vector3d origin =
          pose.inverse(Eigen::Isometry) * kinematics_.link_in_world(j + 1).translation();
      double most = 0.0;
      for (const Vector3d& corner : piece.corners)
        most = std::max(most, std::abs(lever.dot(corner - origin)));
      first_order += half * most;
      turn += half;
      farthest = std::max(farthest, (piece.ball.center - origin).norm() + piece.ball.radius);
    }
    return nearest - first_order - 0.5 * turn * turn * (farthest + moved_[s][p]) - turn * slide_[s];
  }

  void search(const Box& box, const std::vector<Couple>& couples) {
    if (++looks_ > options_.looks) return;
    place(box);
    std::vector<Couple> near;
    for (const Couple& couple : couples) {
      if (!apart(couple)) near.push_back(couple);
    }
    if (near.empty()) {
      check_->place(now_.q);
      if (!check_->touches(0)) mark(box, JointCells::kFree);
      return;
    }
    int widest = -1;
    double most = 0.0;
    for (int k = 0; k < cells_->joints; ++k) {
      if (box.high[at(k)] - box.low[at(k)] < 2 || half_width(box, k) <= most) continue;
      most = half_width(box, k);
      widest = k;
    }
    if (widest < 0) {
      list(box, near);
      return;
    }
    const int middle = (box.low[at(widest)] + box.high[at(widest)]) / 2;
    Box lower = box, upper = box;
    lower.high[at(widest)] = upper.low[at(widest)] = middle;
    search(lower, near);
    search(upper, near);
  }

  void list(const Box& cell, const std::vector<Couple>& couples) {
    if (couples.size() > JointCells::kMostCouples) return;
    std::vector<std::uint32_t>& lists = cells_->lists;
    mark(cell, static_cast<std::uint32_t>(lists.size()));
    lists.push_back(static_cast<std::uint32_t>(couples.size()));
    for (const auto& [a, b] : couples)
      lists.push_back(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b) << 16);
  }

  void mark(const Box& box, std::uint32_t as) {
    JointCells& cells = *cells_;
    std::array<int, JointCells::kMostJoints> now = box.low;
    while (true) {
      std::size_t index = 0;
      for (int k = 0; k < cells.joints; ++k) index = index * at(cells.count[k]) + at(now[at(k)]);
      cells.cell[index] = as;
      int k = cells.joints - 1;
      while (k >= 0 && ++now[at(k)] == box.high[at(k)]) {
        now[at(k)] = box.low[at(k)];
        --k;
      }
      if (k < 0) return;
    }
  }

  const Model& model_;
  const RobotGeometry& geometry_;
  JointCellOptions options_;
  Kinematics kinematics_;
  Configuration now_;
  std::vector<std::vector<Piece>> pieces_;  // of links, once they are asked for
  MeshDistance distance_;
  // Of the pair in hand.
  CollisionPair pair_;
  Sides side_;                    // joints that move a, b alone
  std::vector<double> half_[2];   // widths of their ranges
  double slide_[2] = {};          // of the sliding ones, together
  std::vector<double> moved_[2];  // of the pieces
  std::vector<Vector3d> centers_[2];
  std::unique_ptr<SelfCollision> check_;
  JointCells* cells_ = nullptr;
  int looks_ = 0;
};

}  // namespace

std::vector<JointCells> find_joint_cells(const Model& model, const RobotGeometry& geometry,
                                         const std::vector<CollisionPair>& pairs,
                                         const JointCellOptions& options,
                                         const std::function<void(int done)>& progress) {
  Finder finder(model, geometry, options);
  std::vector<JointCells> cells;
  for (const CollisionPair& pair : pairs) {
    if (progress) progress(static_cast<int>(cells.size()));
    cells.push_back(finder.find(pair));
  }
  return cells;
}

bool are_cells_of(const JointCells& cells, const Model& model, const RobotGeometry& geometry,
                  const CollisionPair& pair, const JointCellOptions& options) {
  if (cells.joints == 0) return cells.cell.empty() && cells.lists.empty();
  const JointCells blank = unknown_cells(model, joints_between(model, pair), options.per_joint);
  if (cells.joints != blank.joints || cells.cell.size() != blank.cell.size()) return false;
  for (int k = 0; k < blank.joints; ++k) {
    if (cells.joint[k] != blank.joint[k] || cells.count[k] != blank.count[k] ||
        cells.low[k] != blank.low[k] || cells.per_unit[k] != blank.per_unit[k])
      return false;
  }
  const auto clusters = [&](int link) {
    return geometry.links[at(geometry.of_link[at(link)])].clusters.size();
  };
  const std::size_t of_a = clusters(pair.link_a), of_b = clusters(pair.link_b);
  const std::vector<std::uint32_t>& lists = cells.lists;
  std::vector<char> begins(lists.size(), 0);
  if (lists.size() < 2) return false;
  for (std::size_t i = 2; i < lists.size();) {
    const std::size_t count = lists[i];
    if (count < 1 || count > JointCells::kMostCouples || count >= lists.size() - i) return false;
    begins[i] = 1;
    for (std::size_t k = i + 1; k <= i + count; ++k) {
      if ((lists[k] & 0xFFFFU) >= of_a || lists[k] >> 16 >= of_b) return false;
    }
    i += count + 1;
  }
  return std::all_of(cells.cell.begin(), cells.cell.end(), [&](std::uint32_t cell) {
    return cell <= JointCells::kUnknown || (cell < begins.size() && begins[cell] != 0);
  });
}

}  // namespace twinbus::robot
