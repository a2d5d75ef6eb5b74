// `twinbus bench distance`: near pairs of a robot of meshes, by the hulls of its links and by their
// triangles as the guard asks for them, beside FCL's distances of the same: cost, and every distance
// compared.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/collision/links/link_geometry.h"
#include "robot/collision/hull_distances.h"
#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"
#include "geometry/distance/mesh_distance.h"
#include "common/process/options.h"
#include "test/bench/collision_cases.h"
#include "test/bench/core_alone.h"
#include "test/no_alloc.h"

using namespace twinbus;

namespace {

using MeshModel = fcl::BVHModel<fcl::OBBRSSd>;
constexpr double kNear = 0.05, kSame = 1e-6;  // [m]

struct BothMeshes {
  std::unique_ptr<ClusteredMesh> ours;
  std::shared_ptr<MeshModel> theirs;
  std::shared_ptr<fcl::Convexd> hull;  // null when the link is no single mesh
  int index = 0;
};

std::shared_ptr<fcl::Convexd> fcl_convex(const TriangleMesh& hull) {
  auto points = std::make_shared<std::vector<Eigen::Vector3d>>(hull.points);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& [a, b, c] : hull.triangles) faces->insert(faces->end(), {3, a, b, c});
  return std::make_shared<fcl::Convexd>(points, static_cast<int>(hull.triangles.size()), faces);
}

// Distance of the hulls by FCL, as exactly as it goes; below zero when they overlap.
double hulls_by_fcl(const BothMeshes& a, const Eigen::Isometry3d& pose_a, const BothMeshes& b,
                    const Eigen::Isometry3d& pose_b) {
  fcl::DistanceRequestd request(true);
  request.distance_tolerance = 1e-9;
  fcl::DistanceResultd result;
  fcl::distance(a.hull.get(), pose_a, b.hull.get(), pose_b, request, result);
  return result.min_distance;
}

// Distance of the triangles by FCL; zero when they cross.
double by_fcl(const BothMeshes& a, const Eigen::Isometry3d& pose_a, const BothMeshes& b,
              const Eigen::Isometry3d& pose_b) {
  fcl::CollisionRequestd touch_request;
  fcl::CollisionResultd touch;
  if (fcl::collide(a.theirs.get(), pose_a, b.theirs.get(), pose_b, touch_request, touch) > 0)
    return 0.0;
  fcl::DistanceRequestd request(true);
  fcl::DistanceResultd result;
  fcl::distance(a.theirs.get(), pose_a, b.theirs.get(), pose_b, request, result);
  return result.min_distance;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("distance_bench", "Near pairs of hulls and of meshes beside FCL's distances.");
  std::string robot = "jvrc29", package, drop;
  std::int64_t postures = 400, compared = 60;
  options.text("--robot", "NAME", robot, "as in bench collision");
  options.text("--package", "NAME=FOLDER", package, "what package:// of a .urdf means");
  options.text("--drop", "TEXT", drop, "leave out links with this in their name");
  options.integer("--postures", "N", postures, 20, 1'000'000, "timed, of each kind");
  options.integer("--compared", "N", compared, 0, 1'000'000, "compared with FCL, of each kind");
  options.parse(argc, argv);

  const Model model = load_case(robot, package, drop);
  Collision collision(model);
  HullDistances hull_distances(model);
  MeshDistance distance;
  std::vector<BothMeshes> links;
  std::vector<int> of_link(model.links.size(), -1);
  for (const LinkGeometry& g : build_geometry(model, {.balls = false}).links) {
    BothMeshes link;
    link.ours = std::make_unique<ClusteredMesh>(g.mesh);
    link.theirs = std::make_shared<MeshModel>();
    link.index = g.link;
    const auto& shapes = model.links[at(g.link)].collision;
    if (shapes.size() == 1 && shapes.front().kind == ShapeKind::kMesh)
      link.hull = fcl_convex(g.hull);
    std::vector<fcl::Triangle> triangles;
    for (const auto& [a, b, c] : g.mesh.triangles) triangles.emplace_back(at(a), at(b), at(c));
    link.theirs->beginModel();
    link.theirs->addSubModel(g.mesh.points, triangles);
    link.theirs->endModel();
    distance.reserve(*link.ours);
    of_link[at(g.link)] = static_cast<int>(links.size());
    links.push_back(std::move(link));
  }
  Kinematics kinematics(model);
  test::CoreAlone core;
  bool agree = true;
  // All pairs of hulls at a posture, those within reach and those beyond it.
  const auto compare_hulls = [&](const auto& next) {
    Times ours, theirs;
    long asked = 0, overlap = 0, differ = 0;
    double worst = 0.0;
    PairDistance near[256];
    for (std::int64_t k = 0; k < compared; ++k) {
      kinematics.update(next(k));
      int count = 0;
      time(ours, 1, [&](int) { count = hull_distances.near(kinematics, kNear, near, 256); });
      std::vector<double> expected;
      const auto hulls_of = [&](const CollisionPair& pair) {
        const auto &a = links[at(of_link[at(pair.link_a)])],
                   &b = links[at(of_link[at(pair.link_b)])];
        if (!a.hull || !b.hull) return std::numeric_limits<double>::quiet_NaN();
        return hulls_by_fcl(a, kinematics.link_in_world(pair.link_a), b,
                            kinematics.link_in_world(pair.link_b));
      };
      time(theirs, 1, [&](int) {
        expected.clear();
        for (const CollisionPair& pair : collision.pairs()) expected.push_back(hulls_of(pair));
      });
      for (std::size_t p = 0; p < expected.size(); ++p) {
        const CollisionPair& pair = collision.pairs()[p];
        const auto* const found = std::find_if(near, near + count, [&](const PairDistance& n) {
          return n.link_a == pair.link_a && n.link_b == pair.link_b;
        });
        if (std::isnan(expected[p]) || (found == near + count && expected[p] > kNear)) continue;
        const double error = found == near + count
                                 ? kNear - expected[p]
                                 : std::abs(found->distance - std::max(expected[p], 0.0));
        ++asked;
        overlap += expected[p] > 0.0 ? 0 : 1;
        worst = std::max(worst, error);
        differ += error <= kSame ? 0 : 1;
      }
    }
    if (asked == 0) return;
    std::printf(
        "  %ld distances of hulls, %ld overlapping: near ones %.2f us, FCL's of all pairs %.0f us "
        "(%.0fx); worst difference %.2g m, %ld over 1 um\n",
        asked, overlap, ours.at_share(0.5), theirs.at_share(0.5),
        theirs.at_share(0.5) / ours.at_share(0.5), worst, differ);
    agree = agree && differ == 0;
  };
  for (const char* kind : {"random", "near home", "one motion"}) {
    const std::string name = kind;
    Postures draws(model);
    const Configuration from = draws.draw(false), to = draws.draw(false);
    Configuration now = from;
    const auto next = [&](std::int64_t k) -> const Configuration& {
      if (name != "one motion") return draws.draw(name == "near home");
      const double share = 0.5 - 0.5 * std::cos(0.01 * static_cast<double>(k));
      now.q = from.q + share * (to.q - from.q);
      return now;
    };
    Times tick, of_hulls, of_hulls_alone;
    PairDistance near[256];
    long pairs = 0, hulls = 0, allocations = 0;
    for (Times* t : {&tick, &of_hulls, &of_hulls_alone})
      t->us.reserve(at(static_cast<int>(postures)));
    for (std::int64_t k = 0; k < postures; ++k) {
      const Configuration& c = next(k);
      const NoAlloc no_alloc;
      time(tick, 1, [&](int) {
        kinematics.update(c);
        pairs += collision.near_pairs(kinematics, kNear, near, 256);
      });
      const bool before = core.alone();
      time(of_hulls, 1, [&](int) {
        kinematics.update(c);
        hulls += hull_distances.near(kinematics, kNear, near, 256);
      });
      if (before && core.alone()) of_hulls_alone.us.push_back(of_hulls.us.back());
      allocations += no_alloc.count();
    }
    std::printf(
        "%s, hulls: %.1f pairs under 50 mm: median %.2f us, core alone %.2f us, p99 %.2f us\n",
        kind, static_cast<double>(hulls) / static_cast<double>(postures), of_hulls.at_share(0.5),
        of_hulls_alone.at_share(0.5), of_hulls.at_share(0.99));
    std::printf(
        "%s, shapes of the guard: %.1f pairs under 50 mm: median %.2f us, p99 %.2f us; %ld "
        "allocations\n",
        kind, static_cast<double>(pairs) / static_cast<double>(postures), tick.at_share(0.5),
        tick.at_share(0.99), allocations);
    compare_hulls(next);
    // Every pair whose triangles are that near, asked alone.
    std::vector<MeshMemory> memory(collision.pairs().size());
    Times ours, theirs;
    long asked = 0, touching = 0, differ = 0;
    double worst = 0.0;
    for (std::int64_t k = 0; k < compared; ++k) {
      kinematics.update(next(k));
      for (std::size_t p = 0; p < memory.size(); ++p) {
        const CollisionPair& pair = collision.pairs()[p];
        const BothMeshes& a = links[at(of_link[at(pair.link_a)])];
        const BothMeshes& b = links[at(of_link[at(pair.link_b)])];
        const Eigen::Isometry3d& pose_a = kinematics.link_in_world(pair.link_a);
        const Eigen::Isometry3d& pose_b = kinematics.link_in_world(pair.link_b);
        MeshGap gap;
        bool found = false;
        const auto ask = [&](int) {
          found = distance.between(*a.ours, pose_a, *b.ours, pose_b, kNear, 0.0, memory[p], gap);
        };
        ask(0);
        if (!found) continue;
        time(ours, 1, ask);
        double expected = 0.0;
        time(theirs, 1, [&](int) { expected = by_fcl(a, pose_a, b, pose_b); });
        ++asked;
        touching += expected > 0.0 ? 0 : 1;
        const double error = std::abs(gap.distance - expected);
        worst = std::max(worst, error);
        differ += error <= kSame ? 0 : 1;
      }
    }
    if (asked == 0) continue;
    std::printf(
        "  %ld distances of meshes, %ld touching: ours %.2f us, FCL %.2f us (%.0fx); worst "
        "difference "
        "%.2g m, %ld over 1 um\n",
        asked, touching, ours.at_share(0.5), theirs.at_share(0.5),
        theirs.at_share(0.5) / ours.at_share(0.5), worst, differ);
    agree = agree && differ == 0;
  }
  return agree ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "distance_bench: %s\n", error.what());
  return 1;
}
