// The page's wish for another setup on its way to the `up` that owns the stack, by files in the run folder.
//
// Only a stack that is simulated is set up so: of one whose hardware is active, or that moves real motors at all, nothing is
// started anew because a page asks for it.

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
  // folder: SETUP/, made here.  now: how the stack was started.
  SetupWishes(const std::string& folder, Setup now);

  // A wish that has come since the last call, else empty; cheap enough for every turn of a loop.
  std::string take(std::int64_t now_ns);

  // Throws std::runtime_error with the sentence to answer.
  Setup prepare(const std::string& wish, const std::string& robot, const Stack& stack,
                const StackMonitor& seen);

  // Of a wish that only saves the robot: writes it, and gives the sentence that answers, also in the file saved.json.  What runs,
  // and what begins anew as before, stays as it is.  saved: whether it could be done.  Does not throw where a file cannot be
  // written.
  std::string save(const std::string& wish, const std::string& robot, bool& saved);

  // The sentence that answers, also in the file answer.  What holds now is kept in now.json, where the page finds it.  Does
  // not throw where they cannot be written: the sentence says so.
  std::string answer(const std::string& wish, const std::string& problem) const;

 private:
  void keep_changes(const std::string& wish) const;

  std::string folder_;
  Setup now_;
  std::int64_t looked_ns_ = 0;
};

// What processes are started with from now on.
void fill_in(const Setup& setup, Placeholders& values);

// Starts simulator, controller, guard and planner of the stack anew and waits until the new simulator is heard; the viewer too where the
// robot is another one.  Throws std::runtime_error when it is not within 10 s.
void start_anew(const Stack& stack, bool other_robot, Supervisor& supervisor, BusLink& bus);

// Takes out what sources, controller, guard and planner say of themselves when they begin anew.
void drop_events_of_the_loop(std::vector<std::string>& events);

}  // namespace twinbus::launcher
