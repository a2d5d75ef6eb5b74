#include "python/simulation/worlds.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sim/scene/scene_seed.h"
#include "sim/world/world.h"

namespace twinbus {

namespace {

constexpr int kMostWorlds = 100'000;
constexpr int kMostThreads = 1024;

}  // namespace

Worlds::Worlds(const SimulationConfig& config, int count, int threads) : config_(config), loaded_(load(config)) {
  if (count < 1 || count > kMostWorlds) throw std::invalid_argument("worlds: 1 to " + std::to_string(kMostWorlds));
  if (threads < 0 || threads > kMostThreads) throw std::invalid_argument("threads: 0 to " + std::to_string(kMostThreads));
  rows_.resize(static_cast<std::size_t>(count));
  sims_.resize(rows_.size());
  const int used = std::min(count, threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  for (int i = 1; i < used; ++i) workers_.emplace_back([this] { run(); });
  std::vector<int> every(rows_.size());
  std::vector<std::uint64_t> seeds(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    every[i] = static_cast<int>(i);
    seeds[i] = config.seed + i;
  }
  reset(every, seeds);
}

Worlds::~Worlds() {
  {
    const std::scoped_lock lock(mutex_);
    quit_ = true;
  }
  begin_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void Worlds::reset(const std::vector<int>& which, const std::vector<std::uint64_t>& seeds) {
  if (which.size() != seeds.size()) throw std::invalid_argument("reset: a seed for each world");
  std::vector<bool> named(rows_.size());
  for (const int world : which) {
    if (world < 0 || static_cast<std::size_t>(world) >= rows_.size() || named[static_cast<std::size_t>(world)])
      throw std::invalid_argument("reset: no world " + std::to_string(world) + ", or named twice");
    named[static_cast<std::size_t>(world)] = true;
  }
  which_ = &which;
  seeds_ = &seeds;
  all(static_cast<int>(which.size()));
}

void Worlds::step(int ticks) {
  if (ticks < 1) throw std::invalid_argument("step: at least one tick");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].failed) continue;
    try {
      check_command(*loaded_.model, rows_[i].command);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("world " + std::to_string(i) + ": " + error.what());
    }
  }
  which_ = nullptr;
  ticks_ = ticks;
  all(static_cast<int>(rows_.size()));
}

Status Worlds::push(int world, int link, const Eigen::Vector3d& force, const Eigen::Vector3d& point, double seconds) {
  if (world < 0 || static_cast<std::size_t>(world) >= rows_.size())
    throw std::invalid_argument("push: no world " + std::to_string(world));
  return sims_[static_cast<std::size_t>(world)]->push(link, force, point, seconds);
}

// Every worker takes the next job until there is none; so does this thread.
void Worlds::all(int jobs) {
  errors_.assign(static_cast<std::size_t>(jobs), nullptr);
  next_ = 0;
  {
    const std::scoped_lock lock(mutex_);
    jobs_ = jobs;
    busy_ = static_cast<int>(workers_.size());
    ++round_;
  }
  begin_.notify_all();
  work();
  {
    std::unique_lock lock(mutex_);
    end_.wait(lock, [this] { return busy_ == 0; });
  }
  for (const std::exception_ptr& error : errors_) {
    if (error) std::rethrow_exception(error);
  }
}

void Worlds::run() {
  std::uint64_t seen = 0;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      begin_.wait(lock, [&] { return quit_ || round_ != seen; });
      if (quit_) return;
      seen = round_;
    }
    work();
    {
      const std::scoped_lock lock(mutex_);
      --busy_;
    }
    end_.notify_one();
  }
}

void Worlds::work() {
  for (int job = next_++; job < jobs_; job = next_++) do_job(job);
}

void Worlds::do_job(int job) {
  const auto at = static_cast<std::size_t>(job);
  try {
    if (which_ != nullptr) {
      reset_one((*which_)[at], (*seeds_)[at]);
    } else {
      step_one(job, ticks_);
    }
  } catch (...) {
    errors_[at] = std::current_exception();
  }
}

void Worlds::reset_one(int world, std::uint64_t seed) {
  const auto at = static_cast<std::size_t>(world);
  Scene scene = loaded_.scene;
  apply_seed(scene, *loaded_.model, seed);
  AdaptorConfig adaptor{config_.settings};
  const auto is_seed = [](const auto& setting) { return setting.first == "sensor.seed"; };
  if (std::none_of(adaptor.settings.begin(), adaptor.settings.end(), is_seed))
    adaptor.settings.emplace_back("sensor.seed", std::to_string(seed));
  rows_[at] = WorldRow{};
  rows_[at].failed = true;
  sims_[at] = std::make_unique<SimAdaptor>(scene);
  if (sims_[at]->open(*loaded_.model, adaptor) != Status::kOk) throw std::runtime_error("the simulator does not open");
  if (sims_[at]->read(rows_[at].state, 0.0) != Status::kOk) throw std::runtime_error("the simulator does not start");
  rows_[at].failed = false;
  look(world);
  hold_posture(*loaded_.model, rows_[at].state, rows_[at].command);
}

void Worlds::step_one(int world, int ticks) {
  const auto at = static_cast<std::size_t>(world);
  WorldRow& row = rows_[at];
  row.command.joint_count = static_cast<std::int16_t>(loaded_.model->bus_count());
  for (int i = 0; i < ticks && !row.failed; ++i) {
    row.failed = sims_[at]->write(row.command) != Status::kOk || sims_[at]->read(row.state, 0.0) != Status::kOk;
    ++row.steps;
  }
  look(world);
}

// What is not in a state.
void Worlds::look(int world) {
  const auto at = static_cast<std::size_t>(world);
  const Model& model = *loaded_.model;
  WorldRow& row = rows_[at];
  row.state.tick = row.steps;
  row.state.period_ns = model.period_ns;
  row.state.time_ns = row.steps * model.period_ns;
  row.state.joint_count = static_cast<std::int16_t>(model.bus_count());
  row.truth = *sims_[at]->truth();
  row.truth.tick = row.steps;
  for (std::size_t side = 0; side < model.hands.size(); ++side) {
    const Hand& hand = model.hands[side];
    if (hand.link < 0) continue;
    const Eigen::Vector3d place = sims_[at]->world()->link_in_world(hand.link) * hand.frame.translation();
    row.hand[side] = {place.x(), place.y(), place.z()};
  }
}

}  // namespace twinbus
