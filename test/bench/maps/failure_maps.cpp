// Cells of the maps of failures, one a line of JSON on the standard input; what became of each as a line on the output.
//
//     failure_maps           runs them: {"map": "slide", "engine": "ode", "step": 0.01, ...} (test/bench/failure_cells.py)
//     failure_maps mujoco    writes them for MuJoCo
//
// A cell that cannot be run answers {"error": WHY}.

#include <cstdio>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>

#include "common/process/process.h"
#include "test/bench/maps/failure_scenes.h"

namespace twinbus {
namespace {

nlohmann::json answer(const std::string& line, bool for_mujoco) try {
  const nlohmann::json cell = nlohmann::json::parse(line);
  if (cell.value("map", "") == "walk") return run_walk(cell);
  nlohmann::json found = nlohmann::json::array();
  for (const FailureScene& scene : failure_scenes(cell)) found.push_back(for_mujoco ? mujoco_scene(scene) : run_scene(scene));
  return found;
} catch (const std::exception& error) {
  return {{"error", error.what()}};
}

int maps(int argc, char** argv) {
  if (argc > 2 || (argc == 2 && std::strcmp(argv[1], "mujoco") != 0))
    throw std::runtime_error("usage: failure_maps [mujoco] < CELLS; a cell is a line of JSON");
  for (std::string line; std::getline(std::cin, line);) {
    if (line.empty()) continue;
    std::printf("%s\n", answer(line, argc == 2).dump().c_str());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) { return twinbus::run_process("failure_maps", &twinbus::maps, argc, argv); }
