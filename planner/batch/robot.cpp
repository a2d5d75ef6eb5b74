#include "planner/batch/robot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "geometry/bounds/coarse_mesh.h"

namespace twinbus::inline planner {

namespace {

constexpr double kRounding = 1e-6;  // [m]
constexpr double kHollow = 0.002;   // that a piece may fill [m]
constexpr double kWhole = 1e-6;     // a column this near to an axis is that

// The link as a part of a body.
struct Place {
  int body = 0;
  Eigen::Isometry3d in_body = Eigen::Isometry3d::Identity();
};

Eigen::Matrix3d turned_to(const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
}

BlockBody body_from(const Eigen::Isometry3d& placement) {
  BlockBody body;
  for (int column = 0; column < 3; ++column) {
    const Eigen::Vector3d entries = placement.linear().col(column);
    int row = 0;
    entries.cwiseAbs().maxCoeff(&row);
    Eigen::Vector3d whole = Eigen::Vector3d::Zero();
    whole[row] = entries[row] > 0.0 ? 1.0 : -1.0;
    body.axis[column] = (entries - whole).cwiseAbs().maxCoeff() < kWhole ? row : -1;
    body.sign[column] = static_cast<float>(whole[row]);
    for (int i = 0; i < 3; ++i) body.rotation[3 * i + column] = static_cast<float>(entries[i]);
  }
  for (int row = 0; row < 3; ++row) {
    const double offset = placement.translation()[row];
    body.offset[row] = std::abs(offset) < 1e-9 ? 0.0F : static_cast<float>(offset);
  }
  return body;
}

double rounded_up(double radius) { return radius * 1.00001; }

// Smallest ball around balls, nearly: the centre walks to the farthest one by ever shorter steps.
Ball around(const std::vector<Ball>& balls) {
  Ball ball;
  for (const Ball& b : balls) ball.center += b.center / static_cast<double>(balls.size());
  const auto reach = [&](const Ball& b) { return (b.center - ball.center).norm() + b.radius; };
  const auto farthest = [&] {
    return *std::max_element(balls.begin(), balls.end(),
                             [&](const Ball& a, const Ball& b) { return reach(a) < reach(b); });
  };
  if (balls.size() > 1) {
    for (int i = 0; i < 300; ++i) {
      const Ball far = farthest();
      const Eigen::Vector3d towards = far.center - ball.center;
      if (!(towards.norm() > 1e-9)) break;
      ball.center += towards.normalized() * reach(far) * 0.5 / (i + 2.0);
    }
  }
  ball.radius = rounded_up(reach(farthest()));
  return ball;
}

BlockBall to_block(const Ball& ball, const Eigen::Isometry3d& in_body, double grow) {
  const Eigen::Vector3f center = (in_body * ball.center).cast<float>();
  return {center.x(), center.y(), center.z(), static_cast<float>(ball.radius + grow)};
}

// How far a point of the group is from a joint's axis at most, in any posture.
double farthest_from(const std::vector<BlockBody>& bodies, const std::vector<double>& slide,
                     int body, const BlockGroup& group) {
  const Eigen::Vector3d at_group(static_cast<double>(group.around.x),
                                 static_cast<double>(group.around.y),
                                 static_cast<double>(group.around.z));
  double length = static_cast<double>(group.around.radius);
  if (group.body == body) return length + at_group.head<2>().norm();
  length += at_group.norm();
  for (int b = group.body; b != body; b = bodies[at(b)].parent) {
    const float* offset = bodies[at(b)].offset;
    const Eigen::Vector3d o(static_cast<double>(offset[0]), static_cast<double>(offset[1]),
                            static_cast<double>(offset[2]));
    length += bodies[at(b)].parent == body ? o.head<2>().norm() : o.norm();
    length += slide[at(b)];
  }
  return length;
}

using CornersOfOne = std::array<Eigen::Vector3d, 3>;

// How far corners stick out above the planes of the triangles [m]: what the hull of a patch that is hollow adds to it.
double hollowness(const std::vector<CornersOfOne>& triangles) {
  double highest = 0.0;
  for (const CornersOfOne& t : triangles) {
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    for (const CornersOfOne& other : triangles) {
      for (const Eigen::Vector3d& corner : other)
        highest = std::max(highest, normal.dot(corner - t[0]));
    }
  }
  return highest;
}

// The corners of the triangles as one piece, or halves of them where that would fill a hollow.
void add_pieces(std::vector<CornersOfOne> triangles,
                std::vector<std::vector<Eigen::Vector3d>>& pieces) {
  if (triangles.size() > 1 && hollowness(triangles) > kHollow) {
    Eigen::AlignedBox3d around;
    const auto middle = [](const CornersOfOne& t) {
      return Eigen::Vector3d((t[0] + t[1] + t[2]) / 3.0);
    };
    for (const CornersOfOne& t : triangles) around.extend(middle(t));
    int axis = 0;
    around.sizes().maxCoeff(&axis);
    const auto half = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
    std::nth_element(triangles.begin(), half, triangles.end(),
                     [&](const CornersOfOne& a, const CornersOfOne& b) {
                       return middle(a)[axis] < middle(b)[axis];
                     });
    add_pieces({triangles.begin(), half}, pieces);
    add_pieces({half, triangles.end()}, pieces);
    return;
  }
  std::vector<Eigen::Vector3d> corners;
  for (const CornersOfOne& t : triangles) {
    for (const Eigen::Vector3d& c : t) {
      if (std::find(corners.begin(), corners.end(), c) == corners.end()) corners.push_back(c);
    }
  }
  pieces.push_back(std::move(corners));
}

}  // namespace

BallGroup group_from(const LinkGeometry& geometry) {
  BallGroup group;
  group.link = geometry.link;
  // A hull of very many corners is asked too often: one of few that is hardly larger, and the pieces settle the rest.
  const auto coarse = geometry.hull.points.size() > at(kMostCorners) ? coarse_hull(geometry.hull) : std::nullopt;
  group.pieces.push_back(coarse ? coarse->points : geometry.hull.points);
  // Pieces are clusters of triangles, or parts of them: together they are the mesh, nearly.
  for (const TriangleCluster& cluster : geometry.clusters) {
    std::vector<CornersOfOne> triangles;
    for (int i = 0; i < cluster.count; ++i) {
      CornersOfOne& t = triangles.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        for (int axis = 0; axis < 3; ++axis)
          t[c][axis] = static_cast<double>(cluster.corner[c][axis][i]);
      }
    }
    add_pieces(std::move(triangles), group.pieces);
  }
  return group;
}

GroupBounds bounds_of(const BallGroup& group) {
  GroupBounds bounds{.balls = around(group.balls), .pieces = {}, .bunches = {}};
  std::vector<Ball> bunch;
  for (std::size_t i = 0; i < group.pieces.size(); ++i) {
    const std::vector<Eigen::Vector3d>& corners = group.pieces[i];
    Ball ball;
    for (const Eigen::Vector3d& c : corners) ball.center += c / static_cast<double>(corners.size());
    for (const Eigen::Vector3d& c : corners)
      ball.radius = std::max(ball.radius, rounded_up((c - ball.center).norm()) + kRounding);
    bounds.pieces.push_back(ball);
    if (i > 0) bunch.push_back(ball);
    if (bunch.size() == at(kBunch) || (!bunch.empty() && i + 1 == group.pieces.size())) {
      bounds.bunches.push_back(around(bunch));
      bunch.clear();
    }
  }
  return bounds;
}

BlockRobot compile_robot(const Model& model, const Configuration& posture,
                         const std::vector<int>& planned, const std::vector<BallGroup>& groups,
                         const std::vector<std::pair<int, int>>& pairs, double grow) {
  if (planned.empty() || planned.size() > at(kMostPlanned))
    throw std::runtime_error("planner: 1 to 24 joints can be planned together");
  BlockRobot robot;
  robot.joints = static_cast<int>(planned.size());
  robot.grow = static_cast<float>(grow);
  for (const int joint : planned) {
    const bool endless = model.joints[at(joint)].kind == JointKind::kContinuous;
    robot.lower.push_back(
        static_cast<float>(endless ? posture.q[joint] - M_PI : model.joints[at(joint)].lower));
    robot.upper.push_back(
        static_cast<float>(endless ? posture.q[joint] + M_PI : model.joints[at(joint)].upper));
  }

  std::vector<Place> places(at(model.link_count()));
  std::vector<double> slide{0.0};
  robot.bodies.emplace_back();
  places[0].in_body = posture.base;
  for (int link = 1; link < model.link_count(); ++link) {
    const Joint& joint = model.joints[at(link - 1)];
    const Place& parent = places[at(joint.parent)];
    const int source = joint.mimic >= 0 ? joint.mimic : link - 1;
    const auto found = std::find(planned.begin(), planned.end(), source);
    const Eigen::Isometry3d placed = parent.in_body * joint.placement;
    const bool slides = joint.kind == JointKind::kPrismatic;
    if (found == planned.end()) {
      const double q = posture.q[link - 1];
      Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
      if (slides)
        moved.translation() = q * joint.axis;
      else
        moved.linear() = Eigen::AngleAxisd(q, joint.axis).toRotationMatrix();
      places[at(link)] = {parent.body, placed * moved};
      continue;
    }
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.linear() = turned_to(joint.axis);
    BlockBody body = body_from(placed * turn);
    body.parent = parent.body;
    body.joint = static_cast<int>(found - planned.begin());
    body.slides = slides;
    if (joint.mimic >= 0) {
      body.scale = static_cast<float>(joint.mimic_multiplier);
      body.shift = static_cast<float>(joint.mimic_offset);
    }
    robot.bodies.push_back(body);
    slide.push_back(slides ? std::max(std::abs(joint.lower), std::abs(joint.upper)) : 0.0);
    places[at(link)] = {static_cast<int>(robot.bodies.size()) - 1, turn.inverse()};
  }

  std::vector<int> order;  // of the groups: those of the world first
  for (int part = 0; part < 2; ++part) {
    for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
      if ((places[at(groups[at(g)].link)].body == 0) == (part == 0) && !groups[at(g)].balls.empty())
        order.push_back(g);
    }
  }
  std::vector<int> index(groups.size(), -1);
  for (const int g : order) {
    const BallGroup& from = groups[at(g)];
    const Place& place = places[at(from.link)];
    BlockGroup group;
    group.link = from.link;
    group.body = place.body;
    group.first = static_cast<int>(robot.balls.size());
    group.count = static_cast<int>(from.balls.size());
    const GroupBounds bounds = from.bounds ? *from.bounds : bounds_of(from);
    group.around = to_block(bounds.balls, place.in_body, grow);
    for (const Ball& ball : from.balls) robot.balls.push_back(to_block(ball, place.in_body, grow));
    group.first_piece = static_cast<int>(robot.pieces.size());
    group.piece_count = static_cast<int>(from.pieces.size());
    group.first_inner = static_cast<int>(robot.inner.size());
    group.inner_count = static_cast<int>(from.inner.size());
    for (const Ball& ball : from.inner) robot.inner.push_back(to_block(ball, place.in_body, 0.0));
    group.first_bunch = static_cast<int>(robot.bunches.size());
    for (const Ball& bunch : bounds.bunches) robot.bunches.push_back(to_block(bunch, place.in_body, grow));
    for (std::size_t i = 0; i < from.pieces.size(); ++i) {
      const std::vector<Eigen::Vector3d>& corners = from.pieces[i];
      BlockPiece piece;
      piece.first = static_cast<int>(robot.corners.size());
      piece.count = static_cast<int>(corners.size());
      piece.room = (piece.count + 15) / 16 * 16;
      piece.around = to_block(bounds.pieces[i], place.in_body, grow);
      robot.pieces.push_back(piece);
      robot.corners.resize(robot.corners.size() + at(3 * piece.room));
      float* columns = robot.corners.data() + piece.first;
      for (int k = 0; k < piece.room; ++k) {
        const Eigen::Vector3d corner = place.in_body * corners[at(k < piece.count ? k : 0)];
        for (int axis = 0; axis < 3; ++axis) columns[axis * piece.room + k] = static_cast<float>(corner[axis]);
      }
    }
    for (int b = place.body; b > 0; b = robot.bodies[at(b)].parent) {
      const BlockBody& body = robot.bodies[at(b)];
      if (!body.slides) group.turn[body.joint] += std::abs(body.scale);
      group.travel[body.joint] +=
          std::abs(body.scale) *
          (body.slides ? 1.0F : static_cast<float>(farthest_from(robot.bodies, slide, b, group)));
    }
    index[at(g)] = static_cast<int>(robot.groups.size());
    robot.groups.push_back(group);
    if (group.body == 0) ++robot.fixed_groups;
  }
  robot.group_of = index;
  for (const auto& [a, b] : pairs) {
    if (index[at(a)] < 0 || index[at(b)] < 0) continue;
    if (robot.groups[at(index[at(a)])].body == robot.groups[at(index[at(b)])].body) continue;
    robot.pairs.emplace_back(index[at(a)], index[at(b)]);
  }
  if (robot.bodies.size() > at(kBlockBodies) || robot.groups.size() > at(kBlockGroups) ||
      robot.balls.size() > at(kBlockBalls)) {
    throw std::runtime_error("planner: " + model.name +
                             " has more bodies, links or balls than a block holds");
  }
  return robot;
}

}  // namespace twinbus::planner
