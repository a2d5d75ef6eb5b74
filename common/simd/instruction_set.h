// Which vector instructions this machine has, for kernels that are compiled for several and give the same bits by each.
#pragma once

namespace twinbus::inline common {

enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

// What the variable TWINBUS_SIMD of the environment allows at most: baseline, avx2 or avx512 (the default, and for any other
// word: `./twinbus run` refuses those).  The same path on two machines gives the same bits on both; read once.
InstructionSet most_instruction_set() noexcept;

// The widest that this machine has and TWINBUS_SIMD allows.
InstructionSet best_instruction_set() noexcept;

}  // namespace twinbus::common
