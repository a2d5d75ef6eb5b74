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
#include <vector>

#include "planner/batch/robot.h"
#include "planner/batch/scene.h"
#include "common/simd/instruction_set.h"

namespace twinbus::inline planner {

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
  void settle_by_pieces(bool yes) noexcept;
  // On the rake: everything, or only groups and pairs that balls see touching at one of these postures; from
  // then on pieces settle those alone that hulls see touching there.
  void settle_all() noexcept;
  void settle_as_at_first() noexcept;  // all, by hulls and pieces
  void settle_touching(const std::vector<const float*>& postures) noexcept;
  // Shall hulls, and pieces then, settle what the balls of two links leave open, too?
  void settle_pairs(bool yes) noexcept;

  // from + t step for t in 0..1, but not t = 0 itself: 8 blocks postures.  from, step: [joints].
  bool line_free(const float* from, const float* step, int blocks) noexcept;
  bool point_free(const float* q) noexcept;
  // Is every posture of the line free, ends included?  No is also said when that cannot be proved in
  // about a thousand pieces.  slack: how far the robot may be from the posture on the line besides [m].
  bool line_certain(const float* from, const float* step, float slack = 0.0F) noexcept;

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

}  // namespace twinbus::planner
