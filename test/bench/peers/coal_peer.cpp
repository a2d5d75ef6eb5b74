// Coal on the same triangles and postures as our exact check, taking turns in one run.
//
// A program of its own: Coal brings its own octomap, which does not go into one process with FCL's.
// Where `pip install coal` has put it: `cmake --build --preset release --target coal_bench`, then
// `./twinbus bench coal`.

#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "robot/collision/links/link_geometry.h"
#include "common/math/index.h"
#include "common/process/options.h"
#include "robot/collision/exact/self_collision.h"
#include "test/bench/collision_cases.h"

using namespace twinbus;

namespace {

using MeshModel = coal::BVHModel<coal::OBBRSS>;

class CoalPeer {
 public:
  CoalPeer(const RobotGeometry& geometry, const std::vector<CollisionPair>& pairs)
      : pairs_(pairs), of_link_(geometry.of_link), poses_(geometry.links.size()) {
    for (const LinkGeometry& g : geometry.links) {
      auto mesh = std::make_shared<MeshModel>();
      std::vector<coal::Vec3s> points(g.mesh.points.begin(), g.mesh.points.end());
      std::vector<coal::Triangle> triangles;
      for (const auto& [a, b, c] : g.mesh.triangles)
        triangles.emplace_back(static_cast<unsigned>(a), static_cast<unsigned>(b),
                               static_cast<unsigned>(c));
      mesh->beginModel();
      mesh->addSubModel(points, triangles);
      mesh->endModel();
      meshes_.push_back(mesh);
      links_.push_back(g.link);
    }
  }
  void place(const Kinematics& kinematics) {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Eigen::Isometry3d& pose = kinematics.link_in_world(links_[i]);
      poses_[i].setTransform(pose.linear(), pose.translation());
    }
  }
  int pair_loop() const {
    int count = 0;
    for (const CollisionPair& pair : pairs_) {
      const auto a = at(of_link_[at(pair.link_a)]), b = at(of_link_[at(pair.link_b)]);
      coal::CollisionRequest request;
      coal::CollisionResult result;
      coal::collide(meshes_[a].get(), poses_[a], meshes_[b].get(), poses_[b], request, result);
      count += result.isCollision() ? 1 : 0;
    }
    return count;
  }

 private:
  std::vector<CollisionPair> pairs_;
  std::vector<int> of_link_, links_;
  std::vector<coal::Transform3s> poses_;
  std::vector<std::shared_ptr<MeshModel>> meshes_;
};

}  // namespace

int main(int argc, char** argv) try {
  Options options("coal_bench", "Exact self-collision beside Coal on the same triangles.");
  std::string robot = "jvrc29", package, drop;
  std::int64_t postures = 2000;
  options.text("--robot", "NAME", robot, "as in collision_bench");
  options.text("--package", "NAME=FOLDER", package, "what package:// of a .urdf means");
  options.text("--drop", "TEXT", drop, "leave out links with this in their name");
  options.integer("--postures", "N", postures, 20, 10'000'000, "timed, of each kind");
  options.parse(argc, argv);

  const Model model = load_case(robot, package, drop);
  const RobotGeometry geometry = build_geometry(model);
  SelfCollision check(model, geometry);
  check.use(find_joint_cells(model, geometry, check.pairs()));
  CoalPeer coal(geometry, check.pairs());
  Kinematics kinematics(model);
  for (const bool near_home : {false, true}) {
    Postures draws(model);
    Times ours, theirs;
    long our_hits = 0, their_hits = 0;
    for (std::int64_t done = 0; done < postures; done += 200) {
      std::vector<Configuration> set;
      for (int k = 0; k < 200; ++k) set.push_back(draws.draw(near_home));
      for (const Configuration& c : set) {
        time(ours, 1, [&](int) {
          check.place(c.q);
          our_hits += check.touching();
        });
      }
      for (const Configuration& c : set) {
        kinematics.update(c);
        coal.place(kinematics);
        time(theirs, 1, [&](int) { their_hits += coal.pair_loop(); });
      }
    }
    std::printf(
        "%s: ours %.2f us (p99 %.2f), Coal's pair loop %.2f us (p99 %.2f): %.1fx; %ld and %ld "
        "hits\n",
        near_home ? "near home" : "random", ours.at_share(0.5), ours.at_share(0.99),
        theirs.at_share(0.5), theirs.at_share(0.99), theirs.at_share(0.5) / ours.at_share(0.5),
        our_hits, their_hits);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "coal_bench: %s\n", error.what());
  return 1;
}
