// Whether `run --accuracy` holds what is asked: scenes, each with its own duration, against references converged by two methods.
//
//     accuracy_bench [SCENE:SECONDS...] [--errors 10,1,0.1] [--fidelity] [--tune] [--csv F.csv]
//
// Without scenes: twenty, of walking, pushes, things carried and pushed, loose bodies, loops and flight.  Each scene is run at every order and step of the ladder, once, and at orders 2 and 3 with a step of a fortieth of the
// control period: the references.  For every error the ladder is climbed as `run` climbs it, and its choice is held
// against the reference of order 3.  The best fixed setting is the cheapest that truly holds the error together with all finer
// ones of its order.  With --fidelity what hardly moves is left out, as `fidelity: auto` does; the references model everything, and
// the gain is the cost of the same order and step with everything over that of the run delivered.  With --tune no reference is run: what
// `tune` chooses, which stops climbing where the error is proven, is held against the choice from every rung.  Where the references differ by more than a quarter of the error, nothing can be said.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/math/index.h"
#include "common/process/arguments.h"
#include "common/process/process.h"
#include "launcher/run/judge_scene.h"
#include "launcher/run/ladder.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"

namespace twinbus {
namespace {

constexpr const char* kTwenty[] = {"walk_forward:5", "walk_slope:5",  "push_walk:5",    "push_forward:3",   "push_left:3",    "stand:3",       "sway:3",
                                   "squat:3",        "reach:3",       "box_push:3",     "box_on_foot:3",    "hand_in_hand:2", "carry_box:4",   "plate_underfoot:3",
                                   "brick_stop:2",   "boxes_tumble:4", "slide_to_roll:2", "heavy_on_light:2", "n_four_bar:2",   "dzhanibekov:2"};
constexpr int kReferenceParts = 40;  // of the control period
constexpr double kNear = 1.2;           // times the exhaustive optimum may cost what `tune` chooses
constexpr double kPatience = 120.0;     // it may take, CPU [s]
constexpr int kRounds = 5;
constexpr double kKnown = 0.25;      // of the error the references may differ by

struct Counts {
  int cells = 0, answered = 0, held = 0, thrice = 0, estimated = 0, cheap = 0, unknown = 0;
  int tuned = 0, near = 0;    // choices of `tune`; those within kNear of the exhaustive one
  double longest = 0.0;       // choosing, CPU [s]
  std::vector<double> gains;  // of cells in which something was left out
};

std::vector<double> errors_of(const std::string& list) {
  std::vector<double> errors;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) errors.push_back(1e-3 * std::stod(word));
  return errors;
}

// A scene of the ladder, whatever else is in it.
std::string key_of(const Scene& scene) {
  std::string key = std::to_string(scene.step);
  for (const auto& [name, value] : scene.settings) key += ' ' + name + '=' + value;
  for (const std::string& name : scene.held) key += " held " + name;
  for (const std::string& name : scene.untouched) key += " untouched " + name;
  for (const std::string& name : scene.aloft) key += " aloft " + name;
  for (const std::string& name : scene.rigid) key += " rigid " + name;
  key += scene.asleep ? " asleep" : "";
  key += scene.self_contact ? " touch" : "";
  return key;
}

class Case {
 public:
  Case(const std::string& name, double seconds, bool less)
      : name_(name), less_(less), scene_(load_scene(name)), model_(load_robot(scene_.robot)) {
    if (less) scene_.fidelity = "auto";
    fit_scene(scene_, model_);
    apply_seed(scene_, model_, 1);
    duration_ = seconds > 0.0 ? seconds : scene_.duration;
  }

  void judge(const std::vector<double>& errors, Counts& counts, std::FILE* csv) {
    const double step = model_.period() / kReferenceParts;
    const Track reference = track_of(at_rung(scene_, 3, step));
    const double known = distance(track_of(at_rung(scene_, 2, step)), reference).most;
    const Ladder whole = climb_to(1e-9, true);
    for (const double error : errors) {
      ++counts.cells;
      const Ladder ladder = climb_to(error, false);
      const int chosen = ladder.choose(error);
      std::printf("%-16s %6.3g mm  references %.2g mm apart  ", name_.c_str(), 1e3 * error,
                  1e3 * known);
      if (!ladder.parted.empty()) {
        std::printf("said: %s cannot be held\n", ladder.parted.front().body.c_str());
        continue;
      }
      if (chosen < 0) {
        std::printf("none: the finest two differ by %.3g mm\n", 1e3 * ladder.agreement);
        continue;
      }
      ++counts.answered;
      const Rung& rung = ladder.rungs[at(chosen)];
      const double truth = distance(track_of(at_rung(scene_, rung)), reference).most;
      const double estimate = ladder.estimate(at(chosen));
      const double best = best_cost(whole, reference, error);
      if (!(known <= kKnown * error)) {
        ++counts.unknown;
        std::printf("nothing can be said (%s: %.3g mm)\n", words_of(rung).c_str(), 1e3 * truth);
        continue;
      }
      counts.held += truth <= error ? 1 : 0;
      counts.thrice += truth > 3.0 * error ? 1 : 0;
      counts.estimated += truth <= 3.0 * estimate && estimate <= 3.0 * truth ? 1 : 0;
      counts.cheap += cost_of(rung) <= 1.5 * best ? 1 : 0;
      std::printf(
          "%s  %.3g mm, estimated %.3g  %.2f ms/s, best fixed %.2f, choosing %.1f s\n", words_of(rung).c_str(), 1e3 * truth, 1e3 * estimate, cost_of(rung), best,
          ladder.cost);
      const double gain = less_ && !rung.less.none() ? gain_of(rung) : 1.0;
      if (less_) {
        if (!rung.less.none()) counts.gains.push_back(gain);
        std::printf("%26s%s: %.2f times as fast\n", "", rung.less.none() ? "everything" : words_of(rung.less).c_str(), gain);
      }
      if (csv != nullptr) {
        std::fprintf(csv, "%s,%g,%g,%d,%g,%g,%g,%g,%g,%g,%g,%g,%zu,%zu,%g\n", name_.c_str(), duration_, error,
                     rung.order, rung.step, rung.local, truth, estimate, known, cost_of(rung), best,
                     ladder.cost, rung.less.held.size(), rung.less.rigid.size(), gain);
      }
    }
    std::fflush(stdout);
  }

  void tune(const std::vector<double>& errors, Counts& counts) {
    for (const double error : errors) {
      const Ladder quick = climb_to(error, false), whole = climb_to(error, true);
      const int chosen = quick.choose(error), best = whole.choose(error);
      ++counts.tuned;
      counts.longest = std::max(counts.longest, quick.cost);
      std::printf("%-16s %6.3g mm  ", name_.c_str(), 1e3 * error);
      if (chosen < 0 || best < 0) {
        counts.near += chosen == best ? 1 : 0;
        std::printf("%s, of all rungs %s", chosen < 0 ? "none" : "one", best < 0 ? "none" : "one");
      } else {
        const Rung &a = quick.rungs[at(chosen)], &b = whole.rungs[at(best)];
        const double times = cost_of(a) / cost_of(b);
        counts.near += times <= kNear ? 1 : 0;
        std::printf("%s %.2f ms/s, of all rungs %s %.2f ms/s: %.2f times", words_of(a).c_str(), cost_of(a), words_of(b).c_str(),
                    cost_of(b), times);
      }
      std::printf("; %zu rungs %.1f s, all %zu %.1f s\n", quick.rungs.size(), quick.cost, whole.rungs.size(), whole.cost);
    }
    std::fflush(stdout);
  }

 private:
  const Track& track_of(const Scene& scene) {
    const std::string key = key_of(scene);
    const auto known = tracks_.find(key);
    if (known != tracks_.end()) return known->second;
    return tracks_.emplace(key, follow(model_, scene, {}, duration_)).first->second;
  }
  Ladder climb_to(double error, bool all) {
    LadderRequest request;
    request.duration = duration_;
    request.error = error;
    request.all = all;
    request.less = less_ && !all;
    request.follow = [this](const Scene& scene) { return track_of(scene); };
    return climb(model_, scene_, {}, request);
  }
  // Of the one run of it: the ladders share it.
  double cost_of(const Rung& rung) {
    return 1e3 * track_of(at_rung(scene_, rung)).cost / duration_;
  }
  // How much dearer everything is at the same order and step: the least of kRounds runs of each, in turn.
  double gain_of(const Rung& rung) {
    double less = cost_of(rung), whole = cost_of(whole_of(rung));
    for (int round = 1; round < kRounds; ++round) {
      less = std::min(less, 1e3 * follow(model_, at_rung(scene_, rung), {}, duration_).cost / duration_);
      whole = std::min(whole, 1e3 * follow(model_, at_rung(scene_, whole_of(rung)), {}, duration_).cost / duration_);
    }
    return whole / less;
  }
  static Rung whole_of(Rung rung) {
    rung.less = {};
    return rung;
  }
  double best_cost(const Ladder& whole, const Track& reference, double error) {
    Ladder known = whole;
    std::erase_if(known.rungs, [](const Rung& rung) { return rung.local > 0.0; });
    for (Rung& rung : known.rungs)
      rung.apart = distance(track_of(at_rung(scene_, rung.order, rung.step)), reference).most;
    double best = std::nan("");
    for (const Rung& rung : known.rungs) {
      bool holds = true;
      for (const Rung& finer : known.rungs) {
        if (finer.order == rung.order && finer.step <= rung.step)
          holds = holds && finer.apart <= error;
      }
      if (holds && !(best <= cost_of(rung))) best = cost_of(rung);
    }
    return best;
  }

  std::string name_;
  bool less_;
  Scene scene_;
  Model model_;
  double duration_ = 0.0;
  std::map<std::string, Track> tracks_;
};

int accuracy(int argc, char** argv) {
  const Arguments arguments({"bench accuracy", 0, 100, R"([SCENE:SECONDS...]
Without scenes: twenty, of walking, pushes, things carried and pushed, loose bodies, loops and flight (about half an hour).
Holds the choices of run --accuracy against converged references; exit status 0 only if 95 % hold and none is over three times.
  --errors LIST  [mm]; default 10,1,0.1
  --fidelity  leaves out what hardly moves
  --tune  compares what tune chooses with the best of all rungs instead; 0 only if 90 % cost at most 1.2 times that, 2 minutes of CPU each
  --csv F.csv  one line a choice)"}, std::vector<std::string>(argv + 1, argv + argc));
  const std::vector<double> errors = errors_of(arguments.text("--errors", "10,1,0.1"));
  std::FILE* csv = nullptr;
  if (const std::string file = arguments.text("--csv", ""); !file.empty()) {
    csv = std::fopen(file.c_str(), "w");
    if (csv == nullptr) throw std::runtime_error("cannot write " + file);
    std::fprintf(csv,
                 "scene,duration_s,asked_m,order,step_s,local_error_m_s2,true_m,estimate_m,references_m,cost_ms_per_"
                 "s,best_ms_per_s,"
                 "choosing_s,held_joints,rigid_robots,gain\n");
  }
  Counts counts;
  for (const std::string& word : arguments.words().empty() ? std::vector<std::string>(std::begin(kTwenty), std::end(kTwenty)) : arguments.words()) {
    const std::size_t colon = word.find(':');
    const double seconds = colon == std::string::npos ? 0.0 : std::stod(word.substr(colon + 1));
    Case scene(word.substr(0, colon), seconds, arguments.has("--fidelity"));
    if (arguments.has("--tune")) scene.tune(errors, counts);
    else scene.judge(errors, counts, csv);
  }
  if (csv != nullptr) std::fclose(csv);
  if (counts.tuned > 0) {
    std::printf("%d choices of tune, %d cost at most %.1f times the best of all rungs; the longest search %.1f s of CPU\n", counts.tuned, counts.near,
                kNear, counts.longest);
    return counts.near >= 0.9 * counts.tuned && counts.longest <= kPatience ? 0 : 1;
  }
  const int judged = counts.answered - counts.unknown;
  std::printf(
      "%d cells, %d answered, %d of them unknown; of %d: held %d, over three times %d, estimate "
      "within 3 %d, "
      "at most 1.5 times the best fixed setting %d\n",
      counts.cells, counts.answered, counts.unknown, judged, counts.held, counts.thrice,
      counts.estimated, counts.cheap);
  if (arguments.has("--fidelity")) {
    std::sort(counts.gains.begin(), counts.gains.end());
    std::printf("something was left out in %zu cells, which are %.2f times as fast in the median\n", counts.gains.size(),
                counts.gains.empty() ? 1.0 : counts.gains[counts.gains.size() / 2]);
  }
  return judged > 0 && counts.held >= 0.95 * judged && counts.thrice == 0 ? 0 : 1;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("bench accuracy", &twinbus::accuracy, argc, argv);
}
