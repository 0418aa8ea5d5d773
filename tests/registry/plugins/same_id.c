#include "small_node.h"
SMALL_PLUGIN("good", "other", WR_ABI)
