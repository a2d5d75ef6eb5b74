// One folder per run, runs/DATE-TIME: each process's output, the stack and scene as read, the commit of the program.

#pragma once

#include <string>

namespace twinbus::inline launcher {

// Makes DATE-TIME in runs_folder(), or DATE-TIME-2 and so on when there is one already.
// Throws std::runtime_error naming the folder if it cannot be made.
std::string make_run_folder();

// Where run folders are made: $TWINBUS_RUNS, else runs/ of the source tree; of an installed program
// $XDG_DATA_HOME/twinbus/runs or ~/.local/share/twinbus/runs.
std::string runs_folder();

// The folder of the one stack that runs.  Throws std::runtime_error when there is none, or several.
std::string running_folder();

// In the folder setup of a run: name or folder of its robot.  No robot's folder beside it has a dot.
inline constexpr char kRunningRobot[] = "running.robot";

// Empty where it cannot be read.
std::string first_line_of(const std::string& file);

// Folder of this very program, for its siblings; and of the source tree or installation around it.
std::string program_folder();
std::string install_folder();

// Of the source tree; of an installation, of the tree that it was made of; "unknown" where neither can be read.
std::string commit_of_program();
// Of a checkout or a worktree of git; "unknown" where it is none.
std::string commit_of_tree(const std::string& tree);

}  // namespace twinbus::launcher
