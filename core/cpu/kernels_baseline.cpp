// The kernels for what every machine has.
#define WRINKLE_ISA baseline
#include "cpu/kernel_bodies.h"
