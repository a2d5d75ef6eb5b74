// Compiles the file that TWINBUS_KERNEL_FILE names once for each instruction set, with fused multiply-add where there is one: into the
// namespaces baseline, avx2 and avx512.  To be included inside namespace twinbus, once for each such file; it ends the macro.
// No #pragma once here or in what it includes.
// clang-format off
namespace baseline {
#include TWINBUS_KERNEL_FILE
}  // namespace baseline
#if defined(__x86_64__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace avx2 {
#include TWINBUS_KERNEL_FILE
}  // namespace avx2
#pragma GCC target("avx512f,avx512vl,avx512dq,fma")
namespace avx512 {
#include TWINBUS_KERNEL_FILE
}  // namespace avx512
#pragma GCC pop_options
#endif
#undef TWINBUS_KERNEL_FILE
// clang-format on
