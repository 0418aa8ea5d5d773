#include "small_node.h"
SMALL_PLUGIN("duplicate", "small", WR_ABI)
