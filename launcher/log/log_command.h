// ./twinbus log: what is in a log, parts of it, and what it says about a controller.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int log_command(const std::vector<std::string>& words);

// One command each; words are what follows its name.
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

}  // namespace twinbus
