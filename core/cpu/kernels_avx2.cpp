// The kernels for x86-64 with AVX2; CMakeLists.txt gives this file its flags.
#if defined(__AVX2__)
#define WRINKLE_ISA avx2
#include "cpu/kernel_bodies.h"
#endif
