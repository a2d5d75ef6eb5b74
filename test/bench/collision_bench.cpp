// `twinbus bench collision`: the exact self-collision check beside FCL on the same triangles, in one run:
// cost per posture, and every verdict compared.
//
// Ours includes kinematics; FCL's times are its pair loop alone.  Near contact: a line between a
// posture that touches and one that does not is halved down to where the verdict changes, and left
// by up to a tenth of a millimetre's worth.

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "common/file/disk_cache.h"
#include "robot/collision/links/link_geometry.h"
#include "common/math/index.h"
#include "robot/collision/links/inscribed_spheres.h"
#include "robot/collision/exact/posture_cells_cache.h"
#include "robot/kinematics/kinematics.h"
#include "common/process/options.h"
#include "robot/collision/exact/pair_proof.h"
#include "common/process/process.h"
#include "robot/collision/exact/self_collision.h"
#include "test/bench/collision_cases.h"
#include "test/bench/core_alone.h"
#include "common/allocation/no_alloc.h"

using namespace twinbus;

namespace {

using MeshModel = fcl::BVHModel<fcl::OBBRSSd>;
constexpr double kBand = 1e-6;  // verdicts this near to touching may differ [m]

class FclPeer {
 public:
  FclPeer(const RobotGeometry& geometry, const std::vector<CollisionPair>& pairs)
      : pairs_(pairs), of_link_(geometry.of_link), wanted_(pairs.size()) {
    for (const LinkGeometry& g : geometry.links) {
      auto mesh = std::make_shared<MeshModel>();
      std::vector<fcl::Triangle> triangles;
      for (const auto& [a, b, c] : g.mesh.triangles) triangles.emplace_back(at(a), at(b), at(c));
      mesh->beginModel();
      mesh->addSubModel(g.mesh.points, triangles);
      mesh->endModel();
      links_.push_back(g.link);
      objects_.push_back(std::make_unique<fcl::CollisionObjectd>(mesh));
    }
    for (auto& object : objects_) manager_.registerObject(object.get());
    manager_.setup();
    const std::size_t n = objects_.size();
    wanted_.assign(n * n, 0);
    for (const CollisionPair& pair : pairs) {
      const auto a = at(of_link_[at(pair.link_a)]), b = at(of_link_[at(pair.link_b)]);
      wanted_[a * n + b] = wanted_[b * n + a] = 1;
    }
    for (std::size_t i = 0; i < n; ++i) objects_[i]->setUserData(&links_[i]);
  }
  void place(const Kinematics& kinematics) {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      objects_[i]->setTransform(kinematics.link_in_world(links_[i]));
      objects_[i]->computeAABB();
    }
  }
  bool touches(std::size_t pair, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    fcl::CollisionObjectd& a = object(pairs_[pair].link_a);
    fcl::CollisionObjectd& b = object(pairs_[pair].link_b);
    Eigen::Isometry3d pose = a.getTransform();
    pose.pretranslate(shift);
    return fcl::collide(a.collisionGeometry().get(), pose, b.collisionGeometry().get(),
                        b.getTransform(), request, result) > 0;
  }
  int pair_loop() {
    int count = 0;
    for (std::size_t p = 0; p < pairs_.size(); ++p) count += touches(p) ? 1 : 0;
    return count;
  }
  int by_manager() {
    manager_.update();
    Count count{this, 0};
    manager_.collide(&count, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* user) {
      auto& c = *static_cast<Count*>(user);
      const auto of = [&](fcl::CollisionObjectd* o) {
        return at(c.peer->of_link_[at(*static_cast<int*>(o->getUserData()))]);
      };
      if (c.peer->wanted_[of(a) * c.peer->objects_.size() + of(b)] == 0) return false;
      fcl::CollisionRequestd request;
      fcl::CollisionResultd result;
      c.pairs += fcl::collide(a, b, request, result) > 0 ? 1 : 0;
      return false;
    });
    return count.pairs;
  }
  // Would a shift of a micrometre change the verdict?
  bool in_band(std::size_t pair, bool ours) {
    for (int i = 0; i < 26; ++i) {
      const int k = i < 13 ? i : i + 1;
      const Eigen::Vector3d way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      if (touches(pair, kBand * way.normalized()) == ours) return true;
    }
    return false;
  }

 private:
  struct Count {
    FclPeer* peer;
    int pairs;
  };
  fcl::CollisionObjectd& object(int link) { return *objects_[at(of_link_[at(link)])]; }

  std::vector<CollisionPair> pairs_;
  std::vector<int> of_link_, links_;
  std::vector<char> wanted_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

void print(const char* name, Times& times, double ours, std::FILE* csv, const char* where) {
  const double median = times.at_share(0.5);
  std::printf("  %-34s %9.2f %9.2f", name, median, times.at_share(0.99));
  if (ours > 0.0) std::printf("   %6.1fx", median / ours);
  std::printf("\n");
  if (csv != nullptr)
    std::fprintf(csv, "collision,\"%s %s\",cost,us,%.3f,%.3f,,,,,\n", name, where, median,
                 times.at_share(0.99));
}

void costs(const Model& model, SelfCollision& check, FclPeer& fcl, int count, bool near_home,
           std::FILE* csv) {
  constexpr int kBatch = 20, kBlock = 200;
  Postures postures(model);
  Kinematics kinematics(model);
  std::vector<float> bounds(check.pairs().size() + 8);
  test::CoreAlone core;
  Times single, alone, all, first, placing, bound, loop, manager;
  long allocations = 0, hits = 0, colliding = 0;
  SelfCollision::Work work;
  for (Times* t : {&single, &alone, &all, &first, &placing, &bound})
    t->us.reserve(at(count) + kBlock);
  // Blocks, so that both see the machine in the same state and neither empties the other's caches.
  for (int done = 0; done < count; done += kBlock) {
    std::vector<Configuration> set;
    for (int k = 0; k < kBlock; ++k) set.push_back(postures.draw(near_home));
    const auto q = [&](int k) -> const Eigen::VectorXd& { return set[at(k)].q; };
    for (int k = 0; k < kBatch; ++k) {  // warm
      check.place(q(k));
      check.touching();
    }
    const SelfCollision::Work before = check.work();
    const NoAlloc no_alloc;
    for (int from = 0; from < kBlock; from += kBatch) {
      time(all, kBatch, [&](int k) {
        check.place(q(from + k));
        const int n = check.touching();
        hits += n;
        colliding += n > 0 ? 1 : 0;
      });
    }
    const SelfCollision::Work after = check.work();
    work.spheres += after.spheres - before.spheres;
    work.capsules += after.capsules - before.capsules;
    work.clusters += after.clusters - before.clusters;
    work.rows += after.rows - before.rows;
    for (int k = 0; k < kBlock; ++k) {
      const bool before_it = core.alone();
      time(single, 1, [&](int) {
        check.place(q(k));
        check.touching();
      });
      if (before_it && core.alone()) alone.us.push_back(single.us.back());
    }
    for (int from = 0; from < kBlock; from += kBatch) {
      time(placing, kBatch, [&](int k) { check.place(q(from + k)); });
      time(first, kBatch, [&](int k) {
        check.place(q(from + k));
        check.any_touching();
      });
      time(bound, kBatch, [&](int k) {
        check.place(q(from + k));
        check.lower_bounds(bounds.data());
      });
    }
    allocations += no_alloc.count();
    for (int k = 0; k < kBlock; k += 4) {
      kinematics.update(set[at(k)]);
      fcl.place(kinematics);
      time(loop, 1, [&](int) { fcl.pair_loop(); });
    }
    for (int k = 0; k < kBlock; k += 4) {
      kinematics.update(set[at(k)]);
      fcl.place(kinematics);
      time(manager, 1, [&](int) { fcl.by_manager(); });
    }
  }
  const char* where = near_home ? "near home" : "random";
  const double tests = count;
  std::printf("%s: %d postures, %.2f pairs touch, %.0f %% of postures; %ld allocations\n", where,
              count, static_cast<double>(hits) / count,
              100.0 * static_cast<double>(colliding) / count, allocations);
  std::printf("  core alone in %.0f %% of postures\n",
              100.0 * static_cast<double>(alone.us.size()) / static_cast<double>(single.us.size()));
  std::printf("  %.1f sphere, %.1f capsule, %.0f cluster pairs, %.0f triangle rows\n",
              static_cast<double>(work.spheres) / tests, static_cast<double>(work.capsules) / tests,
              static_cast<double>(work.clusters) / tests, static_cast<double>(work.rows) / tests);
  const double ours = single.at_share(0.5);  // FCL's are of each posture too
  print("exact, all pairs (each posture)", single, 0.0, csv, where);
  print("the same, core alone", alone, 0.0, csv, where);
  print("exact, all pairs (batches of 20)", all, 0.0, csv, where);
  print("exact, until the first hit", first, 0.0, csv, where);
  print("kinematics and placing alone", placing, 0.0, csv, where);
  print("lower bounds of all pairs", bound, 0.0, csv, where);
  print("FCL pair loop", loop, ours, csv, where);
  print("FCL AABB tree manager", manager, ours, csv, where);
}

class Verdicts {
 public:
  Verdicts(const Model& model, const RobotGeometry& geometry, SelfCollision& check, FclPeer& fcl)
      : check_(check),
        fcl_(fcl),
        geometry_(geometry),
        kinematics_(model),
        ours_(check.pairs().size()) {}
  void compare(const Configuration& c) {
    check_.place(c.q);
    std::fill(ours_.begin(), ours_.end(), 0);
    const int n = check_.touching();
    for (int k = 0; k < n; ++k) ours_[at(check_.hit()[k])] = 1;
    kinematics_.update(c);
    fcl_.place(kinematics_);
    for (std::size_t p = 0; p < ours_.size(); ++p) {
      const bool theirs = fcl_.touches(p);
      ++tests;
      hits += theirs ? 1 : 0;
      if (theirs == (ours_[p] != 0)) continue;
      if (!theirs && !crosses(p)) {
        ++inside;
        inside_by_winding += winds_around(check_.pairs()[p]) ? 1 : 0;
      } else if (fcl_.in_band(p, ours_[p] != 0)) {
        ++band;
      } else {
        ++(theirs ? missed : extra);
      }
    }
    ++postures;
  }
  void print(const char* name) const {
    std::printf(
        "%s: %ld postures, %ld pair verdicts, %ld hits of FCL: %ld missed, %ld extra; %ld differ "
        "within a micrometre, %ld inside without crossing (%ld by winding number)\n",
        name, postures, tests, hits, missed, extra, band, inside, inside_by_winding);
  }
  bool clean() const { return missed + extra == 0 && inside == inside_by_winding; }

 private:
  // Ours by surfaces alone?  FCL knows no inside.
  bool crosses(std::size_t pair) { return check_.surfaces_cross(static_cast<int>(pair)); }

  // Are all corners of one link inside the other, by the solid angle of its triangles?
  bool winds_around(const CollisionPair& pair) const {
    const LinkGeometry& a = geometry_.links[at(geometry_.of_link[at(pair.link_a)])];
    const LinkGeometry& b = geometry_.links[at(geometry_.of_link[at(pair.link_b)])];
    const Eigen::Isometry3d a_to_b =
        kinematics_.link_in_world(pair.link_b).inverse() * kinematics_.link_in_world(pair.link_a);
    const auto within = [](const TriangleMesh& inner, const TriangleMesh& outer,
                           const Eigen::Isometry3d& to_outer) {
      for (const Eigen::Vector3d& point : inner.points) {
        if (!(std::abs(winding_number(outer, to_outer * point)) > 0.5)) return false;
      }
      return true;
    };
    return within(a.mesh, b.mesh, a_to_b) || within(b.mesh, a.mesh, a_to_b.inverse());
  }

  SelfCollision& check_;
  FclPeer& fcl_;
  const RobotGeometry& geometry_;
  Kinematics kinematics_;
  std::vector<char> ours_;
  long postures = 0, tests = 0, hits = 0, missed = 0, extra = 0, band = 0, inside = 0,
       inside_by_winding = 0;
};

// A posture at which some pair nearly touches or hardly touches.
Configuration near_contact(const Model& model, SelfCollision& check, Postures& postures) {
  const auto touching = [&](const Configuration& c) {
    check.place(c.q);
    return check.touching();
  };
  Configuration from(model), to(model);
  int a = 0, b = 0;
  do {
    from = postures.draw(false);
    to = postures.draw(postures.uniform() < 0.5);
    a = touching(from);
    b = touching(to);
  } while (a == b);
  double low = 0.0, high = 1.0;
  Configuration middle = from;
  while (high - low > 1e-7) {
    const double share = 0.5 * (low + high);
    middle.q = from.q + share * (to.q - from.q);
    (touching(middle) == a ? low : high) = share;
  }
  const double away = (postures.uniform() - 0.5) * std::pow(10.0, -3.0 - 4.0 * postures.uniform());
  middle.q = from.q + (low + away) * (to.q - from.q);
  return middle;
}

void use_cells(const Model& model, const RobotGeometry& geometry, SelfCollision& check) {
  const std::int64_t begin = monotonic_ns();
  const bool kept = use_kept_cells(model, geometry, check);
  if (!kept) find_and_keep_cells(model, geometry, check);
  const double seconds = 1e-9 * static_cast<double>(monotonic_ns() - begin);
  std::printf("joint cells of the pairs with few joints between them %s in %.3f s\n",
              kept ? "read" : "found", seconds);
}

// Pairs proved never to touch, looked for at random postures.
bool never_is_never(const Model& model, const RobotGeometry& geometry, std::int64_t samples) {
  const std::int64_t begin = monotonic_ns();
  std::vector<CollisionPair> never;
  int left = 0, seen = 0;
  for (const PairVerdict& v : judge_pairs(model, geometry)) {
    if (v.kind == PairKind::kNever) never.push_back(v.pair);
    left += v.kind == PairKind::kNever || v.kind == PairKind::kNeighbours ? 0 : 1;
    seen += v.kind == PairKind::kTouches || v.kind == PairKind::kAlwaysSeen ? 1 : 0;
  }
  const double seconds = 1e-9 * static_cast<double>(monotonic_ns() - begin);
  long touching = 0;
  if (!never.empty()) {
    SelfCollision check(model, geometry, never);
    Postures postures(model);
    for (std::int64_t k = 0; k < samples; ++k) {
      check.place(postures.draw(false).q);
      touching += check.any_touching() ? 1 : 0;
    }
  }
  std::printf(
      "pairs: %zu proved never to touch in %.1f s, %d remain; 10000 samples would have kept %d. "
      "%ld of %lld random postures touch a proved pair\n",
      never.size(), seconds, left, seen, touching, static_cast<long long>(samples));
  return touching == 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("collision_bench", "Exact self-collision beside FCL on the same triangles.");
  std::string robot = "jvrc29", package, drop, csv_file;
  bool no_cells = false;
  std::int64_t postures = 4000, verdicts = 2000, never = 100'000, seed = 1;
  options.text(
      "--robot", "NAME", robot,
      "jvrc29 (JVRC-1 without its distal finger links), a robot's name or folder, or a .urdf");
  options.text("--package", "NAME=FOLDER", package, "what package:// of a .urdf means");
  options.text("--drop", "TEXT", drop, "leave out links with this in their name");
  options.integer("--postures", "N", postures, 20, 10'000'000, "timed, of each kind");
  options.integer("--verdicts", "N", verdicts, 0, 100'000'000,
                  "compared with FCL, random and near contact each");
  options.integer("--seed", "N", seed, 0, 1'000'000'000, "of the postures compared");
  options.integer("--never", "N", never, 0, 1'000'000'000,
                  "random postures at which proved pairs are looked for");
  options.flag("--no-cells", no_cells,
               "without lists of what pairs with few joints between them can touch with");
  options.text("--csv", "FILE", csv_file, "also as rows");
  options.parse(argc, argv);
  use_user_cache();

  const Model model = load_case(robot, package, drop);
  const std::int64_t begin = monotonic_ns();
  const RobotGeometry geometry = build_geometry(model);
  const double load_ms = 1e-6 * static_cast<double>(monotonic_ns() - begin);
  SelfCollision check(model, geometry);
  FclPeer fcl(geometry, check.pairs());
  std::size_t triangles = 0, clusters = 0;
  for (const LinkGeometry& g : geometry.links) {
    triangles += g.mesh.triangles.size();
    clusters += g.clusters.size();
  }
  std::printf(
      "%s: %zu links with geometry, %zu pairs, %zu triangles, %zu clusters, %d joints; geometry "
      "%.0f ms\n",
      robot.c_str(), geometry.links.size(), check.pairs().size(), triangles, clusters,
      model.joint_count(), load_ms);
  if (!no_cells) use_cells(model, geometry, check);
  std::FILE* csv = csv_file.empty() ? nullptr : std::fopen(csv_file.c_str(), "a");
  if (!csv_file.empty() && csv == nullptr)
    throw std::runtime_error(csv_file + " cannot be written");
  std::printf("  %-34s %9s %9s   ratio\n", "microseconds per posture", "median", "p99");
  costs(model, check, fcl, static_cast<int>(postures + 199) / 200 * 200, false, csv);
  costs(model, check, fcl, static_cast<int>(postures + 199) / 200 * 200, true, csv);
  if (csv != nullptr) std::fclose(csv);

  Verdicts random(model, geometry, check, fcl), near(model, geometry, check, fcl);
  Postures draws(model, static_cast<std::uint64_t>(seed));
  for (std::int64_t k = 0; k < verdicts; ++k) random.compare(draws.draw(k % 2 != 0));
  for (std::int64_t k = 0; k < verdicts; ++k) near.compare(near_contact(model, check, draws));
  random.print("random and near home");
  near.print("near contact");
  const bool proved = never_is_never(model, geometry, never);
  return random.clean() && near.clean() && proved ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "collision_bench: %s\n", error.what());
  return 1;
}
