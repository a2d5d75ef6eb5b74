// The simulator process: a scene behind the adaptor interface, as a source of STATE.

#include <array>
#include <cstdio>

#include "bridge/source/source_main.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "sim/scene/obstacle_pieces.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_requests.h"
#include "sim/scene/scene_seed.h"
#include "sim/scene/settings.h"
#include "sim/sim_adaptor.h"

namespace twinbus::inline sim {
namespace {

int run(int argc, char** argv) {
  SourceMainOptions options = source_main_options("simulator", SourceKind::kSimulator, ProcessKind::kSimulator);
  std::string scene_name = "stand";
  AdaptorConfig config;
  Options parser("twinbus_simulator",
                 "Simulates a robot in a scene as a source of STATE.\n\nSettings of --set:\n" +
                     settings_help());
  add_common(parser, options.common);
  std::string engine, start_pose;
  parser.choice("--engine", {std::begin(kEngineNames), std::end(kEngineNames)}, engine,
                "physics engine; default the scene's");
  parser.text("--start-pose", "POSE", start_pose, "of the SRDF, in which the robot begins; default the scene's");
  parser.positional("SCENE", scene_name, false, "a name under config/scenes, or a YAML file");
  parser.settings("--set", config.settings,
                  "key=value, see above; wins over the scene's own settings");
  double step = 0.0, accuracy = 0.0;
  std::array<double, 4> bands{};
  parser.number("--step", "S", step, 1e-7, 0.1, "physics step, so many of which make a control period; default the scene's");
  parser.number("--accuracy", "M", accuracy, 1e-9, 0.1, "steps that are off by more are doubted; default the scene's");
  constexpr std::array kBands = {"--band-error", "--band-gain", "--band-rise", "--band-depth"};
  for (std::size_t i = 0; i < kBands.size(); ++i)
    parser.number(kBands[i], "X", bands[i], 0.0, 1e9, "of a run whose error was measured: steps are doubted beyond it; 0: no such run");
  add_source_options(parser, options, true);
  parser.parse(argc, argv);

  Scene scene = load_scene(scene_name);
  if (parser.given("--engine")) scene.engine = engine;
  if (!parser.given("--robot")) options.common.robot = scene.robot;
  const Model model = load_robot(options.common.robot);
  if (parser.given("--start-pose")) start_in(start_pose, model, scene);
  if (parser.given("--step")) scene.step = step;
  if (parser.given("--accuracy")) scene.accuracy = accuracy;
  scene.bands = {bands[0], bands[1], bands[2], bands[3]};
  resolve_poses(scene, model);
  apply_seed(scene, model, static_cast<std::uint64_t>(options.seed));
  SimSettings checked;  // a wrong setting is a wrong argument, said before anything opens
  for (const auto& [key, value] : config.settings) {
    const std::string complaint = apply_setting(key, value, model.period(), checked);
    if (complaint.empty()) continue;
    std::fprintf(stderr, "twinbus_simulator: %s\n", complaint.c_str());
    return 2;
  }
  bool seeded = false;
  for (const auto& [key, value] : config.settings) seeded = seeded || key == "sensor.seed";
  if (!seeded) config.settings.emplace_back("sensor.seed", std::to_string(options.seed));

  options.scene_text = scene.text;
  options.obstacles = obstacle_pieces(scene.obstacles, random_id());
  if (!scene.tiles.empty()) options.terrain = obstacle_pieces(scene.tiles, 0);
  options.requests = requests_of(scene);

  SimAdaptor adaptor(scene);
  if (adaptor.open(model, config) != Status::kOk) return 1;  // it has said why
  const int code = run_source_main(options, model, adaptor);
  adaptor.close();
  return code;
}

}  // namespace
}  // namespace twinbus::sim

int main(int argc, char** argv) {
  return twinbus::run_process("simulator", twinbus::run, argc, argv);
}
