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

void work(double seconds) {
  for (const double begun = thread_cpu_seconds(); thread_cpu_seconds() < begun + seconds;) {
  }
}

double seconds_of(const PartClock& clock, std::string_view name) {
  for (const PartClock::Part& part : clock.parts()) {
    if (part.name == name) return part.seconds;
  }
  return -1.0;
}

TEST(PartClock, APartIsCountedWithoutThoseWithinIt) {
  PartClock clock;
  {
    const PartScope nobody("before it runs");
    const PartClock::Running running(clock);
    const PartScope outer("outer");
    work(0.004);
    for (int i = 0; i < 2; ++i) {
      const PartScope inner("inner");
      work(0.008);
    }
    work(0.004);
  }
  const PartScope after("after it ran");
  ASSERT_EQ(clock.parts().size(), 2U);
  EXPECT_NEAR(seconds_of(clock, "outer"), 0.008, 0.002);
  EXPECT_NEAR(seconds_of(clock, "inner"), 0.016, 0.002);
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
  PartClock clock;
  const double begun = thread_cpu_seconds();
  {
    const PartClock::Running running(clock);
    const PartScope scope("all else");
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(run.tick());
  }
  const double whole = thread_cpu_seconds() - begun;
  double sum = 0.0;
  for (const PartClock::Part& part : clock.parts()) sum += part.seconds;
  EXPECT_GT(sum, 0.7 * whole);  // looking at the clock is nobody's
  EXPECT_LE(sum, 1.01 * whole);
  for (const char* name : {"dynamics", "contacts, found", "contacts, solved", "energy and doubts", "sensors and TRUTH", "controller", "guard",
                           "messages", "figures of the run", "all else"})
    EXPECT_GT(seconds_of(clock, name), 0.0) << name;
}

}  // namespace
}  // namespace twinbus
