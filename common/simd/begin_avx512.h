// As begin_avx2.h, with AVX-512: no wider numbers, but more registers, and bits that say which lanes.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,avx512f,avx512vl,avx512dq,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#pragma GCC target("avx512f,avx512vl,avx512dq,fma")
#endif
