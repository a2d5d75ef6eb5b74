// The rake along a line.  Included once per instruction set, inside a namespace,
// by check.cpp: no #pragma once.

// Stride 5/8 of the blocks or a little more, that has no factor in common with them: it visits every
// offset once and far ones early.
inline int stride_of(int blocks) {
  int stride = (blocks * 5 + 4) / 8;
  while (std::gcd(stride, blocks) != 1) ++stride;
  return stride % blocks;
}

// The first look, at postures over the whole line; what is near is listed when the line goes on.
inline bool first_block_free(const BlockRobot& robot, const BlockScene& scene, BlockWork& w,
                             const float* from, const float* step, bool goes_on) {
  w.near_count = w.near_ball_count = w.near_pair_count = w.near_group_count = w.last_body = 0;
  float steps = 0.0F;
  if (goes_on) {
    find_swings(robot, w, step);
    for (int j = 0; j < robot.joints; ++j) steps += __builtin_fabsf(step[j]);
  }
  for (int g = static_cast<int>(robot.groups.size()) - 1; g >= robot.fixed_groups; --g) {
    place_group(robot, w, g);
    w.reach[g] = all(robot.groups[static_cast<std::size_t>(g)].around.radius);
    if (goes_on) w.reach[g] += gap_of(w, g, steps, w.turn[g]);
    if (!group_free(robot, scene, w, g, goes_on)) return false;
  }
  bool listed[kBlockGroups] = {};
  const int pairs = static_cast<int>(robot.pairs.size());
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = robot.pairs[static_cast<std::size_t>(i)];
    const Lanes sum = w.reach[a] + w.reach[b];
    if (!any(apart(w.around[a], w.around[b]) < sum * sum)) continue;
    // Where lines leave the cells that are clear, hulls would be in the way of what is clear at the ends.
    if (!w.notes && clear_on_line(robot, i, from, step)) continue;
    if (!pair_free(robot, w, i)) return false;
    if (!goes_on) continue;
    w.near_pair[w.near_pair_count++] = i;
    for (const int g : {a, b}) {
      const int body = robot.groups[static_cast<std::size_t>(g)].body;
      if (body == 0 || listed[g]) continue;
      listed[g] = true;
      w.near_group[w.near_group_count++] = g;
      w.last_body = std::max(w.last_body, body);
    }
  }
  return true;
}

// A later look, at what is near alone.
inline bool next_block_free(const BlockRobot& robot, const BlockScene& scene, BlockWork& w) {
  for (int i = 0; i < w.near_count; ++i) {
    const BlockWork::Near near = w.near[i];
    const BlockGroup& group = robot.groups[static_cast<std::size_t>(near.group)];
    const BlockShape& shape = scene.shapes[static_cast<std::size_t>(near.obstacle)];
    if (i == 0 || w.near[i - 1].group != near.group) place_group(robot, w, near.group);
    if (!any(meets(shape, w.around[near.group], all(group.around.radius)))) continue;
    Flags touched = {};
    for (int k = near.first; k < near.first + near.count; ++k) {
      const BlockBall& ball = robot.balls[static_cast<std::size_t>(w.near_ball[k])];
      Lanes p[3];
      place(w, group.body, ball, p);
      touched |= meets(shape, p, all(ball.radius));
      if ((group.piece_count == 0 || !w.settles[near.group]) && any(touched)) return false;
    }
    if (any(touched) && !settled(robot, scene, w, near.group, near.obstacle, touched)) return false;
  }
  for (int i = 0; i < w.near_group_count; ++i) place_group(robot, w, w.near_group[i]);
  for (int i = 0; i < w.near_pair_count; ++i) {
    if (!pair_free(robot, w, w.near_pair[i])) return false;
  }
  return true;
}

// Returns how many blocks were looked at, negative when the line is not free.
inline int line_free(const BlockRobot& robot, const BlockScene& scene, BlockWork& w,
                     const float* from, const float* step, int blocks) {
  const Lanes spread = {0.125F, 0.25F, 0.375F, 0.5F, 0.625F, 0.75F, 0.875F, 1.0F};
  const int last = static_cast<int>(robot.bodies.size()) - 1;
  place_bodies(robot, w, from, step, spread, last);
  if (!first_block_free(robot, scene, w, from, step, blocks > 1)) return -1;
  if (blocks == 1 || (w.near_count == 0 && w.near_pair_count == 0)) return 1;
  const float fine = 0.125F / static_cast<float>(blocks);
  const int stride = stride_of(blocks);
  for (int n = 1, offset = stride; n < blocks; ++n) {
    place_bodies(robot, w, from, step, spread - all(fine * static_cast<float>(offset)),
                 w.last_body);
    if (!next_block_free(robot, scene, w)) return -n - 1;
    offset += stride;
    if (offset >= blocks) offset -= blocks;
  }
  return blocks;
}
