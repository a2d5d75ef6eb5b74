#include "launcher/run/accuracy.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "common/file/disk_cache.h"
#include "common/math/index.h"
#include "common/process/process.h"
#include "common/text/closest_name.h"
#include "common/text/formatted.h"
#include "common/text/quantity.h"
#include "common/text/xml.h"
#include "geometry/mesh_contact/contact_mesh.h"
#include "robot/description/load.h"
#include "sim/articulated/spatial.h"
#include "sim/scene/fidelity.h"
#include "sim/scene/settings.h"

namespace twinbus::inline launcher {

namespace {

constexpr const char* kKind = "ladder";

// Another program may come to another result.
void add_this_program(FingerprintMaker& maker) {
  struct stat file {};
  if (stat("/proc/self/exe", &file) != 0) return;
  maker.add(static_cast<std::int64_t>(file.st_size))
      .add(static_cast<std::int64_t>(file.st_mtim.tv_sec))
      .add(static_cast<std::int64_t>(file.st_mtim.tv_nsec));
}

void add_robot(FingerprintMaker& maker, const Model& model) {
  maker.add(model.hash).add(model.yaml_text).add(model.urdf_text).add(model.srdf_text);
}

// Of files that the scene's text only names.
void add_files(FingerprintMaker& maker, const Scene& scene) {
  const auto numbers = [&maker](const auto& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) maker.add(values.data()[i]);
  };
  for (const Obstacle& obstacle : scene.obstacles) {
    maker.add(static_cast<int>(obstacle.shape));
    numbers(obstacle.size);
    numbers(obstacle.pose.matrix());
  }
  for (const LooseBody& body : scene.loose) {
    if (body.mesh == nullptr) continue;
    for (const Eigen::Vector3d& vertex : body.mesh->vertices()) numbers(vertex);
    for (const ContactFace& face : body.mesh->faces()) {
      for (const int vertex : face.vertex) maker.add(vertex);
    }
  }
  for (const TimedMotion& timed : scene.motions) {
    for (const std::string& file : {timed.file, timed.columns}) {
      std::error_code ignored;
      if (std::filesystem::is_regular_file(file, ignored)) maker.add(read_text_file(file));
    }
  }
  for (const SceneRobot& robot : scene.robots) add_robot(maker, load_robot(robot.robot));
}

void decide(const Model& model, const AccuracyRequest& request, AccuracyChoice& choice) {
  const Ladder& ladder = choice.ladder;
  if (!ladder.parted.empty()) {
    const Parted& worst = ladder.parted.front();
    choice.reason = worst.body + " has no converged answer: two runs that differ by 1e-12 part by " +
                    formatted("%.3g mm", 1e3 * worst.apart) +
                    "; no error can be held, leave the accuracy out";
    return;
  }
  if (request.budget > 0.0) {
    choice.rung = ladder.choose_within(1e3 * request.budget / model.period());
    if (choice.rung < 0) {
      choice.reason = formatted("no order and step fits into %.3g ms of a control period",
                                1e3 * request.budget);
      return;
    }
    const double reached = ladder.estimate(at(choice.rung));
    if (request.error > 0.0 && !(reached <= request.error)) {
      choice.reason = formatted("within the budget the error is %.3g mm, %.3g mm were asked",
                                1e3 * reached, 1e3 * request.error);
    }
    return;
  }
  choice.rung = ladder.choose(request.error);
  if (choice.rung < 0) choice.reason = ladder.why_none_holds(request.error);
}

}  // namespace

Fingerprint ladder_key(const Model& model, const Scene& scene, const OneProcessConfig& config, const AccuracyRequest& request) {
  FingerprintMaker maker;
  maker.add("ladder 9").add(static_cast<int>(simd()));
  add_this_program(maker);
  maker.add(scene.text).add(scene.engine).add(scene.robot).add(scene.start_pose).add(scene.origin.x()).add(scene.origin.y());
  add_robot(maker, model);
  add_files(maker, scene);
  maker.add(scene.fidelity).add(static_cast<std::int64_t>(scene.held.size())).add(static_cast<std::int64_t>(scene.rigid.size()));
  for (const auto* names : {&scene.held, &scene.rigid}) {
    for (const std::string& name : *names) maker.add(name);
  }
  for (const auto* list : {&scene.settings, &config.settings}) {
    maker.add(static_cast<std::int64_t>(list->size()));
    for (const auto& [name, value] : *list) maker.add(name).add(value);
  }
  const Disturbance& d = scene.disturbance;
  for (const double most : {d.position, d.angle, d.velocity, d.spin, d.mass, d.friction, d.joints}) maker.add(most);
  maker.add(request.error).add(request.all).add(request.duration).add(request.seed);
  maker.add(config.control.guard_in_loop);
  return maker.value();
}

void choose_fidelity(const Arguments& arguments, Scene& scene) {
  scene.fidelity = arguments.text("--fidelity", scene.fidelity);
  const std::vector<std::string> names(std::begin(kFidelityNames), std::end(kFidelityNames));
  if (std::find(names.begin(), names.end(), scene.fidelity) == names.end())
    throw UsageError("there is no fidelity '" + scene.fidelity + "'" + suggestion(scene.fidelity, names));
}

Settings settings_of(const std::string& command, const Arguments& arguments, double period) {
  Settings settings;
  for (const std::string& word : arguments.all("--set")) {
    const std::size_t equal = word.find('=');
    if (equal == std::string::npos) throw UsageError(command + ": --set wants KEY=VALUE, not '" + word + "'");
    settings.emplace_back(word.substr(0, equal), word.substr(equal + 1));
    SimSettings scratch;
    const std::string complaint = apply_setting(settings.back().first, settings.back().second, period, scratch);
    if (!complaint.empty()) throw UsageError(command + ": " + complaint);
  }
  return settings;
}

std::string read_budget(const std::string& text, double& seconds) {
  constexpr double kLeast = 1e-7, kMost = 10.0;
  constexpr Unit kTimes[] = {{"", 1e-3}, {"ms", 1e-3}, {"us", 1e-6}, {"s", 1.0}};
  seconds = quantity_of(text, kTimes);
  if (seconds >= kLeast && seconds <= kMost) return "";
  return "must be a time of 100 ns to 10 s, in milliseconds or with a unit, such as 0.5ms, not '" + text + "'";
}

AccuracyRequest accuracy_of(const std::string& command, const Arguments& arguments, const Scene& scene) {
  AccuracyRequest request;
  request.error = scene.accuracy;
  if (arguments.has("--accuracy")) {
    const std::string problem = read_accuracy(arguments.text("--accuracy", ""), request.error);
    if (!problem.empty()) throw UsageError(command + ": --accuracy " + problem);
  }
  if (arguments.has("--budget")) {
    const std::string problem = read_budget(arguments.text("--budget", ""), request.budget);
    if (!problem.empty()) throw UsageError(command + ": --budget " + problem);
  }
  if (scene.fidelity == "auto" && !(request.error > 0.0) && !(request.budget > 0.0)) request.error = kAutoError;
  request.talk = true;
  return request;
}

AccuracyChoice choose_accuracy(const Model& model, const Scene& scene,
                               const OneProcessConfig& config, const AccuracyRequest& request) {
  AccuracyChoice choice;
  const Fingerprint key = ladder_key(model, scene, config, request);
  if (const auto text = disk_cache().find(kKind, key)) {
    choice.kept = read_ladder(*text, choice.ladder);
    if (!choice.kept) disk_cache().refuse(kKind, key, "it is no ladder");
  }
  if (!choice.kept) {
    LadderRequest climbing;
    climbing.duration = request.duration;
    climbing.error = request.error;
    // Within a budget the yardstick is as good as time allows.
    climbing.all = request.all || !(request.error > 0.0);
    climbing.less = scene.fidelity == "auto" && request.error > 0.0;
    if (request.talk) {
      climbing.progress = [](const Ladder& so_far, const Rung& rung) {
        if (!rung.less.none()) {
          std::fprintf(stderr, "fidelity: %s, %.2f ms of physics per second, error %.3g mm\n",
                       words_of(rung.less).c_str(), rung.cost, 1e3 * rung.apart);
          return;
        }
        std::fprintf(stderr, "accuracy: %s, %.2f ms of physics per second%s\n", words_of(rung).c_str(), rung.cost,
                     std::isfinite(so_far.agreement) && &rung == &so_far.rungs.back() && rung.order == 3
                         ? formatted("; the finest two agree to %.3g mm", 1e3 * so_far.agreement).c_str()
                         : "");
      };
    }
    choice.ladder = climb(model, scene, config, climbing);
    if (quit_requested()) throw std::runtime_error("interrupted: nothing was chosen, nothing is kept");
    if (!choice.ladder.rungs.empty()) disk_cache().keep(kKind, key, ladder_text(choice.ladder));
  }
  decide(model, request, choice);
  return choice;
}

std::string accuracy_line(const AccuracyChoice& choice, const AccuracyRequest& asked, double cost) {
  std::string line = "accuracy: ";
  if (choice.chosen() != nullptr) {
    const Rung& rung = *choice.chosen();
    line += words_of(rung) + formatted(", error %.3g mm", 1e3 * choice.ladder.estimate(at(choice.rung)));
    if (asked.error > 0.0) line += formatted(" of %.3g mm asked", 1e3 * asked.error);
    line += formatted(", physics %.2f ms/s; ", cost);
    if (!rung.less.none()) line += words_of(rung.less) + "; ";
  } else {
    line += "not held, the scene's own order and step; ";
  }
  return line + formatted(choice.kept ? "chosen earlier in %.1f s of CPU" : "chosen in %.1f s of CPU", choice.ladder.cost);
}

std::string accuracy_json(const AccuracyChoice& choice, const AccuracyRequest& asked, double cost) {
  nlohmann::ordered_json json;
  const auto number = [](double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
  };
  json["asked_m"] = asked.error > 0.0 ? number(asked.error) : nlohmann::ordered_json();
  json["budget_s"] = asked.budget > 0.0 ? number(asked.budget) : nlohmann::ordered_json();
  json["seed"] = asked.seed;
  if (choice.chosen() != nullptr) {
    const Rung& rung = *choice.chosen();
    json["error_estimate_m"] = number(choice.ladder.estimate(at(choice.rung)));
    json["order"] = rung.order;
    json["step_s"] = rung.step;
    json["local_error_m_s2"] = rung.local > 0.0 ? number(rung.local) : nlohmann::ordered_json();
    json["held_joints"] = rung.less.held;
    json["rigid_robots"] = rung.less.rigid;
    json["still"] = rung.less.still;
    json["aloft"] = rung.less.aloft;
    json["untouched"] = rung.less.untouched;
    json["no_self_contact"] = rung.less.apart;
    json["asleep"] = rung.less.asleep;
  } else {
    json["error_estimate_m"] = nullptr;
  }
  json["physics_ms_per_s"] = cost;
  json["choosing_cpu_s"] = choice.ladder.cost;
  json["from_cache"] = choice.kept;
  json["reason"] = choice.reason;
  auto& parted = json["parted"] = nlohmann::ordered_json::array();
  for (const Parted& each : choice.ladder.parted) parted.push_back({{"body", each.body}, {"apart_m", number(each.apart)}});
  return json.dump();
}

}  // namespace twinbus::launcher
