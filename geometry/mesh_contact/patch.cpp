#include "geometry/mesh_contact/patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <limits>

#include "common/math/index.h"

namespace twinbus::inline geometry {

namespace {

constexpr double kLeastArea = 1e-14;    // [m^2]
constexpr double kLeastSpread = 1e-12;  // [m^2], of a line
constexpr double kTouching = 1e-9;      // [m]
constexpr double kEdgeOn = 1e-6;        // cosine: a face so steep has no area along the normal

Eigen::AlignedBox3d box_in(const PatchFrame& frame, const ContactMesh& mesh,
                           const Eigen::Isometry3d& pose) noexcept {
  Eigen::Matrix3d axes;
  axes << frame.x.transpose(), frame.y.transpose(), frame.normal.transpose();
  const Eigen::Vector3d middle = axes * (pose * mesh.box().center() - frame.origin);
  const Eigen::Vector3d half = (axes * pose.linear()).cwiseAbs() * (0.5 * mesh.box().sizes());
  return {Eigen::Vector3d(middle - half), Eigen::Vector3d(middle + half)};
}

}  // namespace

void PatchPolygon::keep(const LinearField& field) noexcept {
  std::array<double, kMost> value;
  bool cut = false;
  for (int i = 0; i < count; ++i) {
    value[at(i)] = field.at(corner[at(i)]);
    cut = cut || !(value[at(i)] >= 0.0);
  }
  if (!cut) return;  // mostly
  PatchPolygon kept;
  for (int i = 0; i < count; ++i) {
    const int next = i + 1 < count ? i + 1 : 0;
    const Eigen::Vector2d& from = corner[at(i)];
    const Eigen::Vector2d& to = corner[at(next)];
    const double here = value[at(i)], there = value[at(next)];
    if (here >= 0.0) kept.add(from);
    if ((here >= 0.0) != (there >= 0.0)) kept.add(from + here / (here - there) * (to - from));
  }
  count = kept.count;
  std::copy_n(kept.corner.begin(), count, corner.begin());
}

PatchFrame::PatchFrame(const Eigen::Vector3d& at, const Eigen::Vector3d& n) noexcept
    : origin(at), normal(n) {
  Eigen::Index least = 0;
  n.cwiseAbs().minCoeff(&least);
  x = n.cross(Eigen::Vector3d::Unit(least)).normalized();
  y = n.cross(x);
}

PatchMoments moments_of(const PatchPolygon& polygon) noexcept {
  const Eigen::Vector2d& o = polygon.corner[0];
  PatchMoments moments;
  for (int i = 2; i < polygon.count; ++i) {
    const Eigen::Vector2d a = polygon.corner[at(i - 1)] - o, b = polygon.corner[at(i)] - o;
    const double piece = 0.5 * (a.x() * b.y() - a.y() * b.x());
    moments.area += piece;
    moments.first += piece / 3.0 * (a + b);
    // Of a triangle with a corner at the origin: area / 12 (a a' + b b' + (a + b)(a + b)').
    moments.second +=
        piece / 12.0 * (a * a.transpose() + b * b.transpose() + (a + b) * (a + b).transpose());
  }
  if (!(moments.area > 0.0)) return {};
  // About the origin of the frame.
  moments.second += o * moments.first.transpose() + moments.first * o.transpose() +
                    moments.area * o * o.transpose();
  moments.first += moments.area * o;
  return moments;
}

PatchMoments mapped(const PatchMoments& moments, const Eigen::Matrix2d& turn) noexcept {
  const double grown = turn(0, 0) * turn(1, 1) - turn(0, 1) * turn(1, 0);
  return {grown * moments.area, grown * (turn * moments.first),
          grown * (turn * moments.second * turn.transpose())};
}

void PatchSum::add(const PatchMoments& moments, const LinearField& lower, const LinearField& depth,
                   double sign) noexcept {
  const double area = moments.area;
  const Eigen::Vector2d& first = moments.first;
  const Eigen::Matrix2d& second = moments.second;
  if (!(area > 0.0)) return;
  area_ += sign * area;
  first_ += sign * first;
  second_ += sign * second;
  depth_ += sign * (depth.offset * area + depth.slope.dot(first));
  square_ += sign * (depth.offset * (depth.offset * area + 2.0 * depth.slope.dot(first)) +
                     depth.slope.dot(second * depth.slope));
  depth_first_ += sign * (depth.offset * first + second * depth.slope);
  height_ += sign * (lower.offset * area + lower.slope.dot(first));
  height_first_ += sign * (lower.offset * first + second * lower.slope);
}

bool PatchSum::finish(const PatchFrame& frame, Patch& patch) const noexcept {
  if (!(area_ > kLeastArea)) return false;
  const Eigen::Vector2d middle = first_ / area_;
  Eigen::Matrix2d spread = second_ / area_ - middle * middle.transpose();
  spread(0, 0) = std::max(spread(0, 0), 0.0) + kLeastSpread;
  spread(1, 1) = std::max(spread(1, 1), 0.0) + kLeastSpread;
  const double depth = depth_ / area_, height = height_ / area_;
  const Eigen::Vector2d depth_moment = depth_first_ / area_ - depth * middle;
  const Eigen::Vector2d height_moment = height_first_ / area_ - height * middle;
  // Cholesky's root, which changes continuously where principal axes would not.
  const double xx = std::sqrt(spread(0, 0));
  const double xy = spread(0, 1) / xx;
  const double yy = std::sqrt(std::max(spread(1, 1) - xy * xy, kLeastSpread));
  // Slope times root is what the fit adds along each of its two columns.
  const auto along = [&](const Eigen::Vector2d& moment) {
    const double first = moment.x() / xx;
    return Eigen::Vector2d(first, (moment.y() - xy * first) / yy);
  };
  const Eigen::Vector2d depth_along = along(depth_moment), height_along = along(height_moment);
  patch.area = area_;
  patch.volume = depth_;
  patch.rough = std::max(0.0, square_ - area_ * (depth * depth + depth_along.squaredNorm()));
  patch.normal = frame.normal;
  for (int i = 0; i < Patch::kPoints; ++i) {
    const Eigen::Vector2d s(i % 2 == 0 ? -1.0 : 1.0, i / 2 == 0 ? -1.0 : 1.0);
    const Eigen::Vector2d x = middle + Eigen::Vector2d(xx * s.x(), xy * s.x() + yy * s.y());
    PatchPoint& point = patch.point[at(i)];
    point.depth = depth + depth_along.dot(s);
    const double level = height + height_along.dot(s) + 0.5 * point.depth;
    point.position = frame.origin + x.x() * frame.x + x.y() * frame.y + level * frame.normal;
  }
  return true;
}

PatchFinder::PatchFinder() {
  lower_.reserve(kMostFaces);
  upper_.reserve(kMostFaces);
}

void PatchFinder::gather(const ContactMesh& mesh, const Eigen::Isometry3d& pose,
                         const PatchFrame& frame, double side, const Eigen::AlignedBox3d& within,
                         std::vector<Face>& faces) noexcept {
  faces.clear();
  const Eigen::Vector3d direction = side * (pose.linear().transpose() * frame.normal);
  const Eigen::Matrix3d& turn = pose.linear();
  const Eigen::Vector3d shift = pose.translation() - frame.origin;
  for (const ContactFace& face : mesh.faces()) {
    const double cosine = face.normal.dot(direction);
    if (!(cosine > kEdgeOn)) continue;
    Face moved;
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()),
                    high = -low;
    std::array<Eigen::Vector3d, 3> corner;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = turn * mesh.vertices()[at(face.vertex[at(k)])] + shift;
      corner[at(k)] = {frame.x.dot(p), frame.y.dot(p), frame.normal.dot(p)};
      low = low.cwiseMin(corner[at(k)]);
      high = high.cwiseMax(corner[at(k)]);
    }
    if (!(within.min().array() <= high.array() + kTouching).all() ||
        !(low.array() <= within.max().array() + kTouching).all())
      continue;
    if (faces.size() >= kMostFaces) return;
    // Seen against the normal what faces along it is counter-clockwise already.
    for (int k = 0; k < 3; ++k) moved.corner[at(side > 0.0 ? k : 2 - k)] = corner[at(k)].head<2>();
    const Eigen::Vector3d n = turn * face.normal;
    const double up = n.dot(frame.normal);
    moved.height.slope = {-n.dot(frame.x) / up, -n.dot(frame.y) / up};
    moved.height.offset = corner[0].z() - moved.height.slope.dot(corner[0].head<2>());
    moved.low = low.head<2>();
    moved.high = high.head<2>();
    moved.least = low.z();
    moved.largest = high.z();
    faces.push_back(moved);
  }
}

bool PatchFinder::between(const ContactMesh& a, const Eigen::Isometry3d& pose_a,
                          const ContactMesh& b, const Eigen::Isometry3d& pose_b,
                          const Eigen::Vector3d& n, double most, Patch& patch) noexcept {
  const PatchFrame frame(pose_a * a.box().center(), n);
  const Eigen::AlignedBox3d shared =
      box_in(frame, a, pose_a).intersection(box_in(frame, b, pose_b));
  if (shared.isEmpty()) return false;
  gather(a, pose_a, frame, -1.0, shared, lower_);
  gather(b, pose_b, frame, 1.0, shared, upper_);
  PatchSum sum;
  for (const Face& below : lower_) {
    for (const Face& above : upper_) {
      if (!(below.least < above.largest) || !(below.low.array() < above.high.array()).all() ||
          !(above.low.array() < below.high.array()).all()) {
        continue;
      }
      PatchPolygon polygon;
      for (const Eigen::Vector2d& x : below.corner) polygon.add(x);
      for (int k = 0; k < 3 && polygon.count > 2; ++k) {
        const Eigen::Vector2d& from = above.corner[at(k)];
        const Eigen::Vector2d way = above.corner[at((k + 1) % 3)] - from;
        const Eigen::Vector2d left(-way.y(), way.x());
        polygon.keep({-left.dot(from), left});
      }
      const LinearField depth = above.height - below.height;
      if (polygon.count > 2) polygon.keep(depth);
      if (polygon.count > 2) polygon.keep({most - depth.offset, -depth.slope});
      if (polygon.count > 2) sum.add(polygon, below.height, depth);
    }
  }
  return sum.finish(frame, patch);
}

bool PatchFinder::with_ground(const ContactMesh& a, const Eigen::Isometry3d& pose_a,
                              Patch& patch) noexcept {
  Eigen::Vector3d origin = pose_a * a.box().center();
  origin.z() = 0.0;
  const PatchFrame frame(origin, Eigen::Vector3d::UnitZ());
  Eigen::AlignedBox3d below = box_in(frame, a, pose_a);
  if (!(below.min().z() < 0.0)) return false;
  below.max().z() = std::min(below.max().z(), 0.0);
  gather(a, pose_a, frame, -1.0, below, lower_);
  PatchSum sum;
  for (const Face& face : lower_) {
    PatchPolygon polygon;
    for (const Eigen::Vector2d& x : face.corner) polygon.add(x);
    const LinearField depth{-face.height.offset, -face.height.slope};
    polygon.keep(depth);
    if (polygon.count > 2) sum.add(polygon, face.height, depth);
  }
  return sum.finish(frame, patch);
}

Patch ball_patch(double radius, double other_radius, const Eigen::Vector3d& centre, double depth,
                 const Eigen::Vector3d& normal) noexcept {
  Patch patch;
  const double round = 1.0 / (1.0 / radius + 1.0 / other_radius);
  const double cap = std::min(depth, round);
  patch.volume = std::numbers::pi * cap * cap * (round - cap / 3.0);
  patch.area = std::numbers::pi * cap * (2.0 * round - cap);
  const double mean = patch.volume / patch.area;
  // Of the squared depth of the cap that lies above a sphere's own lowest plane, less that of its mean.
  patch.rough =
      std::max(0.0, 2.0 * std::numbers::pi * cap * cap * cap * (round / 3.0 - cap / 12.0) -
                        patch.volume * mean);
  patch.normal = normal;
  for (PatchPoint& point : patch.point) point = {centre - (radius - 0.5 * depth) * normal, mean};
  return patch;
}

}  // namespace twinbus::geometry
