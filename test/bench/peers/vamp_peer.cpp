// VAMP's planner on the problems of `bench planner`, one line per problem.
//
//   vamp_peer PROBLEMS ROUNDS    prints: set number plan_us simplify_us cost points, then the path
//
// Built by bench_planner.py against a checkout of VAMP (its headers, nigh, pdqsort and SIMDxorshift),
// outside of this tree, with VAMP's own compiler flags.  Settings are those of VAMP's own evaluation, the longest step of
// a robot as in its table of ranges (TWINBUS_VAMP_RANGE).

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vamp/collision/factory.hh>
#include <vamp/planning/rrtc.hh>
#include <vamp/planning/simplify.hh>
#include <vamp/planning/validate.hh>
#include <vamp/random/halton.hh>
#include <vamp/vector.hh>
#include TWINBUS_VAMP_HEADER
#include <vector>

using Robot = vamp::robots::TWINBUS_VAMP_ROBOT;
constexpr std::size_t kRake = vamp::FloatVectorWidth;
using Input = vamp::collision::Environment<float>;
using Scene = vamp::collision::Environment<vamp::FloatVector<kRake>>;
using Search = vamp::planning::RRTC<Robot, kRake, Robot::resolution>;

struct Problem {
  std::string set;
  int number = 0;
  Robot::ConfigurationArray start{}, goal{};
  Input scene;
};

static std::vector<Problem> read(const char* file) {
  std::ifstream in(file);
  std::vector<Problem> problems;
  std::string line, word;
  while (std::getline(in, line)) {
    std::istringstream s(line);
    if (!(s >> word)) continue;
    if (word == "problem") {
      problems.emplace_back();
      s >> problems.back().set >> problems.back().number;
    } else if (word == "start" || word == "goal") {
      for (float& q : word == "start" ? problems.back().start : problems.back().goal) s >> q;
    } else if (word == "box" || word == "cylinder" || word == "sphere") {
      Problem& p = problems.back();
      float d[3], m[12];
      for (float& v : d) s >> v;
      for (float& v : m) s >> v;
      const auto box = [&](float x, float y, float z) {
        p.scene.cuboids.emplace_back(m[3], m[7], m[11], m[0], m[4], m[8], m[1], m[5], m[9], m[2],
                                     m[6], m[10], x, y, z);
      };
      if (word == "box") box(d[0] / 2, d[1] / 2, d[2] / 2);
      // As VAMP's own loader takes them.
      else if (word == "sphere")
        p.scene.spheres.emplace_back(
            vamp::collision::factory::sphere::flat(m[3], m[7], m[11], d[0]));
      else if (p.set == "box")
        box(d[1], d[1], d[0] / 2);
      else
        p.scene.capsules.emplace_back(vamp::collision::factory::capsule::endpoints::flat(
            m[3] + m[2] * d[0] / 2, m[7] + m[6] * d[0] / 2, m[11] + m[10] * d[0] / 2,
            m[3] - m[2] * d[0] / 2, m[7] - m[6] * d[0] / 2, m[11] - m[10] * d[0] / 2, d[1]));
    }
  }
  for (Problem& p : problems) p.scene.sort();
  return problems;
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::vector<Problem> problems = read(argv[1]);
  const int rounds = std::atoi(argv[2]);
  auto random = std::make_shared<vamp::rng::Halton<Robot>>();
  vamp::planning::RRTCSettings plan;
  plan.range = TWINBUS_VAMP_RANGE;
  vamp::planning::SimplifySettings smooth;
  for (const Problem& p : problems) {
    const Scene scene(p.scene);
    const Robot::Configuration start(p.start), goal(p.goal);
    if (!vamp::planning::validate_motion<Robot, kRake, 1>(start, start, scene) ||
        !vamp::planning::validate_motion<Robot, kRake, 1>(goal, goal, scene)) {
      continue;
    }
    std::vector<double> plan_us, smooth_us;
    vamp::planning::Path<Robot> path;
    float cost = 0;
    for (int round = 0; round < rounds; ++round) {
      random->reset();
      const auto found = Search::solve(start, goal, scene, plan, random);
      if (found.path.empty()) break;
      const auto simple = vamp::planning::simplify<Robot, kRake, Robot::resolution>(
          found.path, scene, smooth, random);
      plan_us.push_back(1e-3 * static_cast<double>(found.nanoseconds));
      smooth_us.push_back(1e-3 * static_cast<double>(simple.nanoseconds));
      path = simple.path;
      cost = path.cost();
    }
    if (plan_us.empty()) {
      std::printf("%s %d 0 0 0 0\n", p.set.c_str(), p.number);
      continue;
    }
    const auto middle = [](std::vector<double>& v) {
      std::sort(v.begin(), v.end());
      return v[v.size() / 2];
    };
    std::printf("%s %d %.3f %.3f %.6f %zu", p.set.c_str(), p.number, middle(plan_us),
                middle(smooth_us), static_cast<double>(cost), path.size());
    for (const auto& q : path) {
      const auto a = q.to_array();
      for (std::size_t j = 0; j < Robot::dimension; ++j)
        std::printf(" %.7g", static_cast<double>(a[j]));
    }
    std::printf("\n");
  }
}
