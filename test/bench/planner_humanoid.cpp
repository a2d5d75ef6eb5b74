// JVRC-1 among shelves: arm and waist, and both arms, every path proved against shelves and body.
//
//   planner_humanoid ROBOTS QUESTIONS ROUNDS
//
// Starts and goals are random postures that are proved free.  Prints per case: questions, solved, median and 99th
// percentile of the time [us], a hash of all paths (same seed, same hash), and how many pairs of links
// were left out because their balls touch already when all joints are zero.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "planner/search/certain_path.h"
#include "test/oracles/sphere_cover.h"
#include "common/math/splitmix64.h"
#include "robot/collision/collision_pairs.h"
#include "common/math/index.h"
#include "robot/description/load.h"
#include "test/oracles/sort_pairs.h"

namespace twinbus {
namespace {

std::vector<Obstacle> shelves() {
  std::vector<Obstacle> boards;
  const auto board = [&](double x, double y, double z, double sx, double sy, double sz) {
    Obstacle o;
    o.shape = ObstacleShape::kBox;
    o.size = Eigen::Vector3d(sx, sy, sz);
    o.pose.translation() = Eigen::Vector3d(x, y, z);
    boards.push_back(o);
  };
  for (const double z : {-0.15, 0.2, 0.55}) board(0.6, 0.0, z, 0.35, 1.4, 0.03);
  for (const double y : {-0.7, 0.0, 0.7}) board(0.6, y, 0.2, 0.35, 0.03, 0.7);
  return boards;
}

std::uint64_t hash_of(std::uint64_t hash, const SearchPath& path) {
  for (const SearchPoint& q : path) {
    for (const float x : q) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &x, sizeof bits);
      hash = (hash ^ bits) * 1099511628211ULL;
    }
  }
  return hash;
}

void measure(const Model& model, const char* name, const std::vector<std::string>& joints,
             int questions, int rounds) {
  std::vector<int> planned;
  for (const std::string& joint : joints) {
    const int index = model.find_joint(joint);
    if (index < 0) throw std::runtime_error("no joint " + joint);
    planned.push_back(index);
  }
  std::vector<BallGroup> groups;
  std::vector<int> group_of(at(model.link_count()), -1);
  for (const LinkGeometry& link : build_geometry(model).links) {
    group_of[at(link.link)] = static_cast<int>(groups.size());
    groups.push_back(group_from(link));
    groups.back().balls = cover_with_balls(link.mesh, link.hull);
  }
  std::vector<std::pair<int, int>> pairs;
  int left_out = 0;
  const BlockScene nothing;
  for (const CollisionPair& pair : pairs_to_check(model)) {
    const std::pair<int, int> both{group_of[at(pair.link_a)], group_of[at(pair.link_b)]};
    const BlockRobot alone =
        compile_robot(model, Configuration(model), planned, groups, {both}, 1e-5);
    BlockCheck check(alone, nothing);
    const SearchPoint zero{};
    if (check.point_free(zero.data()))
      pairs.push_back(both);
    else
      ++left_out;
  }
  BlockRobot robot = compile_robot(model, Configuration(model), planned, groups, pairs, 1e-5);
  sort_pairs(robot);
  const BlockScene scene(shelves());
  BlockCheck check(robot, scene);
  JointSearch search({.lower = robot.lower, .upper = robot.upper});
  SplitMix64 random(1);
  const auto draw = [&] {
    SearchPoint q{};
    do {
      for (std::size_t j = 0; j < at(robot.joints); ++j)
        q[j] = robot.lower[j] +
               (robot.upper[j] - robot.lower[j]) * static_cast<float>(random.uniform());
    } while (!check.point_free(q.data()) || !certain_at(check, q));
    return q;
  };
  std::vector<double> us;
  std::uint64_t hash = 14695981039346656037ULL;
  int solved = 0;
  bool same = true;
  for (int i = 0; i < questions; ++i) {
    const SearchPoint start = draw(), goal = draw();
    std::vector<double> times;
    SearchPath first;
    for (int round = 0; round < rounds; ++round) {
      const auto t0 = std::chrono::steady_clock::now();
      const CertainPath found = find_certain(search, check, 32.0F, start, {goal});
      times.push_back(
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - t0).count());
      if (round == 0) {
        first = found.certain ? found.path : SearchPath{};
        solved += first.empty() ? 0 : 1;
        hash = hash_of(hash, first);
      }
      same = same && (first.empty() || found.path == first);
    }
    std::sort(times.begin(), times.end());
    us.push_back(times[times.size() / 2]);
  }
  std::sort(us.begin(), us.end());
  std::printf(
      "%s joints %d pairs %zu left_out %d asked %d solved %d median_us %.1f p99_us %.1f "
      "worst_us %.1f same %d hash %016llx\n",
      name, robot.joints, robot.pairs.size(), left_out, questions, solved, us[us.size() / 2],
      us[us.size() * 99 / 100], us.back(), same ? 1 : 0, static_cast<unsigned long long>(hash));
}

int run(const std::string& robots, int questions, int rounds) {
  const std::string folder = robots + "/jvrc1";
  const Model model = load_urdf(folder + "/jvrc1.urdf", {{"jvrc1", folder}}, true);
  std::vector<std::string> right, both;
  for (const char* joint :
       {"SHOULDER_P", "SHOULDER_R", "SHOULDER_Y", "ELBOW_P", "ELBOW_Y", "WRIST_R", "WRIST_Y"}) {
    right.push_back(std::string("R_") + joint);
    both.push_back(std::string("R_") + joint);
  }
  for (int j = 0; j < 7; ++j) both.push_back("L_" + both[at(j)].substr(2));
  right.insert(right.begin(), {"WAIST_Y", "WAIST_P", "WAIST_R"});
  measure(model, "arm_and_waist", right, questions, rounds);
  measure(model, "both_arms", both, questions, rounds);
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) try {
  if (argc != 4) return 2;
  return twinbus::run(argv[1], std::atoi(argv[2]), std::atoi(argv[3]));
} catch (const std::exception& error) {
  std::fprintf(stderr, "planner_humanoid: %s\n", error.what());
  return 1;
}
