// Simulators whose worlds go together in the lanes of a vector.

#include <array>
#include <stdexcept>

#include "robot/description/parallel_joints.h"
#include "sim/sim_adaptor_impl.h"

namespace twinbus::inline sim {

static_assert(SimAdaptor::kMostTogether == kWorldLanes);

void SimAdaptor::share_lanes(const std::vector<SimAdaptor*>& sims) {
  std::vector<const Model*> models;
  for (const SimAdaptor* sim : sims) {
    const Impl& s = *sim->impl_;
    const std::string why = s.own_world == nullptr ? "a simulator that is not open" : LaneWorlds::why_not(s.settings.world);
    if (!why.empty()) throw std::runtime_error("lanes: " + why);
    if (!parallel_joints_of(*s.model).empty()) throw std::runtime_error("lanes: joints share motors");
    models.push_back(s.model);
  }
  std::vector<std::unique_ptr<World>> worlds;
  for (const SimAdaptor* sim : sims) worlds.push_back(std::move(sim->impl_->own_world));
  const auto lanes = std::make_shared<LaneWorlds>(models, std::move(worlds));
  for (std::size_t k = 0; k < sims.size(); ++k) {
    Impl& s = *sims[k]->impl_;
    s.lanes = lanes;
    s.lane = static_cast<int>(k);
    s.world = &lanes->world(s.lane);
  }
}

void SimAdaptor::advance_together(const std::vector<SimAdaptor*>& sims) noexcept {
  if (sims.empty()) return;
  Impl& first = *sims.front()->impl_;
  const auto next = [](const Impl& s) { return s.lanes && s.writes > 0 && !s.first_read && !s.ahead; };
  int asked = 0;
  std::array<Impl*, kWorldLanes> at_lane{};
  for (const SimAdaptor* sim : sims) {
    Impl& s = *sim->impl_;
    if (!next(s) || s.lanes != first.lanes) continue;
    asked |= 1 << s.lane;
    at_lane[static_cast<std::size_t>(s.lane)] = &s;
    s.drive_servos();
    s.ahead = true;
    s.ahead_status = Status::kOk;
  }
  std::array<Status, kWorldLanes> status;
  for (int i = 0; i < first.substeps && asked != 0; ++i) {
    for (Impl* s : at_lane) {
      if (s != nullptr) s->begin_step();
    }
    first.lanes->step(asked, status);
    for (Impl*& s : at_lane) {
      if (s == nullptr) continue;
      s->ahead_status = status[static_cast<std::size_t>(s->lane)];
      if (s->ahead_status == Status::kOk) {
        s->watch->stepped(*s->world, s->step * static_cast<double>(s->steps + 1));
        s->end_step();
      } else {
        asked &= ~(1 << s->lane);
        s = nullptr;
      }
    }
  }
  for (Impl* s : at_lane) {
    if (s != nullptr) s->relax_corner_offsets();
  }
}

}  // namespace twinbus::sim
