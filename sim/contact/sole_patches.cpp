#include "sim/contact/sole_patches.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "sim/world/link_hull.h"

namespace twinbus::inline sim {

namespace {

constexpr double kOneDirection = 0.99999;  // cosine between tops that are one patch
constexpr double kUp = 0.5;      // cosine of the steepest top, and of the steepest sole on it
constexpr double kPlane = 3e-3;  // of the sole: what of the foot belongs to it [m]
constexpr double kLikeIt = 0.6;  // of the rectangle, at least, is an outline
constexpr std::size_t kMostCorners = 12;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Counter-clockwise (Andrew 1979).
std::vector<Eigen::Vector2d> hull_of(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Eigen::Vector2d> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t begin = hull.size();
    for (const Eigen::Vector2d& p : points) {
      while (hull.size() >= begin + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 1e-12) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// Of the corners that it has alone.
PatchPolygon copy_of(const PatchPolygon& polygon) noexcept {
  PatchPolygon copy;
  copy.count = polygon.count;
  std::copy_n(polygon.corner.begin(), polygon.count, copy.corner.begin());
  return copy;
}

double area_of(const std::vector<Eigen::Vector2d>& hull) {
  double area = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    area += 0.5 * cross(hull[i], hull[(i + 1) % hull.size()]);
  return area;
}

// Without those corners that add least.
void thin_out(std::vector<Eigen::Vector2d>& hull) {
  while (hull.size() > kMostCorners) {
    std::size_t least = 0;
    double smallest = 1e9;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Eigen::Vector2d& before = hull[(i + hull.size() - 1) % hull.size()];
      const double adds = cross(hull[i] - before, hull[(i + 1) % hull.size()] - before);
      if (adds < smallest) {
        smallest = adds;
        least = i;
      }
    }
    hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

void add_points(const Shape& shape, std::vector<Eigen::Vector3d>& points) {
  if (shape.kind == ShapeKind::kMesh) {
    const TriangleMesh hull = link_hull(shape);
    points.insert(points.end(), hull.points.begin(), hull.points.end());
  } else if (shape.kind == ShapeKind::kBox) {
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d side(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
      points.push_back(shape.pose * side.cwiseProduct(shape.size));
    }
  }
}

}  // namespace

SolePatches::SolePatches(const Model& model, const WorldConfig& config) {
  (void)direction_of(Eigen::Vector3d::UnitZ());
  for (std::size_t side = 0; side < 2; ++side) {
    if (model.soles[side].link >= 0) soles_[side] = outline_of(model, model.soles[side]);
  }
  int index = -1;
  for (const Obstacle& obstacle : config.obstacles) {
    if (obstacle.shape == ObstacleShape::kNone) continue;
    ++index;
    if (obstacle.shape != ObstacleShape::kBox) continue;
    for (int face = 0; face < 6; ++face) {
      const double sign = face % 2 == 0 ? 1.0 : -1.0;
      if (sign * obstacle.pose.linear()(2, face / 2) > kUp)
        add_top(obstacle, face / 2, sign, index);
    }
  }
  for (const Obstacle& tile : config.tiles) add_top(tile, 2, 1.0, -1);
}

SolePatches::Outline SolePatches::outline_of(const Model& model, const Sole& sole) {
  Outline made;
  made.front = sole.front;
  made.back = sole.back;
  made.left = sole.left;
  made.right = sole.right;
  std::vector<Eigen::Vector3d> points;
  for (const Shape& shape : model.links[at(sole.link)].collision) add_points(shape, points);
  std::vector<Eigen::Vector2d> near;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = sole.frame.inverse() * point;
    if (std::abs(p.z()) < kPlane) {
      near.push_back(
          {std::clamp(p.x(), -sole.back, sole.front), std::clamp(p.y(), -sole.right, sole.left)});
    }
  }
  const std::vector<Eigen::Vector2d> rectangle = {{sole.front, sole.left},
                                                  {-sole.back, sole.left},
                                                  {-sole.back, -sole.right},
                                                  {sole.front, -sole.right}};
  std::vector<Eigen::Vector2d> hull = near.size() < 3 ? rectangle : hull_of(near);
  if (hull.size() < 3 || !(area_of(hull) > kLikeIt * area_of(rectangle))) hull = rectangle;
  thin_out(hull);
  for (const Eigen::Vector2d& corner : hull) {
    made.outline.add(corner);
    made.radius = std::max(made.radius, corner.norm());
  }
  made.moments = moments_of(made.outline);
  return made;
}

int SolePatches::direction_of(const Eigen::Vector3d& normal) {
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    if (normals_[i].dot(normal) > kOneDirection) return static_cast<int>(i);
  }
  normals_.push_back(normal);
  frames_.emplace_back(Eigen::Vector3d::Zero(), normal);
  return static_cast<int>(normals_.size()) - 1;
}

void SolePatches::add_top(const Obstacle& box, int axis, double sign, int obstacle) {
  const Eigen::Matrix3d& turn = box.pose.linear();
  const Eigen::Vector3d normal = sign * turn.col(axis);
  Surface top;
  top.direction = direction_of(normal);
  top.obstacle = obstacle;
  top.middle = box.pose.translation() + 0.5 * box.size[axis] * normal;
  const int along = (axis + 1) % 3, across = (axis + 2) % 3;
  top.along = turn.col(along);
  top.across = turn.col(across);
  top.half_along = 0.5 * box.size[along];
  top.half_across = 0.5 * box.size[across];
  top.reach = std::hypot(top.half_along, top.half_across);
  tops_.push_back(top);
}

bool SolePatches::stands_on(std::size_t obstacle, const Eigen::Vector3d& point) const noexcept {
  return std::any_of(tops_.begin(), tops_.end(), [&](const Surface& top) {
    if (top.obstacle != static_cast<int>(obstacle)) return false;
    const double depth = normals_[at(top.direction)].dot(top.middle - point);
    return depth < kSoleSkin;
  });
}

// A sole over the plane of one direction: where its points lie there, as fields over x and y.
struct SolePatches::Placed {
  PatchFrame frame;     // its origin is the sole frame's
  Eigen::Matrix2d turn;  // from the sole's x and y to those of the frame
  LinearField height;   // of the sole along the normal
  LinearField offset;   // what the ground is lowered
  LinearField closing;  // so much nearer at the end of the step
  PatchPolygon outline;
  std::array<LinearField, 3> world;  // of a point of the sole, less the frame's origin

  // direction.(point - from), of the points of the sole.
  LinearField along(const Eigen::Vector3d& direction, const Eigen::Vector3d& from) const noexcept {
    LinearField field{direction.dot(frame.origin - from), Eigen::Vector2d::Zero()};
    for (int axis = 0; axis < 3; ++axis) field.slope += direction[axis] * world[at(axis)].slope;
    return field;
  }
  // Whether no point of the sole is where that is below zero.
  bool lies_in(const LinearField& field) const noexcept {
    return std::all_of(outline.corner.begin(), outline.corner.begin() + outline.count,
                       [&field](const Eigen::Vector2d& x) { return field.at(x) >= 0.0; });
  }
  void clip_to(const Surface& top, PatchPolygon& polygon) const noexcept {
    const auto within = [&](const Eigen::Vector3d& axis, double half) {
      const LinearField field = along(axis, top.middle);
      polygon.keep({half - field.offset, -field.slope});
      if (polygon.count > 2) polygon.keep({half + field.offset, field.slope});
    };
    within(top.along, top.half_along);
    if (polygon.count > 2) within(top.across, top.half_across);
  }
};

int SolePatches::find(std::size_t side, const Eigen::Isometry3d& sole,
                      const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin, double h,
                      double ground, const Offsets& offset, Points& points) const noexcept {
  const Outline& own = soles_[side];
  const Eigen::Vector3d origin = sole.translation(), up = sole.linear().col(2);
  const double ahead = h * (velocity.norm() + spin.norm() * own.radius);
  const auto near = [&](const Surface& top) {
    const double reach = own.radius + top.reach + ahead;
    return (top.middle - origin).squaredNorm() < reach * reach;
  };
  // The offsets of four corners as a plane.
  const double length = own.front + own.back, width = own.left + own.right;
  const double by_x = 0.5 * (offset[0] + offset[1] - offset[2] - offset[3]) / length;
  const double by_y = 0.5 * (offset[0] + offset[2] - offset[1] - offset[3]) / width;
  const double mean = 0.25 * (offset[0] + offset[1] + offset[2] + offset[3]);
  const double at_frame =
      mean - by_x * 0.5 * (own.front - own.back) - by_y * 0.5 * (own.left - own.right);
  const bool alone = std::none_of(tops_.begin(), tops_.end(), near);
  const Eigen::Vector3d lowered = by_x * sole.linear().col(0) + by_y * sole.linear().col(1);

  int count = 0;
  for (std::size_t direction = 0; direction < normals_.size(); ++direction) {
    const Eigen::Vector3d& n = normals_[direction];
    if (!(up.dot(n) > kUp) || count + Patch::kPoints > kMostPoints) continue;
    const bool of_ground =
        direction == 0 && origin.z() - own.radius - ahead < ground - std::min(0.0, mean) + 0.1;
    if (!of_ground && std::none_of(tops_.begin(), tops_.end(), [&](const Surface& top) {
          return top.direction == static_cast<int>(direction) && near(top);
        })) {
      continue;
    }
    Placed placed{frames_[direction], {}, {}, {}, {}, {}, {}};
    PatchFrame& frame = placed.frame;
    frame.origin = origin;
    placed.turn << frame.x.dot(sole.linear().col(0)), frame.x.dot(sole.linear().col(1)),
        frame.y.dot(sole.linear().col(0)), frame.y.dot(sole.linear().col(1));
    placed.height.slope = -Eigen::Vector2d(up.dot(frame.x), up.dot(frame.y)) / up.dot(n);
    for (int axis = 0; axis < 3; ++axis) {
      placed.world[at(axis)].slope =
          Eigen::Vector2d(frame.x[axis], frame.y[axis]) + n[axis] * placed.height.slope;
    }
    placed.offset = placed.along(lowered, origin);
    placed.offset.offset += at_frame;
    placed.closing = placed.along(n.cross(spin), origin);
    placed.closing.offset += n.dot(velocity);
    placed.closing = {-h * placed.closing.offset, -h * placed.closing.slope};
    for (int i = 0; i < own.outline.count; ++i)
      placed.outline.add(placed.turn * own.outline.corner[at(i)]);
    const auto now = [&](const Eigen::Vector3d& normal,
                         const Eigen::Vector3d& on) {  // depth at the start
      const LinearField above = placed.along(normal, on);
      return LinearField{-above.offset - placed.offset.offset, -above.slope - placed.offset.slope};
    };
    const LinearField ground_now = now(Eigen::Vector3d::UnitZ(), Eigen::Vector3d(0.0, 0.0, ground));
    Patch patch;
    const auto press = [&](const LinearField& closing) {
      const auto then = [&](const LinearField& depth) {
        return LinearField{depth.offset + closing.offset, depth.slope + closing.slope};
      };
      PatchSum sum;
      if (of_ground && alone && placed.lies_in(then(ground_now))) {  // mostly: nothing to cut
        sum.add(mapped(own.moments, placed.turn), placed.height, then(ground_now));
      } else if (of_ground) {
        PatchPolygon whole = copy_of(placed.outline);
        const LinearField depth = then(ground_now);
        whole.keep(depth);
        if (whole.count > 2) sum.add(whole, placed.height, depth);
        for (const Surface& top : tops_) {
          if (whole.count < 3 || !near(top)) continue;
          PatchPolygon covered = copy_of(whole);
          placed.clip_to(top, covered);
          if (covered.count > 2)
            covered.keep(now(normals_[at(top.direction)], top.middle) - ground_now);
          if (covered.count > 2) sum.add(covered, placed.height, depth, -1.0);
        }
      }
      for (const Surface& top : tops_) {
        if (top.direction != static_cast<int>(direction) || !near(top)) continue;
        const LinearField at_start = now(n, top.middle), depth = then(at_start);
        PatchPolygon polygon = copy_of(placed.outline);
        polygon.keep(depth);
        if (polygon.count > 2) placed.clip_to(top, polygon);
        if (polygon.count > 2) polygon.keep(at_start - ground_now);
        if (top.obstacle >= 0 && polygon.count > 2)
          polygon.keep({kSoleSkin - depth.offset, -depth.slope});
        if (polygon.count > 2) sum.add(polygon, placed.height, depth);
      }
      return sum.finish(frame, patch);
    };
    // What only presses now may still have to, if something holds it.
    if (!press(placed.closing)) {
      placed.closing = {};
      if (!press(placed.closing)) continue;
    }
    for (int i = 0; i < Patch::kPoints; ++i) {
      const PatchPoint& from = patch.point[at(i)];
      SolePoint& point = points[at(count++)];
      point.key = Patch::kPoints * static_cast<int>(direction) + i;
      point.position = from.position - 0.5 * from.depth * n;  // of the sole's own surface
      point.normal = n;
      point.depth = from.depth - placed.closing.at(frame.across(from.position));
      point.weight = patch.area / own.moments.area;
    }
  }
  return count;
}

}  // namespace twinbus::sim
