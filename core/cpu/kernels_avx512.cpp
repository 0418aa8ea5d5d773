// Kernels for x86-64 with AVX-512 (F, VL, DQ, BW); CMakeLists.txt sets the compiler flags of this
// file.
#if defined(__AVX512F__)
#define WRINKLE_ISA avx512
#include "cpu/kernel_bodies.h"
#endif
