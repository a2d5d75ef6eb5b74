// The page's wish for another setup on its way to the `up` that owns the stack, by files in the run folder; `./twinbus sim reset`
// wishes the one that there is again.
//
// Only a stack that is simulated is set up so: of one whose hardware is active, or that moves real motors at all, nothing is
// started anew because a page asks for it.  A stand-in robot behind the bridge begins anew with the rest, also while it is active.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "launcher/bus/bus_link.h"
#include "launcher/up/setup.h"
#include "launcher/stack/stack.h"
#include "launcher/stack/supervisor.h"

namespace twinbus::inline launcher {

class SetupWishes {
 public:
  // folder: SETUP/, made here; the file stand_in in it tells the page of a stand-in robot.  now: how the stack was started.
  SetupWishes(const std::string& folder, Setup now, const Stack& stack = {});

  // A wish that has come since the last call, else empty; cheap enough for every turn of a loop.
  std::string take(std::int64_t now_ns);

  // active: holder_of_state().
  // Throws std::runtime_error with the sentence to answer.
  Setup prepare(const std::string& wish, const std::string& robot, const Stack& stack, const StackProcess* active);

  // Of a wish that only saves the robot: writes it, and gives the sentence that answers, also in the file saved.json.  What runs,
  // and what begins anew as before, stays as it is.  saved: whether it could be done.  Does not throw where a file cannot be
  // written.
  std::string save(const std::string& wish, const std::string& robot, bool& saved);

  // The sentence that answers, also in the file answer.  What holds now is kept in now.json, where the page finds it.  Does
  // not throw where they cannot be written: the sentence says so.
  std::string answer(const std::string& wish, const std::string& problem) const;

 private:
  void say_robot() const;
  void keep_changes(const std::string& wish) const;

  std::string folder_;
  Setup now_;
  bool stand_in_;
  std::int64_t looked_ns_ = 0;
};

// What processes are started with from now on.
void fill_in(const Setup& setup, Placeholders& values);

// The process of the stack whose source holds STATE, or held it last; one that has ended counts while nobody else holds STATE.
// Null: another's.
const StackProcess* holder_of_state(const Stack& stack, const Supervisor& supervisor, const StackMonitor& seen);

// Whether nothing is set up otherwise than it was.
bool begins_as_before(const std::string& wish);

// Which process is made active of a stack that begins anew: the one that was, the first one where the setup is another or where
// that one shadows.
std::string active_anew(const std::string& wish, const Stack& stack, const StackProcess* active);

// Starts simulators, stand-in robot and the bridge to it, controller, guard and planner of the stack anew and waits until the new
// process of this name is heard; the viewer too where the robot is another one.  Throws std::runtime_error when it is not within
// 10 s.
void start_anew(const std::string& first, bool other_robot, Supervisor& supervisor, BusLink& bus);

// Takes out what sources, controller, guard and planner say of themselves when they begin anew.
void drop_events_of_the_loop(std::vector<std::string>& events);

}  // namespace twinbus::launcher
