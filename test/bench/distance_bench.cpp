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
#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"
#include "geometry/distance/mesh_distance.h"
#include "common/process/options.h"
#include "test/bench/collision_cases.h"
#include "common/allocation/no_alloc.h"

using namespace twinbus;

namespace {

using MeshModel = fcl::BVHModel<fcl::OBBRSSd>;
constexpr double kNear = 0.05, kSame = 1e-6;  // [m]

struct BothMeshes {
  std::unique_ptr<ClusteredMesh> ours;
  std::shared_ptr<MeshModel> theirs;
  int index = 0;
};

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
  Options options("distance_bench", "Near pairs of meshes beside FCL's distances.");
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
  MeshDistance distance;
  std::vector<BothMeshes> links;
  std::vector<int> of_link(model.links.size(), -1);
  for (const LinkGeometry& g : build_geometry(model).links) {
    BothMeshes link;
    link.ours = std::make_unique<ClusteredMesh>(g.mesh);
    link.theirs = std::make_shared<MeshModel>();
    link.index = g.link;
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
  bool agree = true;
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
    Times tick;
    PairDistance near[256];
    long pairs = 0, allocations = 0;
    tick.us.reserve(at(static_cast<int>(postures)));
    for (std::int64_t k = 0; k < postures; ++k) {
      const Configuration& c = next(k);
      const NoAlloc no_alloc;
      time(tick, 1, [&](int) {
        kinematics.update(c);
        pairs += collision.near_pairs(kinematics, kNear, near, 256);
      });
      allocations += no_alloc.count();
    }
    std::printf(
        "%s, shapes of the guard: %.1f pairs under 50 mm: median %.2f us, p99 %.2f us; %ld "
        "allocations\n",
        kind, static_cast<double>(pairs) / static_cast<double>(postures), tick.at_share(0.5),
        tick.at_share(0.99), allocations);
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
