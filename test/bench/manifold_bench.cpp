// Contact of two triangle sets, ours and FCL's: points, normals, depth and time of the cases whose
// answer is known (5 mm deep, normal straight up).
//
//     manifold_bench [SECONDS]     each case for so long, both in turn
//
// A line for each case and library: case, library, points, different ones, worst normal [degrees],
// error of the greatest depth [%], us: median and 99th percentile.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "common/time/cpu_time.h"
#include "geometry/mesh_contact/manifold.h"
#include "test/contact_shapes.h"

namespace twinbus {
namespace {

using FclMesh = fcl::BVHModel<fcl::OBBRSSd>;

constexpr double kDepth = 0.005;  // [m]
constexpr double kDegree = std::numbers::pi / 180.0;

struct Found {
  std::vector<ManifoldPoint> points;
};

struct Case {
  std::string name;
  TriangleMesh upper, slab;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // of the upper body
};

std::vector<Case> cases() {
  const auto fine = [](TriangleMesh mesh, int times) {
    for (int i = 0; i < times; ++i) mesh = test::split(mesh);
    return mesh;
  };
  const TriangleMesh cube = test::box_triangles(Eigen::Vector3d::Constant(0.1));
  const TriangleMesh slab = test::box_triangles(Eigen::Vector3d(1.0, 1.0, 0.1));
  std::vector<Case> all(4);
  all[0] = {"cube_12", cube, slab};
  all[1] = {"cube_768", fine(cube, 3), fine(slab, 3)};
  all[2] = {"cube_768_turned", fine(cube, 3), fine(slab, 3)};
  all[2].pose.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  all[3] = {"sphere_3072", test::sphere_triangles(0.05, 4), fine(slab, 3)};
  for (Case& c : all) c.pose.translation() = Eigen::Vector3d(0.0, 0.0, 0.095);
  all[3].pose.translation() = Eigen::Vector3d(0.013, 0.007, 0.095);
  return all;
}

class Ours {
 public:
  explicit Ours(const Case& c) : upper_(c.upper), slab_(c.slab), pose_(c.pose) {
    finder_.reserve(upper_);
    finder_.reserve(slab_);
  }
  void run() {
    (void)finder_.between(upper_, pose_, slab_, Eigen::Isometry3d::Identity(), manifold_);
  }
  Found found() const {
    return {{manifold_.point.begin(), manifold_.point.begin() + manifold_.count}};
  }

 private:
  ContactMesh upper_, slab_;
  Eigen::Isometry3d pose_;
  ManifoldFinder finder_;
  Manifold manifold_;
};

class Fcl {
 public:
  explicit Fcl(const Case& c) : upper_(model(c.upper), c.pose), slab_(model(c.slab)) {
    request_.enable_contact = true;
    request_.num_max_contacts = 100000;
  }
  void run() {
    result_.clear();
    fcl::collide(&upper_, &slab_, request_, result_);
  }
  Found found() const {
    Found found;
    for (std::size_t i = 0; i < result_.numContacts(); ++i) {
      const fcl::Contactd& c = result_.getContact(i);
      // Its normals lead from the first body to the second.
      found.points.push_back({c.pos, -c.normal, std::abs(c.penetration_depth), 0});
    }
    return found;
  }

 private:
  static std::shared_ptr<FclMesh> model(const TriangleMesh& mesh) {
    auto made = std::make_shared<FclMesh>();
    std::vector<fcl::Triangle> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
      triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                             static_cast<std::size_t>(c));
    }
    made->beginModel();
    made->addSubModel(mesh.points, triangles);
    made->endModel();
    return made;
  }

  fcl::CollisionObjectd upper_, slab_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
};

void report(const Case& c, const char* library, const Found& found, std::vector<double>& us) {
  int different = 0;
  double normal = 0.0, depth = 0.0;
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    const ManifoldPoint& p = found.points[i];
    const bool known = std::any_of(
        found.points.begin(), found.points.begin() + static_cast<std::ptrdiff_t>(i),
        [&](const ManifoldPoint& q) { return (p.position - q.position).norm() < 1e-6; });
    different += known ? 0 : 1;
    normal = std::max(normal, std::acos(std::clamp(p.normal.z(), -1.0, 1.0)) / kDegree);
    depth = std::max(depth, p.depth);
  }
  std::sort(us.begin(), us.end());
  std::printf("%s %s points %zu different %d normal_deg %.4f depth_error_percent %.3f us %.3f "
              "p99 %.3f\n",
              c.name.c_str(), library, found.points.size(), different, normal,
              100.0 * std::abs(depth - kDepth) / kDepth, us[us.size() / 2],
              us[us.size() * 99 / 100]);
}

template <typename Library>
void time_batch(Library& library, std::vector<double>& us) {
  constexpr int kBatch = 20;
  const double begun = thread_cpu_seconds();
  for (int i = 0; i < kBatch; ++i) library.run();
  us.push_back(1e6 * (thread_cpu_seconds() - begun) / kBatch);
}

int main_of(double seconds) {
  for (const Case& c : cases()) {
    Ours ours(c);
    Fcl peer(c);
    std::vector<double> own_us, peer_us;
    const double begun = thread_cpu_seconds();
    while (thread_cpu_seconds() - begun < seconds) {
      time_batch(ours, own_us);
      time_batch(peer, peer_us);
    }
    report(c, "twinbus", ours.found(), own_us);
    report(c, "fcl", peer.found(), peer_us);
  }
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int count, char** values) {
  const double seconds = count > 1 ? std::atof(values[1]) : 1.0;
  if (!(seconds > 0.0)) {
    std::fprintf(stderr, "manifold_bench: seconds must be positive\n");
    return 2;
  }
  return twinbus::main_of(seconds);
}
