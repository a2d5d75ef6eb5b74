// Up to four worlds of robots alike, stepped together on one core: each in a lane of a vector (sim/lanes/lane_block.h).
//
// In the lanes soles stand on level ground and joints may be at their limits; a world in which something else happens (a sole slides or
// nothing is on the ground, a shell or a loose body comes near the robot) takes that step as it would alone in engine articulated, and comes
// back.  Which steps these are is the world's own affair: it gives the same bits beside any neighbours, and beside none.  They are not those
// of engine articulated by itself, whose sums are in another order.

#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "sim/engine/articulated_world.h"
#include "sim/lanes/lane_block.h"
#include "sim/world/forwarding_world.h"

namespace twinbus::inline sim {

class LaneWorlds {
 public:
  // Why a world cannot go in lanes; empty: it can.
  static std::string why_not(const WorldConfig& config);

  // Goes on with worlds as they are; their models must outlive this.  Throws std::runtime_error for what cannot go in lanes and robots
  // that are not alike.
  LaneWorlds(const std::vector<const Model*>& models, std::vector<std::unique_ptr<World>> worlds);
  ~LaneWorlds();
  LaneWorlds(const LaneWorlds&) = delete;
  LaneWorlds& operator=(const LaneWorlds&) = delete;

  int count() const noexcept { return static_cast<int>(lanes_.size()); }
  // Its step() is that of a world alone; step() below steps several.
  World& world(int lane) noexcept;
  // Of the worlds whose bits are set; status: of each.
  void step(int asked, std::array<Status, kWorldLanes>& status) noexcept;

  long steps() const noexcept { return steps_; }        // of single worlds
  long in_lanes() const noexcept { return in_lanes_; }  // so many of them

 private:
  class Lane;
  void fill_lane(int lane, const Model& model);
  void enter(Lane& lane) noexcept;
  void leave(const Lane& lane) noexcept;
  void show_body(const Lane& lane) noexcept;
  void show_contacts(const Lane& lane) noexcept;
  void push(const Lane& lane) noexcept;
  void place() noexcept;

  std::size_t rank(int link) const noexcept { return at(rank_[at(link)]); }
  JointLanes& joint(std::size_t number) noexcept { return block_.joints[rank(static_cast<int>(number) + 1) - 1]; }

  LaneBlock block_{};
  std::vector<int> rank_;  // of each link
  std::vector<std::unique_ptr<Lane>> lanes_;
  bool placed_ = false;  // the links of the block
  long steps_ = 0, in_lanes_ = 0;
};

}  // namespace twinbus::sim
