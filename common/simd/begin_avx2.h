// Functions from here to end_target.h may use AVX2 and fused multiply-add (nothing is fused but in files compiled with
// -ffp-contract=fast).  Included at namespace scope, as often as wanted: no #pragma once.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
