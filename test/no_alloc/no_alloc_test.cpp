#include "common/allocation/no_alloc.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstdlib>
#include <thread>

namespace twinbus {
namespace {

volatile double sink = 0.0;

TEST(NoAlloc, CountsNothingWhenNothingIsAllocated) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Random();
  NoAlloc no_alloc;
  sink = (a * a).trace();
  EXPECT_EQ(no_alloc.count(), 0);
}

// The temporary of an aliased dynamic product is the classical way to allocate in a loop without
// seeing it.
TEST(NoAlloc, SeesAnEigenTemporary) {
  if (!allocations_counted()) GTEST_SKIP() << "the sanitizer owns malloc";
  Eigen::MatrixXd a = Eigen::MatrixXd::Random(20, 20);
  Eigen::MatrixXd b = Eigen::MatrixXd::Random(20, 20);
  NoAlloc no_alloc;
  a = a * b;
  sink = a(0, 0);
  EXPECT_GE(no_alloc.count(), 1);
}

TEST(NoAlloc, SeesEveryWayToAllocate) {
  if (!allocations_counted()) GTEST_SKIP() << "the sanitizer owns malloc";
  NoAlloc no_alloc;
  void* volatile a = std::malloc(10);
  void* volatile b = std::calloc(2, 10);
  void* volatile c = std::aligned_alloc(64, 128);
  a = std::realloc(a, 2000);
  int* volatile d = new int(1);  // clang leaves out one that nobody could see
  EXPECT_EQ(no_alloc.count(), 5);
  std::free(a);
  std::free(b);
  std::free(c);
  delete d;
}

TEST(NoAlloc, CountsTheCallingThreadOnly) {
  NoAlloc no_alloc;
  {
    std::int64_t before = 0;
    std::int64_t after = 0;
    std::thread other([&] {
      before = thread_allocations();
      for (int i = 0; i < 100; ++i) {
        void* volatile block = std::malloc(10);
        std::free(block);
      }
      after = thread_allocations();
    });
    other.join();
    EXPECT_EQ(after - before, allocations_counted() ? 100 : 0);
  }
  EXPECT_LT(no_alloc.count(), 50);  // making the thread itself
}

}  // namespace
}  // namespace twinbus
