#include "common/allocation/no_alloc.h"

#include <cerrno>
#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TWINBUS_COUNT_ALLOCATIONS 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define TWINBUS_COUNT_ALLOCATIONS 0
#endif
#endif
#if !defined(TWINBUS_COUNT_ALLOCATIONS) && !defined(__GLIBC__)
#define TWINBUS_COUNT_ALLOCATIONS 0
#endif
#ifndef TWINBUS_COUNT_ALLOCATIONS
#define TWINBUS_COUNT_ALLOCATIONS 1
#endif

namespace {
// initial-exec: the first touch of a lazily made thread-local block would itself call malloc.
[[gnu::tls_model("initial-exec")]] thread_local std::int64_t allocations = 0;
}  // namespace

namespace twinbus::inline common {

std::int64_t thread_allocations() noexcept { return allocations; }
bool allocations_counted() noexcept { return TWINBUS_COUNT_ALLOCATIONS != 0; }

}  // namespace twinbus::common

#if TWINBUS_COUNT_ALLOCATIONS

// The C library's own entries, under the names it keeps for interposers like this one.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  ++allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) noexcept {
  ++allocations;
  return __libc_realloc(block, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  if (alignment % sizeof(void*) != 0 || alignment == 0 || (alignment & (alignment - 1)) != 0)
    return EINVAL;
  void* result = __libc_memalign(alignment, size);
  if (result == nullptr) return ENOMEM;
  *block = result;
  return 0;
}
}

#endif
