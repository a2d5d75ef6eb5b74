// Every command of `twinbus`, as the folders of the launcher give them; words are what follows its name.

#pragma once

#include <string>
#include <vector>

namespace twinbus::inline launcher {

struct Command {
  const char* name;
  const char* about;
  int (*run)(const std::vector<std::string>& words);
};

// launcher/up
int up_command(const std::vector<std::string>& words);
int restart_command(const std::vector<std::string>& words);
int push_command(const std::vector<std::string>& words);
int sim_command(const std::vector<std::string>& words);

// launcher/run
int run_command(const std::vector<std::string>& words);
int tune_command(const std::vector<std::string>& words);
int explain_command(const std::vector<std::string>& words);
int scenes_command(const std::vector<std::string>& words);

// launcher/operate: what an operator says to a running robot
int stop_command(const std::vector<std::string>& words);
int clear_command(const std::vector<std::string>& words);
int pose_command(const std::vector<std::string>& words);
int mode_command(const std::vector<std::string>& words);
int sway_command(const std::vector<std::string>& words);
int squat_command(const std::vector<std::string>& words);
int walk_command(const std::vector<std::string>& words);
int reach_command(const std::vector<std::string>& words);
int grip_command(const std::vector<std::string>& words);
int attach_command(const std::vector<std::string>& words);
int release_command(const std::vector<std::string>& words);
int status_command(const std::vector<std::string>& words);
int switch_command(const std::vector<std::string>& words);
int doctor_command(const std::vector<std::string>& words);
// Programs and scripts of their own.  face_command throws std::runtime_error naming the package when that was not built.
int spy_command(const std::vector<std::string>& words);
int policy_command(const std::vector<std::string>& words);
int env_command(const std::vector<std::string>& words);
int replay_command(const std::vector<std::string>& words);
int view_command(const std::vector<std::string>& words);
int record_command(const std::vector<std::string>& words);
int gamepad_command(const std::vector<std::string>& words);
int face_command(const std::vector<std::string>& words);
int bench_command(const std::vector<std::string>& words);
int campaign_command(const std::vector<std::string>& words);
int chart_command(const std::vector<std::string>& words);

// launcher/check, launcher/export, launcher/motion
int check_command(const std::vector<std::string>& words);
int export_command(const std::vector<std::string>& words);
int motion_file_command(const std::vector<std::string>& words);

// launcher/log
int log_command(const std::vector<std::string>& words);
int log_info(const std::vector<std::string>& words);
int log_cut(const std::vector<std::string>& words);
int log_filter(const std::vector<std::string>& words);
int log_rename(const std::vector<std::string>& words);
int log_csv(const std::vector<std::string>& words);
int log_mcap(const std::vector<std::string>& words);
int log_plot(const std::vector<std::string>& words);
int log_events(const std::vector<std::string>& words);
int log_compare(const std::vector<std::string>& words);
int log_rerun(const std::vector<std::string>& words);

}  // namespace twinbus::launcher
