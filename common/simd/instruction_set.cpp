#include "common/simd/instruction_set.h"

#include <cstdlib>
#include <cstring>

namespace twinbus::inline common {

InstructionSet most_instruction_set() noexcept {
  static const InstructionSet most = [] {
    const char* asked = std::getenv("TWINBUS_SIMD");
    if (asked == nullptr) return InstructionSet::kAvx512;
    if (std::strcmp(asked, "baseline") == 0) return InstructionSet::kBaseline;
    return std::strcmp(asked, "avx2") == 0 ? InstructionSet::kAvx2 : InstructionSet::kAvx512;
  }();
  return most;
}

InstructionSet best_instruction_set() noexcept {
#ifdef __x86_64__
  static const InstructionSet best =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
              __builtin_cpu_supports("avx512dq")
          ? InstructionSet::kAvx512
          : (__builtin_cpu_supports("avx2") ? InstructionSet::kAvx2 : InstructionSet::kBaseline);
  return best < most_instruction_set() ? best : most_instruction_set();
#else
  return InstructionSet::kBaseline;
#endif
}

}  // namespace twinbus::common
