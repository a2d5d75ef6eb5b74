// Is a straight line in joint space free?  Eight postures at a time, with the robot as balls.
//
// The rake: the first block spreads 8 postures over the whole line (a coarse look that ends most bad
// lines); each further block is the same set moved back by a fraction of their distance, until the
// postures lie as densely as asked.  What the first block finds far enough away for the rest of the
// line, by how far the balls move between two postures, is not looked at again.
//
// The same answer on every machine: see block_lanes.h.

#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "planner/batch/robot.h"
#include "planner/batch/scene.h"
#include "common/simd/instruction_set.h"

namespace twinbus {

struct BlockWork;  // what a check writes on

class BlockCheck {
 public:
  // robot and scene must outlive this.  set: one that this machine has; all give the same answers.
  BlockCheck(const BlockRobot& robot, const BlockScene& scene,
             InstructionSet set = best_instruction_set());
  ~BlockCheck();
  BlockCheck(const BlockCheck&) = delete;
  BlockCheck& operator=(const BlockCheck&) = delete;

  // Obstacles have changed.
  void set_scene(const BlockScene& scene) noexcept { scene_ = &scene; }

  // Shall pieces settle what hulls leave open?  Slower; needed where an end lies in a hull.
  // pairs: shall hulls settle what the balls of two links leave open, too?  Not said: as before; at first they do not.
  void settle_by_pieces(bool yes, std::optional<bool> pairs = std::nullopt) noexcept;

  // from + t step for t in 0..1, but not t = 0 itself: 8 blocks postures.  from, step: [joints].
  bool line_free(const float* from, const float* step, int blocks) noexcept;
  bool point_free(const float* q) noexcept;
  // Is every posture of the line free, ends included?  No is also said when that cannot be proved in
  // about a thousand pieces.
  bool line_certain(const float* from, const float* step) noexcept;
  // Does what no joint moves touch an obstacle?
  bool world_free() noexcept;

  std::int64_t blocks() const noexcept { return blocks_; }  // looked at so far
  const BlockRobot& robot() const noexcept { return *robot_; }
  const BlockScene& scene() const noexcept { return *scene_; }

 private:
  const BlockRobot* robot_;
  const BlockScene* scene_;
  std::unique_ptr<BlockWork> work_;
  InstructionSet set_;
  std::int64_t blocks_ = 0;
};

// Brings the pairs that touch most often to the front, by random postures.
void sort_pairs(BlockRobot& robot);

}  // namespace twinbus
