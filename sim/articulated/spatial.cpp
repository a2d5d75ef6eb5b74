#include "sim/articulated/spatial.h"

#include <algorithm>

#include "common/simd/instruction_set.h"

namespace twinbus::inline sim {

namespace {

Simd of_this_machine() noexcept {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2")) {
    const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512dq");
    return std::min(wide ? Simd::kAvx512 : Simd::kAvx2, static_cast<Simd>(most_instruction_set()));
  }
#endif
  return Simd::kBaseline;
}

Simd chosen = of_this_machine();

}  // namespace

Simd simd() noexcept { return chosen; }

void lower_simd(Simd most) noexcept {
  const Simd best = of_this_machine();
  chosen = most < best ? most : best;
}

}  // namespace twinbus::sim
