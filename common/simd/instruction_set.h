// Which vector instructions this machine has, for kernels that are compiled for several and give the same bits by each.
#pragma once

namespace twinbus {

enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

// The widest that this machine has.
InstructionSet best_instruction_set() noexcept;

}  // namespace twinbus
