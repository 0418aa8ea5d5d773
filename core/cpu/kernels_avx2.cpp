// Kernels for x86-64 with AVX2; CMakeLists.txt sets the compiler flags of this file.
#if defined(__AVX2__)
#define WRINKLE_ISA avx2
#include "cpu/kernel_bodies.h"
#endif
