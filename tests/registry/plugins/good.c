#include "small_node.h"
SMALL_PLUGIN("good", "small", WR_ABI)
