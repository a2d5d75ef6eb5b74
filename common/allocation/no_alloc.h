// Counts what a thread allocates, so that a test or a heartbeat can say "this loop allocated
// nothing".
//
// Linking twinbus_common_allocation replaces malloc and its family in the whole program (Eigen and liblcm
// call malloc, not operator new).  Under a sanitizer, which has a malloc of its own, nothing is
// counted and counting() says so.

#pragma once

#include <cstdint>

namespace twinbus::inline common {

// Calls of malloc, calloc, realloc and the aligned ones by the calling thread since it started.
std::int64_t thread_allocations() noexcept;

// False when this build cannot count.
bool allocations_counted() noexcept;

// Allocations of the calling thread since the object was made.
//
//     NoAlloc no_alloc;
//     controller.update(...);
//     EXPECT_EQ(no_alloc.count(), 0);
class NoAlloc {
 public:
  NoAlloc() noexcept : start_(thread_allocations()) {}
  std::int64_t count() const noexcept { return thread_allocations() - start_; }

 private:
  std::int64_t start_;
};

}  // namespace twinbus::common
