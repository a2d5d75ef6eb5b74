// Ends begin_avx2.h and begin_avx512.h.
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
