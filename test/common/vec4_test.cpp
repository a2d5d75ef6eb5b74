#include "common/simd/vec4.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>

#include "common/simd/instruction_set.h"

namespace twinbus::test {
namespace {

TEST(Vec4, SineAndCosineAreThoseOfTheLibrary) {
  std::mt19937 random(1);
  for (const double range : {1e-8, 1.0, 4.0, 100.0, kMostAngle}) {
    std::uniform_real_distribution<double> angle(-range, range);
    for (int i = 0; i < 20000; ++i) {
      const Vec4 x = {angle(random), angle(random), angle(random), angle(random)};
      Vec4 s, c;
      sine_cosine(x, s, c);
      for (int k = 0; k < 4; ++k) {
        ASSERT_NEAR(s[k], std::sin(x[k]), 3e-16 + 1e-21 * range) << x[k];
        ASSERT_NEAR(c[k], std::cos(x[k]), 3e-16 + 1e-21 * range) << x[k];
      }
    }
  }
}

#ifdef __x86_64__
// Whatever compiler built it.
TEST(InstructionSet, WhatTheMachineHasAndTheEnvironmentAllowsIsUsed) {
  InstructionSet has = InstructionSet::kBaseline;
  if (__builtin_cpu_supports("avx2")) has = InstructionSet::kAvx2;
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq")) has = InstructionSet::kAvx512;
  EXPECT_EQ(best_instruction_set(), std::min(has, most_instruction_set()));
}
#endif

TEST(Vec4, NotANumberStaysOne) {
  Vec4 s, c;
  sine_cosine(Vec4{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0, 0.0}, s, c);
  EXPECT_TRUE(std::isnan(s[0]) && std::isnan(c[0]));
  EXPECT_EQ(s[1], 0.0);
  EXPECT_EQ(c[1], 1.0);
}

TEST(Vec4, CrossProductIsEigens) {
  const Eigen::Vector3d a(1.0, -2.0, 0.5), b(0.3, 4.0, -1.0);
  EXPECT_EQ(vector3(cross4(vec4(a), vec4(b))), a.cross(b));
  EXPECT_DOUBLE_EQ(dot3(vec4(a), vec4(b)), a.dot(b));
}

}  // namespace
}  // namespace twinbus::test
