// Kernels for the baseline instruction set.
#define WRINKLE_ISA baseline
#include "cpu/kernel_bodies.h"
