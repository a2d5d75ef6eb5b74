#include "control/guard/braking_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace twinbus {
namespace {

constexpr double kDelay = 0.011;  // [s]

std::vector<Course> random_courses(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Course> courses;
  for (int j = 0; j < 8; ++j)
    courses.push_back({0.1 * unit(random), j == 0 ? 0.0 : 6.0 * unit(random), 60.0 + j});
  return courses;
}

TEST(CourseWay, LeadsFromHereToRestAndTurnsWhereTheBrakesCome) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 50; ++k) {
    const std::vector<Course> courses = random_courses(random);
    const CourseWay way(courses, kDelay);
    Eigen::VectorXd here = Eigen::VectorXd::Constant(8, 0.3), brakes = here, rest = here;
    way.go_on(0.0, here);
    way.go_on(way.brakes_at(), brakes);
    way.go_on(1.0, rest);
    for (std::size_t j = 0; j < courses.size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      EXPECT_NEAR(here[i], 0.3, 1e-12);
      EXPECT_NEAR(brakes[i], 0.3 + courses[j].first, 1e-9);
      EXPECT_NEAR(rest[i], 0.3 + courses[j].rest(), 1e-9);
    }
  }
}

// Between two places all joints have gone the same share of their steps, but for the bend.
TEST(CourseWay, BetweenPlacesItIsNearlyStraight) {
  std::mt19937_64 random(4);
  int bent = 0;
  SweptShapes::Way places;
  places.q.resize(8);
  places.bend.resize(8);
  places.asked.assign(8, 1);
  const Eigen::VectorXd here = Eigen::VectorXd::Constant(8, 0.3);
  for (int k = 0; k < 60; ++k) {
    const std::vector<Course> courses = random_courses(random);
    const CourseWay way(courses, kDelay);
    CourseWay::Shares shares = way.shares();
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares[1], way.brakes_at());
    EXPECT_EQ(shares.back(), 1.0);
    if (k % 2 == 0) shares = CourseWay::between(shares[3], shares[5]);
    way.go(here, shares, places);
    for (std::size_t stretch = 0; stretch + 1 < shares.size(); ++stretch) {
      Eigen::VectorXd from(8), step(8), bend(8);
      for (std::size_t j = 0; j < 8; ++j) {
        const auto i = static_cast<Eigen::Index>(j);
        from[i] = places.q[j][stretch];
        step[i] = places.q[j][stretch + 1] - from[i];
        bend[i] = static_cast<double>(places.bend[j][stretch]);
      }
      for (int part = 0; part <= 4; ++part) {
        Eigen::VectorXd q = here;
        way.go_on(shares[stretch] + 0.25 * part * (shares[stretch + 1] - shares[stretch]), q);
        double least =
            1e9;  // of the most that a joint is off, over the shares that all may have gone
        for (int s = 0; s <= 1000; ++s)
          least = std::min(least, ((q - from - 0.001 * s * step).cwiseAbs() - bend).maxCoeff());
        EXPECT_LE(least, 0.0006 * step.cwiseAbs().maxCoeff() + 1e-7);
        bent += bend.maxCoeff() > 1e-4 ? 1 : 0;
      }
    }
    for (const auto& bend : places.bend) EXPECT_EQ(bend.back(), 0.0F);
  }
  EXPECT_GT(bent, 100);
}

}  // namespace
}  // namespace twinbus
