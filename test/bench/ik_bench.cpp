// `ik_bench`: inverse kinematics on random targets that arms and legs can reach, and on some that they cannot.

#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "robot/onboarding/anatomy.h"
#include "robot/kinematics/inverse_kinematics.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "common/math/pose_math.h"
#include "common/process/process.h"
#include "common/time/latency_histogram.h"

using namespace twinbus;

namespace {

struct Chain {
  std::string name;
  int base = 0, link = -1;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
};

std::vector<Chain> chains(const Model& model) {
  std::vector<Chain> all;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string name = side == 0 ? "left" : "right";
    const Sole& sole = model.soles[side];
    const Hand& hand = model.hands[side];
    if (sole.link > 0) all.push_back({name + " leg", 0, sole.link, sole.frame});
    if (hand.link > 0 && !hand.joints.empty()) {
      all.push_back({name + " arm",
                     model.joints[static_cast<std::size_t>(hand.joints.front())].parent, hand.link,
                     hand.frame});
    }
  }
  return all;
}

Eigen::VectorXd start(const Model& model) {
  const int pose = model.find_pose("half_sitting");
  if (pose < 0) return neutral_posture(model);
  const auto& q = model.poses[static_cast<std::size_t>(pose)].q;
  return Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
}

bool bench(const Model& model, const Chain& chain, std::int64_t count, std::FILE* csv) {
  InverseKinematics ik(model, chain.base, chain.link, chain.frame);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Eigen::VectorXd rest = start(model);
  Eigen::VectorXd q = rest;
  RateStats time;
  std::int64_t solved = 0;
  double reach = 0.0;  // of the targets, from the base link [m]
  const IkOptions options{.position_tolerance = 1e-8, .rotation_tolerance = 1e-8, .restarts = 100};
  const auto target_of = [&] {
    q = rest;
    for (const int j : ik.joints()) {
      const Joint& joint = model.joints[static_cast<std::size_t>(j)];
      const double low = std::max(joint.lower, -3.14159), high = std::min(joint.upper, 3.14159);
      q[j] = low + unit(random) * (high - low);
    }
    return ik.pose(q);
  };
  for (std::int64_t i = 0; i < count; ++i) {
    const Eigen::Isometry3d target = target_of();
    reach = std::max(reach, target.translation().norm());
    q = rest;
    const std::int64_t begin = monotonic_ns();
    const IkResult result = ik.solve(target, options, q);
    time.add(monotonic_ns() - begin);
    const bool there = (ik.pose(q).translation() - target.translation()).norm() <= 1e-8;
    solved += result.reached && there ? 1 : 0;
  }
  std::int64_t wrong = 0;
  constexpr int kFar = 100;
  for (int i = 0; i < kFar; ++i) {
    Eigen::Isometry3d target = target_of();
    target.translation() *= 1.5 * reach / std::max(1e-3, target.translation().norm());
    q = rest;
    const IkResult result = ik.solve(target, {.restarts = 5}, q);
    // It must say so, and by how much: at least what lies beyond the reach.
    wrong += result.reached || !(result.position_error >= 0.4 * reach) ? 1 : 0;
  }
  const double share = 100.0 * static_cast<double>(solved) / static_cast<double>(count);
  std::printf("%-10s %-10s %9.4f %9.1f %9.1f %9.1f %9.1f   %s\n", model.name.c_str(),
              chain.name.c_str(), share, 1e-3 * time.median_ns(), 1e-3 * time.p99_ns(),
              1e-3 * time.p999_ns(), 1e-3 * static_cast<double>(time.max_ns()),
              wrong == 0 ? "all said" : "NOT ALL SAID");
  if (csv != nullptr) {
    std::fprintf(csv, "ik,%s %s,solved,%%,%.4f,,,,,,\n", model.name.c_str(), chain.name.c_str(),
                 share);
    std::fprintf(csv, "ik,%s %s,cost,us,%.3f,%.3f,%.3f,%.3f,,,\n", model.name.c_str(),
                 chain.name.c_str(), 1e-3 * time.median_ns(), 1e-3 * time.p99_ns(),
                 1e-3 * time.p999_ns(), 1e-3 * static_cast<double>(time.max_ns()));
  }
  return share >= 99.9 && wrong == 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("ik_bench",
                  "Inverse kinematics on random reachable targets, of every arm and leg.");
  std::string csv_name;
  std::vector<std::string> robots;
  std::int64_t count = 100000;
  options.integer("--targets", "N", count, 100, 100'000'000, "per arm and leg");
  options.text("--csv", "FILE", csv_name, "also as rows");
  options.rest("ROBOT", robots, "default: hrp1s hrp2p biped12");
  options.parse(argc, argv);
  if (robots.empty()) robots = {"hrp1s", "hrp2p", "biped12"};
  std::FILE* csv = csv_name.empty() ? nullptr : std::fopen(csv_name.c_str(), "a");
  std::printf("%-10s %-10s %9s %9s %9s %9s %9s   %s\n", "robot", "chain", "solved %", "median us",
              "p99", "p99.9", "worst", "unreachable");
  bool good = true;
  for (const std::string& robot : robots) {
    const Model model = load_robot(robot);
    for (const Chain& chain : chains(model)) good = bench(model, chain, count, csv) && good;
  }
  if (csv != nullptr) std::fclose(csv);
  return good ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "ik_bench: %s\n", error.what());
  return 1;
}
