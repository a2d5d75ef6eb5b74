#include "geometry/distance/mesh_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "common/math/index.h"
#include "geometry/distance/mesh_distance_data.h"
#include "common/simd/instruction_set.h"
#include "geometry/bounds/triangle_clusters.h"
#include "common/simd/vec4.h"

namespace twinbus::inline geometry {

// clang-format off
#define TWINBUS_WIDE 0
namespace baseline_mesh {
#include "common/simd/float8.h"
#include "geometry/distance/triangle_sat.h"
#include "geometry/distance/mesh_distance_triangles.h"
#include "geometry/distance/mesh_distance_lanes.h"
}  // namespace baseline_mesh
#undef TWINBUS_WIDE
#ifdef __x86_64__
#define TWINBUS_WIDE 1
#include "common/simd/begin_avx2.h"
namespace avx2_mesh {
#include "common/simd/float8.h"
#include "geometry/distance/triangle_sat.h"
#include "geometry/distance/mesh_distance_triangles.h"
#include "geometry/distance/mesh_distance_lanes.h"
}  // namespace avx2_mesh
#include "common/simd/end_target.h"
#undef TWINBUS_WIDE
#endif
// clang-format on

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kSingle = 5e-7;  // what single precision may hide [m]

std::size_t padded8(std::size_t n) { return (n + 7) / 8 * 8; }

// Nearest points of two segments.
double segments(const Vector3d& p, const Vector3d& p2, const Vector3d& q, const Vector3d& q2,
                Vector3d& on_a, Vector3d& on_b) {
  const Vector3d e = p2 - p, f = q2 - q, w = q - p;
  const double ee = std::max(e.squaredNorm(), 1e-30), ff = std::max(f.squaredNorm(), 1e-30);
  const double ef = e.dot(f), ew = e.dot(w), fw = f.dot(w);
  const double det = std::max(ee * ff - ef * ef, 1e-14 * ee * ff);
  double s = std::clamp((ew * ff - fw * ef) / det, 0.0, 1.0);
  double r = std::clamp((s * ef - fw) / ff, 0.0, 1.0);
  s = std::clamp((r * ef + ew) / ee, 0.0, 1.0);
  r = std::clamp((s * ef - fw) / ff, 0.0, 1.0);
  on_a = p + s * e;
  on_b = q + r * f;
  return (on_a - on_b).squaredNorm();
}

using Triangle = std::array<Vector3d, 3>;

// Is p over the face?  Then its foot.
bool foot(const Vector3d& p, const Triangle& t, Vector3d& on_face) {
  const Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double nn = n.squaredNorm();
  if (!(nn > 1e-30)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (n.cross(t[(k + 1) % 3] - t[k]).dot(p - t[k]) < 0.0) return false;
  }
  on_face = p - n.dot(p - t[0]) / nn * n;
  return true;
}

// Of triangles that do not cross.
double triangles(const Triangle& a, const Triangle& b, Vector3d& on_a, Vector3d& on_b) {
  double best = 1e300;
  Vector3d x = a[0], y = b[0];
  const auto take = [&](double d) {
    if (!(d < best)) return;
    best = d;
    on_a = x;
    on_b = y;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      take(segments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3], x, y));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (foot(x = a[i], b, y)) take((x - y).squaredNorm());
    if (foot(y = b[i], a, x)) take((x - y).squaredNorm());
  }
  return std::sqrt(best);
}

CollisionPose single(const Isometry3d& pose) {
  CollisionPose result{};
  for (int d = 0; d < 3; ++d) {
    for (int k = 0; k < 3; ++k) result.column[k][d] = static_cast<float>(pose.linear()(d, k));
    result.origin[d] = static_cast<float>(pose.translation()[d]);
  }
  return result;
}

Triangle triangle_of(const TriangleCluster& cluster, int i) {
  Triangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t d = 0; d < 3; ++d)
      t[k][static_cast<int>(d)] = static_cast<double>(cluster.corner[k][d][i]);
  }
  return t;
}

}  // namespace

struct ClusteredMesh::Impl {
  std::vector<TriangleCluster> clusters;
  std::vector<float> numbers;
  std::vector<std::array<float, 4>> middle, half;
  MeshView view;
};

ClusteredMesh::ClusteredMesh(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
  Impl& i = *impl_;
  i.clusters = triangle_clusters(mesh);
  const std::size_t count = padded8(i.clusters.size());
  i.numbers.assign(4 * count, 0.0F);
  for (std::size_t d = 0; d < 3; ++d) {
    i.view.low[d] = 1e30F;
    i.view.high[d] = -1e30F;
    i.view.center[d] = i.numbers.data() + d * count;
  }
  i.view.radius = i.numbers.data() + 3 * count;
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t d = 0; d < 3; ++d)
      i.numbers[d * count + c] = c < i.clusters.size() ? i.clusters[c].center[d] : 1e9F;
  }
  for (std::size_t c = 0; c < i.clusters.size(); ++c) {
    const TriangleCluster& cluster = i.clusters[c];
    i.numbers[3 * count + c] = cluster.radius;
    std::array<float, 4> middle{}, half{};
    for (std::size_t d = 0; d < 3; ++d) {
      middle[d] = 0.5F * (cluster.low[d] + cluster.high[d]);
      half[d] = 0.5F * (cluster.high[d] - cluster.low[d]) + 1e-6F;
      i.view.low[d] = std::min(i.view.low[d], cluster.low[d]);
      i.view.high[d] = std::max(i.view.high[d], cluster.high[d]);
    }
    i.middle.push_back(middle);
    i.half.push_back(half);
  }
  i.view.cluster = i.clusters.data();
  i.view.clusters = static_cast<int>(i.clusters.size());
  i.view.middle = reinterpret_cast<const float(*)[4]>(i.middle.data());
  i.view.half = reinterpret_cast<const float(*)[4]>(i.half.data());
}
ClusteredMesh::~ClusteredMesh() = default;

int ClusteredMesh::clusters() const noexcept { return impl_->view.clusters; }

struct MeshDistance::Impl {
  std::vector<float> kept;
  int stride = 0;
  GjkShape one;  // triangle
  bool wide = best_instruction_set() != InstructionSet::kBaseline;
};

MeshDistance::MeshDistance() : impl_(std::make_unique<Impl>()) {
  impl_->one = gjk_hull({Vector3d::Zero()});
}
MeshDistance::~MeshDistance() = default;

void MeshDistance::reserve(const ClusteredMesh& mesh) {
  Impl& i = *impl_;
  i.stride = std::max(i.stride, static_cast<int>(padded8(at(mesh.clusters()))) + 8);
  i.kept.resize(16 * at(i.stride));
}

bool MeshDistance::between(const ClusteredMesh& a, const Isometry3d& pose_a, const ClusteredMesh& b,
                           const Isometry3d& pose_b, double below, double at_least,
                           MeshMemory& memory, MeshGap& gap) noexcept {
  Impl& i = *impl_;
  const Isometry3d a_to_b = pose_b.inverse(Eigen::Isometry) * pose_a;
  MeshTables t;
  t.a = &a.impl_->view;
  t.b = &b.impl_->view;
  t.a_to_b = single(a_to_b);
  t.b_to_a = single(a_to_b.inverse(Eigen::Isometry));
  t.enough = at_least > 0.0 ? static_cast<float>(at_least + kSingle) : 0.0F;
  t.kept = i.kept.data();
  t.stride = i.stride;
  MeshNearest nearest;
  nearest.below = static_cast<float>(below + kSingle);
  nearest.cluster_a = memory.cluster_a;
  nearest.cluster_b = memory.cluster_b;
#ifdef __x86_64__
  if (i.wide) {
    avx2_mesh::search(t, nearest);
  } else {
    baseline_mesh::search(t, nearest);
  }
#else
  baseline_mesh::search(t, nearest);
#endif
  memory = {nearest.cluster_a, nearest.cluster_b};
  if (nearest.cluster_a < 0) return false;
  const Triangle of_a = triangle_of(t.a->cluster[nearest.cluster_a], nearest.triangle_a);
  const Triangle of_b = triangle_of(t.b->cluster[nearest.cluster_b], nearest.triangle_b);
  Triangle of_a_in_b;
  for (std::size_t k = 0; k < 3; ++k) of_a_in_b[k] = a_to_b * of_a[k];
  Vector3d on_a = of_a_in_b[0], on_b = of_b[0];
  gap.distance = triangles(of_a_in_b, of_b, on_a, on_b);
  if (!(nearest.below > 0.0F)) gap.distance = 0.0;
  gap.point_a = pose_b * on_a;
  gap.point_b = pose_b * on_b;
  return gap.distance < below;
}

bool MeshDistance::between(const ClusteredMesh& a, const Isometry3d& pose_a, const GjkShape& b,
                           const Isometry3d& pose_b, double below, MeshMemory& memory,
                           MeshGap& gap) noexcept {
  Impl& i = *impl_;
  const MeshView& mesh = a.impl_->view;
  const Isometry3d a_to_b = pose_b.inverse(Eigen::Isometry) * pose_a;
  const double round = b.kind == ShapeKind::kSphere ? b.half.x() : 0.0;
  // Of the shape: a box around it, in its axes.
  const Vector3d half = b.kind == ShapeKind::kBox || b.kind == ShapeKind::kMesh ? b.half
                        : b.kind == ShapeKind::kSphere
                            ? Vector3d::Constant(round)
                            : Vector3d(b.half.x(), b.half.x(), b.half.y());
  const auto outside = [&](const Vector3d& low, const Vector3d& high) {
    return (low - half).cwiseMax(-half - high).cwiseMax(0.0).norm();
  };
  double best = below;
  bool found = false;
  const auto measure_cluster = [&](int c) {
    const TriangleCluster& cluster = mesh.cluster[c];
    for (int k = 0; k < cluster.count && best > 0.0; ++k) {
      Triangle t = triangle_of(cluster, k);
      for (Vector3d& corner : t) corner = a_to_b * corner;
      if (!(outside(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])) < best))
        continue;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        for (std::size_t d = 0; d < 3; ++d)
          i.one.points[4 * d + corner] = t[std::min<std::size_t>(corner, 2)][static_cast<int>(d)];
      }
      const GjkResult r =
          gjk_distance(i.one, Isometry3d::Identity(), b, Isometry3d::Identity(), best);
      if (!(r.distance < best)) continue;
      best = r.distance;
      found = true;
      memory.cluster_a = c;
      gap.distance = r.distance;
      gap.point_a = pose_b * r.point_a;
      gap.point_b = pose_b * r.point_b;
    }
  };
  const int first = memory.cluster_a;
  memory.cluster_a = -1;
  if (first >= 0) measure_cluster(first);
  for (int c = 0; c < mesh.clusters && best > 0.0; ++c) {
    const TriangleCluster& cluster = mesh.cluster[c];
    const Vector3d center = a_to_b * Vector3d(static_cast<double>(cluster.center[0]),
                                              static_cast<double>(cluster.center[1]),
                                              static_cast<double>(cluster.center[2]));
    const Vector3d reach = Vector3d::Constant(static_cast<double>(cluster.radius));
    if (c == first || !(outside(center - reach, center + reach) < best)) continue;
    measure_cluster(c);
  }
  return found;
}

}  // namespace twinbus::geometry
