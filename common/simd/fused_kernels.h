// Compiles the file that TWINBUS_KERNEL_FILE names once for each instruction set, with fused multiply-add where there is one: into the
// namespaces baseline, avx2 and avx512.  To be included inside namespace twinbus, once for each such file; it ends the macro.
// No #pragma once here or in what it includes.
// clang-format off
namespace baseline {
#include TWINBUS_KERNEL_FILE
}  // namespace baseline
#ifdef __x86_64__
#include "common/simd/begin_avx2.h"
namespace avx2 {
#include TWINBUS_KERNEL_FILE
}  // namespace avx2
#include "common/simd/end_target.h"
#include "common/simd/begin_avx512.h"
namespace avx512 {
#include TWINBUS_KERNEL_FILE
}  // namespace avx512
#include "common/simd/end_target.h"
#endif
#undef TWINBUS_KERNEL_FILE
// clang-format on
