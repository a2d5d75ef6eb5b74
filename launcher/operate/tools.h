// Commands that are programs or scripts of their own: spy, env, policy, record, gamepad, bench, campaign.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int spy_command(const std::vector<std::string>& words);
int policy_command(const std::vector<std::string>& words);
int env_command(const std::vector<std::string>& words);
int replay_command(const std::vector<std::string>& words);
int view_command(const std::vector<std::string>& words);
int record_command(const std::vector<std::string>& words);
int gamepad_command(const std::vector<std::string>& words);
// Throws std::runtime_error naming the package when that program was not built.
int face_command(const std::vector<std::string>& words);
int bench_command(const std::vector<std::string>& words);
int campaign_command(const std::vector<std::string>& words);
int chart_command(const std::vector<std::string>& words);

}  // namespace twinbus
