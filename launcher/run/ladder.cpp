#include "launcher/run/ladder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>

#include "common/math/index.h"
#include "common/process/process.h"
#include "common/text/formatted.h"
#include "common/time/cpu_time.h"
#include "launcher/run/clearance.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kEvery = 0.02;        // between two looks at a run [s]
constexpr double kLies = 1e-5;         // of kEvery a loose body that lies still moves no farther [m]
constexpr double kTwin = 1e-12;        // relative, and [m]
constexpr double kParted = 1e-6;       // [m]: what converges parts by less than 1e-8
constexpr double kWide = 1.6;          // two steps of which one is so many times the other have room for one between
constexpr double kAlike = 1.1;         // two runs of which one is at most so many times the work of the other
constexpr int kMostBetween = 4;        // steps between those of a ladder
constexpr int kParts[] = {1, 2, 4, 10, 20};  // of the control period
constexpr double kLocal[] = {30.0, 10.0, 3.0, 1.0, 0.3, 0.1, 0.03, 0.01};  // errors of parts [m/s^2]
constexpr double kDear = 2.0;  // times the work of what is chosen: the next such run will be dearer still

constexpr double kFinest = 1.0 / kParts[std::size(kParts) - 1];

using Sample = std::vector<Eigen::Vector3d>;

Sample places(const OneProcess& run) {
  Sample sample;
  const World& world = run.world();
  for (int i = 0; i < run.model().link_count(); ++i)
    sample.push_back(world.link_in_world(i).translation());
  for (int i = 0; i < world.loose_count(); ++i)
    sample.push_back(world.loose(i).pose.translation());
  for (std::size_t i = 0; i < run.further_robots().size(); ++i)
    sample.push_back(world.robot_link(static_cast<int>(i), 0).translation());
  return sample;
}

std::vector<std::string> names_of(const OneProcess& run) {
  std::vector<std::string> names;
  for (const Link& link : run.model().links) names.push_back("link " + link.name);
  for (int i = 0; i < run.world().loose_count(); ++i)
    names.push_back("loose body " + run.loose_name(i));
  for (const auto& robot : run.further_robots()) names.push_back("robot " + robot.name);
  return names;
}

// The same with everything heavier, rougher and farther by one part in 1e12.
Scene twin_of(const Scene& scene) {
  Scene twin = scene;
  twin.ground_friction *= 1.0 + kTwin;
  for (LooseBody& body : twin.loose) {
    body.mass *= 1.0 + kTwin;
    body.friction *= 1.0 + kTwin;
    body.start.pose.translation() += kTwin * Eigen::Vector3d(1.0, -0.7, 0.4);
    body.start.velocity *= 1.0 + kTwin;
    body.start.angular_velocity *= 1.0 + kTwin;
  }
  for (auto& [joint, speed] : twin.start_velocity) speed *= 1.0 + kTwin;
  double mass = 1.0;
  for (const auto& [key, value] : twin.settings) {
    if (key == "model.mass_scale") mass = std::stod(value);
  }
  twin.settings.emplace_back("model.mass_scale", formatted("%.17g", mass * (1.0 + kTwin)));
  return twin;
}

std::vector<Parted> parted_bodies(const Track& a, const Track& b) {
  std::vector<Parted> parted;
  for (std::size_t k = 0; k < a.names.size(); ++k) {
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(a.at.size(), b.at.size()); ++i) {
      const double d = (a.at[i][k] - b.at[i][k]).norm();
      if (!(d <= most)) most = d;
    }
    if (!(most <= kParted)) parted.push_back({a.names[k], most});
  }
  std::sort(parted.begin(), parted.end(),
            [](const Parted& x, const Parted& y) { return x.apart > y.apart; });
  return parted;
}

}  // namespace

Track follow(const Model& model, const Scene& scene, const OneProcessConfig& config,
             double duration) {
  const double begun = thread_cpu_seconds();
  OneProcess run(model, scene, config);
  run.time_physics();
  Track track;
  track.names = names_of(run);
  const Eigen::VectorXd start = run.world().configuration().q;
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(start.size());
  for (const auto& robot : run.further_robots()) track.moved.robots.push_back(robot.name);
  track.moved.robot_ways.assign(track.moved.robots.size(), 0.0);
  std::optional<Clearance> clearance;
  if (scene.fidelity == "auto") clearance.emplace(run.model(), run.world_config());
  const Sample begin = places(run);
  Sample before = begin;
  double links = 0.0;
  std::size_t lay = 0;
  const std::int64_t ticks = std::llround(duration / model.period());
  const std::int64_t every = std::max<std::int64_t>(1, std::llround(kEvery / model.period()));
  while (run.ticks() < ticks && !quit_requested() && run.tick()) {
    if (run.ticks() % every != 0) continue;
    track.at.push_back(places(run));
    moved = moved.cwiseMax((run.world().configuration().q - start).cwiseAbs());
    for (std::size_t i = 0; i < at(run.model().link_count()); ++i)
      links = std::max(links, (track.at.back()[i] - begin[i]).norm());
    for (std::size_t i = 0; i < at(run.world().loose_count()); ++i) {
      track.slept = track.slept || run.world().asleep(static_cast<int>(i));
      const std::size_t body = at(run.model().link_count()) + i;
      lay += (track.at.back()[body] - before[body]).norm() < kLies ? 1 : 0;
    }
    before = track.at.back();
    if (clearance) clearance->look(run.world());
    for (std::size_t i = 0; i < track.moved.robots.size(); ++i) {
      const Eigen::Vector3d now = run.world().robot_link(static_cast<int>(i), 0).translation();
      track.moved.robot_ways[i] = std::max(track.moved.robot_ways[i], (now - run.further_robots()[i].start).norm());
    }
  }
  track.moved.joints.assign(moved.begin(), moved.end());
  track.moved.links = links;
  if (clearance) {
    track.moved.clear = clearance->nearest();
    track.moved.above = clearance->above();
  }
  if (run.world().loose_count() > 0 && !track.at.empty())
    track.moved.lay = static_cast<double>(lay) / static_cast<double>(track.at.size() * at(run.world().loose_count()));
  track.whole = run.ticks() >= ticks;
  track.stopped = run.state().role == Role::kStopped;
  track.bands = run.bands();
  track.cost = run.physics_seconds();
  track.work = run.world().work();
  track.all = thread_cpu_seconds() - begun;
  return track;
}

Apart distance(const Track& a, const Track& b) {
  Apart apart;
  if (!a.whole || !b.whole || a.at.size() != b.at.size()) return {kUnbounded, 0, 0};
  for (std::size_t i = 0; i < a.at.size(); ++i) {
    for (std::size_t k = 0; k < a.at[i].size(); ++k) {
      const double d = (a.at[i][k] - b.at[i][k]).norm();
      if (!(d <= apart.most)) apart = {d, i, k};
    }
  }
  return apart;
}

Scene at_rung(const Scene& scene, int order, double step, double local) {
  Scene changed = scene;
  changed.step = step;
  drop_method(changed.settings);
  if (order > 1) changed.settings.emplace_back("solver.order", std::to_string(order));
  if (local > 0.0) changed.settings.emplace_back("solver.local_error", formatted("%.9g", local));
  return changed;
}

Scene at_rung(const Scene& scene, const Rung& rung) {
  return without(at_rung(scene, rung.order, rung.step, rung.local), rung.less);
}

void drop_method(std::vector<std::pair<std::string, std::string>>& settings) {
  std::erase_if(settings, [](const auto& each) { return each.first == "solver.order" || each.first == "solver.local_error"; });
}

std::string words_of(const Rung& rung) {
  std::string words = formatted("order %d at %.4g ms", rung.order, 1e3 * rung.step);
  if (rung.local > 0.0) words += formatted(" in parts, local error %.3g m/s^2", rung.local);
  return words;
}

namespace {

// The last run of `tracks` is the yardstick.
Rung rung_of(int order, double step, const Track& track, const Track& yardstick, double duration) {
  const Apart apart = distance(track, yardstick);
  Rung rung;
  rung.order = order;
  rung.step = step;
  rung.cost = 1e3 * track.cost / duration;
  rung.work = std::isfinite(track.work) ? track.work / duration : 1.0 / step;
  rung.apart = apart.most;
  rung.at = kEvery * static_cast<double>(apart.sample + 1);
  rung.body = track.names.empty() ? "" : track.names[apart.body];
  rung.whole = track.whole;
  rung.bands = track.bands;
  return rung;
}

// Leaves out of the chosen run what hardly moved in the yardstick: the largest set that holds the error and costs less.
template <class Run>
void leave_out(const Model& model, const LadderRequest& request, const Run& run, const Scene& scene, const Track& yardstick,
               Ladder& ladder) {
  const int chosen = ladder.choose(request.error);
  if (chosen < 0) return;
  const Rung whole = ladder.rungs[at(chosen)];
  const auto try_at = [&](const Less& less, double step) {
    Rung wanted = whole;
    wanted.step = step;
    wanted.less = less;
    const Track track = run(at_rung(scene, wanted));
    Rung rung = rung_of(whole.order, step, track, yardstick, request.duration);
    rung.less = less;
    rung.less.asleep = less.asleep && track.slept;  // else the run is the same without
    if (track.stopped != yardstick.stopped) rung.apart = kUnbounded;
    ladder.rungs.insert(ladder.rungs.end() - 1, rung);
    if (request.progress) request.progress(ladder, rung);
    const int now = ladder.choose(request.error);  // the yardstick has moved
    return now >= 0 && !ladder.rungs[at(now)].less.none();
  };
  Moved moved = yardstick.moved;
  if (scene.engine != "articulated" || scene.asleep) moved.lay = 0.0;
  if (scene.engine != "articulated" || !scene.untouched.empty()) moved.clear.clear();
  if (scene.engine != "articulated" || !scene.aloft.empty()) moved.above.clear();
  const double finer = whole.step / 2.0;
  for (const Less& less : proposals(model, moved, request.error, scene.self_contact)) {
    if (quit_requested()) return;
    try {
      if (try_at(less, whole.step) && (finer < 0.9 * kFinest * model.period() || try_at(less, finer))) return;
    } catch (const std::runtime_error&) {
      continue;  // a loop or grasp needs what would be left out
    }
  }
}

// The yardstick stands, and a finer run of a lower order may hold the error for less than what is chosen so far.
template <class Run>
void add_cheaper(const LadderRequest& request, const Run& run, double period, const Scene& scene,
                 std::vector<Track>& tracks, Ladder& ladder) {
  for (int order = 1; order < ladder.rungs.back().order; ++order) {
    for (const int next : kParts) {
      if (!(period / next < 0.75 * ladder.rungs.back().step)) continue;
      const Rung* coarser = nullptr;
      for (const Rung& rung : ladder.rungs) coarser = rung.order == order ? &rung : coarser;
      const int chosen = ladder.choose(request.error);
      if (chosen < 0 || ladder.rungs[at(chosen)].order <= order || quit_requested()) break;
      const double before = std::round(period / coarser->step), most = ladder.rungs[at(chosen)].work / coarser->work * before;
      const double parts = next < most ? next : std::round(std::sqrt(before * next));
      if (!(parts < most && parts > before)) break;
      const double step = period / parts;
      const Track track = run(at_rung(scene, order, step));
      const Rung finer = rung_of(order, step, track, tracks.back(), request.duration);
      ladder.rungs.insert(ladder.rungs.end() - 1, finer);
      if (request.progress) request.progress(ladder, finer);
      if (parts < next) break;
    }
  }
}

// In how many parts of a control period to step next to what is chosen, between two steps of the ladder, where that may be
// less work; 0: nowhere.  order: of it.
int parts_between(const Ladder& ladder, double error, double period, int& order) {
  const int chosen = ladder.choose(error);
  if (chosen < 0) return 0;
  const Rung& best = ladder.rungs[at(chosen)];
  for (order = 1; order <= ladder.rungs.back().order; ++order) {
    std::vector<const Rung*> runs;  // from coarse to fine
    for (const Rung& rung : ladder.rungs) {
      if (rung.order == order && rung.less.none() && !(rung.local > 0.0)) runs.push_back(&rung);
    }
    std::sort(runs.begin(), runs.end(), [](const Rung* a, const Rung* b) { return a->step > b->step; });
    for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
      if (!ladder.holds(*runs[i + 1], error)) continue;
      const bool chance = ladder.holds(*runs[i], error) ? std::max(runs[i]->work, runs[i + 1]->work) < kAlike * best.work
                                                        : std::sqrt(runs[i]->work * runs[i + 1]->work) < best.work;
      const double coarse = std::round(period / runs[i]->step), fine = std::round(period / runs[i + 1]->step);
      const double between = std::round(std::sqrt(coarse * fine));
      if (chance && fine >= kWide * coarse && between > coarse && between < fine) return static_cast<int>(between);
    }
  }
  return 0;
}

template <class Run>
void add_between(const LadderRequest& request, const Run& run, double period, const Scene& scene, const Track& yardstick,
                 Ladder& ladder) {
  for (int tried = 0; tried < kMostBetween && !quit_requested(); ++tried) {
    int order = 0;
    const int parts = parts_between(ladder, request.error, period, order);
    if (parts == 0) return;
    const double step = period / parts;
    const Rung rung = rung_of(order, step, run(at_rung(scene, order, step)), yardstick, request.duration);
    ladder.rungs.insert(ladder.rungs.end() - 1, rung);
    if (request.progress) request.progress(ladder, rung);
  }
}

}  // namespace

bool falls_alone(const Scene& scene) {
  return scene.engine == "articulated" && !scene.loose.empty() && scene.modes.size() <= 1 && scene.walks.empty() &&
         scene.steps.empty() && scene.motions.empty() && scene.goals.empty() && scene.pads.empty();
}

namespace {

// Steps of a control period in parts chosen by their local error, ever finer until two in a row hold the error.
template <class Run>
void add_local(const LadderRequest& request, const Run& run, double period, const Scene& scene, const Track& yardstick,
               Ladder& ladder) {
  for (int order = 2; order <= ladder.rungs.back().order; ++order) {
    bool held = false;
    for (const double local : kLocal) {
      const int chosen = ladder.choose(request.error);
      if ((chosen < 0 && !request.all) || quit_requested()) return;
      const double most = chosen < 0 ? kUnbounded : kDear * ladder.rungs[at(chosen)].work;
      Rung rung = rung_of(order, period, run(at_rung(scene, order, period, local)), yardstick, request.duration);
      rung.local = local;
      ladder.rungs.insert(ladder.rungs.end() - 1, rung);
      if (request.progress) request.progress(ladder, rung);
      const bool holds = rung.whole && rung.apart <= ladder.allowed(request.error);
      if (!request.all && ((held && holds) || rung.work > most)) break;
      held = holds;
    }
  }
}

}  // namespace

Ladder climb(const Model& model, const Scene& scene, const OneProcessConfig& config,
             const LadderRequest& request) {
  OneProcessConfig quiet = config;
  quiet.listener = nullptr;
  drop_method(quiet.settings);
  const int orders = scene.engine == "articulated" ? 3 : 1;
  Ladder ladder;
  std::vector<Track> tracks;
  const auto run = [&](const Scene& asked) {
    Track track =
        request.follow ? request.follow(asked) : follow(model, asked, quiet, request.duration);
    ladder.cost += track.all;
    return track;
  };
  const auto look_again = [&] {  // from the newest yardstick
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      const Apart apart = distance(tracks[i], tracks.back());
      Rung& rung = ladder.rungs[i];
      rung.apart = apart.most;
      rung.at = kEvery * static_cast<double>(apart.sample + 1);
      rung.body = tracks[i].names.empty() ? "" : tracks[i].names[apart.body];
    }
  };
  std::size_t last_top = 0;
  bool have_top = false;
  for (const int parts : kParts) {
    const double step = model.period() / parts;
    for (int order = 1; order <= orders; ++order) {
      tracks.push_back(run(at_rung(scene, order, step)));
      ladder.rungs.push_back(rung_of(order, step, tracks.back(), tracks.back(), request.duration));
      // Twins of the coarsest run of order 2, or of order 1 where there is no other.
      if (parts == 1 && order == std::min(2, orders)) {
        ladder.parted =
            parted_bodies(tracks.back(), run(twin_of(at_rung(scene, order, step))));
        if (!ladder.parted.empty() && !request.all) {
          look_again();
          ladder.agreement = kUnbounded;
          ladder.moved = tracks.back().moved;
          return ladder;
        }
      }
      if (order == orders) {
        look_again();
        ladder.agreement = have_top ? ladder.rungs[last_top].apart : kUnbounded;
      }
      if (request.progress) request.progress(ladder, ladder.rungs.back());
      if (quit_requested()) return ladder;
    }
    last_top = tracks.size() - 1;
    const bool agreed = have_top && ladder.proven(request.error);
    have_top = true;
    if (agreed && !request.all) {
      add_cheaper(request, run, model.period(), scene, tracks, ladder);
      break;
    }
  }
  add_between(request, run, model.period(), scene, tracks.back(), ladder);
  if (falls_alone(scene)) add_local(request, run, model.period(), scene, tracks.back(), ladder);
  ladder.moved = tracks.back().moved;
  if (request.less) leave_out(model, request, run, scene, tracks.back(), ladder);
  return ladder;
}

std::string ladder_table(const Ladder& ladder, int chosen) {
  std::string table = "order   step [ms]   physics [ms/s]   error [mm]   where it is largest\n";
  for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
    const Rung& r = ladder.rungs[i];
    const double error = 1e3 * ladder.estimate(i);
    table += formatted("%c %d   %9.3f   %14.2f   %10.4g   ", static_cast<int>(i) == chosen ? '*' : ' ', r.order,
                       1e3 * r.step, r.cost, error);
    if (i + 1 == ladder.rungs.size()) {
      table += "the yardstick";
    } else if (!r.whole) {
      table += "ended early";
    } else {
      table += formatted("%s at %.2f s", r.body.c_str(), r.at);
    }
    if (r.local > 0.0) table += formatted("; in parts, local error %.3g m/s^2", r.local);
    if (!r.less.none()) table += "; " + words_of(r.less);
    table += '\n';
  }
  for (const Parted& p : ladder.parted) {
    table += formatted("%s: two runs that differ by 1e-12 part by %.3g mm: no error can be held\n", p.body.c_str(),
                       1e3 * p.apart);
  }
  return table;
}

}  // namespace twinbus::launcher
