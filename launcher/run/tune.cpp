// `./twinbus tune`: the cheapest order and step that hold an error; `explain`: what of a scene is modelled, at what cost.

#include "common/math/angle.h"
#include "launcher/commands/commands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/file/write_file.h"
#include "common/math/index.h"
#include "common/process/arguments.h"
#include "common/process/process.h"
#include "common/text/formatted.h"
#include "common/time/part_clock.h"
#include "launcher/run/accuracy.h"
#include "launcher/run/judge_scene.h"
#include "launcher/run/ladder_plot.h"
#include "launcher/run/tuned_text.h"
#include "launcher/stack/run_folder.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kLook = 1.0;  // of a scene, to see where its time goes [s]

struct Opened {
  Scene scene;
  Model model;
  OneProcessConfig config;
  AccuracyRequest request;
};

double length_of(const Arguments& arguments, const std::string& option, double otherwise) {
  if (!arguments.has(option)) return otherwise;
  double length = 0.0;
  const std::string problem = read_accuracy(arguments.text(option, ""), length);
  if (!problem.empty()) throw UsageError(option + " " + problem);
  return length;
}

Opened open(const Arguments& arguments) {
  Opened opened;
  Scene& scene = opened.scene = load_scene(arguments.word(0));
  opened.model = load_robot(arguments.text("--robot", scene.robot));
  opened.request.seed =
      static_cast<std::uint64_t>(arguments.number("--seed", 1.0, 0.0, 1e9));
  opened.request.duration = arguments.number("--for", scene.duration, 0.02, 1e6);
  opened.request.talk = true;
  opened.config.seed = opened.request.seed;
  fit_scene(scene, opened.model);
  choose_fidelity(arguments, scene);
  apply_seed(scene, opened.model, opened.request.seed);
  return opened;
}

std::string csv_of(const Opened& opened, const AccuracyChoice& choice) {
  std::ostringstream csv;
  csv.precision(9);
  csv << "scene,seed,duration_s,order,step_s,local_error_m_s2,physics_ms_per_s,error_m,where,at_s,held_joints,rigid_robots,still,untouched,aloft,no_self_contact,asleep,chosen\n";
  for (std::size_t i = 0; i < choice.ladder.rungs.size(); ++i) {
    const Rung& rung = choice.ladder.rungs[i];
    csv << opened.scene.name << ',' << opened.request.seed << ',' << opened.request.duration << ','
        << rung.order << ',' << rung.step << ',' << rung.local << ',' << rung.cost << ',' << choice.ladder.estimate(i)
        << ',' << rung.body << ',' << rung.at << ',' << rung.less.held.size() << ',' << rung.less.rigid.size()
        << ',' << rung.less.still.size() << ',' << rung.less.untouched.size() << ',' << rung.less.aloft.size() << ',' << rung.less.apart << ',' << rung.less.asleep
        << ',' << (static_cast<int>(i) == choice.rung)
        << '\n';
  }
  return csv.str();
}

std::string why_of(const Opened& opened, const AccuracyChoice& choice) {
  const auto index = static_cast<std::size_t>(choice.rung);
  const Rung& rung = choice.ladder.rungs[index];
  return formatted(
      "tuned: error %.3g mm over %.3g s (seed %llu), physics %.3g ms per second; the finest two runs agree to %.3g mm; commit %.12s",
      1e3 * choice.ladder.estimate(index), opened.request.duration, static_cast<unsigned long long>(opened.request.seed),
      rung.cost, 1e3 * choice.ladder.agreement, commit_of_program().c_str());
}

// A line for each part, what takes most first.
std::string parts_of_time(const PartClock& clock, double simulated) {
  std::vector<PartClock::Part> parts(clock.parts().begin(), clock.parts().end());
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
  double all = 0.0;
  for (const PartClock::Part& part : parts) all += part.seconds;
  std::string text = "part of the time         CPU [ms/s]    share\n";
  for (const PartClock::Part& part : parts) {
    text += formatted("%-22s %12.3f  %5.1f %%\n", std::string(part.name).c_str(), 1e3 * part.seconds / simulated,
                      all > 0.0 ? 1e2 * part.seconds / all : 0.0);
  }
  return text;
}

// Where the time of a short run goes.
void print_shares(const Opened& opened) {
  OneProcess run(opened.model, opened.scene, opened.config);
  const double duration = std::min(kLook, opened.request.duration);
  const std::int64_t ticks = std::max<std::int64_t>(1, std::llround(duration / opened.model.period()));
  const std::int64_t begun = monotonic_ns();
  std::size_t contacts = 0, most = 0;
  PartClock clock;
  const auto tick = [&] {
    const PartClock::Running running(clock);
    const PartScope part("all else");
    return run.tick();
  };
  while (run.ticks() < ticks && tick()) {
    contacts += run.world().contacts().size();
    most = std::max(most, run.world().contacts().size());
  }
  const double wall = 1e-9 * static_cast<double>(monotonic_ns() - begun);
  const double simulated = opened.model.period() * static_cast<double>(run.ticks());
  if (!(simulated > 0.0)) return;
  std::printf("time         %.2f ms per simulated second\n%s", 1e3 * wall / simulated, parts_of_time(clock, simulated).c_str());
  std::printf("contacts     of the robot %.1f points in the mean, %zu at most\n",
              static_cast<double>(contacts) / static_cast<double>(run.ticks()), most);
  std::printf("doubts       %ld of the physics steps of that second\n", run.trust().doubted);
}

void print_model(const Opened& opened) {
  const Scene& scene = opened.scene;
  const Model& model = opened.model;
  int locked = 0, follow = 0, rotors = 0, rubbing = 0;
  for (const Joint& joint : model.joints) {
    locked += !(joint.upper > joint.lower) ? 1 : 0;
    follow += joint.mimic >= 0 ? 1 : 0;
    rotors += joint.rotor_inertia > 0.0 ? 1 : 0;
    rubbing += joint.friction > 0.0 || joint.damping > 0.0 ? 1 : 0;
  }
  std::printf("engine       %s, contact %s\n", scene.engine.c_str(), scene.contact.c_str());
  std::printf("robot        %s: %d links, %d joints (%d cannot move, %d follow others, %d with rotor "
              "inertia, %d with friction or damping), base %s\n",
              model.name.c_str(), model.link_count(), model.joint_count(), locked, follow, rotors,
              rubbing, scene.fixed_base || !model.floating_base ? "fixed" : "free");
  std::printf("soles        %s, springs and dampers; links: %s\n",
              scene.contact == "patch" ? "and other links: the area that presses" : "four corners each",
              scene.self_contact
                  ? "touch one another, the ground and obstacles"
                  : "touch the ground and obstacles, not one another (self_contact)");
  if (!scene.loose.empty() && scene.engine == "articulated")
    std::printf("steps        %s\n", falls_alone(scene) ? "nobody drives the robot and something is loose: with an accuracy parts by local error are tried too"
                                                       : "of one length: parts by local error are for what falls while nobody drives the robot");
  std::printf("settings     ");
  for (const auto& [key, value] : scene.settings) std::printf("%s%s=%s", &key == &scene.settings.front().first ? "" : ", ", key.c_str(), value.c_str());
  std::printf("%s\n", scene.settings.empty() ? "none: ideal sensors, servos without delay or play" : "");
  std::printf("loose        %zu bodies", scene.loose.size());
  for (const LooseBody& body : scene.loose)
    std::printf(", %s%s", body.name.c_str(), body.mesh != nullptr ? " (triangles)" : "");
  std::printf("\nfixed        %zu obstacles, %zu tiles of ground; further robots %zu; loops %zu, grasps %zu\n",
              scene.obstacles.size(), scene.tiles.size(), scene.robots.size(), scene.loops.size(),
              scene.grasps.size());
}

// Line by line: what moves how far and how it is modelled.
std::vector<ModelledPart> parts_of(const Opened& opened, const Moved& moved, const Less& less) {
  const auto in = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<ModelledPart> parts;
  char text[80];
  const std::vector<double> way = ways(opened.model, moved);
  for (std::size_t j = 0; j < way.size(); ++j) {
    const Joint& joint = opened.model.joints[j];
    const bool slides = joint.kind == JointKind::kPrismatic, held = in(less.held, joint.name);
    std::snprintf(text, sizeof text, "moves %.4g %s", moved.joints[j] * (slides ? 1e3 : kDegrees), slides ? "mm" : "degrees");
    parts.push_back({joint.name, text, way[j],
                     held ? "held" : way[j] <= opened.request.error ? "yes: with it held the error was not kept" : "yes", held});
  }
  for (std::size_t i = 0; i < moved.robots.size(); ++i) {
    const std::string& name = moved.robots[i];
    const bool rigid = in(less.rigid, name), still = in(less.still, name);
    parts.push_back({"robot " + name, "", moved.robot_ways[i], still ? "still" : rigid ? "one rigid body" : "yes", still || rigid});
  }
  const bool still = in(less.still, "base");
  parts.push_back({"robot itself", "", moved.links, still ? "still" : "yes", still});
  if (opened.scene.self_contact)
    parts.push_back({"links touch links", "", -1.0, less.apart ? "no: without it the error is kept" : "yes", less.apart});
  if (!moved.clear.empty()) {
    const std::string far = less.untouched.empty() ? "all" : "all but " + std::to_string(less.untouched.size());
    parts.push_back({"links meet what is loose", "", -1.0, far + (less.untouched.empty() ? "" : ", which nothing comes near"),
                     !less.untouched.empty()});
  }
  const std::string fixed = less.aloft.empty() ? "all" : "all but " + std::to_string(less.aloft.size()) + ", which it never comes near";
  parts.push_back({"links meet what is fixed", "", -1.0, fixed, !less.aloft.empty()});
  if (!opened.scene.loose.empty()) {
    std::snprintf(text, sizeof text, "lie still for %.0f %% of the time", 1e2 * moved.lay);
    parts.push_back({"loose bodies", text, -1.0, less.asleep ? "asleep where they lie still" : "yes", less.asleep});
  }
  return parts;
}

// What is modelled, what was left out and why, and what each costs, as a table and, where a file is named, a picture.
void explain_less(const Opened& opened, const AccuracyChoice& choice, const std::string& file) {
  const Ladder& ladder = choice.ladder;
  const Rung* chosen = choice.chosen();
  Less less = chosen != nullptr ? chosen->less : Less{};
  less.asleep = less.asleep || opened.scene.asleep;
  less.aloft.insert(less.aloft.end(), opened.scene.aloft.begin(), opened.scene.aloft.end());
  less.untouched.insert(less.untouched.end(), opened.scene.untouched.begin(), opened.scene.untouched.end());
  std::printf("\nfidelity     auto: what moves less than the error of %.3g mm in this scene may be left out\n",
              1e3 * opened.request.error);
  const std::vector<ModelledPart> parts = parts_of(opened, ladder.moved, less);
  std::printf("%-28s %-30s %-28s modelled\n", "part", "", "what is behind it moves [mm]");
  for (const ModelledPart& part : parts) {
    char way[32] = "";
    if (part.way >= 0.0) std::snprintf(way, sizeof way, "%.4g", 1e3 * part.way);
    std::printf("%-28s %-30s %-28s %s\n", part.name.c_str(), part.moves.c_str(), way, part.modelled.c_str());
  }
  std::vector<std::pair<std::string, double>> costs;
  if (chosen != nullptr) {
    double whole = chosen->cost;
    for (const Rung& rung : ladder.rungs) {
      const bool same = rung.order == chosen->order && rung.step == chosen->step && rung.local == chosen->local;
      if (same && rung.less.none()) whole = rung.cost;
    }
    costs = {{"what is modelled", chosen->cost}, {"what was left out", whole - chosen->cost}};
    std::printf("part                         physics [ms/s]    share\n");
    for (const auto& [name, cost] : costs) std::printf("%-28s %14.2f   %5.1f %%\n", name.c_str(), cost, 1e2 * cost / whole);
    std::printf("left out: %s\n", less.none() ? "nothing" : words_of(less).c_str());
  }
  if (file.empty()) return;
  const std::string title = formatted("%s on %s: what is modelled to be within %.4g mm over %.4g s", opened.scene.name.c_str(),
                opened.model.name.c_str(), 1e3 * opened.request.error, opened.request.duration);
  write_file(file, parts_svg(title, parts, opened.request.error, costs));
}

// Error against cost of what was run, where a file is named.
void plot_front(const Opened& opened, const AccuracyChoice& choice, const std::string& file) {
  if (file.empty()) return;
  const std::string title = formatted("%s on %s, %.4g s, seed %llu: error against cost", opened.scene.name.c_str(), opened.model.name.c_str(),
                opened.request.duration, static_cast<unsigned long long>(opened.request.seed));
  write_file(file, front_svg(title, choice.ladder, choice.rung, opened.request.error));
}

// What the scene leaves out itself is left out too.
Rung with_own(Rung rung, const Scene& scene) {
  if (rung.less.none()) return rung;
  const Scene all = without(scene, rung.less);
  rung.less = {all.held, all.rigid, {}, all.untouched, all.aloft, rung.less.apart, all.asleep};
  return rung;
}

}  // namespace

int tune_command(const std::vector<std::string>& words) {
  const Arguments arguments({"tune", 1, 1, R"(SCENE
Runs a scene at orders and steps of the ladder, prints error against cost and the cheapest that holds the error
together with all finer ones.  It climbs until the error is proven.  Exit status 0 only if one holds.
  --robot
  --error LENGTH  0.001 or 1mm; default the scene's accuracy, else 1mm
  --budget TIME  of CPU for the physics in a control period, 0.5 or 0.5ms: the best that fits of all rungs
  --for S  simulated seconds; default: the scene's duration
  --all  every rung, also those that cannot win
  --seed N  of everything random; default 1
  --fidelity WORD  full, auto, legs or rigid, as ./twinbus run; default the scene's
  --csv F.csv  writes order, step, cost and error of every run
  --plot F.svg  draws them
  --write F.yaml  writes the scene with the settings found, and why)"}, words);
  catch_quit_signals();
  Opened opened = open(arguments);
  if (arguments.has("--budget")) {
    const std::string problem = read_budget(arguments.text("--budget", ""), opened.request.budget);
    if (!problem.empty()) throw UsageError("tune: --budget " + problem);
  }
  opened.request.all = arguments.has("--all") || opened.request.budget > 0.0;
  opened.request.error = length_of(
      arguments, "--error",
      opened.scene.accuracy > 0.0 ? opened.scene.accuracy : opened.request.budget > 0.0 ? 0.0 : 1e-3);
  const AccuracyChoice choice =
      choose_accuracy(opened.model, opened.scene, opened.config, opened.request);
  std::printf("%s", ladder_table(choice.ladder, choice.rung).c_str());
  if (!choice.reason.empty()) std::printf("%s\n", choice.reason.c_str());
  if (const std::string file = arguments.text("--csv", ""); !file.empty())
    write_file(file, csv_of(opened, choice));
  plot_front(opened, choice, arguments.text("--plot", ""));
  if (choice.rung < 0) return 1;
  const Rung& rung = choice.ladder.rungs[at(choice.rung)];
  const std::string why = why_of(opened, choice);
  std::printf("%s; %s\n", words_of(rung).c_str(), why.c_str());
  if (const std::string file = arguments.text("--write", ""); !file.empty())
    write_file(file, tuned_text(opened.scene.text, with_own(rung, opened.scene), why));
  return choice.reason.empty() ? 0 : 1;
}

int explain_command(const std::vector<std::string>& words) {
  const Arguments arguments({"explain", 1, 1, R"(SCENE
Says what of a scene is modelled and how, where the time of its run goes, and with an accuracy which orders and
steps were tried for it and what each is off.
  --robot
  --accuracy LENGTH  0.001 or 1mm; default the scene's
  --for S  simulated seconds of the ladder; default: the scene's duration
  --fidelity WORD  full, auto, legs or rigid, as ./twinbus run; default the scene's
  --plot F.svg  draws what is modelled (fidelity auto), else error against cost of what was tried
  --seed N  of everything random; default 1)"}, words);
  catch_quit_signals();
  Opened opened = open(arguments);
  const std::string file = arguments.text("--plot", "");
  opened.request.error = length_of(arguments, "--accuracy", opened.scene.accuracy > 0.0    ? opened.scene.accuracy
                                                            : opened.scene.fidelity == "auto" ? kAutoError
                                                                                              : 0.0);
  if (!(opened.request.error > 0.0)) {
    if (!file.empty()) throw UsageError("--plot draws what holds an error: say --accuracy 1mm too");
    print_model(opened);
    print_shares(opened);
    std::printf("accuracy     not asked for: the scene's own order and step; --accuracy 1mm finds which are "
                "needed\n");
    return 0;
  }
  print_model(opened);
  print_shares(opened);
  const AccuracyChoice choice =
      choose_accuracy(opened.model, opened.scene, opened.config, opened.request);
  std::printf("%s", ladder_table(choice.ladder, choice.rung).c_str());
  if (!choice.reason.empty()) std::printf("%s\n", choice.reason.c_str());
  if (opened.scene.fidelity == "auto") explain_less(opened, choice, file);
  else plot_front(opened, choice, file);
  return 0;
}

}  // namespace twinbus::launcher
