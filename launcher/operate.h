// What an operator says to a running robot: stop, clear, pose, mode, sway, squat, walk.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int stop_command(const std::vector<std::string>& words);
int clear_command(const std::vector<std::string>& words);
int pose_command(const std::vector<std::string>& words);
int mode_command(const std::vector<std::string>& words);
int sway_command(const std::vector<std::string>& words);
int squat_command(const std::vector<std::string>& words);
int walk_command(const std::vector<std::string>& words);

}  // namespace twinbus
