// How far a run is from the converged answer, and the cheapest order and step that hold an error.
//
// Two runs whose start differs by 1e-12 come first: what parts there has no converged answer, body
// by body.  Then a ladder of orders 1, 2, 3 at ever finer steps until the finest two of order 3 agree
// to half the error asked for and that of order 2 lies within three times it (after impacts two runs may agree by
// luck).  The last is the yardstick; then come finer steps of lower orders while one may be cheaper than what is chosen
// so far, and steps between those of the ladder next to the cheapest.  Delivered is the cheapest run that lies
// within the error / 1.3 of the yardstick, together with all finer ones of its order; or within 0.97 of the error less what the
// yardstick may be off by, which is how far the finest runs of orders 2 and 3 and the finest two of order 3 are apart.  Richardson's rule is not
// used: where there are events it is wrong.
//
// Cheap is what takes little work as the engine counts it, in solves: what a clock says changes with the machine, and a
// step that is divided where events lie may be more work than a finer one.  A run that leaves something out has cheaper
// solves: of it the clock decides.
//
// With `fidelity: auto` what hardly moved in the yardstick is then left out of the run that was chosen (less.h), the most
// that still holds the error, at that step and at the next finer one.
//
// Where nobody drives the robot and something is loose, steps of a control period whose parts are chosen by their local error (setting
// solver.local_error) are further rungs, ever finer ones until two in a row hold the error: a fall is then stepped coarsely and its
// impact finely.  Such a run holds an error only together with a finer one.
//
// The error is the largest distance of any link origin or loose body from the yardstick, every 20 ms.

#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "launcher/run/less.h"
#include "launcher/run/local_stack.h"

namespace twinbus::inline launcher {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();  // an error or cost that is not known

// Where everything of a run was, every 20 ms.
struct Track {
  std::vector<std::vector<Eigen::Vector3d>> at;  // world [m]
  std::vector<std::string> names;                // of the links and bodies
  Moved moved;
  double cost = 0.0;                             // CPU of the physics [s]
  double work = std::numeric_limits<double>::quiet_NaN();  // of the engine, in solves; NaN: it does not count them
  double all = 0.0;                              // CPU of everything [s]
  bool whole = true;                             // the run did not end early
  bool stopped = false;                          // and not with its source stopped
  bool slept = false;                            // a loose body was asleep
  TrustBands bands;                              // what its doubts came to
};

// Throws std::runtime_error as OneProcess does.
Track follow(const Model& model, const Scene& scene, const OneProcessConfig& config,
             double duration);

struct Apart {
  double most = 0.0;  // [m]; infinite where one of them is not whole
  std::size_t sample = 0, body = 0;
};
Apart distance(const Track& a, const Track& b);

struct Rung {
  int order = 1;
  double step = 0.0;     // [s]
  double local = 0.0;    // error by which its parts are chosen [m/s^2]; 0: they are not
  double cost = 0.0;     // CPU of the physics [ms per simulated s]
  double work = 0.0;     // of the engine [solves per simulated s]
  double apart = 0.0;    // from the yardstick [m]
  double at = 0.0;       // where it is farthest [s]
  std::string body;      // and what
  bool whole = true;     // the run did not end early
  TrustBands bands;      // what its doubts came to
  Less less;             // what was left out
  bool operator==(const Rung&) const = default;
};

// What two runs that differ by 1e-12 disagree about.
struct Parted {
  std::string body;
  double apart = 0.0;  // [m]
  bool operator==(const Parted&) const = default;
};

struct Ladder {
  std::vector<Rung> rungs;  // the first from coarse to fine, then those between; the yardstick is the last
  std::vector<Parted> parted;
  Moved moved;              // in the yardstick
  double agreement = 0.0;   // of the finest two of order 3 [m]
  double cost = 0.0;        // CPU of all runs, controller too [s]

  // True error of a rung is about this [m]: its distance, of the yardstick the agreement.
  double estimate(std::size_t rung) const;
  // Whether the yardstick is known well enough for that error.
  bool proven(double error) const;
  // For people: why choose() finds none, nothing parted.
  std::string why_none_holds(double error) const;
  // How far a run may be from the yardstick where that error is asked for [m].
  double allowed(double error) const;
  // Whether a run and all finer ones of its order hold it.
  bool holds(const Rung& rung, double error) const;
  // The cheapest that holds the error together with all finer ones of its order; -1: none does.
  int choose(double error) const;
  // The nearest to the yardstick that costs no more [ms per simulated s]; -1: none.
  int choose_within(double budget) const;
};

struct LadderRequest {
  double duration = 0.0;  // [s]
  double error = 1e-3;    // asked for [m]
  bool all = false;       // every rung, however soon they agree
  bool less = false;      // leaves out what need not be modelled
  std::function<void(const Ladder&, const Rung& newest)> progress;  // after each run; may be empty
  std::function<Track(const Scene&)> follow;    // instead of follow(), if not empty
};

// The scene's own step and order are not used.  Throws std::runtime_error as OneProcess does.
Ladder climb(const Model& model, const Scene& scene, const OneProcessConfig& config,
             const LadderRequest& request);

// What the cache keeps.  Empty text or a wrong one: false.
std::string ladder_text(const Ladder& ladder);
bool read_ladder(const std::string& text, Ladder& ladder);

// The scene as that rung runs it.
Scene at_rung(const Scene& scene, int order, double step, double local = 0.0);
Scene at_rung(const Scene& scene, const Rung& rung);
// Settings without what a rung decides.
void drop_method(std::vector<std::pair<std::string, std::string>>& settings);

// "order 3 at 2 ms", and by which local error its parts are chosen.
std::string words_of(const Rung& rung);

// Nobody drives the robot and something is loose: it falls for long and hits for short.
bool falls_alone(const Scene& scene);

// For people: a line for each rung.
std::string ladder_table(const Ladder& ladder, int chosen);

}  // namespace twinbus::launcher
