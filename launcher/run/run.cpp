// `./twinbus run`: a scene in one process without a bus, as fast as it goes, with report and exit status.

#include "common/math/angle.h"
#include "launcher/commands/commands.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/file/write_file.h"
#include "common/math/index.h"
#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "launcher/run/accuracy.h"
#include "launcher/run/judge_scene.h"
#include "launcher/run/local_stack.h"
#include "launcher/run/seeds.h"
#include "launcher/stack/run_folder.h"
#include "launcher/run/verdict.h"
#include "robot/description/load.h"
#include "common/process/process.h"
#include "sim/articulated/spatial.h"
#include "sim/scene/scene_seed.h"
#include "sim/scene/settings.h"
#include "sim/world/world.h"
#include "viewer_log/log/log_writer.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kFarthest = 1e5;                     // [m]
constexpr int kFinerSteps = 8;                        // of the reference, per step of the run

using FootForces = std::vector<std::array<float, 2>>;  // vertical, left and right, per tick [N]

void show_progress(const OneProcess& run, std::int64_t ticks, std::int64_t& shown_ns) {
  static const bool terminal = isatty(STDERR_FILENO) == 1;
  if (!terminal || monotonic_ns() - shown_ns < kProgressEvery) return;
  shown_ns = monotonic_ns();
  std::fprintf(stderr, "\r%3.0f %%  ",
               1e2 * static_cast<double>(run.ticks()) / static_cast<double>(ticks));
}

FootForces go(OneProcess& run, std::int64_t ticks, bool talk) {
  FootForces forces;
  forces.reserve(static_cast<std::size_t>(ticks));
  std::int64_t shown_ns = monotonic_ns();
  while (run.ticks() < ticks && !quit_requested() && run.tick()) {
    const SimTruth& truth = run.truth();
    forces.push_back({truth.foot_force[0][2], truth.foot_force[1][2]});
    for (const std::string& sentence : run.take_sentences()) {
      if (talk) {
        std::printf("%8.3f s  %s\n", 1e-9 * static_cast<double>(run.state().time_ns),
                    sentence.c_str());
      }
    }
    show_progress(run, ticks, shown_ns);
  }
  return forces;
}

// Root of the mean square over ticks and feet [N].
double rms_difference(const FootForces& a, const FootForces& b) {
  double sum = 0.0;
  const std::size_t n = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t foot = 0; foot < 2; ++foot) {
      sum += std::pow(static_cast<double>(a[i][foot]) - static_cast<double>(b[i][foot]), 2);
    }
  }
  return n > 0 ? std::sqrt(sum / static_cast<double>(2 * n)) : std::nan("");
}

void print(const OneProcess& run, const Criteria& asked, const RunVerdict& verdict,
           const std::string& robot, double sim_s, double wall_s, double force_error) {
  std::printf("%.3f s simulated in %.3f s: %.1f times real time\n", sim_s, wall_s, sim_s / wall_s);
  std::printf("%s", scene_figures(run, asked).c_str());
  if (!std::isnan(force_error))
    std::printf("foot forces: %.2f N from the reference (root mean square)\n", force_error);
  std::printf("state_hash %s\n", run.state_hash().c_str());
  for (const std::string& failure : verdict.failures) std::printf("FAILED: %s\n", failure.c_str());
  if (verdict.fell && std::filesystem::exists(robot))
    print_typed(stdout, "why: ./twinbus check %s names joints that are too weak and what looks wrong\n",
                robot.c_str());
  if (!verdict.left_out.empty()) {
    std::printf("not judged, for this is only a part of the scene:");
    const char* between = "";
    for (const std::string& what : verdict.left_out) {
      std::printf("%s %s", between, what.c_str());
      between = ";";
    }
    std::printf("\n");
  }
  if (verdict.passed) std::printf("%s\n", passed_line(run.trust().doubted).c_str());
}

constexpr const char* kSimdNames[] = {"baseline", "avx2", "avx512"};
#if defined(__x86_64__)
constexpr const char* kArchitecture = "x86_64";
#elif defined(__aarch64__)
constexpr const char* kArchitecture = "aarch64";
#else
constexpr const char* kArchitecture = "other";
#endif

// A word that nobody knows would run on whatever path the machine has.
void check_simd_word() {
  const char* asked = std::getenv("TWINBUS_SIMD");
  if (asked == nullptr || *asked == '\0') return;
  for (const char* name : kSimdNames) {
    if (std::string(asked) == name) return;
  }
  throw UsageError(std::string("run: TWINBUS_SIMD is '") + asked +
                   "'; use baseline, avx2 or avx512, or take it out of the environment");
}

// What the settings make of the scene's contact.
std::string contact_asked(const Scene& scene,
                          const std::vector<std::pair<std::string, std::string>>& settings) {
  std::string contact = scene.contact;
  for (const auto* list : {&scene.settings, &settings}) {
    for (const auto& [key, value] : *list) {
      if (key == "contact") contact = value;
    }
  }
  return contact;
}

// CPU of the physics of this run [ms per simulated s].
double cost_of(const OneProcess& run) {
  const double simulated = run.model().period() * static_cast<double>(run.ticks());
  return simulated > 0.0 ? 1e3 * run.physics_seconds() / simulated : 0.0;
}

// The figures that only `run` has, in the report that `up` writes too.
std::string with_own_figures(const std::string& report, double force_error, const OneProcess& run,
                             const AccuracyChoice* choice, const AccuracyRequest& accuracy) {
  const WalkFigures& walked = run.walked();
  const auto number = [](double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
  };
  auto json = nlohmann::ordered_json::parse(report);
  json["simd"] = kSimdNames[static_cast<std::size_t>(simd())];
  json["architecture"] = kArchitecture;
  if (!std::isnan(force_error)) json["foot_force_rms_error_n"] = force_error;
  json["sole_tilt_max_deg"] = kDegrees * run.sole_tilt_max();
  json["steps"] = walked.steps();
  json["zmp_margin_p5_mm"] = number(1e3 * walked.margin_percentile(0.05));
  json["step_slip_max_mm"] = number(1e3 * walked.step_slip_max());
  json["force_rms_percent"] = number(1e2 * walked.force_error());
  json["velocity_error_percent"] = number(1e2 * walked.velocity_error());
  json["travel_m"] = number(walked.travel());
  if (choice != nullptr) json["accuracy"] = nlohmann::ordered_json::parse(accuracy_json(*choice, accuracy, cost_of(run)));
  const TrustCounts& trust = run.trust();
  auto& doubted = json["doubted_steps"];
  doubted = doubts_json(trust);  // those after the last TRUTH too
  doubted["energy_gain_max_j"] = trust.energy_gain;
  doubted["first_seen_depth_max_mm"] = 1e3 * trust.first_depth;
  if (const auto swing = run.swing().seen()) {
    json["swing_period_s"] = swing->period;
    json["swing_decay_per_s"] = swing->decay;
    json["linear_period_s"] = run.swing().expected().period;
    json["linear_decay_per_s"] = run.swing().expected().decay;
  }
  return json.dump(2) + "\n";
}

// Nothing when one seed is run.
std::optional<SeedsRequest> seeds_of(const Arguments& arguments) {
  if (!arguments.has("--seeds")) {
    for (const char* option : {"--jobs", "--lanes"}) {
      if (arguments.has(option)) throw UsageError(std::string("run: ") + option + " goes with --seeds");
    }
    return std::nullopt;
  }
  for (const char* other : {"--seed", "--log", "--reference"}) {
    if (arguments.has(other)) throw UsageError(std::string("run: --seeds goes without ") + other);
  }
  SeedsRequest request;
  const std::string word = arguments.text("--seeds", "");
  if (!read_seeds(word, request.seeds))
    throw UsageError("run: --seeds wants FIRST..LAST, such as 1..256, at most a million, not '" + word + "'");
  request.jobs = static_cast<int>(arguments.number("--jobs", 0.0, 1.0, 1024.0));
  request.lanes = arguments.has("--lanes");
  request.talk = true;
  return request;
}

// A robust scene is another world with each of several seeds; a single one is the world that the scene says.
void disturb_if_asked(const Arguments& arguments, const std::optional<SeedsRequest>& many, Scene& scene) {
  const bool asked = arguments.has("--disturbed"), refused = arguments.has("--undisturbed");
  if (asked && refused) throw UsageError("run: --disturbed or --undisturbed, not both");
  if (refused) {
    scene.disturbance = {};
  } else if ((asked || (many && scene.robust)) && !is_disturbed(scene)) {
    scene.disturbance = small_disturbance();
    if (many && !asked) std::printf("starts, masses and friction are drawn from each seed, as by --disturbed with one --seed\n");
  }
  if (many && many->seeds.last > many->seeds.first && !draws_from_seed(scene))
    std::printf("the scene draws nothing from its seed but the noise of its sensors, if it has some: --disturbed makes each seed another world\n");
}

// The scene once for each seed; undrawn: before a seed has drawn anything in it.  choice: what the first seed alone has shown,
// may be null.
int run_many(SeedsRequest seeds, const Model& model, const Scene& undrawn, const OneProcessConfig& config,
             const RunRequest& request, const AccuracyChoice* choice, const AccuracyRequest& accuracy,
             const std::string& report) {
  if (choice != nullptr) {
    const double cost = choice->cost();
    seeds.accuracy = accuracy_json(*choice, accuracy, cost);
    seeds.measured = choice->rung >= 0;
    std::printf("%s, with seed %llu alone\n", accuracy_line(*choice, accuracy, cost).c_str(),
                static_cast<unsigned long long>(accuracy.seed));
    if (!choice->reason.empty()) std::printf("FAILED: %s\n", choice->reason.c_str());
  }
  seeds.ticks = std::llround(request.duration / model.period());
  seeds.part = seeds.ticks < std::llround(undrawn.duration / model.period());
  const std::int64_t begin = monotonic_ns();
  const std::vector<SeedResult> results = run_seeds(model, seeds, [&](std::uint64_t seed) {
    SeededRun ready{undrawn, config};
    ready.config.seed = seed;
    apply_seed(ready.scene, model, seed);
    return ready;
  });
  const double wall_s = 1e-9 * static_cast<double>(monotonic_ns() - begin);
  std::printf("%s", seeds_text(results, seeds, model.period(), wall_s).c_str());
  if (!report.empty()) write_file(report, seeds_json(results, seeds, request, wall_s));
  const bool all = results.size() == seeds.seeds.last - seeds.seeds.first + 1 && (choice == nullptr || choice->reason.empty());
  return all && std::all_of(results.begin(), results.end(), [](const SeedResult& each) { return each.verdict.passed; }) ? 0 : 1;
}

}  // namespace

int run_command(const std::vector<std::string>& words) {
  const Arguments arguments({"run", 1, 1, R"(SCENE
Runs a scene in one process, without a bus, as fast as it goes, and judges it by the scene's own criteria;
shorter than the scene (--for) by what can be judged by then, and what is left out is said.
SCENE is a name in config/scenes or a file.  Exit status 0 only if all of them hold.  The same line gives the
same state_hash, which is also that of ./twinbus up SCENE --lockstep.  Settings of --set:
)" + settings_help() + R"(
  --robot
  --for S  simulated seconds; default: the scene's duration
  --engine E  articulated, ode or mujoco; default the scene's
  --start-pose POSE  of the robot's SRDF, in which it begins; default the scene's
  --away M  all of it begins so far along x from where the scene says [m]
  --seed N  of everything random; default 1
  --disturbed  a scene without a disturbance of its own gets a small one, drawn from the seed: starts, masses, friction; \
      with --seeds a scene that says robust: true has it anyway
  --undisturbed  nothing of that is drawn
  --seeds A..B  the scene once for each of these seeds, one at a time on each processor
  --jobs N  with --seeds: so many at a time
  --lanes  with --seeds: the physics of four seeds in the lanes of one vector; hashes are those of seeds run so
  --set KEY=VALUE  a setting of the simulator; wins over the scene's own
  --reference  runs the scene again with eight physics steps in one: error of the foot forces against that
  --accuracy LENGTH  order and step are chosen so that no link or body is farther from the converged answer, 0.001 or 1mm
  --fidelity WORD  full, auto (no more is modelled than the accuracy needs; default 1mm), legs or rigid; default the scene's
  --budget TIME  of CPU for the physics in a control period, 0.5 or 0.5ms: the best accuracy that fits
  --no-guard  leaves the guard in the controller out
  --log F.log  records every message, for ./twinbus log; times are simulated
  --force  writes over a log that is there, with its parts
  --report F.json  writes the figures)"}, words);
  check_simd_word();
  catch_quit_signals();
  const std::string log_file = arguments.text("--log", "");
  if (!log_file.empty() && !arguments.has("--force")) refuse_if_there(log_file);
  Scene scene = load_scene(arguments.word(0));
  RunRequest request = request_of("run", arguments, scene);
  scene.engine = request.engine;
  choose_fidelity(arguments, scene);
  request.lockstep = true;
  const std::optional<SeedsRequest> many = seeds_of(arguments);
  if (many) request.seed = many->seeds.first;
  const Model model = load_robot(request.robot);
  fit_scene(scene, model);
  request.duration = arguments.number("--for", scene.duration, 0.002, 1e6);
  start_in(arguments.text("--start-pose", scene.start_pose), model, scene);
  scene.origin.x() += arguments.number("--away", 0.0, -kFarthest, kFarthest);
  if (!scene.scaled.empty()) std::printf("%s\n", scene.scaled.c_str());
  disturb_if_asked(arguments, many, scene);
  Scene undrawn = scene;
  apply_seed(scene, model, request.seed);
  request.period = model.period();
  request.step_s = scene.step > 0.0 ? scene.step : model.period();

  OneProcessConfig config;
  config.settings = settings_of("run", arguments, model.period());
  request.contact = contact_asked(scene, config.settings);
  config.seed = request.seed;
  config.control.guard_in_loop = !arguments.has("--no-guard");
  const std::int64_t ticks = std::llround(request.duration / model.period());
  AccuracyRequest accuracy = accuracy_of("run", arguments, scene);
  scene.accuracy = undrawn.accuracy = accuracy.error;  // what is off by more is doubted
  std::optional<AccuracyChoice> choice;
  if (accuracy.error > 0.0 || accuracy.budget > 0.0) {
    accuracy.duration = request.duration;
    accuracy.seed = request.seed;
    choice = choose_accuracy(model, scene, config, accuracy);
    if (choice->rung >= 0) {
      Rung rung = choice->ladder.rungs[static_cast<std::size_t>(choice->rung)];
      scene = at_rung(scene, rung);
      rung.less.aloft.clear();
      rung.less.untouched.clear();  // another seed may come to touch what this one does not
      rung.less.apart = false;
      undrawn = at_rung(undrawn, rung);
      // The ladder has measured what this run is off by, so its steps are doubted where they are worse than they were there.
      scene.bands = undrawn.bands = rung.bands.times(kBand);
      drop_method(config.settings);
      request.step_s = rung.step;
    }
  }

  if (many) {
    return run_many(*many, model, undrawn, config, request, choice ? &*choice : nullptr, accuracy,
                    arguments.text("--report", ""));
  }

  std::unique_ptr<LogWriter> log;
  if (!log_file.empty()) {
    log = std::make_unique<LogWriter>(log_file);
    remove_later_parts(log_file);
    config.listener = [&log](const char* name, std::span<const std::uint8_t> bytes,
                             std::int64_t now_ns) { log->add(now_ns / 1000, name, bytes); };
  }
  std::unique_ptr<OneProcess> made;
  try {
    made = std::make_unique<OneProcess>(model, scene, config);
  } catch (...) {
    if (log != nullptr) std::remove(log_file.c_str());  // there is nothing in it
    throw;
  }
  OneProcess& run = *made;
  if (choice) run.time_physics();
  config.listener = nullptr;  // not of the reference
  const std::int64_t begin = monotonic_ns();
  const FootForces forces = go(run, ticks, true);
  const double wall_s = std::max(1e-9, 1e-9 * static_cast<double>(monotonic_ns() - begin));
  if (log != nullptr) log->close();
  double force_error = std::nan("");
  if (arguments.has("--reference")) {
    Scene finer = scene;
    finer.step = request.step_s / kFinerSteps;
    OneProcess reference(model, finer, config);
    force_error = rms_difference(forces, go(reference, ticks, false));
  }
  const bool part = ticks < std::llround(scene.duration / model.period());
  RunVerdict verdict = judge_scene(run, scene.criteria, ticks, part);
  if (choice && !choice->reason.empty()) {
    verdict.failures.push_back(choice->reason);
    verdict.passed = false;
  }
  if (choice) std::printf("%s\n", accuracy_line(*choice, accuracy, cost_of(run)).c_str());
  print(run, scene.criteria, verdict, request.robot,
        model.period() * static_cast<double>(run.ticks()), wall_s, force_error);
  if (const std::string file = arguments.text("--report", ""); !file.empty()) {
    write_file(file,
               with_own_figures(report_json(verdict, request, run.seen(), wall_s, run.state_hash()),
                                force_error, run, choice ? &*choice : nullptr, accuracy));
  }
  return verdict.passed ? 0 : 1;
}

}  // namespace twinbus::launcher
