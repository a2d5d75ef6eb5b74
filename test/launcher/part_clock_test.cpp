// The time of a part is its own, without what begins within it; of a run every part is there and together they are all of it.

#include "common/time/part_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "launcher/run/fit_scene.h"
#include "launcher/run/local_stack.h"
#include "robot/description/load.h"

namespace twinbus {
namespace {

// The clock of these tests moves by work, and by 1 s at each look.
double time_s = 0.0;
double look() { return time_s += 1.0; }
void work(double seconds) { time_s += seconds; }

double seconds_of(const PartClock& clock, std::string_view name) {
  for (const PartClock::Part& part : clock.parts()) {
    if (part.name == name) return part.seconds;
  }
  return -1.0;
}

TEST(PartClock, APartIsCountedWithoutThoseWithinIt) {
  PartClock clock(look, 1.0);
  {
    const PartScope nobody("before it runs");
    const PartClock::Running running(clock);
    const PartScope outer("outer");
    work(4.0);
    for (int i = 0; i < 2; ++i) {
      const PartScope inner("inner");
      work(8.0);
    }
    work(4.0);
  }
  const PartScope after("after it ran");
  ASSERT_EQ(clock.parts().size(), 2U);
  EXPECT_DOUBLE_EQ(seconds_of(clock, "outer"), 8.0);
  EXPECT_DOUBLE_EQ(seconds_of(clock, "inner"), 16.0);
  EXPECT_EQ(clock.parts()[1].times, 2);
}

TEST(PartClock, OfManyPartsTheLastTakesWhatHasNoRoom) {
  PartClock clock;
  const PartClock::Running running(clock);
  std::array<std::string, 20> names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] = "part " + std::to_string(i);
    const PartScope scope(names[i]);
  }
  ASSERT_EQ(clock.parts().size(), 16U);
  EXPECT_EQ(clock.parts().back().times, 5);
}

TEST(PartClock, OfARunHasEveryPart) {
  Scene scene = load_scene("stand");
  const Model model = load_robot(scene.robot);
  fit_scene(scene, model);
  OneProcess run(model, scene, {});
  PartClock clock(look, 0.0);
  const double begun = time_s;
  {
    const PartClock::Running running(clock);
    const PartScope scope("all else");
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(run.tick());
  }
  const double whole = time_s - begun - 1.0;  // from the first look to the last
  double sum = 0.0;
  for (const PartClock::Part& part : clock.parts()) sum += part.seconds;
  EXPECT_DOUBLE_EQ(sum, whole);
  for (const char* name : {"dynamics", "contacts, found", "contacts, solved", "energy and doubts", "sensors and TRUTH", "controller", "guard",
                           "messages", "figures of the run", "all else"})
    EXPECT_GT(seconds_of(clock, name), 0.0) << name;
}

}  // namespace
}  // namespace twinbus
