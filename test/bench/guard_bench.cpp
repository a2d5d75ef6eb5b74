// `twinbus bench guard`: what one tick of the guard costs on hrp1s, and one look at all pairs, beside
// FCL's own ways to ask the same: its dynamic AABB tree manager, and every pair in turn.  A robot with meshes has no FCL beside
// it here (bench collision has).
//
// Ticks of the guard are timed by the processor time of their thread: what others take of the machine does not count.
//
// --gate: exit status 1 when ticks of random motion, postures never met, take more than 60 us in the mean or more than twice
// their median at 99 %, or when a tick allocates.

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "control/guard/guard.h"
#include "robot/collision/collision.h"
#include "common/math/index.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "common/time/cpu_time.h"
#include "common/time/latency_histogram.h"
#include "test/collision/guard_rig.h"
#include "common/allocation/no_alloc.h"

using namespace twinbus;

namespace {

constexpr double kNear = 0.05;  // [m]
constexpr double kMostMean = 60.0, kMostRatio = 2.0;  // asked of random motion [us; of the median]

struct Tick {
  double us;
  GuardWork work;
};
struct Row {
  std::string name;
  std::string metric = "cost";
  RateStats stats;
  const Row* peer = nullptr;
  std::vector<Tick> ticks;  // of the guard
};


Configuration pose(const Model& model, const std::string& name) {
  Configuration c(model);
  const auto& q = model.poses[at(model.find_pose(name))].q;
  for (int j = 0; j < model.joint_count(); ++j) c.q[j] = q[at(j)];
  return c;
}

std::vector<Configuration> postures(const Model& model, bool random_ones) {
  std::mt19937_64 random(1);
  const Configuration home = pose(model, "half_sitting");
  std::vector<Configuration> result;
  for (int i = 0; i < 256; ++i) {
    Configuration c = home;
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[at(j)];
      c.q[j] = random_ones
                   ? std::uniform_real_distribution<double>(joint.lower, joint.upper)(random)
                   : std::clamp(home.q[j] + std::normal_distribution<double>(0.0, 0.15)(random),
                                joint.lower, joint.upper);
    }
    result.push_back(c);
  }
  return result;
}

// The same shapes as fcl::CollisionObjects, one per shape, with the pairs that we check.
class FclPeer {
 public:
  FclPeer(const Model& model, const Collision& collision)
      : model_(model), wanted_(at(model.link_count() * model.link_count()), 0) {
    for (const CollisionPair& pair : collision.pairs()) {
      wanted_[at(pair.link_a * model.link_count() + pair.link_b)] = 1;
      wanted_[at(pair.link_b * model.link_count() + pair.link_a)] = 1;
    }
    for (int link = 0; link < model.link_count(); ++link) {
      for (const Shape& shape : model.links[at(link)].collision) {
        std::shared_ptr<fcl::CollisionGeometryd> geometry;
        if (shape.kind == ShapeKind::kBox) {
          geometry = std::make_shared<fcl::Boxd>(shape.size.x(), shape.size.y(), shape.size.z());
        } else if (shape.kind == ShapeKind::kSphere) {
          geometry = std::make_shared<fcl::Sphered>(shape.size.x());
        } else if (shape.kind == ShapeKind::kCylinder) {
          geometry = std::make_shared<fcl::Cylinderd>(shape.size.x(), shape.size.y());
        } else {
          continue;
        }
        parts_.push_back({link, shape.pose, std::make_unique<fcl::CollisionObjectd>(geometry)});
      }
    }
    for (Part& part : parts_) {
      part.object->setUserData(&part.link);
      manager_.registerObject(part.object.get());
    }
    manager_.setup();
  }

  void place(const Kinematics& kinematics) {
    for (Part& part : parts_) {
      part.object->setTransform(kinematics.link_in_world(part.link) * part.pose);
      part.object->computeAABB();
    }
  }
  int touching_by_manager() {
    manager_.update();
    Count count{this, 0};
    manager_.collide(&count, &FclPeer::touch);
    return count.pairs;
  }
  int touching_one_by_one() {
    int pairs = 0;
    each_pair([&](Part& a, Part& b) {
      fcl::CollisionRequestd request;
      fcl::CollisionResultd result;
      pairs += fcl::collide(a.object.get(), b.object.get(), request, result) > 0 ? 1 : 0;
    });
    return pairs;
  }
  int near_one_by_one() {
    int pairs = 0;
    each_pair([&](Part& a, Part& b) {
      fcl::DistanceRequestd request(true);
      fcl::DistanceResultd result;
      pairs += fcl::distance(a.object.get(), b.object.get(), request, result) <= kNear ? 1 : 0;
    });
    return pairs;
  }

 private:
  struct Part {
    int link;
    Eigen::Isometry3d pose;
    std::unique_ptr<fcl::CollisionObjectd> object;
  };
  struct Count {
    FclPeer* peer;
    int pairs;
  };
  bool wanted(int a, int b) const { return wanted_[at(a * model_.link_count() + b)] != 0; }
  template <class Call>
  void each_pair(Call call) {
    for (std::size_t a = 0; a < parts_.size(); ++a) {
      for (std::size_t b = a + 1; b < parts_.size(); ++b) {
        if (wanted(parts_[a].link, parts_[b].link)) call(parts_[a], parts_[b]);
      }
    }
  }
  static bool touch(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* user) {
    auto& count = *static_cast<Count*>(user);
    if (!count.peer->wanted(*static_cast<int*>(a->getUserData()),
                            *static_cast<int*>(b->getUserData())))
      return false;
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    count.pairs += fcl::collide(a, b, request, result) > 0 ? 1 : 0;
    return false;
  }

  const Model& model_;
  std::vector<char> wanted_;
  std::vector<Part> parts_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

template <class Call>
Row measure(const std::string& name, const Model& model, const std::vector<Configuration>& set,
            std::int64_t calls, Call call) {
  Row row{name, "cost", {}, nullptr, {}};
  Kinematics kinematics(model);
  for (std::int64_t i = -50; i < calls; ++i) {
    const std::int64_t begin = monotonic_ns();
    kinematics.update(set[static_cast<std::size_t>(i + 50) % set.size()]);
    call(kinematics);
    if (i >= 0) row.stats.add(monotonic_ns() - begin);
  }
  return row;
}

template <class Call>
void timed_tick(Row& row, const Guard& guard, std::int64_t tick, long& allocations, Call call) {
  const NoAlloc no_alloc;
  const double begin = thread_cpu_seconds();
  call();
  const double took = thread_cpu_seconds() - begin;
  if (tick > 1) allocations += no_alloc.count();
  row.stats.add(static_cast<std::int64_t>(1e9 * took));
  row.ticks.push_back({1e6 * took, guard.work()});
}

// The guard as a controller sees it.  drive(t, k, q, qd): where joint k of the bus is, and how fast.
template <class Drive>
Row measure_guard(const std::string& name, const Model& model, std::int64_t calls, long& allocations, Drive drive) {
  Row row{name, "cost", {}, nullptr, {}};
  row.ticks.reserve(static_cast<std::size_t>(calls));
  Guard guard(model, {});
  Configuration base = pose(model, "half_sitting");
  RobotState state;
  JointCommand command;
  state.run_id = command.run_id = 1;
  state.joint_count = command.joint_count = static_cast<std::int16_t>(model.bus_count());
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {  // servos as stiff as our controller's
    command.kp[k] = static_cast<float>(model.joints[at(model.bus_joints[k])].kp);
    command.kd[k] = static_cast<float>(model.joints[at(model.bus_joints[k])].kd);
  }
  for (std::int64_t tick = 1; tick <= calls; ++tick) {
    state.tick = command.tick = tick;
    const double t = model.period() * static_cast<double>(tick);
    for (int k = 0; k < model.bus_count(); ++k) {
      double q = 0.0, qd = 0.0;
      drive(t, k, q, qd);
      state.q[at(k)] = q;
      state.qd[at(k)] = static_cast<float>(qd);
      command.q[at(k)] = state.q[at(k)] + 0.004 * static_cast<double>(state.qd[at(k)]);
      command.qd[at(k)] = state.qd[at(k)];
    }
    timed_tick(row, guard, tick, allocations, [&] { guard.check(state, &command, base); });
  }
  return row;
}

// Arms that swing in and out of the body at a servo's pace.
Row measure_swings(const Model& model, std::int64_t calls, long& allocations) {
  const Configuration base = pose(model, "half_sitting");
  return measure_guard("guard tick, arms swinging into the body", model, calls, allocations, [&](double t, int k, double& q, double& qd) {
    const Joint& joint = model.joints[at(model.bus_joints[at(k)])];
    const double swing = joint.name.find("ARM") != std::string::npos ? 0.6 : 0.05, rate = 1.0 + 0.13 * k;
    q = std::clamp(base.q[model.bus_joints[at(k)]] + swing * std::sin(rate * t), joint.lower, joint.upper);
    qd = swing * rate * std::cos(rate * t);
  });
}

// Every joint at its speed limit from one random place to the next: postures that were never met.
class RandomDrive {
 public:
  explicit RandomDrive(const Model& model) : model_(model), now_(pose(model, "half_sitting").q), towards_(now_) {}
  void next(int k, double& q, double& qd) {
    const int j = model_.bus_joints[at(k)];
    const Joint& joint = model_.joints[at(j)];
    const double most = joint.velocity * model_.period(), left = towards_[j] - now_[j];
    if (std::abs(left) <= most) {
      now_[j] = towards_[j];
      towards_[j] = std::uniform_real_distribution<double>(std::max(joint.lower, -M_PI), std::min(joint.upper, M_PI))(random_);
    } else {
      now_[j] += std::copysign(most, left);
    }
    q = now_[j];
    qd = std::copysign(joint.velocity, towards_[j] - now_[j]);
  }

 private:
  const Model& model_;
  std::mt19937_64 random_{1};
  Eigen::VectorXd now_, towards_;
};
// Nobody heeds what the guard says, and links go through one another.
Row measure_drives(const Model& model, std::int64_t calls, long& allocations) {
  RandomDrive drive(model);
  return measure_guard("guard tick, random motion at speed limits", model, calls, allocations,
                       [&](double, int k, double& q, double& qd) { drive.next(k, q, qd); });
}
// Its masks are heeded.
Row measure_guarded_drives(const Model& model, std::int64_t calls, long& allocations) {
  Row row{"  the same, masks heeded", "cost", {}, nullptr, {}};
  row.ticks.reserve(static_cast<std::size_t>(calls));
  RandomDrive drive(model);
  Guard guard(model, {});
  GuardRig rig(model, pose(model, "half_sitting"));
  for (std::int64_t tick = 1; tick <= calls; ++tick) {
    double qd = 0.0;
    for (int k = 0; k < model.bus_count(); ++k) drive.next(k, rig.command.q[at(k)], qd);
    timed_tick(row, guard, tick, allocations, [&] { rig.look(guard); });
    rig.go_on(guard.report());
  }
  return row;
}

// What the slowest ticks did that others did not; whether they are as fast as is asked of random motion.
bool print_work(const Row& row) {
  std::vector<Tick> ticks = row.ticks;
  std::sort(ticks.begin(), ticks.end(), [](const Tick& a, const Tick& b) { return a.us < b.us; });
  const double ratio = ticks[ticks.size() * 99 / 100].us / ticks[ticks.size() / 2].us;
  const double mean = std::accumulate(ticks.begin(), ticks.end(), 0.0, [](double sum, const Tick& t) { return sum + t.us; }) /
                      static_cast<double>(ticks.size());
  std::printf("%s: %.1f us in the mean, %.2f times the median at 99 %%\n", row.name.c_str(), mean, ratio);
  for (const auto& [name, from, to] : {std::tuple("around the median", 0.45, 0.55), std::tuple("around 99 %", 0.985, 0.995)}) {
    double ways = 0.0, open = 0.0, looks = 0.0, stretches = 0.0, count = 0.0;
    for (std::size_t i = static_cast<std::size_t>(from * static_cast<double>(ticks.size()));
         i < static_cast<std::size_t>(to * static_cast<double>(ticks.size())); ++i) {
      const GuardWork& work = ticks[i].work;
      ways += work.ways, open += work.open, looks += work.looks, stretches += work.stretches, count += 1.0;
    }
    std::printf("  %s: %.1f ways, %.1f pairs open on them, %.1f looks, %.1f stretches\n", name, ways / count, open / count,
                looks / count, stretches / count);
  }
  return mean <= kMostMean && ratio <= kMostRatio;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("guard_bench", "Costs of self-collision checking per tick, beside plain FCL.");
  std::string csv, robot = "hrp1s";
  std::int64_t calls = 20000;
  bool gate = false;
  options.text("--robot", "NAME_OR_DIR", robot, "the robot");
  options.integer("--calls", "N", calls, 100, 10'000'000, "per case");
  options.text("--csv", "FILE", csv, "also as rows");
  options.flag("--gate", gate, "exit status 1 when random motion costs more than 60 us a tick, or at 99 % more than twice the median");
  options.parse(argc, argv);

  const Model model = load_robot(robot);
  Collision collision(model);
  FclPeer peer(model, collision);
  std::vector<Row> rows;
  rows.reserve(16);
  long allocations = 0;
  rows.push_back(measure_swings(model, calls, allocations));
  rows.push_back(measure_drives(model, calls, allocations));
  rows.push_back(measure_guarded_drives(model, calls, allocations));
  const bool compares = std::none_of(model.links.begin(), model.links.end(), [](const Link& link) {
    return std::any_of(link.collision.begin(), link.collision.end(), [](const Shape& s) { return s.kind == ShapeKind::kMesh; });
  });
  for (const bool random_ones : {false, true}) {
    const std::string where = random_ones ? ", random" : ", near half_sitting";
    const std::vector<Configuration> set = postures(model, random_ones);
    PairDistance near[64];
    // The verdicts must be the same, or the costs say nothing.
    Kinematics kinematics(model);
    for (const Configuration& c : set) {
      if (!compares) break;
      kinematics.update(c);
      peer.place(kinematics);
      if (collision.in_collision(kinematics) != (peer.touching_one_by_one() > 0))
        std::fprintf(stderr, "guard_bench: a verdict differs from FCL's\n");
    }
    const auto timed = [&](const char* name, std::int64_t count, Row* of, auto call) -> Row& {
      if (of != nullptr && !compares) return *of;
      rows.push_back(measure(name + where, model, set, count, call));
      if (of != nullptr) of->peer = &rows.back();
      return rows.back();
    };
    Row& touching = timed("all pairs: touching?", calls, nullptr, [&](const Kinematics& k) { collision.in_collision(k); });
    timed("  FCL pair by pair", calls / 4, &touching, [&](const Kinematics& k) {
      peer.place(k);
      peer.touching_one_by_one();
    });
    timed("  FCL manager", calls / 4, &touching, [&](const Kinematics& k) {
      peer.place(k);
      peer.touching_by_manager();
    });
    Row& distances = timed("all pairs: distances under 50 mm", calls, nullptr,
                           [&](const Kinematics& k) { collision.near_pairs(k, kNear, near, 64); });
    timed("  FCL distance pair by pair", calls / 20, &distances, [&](const Kinematics& k) {
      peer.place(k);
      peer.near_one_by_one();
    });
  }

  std::printf("%d pairs; %ld allocations in %lld guard ticks%s\n", collision.pair_count(),
              allocations, static_cast<long long>(calls),
              allocations_counted() ? "" : " (not counted in this build)");
  std::printf("%-56s %9s %9s %9s %9s %8s\n", "microseconds, kinematics included", "median", "p99",
              "p99.9", "worst", "peer/us");
  for (const Row& row : rows) {
    std::printf("%-56s %9.2f %9.2f %9.2f %9.2f", row.name.c_str(), 1e-3 * row.stats.median_ns(),
                1e-3 * row.stats.p99_ns(), 1e-3 * row.stats.p999_ns(),
                1e-3 * static_cast<double>(row.stats.max_ns()));
    if (row.peer != nullptr)
      std::printf(" %8.1f", row.peer->stats.median_ns() / row.stats.median_ns());
    std::printf("\n");
  }
  bool short_of = allocations > 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].ticks.empty()) continue;
    const bool fast = print_work(rows[r]), judged = r > 0;  // the first one moves as arms do, between few postures
    if (judged && !fast) short_of = true;
    if (gate && judged) std::printf("  asked: %.0f us, %.1f times: %s\n", kMostMean, kMostRatio, fast ? "holds" : "FALLS SHORT");
  }
  const int status = gate && short_of ? 1 : 0;
  if (csv.empty()) return status;
  std::FILE* file = std::fopen(csv.c_str(), "a");
  if (file == nullptr) throw std::runtime_error(csv + " cannot be written");
  for (const Row& row : rows) {
    std::fprintf(file, "guard,\"%s\",cost,us,%.3f,%.3f,%.3f,%.3f,", row.name.c_str(),
                 1e-3 * row.stats.median_ns(), 1e-3 * row.stats.p99_ns(),
                 1e-3 * row.stats.p999_ns(), 1e-3 * static_cast<double>(row.stats.max_ns()));
    if (row.peer != nullptr) {
      std::fprintf(file, "%s,%.3f,%.3f\n", "FCL", 1e-3 * row.peer->stats.median_ns(),
                   row.stats.median_ns() / row.peer->stats.median_ns());
    } else {
      std::fprintf(file, ",,\n");
    }
  }
  return std::fclose(file) == 0 ? status : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "guard_bench: %s\n", error.what());
  return 1;
}
