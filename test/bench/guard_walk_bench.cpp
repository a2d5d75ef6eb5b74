// `twinbus bench guard_walk --states STATE.csv`: what watching all pairs costs while a robot walks, and what the
// list of pairs costs that can touch at all within the ranges its joints keep to.
//
//   ./twinbus run walk_forward --log walk.log; ./twinbus log csv walk.log STATE walk.csv --fields q
//
// The reduced list is what is left when every pair is taken out that is proved, over all postures
// within the ranges seen (and a little beyond), never to touch: robot/pair_proof.  A guard may use it
// as long as the joints are within these ranges, which is one comparison per joint.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "control/guard/guard.h"
#include "robot/collision/links/link_geometry.h"
#include "common/math/index.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "robot/collision/exact/pair_proof.h"
#include "common/process/process.h"
#include "common/time/latency_histogram.h"
#include "robot/collision/exact/self_collision.h"

using namespace twinbus;

namespace {

// The columns q[0], q[1], ... of every row.
std::vector<std::vector<double>> read_rows(const std::string& file, std::size_t joints) {
  std::ifstream in(file);
  std::string line, cell;
  if (!std::getline(in, line)) throw std::runtime_error(file + ": cannot be read");
  std::vector<std::size_t> column;
  std::istringstream head(line);
  for (std::size_t c = 0; std::getline(head, cell, ','); ++c) {
    std::string wanted = "q[";
    wanted += std::to_string(column.size());
    wanted += ']';
    if (cell == wanted) column.push_back(c);
  }
  if (column.size() < joints)
    throw std::runtime_error(file + ": has no q of all joints; make it with --fields q");
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    std::vector<double> cells;
    std::istringstream row(line);
    while (std::getline(row, cell, ',')) cells.push_back(std::strtod(cell.c_str(), nullptr));
    std::vector<double> q;
    for (std::size_t k = 0; k < joints && column[k] < cells.size(); ++k)
      q.push_back(cells[column[k]]);
    if (q.size() == joints) rows.push_back(q);
  }
  return rows;
}

void print(const char* name, const RateStats& stats) {
  std::printf("%-44s %8.2f %8.2f %8.2f\n", name, 1e-3 * stats.median_ns(), 1e-3 * stats.p99_ns(),
              1e-3 * static_cast<double>(stats.max_ns()));
}

RateStats timed(SelfCollision& check, const std::vector<Configuration>& walk, long& hits) {
  RateStats stats;
  hits = 0;
  for (int round = 0; round < 2; ++round) {
    for (const Configuration& c : walk) {
      const std::int64_t begin = monotonic_ns();
      check.place(c.q);
      const int n = check.touching();
      if (round == 0) continue;
      stats.add(monotonic_ns() - begin);
      hits += n;
    }
  }
  return stats;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("guard_walk_bench", "All pairs and the reduced list while walking.");
  std::string file, csv, robot = "hrp1s";
  double beyond = 0.05;
  options.text("--states", "FILE.csv", file,
               "from `twinbus log csv LOG STATE FILE.csv --fields q`");
  options.text("--robot", "NAME_OR_DIR", robot, "that walked");
  options.number("--beyond", "RAD", beyond, 0.0, 1.0, "by which joints may leave the ranges seen");
  options.text("--csv", "FILE.csv", csv, "what every state took, for chart guard");
  options.parse(argc, argv);
  if (file.empty()) {
    std::printf("no states given: see --help\n");
    return 0;
  }

  const Model model = load_robot(robot);
  std::vector<Configuration> walk;
  for (const std::vector<double>& row : read_rows(file, model.bus_joints.size())) {
    Configuration c(model);
    for (std::size_t k = 0; k < row.size(); ++k) c.q[model.bus_joints[k]] = row[k];
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[at(j)];
      if (joint.mimic >= 0) c.q[j] = joint.mimic_multiplier * c.q[joint.mimic] + joint.mimic_offset;
    }
    walk.push_back(c);
  }
  if (walk.empty()) throw std::runtime_error(file + ": has no rows");
  Model within = model;
  for (int j = 0; j < model.joint_count(); ++j) {
    double low = walk.front().q[j], high = low;
    for (const Configuration& c : walk) {
      low = std::min(low, c.q[j]);
      high = std::max(high, c.q[j]);
    }
    within.joints[at(j)].lower = low;
    within.joints[at(j)].upper = high;
  }
  const RobotGeometry geometry = build_geometry(model);
  SelfCollision all(model, geometry);
  std::vector<CollisionPair> left;
  const std::vector<PairVerdict> verdicts =
      judge_pairs(within, geometry, {.samples = 300, .cells = 20000, .beyond_limits = beyond});
  for (const CollisionPair& pair : all.pairs()) {
    const bool never = std::any_of(verdicts.begin(), verdicts.end(), [&](const PairVerdict& v) {
      return v.kind == PairKind::kNever &&
             ((v.pair.link_a == pair.link_a && v.pair.link_b == pair.link_b) ||
              (v.pair.link_a == pair.link_b && v.pair.link_b == pair.link_a));
    });
    if (!never) left.push_back(pair);
  }
  SelfCollision few(model, geometry, left);
  long hits = 0, hits_few = 0;
  const RateStats cost = timed(all, walk, hits), cost_few = timed(few, walk, hits_few);
  RateStats placing, guard_tick;
  for (const Configuration& c : walk) {
    const std::int64_t begin = monotonic_ns();
    few.place(c.q);
    placing.add(monotonic_ns() - begin);
  }
  std::FILE* out = csv.empty() ? nullptr : std::fopen(csv.c_str(), "w");
  if (!csv.empty() && out == nullptr) throw std::runtime_error(csv + " cannot be written");
  if (out != nullptr) std::fprintf(out, "tick,all_us,reduced_us,guard_us\n");
  Guard guard(model, {});
  RobotState state;
  state.run_id = 1;
  state.joint_count = static_cast<std::int16_t>(model.bus_count());
  for (const Configuration& c : walk) {
    ++state.tick;
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      const double q = c.q[model.bus_joints[k]];
      if (state.tick > 1) state.qd[k] = static_cast<float>((q - state.q[k]) / model.period());
      state.q[k] = q;
    }
    double us[3] = {};
    const auto once = [&](int row, auto call) {
      const std::int64_t begin = monotonic_ns();
      call();
      const std::int64_t took = monotonic_ns() - begin;
      us[row] = 1e-3 * static_cast<double>(took);
      return took;
    };
    once(0, [&] {
      all.place(c.q);
      all.touching();
    });
    once(1, [&] {
      few.place(c.q);
      few.touching();
    });
    guard_tick.add(once(2, [&] { guard.check(state, nullptr, c); }));
    if (out != nullptr)
      std::fprintf(out, "%lld,%.3f,%.3f,%.3f\n", static_cast<long long>(state.tick), us[0],
                   us[1], us[2]);
  }
  if (out != nullptr) std::fclose(out);
  std::printf(
      "%s, %zu states of walking: %zu pairs, %zu of them can touch within %.2f rad of what "
      "the joints did; %ld and %ld contacts\n",
      robot.c_str(), walk.size(), all.pairs().size(), left.size(), beyond, hits, hits_few);
  std::printf("%-44s %8s %8s %8s\n", "microseconds, kinematics included", "median", "p99", "worst");
  print("exact verdict, all pairs", cost);
  print("exact verdict, reduced list", cost_few);
  print("  of it kinematics", placing);
  print("guard tick: distances and look-ahead", guard_tick);
  return hits == 0 && hits_few == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "guard_walk_bench: %s\n", error.what());
  return 1;
}
