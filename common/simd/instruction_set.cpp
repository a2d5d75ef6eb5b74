#include "common/simd/instruction_set.h"

namespace twinbus {

InstructionSet best_instruction_set() noexcept {
#if defined(__x86_64__) && !defined(__clang__)
  static const InstructionSet best =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
              __builtin_cpu_supports("avx512dq")
          ? InstructionSet::kAvx512
          : (__builtin_cpu_supports("avx2") ? InstructionSet::kAvx2 : InstructionSet::kBaseline);
  return best;
#else
  return InstructionSet::kBaseline;
#endif
}

}  // namespace twinbus
