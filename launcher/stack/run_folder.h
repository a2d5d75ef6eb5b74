// One folder per run, runs/DATE-TIME: each process's output, the stack and scene as read, the commit of the program.

#pragma once

#include <string>
#include <utility>
#include <vector>

namespace twinbus {

// Makes runs/DATE-TIME under the installation ($TWINBUS_RUNS wins), or DATE-TIME-2 and so on when there is one already.
// Throws std::runtime_error naming the folder if it cannot be made.
std::string make_run_folder();

// Where run folders are made.
std::string runs_folder();

// Throws std::runtime_error naming the file.
void write_file(const std::string& file, const std::string& text);

// Folder of this very program, for its siblings; and of the source tree or installation around it.
std::string program_folder();
std::string install_folder();

// Of the source tree, or "unknown".
std::string commit_of_program();

}  // namespace twinbus
