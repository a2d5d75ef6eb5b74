#include "geometry/bounds/bounds.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/math/index.h"

namespace twinbus::inline geometry {

namespace {

using Eigen::Vector3d;

constexpr int kClimb = 500;  // steps from each principal axis
constexpr int kInward = 100;  // steps away from the nearest face

Vector3d mean_of(const std::vector<Vector3d>& points) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

double volume(const Capsule& c) {
  return std::numbers::pi * c.radius * c.radius * ((c.b - c.a).norm() + 4.0 / 3.0 * c.radius);
}

// The shortest capsule about the line through c along d (unit) that holds all points.
Capsule about_line(const std::vector<Vector3d>& points, const Vector3d& c, const Vector3d& d) {
  double widest = 0.0;
  for (const Vector3d& p : points) {
    const double t = (p - c).dot(d);
    widest = std::max(widest, (p - c).squaredNorm() - t * t);
  }
  double low = 1e300, high = -1e300;
  for (const Vector3d& p : points) {
    const double t = (p - c).dot(d);
    const double h = std::sqrt(std::max(0.0, widest - ((p - c).squaredNorm() - t * t)));
    low = std::min(low, t + h);
    high = std::max(high, t - h);
  }
  Capsule result;
  result.radius = std::sqrt(widest);
  if (high < low) {  // one ball at the middle suffices
    low = high = 0.5 * (low + high);
    result.radius = 0.0;
    for (const Vector3d& p : points)
      result.radius = std::max(result.radius, (p - (c + low * d)).norm());
  }
  result.a = c + low * d;
  result.b = c + high * d;
  return result;
}

}  // namespace

Ball ball_around(const std::vector<Vector3d>& points, int steps) {
  Ball ball;
  ball.center = mean_of(points);
  const auto farthest = [&](double& distance2) {
    std::size_t best = 0;
    distance2 = -1.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = (points[i] - ball.center).squaredNorm();
      if (d > distance2) {
        distance2 = d;
        best = i;
      }
    }
    return best;
  };
  double distance2 = 0.0;
  Vector3d best = ball.center;
  double least = 1e300;
  for (int i = 0; i < steps; ++i) {
    const std::size_t far = farthest(distance2);
    if (distance2 < least) {
      least = distance2;
      best = ball.center;
    }
    ball.center += (points[far] - ball.center) / (i + 2.0);
  }
  ball.center = best;
  farthest(distance2);
  ball.radius = std::sqrt(distance2);
  return ball;
}

Capsule capsule_around(const std::vector<Vector3d>& points) {
  const Vector3d mean = mean_of(points);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto shake = [&]() -> Vector3d {
    const double x = normal(random), y = normal(random);
    return {x, y, normal(random)};
  };
  Capsule best;
  double least = 1e300;
  for (int k = 0; k < 3; ++k) {
    Vector3d c = mean;
    Vector3d d = axes.eigenvectors().col(k);
    Capsule current = about_line(points, c, d);
    double size = volume(current);
    double step = 0.3;
    for (int i = 0; i < kClimb; ++i) {
      const Vector3d c2 = c + 0.1 * step * shake();
      const Vector3d d2 = (d + step * shake()).normalized();
      const Capsule tried = about_line(points, c2, d2);
      if (volume(tried) < size) {
        current = tried;
        size = volume(tried);
        c = c2;
        d = d2;
      } else {
        step = std::max(1e-3, 0.99 * step);
      }
    }
    if (size < least) {
      least = size;
      best = current;
    }
  }
  return best;
}

// From the middle of the corners away from the nearest face, by ever smaller steps.
Ball ball_inside(const TriangleMesh& hull) {
  Ball best{mean_of(hull.points), 0.0};
  std::vector<Eigen::Vector4d> faces;  // normal, distance from the origin
  double step = 0.0;
  for (const Vector3d& p : hull.points) step = std::max(step, (p - best.center).norm());
  for (const auto& [a, b, c] : hull.triangles) {
    const Vector3d& p = hull.points[at(a)];
    const Vector3d n = (hull.points[at(b)] - p).cross(hull.points[at(c)] - p).stableNormalized();
    faces.emplace_back(n.x(), n.y(), n.z(), n.dot(p));
  }
  Vector3d center = best.center;
  for (int i = 0; i < kInward && !faces.empty(); ++i, step *= 0.93) {
    const Eigen::Vector4d* nearest = nullptr;
    double inside = 1e300;
    for (const Eigen::Vector4d& face : faces) {
      const double depth = face.w() - face.head<3>().dot(center);
      if (depth < inside) inside = depth, nearest = &face;
    }
    if (inside > best.radius) best = {center, inside};
    center -= step * nearest->head<3>();
  }
  return best;
}

}  // namespace twinbus::geometry
