// Many simulated robots of one kind side by side, for learning: each a world behind its adaptor, without gate, controller and bus,
// stepped by as many threads as asked.  States and commands of all worlds lie one behind the other.

#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "python/simulation/simulation.h"
#include "sim/sim_adaptor.h"

namespace twinbus {

// What is looked at of one world; joint arrays are in bus order.
struct WorldRow {
  RobotState state;
  JointCommand command;  // for the next step
  SimTruth truth;
  std::array<std::array<double, 3>, 2> hand{};  // left, right: the hand frame's origin, world [m]; zero without that hand
  std::int64_t steps = 0;                       // ticks since its reset
  bool failed = false;                          // the simulation gave up: it stands still until it is reset
};

class Worlds {
 public:
  // threads: 0: one per processor.  Throws as load() does, std::invalid_argument for a count that cannot be.
  Worlds(const SimulationConfig& config, int count, int threads);
  ~Worlds();
  Worlds(const Worlds&) = delete;
  Worlds& operator=(const Worlds&) = delete;

  const Model& model() const { return *loaded_.model; }
  std::vector<WorldRow>& rows() { return rows_; }
  int threads() const { return static_cast<int>(workers_.size()) + 1; }

  // These worlds begin anew, each with its seed, on the threads.  Throws std::invalid_argument for a world that is not there,
  // std::runtime_error when one does not open.
  void reset(const std::vector<int>& which, const std::vector<std::uint64_t>& seeds);
  // All worlds that have not failed obey their command for so many ticks.  Throws std::invalid_argument naming world and joint of a
  // command that is not finite.
  void step(int ticks);
  // A force on a link of one world for so long from now on; force: world [N], point: in the frame of the link [m].  Throws
  // std::invalid_argument for a world that is not there.
  Status push(int world, int link, const Eigen::Vector3d& force, const Eigen::Vector3d& point, double seconds);

 private:
  void run();
  void all(int jobs);
  void work();
  void do_job(int job);
  void reset_one(int world, std::uint64_t seed);
  void step_one(int world, int ticks);
  void look(int world);

  SimulationConfig config_;
  SceneAndRobot loaded_;
  std::vector<WorldRow> rows_;
  std::vector<std::unique_ptr<SimAdaptor>> sims_;

  // What all() hands out.
  const std::vector<int>* which_ = nullptr;  // null: step
  const std::vector<std::uint64_t>* seeds_ = nullptr;
  int ticks_ = 0, jobs_ = 0;
  std::atomic<int> next_ = 0;
  std::vector<std::exception_ptr> errors_;

  std::mutex mutex_;
  std::condition_variable begin_, end_;
  std::uint64_t round_ = 0;
  int busy_ = 0;
  bool quit_ = false;
  std::vector<std::thread> workers_;
};

}  // namespace twinbus
